# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt report: what is in the page agrees with the other commands, and the page keeps to itself."""

import base64
import hashlib
import re
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from mapt_test import DATA, OUTPUT_NOT_WRITTEN, Test, UNUSABLE_INPUT, WRONG_USAGE, off
from report_file import Report


def arrays_of(vti):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(vti))
    reader.Update()
    image = reader.GetOutput()
    shape = image.GetDimensions()[::-1]
    data = image.GetPointData()
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)).reshape(shape)
            for i in range(data.GetNumberOfArrays())}


class Reports(Test):

    def setUp(self):
        super().setUp()
        self.page = self.path / "page.html"

    def make(self, mesh, *arguments):
        report = self.report("report", mesh, "-o", self.page, "--resolution", "32", *arguments)
        return report, Report(self.page)


class Contents(Reports):

    def test_maps_are_those_of_transform(self):
        _, page = self.make(self.sphere)
        voxel = repr(page.json["grid"]["spacing"])
        for kind, entries in [("jmapt", [page.json["maps"]["joint"]]), ("mapt", page.json["maps"]["of_radii"])]:
            file = self.path / "map.vti"
            self.succeed("transform", self.sphere, "-o", file, "--kind", kind, "--voxel", voxel)
            arrays = arrays_of(file)
            names = ["JMAPT"] if kind == "jmapt" else [f"MAPT_{k}" for k in range(len(entries))]
            for name, entry in zip(names, entries, strict=True):
                stride = entry["stride"]
                expected = arrays[name][::stride, ::stride, ::stride]
                shown = page.voxels(entry["voxels"]) * (entry["largest"] / 255)
                # A sphere is convex: the voxels that have storage are those inside. Half a step of 8 bits.
                self.assertLess(abs(shown - expected).max(), entry["largest"] / 509)
                self.assertGreater(entry["largest"], 0)

    def test_maps_of_large_radii_have_every_second_voxel(self):
        _, page = self.make(self.sphere)
        voxel = page.json["grid"]["spacing"]
        strides = [(m["sigma"] / voxel, m["stride"]) for m in page.json["maps"]["of_radii"]]
        self.assertEqual({stride for _, stride in strides}, {1, 2})
        for sigma, stride in strides:
            self.assertEqual(stride, 2 if sigma >= 4 else 1)

    def test_surface_is_the_mesh(self):
        _, page = self.make(self.sphere)
        surface = page.json["surface"]
        points, corners = page.points(surface["points"]), page.integers(surface["triangles"])
        # 65536 places along the longest side.
        step = 2 / 65535
        self.assertAlmostEqual(page.json["lattice"]["step"], step, delta=1e-3 * step)
        expected = numpy.array(self.points)[numpy.array(self.faces)]
        self.assertLess(abs(points[corners] - expected).max(), 0.51 * step)
        self.assertEqual(surface["holes"]["number"], 0)
        self.assertEqual(surface["joined_within"], 0)

    def test_edges_of_holes_are_there(self):
        open_sphere = self.write("open.off", off(self.points, self.faces[1:]))
        report, page = self.make(open_sphere)
        self.assertEqual(report["input"]["boundary_edges"], 3)
        ends = page.points(page.json["surface"]["holes"]).reshape(-1, 3)
        corners = numpy.array(self.points)[list(self.faces[0])]
        self.assertEqual(len(ends), 6)
        for end in ends:
            self.assertLess(numpy.linalg.norm(corners - end, axis=1).min(), 1e-4)

    def test_salient_points_are_those_of_salient(self):
        report, page = self.make(self.sphere)
        points = self.report("salient", self.sphere)["points"]
        self.assertEqual(page.json["salient"], points)
        self.assertEqual(report["salient"], points)
        self.assertEqual(points[0]["type"], "sphere")

    def test_medial_balls_of_a_sphere_are_the_sphere(self):
        report, page = self.make(self.sphere)
        medial = page.json["medial"]
        self.assertEqual(report["medial"]["balls"], medial["found"])
        self.assertEqual(report["medial"]["shown"], len(page.floats(medial["radii"])))
        # The first one is the most important. Edges are 0.14 long; facets lie inside by half of its square over 4.
        self.assertLess(numpy.linalg.norm(page.points(medial["points"])[0]), 0.01)
        self.assertAlmostEqual(page.floats(medial["radii"])[0], 1, delta=0.01)
        self.assertAlmostEqual(page.floats(medial["mapt"])[0], 1, delta=0.02)
        importance = page.floats(medial["importance"])
        self.assertTrue((importance[:-1] >= importance[1:]).all())

    def test_lines_are_those_of_lines(self):
        tube = self.write("tube.off", off([(x, y, 6 * z) for x, y, z in self.points], self.faces))
        report, page = self.make(tube)
        expected = self.report("lines", tube)["lines"]["branches"]
        self.assertGreater(len(expected), 0)
        self.assertEqual(report["lines"]["branches"], len(expected))
        lines = page.json["lines"]
        for shown, branch in zip(lines["branches"], expected, strict=True):
            for key in ("points", "length", "mean_radius", "score"):
                self.assertEqual(shown[key], branch[key])
        points = page.points(lines["points"])
        self.assertEqual(len(points), sum(b["points"] for b in lines["branches"]))
        self.assertEqual(len(page.floats(lines["radii"])), len(points))
        # The axis is that of z; it bends by no more than a fraction of the least radius of the ellipsoid.
        self.assertLess(abs(points[:, :2]).max(), 0.1)

    def test_descriptor_is_that_of_describe(self):
        _, page = self.make(self.sphere)
        table = self.path / "hapt.csv"
        self.succeed("describe", self.sphere, "-o", table)
        expected = [float(x) for x in table.read_text().splitlines()[1].split(",")[1:]]
        numpy.testing.assert_allclose(page.json["descriptor"]["values"], expected, atol=1e-7)

    def test_arrays_do_not_depend_on_threads(self):
        _, one = self.make(self.sphere, "-j", "1")
        _, two = self.make(self.sphere, "-j", "2")
        self.assertEqual(one.arrays, two.arrays)

    def test_parts_can_be_left_out(self):
        report, page = self.make(self.sphere, "--leave-out", "salient,lines,medial,descriptor,lines")
        for part in ("salient", "lines", "medial", "descriptor"):
            self.assertIsNone(page.json[part])
            self.assertNotIn(part, report)
        self.assertEqual(list(report["steps"]), ["maps"])
        self.assertEqual(report["parameters"]["left_out"], ["descriptor", "lines", "medial", "salient"])

    def test_large_meshes_are_drawn_coarser(self):
        report, page = self.make(self.sphere, "--most-faces", "300")
        corners = page.integers(page.json["surface"]["triangles"])
        self.assertEqual(report["page"]["faces"], len(corners))
        self.assertTrue(100 < len(corners) <= 300, len(corners))
        self.assertGreater(page.json["surface"]["joined_within"], 0)
        points = page.points(page.json["surface"]["points"])
        self.assertLess(abs(numpy.linalg.norm(points, axis=1) - 1).max(), 1e-4)
        text = self.succeed("report", self.sphere, "-o", self.page, "--most-faces", "300").stdout
        self.assertIn(f"draws {len(corners)} of 1280 faces", text)

    def test_without_a_page_there_is_a_summary(self):
        text = self.succeed("report", self.sphere).stdout
        for word in ("maps", "salient", "lines", "balls", "hapt", "nothing: name a page with -o"):
            self.assertIn(word, text)
        self.assertEqual(sorted(f.name for f in self.path.iterdir()), ["sphere.off"])


