"""The report: one HTML file that needs nothing else."""

from __future__ import annotations

import html

from . import plots, summaries, table
from .style import svg
from .summaries import text

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


def html_table(head: list[str], rows: list[list[object]]) -> str:
    def line(tag: str, cells: list[object]) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(text(c))}</{tag}>" for c in cells) + "</tr>"

    return "<table><thead>" + line("th", head) + "</thead><tbody>" + "".join(line("td", r) for r in rows) + "</tbody></table>"


def verdict(comparison: dict) -> str:
    faults = comparison["faults"]
    if faults:
        items = "".join(f"<li>{html.escape(f)}</li>" for f in faults)
        return f'<div class="fault"><b>{len(faults)} faults</b><ul>{items}</ul></div>'
    return f'<p class="sound">{summaries.verdict(comparison)}</p>'


def machine(comparison: dict) -> str:
    return html_table(["", ""], [list(r) for r in summaries.machine(comparison)]).replace("<td>", '<td style="text-align:left">')


def summary(of: summaries.Table) -> str:
    if not of.rows:
        return ""
    return html_table(of.head, of.rows) + (f'<p class="note">{html.escape(of.note)}</p>' if of.note else "")


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
        *((t.title, summary(t)) for t in (summaries.methods(comparison), summaries.scenes(comparison))),
        ("Time against the size of the scene", _figure(plots.growth(comparison), "Median over the same cells at each size.")),
        ("Guided rays against time", _figure(plots.recall(comparison),
         "A line per cell, growing budgets of rays. Black: time of exact-2.5d over the same cells, median and range.")),
        ("Resolution", _figure(plots.option(comparison, "resolution", "resolution, pixels along a side"),
         "Medians over the scenes that have an exact set and in which all values ran.")),
        ("Components of ray space", _figure(plots.option(comparison, "components", "umbrae kept in a pixel"),
         "Medians over the scenes that have an exact set and in which all values ran.")),
        ("Size of the cell", _figure(plots.cell_size(comparison))),
        *((t.title, summary(t)) for t in (summaries.options(comparison), summaries.arithmetic(comparison), summaries.layers(comparison))),
        ("Memory", _figure(plots.memory(comparison),
         "Of the whole process. Dotted: what the measurement cannot fall below.")),
        ("Each scene", "<p class=\"note\">Of the points, those on the grey line are beaten by none in time and size of the set both.</p>"
         + "".join(scene_section(comparison, i) for i in range(len(comparison["layout"]["scenes"])))),
    ]
    notes = "".join(f'<p class="note">{html.escape(n)}.</p>' for n in comparison["layout"].get("notes", ()))
    body = "".join(f"<h2>{title}</h2>{content}" for title, content in sections if content)
    return ('<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"/><title>Comparison of all methods</title>'
            f"<style>{CSS}</style></head><body><h1>Comparison of all methods</h1>{verdict(comparison)}{machine(comparison)}{notes}{body}"
            "</body></html>\n")
