# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the tests of the command mapt share: shapes, files, and how to call it.

The environment names the command (MAPT) and the folder of the bundled meshes (MAPT_DATA).
"""

import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

MAPT = os.environ.get("MAPT", "mapt")
DATA = pathlib.Path(os.environ.get("MAPT_DATA", "data"))
SHELF = pathlib.Path(__file__).parent / "data"

DONE, WRONG_USAGE, UNUSABLE_INPUT, OUTPUT_NOT_WRITTEN, INTERRUPTED = 0, 2, 3, 4, 130


def run(*arguments):
    # So long only with a sanitizer on a busy machine; ctest has its own limit.
    return subprocess.run([MAPT, *map(str, arguments)], capture_output=True, text=True, timeout=1000,
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
