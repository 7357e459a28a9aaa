"""The tables of a comparison over all its scenes, for the page and for the text."""

from __future__ import annotations

from dataclasses import dataclass
from statistics import median

from . import table


@dataclass(frozen=True)
class Table:
    """`rows`: of strings, numbers, and None where there is nothing to say."""

    title: str
    head: list[str]
    rows: list[list[object]]
    note: str = ""


def text(value: object) -> str:
    """Of a table: counts in full, measurements with three digits, nothing where there is none."""
    if value is None:
        return "–"
    if isinstance(value, float):
        return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.3g}"
    return f"{value:,}" if isinstance(value, int) else str(value)


def verdict(comparison: dict) -> str:
    """What was held against what, if there are no faults."""
    checked = [m for r in table.finished(comparison) for m in r["measures"] if m["guarantee"] in ("exact", "conservative")]
    exact = sum(m["truth"] == "exact" for m in checked)
    return (f"No object falsely hidden in {len(checked):,} sets that call themselves exact or conservative: {exact:,} held against an "
            f"exact set, {len(checked) - exact:,} against objects with a confirmed sight line.")


def wall_share(comparison: dict) -> float:
    """How much longer queries took than they computed, because the machine did other things too."""
    return median([m["wall_seconds"] / m["query_seconds"] for r in table.finished(comparison) for m in r["measures"]
                   if m["query_seconds"] > 0] or [1.0])


def machine(comparison: dict) -> list[tuple[str, str]]:
    m, layout = comparison["machine"], comparison["layout"]
    return [("date", m["date"]), ("commit", m["commit"]), ("compiler", f"{m['compiler']}, {m['build_type']}"),
            ("machine", f"{m['processor']}, {m['cores']} cores, {m['memory']}, {m['system']}"),
            ("mode", f"{layout['mode']}, layout {layout['identity']}: {len(layout['rows'])} rows, one process each, one thread, at most "
                     f"{layout['repeats']} runs (fewer after {layout['repeat_seconds']:g} s), {layout['timeout']:g} s a run"),
            ("query times", f"processor time of one thread; wall time was {wall_share(comparison):.2f} times that (median)")]


def methods(comparison: dict) -> Table:
    """A line per method, as it comes."""
    rows = []
    for mine in _as_they_come(comparison).values():
        measured = [m for r in mine for m in r["measures"]]
        over = [m["overestimation"] for m in measured if m["overestimation"] is not None]
        recalls = [m["recall"] for m in measured if m["recall"] is not None and m["truth"] == "exact"]
        promises = any(m["guarantee"] in ("exact", "conservative") for m in measured)
        rows.append([table.method_of(comparison, mine[0]).label, len(measured), 1e3 * median(m["query_seconds"] for m in measured),
                     1e3 * median(r["build_seconds"] for r in mine), median(over) if over and promises else None,
                     max(over) if over and promises else None, 100 * min(recalls) if recalls else None,
                     sum(m["false_hidden"] for m in measured) if promises else None, table.peak_mib(max(mine, key=lambda r: r["peak_kib"]))])
    return Table("Methods", ["method, default options", "cells", "query, ms (median)", "build, ms (median)", "|P| / |E| (median)",
                             "(worst)", "least recall, %", "false hidden", "peak memory, MiB"], rows,
                 "Over all cells of all scenes that a method applies to. |P| / |E|: set over exact set, where there is one.")


def scenes(comparison: dict) -> Table:
    """A line per scene, a column per method as it comes."""
    of_method = _as_they_come(comparison)
    rows = []
    for i, scene in enumerate(comparison["layout"]["scenes"]):
        finished = [r for r in table.finished(comparison) if r["scene_index"] == i]
        if not finished:
            continue
        cells = []
        for mine in of_method.values():
            row = next((r for r in mine if r["scene_index"] == i), None)
            excess = table.median_of(row, table.excess) if row else None
            cells.append(f"{text(table.query_ms(row))} · {text(excess)}".replace(" ", "\u00a0") if row else None)
        rows.append([scene["name"], finished[0]["objects"], "E" if table.has_truth(finished) else "seen", *cells])
    labels = [table.method_of(comparison, mine[0]).label for mine in of_method.values()]
    return Table("Scenes", ["scene", "objects", "against", *labels], rows,
                 "Methods as they come: query, ms · set over the exact set E, or over what some rays saw; medians over cells.")


