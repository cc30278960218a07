# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Meshes as people have them, and what the command mapt makes of them."""

import math
import unittest

from mapt_test import Test, SHELF, UNUSABLE_INPUT, WRONG_USAGE, area_of, off, unit


class Inputs(Test):
    """Each line of what bad input gets."""

    def test_what_cannot_be_used(self):
        for name, part in (("empty.off", "0 bytes"), ("not_a_mesh.off", ""), ("not_a_mesh.ply", ""),
                           ("not_a_mesh.stl", ""), ("not_a_mesh.obj", ""), ("not_a_mesh.vtp", ""),
                           ("no_faces.off", "faces"), ("no_vertices.off", "vertices"),
                           ("nan_vertex.off", "vertex"), ("infinite_vertex.obj", "line"),
                           ("index_out_of_range.off", ""), ("index_out_of_range.obj", ""),
                           ("index_out_of_range.vtp", ""), ("truncated.off", ""),
                           ("truncated_binary.ply", ""), ("huge_claim.off", ""),
                           ("all_faces_degenerate.off", "no face with an area"),
                           ("points_without_normals.xyz", "normals"),
                           ("unknown_extension.step", ".step"), ("zero_extent.off", "no size"),
                           ("there_is_none.off", "no such file")):
            for command in ("transform", "info", "evaluate"):
                with self.subTest(name=name, command=command):
                    more = []
                    if command == "transform":
                        more = ["-o", self.path / "map.vti"]
                    elif command == "evaluate":
                        more = ["--at", self.write("points.csv", "x,y,z,radius\n0,0,0,1\n")]
                    self.fail_with(UNUSABLE_INPUT, [name, part], command, SHELF / name, *more)
        self.fail_with(UNUSABLE_INPUT, ["directory"], "info", self.path)

    def test_what_works_with_a_word(self):
        for name, part in (("polygons.off", "polygon"), ("degenerate_faces.off", "no area"),
                           ("unused_vertices.off", "no face"),
                           ("nonmanifold_edge.off", "more than 2 faces"),
                           ("mixed_orientation.off", "--orient, or --side both"),
                           ("inward_cube.off", "turned over"),
                           ("soup.stl", None), ("open_tetrahedron.off", None),
                           ("two_components.off", None), ("cavity.off", None),
                           ("concave_polygon.off", "polygon"), ("tetrahedron.vtp", None),
                           ("big_endian.ply", None), ("duplicate_vertices.off", None)):
            for command in ("transform", "info"):
                with self.subTest(name=name, command=command):
                    # soups say that they were joined; apart from that there is nothing to say
                    options = ["-n", 2, "--voxel", 0.1] if command == "transform" else []
                    report = self.report(command, SHELF / name, *options)
                    if part:
                        self.assertTrue(any(part in line for line in report["warnings"]), report)
                        for line in report["warnings"]:
                            self.assertIn(name, line)

    def test_orientation(self):
        mixed = SHELF / "mixed_orientation.off"
        self.assertFalse(self.report("info", mixed)["is_consistently_oriented"])
        report = self.report("transform", mixed, "--orient", "-n", 2)
        self.assertTrue(report["input"]["is_consistently_oriented"])
        inward = SHELF / "inward_cube.off"
        outward = SHELF / "cube.off"
        of_inward, of_outward = (self.report("transform", mesh, "-R", 0.5)["maxima"][0]
                                 for mesh in (inward, outward))
        self.assertAlmostEqual(of_inward["value"], of_outward["value"], delta=0.01)
        report = self.report("transform", outward, "-R", 0.5, "--flip", "--region", "all")
        self.assertEqual(report["maxima"], []) # all lands outside

    def test_soup_equals_its_mesh(self):
        text = "solid\n"
        for face in self.faces:
            text += "facet normal 0 0 0\nouter loop\n"
            text += "".join("vertex %r %r %r\n" % self.points[v] for v in face)
            text += "endloop\nendfacet\n"
        soup = self.write("sphere.stl", text + "endsolid\n")
        of_soup = self.report("transform", soup, "-n", 3)
        of_mesh = self.report("transform", self.sphere, "-n", 3)
        self.assertEqual(of_soup["coverage"], of_mesh["coverage"])
        self.assertEqual(len(of_soup["maxima"]), len(of_mesh["maxima"]))
        for a, b in zip(of_soup["maxima"], of_mesh["maxima"]):
            self.assertAlmostEqual(a["value"], b["value"], places=4)

    def test_holes(self):
        holed = self.write("holed.off", off(self.points, self.faces[60:]))
        report = self.report("transform", holed, "-R", 1, "--voxel", 0.1)
        self.assertLess(report["coverage"], 1)
        self.assertGreater(report["coverage"], 0.8)
        # that it is open is no defect
        self.assertEqual([line for line in report["warnings"] if "on no face" not in line], [])
        self.assertIn("coverage", self.succeed("transform", holed, "-R", 1, "--voxel", 0.1).stdout)
        self.assertIsNone(report["input"]["volume"])

    def test_points_with_normals(self):
        share = area_of(self.points, self.faces) / len(self.points)
        text = "".join(" ".join(map(repr, (*p, *unit(p), share))) + "\n" for p in self.points)
        points = self.write("points.xyz", text)
        table = self.write("at.csv", "x,y,z,radius\n0,0,0,1\n")
        row = self.report("evaluate", points, "--at", table)
        self.assertEqual(row["parameters"]["method"], "samples")
        self.assertAlmostEqual(row["results"][0]["apt"], share * len(self.points), places=8)
        self.fail_with(WRONG_USAGE, ["points.xyz", "--method exact", "samples"], "evaluate", points,
                       "--at", table, "--method", "exact")
        report = self.report("transform", points, "-R", 1, "--voxel", 0.1)
        self.assertEqual(report["parameters"]["region"], "all")
        self.assertLess(math.dist([report["maxima"][0][a] for a in "xyz"], (0, 0, 0)), 0.11)
        for option, value in (("--method", "exact"), ("--normals", "interpolated"),
                              ("--normals", "smoothed"), ("--region", "interior")):
            self.fail_with(WRONG_USAGE, [option, "points.xyz"], "transform", points, option, value)
        # without areas they come from the density
        text = "".join(" ".join(map(repr, (*p, *unit(p)))) + "\n" for p in self.points)
        apt = self.report("evaluate", self.write("plain.xyz", text), "--at", table)["results"][0]["apt"]
        self.assertAlmostEqual(apt / (4 * math.pi), 1, delta=0.02)


if __name__ == "__main__":
    unittest.main()
