# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Every benchmark runs, on tiny inputs, and its results become a page. Times are not judged.

Finds the benchmarks in the environment variable BENCHMARK and scripts/plot-benchmarks in PLOT.
"""

import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree


def run(*arguments):
    return subprocess.run(arguments, check=True, capture_output=True, text=True).stdout


class Smoke(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.groups = run(os.environ["BENCHMARK"], "--list").split()
        file = cls.folder / "smoke.json"
        cls.output = run(os.environ["BENCHMARK"], "--smoke", "--json", str(file))
        cls.data = json.loads(file.read_text(encoding="utf-8"))

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def page_of(self, data, name):
        """The text of the page, after a look at its figures."""
        folder = self.folder / name
        folder.mkdir()
        file = folder / "benchmark.json"
        file.write_text(json.dumps(data), encoding="utf-8")
        run(sys.executable, "-B", os.environ["PLOT"], str(file), str(folder))
        page = (folder / "benchmarks.md").read_text(encoding="utf-8")
        shown = set(re.findall(r"\]\((fig/.*?\.svg)\)", page))
        written = {f"fig/{figure.name}" for figure in (folder / "fig").iterdir()}
        self.assertEqual(shown, written)
        for figure in shown:
            xml.etree.ElementTree.parse(folder / figure)
        return page

    def test_every_group_has_rows(self):
        self.assertEqual([group["name"] for group in self.data["groups"]], self.groups)
        self.assertEqual({row["group"] for row in self.data["rows"]}, set(self.groups))
        for name in self.groups:
            self.assertIn(f"\n{name}, ", self.output)

    def test_numbers_are_numbers(self):
        for row in self.data["rows"]:
            for spread in (row["wall_seconds"], row["ratio"]):
                self.assertTrue(0 < spread["minimum"] <= spread["median"] <= spread["maximum"], row)
            for value in row["measures"].values():
                self.assertTrue(math.isfinite(value), row)

    def test_each_comparison_begins_with_its_baseline(self):
        first = None
        for row in self.data["rows"]:
            if row["is_baseline"]:
                first = row
                self.assertEqual(row["ratio"]["median"], 1)
            self.assertEqual((row["group"], row["comparison"]), (first["group"], first["comparison"]))

    def test_machine_and_software_are_named(self):
        for part, name in (("machine", "processor"), ("machine", "cores"), ("machine", "system"),
                           ("machine", "memory_gigabytes"), ("software", "compiler"),
                           ("software", "CGAL"), ("software", "instruction_set")):
            self.assertTrue(self.data[part][name], name)

    def test_page_has_every_group(self):
        page = self.page_of(self.data, "all")
        for name in self.groups:
            self.assertIn(f"\n## {name}\n", page)

    def test_page_of_some_groups(self):
        for name in self.groups:
            one = dict(self.data)
            one["groups"] = [group for group in self.data["groups"] if group["name"] == name]
            one["rows"] = [row for row in self.data["rows"] if row["group"] == name]
            self.assertIn(f"\n## {name}\n", self.page_of(one, name))
        self.page_of({**self.data, "groups": [], "rows": []}, "none")

    def test_page_has_groups_without_figures(self):
        text = json.dumps(self.data).replace(f'"{self.groups[0]}"', '"something new"')
        self.assertIn("\n## something new\n", self.page_of(json.loads(text), "new"))


if __name__ == "__main__":
    unittest.main()
