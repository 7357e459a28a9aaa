"""How far a run is, on standard error: one line that is rewritten on a terminal, one line per row elsewhere."""

from __future__ import annotations

import sys
import time
from typing import TextIO


class Progress:
    """Counts rows, of which `done` are there from an earlier run."""

    def __init__(self, total: int, done: int, stream: TextIO | None = None):
        self._total, self._done, self._at_start, self._stream = total, done, done, stream or sys.stderr
        self._start = time.monotonic()
        self._in_place = self._stream.isatty()

    def working_on(self, what: str) -> None:
        if self._in_place:
            self._stream.write(f"\r\x1b[K{self._counts()}  {what[:80]}")
            self._stream.flush()

    def finished(self, what: str) -> None:
        self._done += 1
        if not self._in_place:
            self._stream.write(f"{self._counts()}  {what}\n")
            self._stream.flush()

    def end(self) -> None:
        if self._in_place:
            self._stream.write(f"\r\x1b[K{self._counts()}\n")

    def _counts(self) -> str:
        elapsed = time.monotonic() - self._start
        here = self._done - self._at_start
        rest = f", about {_clock(elapsed / here * (self._total - self._done))} left" if here else ""
        return f"row {self._done}/{self._total}, {_clock(elapsed)}{rest}"


def _clock(seconds: float) -> str:
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"
