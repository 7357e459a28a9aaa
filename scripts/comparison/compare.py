"""Two runs of one layout side by side."""

from __future__ import annotations

from statistics import median


class LayoutsDiffer(Exception):
    """One line: the runs are of different layouts."""


def compare(a: dict, b: dict) -> tuple[str, int]:
    """Table of time ratios B / A, and the exit code: 1 if sets that call themselves exact differ or a run has faults.

    A row's ratio is the median over its cells. Throws LayoutsDiffer unless both ran the same.
    """
    if a["layout"]["identity"] != b["layout"]["identity"]:
        raise LayoutsDiffer(f"the runs are of different layouts ({a['layout']['mode']} {a['layout']['identity']}, "
                            f"{b['layout']['mode']} {b['layout']['identity']}): scenes, cells, methods, options or seeds differ")
    lines = [f"A  {describe(a['machine'])}", f"B  {describe(b['machine'])}", ""]
    ratios: dict[str, list[float]] = {}
    table, clashes, changes = [], [], 0
    for row_a, row_b in zip(a["rows"], b["rows"], strict=True):
        where = f"{row_a['scene']}: {row_a['method']}"
        if row_a["state"] != "finished" or row_b["state"] != "finished":
            if row_a["state"] != row_b["state"]:
                table.append((where, f"{row_a['state']} -> {row_b['state']}"))
            continue
        pairs = list(zip(row_a["measures"], row_b["measures"], strict=True))
        ratio = median(y["query_seconds"] / x["query_seconds"] for x, y in pairs)
        ratios.setdefault(row_a["method"], []).append(ratio)
        differ = [x["cell"] + 1 for x, y in pairs if x["digest"] != y["digest"]]
        clashes += [f"{where}, cell {x['cell'] + 1}" for x, y in pairs
                    if x["digest"] != y["digest"] and x["guarantee"] == y["guarantee"] == "exact"]
        changes += bool(differ)
        table.append((where, f"{ratio:8.3f}" + (f"  sets of cells {', '.join(map(str, differ))} differ" if differ else "")))
    width = max((len(where) for where, _ in table), default=0)
    lines += ["time of B over time of A, median over cells"] + [f"  {where:<{width}}  {text}" for where, text in table] + [""]
    lines += ["by method, median over scenes"] + [f"  {m:<{width}}  {median(r):8.3f}" for m, r in ratios.items()] + [""]
    lines.append(f"rows whose sets differ: {changes}")
    lines += [f"FAULT: exact sets differ: {c}" for c in clashes]
    lines += [f"FAULT in {name}: {f}" for name, run in (("A", a), ("B", b)) for f in run["faults"]]
    return "\n".join(lines), 1 if clashes or a["faults"] or b["faults"] else 0


def describe(machine: dict) -> str:
    return f"{machine['date']}, commit {machine['commit']}, {machine['compiler']}, {machine['processor']}"
