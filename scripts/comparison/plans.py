"""The layouts: what `bench run` runs in each mode."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from pathlib import Path

from .layout import Cell, Layout, Method, Scene


def cell(kind: str, x: float, y: float, z: float, size: float, height: float = 2) -> Cell:
    """A square cell about (x, y) that stands at z."""
    return Cell(kind, size, (x - size / 2, y - size / 2, z), (x + size / 2, y + size / 2, z + height))


# Scenes -------------------------------------------------------------------------------------------------------------------

def city(name: str, sites: int, base: float, street: float, heights: tuple[float, float], family: str = "",
         sizes: bool = True) -> Scene:
    """`gen:city`: a square of four removed sites in the middle, streets on the axes, junctions at every pitch."""
    pitch, half = base + street, street / 2
    low, high = heights
    large = (cell("square", 0, 0, 0, 0.8 * (2 * pitch)), cell("street", 0, 1.5 * pitch, 0, 0.9 * street))
    cells = (cell("square", 0, 0, 0, street), cell("street", 0, 1.5 * pitch, 0, street / 4),
             cell("junction", 0, 2 * pitch, 0, street / 2), cell("roof", 0, 0, (low + high) / 2, street / 2),
             *(large if sizes else ()))
    source = f"gen:city,n={sites},base={base:g},street={street:g},low={low:g},high={high:g},seed=1"
    return Scene(name, source, cells, height_field=True, family=family)


def town(sites: int, family: str = "", sizes: bool = False) -> Scene:
    """Dense town of narrow streets."""
    return city(f"town {sites:,}", sites, 40, 11.6, (12, 25), family, sizes)


def towers(sites: int) -> Scene:
    """The city of Cohen-Or et al. 1998."""
    return city(f"towers {sites:,}", sites, 100, 100, (200, 900))


def slanted(buildings: int, family: str = "") -> Scene:
    """Random buildings with slanting roofs [Bittner05]."""
    cells = (cell("square", 0, 0, 0, 4), cell("square", 0, 0, 0, 8), cell("square", 0, 0, 0, 16), cell("roof", 0, 0, 6, 8))
    return Scene(f"slanted {buildings:,}", f"gen:slanted,n={buildings},seed=1", cells, height_field=True, family=family)


AVENUES = (cell("junction", 0, 0, 0, 3, 2.5), cell("junction", 0, 0, 0, 25, 2.5), cell("street", 0, 60, 0, 9, 2.5))


def urban(buildings: int) -> Scene:
    """H, T and plain buildings with parking decks, which one looks through: no height field [Leyvand03]."""
    return Scene(f"urban {buildings:,}", f"gen:urban,n={buildings},seed=1", AVENUES)


def urban_grounded(buildings: int) -> Scene:
    """The same with everything below upper surfaces solid, so that there is a truth."""
    return Scene(f"urban {buildings:,}, grounded", f"gen:urban,n={buildings},seed=1", AVENUES, ("--grounded",), height_field=True)


def district(copies: int) -> Scene:
    """Town houses in detail [Durand00]. Windows, sills and eaves overhang, so there is no truth."""
    cells = (cell("junction", 0, 0, 0.5, 4), cell("junction", 0, 0, 0.5, 12), cell("street", 0, 40, 0.5, 8))
    return Scene(f"district {copies}", f"gen:district,copies={copies},seed=1", cells)


def box_field(boxes: int) -> Scene:
    """Boxes of any orientation around a cleared column [Leyvand03]."""
    cells = (cell("square", 0, 0, 0, 4, 4), cell("square", 0, 0, 0, 20, 10))
    return Scene(f"box field {boxes:,}", f"gen:box-field,n={boxes},density=0.5,seed=1", cells)


def spheres(side: int) -> Scene:
    """Balls on a jittered grid [CohenOr98]; the cell stands where one was removed."""
    middle = 100 * (side + 1 if side % 2 == 0 else side)
    return Scene(f"spheres {side ** 3 - 1:,}", f"gen:spheres,n={side},seed=1",
                 (cell("square", 0, 0, middle - 5, 10, 10), cell("square", 0, 0, middle - 20, 40, 40)))


def forest(trees: int) -> Scene:
    """Trees of loose leaves [Durand00]."""
    return Scene(f"forest {trees:,}", f"gen:forest,n={trees},leaf=0.6,seed=1",
                 (cell("square", 0, 0, 1.25, 0.1, 0.1), cell("square", 0, 0, 1.25, 0.5, 0.5)))


# Free places of the real cities; those with a letter also stand in benchmarks/strong_occlusion/cities.cpp.
REAL = (
    Scene("Akihabara", "city/tokyo_akihabara.geojsonl",
          (cell("street", 161.28, 891.76, 0.5, 4), cell("street", 157.75, 981.90, 0.5, 4), cell("street", 131.20, 908.38, 0.5, 4),
           cell("roof", 300, 900, 40, 20)), height_field=True),
    Scene("Chuo", "city/tokyo_chuo.geojsonl.gz",
          (cell("street", 782, -1366, 0, 4), cell("street", 956, -1831, 0, 12), cell("junction", 465, -2873, 0, 20),
           cell("square", 760, -969, 0, 36), cell("roof", 465, -2873, 60, 20)), height_field=True),
    Scene("Lyon 1", "city/lyon1.geojson",
          (cell("street", 1841950.79, 5176044.36, 170, 4), cell("street", 1842326.21, 5176078.02, 170, 4),
           cell("street", 1842419.07, 5176003.44, 170, 4))),
    Scene("Rotterdam, grounded", "city/rotterdam_centre.ply",
          (cell("street", 701.95, -94.22, 0.5, 4), cell("street", 705.74, 79.12, 0.5, 4), cell("square", 1029.72, 504.44, 0.5, 4)),
          ("--grounded",), height_field=True),
    Scene("Manhattan, grounded", "city/lower_manhattan.ply",
          (cell("street", -2387.30, -7632.57, 0.5, 4), cell("street", -2789.32, -7413.23, 0.5, 4),
           cell("square", -2989.51, -8013.78, 0.5, 4)), ("--grounded",), height_field=True),
)


# Methods ------------------------------------------------------------------------------------------------------------------

def defaults() -> list[Method]:
    """Each method as it comes, sampling aside."""
    return [Method("strong-occlusion"), Method("exact-2.5d"), Method("extended-projection"), Method("occlusion-sweep"),
            Method("ray-space")]


def variations(resolutions: tuple[int, ...], components: tuple[int, ...]) -> list[Method]:
    """One option varied at a time, the others as they come."""
    out = [Method("strong-occlusion", ("--granularity", g), "granularity", g) for g in ("object", "part", "triangle")]
    out += [Method("strong-occlusion", ("--no-inner-bodies",), "inner bodies", "no inner bodies")]
    out += [Method(m, ("--arithmetic", a), "arithmetic", a)
            for m in ("strong-occlusion", "exact-2.5d") for a in ("rational", "double")]
    out += [Method(m, ("--tally",), "tally", "tally") for m in ("strong-occlusion", "exact-2.5d")]
    out += [Method(m, ("--resolution", str(r)), "resolution", str(r))
            for m, default in (("extended-projection", 256), ("occlusion-sweep", 256), ("ray-space", 4096))
            for r in resolutions if r != default]
    out += [Method("ray-space", ("--components", str(k)), "components", str(k)) for k in components if k != 2]
    out += [Method("ray-space", ("--granularity", "object"), "granularity", "object"),
            Method("ray-space", ("--bounds", "linear"), "bounds", "linear bounds"),
            Method("occlusion-sweep", ("--convolution",), "reprojection", "convolution")]
    return out


def sampling(budgets: tuple[int, ...]) -> list[Method]:
    """Guided rays, growing budgets, all from seed 1."""
    return [Method("sampling", ("--rays", str(n), "--seed", "1"), "rays", str(n)) for n in budgets]


# Layouts ------------------------------------------------------------------------------------------------------------------

def _wanted(method: Method, kind: str, most_rays: int) -> bool:
    """`kind`: compared (all methods), growth (methods as they come), small (arithmetics: rational numbers take a thousand times
    longer in the worst case, so they run on small scenes alone)."""
    if kind == "compared":
        return method.value != "rational"
    if kind == "small":
        return method.name in ("strong-occlusion", "exact-2.5d") and method.sweep in ("", "arithmetic")
    return not method.sweep or method.sweep == "rays" and int(method.value) == most_rays


def _layout(mode: str, scenes_folder: Path, scenes: dict[str, list[Scene]], real: tuple[Scene, ...], varied: list[Method],
            budgets: tuple[int, ...], **limits: float) -> Layout:
    """`scenes`: by the kinds of `_wanted`; `real`: compared too, where the files are there."""
    methods = defaults() + varied + sampling(budgets)
    notes, found = [], []
    for scene in real:
        file = scenes_folder / scene.source
        if file.exists():
            found.append(replace(scene, digest=hashlib.sha256(file.read_bytes()).hexdigest()[:16]))
        else:
            notes.append(f"{scene.name} is left out: {scene.source} is not in the folder of real scenes")
    kinds = [(s, kind) for kind, of_kind in (scenes | {"compared": scenes["compared"] + found}).items() for s in of_kind]
    rows = [(i, j) for i, (scene, kind) in enumerate(kinds) for j, method in enumerate(methods)
            if _wanted(method, kind, max(budgets)) and (method.name != "exact-2.5d" or scene.height_field)]
    return Layout(mode, tuple(s for s, _ in kinds), tuple(methods), tuple(rows), notes=tuple(notes), **limits)


def smoke(scenes_folder: Path) -> Layout:
    """Everything once, on next to nothing: seconds."""
    scenes = {"compared": [town(64), box_field(60)], "growth": [town(16, "town"), town(36, "town")], "small": [slanted(20)]}
    return _layout("smoke", scenes_folder, scenes, (), variations((32, 64), (1,)), (300, 3000), repeats=1, timeout=60)


def quick(scenes_folder: Path) -> Layout:
    """Minutes: scenes of thousands of objects."""
    scenes = {"compared": [town(3000, "town", True), towers(2500), slanted(1000, "slanted"), urban(500), urban_grounded(500),
                           district(1), box_field(1000), spheres(10)],
              "growth": [town(1000, "town"), town(10_000, "town"), town(30_000, "town"), slanted(300, "slanted"),
                         slanted(3000, "slanted")],
              "small": [town(300), slanted(100)]}
    return _layout("quick", scenes_folder, scenes, REAL[:2], variations((64, 128, 256, 512), (1, 4, 8)),
                   (1000, 10_000, 100_000, 1_000_000), repeats=3, repeat_seconds=0.5, timeout=120)


def full(scenes_folder: Path) -> Layout:
    """An hour or two: the published sizes where methods allow, all real cities."""
    scenes = {"compared": [town(3000, "town", True), towers(2500), towers(20_000), slanted(3567, "slanted"), urban(2000),
                           urban_grounded(2000), urban(8000), district(4), box_field(10_000), spheres(20), forest(250)],
              "growth": [town(1000, "town"), town(10_000, "town"), town(30_000, "town"), town(100_000, "town"),
                         town(300_000, "town"), slanted(1000, "slanted"), slanted(10_000, "slanted"), slanted(30_000, "slanted")],
              "small": [town(300), slanted(100)]}
    return _layout("full", scenes_folder, scenes, REAL, variations((64, 128, 256, 512, 1024), (1, 4, 8, 16)),
                   (1000, 10_000, 100_000, 1_000_000, 10_000_000), repeats=5, repeat_seconds=5, timeout=300)


MODES = {"smoke": smoke, "quick": quick, "full": full}
