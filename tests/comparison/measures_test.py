"""Measures against brute force, and faults that are planted."""

from __future__ import annotations

import random
import unittest

from samples import EXACT, NAMES, comparison, row, rows

from comparison import measures


def brute_force(visible: list[str], truth: list[str], seen: list[str], universe: list[str]) -> dict:
    """By looking at every object of the scene on its own."""
    common = hidden = extra = 0
    for name in universe:
        common += name in visible and name in truth
        hidden += name not in visible and (name in truth or name in seen)
        extra += name in visible and name not in truth
    return {"common": common, "false_hidden": hidden, "false_visible": extra}


class Measures(unittest.TestCase):
    def test_agree_with_brute_force_on_random_sets(self) -> None:
        random_numbers = random.Random(1)
        universe = [f"o{i}" for i in range(12)]
        faulty = 0
        for trial in range(2000):
            visible, truth, seen = (random_numbers.sample(universe, random_numbers.randrange(13)) for _ in range(3))
            kind = random_numbers.choice([measures.EXACT, measures.LOWER_BOUND])
            guarantee = random_numbers.choice(["exact", "conservative", "aggressive", "none"])
            expected = brute_force(visible, truth, seen, universe)
            m = measures.measure(guarantee, frozenset(visible), measures.Truth(kind, frozenset(truth)), frozenset(seen))
            with self.subTest(trial=trial):
                self.assertEqual(m["size"], len(visible))
                self.assertEqual(m["false_hidden"], expected["false_hidden"])
                self.assertEqual(m["false_visible"], expected["false_visible"] if kind == measures.EXACT else None)
                self.assertEqual(m["recall"], expected["common"] / len(truth) if truth else None)
                known, other = ("overestimation", "over_lower_bound") if kind == measures.EXACT else ("over_lower_bound", "overestimation")
                self.assertEqual(m[known], len(visible) / len(truth) if truth else None)
                self.assertIsNone(m[other])  # the two are never mixed up
                lacks = expected["false_hidden"] > 0 and guarantee in ("exact", "conservative")
                exceeds = kind == measures.EXACT and expected["false_visible"] > 0 and guarantee in ("exact", "aggressive")
                self.assertEqual(m["fault"], lacks or exceeds)
                faulty += m["fault"]
        self.assertGreater(faulty, 100)

    def test_the_truth_is_an_exact_set_or_all_that_was_seen(self) -> None:
        a, b, c = frozenset("a"), frozenset("b"), frozenset("abc")
        self.assertEqual(measures.truth_of([("conservative", c), ("aggressive", a), ("aggressive", b)]),
                         measures.Truth(measures.LOWER_BOUND, a | b))
        self.assertEqual(measures.truth_of([("aggressive", a), ("exact", b)]), measures.Truth(measures.EXACT, b))
        self.assertEqual(measures.truth_of([("none", c)]), measures.Truth(measures.LOWER_BOUND, frozenset()))

    def test_equal_sets_have_equal_digests_whatever_the_order(self) -> None:
        self.assertEqual(measures.digest(frozenset(["a", "b"])), measures.digest(frozenset(["b", "a"])))
        self.assertNotEqual(measures.digest(frozenset(["ab"])), measures.digest(frozenset(["a", "b"])))


class Faults(unittest.TestCase):
    def test_sound_rows_have_none(self) -> None:
        self.assertEqual(comparison()["faults"], [])

    def test_a_conservative_set_that_lacks_one_visible_object(self) -> None:
        planted = rows(0)
        planted[2] = row(0, 2, set(NAMES) - {NAMES[3]}, "conservative")
        faults = comparison([planted, rows(1)])["faults"]
        self.assertEqual(len(faults), 2)  # in both cells
        self.assertIn(NAMES[3], faults[0])
        self.assertIn("ray-space", faults[0])

    def test_an_exact_set_that_lacks_an_object_that_was_seen(self) -> None:
        planted = rows(0)
        planted[6] = row(0, 6, {NAMES[7]}, "aggressive")
        culprits = " ".join(comparison([planted, rows(1)])["faults"])
        for method in ("exact-2.5d", "strong-occlusion", "sampling"):
            self.assertIn(method, culprits)

    def test_two_exact_sets_that_differ(self) -> None:
        planted = rows(0)
        planted[7] = row(0, 7, EXACT | {NAMES[9]}, "exact")
        self.assertTrue(any("exact-2.5d, tally" in f and NAMES[9] in f for f in comparison([planted, rows(1)])["faults"]))

    def test_no_promise_no_fault(self) -> None:
        planted = rows(0)
        planted[2] = row(0, 2, set(), "none")
        result = comparison([planted, rows(1)])
        self.assertEqual(result["faults"], [])
        self.assertEqual(result["rows"][2]["measures"][0]["false_hidden"], len(EXACT))  # but it is counted

    def test_a_row_that_failed_is_one_and_one_that_ran_out_of_time_is_not(self) -> None:
        planted = rows(0)
        planted[2] = {k: planted[2][k] for k in ("scene", "method", "command", "scene_index", "method_index")} | {
            "state": "failed", "message": "no such method", "peak_kib": 1}
        planted[3] = planted[2] | {"state": "timeout", "method": "slow"}
        faults = comparison([planted, rows(1)])["faults"]
        self.assertEqual(len(faults), 1)
        self.assertIn("no such method", faults[0])


if __name__ == "__main__":
    unittest.main()
