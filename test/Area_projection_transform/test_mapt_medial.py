# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt medial: balls along the medial axis, and what is selected of them."""

import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOPLY import vtkPLYReader

from mapt_test import Test, OUTPUT_NOT_WRITTEN, UNUSABLE_INPUT, WRONG_USAGE, icosphere, off

PROPERTIES = ["x", "y", "z", "radius", "mapt", "lambda", "angle", "scale_axis", "kept"]


def read_balls(file):
    """The properties of the vertices of a binary file, by name, in its order."""
    data = file.read_bytes()
    header, _, body = data.partition(b"end_header\n")
    types = {"double": "<f8", "uchar": "u1", "uint": "<u4"}
    words = [line.split() for line in header.decode().splitlines()]
    fields = [(word[2], types[word[1]]) for word in words if word[0] == "property"]
    number = next(int(word[2]) for word in words if word[:2] == ["element", "vertex"])
    return numpy.frombuffer(body, dtype=fields, count=number)


class Medial(Test):

    def setUp(self):
        super().setUp()
        self.mesh = self.write("sphere.off", off(*icosphere(4)))
        self.file = self.path / "balls.ply"

    def balls(self, *arguments):
        self.succeed("medial", self.mesh, "-o", self.file, *arguments)
        return read_balls(self.file)

    def test_of_a_sphere_are_the_sphere(self):
        balls = self.balls()
        self.assertEqual(list(balls.dtype.names[:len(PROPERTIES)]), PROPERTIES)
        # Edges are 0.07 long; balls are as far off as the normals of samples, by about its square.
        for axis in "xyz":
            self.assertLess(numpy.percentile(abs(balls[axis]), 95), 0.02)
            self.assertLess(abs(balls["refitted_" + axis]).max(), 0.005)
        self.assertLess(numpy.percentile(abs(balls["radius"] - 1), 95), 0.02)
        self.assertLess(abs(balls["mapt"] - 1).max(), 0.02)
        self.assertTrue((balls["kept"] == 1).all())

    def test_are_selected(self):
        report = self.report("medial", self.mesh, "-o", self.file, "--balls", "1")
        self.assertEqual(report["medial"]["kept"], 1)
        self.assertEqual(read_balls(self.file)["kept"].sum(), 1)
        # One ball is all of the sphere, but for what its facets and its radius are off.
        report = self.report("medial", self.mesh, "--balls", "1", "--tolerance", "0.05")
        self.assertGreater(report["medial"]["covered_by_kept"], 0.99)
        self.assertEqual(len(self.balls("--balls", "1", "--kept-only")), 1)
        self.assertGreater(len(self.balls("--prune", "0.9", "--kept-only")), 1000)
        report = self.report("medial", self.mesh, "--prune", "2")  # more than the spread of a sphere
        self.assertEqual(report["medial"]["kept"], 0)

    def test_that_cover_are_few(self):
        report = self.report("medial", self.mesh, "--select", "covering", "--tolerance", "0.05")
        self.assertLess(report["medial"]["kept"], 5)
        self.assertGreater(report["medial"]["covered_by_kept"], 0.99)

    def test_outside_of_a_sphere_are_none(self):
        result = self.succeed("medial", self.mesh, "-o", self.file, "--side", "outside")
        self.assertIn("no ball found", result.stderr)
        self.assertEqual(len(read_balls(self.file)), 0)

    def test_file_is_read_by_vtk(self):
        balls = self.balls()
        reader = vtkPLYReader()
        reader.SetFileName(str(self.file))
        reader.Update()
        points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
        numpy.testing.assert_allclose(points[:, 0], balls["x"], atol=1e-6)

    def test_picture_is_written(self):
        self.succeed("medial", self.mesh, "--balls", "3", "--picture", self.path / "p.png")
        self.assertEqual((self.path / "p.png").read_bytes()[:4], b"\x89PNG")

    def test_do_not_depend_on_threads(self):
        self.balls("-j", "1")
        one = self.file.read_bytes()
        self.balls("-j", "2")
        self.assertEqual(one, self.file.read_bytes())

    def test_refuse_what_they_cannot_do(self):
        for arguments, code, text in [
                ([self.mesh, "-o", self.path / "b.txt"], WRONG_USAGE, ".ply"),
                ([self.mesh, "--prune", "-1"], WRONG_USAGE, "--prune"),
                ([self.mesh, "--balls", "0"], WRONG_USAGE, "--balls"),
                ([self.mesh, "--stop-angle", "180"], WRONG_USAGE, "--stop-angle"),
                ([self.mesh, "--select", "random"], WRONG_USAGE, "--balls"),
                ([self.mesh, "--kept-only"], WRONG_USAGE, "--output"),
                ([self.path / "none.off"], UNUSABLE_INPUT, "none.off"),
                ([self.mesh, "-o", self.path / "no" / "b.ply"], OUTPUT_NOT_WRITTEN, "no/b.ply")]:
            with self.subTest(arguments=arguments):
                self.fail_with(code, [text], "medial", *arguments)


if __name__ == "__main__":
    unittest.main()
