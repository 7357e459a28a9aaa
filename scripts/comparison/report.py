"""The report: one HTML file that needs nothing else."""

from __future__ import annotations

import html
from statistics import median

from . import plots, table
from .style import svg

CSS = """
body { font: 15px/1.45 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; color: #222; }
table { border-collapse: collapse; margin: .6rem 0 1.4rem; font-size: 13px; }
th, td { padding: .18rem .6rem; text-align: right; border-bottom: 1px solid #ddd; }
th:first-child, td:first-child { text-align: left; }
th { border-bottom: 2px solid #888; vertical-align: bottom; }
h2 { margin-top: 2.2rem; } figure { margin: 0 0 1.2rem; } svg { max-width: 100%; height: auto; }
.fault { background: #b00020; color: #fff; padding: .6rem 1rem; } .sound { background: #e6f4ea; padding: .6rem 1rem; }
.note { color: #555; } code { font-size: 12px; } details code { display: block; margin: .15rem 0; }
"""


def text(value: object) -> str:
    """A table cell: counts in full, measurements with three digits, nothing where there is none."""
    if value is None:
        return "–"
    if isinstance(value, float):
        return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.3g}"
    return f"{value:,}" if isinstance(value, int) else str(value)


def html_table(head: list[str], rows: list[list[object]]) -> str:
    def line(tag: str, cells: list[object]) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(text(c))}</{tag}>" for c in cells) + "</tr>"

    return "<table><thead>" + line("th", head) + "</thead><tbody>" + "".join(line("td", r) for r in rows) + "</tbody></table>"


def verdict(comparison: dict) -> str:
    faults = comparison["faults"]
    if faults:
        items = "".join(f"<li>{html.escape(f)}</li>" for f in faults)
        return f'<div class="fault"><b>{len(faults)} faults</b><ul>{items}</ul></div>'
    checked = [m for r in table.finished(comparison) for m in r["measures"] if m["guarantee"] in ("exact", "conservative")]
    exact = sum(m["truth"] == "exact" for m in checked)
    return (f'<p class="sound">No object falsely hidden in {len(checked):,} sets that call themselves exact or conservative: {exact:,} '
            f"held against an exact set, {len(checked) - exact:,} against objects with a confirmed sight line.</p>")


def wall_share(comparison: dict) -> float:
    """How much longer queries took than they computed, because the machine did other things too."""
    return median([m["wall_seconds"] / m["query_seconds"] for r in table.finished(comparison) for m in r["measures"]
                   if m["query_seconds"] > 0] or [1.0])


def machine(comparison: dict) -> str:
    m, layout = comparison["machine"], comparison["layout"]
    rows = [["date", m["date"]], ["commit", m["commit"]], ["compiler", f"{m['compiler']}, {m['build_type']}"],
            ["machine", f"{m['processor']}, {m['cores']} cores, {m['memory']}, {m['system']}"],
            ["mode", f"{layout['mode']}, layout {layout['identity']}: {len(layout['rows'])} rows, one process each, one thread, at most "
                     f"{layout['repeats']} runs (fewer after {layout['repeat_seconds']:g} s), {layout['timeout']:g} s a run"],
            ["query times", f"processor time of one thread; wall time was {wall_share(comparison):.2f} times that (median)"]]
    return html_table(["", ""], rows).replace("<td>", '<td style="text-align:left">')


def summary(comparison: dict) -> str:
    """A line per method, as it comes; medians over all cells of all scenes."""
    rows = []
    for entry in dict.fromkeys(m["name"] for m in comparison["layout"]["methods"]):
        mine = [r for r in table.finished(comparison) if table.method_of(comparison, r).name == entry]
        mine = [r for r in mine if not table.method_of(comparison, r).sweep] or _largest_budget(comparison, mine)
        measured = [m for r in mine for m in r["measures"]]
        if not measured:
            continue
        over = [m["overestimation"] for m in measured if m["overestimation"] is not None]
        recalls = [m["recall"] for m in measured if m["recall"] is not None and m["truth"] == "exact"]
        promises = any(m["guarantee"] in ("exact", "conservative") for m in measured)
        rows.append([table.method_of(comparison, mine[0]).label, len(measured), 1e3 * median(m["query_seconds"] for m in measured),
                     1e3 * median(r["build_seconds"] for r in mine), median(over) if over and promises else None,
                     max(over) if over and promises else None, 100 * min(recalls) if recalls else None,
                     sum(m["false_hidden"] for m in measured) if promises else None, table.peak_mib(max(mine, key=lambda r: r["peak_kib"]))])
    return html_table(["method, default options", "cells", "query, ms (median)", "build, ms (median)", "|P| / |E| (median)", "(worst)",
                       "least recall, %", "false hidden", "peak memory, MiB"], rows)


def _largest_budget(comparison: dict, rows: list[dict]) -> list[dict]:
    most = max((int(table.method_of(comparison, r).value) for r in rows), default=0)
    return [r for r in rows if int(table.method_of(comparison, r).value) == most]


