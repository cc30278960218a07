# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt medial: balls along the medial axis, and what is selected of them."""

import json
import math
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOPLY import vtkPLYReader

from mapt_test import DATA, Test, OUTPUT_NOT_WRITTEN, UNUSABLE_INPUT, WRONG_USAGE, icosphere, off

PROPERTIES = ["x", "y", "z", "radius", "mapt", "lambda", "angle", "scale_axis", "kept"]


TYPES = {"double": "<f8", "uchar": "u1", "uint": "<u4", "int": "<i4"}


def read_ply(file):
    """The elements of a binary file by name, each an array with the properties by name."""
    header, _, body = file.read_bytes().partition(b"end_header\n")
    elements = []
    for words in map(str.split, header.decode().splitlines()):
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[:2] == ["property", "list"]:  # of three
            elements[-1][2].extend([("count", TYPES[words[2]]), (words[4], TYPES[words[3]], 3)])
        elif words[0] == "property":
            elements[-1][2].append((words[2], TYPES[words[1]]))
    arrays = {}
    for name, number, fields in elements:
        arrays[name] = numpy.frombuffer(body, dtype=fields, count=number)
        body = body[arrays[name].nbytes:]
    assert not body
    return arrays


def read_balls(file):
    return read_ply(file)["vertex"]


