"""Notebooks are kept without outputs, and the papers' numbers with their source."""

from __future__ import annotations

import json
import unittest
from pathlib import Path

NOTEBOOKS = Path(__file__).resolve().parents[2] / "notebooks"


class Clean(unittest.TestCase):
    def test_notebooks_have_no_outputs(self) -> None:
        files = sorted(NOTEBOOKS.glob("*.ipynb"))
        self.assertTrue(files)
        for file in files:
            cells = [c for c in json.loads(file.read_text())["cells"] if c["cell_type"] == "code"]
            self.assertTrue(all(c["outputs"] == [] and c["execution_count"] is None for c in cells), file.name)

    def test_every_notebook_is_run_by_the_tests(self) -> None:
        listed = (Path(__file__).parent / "CMakeLists.txt").read_text()
        for file in NOTEBOOKS.glob("*.ipynb"):
            self.assertIn(file.stem, listed)

    def test_numbers_of_papers_say_where_they_are_from_and_have_no_gaps_in_rows(self) -> None:
        files = sorted((NOTEBOOKS / "papers").glob("*.csv"))
        self.assertTrue(files)
        for file in files:
            source, head, *rows = file.read_text().splitlines()
            self.assertRegex(source, r"^# .*(19|20)\d\d, (table|tables|section|sections)", file.name)
            self.assertTrue(rows)
            for row in rows:
                self.assertEqual(row.count(","), head.count(","), f"{file.name}: {row}")


if __name__ == "__main__":
    unittest.main()