class Inputs(Reports):

    def test_points_with_normals(self):
        rows = [" ".join(map(repr, (*p, *p))) for p in self.points]  # of the unit sphere
        cloud = self.write("cloud.xyz", "\n".join(rows) + "\n")
        _, page = self.make(cloud)
        self.assertTrue(page.json["is_point_set"])
        self.assertEqual(page.json["surface"]["triangles"]["number"], 0)
        self.assertEqual(len(page.points(page.json["surface"]["points"])), len(self.points))
        self.assertEqual(page.json["descriptor"], {"missing": "a descriptor needs faces"})

    def test_a_surface_that_encloses_nothing(self):
        flat = self.write("flat.off", off([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)]))
        report, page = self.make(flat)
        self.assertIn("no voxel is inside", " ".join(report["warnings"]))
        self.assertIn("missing", page.json["descriptor"])
        self.assertEqual(page.json["parameters"]["region"], "all")

    def test_refuses_what_it_cannot_do(self):
        bad = self.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n")
        for arguments, code, text in [
                ([self.sphere, "-o", self.path / "page.txt"], WRONG_USAGE, ".html"),
                ([self.sphere, "--resolution", "4"], WRONG_USAGE, "--resolution"),
                ([self.sphere, "--leave-out", "maps"], WRONG_USAGE, "--leave-out"),
                ([self.sphere, "--radii", "0.001"], WRONG_USAGE, "smaller than the voxel"),
                ([bad, "-o", self.page], UNUSABLE_INPUT, "bad.off"),
                ([self.path / "none.off", "-o", self.page], UNUSABLE_INPUT, "none.off"),
                ([self.sphere, "-o", self.page, "--max-memory", "1k"], UNUSABLE_INPUT,
                 "; lower --resolution or raise --max-memory"),
                ([self.sphere, "-o", self.path / "no" / "page.html"], OUTPUT_NOT_WRITTEN, "no/page.html")]:
            with self.subTest(arguments=arguments):
                self.fail_with(code, [text], "report", *arguments)

    def test_a_page_that_is_there_stays_if_the_mesh_is_bad(self):
        self.page.write_text("mine")
        bad = self.write("bad.off", "OFF\n1 1 0\n0 0 0\n3 0 1 2\n")
        self.fail_with(UNUSABLE_INPUT, ["bad.off"], "report", bad, "-o", self.page)
        self.assertEqual(self.page.read_text(), "mine")


