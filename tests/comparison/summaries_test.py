"""The tables over all scenes, on a comparison whose numbers are known."""

from __future__ import annotations

import unittest

from samples import comparison, row, rows

from comparison import summaries

KNOWN = comparison()


def line(table: summaries.Table, label: str) -> dict[str, object]:
    return next(dict(zip(table.head, r)) for r in table.rows if r[0] == label)


class Summaries(unittest.TestCase):
    def test_methods_have_medians_over_all_cells(self) -> None:
        ray_space = line(summaries.methods(KNOWN), "ray-space")
        self.assertEqual(ray_space["cells"], 4)
        self.assertAlmostEqual(ray_space["query, ms (median)"], 30)
        self.assertEqual((ray_space["|P| / |E| (median)"], ray_space["false hidden"]), (1.5, 0))
        rays = line(summaries.methods(KNOWN), "sampling, 1,000 rays")
        self.assertEqual((rays["|P| / |E| (median)"], rays["least recall, %"]), (None, 75))

    def test_scenes_have_time_and_set_of_each_method(self) -> None:
        town = line(summaries.scenes(KNOWN), "town")
        self.assertEqual((town["objects"], town["against"], town["ray-space"], town["exact-2.5d"]), (10, "E", "30\u00a0·\u00a01.5", "20\u00a0·\u00a01"))

    def test_options_are_held_against_the_method_as_it_comes(self) -> None:
        table = summaries.options(KNOWN)
        self.assertEqual([r[0] for r in table.rows], ["ray-space, 64²"])  # rays have no default, a tally is no option
        option = line(table, "ray-space, 64²")
        self.assertEqual(option["scenes"], 2)
        self.assertAlmostEqual(option["time / default"], 2)
        self.assertEqual(option["set / default (median)"], 1)

    def test_text_has_all_tables_whole(self) -> None:
        text = summaries.markdown(KNOWN)
        for of in (summaries.methods, summaries.scenes, summaries.options, summaries.layers):
            self.assertIn(f"## {of(KNOWN).title}", text)
        columns = 0
        for l in text.splitlines():
            bars = l.count("|") - l.count("\\|") if l.startswith("|") else 0
            self.assertTrue(columns == 0 or bars in (0, columns), l)
            columns = bars

    def test_text_says_faults_first(self) -> None:
        planted = rows(0)
        planted[2] = row(0, 2, set(), "conservative")
        text = summaries.markdown(comparison([planted, rows(1)]))
        self.assertLess(text.index("FAULT"), text.index("## Methods"))
        self.assertNotIn("No object falsely hidden", text)

    def test_scenes_without_finished_rows_are_left_out(self) -> None:
        unfinished = [{k: r[k] for k in ("scene", "method", "command", "scene_index", "method_index")}
                      | {"state": "timeout", "peak_kib": 1} for r in rows(0)]
        self.assertEqual([r[0] for r in summaries.scenes(comparison([unfinished, rows(1)])).rows], ["large town"])


if __name__ == "__main__":
    unittest.main()
