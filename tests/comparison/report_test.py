"""The report: one file, well formed, faults on top."""

from __future__ import annotations

import re
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

from samples import comparison, row, rows

from comparison import plans, report, style

SOUND = report.render(comparison())


class Report(unittest.TestCase):
    def test_every_method_has_its_colour_and_marker(self) -> None:
        names = {m.name for make in plans.MODES.values() for m in make(Path("/nonexistent")).methods}
        self.assertEqual(names, set(style.COLOURS))
        self.assertEqual(names, set(style.MARKERS))

    def test_is_well_formed_and_has_all_figures(self) -> None:
        page = xml.fromstring(SOUND.removeprefix("<!DOCTYPE html>"))
        # two scenes; growth, rays, resolution, size of the cell, memory
        self.assertEqual(len(page.findall(".//{http://www.w3.org/2000/svg}svg")), 7)
        self.assertIn("visibility pvs <scene> & more", "".join(page.itertext()))  # text is escaped

    def test_needs_nothing_from_elsewhere(self) -> None:
        for reference in re.findall(r'(?:src|href)\s*=\s*"([^"]*)"', SOUND) + re.findall(r"url\(([^)]*)\)", SOUND):
            self.assertTrue(reference.startswith("#"), reference)
        for tag in ("<script", "<link", "<img", "@import"):
            self.assertNotIn(tag, SOUND)

    def test_identifiers_are_unique_and_references_resolve(self) -> None:
        identifiers = re.findall(r'\bid="([^"]*)"', SOUND)
        self.assertEqual(len(identifiers), len(set(identifiers)))
        targets = re.findall(r'href="#([^"]*)"', SOUND) + re.findall(r"url\(#([^)]*)\)", SOUND)
        self.assertTrue(targets)
        self.assertLessEqual(set(targets), set(identifiers))

    def test_faults_come_first(self) -> None:
        planted = rows(0)
        planted[2] = row(0, 2, set(), "conservative")
        page = report.render(comparison([planted, rows(1)]))
        self.assertLess(page.index('class="fault"'), page.index("<table"))
        self.assertNotIn('class="sound"', page)
        self.assertNotIn('class="fault"', SOUND)

    def test_survives_methods_that_did_not_finish(self) -> None:
        unfinished = [{k: r[k] for k in ("scene", "method", "command", "scene_index", "method_index")}
                      | {"state": "timeout", "peak_kib": 1} for r in rows(0)]
        self.assertIn("timeout", report.render(comparison([unfinished, rows(1)])))
        self.assertIn("timeout", report.render(comparison([unfinished, [dict(r, scene_index=1) for r in unfinished]])))


if __name__ == "__main__":
    unittest.main()
