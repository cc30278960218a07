# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The experiments of the paper run, say what they are to say, and become a page with curves.

Finds the experiments in the environment variable BENCHMARK and scripts/plot-benchmarks in PLOT.
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
        file = cls.folder / "paper.json"
        cls.output = run(os.environ["BENCHMARK"], "--quick", "--voxels", "40", "--json", str(file),
                         "--pictures", str(cls.folder / "pictures"))
        cls.data = json.loads(file.read_text(encoding="utf-8"))

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def rows(self, group, comparison, **parameters):
        rows = [row for row in self.data["rows"]
                if (row["group"], row["comparison"]) == (group, comparison)
                and parameters.items() <= row["parameters"].items()]
        self.assertTrue(rows, (group, comparison, parameters))
        return rows

    def test_every_figure_has_rows(self):
        groups = [group["name"] for group in self.data["groups"]]
        self.assertEqual(groups, ["figure 1", "figure 4", "figure 5", "figure 7", "figure 8", "figure 9", "figure 10",
                                  "figure 11", "figure 12", "figure 13", "curves", "ratios", "salient",
                                  "lines", "medial"])
        self.assertEqual({row["group"] for row in self.data["rows"]}, set(groups))
        for name in groups:
            self.assertIn(f"\n{name}, ", self.output)

    def test_numbers_are_numbers(self):
        for row in self.data["rows"]:
            for value in row["measures"].values():
                self.assertTrue(math.isfinite(value), row)

    def test_no_damage_is_no_difference(self):
        for damage in ("faces removed", "holes", "noise"):
            for row in self.rows("curves", f"{damage}: maps", amount=0):
                self.assertAlmostEqual(row["measures"]["joint correlation"], 1, 12)
                self.assertEqual(row["measures"]["joint error"], 0)
            for row in self.rows("curves", f"{damage}: maxima", amount=0):
                self.assertEqual(row["measures"]["displacement"], 0)

    def test_maps_are_robust_against_the_loss_of_half_of_the_faces(self):
        for row in self.rows("figure 1", "maps", damage="faces removed"):
            self.assertGreater(row["measures"]["joint correlation"], 0.95, row)
            self.assertLess(row["measures"]["/ area error"], 0.2, row)

    def test_smoothing_resists_noise(self):
        for row in self.rows("curves", "noise: maps", amount=0.2):
            if row["name"] in ("averaged", "smoothed"):
                self.assertGreater(row["measures"]["largest R correlation"], 0.98, row)
                self.assertLess(row["measures"]["largest R error"], 0.1, row)

    def test_bumps_scatter_the_normals_of_faces_and_smoothing_brings_them_back(self):
        for row in self.rows("figure 4", "bumpy sphere", amplitude=0):
            self.assertAlmostEqual(row["measures"]["relative value"], 1, 3)
        for row in self.rows("figure 4", "bumpy sphere", amplitude=1):
            if row["name"] in ("face", "interpolated"):
                self.assertLess(row["measures"]["relative value"], 0.5, row)
            else:
                self.assertAlmostEqual(row["measures"]["relative value"], 1, delta=0.1, msg=row)

    def test_a_bump_moves_what_is_important_least(self):
        gain = {row["name"]: row["measures"]["gain"]
                for row in self.rows("figure 5", "bump", coverage=0.8)}
        self.assertGreater(gain["importance"], 5)
        self.assertGreater(gain["importance"], 3 * gain["MAPT"])

    def test_walls_count(self):
        walls = [row for row in self.data["rows"]
                 if "walls" in row["measures"] and row["name"] == "face"]
        self.assertTrue(walls)
        for row in walls:
            self.assertAlmostEqual(row["measures"]["in walls"], row["measures"]["walls"], delta=0.25)

    def test_salient_points_are_on_the_objects_of_figure_9(self):
        for row in self.rows("figure 9", "points on objects", s=0.1):
            for name, radius in ("sphere 1", 1), ("sphere 0.5", 0.5), ("sphere 0.25", 0.25):
                self.assertEqual(row["measures"][f"on {name}"], 1, row)
            # No sphere is seen at less than two thirds of its radius.
            self.assertGreaterEqual(row["measures"]["R/R0, sphere 1"], 2 / 3)
            self.assertGreater(row["measures"]["sphericity, sphere 1"], 0.95)
            self.assertGreater(row["measures"]["on tube"], 0)
            self.assertLess(row["measures"]["sphericity, tube"], 0.9)
            self.assertEqual(row["measures"]["elsewhere"], 0)

    def test_salient_points_survive_holes(self):
        for row in self.rows("figure 11", "points found again", damage="none"):
            self.assertEqual(row["measures"]["within 2 voxels"], 1)
        for row in self.rows("figure 11", "points found again", damage="holes"):
            self.assertGreater(row["measures"]["within R/2"], 0.5)

    def test_lines_follow_an_arm_that_is_attached_to_the_body(self):
        for row in self.rows("figure 12", "B: attached arm", line="arm"):
            self.assertGreater(row["measures"]["found"], 0.7, row)
            self.assertLess(row["measures"]["distance / R"], 0.3, row)

    def test_medial_axes_are_judged(self):
        names = {row["name"] for row in self.rows("medial", "axes")}
        self.assertEqual(names, {"unpruned", "mapt", "mapt_refitted", "lambda", "scale_axis",
                                 "random", "covering", "centerlines", "skeleton"})
        for row in self.rows("medial", "axes"):
            if row["name"] in ("unpruned", "mapt", "lambda", "skeleton"):
                self.assertEqual((row["measures"]["pieces"], row["measures"]["loops"]), (1, 0), row)
        covers = {row["name"]: row["measures"]["covers"]
                  for row in self.rows("medial", "equal numbers", **{"most balls": 50})}
        self.assertEqual(max(covers, key=covers.get), "covering")
        # CGAL's skeleton does not know directions, and centrelines hardly do.
        for row in self.rows("medial", "stability", change="turned"):
            if row["name"] in ("centerlines", "skeleton"):
                self.assertLess(row["measures"]["mean %"], 0.5, row)

    def test_lines_survive_the_loss_of_half_of_the_faces(self):
        for row in self.rows("figure 13", "lines found again"):
            self.assertGreater(row["measures"]["found again"], 0.7, row)

    def test_round_objects_are_found(self):
        for row in self.rows("salient", "easy, clean"):
            self.assertEqual(row["measures"]["recall"], 1, row)
            self.assertLess(row["measures"]["radius error"], 0.01, row)
        for row in self.rows("salient", "no spheres"):
            if row["name"] == "area projection":
                self.assertEqual(row["measures"]["spheres"], 0, row)

    def test_pictures_are_written(self):
        pictures = list((self.folder / "pictures").iterdir())
        self.assertTrue(pictures)
        for picture in pictures:
            self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_the_seed_decides(self):
        def numbers(seed):
            file = self.folder / "again.json"
            run(os.environ["BENCHMARK"], "--quick", "--voxels", "20", "--figure", "7", "--seed", seed,
                "--json", str(file))
            return json.loads(file.read_text(encoding="utf-8"))["rows"]
        self.assertEqual(numbers("3"), numbers("3"))
        self.assertNotEqual(numbers("3"), numbers("4"))

    def test_page_shows_all_curves(self):
        folder = self.folder / "page"
        run(sys.executable, "-B", os.environ["PLOT"], str(self.folder / "paper.json"), str(folder))
        page = (folder / "paper.md").read_text(encoding="utf-8")
        shown = set(re.findall(r"\]\((fig/.*?\.svg)\)", page))
        self.assertEqual(shown, {f"fig/{figure.name}" for figure in (folder / "fig").iterdir()})
        self.assertEqual(len(shown), 15)
        for figure in shown:
            xml.etree.ElementTree.parse(folder / figure)


if __name__ == "__main__":
    unittest.main()