def torus(ring, tube, n, m):
    """Points and triangles that face outward."""
    angles = [(2 * math.pi * i / n, 2 * math.pi * j / m) for i in range(n) for j in range(m)]
    points = [((ring + tube * math.cos(v)) * math.cos(u), (ring + tube * math.cos(v)) * math.sin(u),
               tube * math.sin(v)) for u, v in angles]
    faces = []
    for i in range(n):
        for j in range(m):
            a, b = i * m + j, (i + 1) % n * m + j
            c, d = (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m
            faces += [(a, b, c), (a, c, d)]
    return points, faces


def volume_of(points, faces):
    p = numpy.array(points)[numpy.array(faces)]
    return numpy.linalg.det(p).sum() / 6


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

    def test_that_are_polar_are_where_samples_say(self):
        balls = self.balls("--method", "polar")
        # Samples are nearer to the centre than 1 by up to 0.07² / 6, by some more or less: between four that are 0.07 apart
        # balls end early by a part of that over 0.07.
        for axis in "xyz":
            self.assertLess(numpy.median(abs(balls[axis])), 0.02)
        self.assertLess(numpy.median(abs(balls["radius"] - 1)), 0.03)
        touching = self.balls("--method", "touching")
        self.assertFalse(len(balls) == len(touching) and (balls["radius"] == touching["radius"]).all())

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

    def test_see_what_gaps_hide(self):
        points, faces = icosphere(4)
        mesh = self.write("holed.off", off(points, faces[::2] + faces[1::4]))
        seen = [numpy.median(read_balls(self.file)["mapt"]) for options in ((), ("--no-compensate",))
                if self.succeed("medial", mesh, "-o", self.file, *options)]
        # All of a sphere votes; a quarter of the faces is missing.
        self.assertLess(abs(seen[0] - 1), 0.02)
        self.assertLess(abs(seen[1] - 0.75), 0.02)

    def test_that_cover_are_connected(self):
        pieces = {}
        for choice in "covering", "connected":
            report = self.report("medial", DATA / "human_woman.obj", "--balls", "91", "--select",
                                 choice)["medial"]
            pieces[choice] = report["topology"]["components"]
            self.assertLessEqual(report["kept"], 91)
            self.assertGreater(report["covered_by_kept"], 0.85)
        self.assertGreater(pieces["covering"], 1)
        self.assertEqual(pieces["connected"], 1)

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

    def test_are_connected_as_the_shape_is(self):
        mesh = self.write("torus.off", off(*torus(1, 0.3, 60, 20)))
        report = self.report("medial", mesh, "-o", self.file)["medial"]
        self.assertEqual(report["topology"],
                         {"components": 1, "loops": 1, "cavities": 0, "euler_number": 0})
        self.assertEqual(report["shape"], report["topology"])
        data = read_ply(self.file)
        edges = numpy.stack([data["edge"]["vertex1"], data["edge"]["vertex2"]], axis=1)
        faces = data["face"]["vertex_indices"]
        self.assertEqual((len(edges), len(faces)), (report["edges"], report["faces"]))
        self.assertTrue((data["face"]["count"] == 3).all())
        self.assertEqual(len(numpy.unique(edges)) - len(edges) + len(faces), 0)
        # Balls that are connected overlap, if they grow by what closes cracks.
        balls = data["vertex"]
        a, b = balls[edges[:, 0]], balls[edges[:, 1]]
        apart = numpy.sqrt(sum((a[axis] - b[axis]) ** 2 for axis in "xyz"))
        self.assertTrue((apart <= a["radius"] + b["radius"] + 2 * report["growth"]).all())
        sides = {frozenset(edge) for edge in edges.tolist()}
        for i, j, k in faces.tolist():
            self.assertLessEqual({frozenset((i, j)), frozenset((j, k)), frozenset((i, k))}, sides)
        reader = vtkPLYReader()
        reader.SetFileName(str(self.file))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfPolys(), len(faces))

    def test_that_are_left_out_are_not_connected(self):
        mesh = self.write("torus.off", off(*torus(1, 0.3, 60, 20)))
        report = self.report("medial", mesh, "-o", self.file, "--balls", "40", "--kept-only",
                             "--select", "covering")["medial"]
        data = read_ply(self.file)
        self.assertEqual(len(data["vertex"]), report["kept"])
        self.assertEqual(report["topology"]["loops"], 1)
        for name in ("vertex1", "vertex2"):
            self.assertLess(data["edge"][name].max(), report["kept"])
        # Neighbours along the ring, not balls across it.
        balls = data["vertex"]
        a, b = balls[data["edge"]["vertex1"]], balls[data["edge"]["vertex2"]]
        self.assertLess(((a["x"] - b["x"]) ** 2 + (a["y"] - b["y"]) ** 2).max(), 1)

    def test_picture_is_written(self):
        self.succeed("medial", self.mesh, "--balls", "3", "--picture", self.path / "p.png")
        self.assertEqual((self.path / "p.png").read_bytes()[:4], b"\x89PNG")

    def test_are_a_mesh_again(self):
        for extension in "off", "obj", "ply", "stl":
            file = self.path / f"again.{extension}"
            report = self.report("medial", self.mesh, "--reconstruct", file, "--cell", "0.1")
            self.assertIn(str(file), report["outputs"])
            mesh = self.report("info", file)
            self.assertEqual(mesh["faces"], report["reconstruction"]["faces"])
            self.assertTrue(mesh["is_closed"], extension)
            # A sphere within the sagitta of cells, cell² / 2r, and what facets and balls are off.
            self.assertLess(abs(mesh["volume"] - 4 * math.pi / 3), 4 * math.pi * 0.02)
        error = report["reconstruction"]["error"]
        self.assertLess(error["missing"]["largest"], 0.01)
        self.assertLess(error["protrusion"]["mean"], 0.01)
        self.assertEqual(error["spacing"], 0.1)

    def test_are_filled_between(self):
        mesh = self.write("torus.off", off(*torus(1, 0.3, 60, 20)))
        means = []
        for arguments in [], ["--interpolate"]:
            report = self.report("medial", mesh, "--balls", "24", "--select", "covering",
                                 "--reconstruct", self.path / "again.off", *arguments)
            means.append(report["reconstruction"]["error"]["missing"]["mean"])
        self.assertLess(means[1], 0.5 * means[0])

    def test_do_not_depend_on_threads(self):
        self.balls("-j", "1")
        one = self.file.read_bytes()
        self.balls("-j", "2")
        self.assertEqual(one, self.file.read_bytes())

    def test_of_half_of_the_faces_weigh_what_all_would_give_them(self):
        points, faces = icosphere(3)
        half = self.write("half.off", off(points, faces[::2]))
        for options, weight in ([], 1), (["--no-compensate"], 0.5):
            balls = self.path / "balls.ply"
            self.succeed("medial", half, "-o", balls, *options)
            self.assertAlmostEqual(numpy.median(read_ply(balls)["vertex"]["mapt"]), weight, delta=0.05)

    def test_refuse_what_they_cannot_do(self):
        for arguments, code, text in [
                ([self.mesh, "-o", self.path / "b.txt"], WRONG_USAGE, ".ply"),
                ([self.mesh, "--prune", "-1"], WRONG_USAGE, "--prune"),
                ([self.mesh, "--balls", "0"], WRONG_USAGE, "--balls"),
                ([self.mesh, "--stop-angle", "180"], WRONG_USAGE, "--stop-angle"),
                ([self.mesh, "--select", "random"], WRONG_USAGE, "--balls"),
                ([self.mesh, "--select", "random", "--balls", "3", "--seed", "-1"], WRONG_USAGE,
                 "--seed: -1 is not a whole number"),
                ([self.mesh, "--weight", "lambda"], WRONG_USAGE, "--prune"),
                ([self.mesh, "--weight", "lambda", "--select", "covering", "--balls", "9"], WRONG_USAGE,
                 "--prune"),
                ([self.mesh, "--kept-only"], WRONG_USAGE, "--output"),
                ([self.mesh, "--compare", self.path / "c.txt"], WRONG_USAGE, ".json"),
                ([self.mesh, "--reconstruct", self.path / "m.vtp"], WRONG_USAGE, ".stl"),
                ([self.mesh, "--cell", "1"], WRONG_USAGE, "--reconstruct"),
                ([self.mesh, "--interpolate"], WRONG_USAGE, "--reconstruct"),
                ([self.mesh, "--reconstruct", self.path / "m.off", "--cell", "1e-5"], WRONG_USAGE,
                 "--cell is 1e-05"),
                ([self.mesh, "--reconstruct", self.path / "m.off", "--cell", "1e-30",
                  "--interpolate"], WRONG_USAGE, "--cell is 1e-30"),
                ([self.mesh, "--reconstruct", self.path / "m.off", "--cell", "1e6"], WRONG_USAGE,
                 "--cell is 1e+06"),
                ([self.mesh, "--spacing", "1e-5"], UNUSABLE_INPUT,
                 "raise --spacing or raise --max-memory (2 GB)"),
                ([self.mesh, "--max-memory", "10k"], UNUSABLE_INPUT,
                 "simplify the mesh or raise --max-memory"),
                ([self.mesh, "--reconstruct", self.path / "m.off", "--cell", "0.002"], UNUSABLE_INPUT,
                 "raise --cell or raise --max-memory"),
                ([self.mesh, "--seed", "3"], WRONG_USAGE, "--seed"),
                ([self.mesh, "--coverage", "2"], WRONG_USAGE, "--coverage"),
                ([self.mesh, "--coverage", "0.5"], WRONG_USAGE, "--compare"),
                ([self.mesh, "--compare", self.path / "c.json", "--coverage", "0.5", "--balls",
                  "3"], WRONG_USAGE, "--balls"),
                ([self.mesh, "--compare", self.path / "c.json", "--prune", "1"], WRONG_USAGE,
                 "--prune"),
                ([self.mesh, "--compare", self.path / "c.json", "--select", "covering"],
                 WRONG_USAGE, "--select"),
                ([self.mesh, "--compare", self.path / "no" / "c.json"], OUTPUT_NOT_WRITTEN,
                 "no/c.json"),
                ([self.path / "none.off"], UNUSABLE_INPUT, "none.off"),
                ([self.mesh, "-o", self.path / "no" / "b.ply"], OUTPUT_NOT_WRITTEN, "no/b.ply")]:
            with self.subTest(arguments=arguments):
                self.fail_with(code, [text], "medial", *arguments)