class Page(Reports):

    def test_asks_nothing_of_the_network(self):
        _, page = self.make(self.sphere)
        for tag, attributes, _ in page.page.elements:
            self.assertFalse({"src", "href", "srcset", "action", "data", "style"} & set(attributes), (tag, attributes))
            self.assertNotIn(tag, ("link", "base", "iframe", "object", "embed", "form", "img"))
        style = "".join(text for _, _, text in page.page.find("style"))
        self.assertNotRegex(style, r"url\(|@import")

    def test_allows_its_own_script_and_style_only(self):
        _, page = self.make(self.sphere)
        policy = page.page.find("meta", **{"http-equiv": "Content-Security-Policy"})[0][1]["content"]

        def digest(text):
            return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"

        script = page.page.find("script", type="module")[0][2]
        style = page.page.find("style")[0][2]
        self.assertEqual(policy.split("; ")[:3],
                         ["default-src 'none'", "script-src " + digest(script), "style-src " + digest(style)])
        self.assertNotIn("unsafe", policy)

    def test_names_are_text(self):
        name = "a&'\"<!--<script>alert(1)<.off"
        mesh = self.write(name, off(self.points, self.faces[1:]))
        _, page = self.make(mesh)
        self.assertEqual(page.json["name"], name)
        scripts = [attributes.get("id") or attributes["type"] for _, attributes, _ in page.page.find("script")]
        self.assertEqual(scripts, ["report", "arrays", "module"])
        inside = re.search(r'<script id="report"[^>]*>(.*?)</script>', page.text, re.S).group(1)
        self.assertNotIn("<", inside)

    def test_does_not_tell_where_the_mesh_was(self):
        inward = [(b, a, c) for a, b, c in self.faces]
        _, page = self.make(self.write("inward.off", off(self.points, inward)))
        self.assertTrue(page.json["warnings"][0].startswith("inward.off: "), page.json["warnings"])
        self.assertNotIn(str(self.path), page.text)

    def test_of_a_hand_is_small(self):
        self.succeed("report", DATA / "hand.obj", "-o", self.page)
        page = Report(self.page)
        self.assertEqual(max(page.json["grid"]["size"]), 129)
        self.assertLess(self.page.stat().st_size, 2_000_000)


if __name__ == "__main__":
    unittest.main()
