# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt transform: maps, their files, and what it says."""

import json
import math
import os
import pty
import signal
import struct
import subprocess
import unittest
import zlib

from mapt_test import (
    Test,
    DATA,
    INTERRUPTED,
    MAPT,
    OUTPUT_NOT_WRITTEN,
    SHELF,
    UNUSABLE_INPUT,
    area_of,
    icosphere,
    off,
)


class Transform(Test):
    def test_report(self):
        output, picture = self.path / "map.vti", self.path / "map.png"
        report = self.report("transform", self.sphere, "-o", output, "--picture", picture, "-R",
                             "1,0.6", "--voxel", 0.1)
        self.assertEqual(report["command"], "transform")
        self.assertEqual(report["exit_code"], 0)
        self.assertEqual(report["warnings"], [])
        self.assertEqual(report["input"]["file"], str(self.sphere))
        self.assertEqual(report["input"]["vertices"], len(self.points))
        self.assertEqual(report["parameters"]["radii"], [0.6, 1])
        self.assertEqual(report["parameters"]["sigma"], [0.3, 0.5])
        self.assertEqual(report["grid"]["spacing"], 0.1)
        self.assertLess(report["grid"]["region_voxels"], report["grid"]["voxels"])
        self.assertEqual(report["coverage"], 1)
        self.assertEqual(report["outputs"], [str(output), str(picture)])
        self.assertEqual(report["area_outside_percent"]["inside"], [0, 0])
        for key in ("forecast", "seconds", "peak_memory_bytes"):
            self.assertIn(key, report)
        self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))

    def test_strongest_maximum_is_the_centre(self):
        points, faces = icosphere(4, 2, (10, -3, 0.5))
        mesh = self.write("ball.off", off(points, faces))
        report = self.report("transform", mesh, "-R", 2, "--voxel", 0.1)
        first = report["maxima"][0]
        for axis, value in zip("xyz", (10, -3, 0.5)):
            self.assertAlmostEqual(first[axis], value, delta=0.1)
        self.assertEqual(first["radius"], 2)
        self.assertAlmostEqual(first["value"], area_of(points, faces) / (16 * math.pi), delta=1e-4)
        # all voxels that see the whole sphere are one maximum, and near it is no other
        for other in report["maxima"][1:]:
            self.assertGreaterEqual(
                math.dist([first[a] for a in "xyz"], [other[a] for a in "xyz"]), 1)

    def test_radii(self):
        def radii(*options):
            return self.report("transform", self.sphere, "--voxel", 0.1, *options)["parameters"]["radii"]

        def assert_near(values, expected):
            self.assertEqual(len(values), len(expected))
            for value, wanted in zip(values, expected):
                self.assertAlmostEqual(value, wanted, places=9)

        assert_near(radii("--radius-min", 0.2, "--radius-step", 0.1, "-n", 3), [0.2, 0.3, 0.4])
        assert_near(radii("--radius-min", 0.2, "--radius-max", 0.5, "--radius-step", 0.1),
                    [0.2, 0.3, 0.4, 0.5])
        assert_near(radii("--radius-min", 0.2, "--radius-max", 0.8, "-n", 3), [0.2, 0.4, 0.8])
        self.assertEqual(len(radii("-n", 5)), 5)
        default = radii()
        self.assertGreaterEqual(default[0] / 2, 0.1) # sigma is a voxel at least
        self.assertLess(max(b / a for a, b in zip(default, default[1:])), 1.25 + 1e-9)
        report = self.report("transform", self.sphere, "-R", "0.5,1", "--sigma", 0.2)
        self.assertEqual(report["parameters"]["sigma"], [0.2, 0.2])

    def test_kinds_and_sides(self):
        def names(*options):
            self.report("transform", self.sphere, "-R", "0.5,1", "--voxel", 0.2, *options, "-o",
                        self.path / "map.vti")
            return [array["name"] for array in self.report("info", self.path / "map.vti")["arrays"]]

        self.assertEqual(names(), ["JMAPT", "SMAPT"])
        self.assertEqual(names("--side", "both"),
                         ["JMAPT", "SMAPT", "JMAPT_outside", "SMAPT_outside"])
        self.assertEqual(names("--kind", "apt"), ["APT_0", "APT_1"])
        self.assertEqual(names("--kind", "mapt", "--side", "outside"), ["MAPT_0", "MAPT_1"])

    def test_apt_is_an_area(self):
        self.report("transform", self.sphere, "-R", 1, "--kind", "apt", "--voxel", 0.1, "-o",
                    self.path / "map.nrrd")
        array = self.report("info", self.path / "map.nrrd")["arrays"][0]
        self.assertAlmostEqual(array["max"], area_of(self.points, self.faces), places=4)

    def test_methods_agree(self):
        def best(*options):
            return self.report("transform", self.sphere, "-R", 1, "--voxel", 0.1,
                               *options)["maxima"][0]["value"]

        exact = best("--method", "exact")
        self.assertAlmostEqual(best(), exact, places=4)
        self.assertAlmostEqual(best("--method", "paper"), exact, places=4)
        self.assertAlmostEqual(best("--normals", "interpolated"), exact, places=4)
        for kernel in ("epanechnikov", "gaussian"):
            self.assertLessEqual(best("--kernel", kernel), exact + 1e-6)

    def test_outside_has_room(self):
        report = self.report("transform", self.sphere, "-R", "0.5,1", "--side", "outside", "--voxel",
                             0.2)
        self.assertLessEqual(report["grid"]["origin"][0], -1.99)
        self.assertEqual(report["parameters"]["region"], "all")
        self.assertEqual(report["area_outside_percent"]["outside"], [0, 0])

    def test_regions(self):
        sizes = {region: self.report("transform", self.sphere, "-R", 0.2, "--voxel", 0.1, "--region",
                                     region)["grid"]["region_voxels"]
                 for region in ("interior", "band", "all")}
        self.assertAlmostEqual(sizes["interior"] * 1e-3, 4 / 3 * math.pi, delta=0.15)
        self.assertLess(sizes["band"], sizes["all"])

    def test_threads_do_not_change_a_byte(self):
        for kind in ("vti", "nrrd"):
            files = []
            for threads in (1, 2):
                files.append(self.path / f"{threads}.{kind}")
                self.succeed("transform", DATA / "hand.obj", "-n", 3, "-j", threads, "-o", files[-1])
            self.assertEqual(files[0].read_bytes(), files[1].read_bytes())

    def test_nothing_found(self):
        # a plane has no interior
        plane = self.write("plane.off", off([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]))
        result = self.succeed("transform", plane, "--voxel", 0.1, "-R", 0.2)
        self.assertIn("Nothing found", result.stdout)
        self.assertIn("--region band or all", result.stderr)
        self.assertEqual(self.report("transform", plane, "--voxel", 0.1, "-R", 0.2)["maxima"], [])

    def test_too_large(self):
        for options in (["--voxel", 1e-4], ["--voxel", 1e-9], ["--voxel", 1e-30],
                        ["--max-memory", "10k"], ["--voxel", 1e-3, "--region", "all"],
                        ["--voxel", 2e-3, "--side", "outside"],
                        ["--voxel", 1e-3, "--region", "band"]):
            with self.subTest(options=options):
                self.fail_with(UNUSABLE_INPUT,
                               ["sphere.off", " voxels need ", "raise --voxel or raise --max-memory"],
                               "transform", self.sphere, "-R", 0.5, *options)
        self.report("transform", self.sphere, "--max-memory", "500M")

    def test_less_memory_takes_fewer_threads(self):
        report = self.report("transform", self.sphere, "-R", "0.5,1", "-j", 2)
        if report["parameters"]["threads"] < 2:
            self.skipTest("there is one thread only")
        one = self.report("transform", self.sphere, "-R", "0.5,1", "-j", 1)["forecast"]["bytes"]
        report = self.report("transform", self.sphere, "-R", "0.5,1", "-j", 2, "--max-memory",
                             int(one) + 1)
        self.assertEqual(report["parameters"]["threads"], 1)

    def test_outputs_that_cannot_be_written(self):
        (self.path / "folder.vti").mkdir()
        for name in ("nowhere/map.vti", "folder.vti"):
            self.fail_with(OUTPUT_NOT_WRITTEN, [name, "cannot be created"], "transform", self.sphere,
                           "-o", self.path / name)
        self.fail_with(OUTPUT_NOT_WRITTEN, ["map.png"], "transform", self.sphere, "--picture",
                       self.path / "nowhere" / "map.png")
        full = self.path / "full.vti"
        full.symlink_to("/dev/full")
        self.fail_with(OUTPUT_NOT_WRITTEN, ["full.vti"], "transform", self.sphere, "-R", 1, "-o", full)

    def test_full_standard_output(self):
        with open("/dev/full", "w", encoding="ascii") as stdout:
            result = subprocess.run([MAPT, "info", self.sphere], stdout=stdout, timeout=60,
                                    stderr=subprocess.PIPE, check=False)
        self.assertEqual(result.returncode, OUTPUT_NOT_WRITTEN)

    def test_output_is_replaced_and_a_failure_keeps_it(self):
        output = self.path / "map.vti"
        self.succeed("transform", self.sphere, "-R", 1, "-o", output)
        before = output.read_bytes()
        self.fail_with(UNUSABLE_INPUT, ["empty.off"], "transform", SHELF / "empty.off", "-o", output)
        self.assertEqual(output.read_bytes(), before)
        self.succeed("transform", self.sphere, "-R", 0.5, "-o", output)
        self.assertNotEqual(output.read_bytes(), before)

    def test_interruption_leaves_nothing(self):
        before = sorted(self.path.iterdir())
        command = subprocess.Popen(
            [MAPT, "transform", self.sphere, "-o", self.path / "map.vti", "--json", "-n", "255",
             "-j", "1", "--sampling-ratio", "0.03", "-v"],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertIn("is done", command.stderr.readline()) # the first of many radii
        command.send_signal(signal.SIGINT)
        out, err = command.communicate(timeout=120)
        self.assertEqual(command.returncode, INTERRUPTED, err)
        self.assertEqual(json.loads(out)["exit_code"], INTERRUPTED)
        self.assertIn("interrupted", err)
        self.assertEqual(sorted(self.path.iterdir()), before)

    def test_progress_is_for_terminals(self):
        master, slave = pty.openpty()
        subprocess.run([MAPT, "transform", self.sphere, "-R", "0.5,1"], stdout=subprocess.DEVNULL,
                       stderr=slave, timeout=60, check=True)
        os.close(slave)
        self.assertIn(b" %", os.read(master, 100000))
        os.close(master)
        self.assertEqual(self.succeed("transform", self.sphere, "-R", "0.5,1").stderr, "")

    def test_compression_is_an_option(self):
        for name, options in (("a.vti", []), ("b.vti", ["--no-compress"])):
            self.succeed("transform", self.sphere, "-R", 1, "-o", self.path / name, *options)
        self.assertLess((self.path / "a.vti").stat().st_size, (self.path / "b.vti").stat().st_size)

    def test_picture_is_whole(self):
        self.succeed("transform", self.sphere, "-R", 1, "--voxel", 0.05, "--picture",
                     self.path / "map.png")
        data = (self.path / "map.png").read_bytes()
        width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
        self.assertEqual((depth, kind), (8, 2))
        self.assertGreater(width, 600)
        self.assertGreater(height, 600)
        position, pixels = 8, b""
        while position < len(data):
            length = struct.unpack(">I", data[position:position + 4])[0]
            if data[position + 4:position + 8] == b"IDAT":
                pixels += data[position + 8:position + 8 + length]
            position += 12 + length
        self.assertEqual(len(zlib.decompress(pixels)), height * (3 * width + 1))


if __name__ == "__main__":
    unittest.main()
