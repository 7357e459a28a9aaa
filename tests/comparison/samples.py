"""A small comparison made by hand, as `bench run` would leave it."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))

from comparison import measures, plans  # noqa: E402
from comparison.layout import FORMAT, Layout, Method, Scene  # noqa: E402

NAMES = [f"building {i}" for i in range(10)]
EXACT, SUPERSET, SEEN = set(NAMES[:4]), set(NAMES[:6]), set(NAMES[:3])
METHODS = (Method("strong-occlusion"), Method("exact-2.5d"), Method("ray-space"), Method("extended-projection"),
           Method("occlusion-sweep"), Method("ray-space", ("--resolution", "64"), "resolution", "64"),
           Method("sampling", ("--rays", "1000"), "rays", "1000"), Method("exact-2.5d", ("--tally",), "tally", "tally"))


def layout(**changes: object) -> Layout:
    cells = (plans.cell("street", 0, 0, 0, 4), plans.cell("street", 0, 0, 0, 8))
    scenes = (Scene("town", "gen:city,n=16", cells, height_field=True, family="town"),
              Scene("large town", "gen:city,n=36", cells, height_field=True, family="town"))
    rows = tuple((i, j) for i in range(2) for j in range(len(METHODS)))
    return Layout(**{"mode": "test", "scenes": scenes, "methods": METHODS, "rows": rows, **changes})


def row(scene: int, method: int, visible: set[str], guarantee: str, seconds: float = 0.01) -> dict:
    cell = {"guarantee": guarantee, "visible": sorted(visible), "query_seconds": seconds * (1 + method), "wall_seconds": 2 * seconds,
            "statistics": {"signs_filter": 90, "signs_interval": 9, "signs_exact": 1}}
    return {"scene": layout().scenes[scene].name, "method": METHODS[method].label, "command": "visibility pvs <scene> & more",
            "scene_index": scene, "method_index": method, "state": "finished", "peak_kib": 20000, "floor_kib": 10000, "runs": 1, "objects": 10 + 30 * scene,
            "primitives": 10, "arithmetic": "filtered", "options": {"resolution": "64" if METHODS[method].sweep else "512"},
            "read_seconds": 0.1, "build_seconds": 0.2, "cells": [dict(cell), dict(cell)]}


def rows(scene: int, seconds: float = 0.01) -> list[dict]:
    out = []
    for j, method in enumerate(METHODS):
        guarantee = {"exact-2.5d": "exact", "sampling": "aggressive"}.get(method.name, "conservative")
        visible = {"exact": EXACT, "aggressive": SEEN, "conservative": SUPERSET}[guarantee]
        out.append(row(scene, j, visible, guarantee, seconds))
    return out


def comparison(of_scenes: list[list[dict]] | None = None, plan: Layout | None = None) -> dict:
    measured = [m for r in (of_scenes or [rows(0), rows(1)]) for m in measures.measure_scene(r)]
    machine = {"date": "2000-01-01", "processor": "P", "cores": 1, "memory": "1 kB", "system": "S", "compiler": "C", "build_type": "Release",
               "commit": "abc", "program_digest": "d"}
    return {"format": FORMAT, "layout": (plan or layout()).json(), "machine": machine, "rows": measured, "faults": measures.faults(measured)}
