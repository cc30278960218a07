# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt lines: centrelines of tubes, and the files they are written to."""

import json
import math
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from mapt_test import Test, OUTPUT_NOT_WRITTEN, UNUSABLE_INPUT, WRONG_USAGE, icosphere, off

RADIUS, LENGTH = 1, 12


def tube(sides=32, rings=60):
    """An open cylinder around the z axis: its vertices lie on it."""
    points = [(RADIUS * math.cos(2 * math.pi * side / sides), RADIUS * math.sin(2 * math.pi * side / sides),
               LENGTH * ring / rings) for ring in range(rings + 1) for side in range(sides)]
    faces = []
    for ring in range(rings):
        for side in range(sides):
            a, b = ring * sides + side, ring * sides + (side + 1) % sides
            faces += [(a, b, b + sides), (a, b + sides, a + sides)]
    return points, faces


def torus(radius, bend, sides=24, rings=96):
    points, faces = [], []
    for ring in range(rings):
        for side in range(sides):
            u, v = 2 * math.pi * ring / rings, 2 * math.pi * side / sides
            across = bend + radius * math.cos(v)
            points.append((across * math.cos(u), across * math.sin(u), radius * math.sin(v)))
            a, b = ring * sides + side, ring * sides + (side + 1) % sides
            c, d = (a + sides) % (sides * rings), (b + sides) % (sides * rings)
            faces += [(a, c, d), (a, d, b)]
    return points, faces


