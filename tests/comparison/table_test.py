"""Rows as plots want them."""

from __future__ import annotations

import random
import unittest

from samples import METHODS, comparison

from comparison import table
from comparison.table import Point


class ParetoFront(unittest.TestCase):
    def test_is_what_no_other_point_beats(self) -> None:
        random_numbers = random.Random(1)
        for _ in range(300):
            points = [Point(METHODS[0], random_numbers.randrange(6), random_numbers.randrange(6)) for _ in range(random_numbers.randrange(9))]

            def beaten(p: Point) -> bool:
                return any(q.milliseconds <= p.milliseconds and q.excess <= p.excess
                           and (q.milliseconds, q.excess) != (p.milliseconds, p.excess) for q in points)

            expected = sorted({(p.milliseconds, p.excess) for p in points if not beaten(p)})
            self.assertEqual([(p.milliseconds, p.excess) for p in table.pareto_front(points)], expected)


class Points(unittest.TestCase):
    def test_are_of_sets_that_promise_to_lack_nothing_timed_without_tally(self) -> None:
        labels = [p.method.label for p in table.points_of(comparison(), 0)]
        self.assertEqual(labels, [m.label for m in METHODS if m.name != "sampling" and m.sweep != "tally"])


if __name__ == "__main__":
    unittest.main()
