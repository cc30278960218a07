# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The command mapt as its users meet it: arguments, messages, exit codes, files, values.

The environment names the command (MAPT) and the folder of the bundled meshes (MAPT_DATA).
"""

import csv
import io
import json
import math
import os
import pathlib
import pty
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

MAPT = os.environ.get("MAPT", "mapt")
DATA = pathlib.Path(os.environ.get("MAPT_DATA", "data"))
SHELF = pathlib.Path(__file__).parent / "data"

DONE, WRONG_USAGE, UNUSABLE_INPUT, OUTPUT_NOT_WRITTEN, INTERRUPTED = 0, 2, 3, 4, 130


def run(*arguments):
    return subprocess.run([MAPT, *map(str, arguments)], capture_output=True, text=True, timeout=300,
                          check=False)


def icosphere(subdivisions, radius=1.0, centre=(0, 0, 0)):
    """Points on a sphere and triangles with outward normals."""
    t = (1 + math.sqrt(5)) / 2
    points = [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t),
              (0, -1, -t), (0, 1, -t), (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(subdivisions):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(tuple(s + t for s, t in zip(unit(points[a]), unit(points[b]))))
            return middles[key]

        faces = [f for a, b, c in faces for ab, bc, ca in [(middle(a, b), middle(b, c), middle(c, a))]
                 for f in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))]
    return [tuple(c + radius * x for c, x in zip(centre, unit(p))) for p in points], faces


def unit(p):
    length = math.sqrt(sum(x * x for x in p))
    return tuple(x / length for x in p)


def area_of(points, faces):
    total = 0.0
    for a, b, c in faces:
        u = [q - p for p, q in zip(points[a], points[b])]
        v = [q - p for p, q in zip(points[a], points[c])]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        total += math.sqrt(sum(x * x for x in n)) / 2
    return total


def off(points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(repr, map(float, p))) for p in points]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    return "\n".join(lines) + "\n"


class Test(unittest.TestCase):
    """A folder of its own, with a sphere in it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.points, self.faces = icosphere(3)
        self.sphere = self.write("sphere.off", off(self.points, self.faces))

    def write(self, name, text):
        (self.path / name).write_text(text, encoding="utf-8")
        return self.path / name

    def succeed(self, *arguments):
        result = run(*arguments)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return result

    def report(self, *arguments):
        return json.loads(self.succeed(*arguments, "--json").stdout)

    def fail_with(self, code, parts, *arguments):
        """One line with all the parts, in plain words and as JSON; nothing is left in the folder."""
        before = sorted(self.path.iterdir())
        for more in ([], ["--json"]):
            result = run(*arguments, *more)
            self.assertEqual(result.returncode, code, result.stderr)
            lines = [line for line in result.stderr.splitlines() if "warning" not in line]
            self.assertEqual(len(lines), 1, result.stderr)
            self.assertTrue(lines[0].startswith("mapt: error: "), lines[0])
            for part in parts:
                self.assertIn(part, lines[0])
            if more:
                answer = json.loads(result.stdout)
                self.assertEqual(answer["exit_code"], code)
                self.assertEqual("mapt: error: " + answer["error"], lines[0])
            elif "--json" not in arguments:
                self.assertNotIn("error", result.stdout)
        self.assertEqual(sorted(self.path.iterdir()), before)


