"""What the notebooks share: saved results of the benchmarks, the papers' numbers, and the command line."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd

HERE = Path(__file__).resolve().parent
# Set by scripts/notebooks: where the saved results are, and the program.
RESULTS = Path(os.environ.get("VISIBILITY_RESULTS", HERE.parent / "notebook-results"))
PROGRAM = os.environ.get("VISIBILITY_PROGRAM", str(HERE.parent / "build" / "release" / "bin" / "visibility"))

PAPER, OURS, SECOND = "#000000", "#0072B2", "#D55E00"  # Okabe and Ito

plt.rcParams.update({"figure.dpi": 90, "axes.grid": True, "grid.color": "#dddddd", "axes.spines.top": False,
                     "axes.spines.right": False, "legend.frameon": False, "font.size": 9})


def saved(benchmark: str) -> dict:
    """What `<benchmark>_bench NAME... --json` wrote. Throws FileNotFoundError if it did not run."""
    return json.loads((RESULTS / f"{benchmark}.json").read_text())


def origin(benchmark: str) -> str:
    """Where and with what the results came about, in a line."""
    s = saved(benchmark)
    size = "small data, for a test" if "--smoke" in s["command"] else "full size"
    return f"{s['command']} ({size}); commit {s['commit']}, {s['compiler']}, {s['machine']}"


def table(benchmark: str, title: str) -> pd.DataFrame:
    """The one table whose title starts so. Columns of equal names are numbered: ours, ours.1, ..."""
    found = [t for t in saved(benchmark)["tables"] if t["title"].startswith(title)]
    if len(found) != 1:
        raise KeyError(f"{benchmark}: {len(found)} tables start with '{title}'")
    seen: dict[str, int] = {}
    names = []
    for column in found[0]["columns"]:
        column = column.strip()
        n = seen.get(column, 0)
        seen[column] = n + 1
        names.append(f"{column}.{n}" if n else column)
    return pd.DataFrame(found[0]["rows"], columns=names)


def paper(name: str) -> pd.DataFrame:
    """The numbers of a paper, typed from it: papers/<name>.csv, whose first line says what they are."""
    return pd.read_csv(HERE / "papers" / f"{name}.csv", comment="#")


def assert_same(typed: pd.Series, of_benchmark: pd.Series) -> None:
    """The benchmarks hold numbers of the papers too, typed at another time: where both have one they must agree."""
    numbers = of_benchmark.dropna().astype(float)
    assert len(numbers) > 0
    for at, value in numbers.items():
        assert abs(typed[at] - value) <= 1e-9 + 5e-3 * abs(value), f"{at}: {typed[at]} in papers/, {value} in the benchmark"


def visibility(*words: object) -> str:
    """Runs the command line. Gives its standard output; throws RuntimeError with its message unless it exits with 0 or 1."""
    run = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
    if run.returncode not in (0, 1):
        raise RuntimeError(run.stderr.strip())
    return run.stdout


def pvs(scene: str, cell: tuple[float, ...], method: str, *options: object) -> dict:
    """One set: `visibility pvs`."""
    return json.loads(visibility("pvs", scene, "--cell=" + ",".join(f"{x:g}" for x in cell), "--method", method, *options))


def boxes(scene: str) -> dict[str, list[tuple[float, ...]]]:
    """Of each object of a generated scene of boxes, its boxes: x0, y0, z0, x1, y1, z1 in metres."""
    kind, *parameters = scene.removeprefix("gen:").split(",")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "scene.json"
        visibility("generate", kind, *parameters, "-o", file)
        objects = json.loads(file.read_text())["objects"]
    return {o["name"]: [tuple(o["boxes"][i:i + 6]) for i in range(0, len(o["boxes"]), 6)] for o in objects}


def powers_of_two(axes: plt.Axes) -> None:
    """The horizontal axis by powers of two, as plain numbers."""
    axes.set_xscale("log", base=2)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")


def draw_plan(axes: plt.Axes, scene: dict[str, list[tuple[float, ...]]], cell: tuple[float, ...], colours: dict[str, str]) -> None:
    """The scene from above. `colours`: of objects by name; the others are drawn pale."""
    for name, parts in scene.items():
        for x0, y0, _, x1, y1, _ in parts:
            axes.add_patch(plt.Rectangle((x0, y0), x1 - x0, y1 - y0, fc=colours.get(name, "#e3e3e3"), ec="white", lw=0.4))
    x0, y0, _, x1, y1, _ = cell
    axes.add_patch(plt.Rectangle((x0, y0), x1 - x0, y1 - y0, fc="#CC79A7", ec="black", lw=0.6, zorder=4))
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.grid(False)
    axes.set_xlabel("x, m")
    axes.set_ylabel("y, m")


__all__ = ["OURS", "PAPER", "SECOND", "assert_same", "boxes", "draw_plan", "origin", "paper", "pd", "plt",
           "powers_of_two", "pvs", "saved", "table", "visibility"]
