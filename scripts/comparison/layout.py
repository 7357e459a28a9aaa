"""What a comparison runs: scenes with view cells, methods with options. Two runs can be compared iff their layouts are equal."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, dataclass, field

FORMAT = "visibility-comparison/1"


@dataclass(frozen=True)
class Cell:
    """A box, metres. `kind`: street, square, junction or roof; `size`: side of its base, m."""

    kind: str
    size: float
    low: tuple[float, float, float]
    high: tuple[float, float, float]

    @property
    def name(self) -> str:
        return f"{self.kind} {self.size:g} m"

    def json(self) -> dict:
        """As `visibility pvs --cells` reads it."""
        return {"min": list(self.low), "max": list(self.high)}


@dataclass(frozen=True)
class Scene:
    """`source`: gen:... or a file below the folder of real scenes, of which `digest` is the SHA-256 (of the bytes).

    `arguments`: options of the command line that belong to the scene, such as --grounded.
    `height_field`: exact-2.5d answers exactly, so there is a truth; otherwise only a lower bound.
    `family`: scenes of one family differ in size alone.
    """

    name: str
    source: str
    cells: tuple[Cell, ...]
    arguments: tuple[str, ...] = ()
    height_field: bool = False
    family: str = ""
    digest: str = ""


@dataclass(frozen=True)
class Method:
    """A method of the command line with the options that differ from its defaults.

    `sweep`: what is varied against the method's default: resolution, components, ...; empty for the default itself.
    `value`: what it is varied to, as text.
    """

    name: str
    arguments: tuple[str, ...] = ()
    sweep: str = ""
    value: str = ""

    @property
    def label(self) -> str:
        if not self.sweep:
            return self.name
        shape = {"resolution": "{}²", "components": "k = {}", "rays": "{} rays"}.get(self.sweep, "{}")
        value = f"{int(self.value):,}" if self.sweep == "rays" else self.value
        return f"{self.name}, {shape.format(value)}"


@dataclass(frozen=True)
class Layout:
    """`rows`: pairs of positions in `scenes` and `methods`, one process each. Everything that a result may depend on but the
    machine and the build is here. `repeats`: runs of a row at most, fewer once `repeat_seconds` are spent; `timeout`: s a run."""

    mode: str
    scenes: tuple[Scene, ...]
    methods: tuple[Method, ...]
    rows: tuple[tuple[int, int], ...]
    repeats: int = 3
    repeat_seconds: float = 2
    timeout: float = 60
    notes: tuple[str, ...] = field(default=(), compare=False)

    def __post_init__(self) -> None:
        names = [s.name for s in self.scenes]
        if len(set(names)) != len(names):
            raise ValueError("two scenes have the same name")
        labels = [m.label for m in self.methods]
        if len(set(labels)) != len(labels):
            raise ValueError("two methods have the same label")

    def identity(self) -> str:
        """Equal iff scenes, cells, methods, options and seeds are; notes and the order of keys do not count."""
        content = asdict(self)
        del content["notes"]
        return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()[:16]

    def json(self) -> dict:
        return {"format": FORMAT, "identity": self.identity(), **asdict(self)}
