"""The figures of the report. Each takes a comparison and gives a matplotlib figure, or None where there is nothing to draw."""

from __future__ import annotations

from statistics import median

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullLocator

from . import table
from .style import COLOURS, MARKERS, plt


def _panels(count: int) -> tuple[Figure, np.ndarray]:
    """A figure of so many panels, three in a line at most, and the panels as lines; those left over are blank."""
    columns = min(3, count)
    lines = -(-count // columns)
    figure, panels = plt.subplots(lines, columns, figsize=(3.1 * columns, 2.7 * lines), squeeze=False)
    for axes in panels.flat[count:]:
        axes.axis("off")
    return figure, panels


def plain_log(axis) -> None:
    """Logarithmic ticks as plain numbers: the fewer, the larger the range."""
    low, high = axis.get_view_interval()
    if high / low < 5:
        axis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 2.5, 5, 10]))
    else:
        steps = (1, 1.5, 2, 3, 5, 7) if high / low < 20 else (1, 2, 5) if high / low < 300 else (1,)
        axis.set_major_locator(LogLocator(subs=steps))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda v, _: f"{v:g}" if v < 1e4 else f"{v:,.0f}"))


def excess_label(rows: list[dict]) -> str:
    return "overestimation |P| / |E|" if table.has_truth(rows) else "set over lower bound |P| / |seen|"


def pareto(comparison: dict, scene_index: int) -> Figure | None:
    """Time against overestimation, a point per configuration, and those that none beats."""
    points = table.points_of(comparison, scene_index)
    if not points:
        return None
    rows = [r for r in table.finished(comparison) if r["scene_index"] == scene_index]
    scene = comparison["layout"]["scenes"][scene_index]
    figure, axes = plt.subplots(figsize=(7.2, 4.0))
    axes.set_xscale("log")
    axes.set_yscale("log")
    for name, colour in COLOURS.items():
        mine = [p for p in points if p.method.name == name]
        if mine:
            axes.scatter([p.milliseconds for p in mine], [p.excess for p in mine], c=colour,
                         s=[26 if p.method.sweep else 70 for p in mine], marker=MARKERS[name], label=name, zorder=3, linewidths=0)
    front = table.pareto_front(points)
    axes.step([p.milliseconds for p in front], [p.excess for p in front], where="post", color="#999999", lw=1, zorder=2)
    right = axes.get_xlim()[1]
    for k, p in enumerate(front):
        text = p.method.label.removeprefix(p.method.name + ", ") if p.method.sweep else "default"
        at_edge = p.milliseconds > right / 3
        axes.annotate(text, (p.milliseconds, p.excess), xytext=(-5 if at_edge else 5, 6 if k % 2 == 0 else -11),
                      textcoords="offset points", fontsize=7, color=COLOURS[p.method.name], ha="right" if at_edge else "left")
    axes.set_xlabel("query, ms (median over cells)")
    axes.set_ylabel(excess_label(rows))
    axes.set_title(f"{scene['name']}: {rows[0]['objects']:,} objects", loc="left")
    axes.margins(0.08)
    plain_log(axes.xaxis)
    plain_log(axes.yaxis)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), title="large: default options", title_fontsize=7)
    return figure


def growth(comparison: dict) -> Figure | None:
    """Time against the number of objects, a panel for each family of scenes; methods as they come."""
    scenes = comparison["layout"]["scenes"]
    families = [f for f in dict.fromkeys(s["family"] for s in scenes) if f and sum(s["family"] == f for s in scenes) > 1]
    if not families:
        return None
    figure, panels = plt.subplots(1, len(families), figsize=(4.0 * len(families), 3.4), squeeze=False, sharey=True)
    for axes, family in zip(panels[0], families):
        for name, colour in COLOURS.items():
            at = []
            for row in table.finished(comparison):
                method = table.method_of(comparison, row)
                # Cells that all scenes of the family have: the first ones.
                shared = min(len(s["cells"]) for s in scenes if s["family"] == family)
                if scenes[row["scene_index"]]["family"] == family and method.name == name and not method.sweep:
                    at.append((row["objects"], 1e3 * median(m["query_seconds"] for m in row["measures"][:shared])))
            if at:
                axes.plot(*zip(*sorted(at)), color=colour, marker=MARKERS[name], ms=5, lw=1.3, label=name)
        axes.set_xscale("log")
        axes.set_yscale("log")
        plain_log(axes.xaxis)
        plain_log(axes.yaxis)
        axes.set_title(family, loc="left")
        axes.set_xlabel("objects")
    panels[0][0].set_ylabel("query, ms (median over cells)")
    panels[0][-1].legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def recall(comparison: dict) -> Figure | None:
    """Share of the exact set that guided rays find, against their time; where the exact method was done is marked."""
    scenes = [i for i in table.compared_scenes(comparison) if comparison["layout"]["scenes"][i]["height_field"]
              and any(_is_sampling(comparison, r, i) for r in table.finished(comparison))]
    if not scenes:
        return None
    figure, panels = _panels(len(scenes))
    for axes, i in zip(panels.flat, scenes):
        rows = [r for r in table.finished(comparison) if _is_sampling(comparison, r, i)]
        for cell in range(len(rows[0]["measures"])):
            at = [(1e3 * r["measures"][cell]["query_seconds"], 100 * r["measures"][cell]["recall"]) for r in rows
                  if r["measures"][cell]["truth"] == "exact"]
            if at:
                axes.plot(*zip(*at), color=COLOURS["sampling"], marker="o", ms=3.5, lw=1, alpha=0.8)
        exact = [r for r in table.finished(comparison) if r["scene_index"] == i and r["method"] == "exact-2.5d"]
        for row in exact:
            times = [1e3 * m["query_seconds"] for m in row["measures"]]
            axes.axvspan(min(times), max(times), color="#000000", alpha=0.12, lw=0)
            axes.axvline(median(times), color="#000000", lw=1.2)
            axes.text(median(times), 3, " exact-2.5d: 100 %", fontsize=7, rotation=90, va="bottom", ha="right")
        axes.set_xscale("log")
        axes.set_ylim(0, 103)
        plain_log(axes.xaxis)
        axes.set_title(comparison["layout"]["scenes"][i]["name"], loc="left", fontsize=9)
    for axes in panels[-1]:
        axes.set_xlabel("query, ms")
    for axes in panels[:, 0]:
        axes.set_ylabel("recall, %")
    return figure


