"""From sets to figures. Pure functions of sets of object names, so that tests can hold them against brute force."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

SUPERSETS = ("exact", "conservative")  # promise that nothing visible is missing
SUBSETS = ("exact", "aggressive")  # promise that nothing hidden is listed
EXACT, LOWER_BOUND = "exact", "lower bound"


@dataclass(frozen=True)
class Truth:
    """Of one cell. `visible`: the exact set, or of a lower bound all objects to which a sight line was confirmed."""

    kind: str
    visible: frozenset[str]


def truth_of(sets: list[tuple[str, frozenset[str]]]) -> Truth:
    """`sets`: guarantee and set of every method, of one cell. The exact set if one claims to be, else all that is confirmed."""
    for guarantee, visible in sets:
        if guarantee == "exact":
            return Truth(EXACT, visible)
    return Truth(LOWER_BOUND, confirmed(sets))


def confirmed(sets: list[tuple[str, frozenset[str]]]) -> frozenset[str]:
    """All objects that some aggressive method saw."""
    return frozenset().union(*(visible for guarantee, visible in sets if guarantee == "aggressive"))


def measure(guarantee: str, visible: frozenset[str], truth: Truth, seen: frozenset[str]) -> dict:
    """`seen`: objects to which some method confirmed a sight line; they are visible whatever the truth says.

    `overestimation` is |P| / |E| for the exact set E; against a lower bound the same quotient is called `over_lower_bound`, for
    it is larger than the overestimation. `recall`: share of the truth that the set has. `false_hidden`: visible objects that a set
    lacks; a `fault` in what promises to lack none. `false_visible`: members that the exact set has not; a fault in what
    promises to have none. Quotients of an empty truth are None.
    """
    visible_for_sure = truth.visible | seen
    missing = sorted(visible_for_sure - visible)
    extra = sorted(visible - truth.visible) if truth.kind == EXACT else []
    quotient = len(visible) / len(truth.visible) if truth.visible else None
    return {
        "size": len(visible),
        "truth": truth.kind,
        "truth_size": len(truth.visible),
        "overestimation": quotient if truth.kind == EXACT else None,
        "over_lower_bound": quotient if truth.kind == LOWER_BOUND else None,
        "recall": len(visible & truth.visible) / len(truth.visible) if truth.visible else None,
        "false_hidden": len(missing),
        "false_visible": len(extra) if truth.kind == EXACT else None,
        "missing": missing[:10],
        "extra": extra[:10],
        "fault": (bool(missing) and guarantee in SUPERSETS) or (bool(extra) and guarantee in SUBSETS),
        "digest": digest(visible),
    }


def digest(visible: frozenset[str]) -> str:
    """Equal sets, equal digests."""
    return hashlib.sha256("\n".join(sorted(visible)).encode()).hexdigest()[:16]


def measure_scene(rows: list[dict]) -> list[dict]:
    """The finished and unfinished rows of one scene (runner.run_row), with `measures` in place of the sets."""
    finished = [r for r in rows if r["state"] == "finished"]
    measured = {id(r): [] for r in finished}
    for i in range(len(finished[0]["cells"]) if finished else 0):
        sets = [(r["cells"][i]["guarantee"], frozenset(r["cells"][i]["visible"])) for r in finished]
        truth, seen = truth_of(sets), confirmed(sets)
        for row, (guarantee, visible) in zip(finished, sets):
            cell = row["cells"][i]
            measured[id(row)].append({"cell": i, "guarantee": guarantee, "query_seconds": cell["query_seconds"],
                                      "wall_seconds": cell["wall_seconds"],
                                      **measure(guarantee, visible, truth, seen), "statistics": cell["statistics"]})
    return [{k: v for k, v in r.items() if k != "cells"} | ({"measures": measured[id(r)]} if id(r) in measured else {})
            for r in rows]


def faults(rows: list[dict]) -> list[str]:
    """One line for every broken promise and every row that failed. Running out of time is neither."""
    out = []
    for row in rows:
        if row["state"] == "failed":
            out.append(f"{row['scene']}: {row['method']} failed: {row.get('message', '')}")
        for m in row.get("measures", []):
            if m["fault"]:
                what = f"lacks {m['false_hidden']} visible objects ({', '.join(m['missing'])})" if m["missing"] else \
                    f"has {m['false_visible']} objects that the exact set lacks ({', '.join(m['extra'])})"
                out.append(f"{row['scene']}, cell {m['cell'] + 1}: {row['method']} calls itself {m['guarantee']} and {what}")
    return out