def options(comparison: dict) -> Table:
    """What each option does to time and set, against the method as it comes."""
    default = {(r["scene_index"], table.method_of(comparison, r).name): r for r in table.finished(comparison)
               if not table.method_of(comparison, r).sweep}
    pairs: dict[str, list[tuple[float, float]]] = {}
    for row in table.finished(comparison):
        method = table.method_of(comparison, row)
        other = default.get((row["scene_index"], method.name))
        if method.sweep in ("", "rays", "tally") or other is None or row["scene_index"] not in table.compared_scenes(comparison):
            continue
        sizes = [a["size"] / b["size"] for a, b in zip(row["measures"], other["measures"]) if b["size"]]
        if sizes:
            pairs.setdefault(method.label, []).append((table.query_ms(row) / table.query_ms(other), median(sizes)))
    rows = [[label, len(of), median(t for t, _ in of), median(s for _, s in of), min(s for _, s in of), max(s for _, s in of)]
            for label, of in pairs.items()]
    return Table("Options", ["", "scenes", "time / default", "set / default (median)", "(least)", "(greatest)"], rows,
                 "Medians over the cells of a scene, then over scenes.")


def arithmetic(comparison: dict) -> Table:
    """What exactness costs, and what plain floating point gets wrong, over the scenes that have both."""
    rows = []
    for name in ("strong-occlusion", "exact-2.5d"):
        by_scene = {(r["scene_index"], r["arithmetic"]): r for r in table.finished(comparison)
                    if (m := table.method_of(comparison, r)).name == name and m.sweep in ("", "arithmetic")}
        for kind in ("filtered", "rational", "double"):
            pairs = [(r, by_scene[i, "filtered"]) for (i, a), r in by_scene.items() if a == kind and (i, "filtered") in by_scene
                     and any((i, b) in by_scene for b in ("rational", "double"))]
            if not pairs:
                continue
            cells = [(x, y) for r, f in pairs for x, y in zip(r["measures"], f["measures"])]
            rows.append([f"{name}, {kind}", len(cells), median(x["query_seconds"] / y["query_seconds"] for x, y in cells),
                         sum(x["digest"] != y["digest"] for x, y in cells), sum(x["false_hidden"] for x, _ in cells),
                         sum(x["false_visible"] or 0 for x, _ in cells) if name == "exact-2.5d" else None])
    return Table("Arithmetic", ["", "cells", "time / filtered (median)", "cells with another set", "false hidden", "false visible"], rows)


def layers(comparison: dict) -> Table:
    """Which layer of the filtered arithmetic decided."""
    rows = []
    for row in table.finished(comparison):
        if table.method_of(comparison, row).sweep != "tally":
            continue
        signs = [sum(m["statistics"][f"signs_{layer}"] for m in row["measures"]) for layer in ("filter", "interval", "exact")]
        total = sum(signs)
        rows.append([f"{row['scene']}: {row['method'].removesuffix(', tally')}", int(total), *(100 * s / total if total else None for s in signs)])
    return Table("Layers of the filtered arithmetic", ["", "signs", "floating-point filter, %", "intervals, %", "exact numbers, %"], rows)


def _as_they_come(comparison: dict) -> dict[str, list[dict]]:
    """The finished rows of each method without options; of sampling, those with most rays."""
    out: dict[str, list[dict]] = {}
    for name in dict.fromkeys(m["name"] for m in comparison["layout"]["methods"]):
        mine = [r for r in table.finished(comparison) if table.method_of(comparison, r).name == name]
        plain = [r for r in mine if not table.method_of(comparison, r).sweep]
        if not plain and mine:
            most = max(int(table.method_of(comparison, r).value) for r in mine)
            plain = [r for r in mine if int(table.method_of(comparison, r).value) == most]
        if plain:
            out[name] = plain
    return out


def markdown(comparison: dict) -> str:
    """All of this as text."""
    faults = comparison["faults"]
    lines = ["# Comparison of all methods", "", *([f"- FAULT: {f}" for f in faults] or [verdict(comparison)]), ""]
    lines += [f"- {name}: {value}" for name, value in machine(comparison)]
    for of in (methods, scenes, options, arithmetic, layers):
        t = of(comparison)
        if t.rows:
            lines += ["", f"## {t.title}", *([t.note] if t.note else []), "", _line(t.head), _line(["---"] * len(t.head)), *(_line(r) for r in t.rows)]
    return "\n".join(lines) + "\n"


def _line(cells: list[object]) -> str:
    return "| " + " | ".join(text(c).replace("|", "\\|") for c in cells) + " |"
