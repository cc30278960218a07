# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Point sets in the command mapt."""

import math
import unittest

from mapt_test import Test, SHELF, UNUSABLE_INPUT, WRONG_USAGE, off


class Points(Test):
    """Points without normals, which are estimated if that is asked for."""

    def setUp(self):
        super().setUp()
        lines = [" ".join(map(repr, p)) for p in self.points]
        self.text = "\n".join(lines) + "\n"
        self.plain = self.write("plain.xyz", self.text)
        self.table = self.write("at.csv", "x,y,z,radius\n0,0,0,1\n")

    def test_formats(self):
        number, lines = len(self.points), self.text.splitlines()
        vtp = ('<?xml version="1.0"?><VTKFile type="PolyData" version="0.1" '
               'byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="%d" NumberOfPolys="0">'
               '<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">%s'
               '</DataArray></Points></Piece></PolyData></VTKFile>' % (number, self.text))
        ply = "ply\nformat ascii 1.0\nelement vertex %d\n" % number
        ply += "".join("property double %s\n" % axis for axis in "xyz") + "end_header\n"
        for name, text in (("points.xyz", self.text), ("points.off", off(self.points, [])),
                           ("points.obj", "".join("v " + line + "\n" for line in lines)),
                           ("points.ply", ply + self.text), ("points.vtp", vtp)):
            with self.subTest(name=name):
                file = self.write(name, text)
                report = self.report("evaluate", file, "--at", self.table, "--estimate-normals")
                # all points meet at the centre, and share the area of the sphere
                self.assertAlmostEqual(report["results"][0]["apt"] / (4 * math.pi), 1, delta=0.02)
                self.assertTrue(report["input"]["normals_estimated"])
                self.assertEqual(report["input"]["normal_neighbours"], 18)
                self.assertEqual(report["input"]["points_unoriented"], 0)
                self.assertEqual(report["input"]["components"], 1)
                self.assertEqual(len(report["warnings"]), 1)
                self.assertIn("18 neighbours", report["warnings"][0])

    def test_are_samples_as_they_are(self):
        # Faces would be cut into many more for so small a ball.
        table = self.write("small.csv", "x,y,z,radius,sigma\n0,0,0,1,1e-4\n")
        file = SHELF / "points_with_normals.xyz"
        for method in ("samples", "kd-tree"):
            self.succeed("evaluate", file, "--at", table, "--method", method)
        self.fail_with(UNUSABLE_INPUT, ["give fewer points or raise --max-memory (100 bytes)"],
                       "evaluate", file, "--at", table, "--max-memory", 100)

    def test_without_the_option(self):
        for command, more in (("info", []), ("transform", []), ("evaluate", ["--at", self.table])):
            self.fail_with(UNUSABLE_INPUT, ["plain.xyz", "no normals", "--estimate-normals"], command,
                           self.plain, *more)
        self.assertFalse(self.report("info", SHELF / "points_with_normals.xyz")["normals_estimated"])

    def test_where_it_makes_no_sense(self):
        map_file = self.path / "map.vti"
        self.succeed("transform", self.sphere, "-R", 1, "--voxel", 0.5, "-o", map_file)
        for file, part in ((self.sphere, "faces"), (SHELF / "points_with_normals.xyz", "normals"),
                           (map_file, "map")):
            self.fail_with(WRONG_USAGE, ["--estimate-normals", file.name, part, "leave it out"], "info",
                           file, "--estimate-normals")

    def test_info_and_transform(self):
        info = self.report("info", self.plain, "--estimate-normals")
        self.assertEqual((info["type"], info["vertices"]), ("points", len(self.points)))
        self.assertGreater(info["forecast"]["bytes"], 0)
        options = ["--estimate-normals", "-R", 1, "--voxel", 0.1]
        strongest = self.report("transform", self.plain, *options)["maxima"][0]
        self.assertLess(math.dist([strongest[a] for a in "xyz"], (0, 0, 0)), 0.11)
        self.assertAlmostEqual(strongest["value"], 1, delta=0.02)
        turned = self.report("evaluate", self.plain, "--at", self.table, *options[:1], "--flip")
        self.assertEqual(turned["results"][0]["apt"], 0)

    def test_points_that_cannot_be_oriented(self):
        line = "".join("%r 0 0\n" % (10 + i / 10) for i in range(25))
        report = self.report("info", self.write("line.xyz", self.text + line), "--estimate-normals")
        self.assertEqual(report["points_unoriented"], 25)
        self.assertTrue(any("25 points" in w and "left out" in w for w in report["warnings"]))
        self.fail_with(UNUSABLE_INPUT, ["line.xyz", "25 points", "lines"], "info",
                       self.write("line.xyz", line), "--estimate-normals")
        self.fail_with(UNUSABLE_INPUT, ["few.xyz", "6 different positions", "more points"], "info",
                       self.write("few.xyz", "\n".join(self.text.splitlines()[:6])),
                       "--estimate-normals")

    def test_threads_do_not_change_a_bit(self):
        results = [self.report("evaluate", self.plain, "--at", self.table, "--estimate-normals", "-j",
                               threads)["results"] for threads in (1, 4)]
        self.assertEqual(*results)


if __name__ == "__main__":
    unittest.main()