class Usage(Test):
    def test_help(self):
        for command in ("", "transform", "evaluate", "info"):
            result = self.succeed(*command.split(), "--help")
            self.assertIn("sage: mapt", result.stdout)
            self.assertLessEqual(max(map(len, result.stdout.splitlines())), 80)
            self.assertEqual(result.stderr, "")
        self.assertIn("--max-memory BYTES", self.succeed("transform", "--help").stdout)
        self.assertIn("(default: 0.5)", self.succeed("transform", "--help").stdout)

    def test_version(self):
        for command in ("", "transform", "evaluate", "info"):
            self.assertRegex(self.succeed(*command.split(), "--version").stdout,
                             r"^mapt \d+\.\d+\.\d+\n$")

    def test_commands(self):
        self.fail_with(WRONG_USAGE, ["'trasform'", "did you mean transform?"], "trasform")
        self.fail_with(WRONG_USAGE, ["'frobnicate'", "mapt --help"], "frobnicate")
        result = run()
        self.assertEqual(result.returncode, WRONG_USAGE)
        self.assertIn("a command is missing", result.stderr)

    def test_options(self):
        transform = ("transform", self.sphere)
        for parts, options in (
                (["--vocsel", "did you mean --voxel?"], ["--vocsel", 1]),
                (["'other.off'", "too many"], ["other.off"]),
                (["--radii", "-1", "positive"], ["-R", "-1"]),
                (["--radii", "0", "positive"], ["--radii", "0.5,0"]),
                (["--radii", "nan", "positive"], ["--radii", "nan"]),
                (["--radii", "twice"], ["--radii", "0.5,0.5"]),
                (["--radius-min", "-2"], ["--radius-min", -2]),
                (["--radius-min", "3", "--radius-max", "2"],
                 ["--radius-min", 3, "--radius-max", 2]),
                (["--radius-step", "contradict"],
                 ["--radius-step", 0.1, "-n", 3, "--radius-max", 2]),
                (["too many", "--radius-step"], ["--radius-step", 1e-5]),
                (["--scales", "0"], ["-n", 0]),
                (["--scales", "2.5"], ["-n", 2.5]),
                (["--radii", "--scales"], ["-R", 1, "-n", 2]),
                (["--sigma-ratio", "1 is", "less than 1"], ["-c", 1]),
                (["--sigma-ratio", "0 is", "greater than 0"], ["-c", 0]),
                (["--sigma", "-1"], ["--sigma", -1]),
                (["--sigma", "--sigma-ratio"], ["--sigma", 1, "-c", 0.5]),
                (["--voxel", "0", "positive"], ["--voxel", 0]),
                (["radius 0.3", "smaller than the voxel, 0.5", "--voxel"],
                 ["-R", 0.3, "--voxel", 0.5]),
                (["--margin", "-1"], ["--margin", -1]),
                (["--side", "up", "inside"], ["--side", "up"]),
                (["--normals", "vertex"], ["--normals", "vertex"]),
                (["--smoothing-ratio", "face"], ["--smoothing-ratio", 0.2]),
                (["--smoothing-ratio", "0"], ["--normals", "averaged", "--smoothing-ratio", 0]),
                (["--compensate", "interior"], ["--compensate", "--region", "all"]),
                (["--method exact", "interpolated"],
                 ["--method", "exact", "--normals", "interpolated"]),
                (["--kernel", "cube"], ["--kernel", "cube"]),
                (["--kind", "hapt"], ["--kind", "hapt"]),
                (["--region", "moon"], ["--region", "moon"]),
                (["--sampling-ratio", "0"], ["--sampling-ratio", 0]),
                (["--threads", "0"], ["-j", 0]),
                (["--max-memory", "lots"], ["--max-memory", "lots"]),
                (["nowhere.toml"], ["--config", self.path / "nowhere.toml"]),
                (["--output", "map.vtk", ".vti or .nrrd"], ["-o", self.path / "map.vtk"]),
                (["--picture", "map.jpg", ".png"], ["--picture", self.path / "map.jpg"])):
            with self.subTest(options=options):
                self.fail_with(WRONG_USAGE, parts, *transform, *options)
        self.fail_with(WRONG_USAGE, ["MESH", "required"], "transform")
        self.fail_with(WRONG_USAGE, ["FILE", "required"], "info")
        self.fail_with(WRONG_USAGE, ["--at", "required"], "evaluate", self.sphere)

    def test_config(self):
        config = self.write("mapt.toml", "radii = [0.5, 1]\nvoxel = 0.1\nside = 'both'\n")
        parameters = self.report("transform", self.sphere, "--config", config)["parameters"]
        self.assertEqual(parameters["radii"], [0.5, 1])
        self.assertEqual((parameters["voxel"], parameters["side"]), (0.1, "both"))
        parameters = self.report("transform", self.sphere, "--config", config, "--voxel", 0.2)
        self.assertEqual(parameters["parameters"]["voxel"], 0.2)
        config = self.write("bad.toml", "vocsel = 1\n")
        self.fail_with(WRONG_USAGE, ["vocsel"], "transform", self.sphere, "--config", config)

    def test_quiet_and_verbose(self):
        mixed = SHELF / "mixed_orientation.off"
        result = self.succeed("transform", mixed, "--voxel", 0.1, "-q", "-v")
        self.assertEqual((result.stdout, result.stderr), ("", ""))
        result = self.succeed("transform", mixed, "--voxel", 0.1)
        self.assertIn("mapt: warning: ", result.stderr)
        result = self.succeed("transform", self.sphere, "-R", 1, "--voxel", 0.1, "-v")
        self.assertIn("radius 1 is done", result.stderr)


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
        for options in (["--voxel", 1e-4], ["--voxel", 1e-9], ["--voxel", 1e-300],
                        ["--max-memory", "10k"], ["--voxel", 1e-3, "--region", "all"],
                        ["--voxel", 2e-3, "--side", "outside"],
                        ["--voxel", 1e-3, "--region", "band"]):
            with self.subTest(options=options):
                self.fail_with(UNUSABLE_INPUT,
                               ["sphere.off", " voxels need ", "raise --voxel or --max-memory"],
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

    def test_missing_faces_are_compensated(self):
        half = self.write("half.off", off(self.points, self.faces[::2]))
        plain = self.report("transform", half, "-R", 1, "--voxel", 0.1)
        compensated = self.report("transform", half, "-R", 1, "--voxel", 0.1, "--compensate")
        self.assertAlmostEqual(compensated["maxima"][0]["value"],
                               plain["maxima"][0]["value"] / plain["coverage"], places=5)
        self.assertAlmostEqual(plain["coverage"], 0.5, delta=0.03)
        self.assertAlmostEqual(compensated["maxima"][0]["value"], 1, delta=0.1)
        self.assertEqual(self.best(self.sphere, "--compensate"), self.best(self.sphere))


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


class Points(Test):
    """Points without normals, which are estimated if that is asked for."""

    def setUp(self):
        super().setUp()
        lines = [" ".join(map(repr, p)) for p in self.points]
        self.text = "\n".join(lines) + "\n"
        self.plain = self.write("plain.xyz", self.text)
        self.table = self.write("at.csv", "x,y,z,radius\n0,0,0,1\n")

    def test_formats(self):
        number, lines = len(self.points), self.text.splitlines()
        vtp = ('<?xml version="1.0"?><VTKFile type="PolyData" version="0.1" '
               'byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="%d" NumberOfPolys="0">'
               '<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">%s'
               '</DataArray></Points></Piece></PolyData></VTKFile>' % (number, self.text))
        ply = "ply\nformat ascii 1.0\nelement vertex %d\n" % number
        ply += "".join("property double %s\n" % axis for axis in "xyz") + "end_header\n"
        for name, text in (("points.xyz", self.text), ("points.off", off(self.points, [])),
                           ("points.obj", "".join("v " + line + "\n" for line in lines)),
                           ("points.ply", ply + self.text), ("points.vtp", vtp)):
            with self.subTest(name=name):
                file = self.write(name, text)
                report = self.report("evaluate", file, "--at", self.table, "--estimate-normals")
                # all points meet at the centre, and share the area of the sphere
                self.assertAlmostEqual(report["results"][0]["apt"] / (4 * math.pi), 1, delta=0.02)
                self.assertTrue(report["input"]["normals_estimated"])
                self.assertEqual(report["input"]["normal_neighbours"], 18)
                self.assertEqual(report["input"]["points_unoriented"], 0)
                self.assertEqual(report["input"]["components"], 1)
                self.assertEqual(len(report["warnings"]), 1)
                self.assertIn("18 neighbours", report["warnings"][0])

    def test_without_the_option(self):
        for command, more in (("info", []), ("transform", []), ("evaluate", ["--at", self.table])):
            self.fail_with(UNUSABLE_INPUT, ["plain.xyz", "no normals", "--estimate-normals"], command,
                           self.plain, *more)
        self.assertFalse(self.report("info", SHELF / "points_with_normals.xyz")["normals_estimated"])

    def test_where_it_makes_no_sense(self):
        map_file = self.path / "map.vti"
        self.succeed("transform", self.sphere, "-R", 1, "--voxel", 0.5, "-o", map_file)
        for file, part in ((self.sphere, "faces"), (SHELF / "points_with_normals.xyz", "normals"),
                           (map_file, "map")):
            self.fail_with(WRONG_USAGE, ["--estimate-normals", file.name, part, "leave it out"], "info",
                           file, "--estimate-normals")

    def test_info_and_transform(self):
        info = self.report("info", self.plain, "--estimate-normals")
        self.assertEqual((info["type"], info["vertices"]), ("points", len(self.points)))
        self.assertGreater(info["forecast"]["bytes"], 0)
        options = ["--estimate-normals", "-R", 1, "--voxel", 0.1]
        strongest = self.report("transform", self.plain, *options)["maxima"][0]
        self.assertLess(math.dist([strongest[a] for a in "xyz"], (0, 0, 0)), 0.11)
        self.assertAlmostEqual(strongest["value"], 1, delta=0.02)
        turned = self.report("evaluate", self.plain, "--at", self.table, *options[:1], "--flip")
        self.assertEqual(turned["results"][0]["apt"], 0)

    def test_points_that_cannot_be_oriented(self):
        line = "".join("%r 0 0\n" % (10 + i / 10) for i in range(25))
        report = self.report("info", self.write("line.xyz", self.text + line), "--estimate-normals")
        self.assertEqual(report["points_unoriented"], 25)
        self.assertTrue(any("25 points" in w and "left out" in w for w in report["warnings"]))
        self.fail_with(UNUSABLE_INPUT, ["line.xyz", "25 points", "lines"], "info",
                       self.write("line.xyz", line), "--estimate-normals")
        self.fail_with(UNUSABLE_INPUT, ["few.xyz", "6 different positions", "more points"], "info",
                       self.write("few.xyz", "\n".join(self.text.splitlines()[:6])),
                       "--estimate-normals")

    def test_threads_do_not_change_a_bit(self):
        results = [self.report("evaluate", self.plain, "--at", self.table, "--estimate-normals", "-j",
                               threads)["results"] for threads in (1, 4)]
        self.assertEqual(*results)


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
