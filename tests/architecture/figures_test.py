"""packaging/dev/figures says what is wrong, and fills in what a command really printed: figures_test.py SCRIPT"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(sys.argv.pop())
FIGURE = {"what": "cells", "unit": "", "read": "mesh.cells | length", "format": "{:,}", "value": 19356, "text": "19,356"}
RECORD = {"command": "echo '{\"mesh\": {\"cells\": [1, 2, 3]}}'", "build": "release", "machine": "one",
          "date": "2026-11-22", "figures": {"cells": FIGURE}}


def with_figure(**changes):
    return {**RECORD, "figures": {"cells": {**FIGURE, **changes}}}


class Figures(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        (self.root / "docs" / "figures").mkdir(parents=True)
        self.write("<!--figure:demo.cells-->19,356<!--/figure--> cells", RECORD)

    def tearDown(self):
        self.folder.cleanup()

    def write(self, text, record=None):
        (self.root / "README.md").write_text(text)
        if record:
            (self.root / "docs" / "figures" / "demo.json").write_text(json.dumps(record))

    def run_with(self, *arguments):
        done = subprocess.run([sys.executable, SCRIPT, "--root", self.root, *arguments], capture_output=True, text=True)
        return done.returncode, done.stdout

    def test_a_text_like_its_record_passes(self):
        self.assertEqual(self.run_with("--check")[0], 0)

    def test_a_text_that_differs_is_named(self):
        self.write("<!--figure:demo.cells-->20,000<!--/figure--> cells")
        code, said = self.run_with("--check")
        self.assertEqual(code, 1)
        self.assertIn('README.md shows demo.cells as "20,000"', said)

    def test_a_marker_without_a_record_is_named(self):
        self.write("<!--figure:demo.cells-->19,356<!--/figure--> <!--figure:demo.points-->7<!--/figure-->")
        code, said = self.run_with("--check")
        self.assertEqual(code, 1)
        self.assertIn("demo.points, which has no record", said)

    def test_a_marker_that_is_not_closed_is_named(self):
        self.write("<!--figure:demo.cells-->19,356<!--/figure--> <!--figure:demo.cells-->19,356")
        self.assertEqual(self.run_with("--check")[0], 1)

    def test_a_record_that_contradicts_itself_is_named(self):
        self.write("<!--figure:demo.cells-->19,357<!--/figure-->", with_figure(text="19,357"))
        code, said = self.run_with("--check")
        self.assertEqual(code, 1)
        self.assertIn("its value is shown as", said)

    def test_a_record_without_its_command_is_named(self):
        self.write("<!--figure:demo.cells-->19,356<!--/figure-->", {**RECORD, "command": ""})
        self.assertIn("lacks command", self.run_with("--check")[1])

    def test_a_record_that_is_shown_nowhere_is_named(self):
        self.write("nothing")
        self.assertIn("shown nowhere", self.run_with("--check")[1])

    def test_measuring_writes_what_the_command_printed(self):
        self.assertEqual(self.run_with("--measure", "demo")[0], 0)
        record = json.loads((self.root / "docs" / "figures" / "demo.json").read_text())
        self.assertEqual((record["figures"]["cells"]["value"], record["figures"]["cells"]["text"]), (3, "3"))
        self.assertIn("<!--figure:demo.cells-->3<!--/figure-->", (self.root / "README.md").read_text())

    def test_a_member_of_a_list_is_found_by_its_name(self):
        runs = {**RECORD, "command": "echo '[{\"name\": \"a\", \"ms\": 1}, {\"name\": \"b\", \"ms\": 25}]'"}
        for read, found in (("b.ms", 25), ("0.ms", 1), ("ms | sum", 26)):
            self.write("<!--figure:demo.cells-->0<!--/figure-->",
                       {**runs, "figures": {"cells": {**FIGURE, "read": read}}})
            self.assertEqual(self.run_with("--measure", "demo")[0], 0)
            record = json.loads((self.root / "docs" / "figures" / "demo.json").read_text())
            self.assertEqual(record["figures"]["cells"]["value"], found)

    def test_a_table_stands_as_it_was_printed(self):
        table = {**RECORD, "command": "printf 'time\\n\\n| a | b |\\n|---|---|\\n| 1 | 2.50 |\\n\\nend\\n'"}
        table["figures"] = {"cells": {**FIGURE, "read": "text:^(\\| a .*?)\n\n", "format": "\n{}\n"}}
        self.write("<!--figure:demo.cells-->old<!--/figure-->", table)
        self.assertEqual(self.run_with("--measure", "demo")[0], 0)
        self.assertEqual((self.root / "README.md").read_text(),
                         "<!--figure:demo.cells-->\n| a | b |\n|---|---|\n| 1 | 2.50 |\n<!--/figure-->")
        self.assertEqual(self.run_with("--check")[0], 0)

    def test_a_value_that_is_not_in_the_output_changes_nothing(self):
        self.write("<!--figure:demo.cells-->19,356<!--/figure--> cells", with_figure(read="mesh.points"))
        before = (self.root / "docs" / "figures" / "demo.json").read_text()
        self.assertEqual(self.run_with("--measure", "all")[0], 1)
        self.assertEqual((self.root / "docs" / "figures" / "demo.json").read_text(), before)

    def test_a_command_that_fails_changes_nothing(self):
        self.write("<!--figure:demo.cells-->19,356<!--/figure--> cells", {**RECORD, "command": "echo 7; false"})
        before = (self.root / "docs" / "figures" / "demo.json").read_text()
        self.assertEqual(self.run_with("--measure", "all")[0], 1)
        self.assertEqual((self.root / "docs" / "figures" / "demo.json").read_text(), before)


if __name__ == "__main__":
    unittest.main()
