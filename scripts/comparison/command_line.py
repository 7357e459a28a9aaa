"""The subcommands of scripts/bench. Exit codes: 0 success; 1 a promise is broken or a row failed; 2 bad input, one line said."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import compare, machine, measures, plans
from .layout import FORMAT, Layout
from .progress import Progress
from .runner import Interrupted, run_row
from .store import Store, StoreError

SOURCE = Path(__file__).resolve().parents[2]
PROGRAMS = ("release", "bench")


class UsageError(Exception):
    """One line: what is wrong and what to do."""


def find_program(given: str | None) -> Path:
    """The program to measure: `given`, or what a preset has built."""
    candidates = [Path(given)] if given else [SOURCE / "build" / p / "bin" / "visibility" for p in PROGRAMS]
    for candidate in candidates:
        if candidate.is_file():
            return candidate
    raise UsageError(f"{candidates[0]}: no such program; build it (cmake --preset release && cmake --build --preset release) or "
                     "name it with --program")


def run_layout(store: Store, layout: Layout, program: Path, scenes_folder: Path) -> None:
    """Runs the rows that the folder lacks."""
    store.open(layout.json(), machine.describe(program, SOURCE))
    done = sum(store.has_row(i, j) for i, j in layout.rows)
    progress = Progress(len(layout.rows), done)
    try:
        for i, j in layout.rows:
            if store.has_row(i, j):
                continue
            scene, method = layout.scenes[i], layout.methods[j]
            progress.working_on(f"{scene.name}: {method.label}")
            row = run_row(program, scenes_folder, layout, scene, method)
            store.add_row(i, j, row)
            note = "" if row["state"] == "finished" else f" -- {row['state']}"
            progress.finished(f"{scene.name}: {method.label}{note}")
    finally:
        progress.end()


def summarize(store: Store) -> dict:
    """The measures of all rows, written to the folder."""
    run = store.run()
    layout = run["layout"]
    rows: list[dict] = []
    for i in range(len(layout["scenes"])):
        of_scene = [dict(store.row(*pair), scene_index=pair[0], method_index=pair[1]) for pair in layout["rows"] if pair[0] == i]
        rows += measures.measure_scene(of_scene)
    comparison = {"format": FORMAT, "layout": layout, "machine": run["machine"], "rows": rows, "faults": measures.faults(rows)}
    store.write_comparison(comparison)
    return comparison


def write_report(store: Store, comparison: dict) -> int:
    """Renders the report; returns the exit code."""
    from . import report, summaries  # matplotlib is large, and what this process holds counts as memory of its children

    for path in store.write_report(report.render(comparison), summaries.markdown(comparison)):
        print(path)
    for fault in comparison["faults"]:
        print(f"FAULT: {fault}", file=sys.stderr)
    return 1 if comparison["faults"] else 0


def _run(arguments: argparse.Namespace) -> int:
    mode = "full" if arguments.full else "smoke" if arguments.smoke else "quick"
    scenes_folder = Path(arguments.scenes)
    store = Store(Path(arguments.output or f"comparison-{mode}"))
    layout = plans.MODES[mode](scenes_folder)
    for note in layout.notes:
        print(note, file=sys.stderr)
    try:
        run_layout(store, layout, find_program(arguments.program), scenes_folder)
    except (Interrupted, KeyboardInterrupt):
        raise UsageError(f"interrupted; the same command goes on where it stopped ({store.folder})") from None
    return write_report(store, summarize(store))


def _report(arguments: argparse.Namespace) -> int:
    store = Store(Path(arguments.folder))
    return write_report(store, summarize(store))


def _compare(arguments: argparse.Namespace) -> int:
    text, code = compare.compare(Store(Path(arguments.a)).comparison(), Store(Path(arguments.b)).comparison())
    print(text)
    return code


def parser() -> argparse.ArgumentParser:
    out = argparse.ArgumentParser(prog="bench", description="Compares all methods on generated and real scenes.")
    commands = out.add_subparsers(required=True, metavar="run|report|compare")
    run = commands.add_parser("run", help="run the comparison, or what an interrupted run has left, and write the report")
    mode = run.add_mutually_exclusive_group()
    mode.add_argument("--quick", action="store_true", help="minutes (default)")
    mode.add_argument("--full", action="store_true", help="an hour or two")
    mode.add_argument("--smoke", action="store_true", help="seconds")
    run.add_argument("-o", "--output", metavar="DIR", help="folder of the run (default: comparison-MODE)")
    run.add_argument("--program", help="the program visibility (default: that of the preset release or bench)")
    run.add_argument("--scenes", default=str(SOURCE.parent / "shared" / "scenes"), metavar="DIR",
                     help="folder of real scenes, used when there (default: ../shared/scenes beside the checkout)")
    run.set_defaults(call=_run)
    report = commands.add_parser("report", help="measure and render a finished run again")
    report.add_argument("folder", metavar="DIR")
    report.set_defaults(call=_report)
    comparison = commands.add_parser("compare", help="two runs of one layout side by side; exit code 1 if exact sets differ")
    comparison.add_argument("a", metavar="A")
    comparison.add_argument("b", metavar="B")
    comparison.set_defaults(call=_compare)
    return out


def main(words: list[str]) -> int:
    arguments = parser().parse_args(words)
    try:
        return arguments.call(arguments)
    except (UsageError, StoreError, compare.LayoutsDiffer) as error:
        print(error, file=sys.stderr)
        return 2
