# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Normals that suit the radius, in the command mapt."""

import math
import unittest

from mapt_test import Test, icosphere, off, unit


class Smoothing(Test):
    """Normals that suit the radius."""

    def setUp(self):
        super().setUp()
        # Dents and bumps of a twelfth of the radius, on every other vertex or so.
        self.points, self.faces = icosphere(4)
        bumpy = [tuple(x * (1.04 if i % 2 else 0.96) for x in p) for i, p in enumerate(self.points)]
        self.bumpy = self.write("bumpy.off", off(bumpy, self.faces))

    def best(self, mesh, *options):
        return self.report("transform", mesh, "-R", 1, "--voxel", 0.1, *options)["maxima"][0]["value"]

    def test_bumps_do_not_scatter(self):
        self.assertLess(self.best(self.bumpy), 0.6)
        for normals in ("averaged", "smoothed"):
            self.assertAlmostEqual(self.best(self.bumpy, "--normals", normals), 1, delta=0.1)
            self.assertAlmostEqual(self.best(self.bumpy, "--normals", normals, "--method", "exact"), 1,
                                   delta=0.1)
        # The less is averaged, the more is scattered.
        self.assertLess(self.best(self.bumpy, "--normals", "averaged", "--smoothing-ratio", 0.01), 0.7)

    def test_points_and_queries(self):
        table = self.write("at.csv", "x,y,z,radius\n0,0,0,1\n")
        report = self.report("evaluate", self.bumpy, "--at", table, "--normals", "averaged")
        self.assertEqual(report["parameters"]["normals"], "averaged")
        self.assertAlmostEqual(report["results"][0]["mapt"], 1, delta=0.1)
        lines, cosines = [], []
        for i, p in enumerate(self.points):
            tilt = (0.5 * math.cos(i), 0.5 * math.sin(i), 0.5 * math.cos(2 * i))
            normal = unit([a + b for a, b in zip(p, tilt)])
            cosines.append(sum(a * b for a, b in zip(p, normal)))
            lines.append(" ".join(map(repr, (*p, *normal))))
        points = self.write("points.xyz", "\n".join(lines) + "\n")
        scattered, calm = (self.report("evaluate", points, "--at", table, "--normals",
                                       normals)["results"][0]["mapt"] for normals in ("face", "averaged"))
        self.assertLess(scattered, 0.8)
        # Each point votes with the cosine between its normal and the averaged one, which is radial.
        self.assertAlmostEqual(calm, sum(cosines) / len(cosines), delta=0.05)

    def test_the_ratio_is_reported(self):
        for normals, ratio in (("face", None), ("averaged", 0.25), ("smoothed", 0.3)):
            report = self.report("transform", self.bumpy, "-R", 1, "--voxel", 0.5, "--normals", normals)
            self.assertEqual(report["parameters"].get("smoothing_ratio"), ratio)
        report = self.report("transform", self.bumpy, "-R", 1, "--voxel", 0.5, "--normals", "averaged",
                             "--smoothing-ratio", 1e30)
        self.assertEqual(report["parameters"]["smoothing_ratio"], 1e30)

    def test_missing_faces_are_compensated(self):
        half = self.write("half.off", off(self.points, self.faces[::2]))
        plain = self.report("transform", half, "-R", 1, "--voxel", 0.1)
        compensated = self.report("transform", half, "-R", 1, "--voxel", 0.1, "--compensate")
        self.assertAlmostEqual(compensated["maxima"][0]["value"],
                               plain["maxima"][0]["value"] / plain["coverage"], places=5)
        self.assertAlmostEqual(plain["coverage"], 0.5, delta=0.03)
        self.assertAlmostEqual(compensated["maxima"][0]["value"], 1, delta=0.1)
        self.assertEqual(self.best(self.sphere, "--compensate"), self.best(self.sphere))


if __name__ == "__main__":
    unittest.main()
