"""The commands of scripts/bench on a small layout, with programs that stand for `visibility`."""

from __future__ import annotations

import contextlib
import io
import json
import stat
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import samples

from comparison import command_line, plans, report
from comparison.layout import Method
from comparison.runner import run_once, run_row

# Answers every cell with the same set. `liar`: a method whose set lacks an object; `stop`: calls after which the program fails.
STAND_IN = """#!{python}
import json, sys
words = sys.argv[1:]
after = lambda word: words[words.index(word) + 1]
calls = {folder!r} + "/calls"
open(calls, "a").write(after("--method") + "\\n")
method = after("--method")
guarantee = {{"exact-2.5d": "exact", "sampling": "aggressive"}}.get(method, "conservative")
if "double" in words: guarantee = "none"
visible = ["a"] if method == {liar!r} else ["a", "b"]
stop = {stop}
if stop and len(open(calls).readlines()) > stop: sys.exit("stopped")
statistics = dict(signs_filter=1, signs_interval=0, signs_exact=0)
result = dict(guarantee=guarantee, visible=visible, statistics=statistics, scene=dict(objects=3, primitives=3),
              method=dict(arithmetic="filtered", options={{}}), seconds=dict(read=.1, build=.1, query=.1, processor=.1))
cells = json.load(open(after("--cells")))
json.dump([result] * len(cells), open(after("-o"), "w"))
"""


class Run(unittest.TestCase):
    def setUp(self) -> None:
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = Path(self._folder.name)

    def stand_in(self, liar: str = "", stop: int = 0) -> Path:
        program = self.folder / "visibility"
        program.write_text(STAND_IN.format(python=sys.executable + " -SEs", folder=str(self.folder), liar=liar, stop=stop))
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        return program

    def calls(self) -> int:
        file = self.folder / "calls"
        return len(file.read_text().splitlines()) if file.exists() else 0

    def bench(self, *words: object) -> tuple[int, str]:
        """Exit code, and standard error without the progress."""
        errors = io.StringIO()
        modes = {"smoke": lambda _: samples.layout(repeats=1)}
        with (mock.patch.object(plans, "MODES", modes), mock.patch.object(report, "svg", lambda _: ""),
              contextlib.redirect_stderr(errors), contextlib.redirect_stdout(io.StringIO())):
            code = command_line.main([str(w) for w in words])
        return code, "".join(line for line in errors.getvalue().splitlines(True) if not line.startswith("row "))

    def run_smoke(self, program: Path, name: str = "run") -> tuple[int, str]:
        """Figures are left to report_test.py: they take most of the time."""
        return self.bench("run", "--smoke", "-o", self.folder / name, "--program", program, "--scenes", self.folder)

    def test_finished_rows_are_not_run_again(self) -> None:
        program = self.stand_in()
        code, errors = self.run_smoke(program)
        self.assertEqual(code, 0, errors)
        rows = self.calls()
        comparison = json.loads((self.folder / "run" / "comparison.json").read_text())
        self.assertEqual(rows, len(comparison["rows"]))
        lost = sorted((self.folder / "run" / "rows").iterdir())[:3]
        for file in lost:
            file.unlink()
        (lost[0].with_name(lost[0].name + ".part")).write_text("half a ro")  # what an interruption may leave
        code, errors = self.run_smoke(program)
        self.assertEqual(code, 0, errors)
        self.assertEqual(self.calls(), rows + 3)
        self.assertEqual(self.bench("compare", self.folder / "run", self.folder / "run")[0], 0)

    def test_an_interrupted_run_says_so_in_one_line_and_goes_on_where_it_stopped(self) -> None:
        program = self.stand_in()
        real, calls = command_line.run_row, []

        def interrupted(*arguments: object) -> dict:
            calls.append(1)
            if len(calls) == 4:
                raise KeyboardInterrupt
            return real(*arguments)

        with mock.patch.object(command_line, "run_row", interrupted):
            code, errors = self.run_smoke(program)
        self.assertEqual((code, errors.count("\n")), (2, 1), errors)
        self.assertEqual(self.run_smoke(program)[0], 0)
        self.assertEqual(self.calls(), len(samples.layout().rows))

    def test_rows_of_another_build_are_refused(self) -> None:
        self.run_smoke(self.stand_in())
        code, errors = self.run_smoke(self.stand_in(liar="ray-space"))
        self.assertEqual(code, 2)
        self.assertEqual(errors.count("\n"), 1, errors)

    def test_a_method_that_hides_what_is_visible_is_found(self) -> None:
        code, errors = self.run_smoke(self.stand_in(liar="ray-space"))
        self.assertEqual(code, 1)
        self.assertIn("ray-space calls itself conservative and lacks 1 visible objects (b)", errors)
        self.assertIn('class="fault"', (self.folder / "run" / "comparison.html").read_text())

    def test_a_program_that_fails_is_found_and_bad_input_is_one_line(self) -> None:
        self.assertEqual(self.run_smoke(self.stand_in(stop=5))[0], 1)
        for words in (("compare", self.folder / "nothing", self.folder / "run"), ("report", self.folder / "nothing"),
                      ("run", "--smoke", "-o", self.folder / "other", "--program", self.folder / "nothing")):
            code, errors = self.bench(*words)
            self.assertEqual(code, 2)
            self.assertEqual(errors.count("\n"), 1, errors)

    def test_time_and_memory_of_a_child(self) -> None:
        state, _, _ = run_once([sys.executable, "-c", "while True: pass"], timeout=0.3)
        self.assertEqual(state, "timeout")
        peak = run_once([sys.executable, "-c", "x = bytearray(200 << 20)"], timeout=60)[1]
        self.assertGreater(peak, 200 << 10)
        self.assertLess(peak, 240 << 10)
        state, _, message = run_once([sys.executable, "-c", "import sys; sys.exit('no such scene')"], timeout=60)
        self.assertEqual((state, message), ("failed", "no such scene"))

    def test_a_row_keeps_its_command(self) -> None:
        row = run_row(self.stand_in(), self.folder, samples.layout(), plans.town(16), Method("ray-space", ("--components", "4"), "components", "4"))
        self.assertTrue(row["command"].startswith("visibility pvs gen:city,n=16,"))
        self.assertIn("--method ray-space --components 4", row["command"])
        self.assertEqual(row["command"].count("--cell="), len(plans.town(16).cells))


if __name__ == "__main__":
    unittest.main()