def arithmetic(comparison: dict) -> str:
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
    return html_table(["", "cells", "time / filtered (median)", "cells with another set", "false hidden", "false visible"], rows)


def layers(comparison: dict) -> str:
    """Which layer of the filtered arithmetic decided."""
    rows = []
    for row in table.finished(comparison):
        if table.method_of(comparison, row).sweep != "tally":
            continue
        signs = [sum(m["statistics"][f"signs_{layer}"] for m in row["measures"]) for layer in ("filter", "interval", "exact")]
        total = sum(signs)
        rows.append([f"{row['scene']}: {row['method'].removesuffix(', tally')}", int(total), *(100 * s / total if total else None for s in signs)])
    return html_table(["", "signs", "floating-point filter, %", "intervals, %", "exact numbers, %"], rows) if rows else ""


def scene_table(comparison: dict, scene_index: int) -> str:
    rows = []
    for row in comparison["rows"]:
        if row["scene_index"] != scene_index:
            continue
        if row["state"] != "finished":
            rows.append([row["method"], row["state"], *[None] * 6])
            continue
        promises = table.promises_superset(row)
        guarantees = sorted({m["guarantee"] for m in row["measures"]})
        rows.append([row["method"], " / ".join(guarantees), table.query_ms(row), 1e3 * row["build_seconds"],
                     " ".join(str(m["size"]) for m in row["measures"]), table.median_of(row, table.excess),
                     sum(m["false_hidden"] for m in row["measures"]) if promises or guarantees == ["none"] else None,
                     table.peak_mib(row)])
    finished = [r for r in table.finished(comparison) if r["scene_index"] == scene_index]
    truth = "|P| / |E|" if table.has_truth(finished) else "|P| / |seen|"
    return html_table(["", "guarantee", "query, ms", "build, ms", "set of each cell", truth, "false hidden", "peak, MiB"], rows)


def scene_section(comparison: dict, scene_index: int) -> str:
    scene = comparison["layout"]["scenes"][scene_index]
    cells = ", ".join(f"{c['kind']} {c['size']:g} m" for c in scene["cells"])
    figure = plots.pareto(comparison, scene_index) if scene_index in table.compared_scenes(comparison) else None
    commands = "".join(f"<code>{html.escape(r['command'])}</code>" for r in comparison["rows"] if r["scene_index"] == scene_index)
    return (f"<h3>{html.escape(scene['name'])}</h3><p class=\"note\"><code>{html.escape(' '.join([scene['source'], *scene['arguments']]))}"
            f"</code>; cells: {html.escape(cells)}.</p>{_figure(figure)}{scene_table(comparison, scene_index)}"
            f"<details><summary>command of each row</summary>{commands}</details>")


def _figure(figure: object, note: str = "") -> str:
    caption = f"<figcaption class=\"note\">{html.escape(note)}</figcaption>" if note else ""
    return f"<figure>{svg(figure)}{caption}</figure>" if figure is not None else ""


def render(comparison: dict) -> str:
    """The page, with all figures inside."""
    sections = [
        ("Methods", summary(comparison)
         + '<p class="note">Over all cells of all scenes that a method applies to. |P| / |E|: set over exact set, where there is one.</p>'),
        ("Time against the size of the scene", _figure(plots.growth(comparison), "Median over the same cells at each size.")),
        ("Guided rays against time", _figure(plots.recall(comparison),
         "A line per cell, growing budgets of rays. Black: time of exact-2.5d over the same cells, median and range.")),
        ("Resolution", _figure(plots.option(comparison, "resolution", "resolution, pixels along a side"),
         "Medians over the scenes that have an exact set and in which all values ran.")),
        ("Components of ray space", _figure(plots.option(comparison, "components", "umbrae kept in a pixel"),
         "Medians over the scenes that have an exact set and in which all values ran.")),
        ("Size of the cell", _figure(plots.cell_size(comparison))),
        ("Arithmetic", arithmetic(comparison)),
        ("Layers of the filtered arithmetic", layers(comparison)),
        ("Memory", _figure(plots.memory(comparison),
         "Of the whole process. Dotted: what the measurement cannot fall below.")),
        ("Scenes", "<p class=\"note\">Of the points, those on the grey line are beaten by none in time and size of the set both.</p>"
         + "".join(scene_section(comparison, i) for i in range(len(comparison["layout"]["scenes"])))),
    ]
    notes = "".join(f'<p class="note">{html.escape(n)}.</p>' for n in comparison["layout"].get("notes", ()))
    body = "".join(f"<h2>{title}</h2>{content}" for title, content in sections if content)
    return ('<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"/><title>Comparison of all methods</title>'
            f"<style>{CSS}</style></head><body><h1>Comparison of all methods</h1>{verdict(comparison)}{machine(comparison)}{notes}{body}"
            "</body></html>\n")
