# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt salient: centres of spheres and tubes."""

import csv
import io
import math
import struct
import unittest

from vtkmodules.vtkIOPLY import vtkPLYReader

from mapt_test import (Test, OUTPUT_NOT_WRITTEN, SHELF, UNUSABLE_INPUT, WRONG_USAGE, icosphere, off,
                       run)

COLUMNS = ("x,y,z,radius,scale,intensity,sphericity,blobness,flatness,vesselness,observed_fraction,"
           "type,axis_x,axis_y,axis_z,radius_low,radius_high,residual,voters,length,slope,"
           "curvature_x,curvature_y,curvature_z,one_sided,side").split(",")


def tube(radius, length, centre=(0, 0, 0), sides=48, rings=40):
    """An open cylinder along z: its vertices lie on it."""
    points, faces = [], []
    for ring in range(rings + 1):
        for side in range(sides):
            angle = 2 * math.pi * side / sides
            points.append((centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle),
                           centre[2] + length * (ring / rings - 0.5)))
    for ring in range(rings):
        for side in range(sides):
            a, b = ring * sides + side, ring * sides + (side + 1) % sides
            faces += [(a, b, b + sides), (a, b + sides, a + sides)]
    return points, faces


def union(*meshes):
    points, faces = [], []
    for more_points, more_faces in meshes:
        faces += [tuple(v + len(points) for v in face) for face in more_faces]
        points += more_points
    return points, faces


def turned(mesh):
    points, faces = mesh
    return points, [face[::-1] for face in faces]


def angle_between(row, axis):
    """In radians; an axis has no sign."""
    cosine = abs(sum(float(row["axis_" + name]) * c for name, c in zip("xyz", axis)))
    return math.acos(min(cosine, 1))


def read_ply(file):
    """The header lines, the faces, and the cell (or point) arrays, as VTK reads them."""
    reader = vtkPLYReader()
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


def properties_of(file, element):
    """The values of a binary PLY file, by property; lists are tuples. Written for the test."""
    types = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
             "float": "f", "double": "d"}
    data = file.read_bytes()
    header, body = data.split(b"end_header\n", 1)
    elements = []
    for line in header.decode("utf-8").splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append((words[-1], words[1:-1]))
    place, result = 0, {}

    def take(kind):
        nonlocal place
        value = struct.unpack_from("<" + types[kind], body, place)[0]
        place += struct.calcsize(types[kind])
        return value

    for name, number, properties in elements:
        for _ in range(number):
            for prop, kind in properties:
                value = (tuple(take(kind[2]) for _ in range(take(kind[1]))) if kind[0] == "list"
                         else take(kind[0]))
                if name == element:
                    result.setdefault(prop, []).append(value)
    assert place == len(body)
    return result


