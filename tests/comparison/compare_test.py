"""Two runs side by side."""

from __future__ import annotations

import unittest
from dataclasses import replace

from samples import EXACT, METHODS, NAMES, SUPERSET, comparison, layout, row, rows

from comparison import compare


class Compare(unittest.TestCase):
    def test_refuses_another_layout(self) -> None:
        other = replace(layout(), methods=(replace(METHODS[0], arguments=("--granularity", "part")), *METHODS[1:]))
        with self.assertRaises(compare.LayoutsDiffer) as raised:
            compare.compare(comparison(), comparison(plan=other))
        self.assertNotIn("\n", str(raised.exception))

    def test_a_run_and_itself(self) -> None:
        text, code = compare.compare(comparison(), comparison())
        self.assertEqual(code, 0)
        self.assertIn("rows whose sets differ: 0", text)

    def test_ratios_are_of_medians(self) -> None:
        text, code = compare.compare(comparison(), comparison([rows(0, 0.03), rows(1, 0.03)]))
        self.assertEqual(code, 0)
        self.assertEqual(text.count("3.000"), len(comparison()["rows"]) + len(METHODS))

    def test_exact_sets_that_differ_are_a_fault_and_conservative_ones_are_not(self) -> None:
        planted = rows(0)
        planted[0] = row(0, 0, SUPERSET | {NAMES[8]}, "conservative")
        text, code = compare.compare(comparison(), comparison([planted, rows(1)]))
        self.assertEqual(code, 0)
        self.assertIn("rows whose sets differ: 1", text)
        for j in (1, 7):  # both exact rows, so that the run itself is sound
            planted[j] = row(0, j, EXACT - {NAMES[3]}, "exact")
        text, code = compare.compare(comparison(), comparison([planted, rows(1)]))
        self.assertEqual(code, 1)
        self.assertIn("exact sets differ: town: exact-2.5d, cell 1", text)

    def test_a_run_with_a_fault_is_one(self) -> None:
        planted = rows(0)
        planted[0] = row(0, 0, set(), "conservative")
        self.assertEqual(compare.compare(comparison([planted, rows(1)]), comparison())[1], 1)


if __name__ == "__main__":
    unittest.main()
