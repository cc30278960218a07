# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Arguments, help and messages of the command mapt."""

import unittest

from mapt_test import Test, SHELF, WRONG_USAGE, run


class Usage(Test):
    def test_help(self):
        for command in ("", "transform", "evaluate", "salient", "describe", "retrieve", "info"):
            result = self.succeed(*command.split(), "--help")
            self.assertIn("sage: mapt", result.stdout)
            self.assertLessEqual(max(map(len, result.stdout.splitlines())), 80)
            self.assertEqual(result.stderr, "")
        self.assertIn("--max-memory BYTES", self.succeed("transform", "--help").stdout)
        self.assertIn("(default: 0.5)", self.succeed("transform", "--help").stdout)

    def test_version(self):
        for command in ("", "transform", "evaluate", "salient", "describe", "retrieve", "info"):
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
                (["--radii", "1e200", "1e30"], ["--radii", "1e200"]),
                (["--sigma-ratio", "nan"], ["--sigma-ratio", "nan"]),
                (["--sampling-ratio", "nan", "0.01"], ["--sampling-ratio", "nan"]),
                (["--voxel", "5e-324", "1e-30"], ["--voxel", "5e-324"]),
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
        for text, parts in (("vocsel = 1\n", ["there is no option 'vocsel'", "did you mean --voxel?"]),
                            ("x" * 60000, ["there is no option 'x", "--help"]),
                            ("voxel = 'wide'\n", ["--voxel", "wide"]),
                            ("\n[transform]\nvoxel = 1\n", ["line 2", "sections"]),
                            ("[" + "a." * 20000 + "b]\nvoxel = 1\n", ["line 1", "sections"]),
                            ('picture = "a\n', ["line 1", "quote"]),
                            ("#" * 100000, ["larger than 64 kB"])):
            with self.subTest(text=text[:40]):
                config = self.write("bad.toml", text)
                result = run("transform", self.sphere, "--config", config)
                self.assertEqual(result.returncode, WRONG_USAGE, result.stderr)
                for part in parts:
                    self.assertIn(part, result.stderr)
                self.assertEqual(result.stderr.count("\n"), 1)
                self.assertLess(len(result.stderr), 300)
        for file, part in (("/dev/zero", "64 kB"), (self.path, "cannot be read")):
            self.fail_with(WRONG_USAGE, ["--config", part], "info", self.sphere, "--config", file)

    def test_config_is_not_replaced(self):
        config = self.write("mine.csv", "threads = 1\n")
        self.fail_with(WRONG_USAGE, ["--output", "mine.csv", "file of --config"], "salient", self.sphere,
                       "--config", config, "-o", self.path / "." / "mine.csv")
        self.assertEqual(config.read_text(), "threads = 1\n")

    def test_outputs_are_apart(self):
        """Also where a file is named by two paths."""
        folder = self.path / "folder"
        folder.mkdir()
        one, other = self.path / "same.ply", folder / ".." / "same.ply"
        for command in (("medial", self.sphere, "-o", one, "--reconstruct", other),
                        ("salient", self.sphere, "-o", one, "--voters", other),
                        ("lines", self.sphere, "-o", self.path / "l.obj", "-o", folder / ".." / "l.obj")):
            with self.subTest(command=command):
                self.fail_with(WRONG_USAGE, ["to be written twice"], *command)
                self.assertFalse(one.exists())

    def test_quiet_and_verbose(self):
        mixed = SHELF / "mixed_orientation.off"
        result = self.succeed("transform", mixed, "--voxel", 0.1, "-q", "-v")
        self.assertEqual((result.stdout, result.stderr), ("", ""))
        result = self.succeed("transform", mixed, "--voxel", 0.1)
        self.assertIn("mapt: warning: ", result.stderr)
        result = self.succeed("transform", self.sphere, "-R", 1, "--voxel", 0.1, "-v")
        self.assertIn("radius 1 is done", result.stderr)


if __name__ == "__main__":
    unittest.main()
