# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt info."""

import math
import unittest

from mapt_test import Test, UNUSABLE_INPUT, area_of


class Info(Test):
    def test_sphere(self):
        info = self.report("info", self.sphere)
        self.assertEqual((info["type"], info["vertices"], info["faces"]),
                         ("mesh", len(self.points), len(self.faces)))
        self.assertTrue(info["is_closed"])
        self.assertEqual((info["genus"], info["components"], info["holes"]), (0, 1, 0))
        self.assertAlmostEqual(info["area"], area_of(self.points, self.faces), places=9)
        self.assertAlmostEqual(info["volume"], 4 / 3 * math.pi, delta=0.1)
        self.assertGreater(info["forecast"]["bytes"], 0)
        table = self.succeed("info", self.sphere).stdout
        for word in ("mesh", "box", "area", "volume", "transform", "evaluate"):
            self.assertIn(word, table)

    def test_map(self):
        for name in ("map.vti", "map.nrrd"):
            self.succeed("transform", self.sphere, "-R", "0.5,1", "--voxel", 0.1, "-o",
                         self.path / name)
            info = self.report("info", self.path / name)
            self.assertEqual(info["type"], "map")
            self.assertEqual(info["metadata"]["radii"], [0.5, 1])
            self.assertEqual(info["metadata"]["sigma"], [0.25, 0.5])
            self.assertEqual(info["metadata"]["source"], "sphere.off")
            for key in ("side", "normals", "method", "kernel", "region", "version"):
                self.assertTrue(info["metadata"][key], key)
            self.assertEqual(info["arrays"][1]["max"], 1)

    def test_bad_maps(self):
        for name, text in (("bad.vti", "nothing"), ("bad.nrrd", "nothing"), ("empty.vti", "")):
            self.fail_with(UNUSABLE_INPUT, [name], "info", self.write(name, text))
        self.fail_with(UNUSABLE_INPUT, ["none.vti"], "info", self.path / "none.vti")


if __name__ == "__main__":
    unittest.main()
