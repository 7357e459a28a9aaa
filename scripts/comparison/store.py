"""The folder of a run. Files appear whole or not at all, so an interrupted run can be resumed."""

from __future__ import annotations

import gzip
import json
import os
from pathlib import Path


class StoreError(Exception):
    """One line: what is wrong with the folder and what to do."""


def write_atomically(path: Path, content: str | bytes) -> None:
    part = path.with_name(path.name + ".part")
    part.write_bytes(content.encode() if isinstance(content, str) else content)
    os.replace(part, path)


class Store:
    """DIR/run.json: layout and machine; DIR/rows/SCENE-METHOD.json.gz: finished rows with their sets;
    DIR/comparison.json: measures; DIR/comparison.html: the report; DIR/comparison.md: its summary."""

    def __init__(self, folder: Path):
        self.folder = folder

    def open(self, layout: dict, machine: dict) -> None:
        """Begins a run or continues it. Throws StoreError if the folder holds another layout or the rows of another build."""
        (self.folder / "rows").mkdir(parents=True, exist_ok=True)
        if (self.folder / "run.json").exists():
            old = self.run()
            if old["layout"]["identity"] != layout["identity"]:
                raise StoreError(f"{self.folder}: holds a run of another layout; give another folder with -o")
            if old["machine"]["program_digest"] != machine["program_digest"]:
                raise StoreError(f"{self.folder}: holds rows of another build; give another folder with -o")
        else:
            write_atomically(self.folder / "run.json", json.dumps({"layout": layout, "machine": machine}, indent=1) + "\n")

    def run(self) -> dict:
        return self._read(self.folder / "run.json")

    def _row_file(self, scene: int, method: int) -> Path:
        return self.folder / "rows" / f"{scene}-{method}.json.gz"

    def has_row(self, scene: int, method: int) -> bool:
        return self._row_file(scene, method).exists()

    def row(self, scene: int, method: int) -> dict:
        return self._read(self._row_file(scene, method))

    def add_row(self, scene: int, method: int, row: dict) -> None:
        write_atomically(self._row_file(scene, method), gzip.compress(json.dumps(row).encode(), mtime=0))

    def comparison(self) -> dict:
        return self._read(self.folder / "comparison.json")

    def write_comparison(self, comparison: dict) -> None:
        write_atomically(self.folder / "comparison.json", json.dumps(comparison, indent=1) + "\n")

    def write_report(self, html: str, markdown: str) -> list[Path]:
        paths = [self.folder / "comparison.html", self.folder / "comparison.md"]
        for path, content in zip(paths, (html, markdown)):
            write_atomically(path, content)
        return paths

    @staticmethod
    def _read(path: Path) -> dict:
        try:
            data = path.read_bytes()
            return json.loads(gzip.decompress(data) if path.suffix == ".gz" else data)
        except FileNotFoundError:
            raise StoreError(f"{path}: not there; is this the folder of a finished `bench run`?") from None
        except (OSError, EOFError, ValueError) as error:
            raise StoreError(f"{path}: cannot be read ({error}); delete it and run again") from None