def _is_sampling(comparison: dict, row: dict, scene_index: int) -> bool:
    return row["scene_index"] == scene_index and table.method_of(comparison, row).name == "sampling"


def option(comparison: dict, key: str, label: str) -> Figure | None:
    """Overestimation and time against an option (resolution, components), a line per method: medians over the scenes that have a
    truth (another measure must not be mixed in) and in which all values of the option finished (each point is of the same scenes).
    """
    values: dict[str, dict[int, dict[int, tuple[float, float]]]] = {}  # method, scene, value of the option
    for row in table.finished(comparison):
        method = table.method_of(comparison, row)
        over = table.median_of(row, lambda m: m["overestimation"])
        varied = row["scene_index"] in table.compared_scenes(comparison) and method.sweep in ("", key)
        if varied and key in row["options"] and over is not None:
            of_scene = values.setdefault(method.name, {}).setdefault(row["scene_index"], {})
            of_scene[int(row["options"][key])] = (over, table.query_ms(row))
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.2, 3.2))
    ticks: set[int] = set()
    for name, scenes in values.items():
        at = sorted(set().union(*scenes.values()))
        complete = [s for s in scenes.values() if len(s) == len(at)]
        if len(at) < 2 or not complete:
            continue
        ticks |= set(at)
        for axes, k in ((left, 0), (right, 1)):
            axes.plot(at, [median(s[x][k] for s in complete) for x in at], color=COLOURS[name], marker=MARKERS[name], ms=5, lw=1.3,
                      label=name)
    if not ticks:
        plt.close(figure)
        return None
    for axes, text in ((left, "overestimation |P| / |E|"), (right, "query, ms")):
        axes.set_xscale("log", base=2)
        axes.set_yscale("log")
        axes.set_xticks(sorted(ticks))
        axes.xaxis.set_major_formatter(FuncFormatter(lambda v, _: f"{v:g}"))
        axes.xaxis.set_minor_locator(NullLocator())
        plain_log(axes.yaxis)
        axes.set_xlabel(label)
        axes.set_ylabel(text)
    right.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def cell_size(comparison: dict) -> Figure | None:
    """Overestimation against the side of the cell, cells of one kind in one scene joined; methods as they come."""
    groups: dict[tuple[int, str], list[tuple[str, float, float]]] = {}
    for row in table.finished(comparison):
        method = table.method_of(comparison, row)
        if method.sweep or method.name == "exact-2.5d" or row["scene_index"] not in table.compared_scenes(comparison):
            continue
        for m in row["measures"]:
            cell = table.cell_of(comparison, row, m)
            if m["overestimation"] is not None:
                groups.setdefault((row["scene_index"], cell["kind"]), []).append((method.name, cell["size"], m["overestimation"]))
    groups = {k: v for k, v in groups.items() if len({size for _, size, _ in v}) > 1}
    if not groups:
        return None
    figure, panels = _panels(len(groups))
    for axes, ((scene, kind), points) in zip(panels.flat, groups.items()):
        for name in COLOURS:
            at = sorted((size, value) for n, size, value in points if n == name)
            if at:
                axes.plot(*zip(*at), color=COLOURS[name], marker=MARKERS[name], ms=4, lw=1.1, label=name)
        axes.set_xscale("log")
        axes.set_yscale("log")
        plain_log(axes.xaxis)
        plain_log(axes.yaxis)
        axes.set_title(f"{comparison['layout']['scenes'][scene]['name']}, {kind}", loc="left", fontsize=9)
    for axes in panels[-1]:
        axes.set_xlabel("side of the cell, m")
    for axes in panels[:, 0]:
        axes.set_ylabel("|P| / |E|")
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def memory(comparison: dict) -> Figure | None:
    """Peak memory against the number of objects; methods as they come, and sampling."""
    if not table.finished(comparison):
        return None
    figure, axes = plt.subplots(figsize=(6.4, 3.2))
    for name in COLOURS:
        at = [(r["objects"], r["peak_kib"] / 1024) for r in table.finished(comparison)
              if table.method_of(comparison, r).label == name or name == "sampling" == table.method_of(comparison, r).name]
        if at:
            axes.scatter(*zip(*at), color=COLOURS[name], marker=MARKERS[name], s=22, label=name, linewidths=0)
    axes.axhline(max((r["floor_kib"] for r in table.finished(comparison)), default=0) / 1024, color="#999999", lw=0.8, ls=":")
    axes.set_xscale("log")
    axes.set_yscale("log")
    plain_log(axes.xaxis)
    plain_log(axes.yaxis)
    axes.set_xlabel("objects")
    axes.set_ylabel("peak memory, MiB")
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