class Lines(Test):

    def setUp(self):
        super().setUp()
        self.mesh = self.write("tube.off", off(*tube()))

    def lines(self, *arguments):
        return self.succeed("lines", *arguments)

    def test_of_what_looks_inward_are_told_to_be_turned(self):
        points, faces = tube()
        inward = self.write("inward.off", off(points, [face[::-1] for face in faces]))
        result = self.lines(inward, "--json")
        self.assertTrue(json.loads(result.stdout)["lines"]["is_turned_over"])
        self.assertIn("as if they looked outward", result.stderr)
        self.assertFalse(self.report("lines", self.mesh)["lines"]["is_turned_over"])

    def test_of_a_tube_are_its_axis(self):
        self.lines(self.mesh, "-o", self.path / "l.json")
        graph = json.loads((self.path / "l.json").read_text())
        self.assertEqual(len(graph["branches"]), 1)
        self.assertEqual(len(graph["nodes"]), 2)
        branch = graph["branches"][0]
        self.assertEqual(sorted([branch["from"], branch["to"]]), [0, 1])
        points = numpy.array(branch["points"])
        # The vertices lie on the tube, so that its axis is known to rounding; a fit is told to rest at 1e-4.
        self.assertLess(numpy.abs(points[:, :2]).max(), 1e-3 * RADIUS)
        self.assertLess(numpy.abs(numpy.array(branch["radii"]) - RADIUS).max(), 1e-3 * RADIUS)
        # Lines go on to the rims, whose points are a ring apart.
        ring = LENGTH / 60
        self.assertLess(points[:, 2].min(), ring)
        self.assertGreater(points[:, 2].max(), LENGTH - ring)
        self.assertAlmostEqual(branch["length"], numpy.ptp(points[:, 2]), delta=0.01)
        self.assertEqual(len(graph["nodes"][0]), 3)

    def test_vtp_is_read_by_vtk(self):
        self.lines(self.mesh, "-o", self.path / "l.vtp", "-o", self.path / "l.json")
        graph = json.loads((self.path / "l.json").read_text())
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.path / "l.vtp"))
        reader.Update()
        data = reader.GetOutput()
        self.assertEqual(data.GetNumberOfLines(), 1)
        line = data.GetCell(0)
        ids = [line.GetPointId(i) for i in range(line.GetNumberOfPoints())]
        points = vtk_to_numpy(data.GetPoints().GetData())[ids]
        numpy.testing.assert_array_equal(points, numpy.array(graph["branches"][0]["points"]))
        radius = vtk_to_numpy(data.GetPointData().GetArray("radius"))[ids]
        numpy.testing.assert_array_equal(radius, graph["branches"][0]["radii"])
        for name in ["mapt", "branch", "coverage", "tangent"]:
            self.assertTrue(data.GetPointData().HasArray(name), name)
        self.assertEqual(data.GetCellData().GetArray("length").GetValue(0),
                         graph["branches"][0]["length"])

    def test_swc_is_a_tree_that_covers_the_line(self):
        self.lines(self.mesh, "-o", self.path / "l.swc", "-o", self.path / "l.json")
        rows = [line.split() for line in (self.path / "l.swc").read_text().splitlines()
                if not line.startswith("#")]
        points = json.loads((self.path / "l.json").read_text())["branches"][0]["points"]
        self.assertEqual(len(rows), len(points))
        self.assertEqual([int(row[0]) for row in rows], list(range(1, len(rows) + 1)))
        self.assertEqual([int(row[6]) for row in rows].count(-1), 1)
        for row in rows:
            self.assertLess(int(row[6]), int(row[0]))  # parents come first
        length = sum(math.dist([float(x) for x in row[2:5]],
                               [float(x) for x in rows[int(row[6]) - 1][2:5]])
                     for row in rows if int(row[6]) > 0)
        self.assertAlmostEqual(length, sum(math.dist(a, b) for a, b in zip(points, points[1:])), 9)

    def test_swc_of_a_closed_line_ends_where_it_begins(self):
        mesh = self.write("torus.off", off(*torus(1, 4)))
        self.lines(mesh, "-o", self.path / "l.swc")
        rows = [line.split() for line in (self.path / "l.swc").read_text().splitlines()
                if not line.startswith("#")]
        places = [tuple(row[2:5]) for row in rows]
        self.assertEqual(len(set(places)), len(places) - 1)  # one of them twice
        self.assertEqual([int(row[6]) for row in rows].count(-1), 1)

    def test_obj_has_an_element_for_each_branch(self):
        self.lines(self.mesh, "-o", self.path / "l.obj")
        lines = (self.path / "l.obj").read_text().splitlines()
        vertices = [line for line in lines if line.startswith("v ")]
        elements = [line.split()[1:] for line in lines if line.startswith("l ")]
        self.assertEqual(len(elements), 1)
        self.assertEqual(sorted(map(int, elements[0])), list(range(1, len(vertices) + 1)))

    def test_segments_name_the_branch_of_each_face(self):
        self.lines(self.mesh, "--segments", self.path / "s.ply")
        reader = vtkPLYReader()
        reader.SetFileName(str(self.path / "s.ply"))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfCells(), len(tube()[1]))
        self.assertIn(b"property int branch", (self.path / "s.ply").read_bytes())

    def test_picture_is_written(self):
        self.lines(self.mesh, "--picture", self.path / "p.png")
        self.assertEqual((self.path / "p.png").read_bytes()[:4], b"\x89PNG")

    def test_json_report_counts(self):
        report = self.report("lines", self.mesh)
        self.assertEqual(report["lines"]["pieces"], 1)
        self.assertEqual(len(report["lines"]["branches"]), 1)
        self.assertAlmostEqual(report["lines"]["branches"][0]["mean_radius"], RADIUS, 3)

    def test_of_a_sphere_there_are_none(self):
        mesh = self.write("sphere.off", off(*icosphere(3)))
        result = self.lines(mesh, "-o", self.path / "l.json")
        self.assertIn("no tube found", result.stderr)
        self.assertEqual(json.loads((self.path / "l.json").read_text()),
                         {"branches": [], "nodes": []})

    def test_do_not_depend_on_threads(self):
        for threads in ["1", "2"]:
            self.lines(self.mesh, "-j", threads, "-o", self.path / f"l{threads}.json")
        self.assertEqual((self.path / "l1.json").read_bytes(),
                         (self.path / "l2.json").read_bytes())

    def test_refuse_what_they_cannot_do(self):
        for arguments, code, text in [
                ([self.mesh, "-o", self.path / "l.txt"], WRONG_USAGE, ".vtp"),
                ([self.mesh, "-o", self.path / "a.swc", "-o", self.path / "a.swc"], WRONG_USAGE,
                 "twice"),
                ([self.mesh, "--radius-min", "2", "--radius-max", "1"], WRONG_USAGE,
                 "--radius-min"),
                ([self.mesh, "--least-length", "0"], WRONG_USAGE, "--least-length"),
                ([self.path / "none.off"], UNUSABLE_INPUT, "none.off"),
                ([self.mesh, "-o", self.path / "no" / "l.vtp"], OUTPUT_NOT_WRITTEN, "no/l.vtp")]:
            with self.subTest(arguments=arguments):
                self.fail_with(code, [text], "lines", *arguments)


if __name__ == "__main__":
    unittest.main()
