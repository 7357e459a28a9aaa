"""The rows of a comparison as plots and tables want them."""

from __future__ import annotations

from dataclasses import dataclass
from statistics import median
from typing import Callable

from .layout import Method


def method_of(comparison: dict, row: dict) -> Method:
    entry = comparison["layout"]["methods"][row["method_index"]]
    return Method(entry["name"], tuple(entry["arguments"]), entry["sweep"], entry["value"])


def cell_of(comparison: dict, row: dict, measured: dict) -> dict:
    return comparison["layout"]["scenes"][row["scene_index"]]["cells"][measured["cell"]]


def finished(comparison: dict) -> list[dict]:
    return [r for r in comparison["rows"] if r["state"] == "finished"]


def excess(measured: dict) -> float | None:
    """|P| / |truth|, whichever truth there is."""
    return measured["overestimation"] if measured["overestimation"] is not None else measured["over_lower_bound"]


def median_of(row: dict, key: Callable[[dict], float | None]) -> float | None:
    """Over the cells of a row; of those that have the measure."""
    values = [v for v in map(key, row["measures"]) if v is not None]
    return median(values) if values else None


def query_ms(row: dict) -> float:
    return 1e3 * median(m["query_seconds"] for m in row["measures"])


def peak_mib(row: dict) -> float | str:
    """Peak memory of a row, or a bound where the measurement could not fall below it."""
    mib = row["peak_kib"] / 1024
    return f"≤ {mib:.3g}" if row["peak_kib"] <= row["floor_kib"] else mib


def has_truth(rows: list[dict]) -> bool:
    """Whether there is an exact set for every cell of the rows of a scene."""
    return all(m["truth"] == "exact" for r in rows for m in r["measures"])


def promises_superset(row: dict) -> bool:
    return all(m["guarantee"] in ("exact", "conservative") for m in row["measures"])


@dataclass(frozen=True)
class Point:
    """A configuration of a method in a scene: median time and median excess over the cells."""

    method: Method
    milliseconds: float
    excess: float


def pareto_front(points: list[Point]) -> list[Point]:
    """Those that no other beats in time and excess both, by time."""
    front: list[Point] = []
    for p in sorted(points, key=lambda q: (q.milliseconds, q.excess)):
        if not front or p.excess < front[-1].excess:
            front.append(p)
    return front


def points_of(comparison: dict, scene_index: int) -> list[Point]:
    """Configurations that promise a superset. Rows with a tally are timed with the counting, and left out."""
    out = []
    for row in finished(comparison):
        method = method_of(comparison, row)
        value = median_of(row, excess)
        if row["scene_index"] == scene_index and promises_superset(row) and method.sweep != "tally" and value is not None:
            out.append(Point(method, query_ms(row), value))
    return out


def compared_scenes(comparison: dict) -> list[int]:
    """Scenes on which resolutions are varied."""
    methods = comparison["layout"]["methods"]
    return sorted({i for i, j in comparison["layout"]["rows"] if methods[j]["sweep"] == "resolution"})
