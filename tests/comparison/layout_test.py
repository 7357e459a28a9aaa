"""Identity of layouts, and the layouts of the three modes."""

from __future__ import annotations

import tempfile
import unittest
from dataclasses import replace
from pathlib import Path

from samples import METHODS, layout

from comparison import plans
from comparison.layout import Method

NOWHERE = Path("/nonexistent")


class Identity(unittest.TestCase):
    def test_notes_do_not_count(self) -> None:
        self.assertEqual(layout().identity(), replace(layout(), notes=("a city is missing",)).identity())

    def test_everything_that_a_result_depends_on_counts(self) -> None:
        scene = layout().scenes[0]
        moved = replace(scene, cells=(plans.cell("street", 1, 0, 0, 4), *scene.cells[1:]))
        others = [replace(layout(), scenes=(changed, layout().scenes[1])) for changed in
                  (moved, replace(scene, source="gen:city,n=16,seed=2"), replace(scene, arguments=("--grounded",)), replace(scene, digest="x"))]
        others.append(replace(layout(), methods=(Method("strong-occlusion", ("--seed", "2")), *METHODS[1:])))
        others.append(replace(layout(), rows=layout().rows[1:]))
        identities = {layout().identity(), *(o.identity() for o in others)}
        self.assertEqual(len(identities), 1 + len(others))

    def test_names_are_unique(self) -> None:
        with self.assertRaises(ValueError):
            replace(layout(), methods=(*METHODS, METHODS[0]))


class Modes(unittest.TestCase):
    def test_every_method_runs_in_every_mode(self) -> None:
        for mode, make in plans.MODES.items():
            plan = make(NOWHERE)
            names = {plan.methods[j].name for _, j in plan.rows}
            with self.subTest(mode=mode):
                self.assertEqual(names, set(m.name for m in METHODS))
                self.assertEqual(len(set(plan.rows)), len(plan.rows))
                self.assertTrue(all(s.height_field for i, s in enumerate(plan.scenes)
                                    if any(plan.methods[j].name == "exact-2.5d" for k, j in plan.rows if k == i)))

    def test_a_city_that_is_missing_is_noted_and_one_that_changed_changes_the_layout(self) -> None:
        without = plans.quick(NOWHERE)
        self.assertEqual(len(without.notes), len(plans.REAL[:2]))
        identities = {without.identity()}
        with tempfile.TemporaryDirectory() as name:
            file = Path(name) / plans.REAL[0].source
            file.parent.mkdir(parents=True)
            for content in ("one", "two"):
                file.write_text(content)
                identities.add(plans.quick(Path(name)).identity())
        self.assertEqual(len(identities), 3)


if __name__ == "__main__":
    unittest.main()
