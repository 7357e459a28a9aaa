"""How plots look: colours that colour-blind people tell apart, one per method everywhere, and a marker each."""

from __future__ import annotations

import io
import re

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

# Okabe and Ito, https://jfly.uni-koeln.de/color/
COLOURS = {"strong-occlusion": "#E69F00", "exact-2.5d": "#000000", "extended-projection": "#56B4E9", "occlusion-sweep": "#0072B2",
           "ray-space": "#D55E00", "sampling": "#009E73"}
MARKERS = {"strong-occlusion": "s", "exact-2.5d": "*", "extended-projection": "^", "occlusion-sweep": "v", "ray-space": "D",
           "sampling": "o"}

plt.rcParams.update({
    "svg.fonttype": "path",  # a report that looks the same everywhere
    "svg.hashsalt": "visibility",  # and whose bytes depend on the data alone
    "font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.color": "#dddddd",
    "grid.linewidth": 0.6, "legend.frameon": False, "legend.fontsize": 8, "figure.constrained_layout.use": True,
})


def svg(figure: Figure) -> str:
    """The figure as an element for HTML, and closed."""
    out = io.StringIO()
    figure.savefig(out, format="svg", bbox_inches="tight", metadata={"Date": None, "Creator": None})
    plt.close(figure)
    text = out.getvalue()
    text = re.sub(r"^.*?(?=<svg)|<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    return unique_ids(text)


_count = 0


def unique_ids(text: str) -> str:
    """Identifiers that no other figure of the page has: matplotlib numbers them anew in each."""
    global _count
    _count += 1
    text = re.sub(r'\bid="', f'id="p{_count}-', text)
    return re.sub(r"(xlink:href=\"#|url\(#)", rf"\g<1>p{_count}-", text)
