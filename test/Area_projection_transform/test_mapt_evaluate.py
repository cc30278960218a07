# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt evaluate: values at points."""

import csv
import io
import math
import unittest

from mapt_test import Test, OUTPUT_NOT_WRITTEN, UNUSABLE_INPUT, WRONG_USAGE, area_of, off


class Evaluate(Test):
    def table(self, text):
        return self.write("points.csv", text)

    def rows(self, *arguments):
        return list(csv.DictReader(io.StringIO(self.succeed("evaluate", *arguments).stdout)))

    def test_centre_of_a_sphere(self):
        area = area_of(self.points, self.faces)
        # the flat faces lie a little inside of the sphere
        table = self.table("x,y,z,radius\n0,0,0,1\n0,0,0,0.8\n0,0,0,3\n")
        rows = self.rows(self.sphere, "--at", table)
        self.assertEqual(list(rows[0]), ["x", "y", "z", "radius", "sigma", "apt", "mapt"])
        self.assertAlmostEqual(float(rows[0]["apt"]), area, places=8)
        self.assertAlmostEqual(float(rows[0]["mapt"]), area / (4 * math.pi), places=8)
        self.assertAlmostEqual(float(rows[1]["mapt"]), area / (4 * math.pi * 0.64), places=8)
        self.assertEqual(float(rows[2]["apt"]), 0)
        self.assertEqual([float(row["sigma"]) for row in rows], [0.5, 0.4, 1.5])

    def test_plane(self):
        plane = self.write("plane.off", off([(-5, -5, 0), (5, -5, 0), (5, 5, 0), (-5, 5, 0)],
                                            [(0, 1, 2), (0, 2, 3)]))
        table = self.table("sigma,radius,x,y,z\n0.4,1,0,0,-1\n,1,0,0,-1\n")
        rows = self.rows(plane, "--at", table, "-c", 0.3)
        self.assertAlmostEqual(float(rows[0]["apt"]), math.pi * 0.16, places=9)
        self.assertAlmostEqual(float(rows[1]["mapt"]), 0.09 / 4, places=9)
        rows = self.rows(plane, "--at", table, "-c", 0.3, "--side", "outside")
        self.assertEqual(float(rows[0]["apt"]), 0)
        sampled, searched = (self.rows(plane, "--at", table, "--method", method, "-c", 0.3)
                             for method in ("samples", "kd-tree"))
        self.assertAlmostEqual(float(sampled[0]["mapt"]), 0.04, delta=0.002)
        for row, other in zip(sampled, searched):
            self.assertAlmostEqual(float(row["apt"]), float(other["apt"]), places=12)

    def test_files_and_json(self):
        table = self.table("x,y,z,radius\n0,0,0,1\n")
        report = self.report("evaluate", self.sphere, "--at", table)
        self.assertAlmostEqual(report["results"][0]["apt"], area_of(self.points, self.faces), places=8)
        output = self.path / "out.csv"
        report = self.report("evaluate", self.sphere, "--at", table, "-o", output)
        self.assertEqual(report["outputs"], [str(output)])
        self.assertEqual(output.read_text(encoding="ascii"),
                         self.succeed("evaluate", self.sphere, "--at", table, "-o", "-").stdout)
        self.fail_with(WRONG_USAGE, ["--json"], "evaluate", self.sphere, "--at", table, "-o", "-",
                       "--json")

    def test_threads_do_not_change_a_bit(self):
        table = self.table("x,y,z,radius\n" +
                           "".join(f"{i / 50},0.1,0,{0.5 + i % 3 / 4}\n" for i in range(50)))
        for method in ("exact", "samples", "kd-tree"):
            outputs = [self.succeed("evaluate", self.sphere, "--at", table, "--method", method, "-j",
                                    threads).stdout for threads in (1, 2)]
            self.assertEqual(*outputs)

    def test_no_rows(self):
        result = self.succeed("evaluate", self.sphere, "--at", self.table("x,y,z,radius\n"))
        self.assertEqual(result.stdout, "x,y,z,radius,sigma,apt,mapt\n")
        self.assertIn("nothing to evaluate", result.stderr)

    def test_bad_tables(self):
        for text, parts in (("", ["empty"]), ("x,y,radius\n1,2,3\n", ["'z'", "missing"]),
                            ("x,y,z,radius\n1,2,3,0\n", ["line 2", "radius", "positive"]),
                            ("x,y,z,radius\n1,2,3,1e200\n", ["line 2", "radius", "1e150"]),
                            ("x,y,z,radius\n1,2,nan,1\n", ["line 2", "z", "finite"]),
                            ("x,y,z,radius,sigma\n1,2,3,1,-1\n", ["sigma", "positive"]),
                            ("x,y,z,radius\n1,2,3\n", ["line 2", "radius", "missing"])):
            with self.subTest(text=text):
                self.fail_with(UNUSABLE_INPUT, ["points.csv", *parts], "evaluate", self.sphere, "--at",
                               self.table(text), "-o", self.path / "out.csv")
        self.fail_with(UNUSABLE_INPUT, ["nowhere.csv"], "evaluate", self.sphere, "--at",
                       self.path / "nowhere.csv")

    def test_output_that_cannot_be_written(self):
        self.fail_with(OUTPUT_NOT_WRITTEN, ["out.csv"], "evaluate", self.sphere, "--at",
                       self.table("x,y,z,radius\n0,0,0,1\n"), "-o", self.path / "nowhere" / "out.csv")

    def test_too_many_samples(self):
        table = self.table("x,y,z,radius,sigma\n0,0,0,1,1e-9\n")
        for method in ("samples", "kd-tree"):
            self.fail_with(UNUSABLE_INPUT, ["sigma of 1e-09", "--method exact"], "evaluate", self.sphere,
                           "--at", table, "--method", method)


if __name__ == "__main__":
    unittest.main()
