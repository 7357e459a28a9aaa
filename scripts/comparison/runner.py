"""Runs one row: the command line on all cells of a scene, with its time and peak memory."""

from __future__ import annotations

import contextlib
import json
import os
import resource
import signal
import subprocess
import tempfile
import time
from pathlib import Path
from statistics import median

from .layout import Layout, Method, Scene


class Interrupted(Exception):
    """The user stopped the run."""


def command(program: Path, scenes_folder: Path, scene: Scene, method: Method, cells_file: str, output: str) -> list[str]:
    """The command line of a row."""
    source = scene.source if scene.source.startswith("gen:") else str(scenes_folder / scene.source)
    return [str(program), "pvs", source, *scene.arguments, "--cells", cells_file, "--method", method.name, *method.arguments,
            "--threads", "1", "-o", output]


def shown_command(scene: Scene, method: Method) -> str:
    """The command line for a reader: each cell written out, file names as below the folder of scenes."""
    cells = " ".join("--cell=" + ",".join(f"{x:g}" for x in (*c.low, *c.high)) for c in scene.cells)
    words = ["visibility pvs", scene.source, *scene.arguments, cells, "--method", method.name, *method.arguments, "--threads 1"]
    return " ".join(words)


def run_once(arguments: list[str], timeout: float) -> tuple[str, int, str]:
    """Runs a command: "finished", "failed" or "timeout"; peak memory in KiB; what it wrote to standard error."""
    with tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=errors)
        deadline = time.monotonic() + timeout
        timed_out = False
        try:
            while True:
                pid, status, usage = os.wait4(process.pid, os.WNOHANG)
                if pid != 0:
                    break
                if time.monotonic() > deadline and not timed_out:
                    timed_out = True
                    os.kill(process.pid, signal.SIGKILL)
                time.sleep(0.005)
        except KeyboardInterrupt:
            with contextlib.suppress(ProcessLookupError, ChildProcessError):  # it may be gone already
                os.kill(process.pid, signal.SIGKILL)
                os.wait4(process.pid, 0)
            raise Interrupted from None
        process.returncode = os.waitstatus_to_exitcode(status)  # reaped here, not by Popen
        errors.seek(0)
        message = errors.read().decode(errors="replace").strip()
    state = "timeout" if timed_out else "finished" if process.returncode == 0 else "failed"
    return state, usage.ru_maxrss, message


def run_row(program: Path, scenes_folder: Path, layout: Layout, scene: Scene, method: Method) -> dict:
    """State, peak memory, and in processor seconds, which other work on the machine does not lengthen, the time to build; for each
    cell its set, its guarantee and the median time of the query, in processor and wall seconds."""
    row: dict = {"scene": scene.name, "method": method.label, "command": shown_command(scene, method),
                 # Linux counts what a child held before it became another program, a copy of this process: peaks are not below.
                 "floor_kib": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss}
    runs: list[list[dict]] = []
    spent, peak = 0.0, 0
    with tempfile.TemporaryDirectory() as folder:
        cells_file, output = f"{folder}/cells.json", f"{folder}/pvs.json"
        Path(cells_file).write_text(json.dumps([c.json() for c in scene.cells]))
        arguments = command(program, scenes_folder, scene, method, cells_file, output)
        while len(runs) < layout.repeats and (not runs or spent < layout.repeat_seconds):
            start = time.monotonic()
            state, memory, message = run_once(arguments, layout.timeout)
            spent += time.monotonic() - start
            peak = max(peak, memory)
            if state != "finished":
                return row | {"state": state, "message": message, "peak_kib": peak}
            results = json.loads(Path(output).read_text())
            runs.append(results if isinstance(results, list) else [results])
    first = runs[0]
    for results in runs[1:]:
        if any(a["visible"] != b["visible"] for a, b in zip(first, results, strict=True)):
            return row | {"state": "failed", "message": "two runs give different sets", "peak_kib": peak}
    return row | {
        "state": "finished", "peak_kib": peak, "runs": len(runs),
        "objects": first[0]["scene"]["objects"], "primitives": first[0]["scene"]["primitives"],
        "arithmetic": first[0]["method"]["arithmetic"], "options": first[0]["method"]["options"],
        "read_seconds": median(r[0]["seconds"]["read"] for r in runs),
        "build_seconds": median(_processor(r[0], "build") for r in runs),
        "cells": [{"guarantee": r["guarantee"], "visible": r["visible"], "statistics": r["statistics"],
                   "query_seconds": median(_processor(results[i], "query") for results in runs),
                   "wall_seconds": median(results[i]["seconds"]["query"] for results in runs)}
                  for i, r in enumerate(first)],
    }


def _processor(result: dict, step: str) -> float:
    """Processor seconds of a query or of building; wall seconds of a program that does not say."""
    seconds = result["seconds"]
    return seconds.get({"query": "processor", "build": "build_processor"}[step], seconds[step])
