"""What the notebooks share: saved results of the benchmarks, the papers' numbers, and the command line."""

from __future__ import annotations

import base64
import json
import os
import subprocess
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
from IPython.display import HTML

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


def powers_of_two(axes: plt.Axes) -> None:
    """The horizontal axis by powers of two, as plain numbers."""
    axes.set_xscale("log", base=2)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")


class View:
    """One view cell of one scene, and a folder for the files that commands exchange about it."""

    def __init__(self, scene: str, cell: tuple[float, ...]) -> None:
        self.scene, self.cell = scene, "--cell=" + ",".join(f"{x:g}" for x in cell)
        self._folder = tempfile.TemporaryDirectory()

    def file(self, name: str) -> Path:
        return Path(self._folder.name) / name

    def pvs(self, name: str, method: str, *options: object) -> dict:
        """The set of a method, also left in the file <name>.json."""
        visibility("pvs", self.scene, self.cell, "--method", method, *options, "-o", self.file(f"{name}.json"))
        return json.loads(self.file(f"{name}.json").read_text())

    def draw(self, name: str, *options: object, width: int = 600) -> str:
        """`visibility draw` of the set <name>.json, as an image for show(). Files among the options are those of this view."""
        picture = self.file("picture.svg")
        visibility("draw", self.scene, self.file(f"{name}.json"), *options, "--size", width, "-o", picture)
        data = base64.b64encode(picture.read_bytes()).decode()
        return f'<img width="{width}" style="display: inline; margin: 4px" src="data:image/svg+xml;base64,{data}"/>'


def show(*images: str) -> HTML:
    return HTML("".join(images))


__all__ = ["OURS", "PAPER", "SECOND", "View", "assert_same", "origin", "paper", "pd", "plt", "powers_of_two", "saved", "show", "table",
           "visibility"]