class Comparison(Test):

    def setUp(self):
        super().setUp()
        self.file = self.path / "comparison.json"

    def comparison(self, mesh, *arguments):
        self.succeed("medial", mesh, "--compare", self.file, *arguments)
        return json.loads(self.file.read_text(encoding="utf-8"))

    def test_of_a_torus_knows_its_ring(self):
        points, faces = torus(1, 0.3, 60, 20)
        result = self.comparison(self.write("torus.off", off(points, faces)))
        axes = {axis["name"]: axis for axis in result["representations"]}
        self.assertEqual(list(axes), ["unpruned", "mapt", "mapt_refitted", "lambda",
                                      "scale_axis", "random", "covering", "centerlines",
                                      "skeleton"])
        self.assertEqual(result["left_out"], [])
        self.assertEqual(result["shape"]["loops"], 1)
        for name, axis in axes.items():
            self.assertEqual(axis["topology"], result["shape"], name)
            solid = axis["volume"]["solid"]
            self.assertLess(abs(solid["value"] - volume_of(points, faces)), 5 * solid["error"])
            self.assertLess(solid["error"], 0.005 * solid["value"])
            error = axis["reconstruction"]
            self.assertLessEqual(error["missing"]["mean"], error["missing"]["largest"])
            self.assertLess(error["protrusion"]["quantile_95"], 0.2 * 0.3)
            correlation = axis["shape_diameter_correlation"]
            if correlation is not None:  # unknown of balls that are all alike
                self.assertLessEqual(abs(correlation), 1 + 1e-9)
            if name != "random":  # which runs out of balls that are apart
                self.assertGreaterEqual(axis["coverage"], 0.9 - 1e-9)
            for other, distances in axis["distances"].items():
                self.assertEqual(distances["there"], axes[other]["distances"][name]["back"])
                self.assertEqual(distances["hausdorff"], max(distances["there"]["largest"],
                                                             distances["back"]["largest"]))
                # Both are near the ring: within a fifth of the tube, and few balls are apart by
                # 0.6 of their radii, so that places between them are not farther than that.
                self.assertLess(distances["hausdorff"], 0.2 * 0.3)
        # Chosen balls are medial balls: none is farther from the axis than their samples.
        for name in ("mapt", "lambda", "scale_axis", "random", "covering"):
            self.assertEqual(axes[name]["off_centre"]["largest"], 0)

    def test_takes_as_many_balls_as_are_asked_for(self):
        mesh = self.write("torus.off", off(*torus(1, 0.3, 60, 20)))
        for axis in self.comparison(mesh, "--balls", "12")["representations"]:
            if axis["name"] in ("mapt", "lambda", "scale_axis", "random", "covering"):
                self.assertEqual(axis["balls"], 12)

    def test_says_what_is_left_out(self):
        points, faces = torus(1, 0.3, 60, 20)
        mesh = self.write("open.off", off(points, faces[1:]))
        result = self.succeed("medial", mesh, "--compare", self.file)
        self.assertIn("skeleton is left out", result.stderr)
        self.assertIn("3 edges have one face only", result.stderr)
        self.assertIn("covering", result.stdout)
        comparison = json.loads(self.file.read_text(encoding="utf-8"))
        self.assertEqual([entry["name"] for entry in comparison["left_out"]], ["skeleton"])
        self.assertIsNone(comparison["shape"])
        self.assertIsNone(comparison["representations"][0]["volume"]["overlap"])

    def test_of_a_plate_that_is_thinner_than_a_cell(self):
        corners = [(x, y, z) for x in (0, 10) for y in (0, 10) for z in (0, 0.02)]
        sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        plate = self.write("plate.off", off(corners, [(a, b, c) for a, b, c, _ in sides] +
                                                    [(a, c, d) for a, _, c, d in sides]))
        self.succeed("medial", plate, "--compare", self.path / "plate.json", "--balls", 3)
        # Balls of a twentieth of a cell hold none of its nodes, but once in a thousand times.
        result = self.succeed("medial", plate, "--reconstruct", self.path / "plate.stl", "--balls", 2,
                              "--select", "random", "--cell", 1)
        self.assertIn("the mesh of the balls is empty", result.stderr)

    def test_a_name_of_two_lines_does_not_end_the_header(self):
        mesh = self.write("two\nlines.off", off(self.points, self.faces))
        self.succeed("medial", mesh, "-o", self.path / "balls.ply")
        self.assertGreater(len(read_balls(self.path / "balls.ply")), 0)
        self.succeed("info", self.path / "balls.ply")

    def test_a_file_that_is_replaced_keeps_its_permissions(self):
        mesh = self.write("ball.off", off(self.points, self.faces))
        output = self.path / "balls.ply"
        output.write_text("", encoding="utf-8")
        output.chmod(0o600)
        self.succeed("medial", mesh, "-o", output)
        self.assertEqual(output.stat().st_mode & 0o777, 0o600)

    def test_does_not_depend_on_threads(self):
        mesh = self.write("open.off", off(self.points, self.faces[1:]))  # has no skeleton, CGAL's
        results = []
        for threads in "1", "2":
            result = self.comparison(mesh, "-j", threads)
            for axis in result["representations"]:
                del axis["seconds"]
            results.append(result)
        self.assertEqual(*results)


if __name__ == "__main__":
    unittest.main()