class Salient(Test):
    def rows(self, *arguments):
        table = csv.DictReader(io.StringIO(self.succeed("salient", *arguments).stdout))
        self.assertEqual(table.fieldnames, COLUMNS)
        return list(table)

    def mesh(self, name, mesh):
        return self.write(name, off(*mesh))

    def check_sphere(self, row, centre, radius):
        # The vertices lie on the sphere: what is left is rounding, and the floor of the interval.
        self.assertEqual(row["type"], "sphere")
        self.assertLess(math.dist([float(row[axis]) for axis in "xyz"], centre), 1e-5 * radius)
        self.assertAlmostEqual(float(row["radius"]), radius, delta=1e-5 * radius)
        self.assertLessEqual(float(row["radius_low"]), radius * (1 + 1e-9))
        self.assertGreaterEqual(float(row["radius_high"]), radius * (1 - 1e-9))
        # APT/(4πR²) over R is largest at R0/(1+c) = 2/3 R0, where it is (1+c)² = 9/4.
        self.assertAlmostEqual(float(row["scale"]), 2 / 3 * radius, delta=0.1 * radius)
        self.assertAlmostEqual(float(row["intensity"]), 2.25, delta=0.25)
        self.assertEqual((row["axis_x"], row["slope"], row["curvature_z"]), ("", "", ""))

    def test_sphere(self):
        mesh = icosphere(3, 2.5, (10, -3, 7))
        rows = self.rows(self.mesh("ball.off", mesh))
        self.assertEqual(len(rows), 1)
        self.check_sphere(rows[0], (10, -3, 7), 2.5)
        self.assertGreater(float(rows[0]["observed_fraction"]), 0.95)
        self.assertEqual((rows[0]["one_sided"], rows[0]["side"]), ("0", "inside"))
        self.assertGreater(int(rows[0]["voters"]), 0.9 * len(mesh[1]))
        self.assertLessEqual(int(rows[0]["voters"]), len(mesh[1]))

    def test_tube(self):
        # Open: a hole at each end, with as many edges as the tube has sides.
        rows = self.rows(self.mesh("tube.off", tube(0.5, 6, (1, 2, 3), rings=120)))
        self.assertEqual(len(rows), 1)
        row = rows[0]
        self.assertEqual(row["type"], "tube")
        self.assertAlmostEqual(float(row["radius"]), 0.5, delta=0.5e-4)
        self.assertLess(angle_between(row, (0, 0, 1)), 1e-3)
        self.assertLess(math.hypot(float(row["x"]) - 1, float(row["y"]) - 2), 1e-3)
        self.assertLess(abs(float(row["z"]) - 3), 3)
        self.assertGreater(float(row["length"]), 4)
        self.assertLess(float(row["length"]), 6.5)
        # On the axis of a tube the largest value over R is 0.55, at R = 0.851 of its radius, from a strip
        # that is 0.4 long. If it were summed over the vertices, one ring more or less would be an eighth.
        self.assertAlmostEqual(float(row["intensity"]), 0.55, delta=0.55 / 8)
        self.assertAlmostEqual(float(row["scale"]), 0.851 * 0.5, delta=0.1 * 0.5)

    def test_table_far_from_the_origin(self):
        # Coordinates as surveyors have them: the table tells places up to a thousandth of the radius.
        centre = (400_000.25, -5_200_000.5, 12.125)
        mesh = self.mesh("far.off", icosphere(3, 1, centre))
        table = self.succeed("salient", mesh, "-o", self.path / "points.csv").stdout
        lines = [line.split() for line in table.splitlines() if line.startswith("sphere")]
        self.assertEqual(len(lines), 1)
        for told, truth in zip(lines[0][1:4], centre):
            self.assertAlmostEqual(float(told), truth, delta=1e-3)

    def test_both_in_one_mesh(self):
        mesh = self.mesh("both.off", union(icosphere(3, 1, (5, 0, 0)), tube(0.4, 5)))
        rows = self.rows(mesh)
        self.assertEqual([row["type"] for row in rows], ["sphere", "tube"]) # the strongest first
        self.assertEqual([row["type"] for row in self.rows(mesh, "--type", "tube")], ["tube"])
        self.assertEqual(len(self.rows(mesh, "--type", "cone,tube,sphere")), 2)
        self.assertEqual([row["type"] for row in self.rows(mesh, "--threshold", "sphere")], ["sphere"])
        self.assertEqual([row["type"] for row in self.rows(mesh, "--threshold", 1)], ["sphere"])
        self.assertEqual([row["type"] for row in self.rows(mesh, "--radius-max", 0.6)], ["tube"])

    def test_sides(self):
        # A cavity, with faces that look into it, is found from outside of the surface.
        both = union(icosphere(3, 1, (5, 0, 0)), turned(icosphere(3, 0.5)), icosphere(4, 1.5))
        mesh = self.mesh("cavity.off", both)
        outside = self.rows(mesh, "--side", "outside")
        self.assertEqual(len(outside), 1)
        self.check_sphere(outside[0], (0, 0, 0), 0.5)
        self.assertEqual(outside[0]["side"], "outside")
        rows = self.rows(mesh, "--side", "both")
        self.assertEqual(sorted(row["side"] for row in rows), ["inside", "inside", "outside"])
        intensities = [float(row["intensity"]) for row in rows]
        self.assertEqual(intensities, sorted(intensities, reverse=True))

    def test_json_has_the_columns(self):
        output = self.path / "points.csv"
        result = self.report("salient", self.sphere, "-o", output)
        self.assertEqual(list(result["points"][0]), COLUMNS)
        with output.open(encoding="ascii", newline="") as file:
            row = next(csv.DictReader(file))
        for name, value in result["points"][0].items():
            if value is None:
                self.assertEqual(row[name], "", name)
            elif isinstance(value, str):
                self.assertEqual(row[name], value)
            else:
                self.assertEqual(float(row[name]), value, name)
        self.assertEqual(result["command"], "salient")
        self.assertEqual(result["counts"], {"sphere": 1, "tube": 0, "cone": 0, "other": 0})
        self.assertEqual(result["outputs"], [str(output)])
        self.assertEqual(result["parameters"]["mode"], "fitted")
        self.assertIsNone(result["parameters"]["radius_min"])
        self.assertGreater(result["peak_memory_bytes"], 0)
        self.assertIn("compute", result["seconds"])
        self.assertEqual(result["input"]["triangles"], len(self.faces))
        self.assertEqual(self.report("salient", self.sphere)["points"], result["points"])

    def test_stdout_is_the_table(self):
        output = self.path / "points.csv"
        table = self.succeed("salient", self.sphere, "-o", output)
        self.assertIn("1 sphere", table.stdout)
        self.assertIn("±", table.stdout)
        text = output.read_text(encoding="ascii")
        for more in ([], ["-o", "-"]):
            result = self.succeed("salient", self.sphere, *more)
            self.assertEqual((result.stdout, result.stderr), (text, ""))
        self.assertIn("1 sphere", self.succeed("salient", self.sphere, "-v").stderr)

    def test_nothing_found(self):
        square = self.mesh("square.off", ([(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)],
                                          [(0, 1, 2), (0, 2, 3)]))
        result = self.succeed("salient", square)
        self.assertEqual(result.stdout, ",".join(COLUMNS) + "\n")
        self.assertIn("nothing found", result.stderr)
        report = self.report("salient", square, "--voters", self.path / "voters.ply", "--picture",
                             self.path / "picture.png")
        self.assertEqual(report["points"], [])
        self.assertIn("nothing found", report["warnings"][-1])
        self.assertEqual(set(properties_of(self.path / "voters.ply", "face")["salient_point"]), {-1})

    def test_voters(self):
        points, faces = union(icosphere(3, 1, (5, 0, 0)), tube(0.4, 5))
        mesh, voters = self.mesh("both.off", (points, faces)), self.path / "voters.ply"
        found = self.report("salient", mesh, "--voters", voters)["points"]
        vertices, cells = properties_of(voters, "vertex"), properties_of(voters, "face")
        self.assertEqual(list(zip(vertices["x"], vertices["y"], vertices["z"])),
                         [tuple(map(float, p)) for p in points])
        self.assertEqual(cells["vertex_indices"], faces)
        self.assertEqual(cells["source_face"], list(range(len(faces))))
        for i, point in enumerate(found):
            self.assertEqual(cells["salient_point"].count(i), point["voters"])
        # The faces of the sphere came first.
        sphere = cells["salient_point"][:1280]
        self.assertEqual(max(sphere), 0)
        self.assertGreater(sphere.count(0), 1100)
        colours = {}
        for colour in zip(cells["salient_point"], cells["red"], cells["green"], cells["blue"]):
            colours.setdefault(colour[0], set()).add(colour[1:])
        self.assertTrue(all(len(of_point) == 1 for of_point in colours.values()), colours)
        (sphere_red, _, sphere_blue), = colours[0]
        (tube_red, _, tube_blue), = colours[1]
        self.assertGreater(sphere_red, sphere_blue)
        self.assertLess(tube_red, tube_blue)

    def test_voters_in_the_hands_of_vtk(self):
        voters = self.path / "voters.ply"
        self.succeed("salient", self.sphere, "--voters", voters, "-q")
        data = read_ply(voters)
        self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfPolys()),
                         (len(self.points), len(self.faces)))
        colours = data.GetCellData().GetArray("RGB")
        self.assertEqual((colours.GetNumberOfTuples(), colours.GetNumberOfComponents()),
                         (len(self.faces), 3))

    def test_voters_of_polygons_and_of_faces_left_out(self):
        # Quadrilaterals around an axis; the second face is a line.
        points, _ = tube(0.5, 6)
        sides = 48
        polygons = []
        for a in range(len(points) - sides):
            b = a + 1 if (a + 1) % sides else a + 1 - sides
            polygons.append((a, b, b + sides, a + sides))
        polygons.insert(1, (0, 1, 0))
        mesh, voters = self.write("quads.off", off(points, polygons)), self.path / "voters.ply"
        self.succeed("salient", mesh, "--voters", voters)
        cells = properties_of(voters, "face")
        expected = [0, 0] + [face for face in range(2, len(polygons)) for _ in range(2)]
        self.assertEqual(cells["source_face"], expected)
        for corners, face in zip(cells["vertex_indices"], cells["source_face"]):
            self.assertLessEqual(set(corners), set(polygons[face]))

    def test_points(self):
        lines = "".join("%r %r %r %r %r %r\n" % (*p, *p) for p in self.points)
        null = "3 3 3 0 0 0\n" # without a normal: left out
        voters = self.path / "voters.ply"
        found = self.report("salient", self.write("points.xyz", null + lines), "--voters", voters)
        self.assertEqual([p["type"] for p in found["points"]], ["sphere"])
        self.assertAlmostEqual(found["points"][0]["radius"], 1, delta=1e-4)
        vertices = properties_of(voters, "vertex")
        self.assertEqual(vertices["source_point"], list(range(1, len(self.points) + 1)))
        self.assertEqual(vertices["salient_point"].count(0), found["points"][0]["voters"])
        plain = self.write("plain.xyz", "".join("%r %r %r\n" % p for p in self.points))
        self.fail_with(UNUSABLE_INPUT, ["plain.xyz", "--estimate-normals"], "salient", plain)
        found = self.report("salient", plain, "--estimate-normals")
        self.assertEqual([p["type"] for p in found["points"]], ["sphere"])

    def test_paper(self):
        # Maxima of the maps, with their raw scale: around 2/3 of the radius, in steps of a tenth.
        for mode in ("paper", "joint"):
            found = self.report("salient", self.sphere, "--mode", mode, "--radius-min", 0.1)["points"]
            self.assertGreater(len(found), 0)
            strongest = found[0]
            self.assertLess(math.dist([strongest[a] for a in "xyz"], (0, 0, 0)), 0.2)
            self.assertGreaterEqual(strongest["intensity"], 0.2)
            self.assertAlmostEqual(strongest["scale"], 2 / 3, delta=0.2)
            self.assertEqual((strongest["type"], strongest["residual"]), ("other", None))
        for option in (["--voters", self.path / "v.ply"], ["--type", "tube"], ["--tube-spacing", 2]):
            self.fail_with(WRONG_USAGE, [option[0], "--mode paper"], "salient", self.sphere, "--mode",
                           "paper", *option)

    def test_picture(self):
        holed = self.mesh("holed.off", (self.points, self.faces[40:]))
        for mesh in (self.sphere, holed):
            picture = self.path / "picture.png"
            self.succeed("salient", mesh, "--picture", picture, "-o", self.path / "points.csv")
            data = picture.read_bytes()
            self.assertTrue(data.startswith(b"\x89PNG"))
            width, height = struct.unpack(">II", data[16:24])
            self.assertGreaterEqual(width, 1400)
            self.assertGreater(height, 600)

    def test_threads_do_not_change_a_bit(self):
        mesh = self.mesh("both.off", union(icosphere(3, 1, (5, 0, 0)), tube(0.4, 5)))
        self.assertEqual(*(self.succeed("salient", mesh, "-j", threads).stdout for threads in (1, 2)))

    def test_usage(self):
        for parts, options in (
                (["--threshold", "moon", "sphere, hemisphere, tube, slab"], ["--threshold", "moon"]),
                (["--threshold", "-1"], ["--threshold", -1]),
                (["--radius-min", "0"], ["--radius-min", 0]),
                (["--radius-min is 2", "--radius-max, 1"], ["--radius-min", 2, "--radius-max", 1]),
                (["--tube-spacing", "0"], ["--tube-spacing", 0]),
                (["--type", "cube"], ["--type", "tube,cube"]),
                (["--mode", "best"], ["--mode", "best"]),
                (["--side", "up"], ["--side", "up"]),
                (["--voters", ".ply"], ["--voters", self.path / "voters.obj"]),
                (["--picture", ".png"], ["--picture", self.path / "picture.jpg"]),
                (["--threads", "0"], ["-j", 0]),
                (["--voxel", "there is no option"], ["--voxel", 1]),
                (["replace the input"], ["-o", self.sphere]),
                (["twice"], ["-o", self.path / "a.ply", "--voters", self.path / "a.ply"])):
            with self.subTest(options=options):
                self.fail_with(WRONG_USAGE, parts, "salient", self.sphere, *options)
        self.fail_with(WRONG_USAGE, ["--json"], "salient", self.sphere, "-o", "-", "--json")
        self.fail_with(WRONG_USAGE, ["MESH", "required"], "salient")

    def test_files_that_cannot_be_read_or_written(self):
        self.fail_with(UNUSABLE_INPUT, ["nowhere.off"], "salient", self.path / "nowhere.off", "-o",
                       self.path / "points.csv")
        self.fail_with(UNUSABLE_INPUT, ["nan_vertex.off"], "salient", SHELF / "nan_vertex.off")
        for option, name in (("-o", "p.csv"), ("--voters", "v.ply"), ("--picture", "p.png")):
            # found out before anything is written
            self.fail_with(OUTPUT_NOT_WRITTEN, [name], "salient", self.sphere, option,
                           self.path / "nowhere" / name, *(["-o", self.path / "points.csv"]
                                                           if option != "-o" else []))

    def test_help(self):
        result = run("salient", "--help")
        self.assertLessEqual(max(map(len, result.stdout.splitlines())), 80)
        self.assertIn("--tube-spacing NUMBER", result.stdout)


if __name__ == "__main__":
    unittest.main()
