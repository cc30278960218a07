# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the command mapt takes, and what it does when there is no more: memory, disk, a reader of its output, time.
And files that are made to take all of it."""

import json
import os
import random
import resource
import shutil
import signal
import struct
import subprocess
import time
import unittest

from mapt_test import (DATA, DONE, INTERRUPTED, MAPT, OUTPUT_NOT_WRITTEN, UNUSABLE_INPUT, Test, icosphere, off,
                       run)

with open(MAPT, "rb") as program:
    code = program.read()
    HAS_SANITIZER = b"__asan_init" in code or b"__tsan_init" in code # which takes memory of its own, and time


class Limited(Test):
    def run_limited(self, limit, amount, *arguments):
        # Where lines are counted, the counts would be cut off as well.
        environment = {**os.environ, "LLVM_PROFILE_FILE": os.devnull}
        return subprocess.run([MAPT, *map(str, arguments)], capture_output=True, text=True, timeout=300,
                              check=False, env=environment,
                              preexec_fn=lambda: resource.setrlimit(limit, (amount, amount)))

    def files(self):
        return sorted(f.name for f in self.path.iterdir())

    def assert_one_line(self, text, *parts):
        lines = [line for line in text.splitlines() if "warning" not in line]
        self.assertEqual(len(lines), 1, text)
        for part in ("mapt: error: ", *parts):
            self.assertIn(part, lines[0])

    def queries(self, number):
        rows = "".join(f"0,0,{i / number},1\n" for i in range(number))
        return self.write("at.csv", "x,y,z,radius\n" + rows)


@unittest.skipIf(HAS_SANITIZER, "the sanitizer takes memory")
class Memory(Limited):
    def test_forecast_is_near_the_peak(self):
        for mesh, options in ((self.sphere, ["--voxel", 0.012, "-R", "0.3,0.5"]),
                              (DATA / "hand.obj", ["-n", 3]),
                              (DATA / "hand.obj", ["-n", 3, "--side", "outside"]),
                              (DATA / "hand.obj", ["-n", 3, "--kind", "mapt", "--region", "all"]),
                              (DATA / "human_woman.obj", ["-n", 2, "--normals", "smoothed"])):
            for threads in (1, 2):
                with self.subTest(mesh=mesh, options=options, threads=threads):
                    report = self.report("transform", mesh, "-j", threads, *options)
                    ratio = report["peak_memory_bytes"] / report["forecast"]["bytes"]
                    self.assertLess(abs(ratio - 1), 0.2, ratio)

    def test_what_is_allowed_is_kept_to(self):
        options = ("transform", self.sphere, "--voxel", 0.012, "-R", "0.3,0.5", "-j", 1)
        needed = self.report(*options)["forecast"]["bytes"]
        report = self.report(*options, "--max-memory", int(1.05 * needed))
        self.assertLess(report["peak_memory_bytes"], 1.2 * 1.05 * needed)
        self.fail_with(UNUSABLE_INPUT, ["--max-memory"], *options, "--max-memory",
                       int(0.95 * needed))

    def test_balls_that_are_allowed_are_near_the_peak(self):
        """By a factor of two: what connects the balls depends on the shape, and needles are cut smaller than others."""
        for mesh, options in ((DATA / "hand.obj", ["--spacing", 0.004]),
                              (DATA / "human_woman.obj", ["--spacing", 0.007]),
                              (DATA / "hand.obj", ["--spacing", 0.006, "--method", "polar"])):
            with self.subTest(mesh=mesh, options=options):
                peak = self.report("medial", mesh, *options)["peak_memory_bytes"]
                self.succeed("medial", mesh, *options, "--max-memory", 2 * peak)
                self.fail_with(UNUSABLE_INPUT, ["balls need", "--max-memory"], "medial", mesh, *options,
                               "--max-memory", peak / 2)

    def test_a_mesh_of_balls_that_is_allowed_is_near_the_peak(self):
        """By a factor of two: balls outside are much larger than the shape."""
        for options in (["--select", "covering", "--cell", 0.003], ["--side", "outside", "--balls", 50]):
            with self.subTest(options=options):
                command = ("medial", DATA / "hand.obj", "--reconstruct", self.path / "balls.stl", *options)
                peak = self.report(*command)["peak_memory_bytes"]
                self.succeed(*command, "--max-memory", 2 * peak)
                self.fail_with(UNUSABLE_INPUT, ["the mesh of the balls", "raise --cell"], *command,
                               "--max-memory", peak / 2)

    def test_memory_that_ends(self):
        """At whatever point: an error of one line and no file, or all is well."""
        before = self.files() + ["at.csv"]
        at = self.queries(2000)
        failures = 0
        for command, name, options in (("transform", "o.vti", ["--voxel", 0.03, "-R", 0.5]),
                                       ("evaluate", "o.csv", ["--at", at]), ("salient", "o.csv", []),
                                       ("lines", "o.vtp", []), ("medial", "o.ply", [])):
            for megabytes in (16, 24, 32, 48, 80):
                with self.subTest(command=command, megabytes=megabytes):
                    result = self.run_limited(resource.RLIMIT_AS, megabytes << 20, command, self.sphere,
                                              "-j", 2, *options, "-o", self.path / name)
                    if result.returncode == DONE:
                        (self.path / name).unlink()
                    elif result.returncode != 127: # else the libraries found no room
                        self.assertEqual(result.returncode, UNUSABLE_INPUT, result.stderr)
                        self.assert_one_line(result.stderr)
                        failures += 1
                    self.assertEqual(self.files(), sorted(before))
        self.assertGreater(failures, 3)


class Disk(Limited):
    def test_file_that_may_not_grow(self):
        before = self.files() + ["at.csv"]
        at = self.queries(2000)
        for command, name, options in (("transform", "o.vti", ["--voxel", 0.05, "-n", 2]),
                                       ("transform", "o.nrrd", ["--voxel", 0.05, "--no-compress"]),
                                       ("evaluate", "o.csv", ["--at", at]),
                                       ("medial", "o.ply", [])):
            with self.subTest(command=command, name=name):
                result = self.run_limited(resource.RLIMIT_FSIZE, 4096, command, self.sphere, *options,
                                          "-o", self.path / name)
                self.assertEqual(result.returncode, OUTPUT_NOT_WRITTEN, result.stderr)
                self.assert_one_line(result.stderr, name, "cannot be written")
                self.assertEqual(self.files(), sorted(before))

    def test_terminal_that_is_full(self):
        for arguments in (["--help"], ["--version"], ["transform", "--help"], ["medial", "--version"],
                          ["info", self.sphere]):
            with self.subTest(arguments=arguments), open("/dev/full", "w", encoding="utf-8") as full:
                result = subprocess.run([MAPT, *arguments], stdout=full, stderr=subprocess.PIPE, text=True,
                                        timeout=60, check=False)
                self.assertEqual(result.returncode, OUTPUT_NOT_WRITTEN)
                self.assert_one_line(result.stderr, "standard output", "cannot be written")

    def test_reader_that_leaves(self):
        at = self.queries(20000)
        before = self.files()
        command = subprocess.Popen([MAPT, "evaluate", self.sphere, "--at", at], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        command.stdout.readline()
        command.stdout.close()
        self.assertIn(command.wait(timeout=60), (-signal.SIGPIPE, OUTPUT_NOT_WRITTEN))
        command.stderr.close()
        self.assertEqual(self.files(), before)

    def test_files_are_as_private_as_the_user_wants(self):
        for mask, mode in ((0o077, 0o600), (0o022, 0o644)):
            output = self.path / f"{mask}.vti"
            subprocess.run([MAPT, "transform", self.sphere, "-R", "0.5", "-q", "-o", output], check=True,
                           timeout=60, preexec_fn=lambda mask=mask: os.umask(mask))
            self.assertEqual(output.stat().st_mode & 0o777, mode)


class Signals(Limited):
    def test_in_the_middle(self):
        before = self.files()
        for number in (signal.SIGINT, signal.SIGTERM):
            command = subprocess.Popen(
                [MAPT, "transform", self.sphere, "-o", self.path / "map.vti", "--json", "-n", "100",
                 "-j", "2", "--sampling-ratio", "0.03", "-v"],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.assertIn("is done", command.stderr.readline())
            command.send_signal(number)
            out, err = command.communicate(timeout=120)
            self.assertEqual(command.returncode, INTERRUPTED, err)
            self.assertEqual(json.loads(out)["exit_code"], INTERRUPTED)
            self.assertEqual(self.files(), before)

    def test_at_any_time(self):
        at = self.queries(50000)
        output = self.path / "o.csv"
        self.interrupt_often(output, "evaluate", self.sphere, "--at", at, "-j", "1", "-q", "-o", output)

    def test_at_any_time_of_a_matrix(self):
        generator = random.Random(4)
        table = self.path / "table.csv"
        with table.open("w", encoding="utf-8") as file:
            file.write("file," + ",".join(f"h{i}" for i in range(12)) + "\n")
            for row in range(1000):
                counts = [generator.random() for _ in range(12)]
                file.write(f"{row}.off," + ",".join(repr(c / sum(counts)) for c in counts) + "\n")
        output = self.path / "distances.csv"
        self.interrupt_often(output, "retrieve", table, "-q", "--distances", output)

    def interrupt_often(self, output, *arguments):
        """Before, while and after a file is written: it is whole or not there."""
        arguments = [MAPT, *arguments]
        start = time.monotonic()
        subprocess.run(arguments, check=True, timeout=120)
        duration = time.monotonic() - start
        whole = output.read_bytes()
        output.unlink()
        before = self.files()
        generator = random.Random(3)
        for _ in range(8):
            with subprocess.Popen(arguments, stderr=subprocess.DEVNULL) as command:
                time.sleep(generator.uniform(0, 1.1 * duration))
                command.send_signal(generator.choice([signal.SIGINT, signal.SIGTERM]))
                command.wait(timeout=120)
            if output.exists():
                self.assertEqual(output.read_bytes(), whole)
                output.unlink()
            self.assertEqual(self.files(), before)


class Hostile(Limited):
    """Each is refused, or done, within seconds and in a memory that is small."""

    def assert_bounded(self, codes, *arguments):
        before = self.files()
        seconds = 300 if HAS_SANITIZER else 60
        start = time.monotonic()
        result = (self.run_limited(resource.RLIMIT_CPU, seconds, *arguments) if HAS_SANITIZER else
                  self.run_limited(resource.RLIMIT_AS, 1 << 30, *arguments))
        self.assertIn(result.returncode, codes, result.stderr)
        if result.returncode != DONE:
            self.assert_one_line(result.stderr)
        self.assertEqual(self.files(), before)
        self.assertLess(time.monotonic() - start, seconds)

    def test_claims(self):
        binary = ("ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
                  "property float y\nproperty float z\nelement face 1000000000\n"
                  "property list uint int vertex_indices\nend_header\n").encode() + bytes(100)
        array = '<DataArray type="{}" Name="{}" {} format="ascii">0 0 3</DataArray>'
        vtp = ('<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>'
               '<Piece NumberOfPoints="1000000000" NumberOfPolys="1000000000"><Points>' +
               array.format("Float32", "", 'NumberOfComponents="3"') + "</Points><Polys>" +
               array.format("Int64", "connectivity", "") + array.format("Int64", "offsets", "") +
               "</Polys></Piece></PolyData></VTKFile>").encode()
        for name, data in (("a.off", b"OFF\n1000000000 1000000000 0\n0 0 0\n"), ("a.ply", binary),
                           ("a.stl", bytes(80) + struct.pack("<I", 0xffffffff) + bytes(50)),
                           ("a.vtp", vtp)):
            with self.subTest(name=name):
                (self.path / name).write_bytes(data)
                self.assert_bounded([UNUSABLE_INPUT], "info", self.path / name)

    def test_depth_and_length(self):
        digits = "1" * 10000000
        for name, text in (("deep.vtp", '<VTKFile type="PolyData">' + "<a>" * 300000),
                           ("wide.vtp", "<a/>" * 1000001),
                           ("huge.off", f"OFF\n3 1 0\n0 0 {digits}\n1 0 0\n0 1 0\n3 0 1 2\n")):
            with self.subTest(name=name):
                self.assert_bounded([UNUSABLE_INPUT], "info", self.write(name, text))
        for text in (f"x,y,z,radius\n0,0,0,{digits}\n", "x,y,z,radius\n\"" + "a\n" * 3000000,
                     "x,y,z,radius" + "," * 3000000 + "\n0,0,0,\n"):
            self.assert_bounded([UNUSABLE_INPUT], "evaluate", self.sphere, "--at",
                                self.write("at.csv", text), "-q")

    def test_sizes(self):
        points, faces = icosphere(2)
        for scale, codes in ((1e300, [UNUSABLE_INPUT]), (1e16, [UNUSABLE_INPUT]), (9e14, [DONE]),
                             (2e-15, [DONE]), (1e-16, [UNUSABLE_INPUT]), (5e-324, [UNUSABLE_INPUT])):
            mesh = self.write("mesh.off", off([tuple(scale * x for x in p) for p in points], faces))
            commands = ("transform", "salient", "lines", "medial", "describe")
            for command in commands if codes == [DONE] else commands[:1]:
                with self.subTest(scale=scale, command=command):
                    self.assert_bounded(codes, command, mesh, "-q")
        # one vertex far away: of a needle there is much less to be seen than its length asks for
        mesh = self.write("mesh.off", off([(1e6, 0, 0), *points[1:]], faces))
        for command in ("transform", "salient", "lines"):
            with self.subTest(command=command):
                self.assert_bounded([DONE, UNUSABLE_INPUT], command, mesh, "-q")


class Names(Limited):
    def test_messages_and_tables_stay_in_their_lines(self):
        result = run("info", self.path / "no\nmesh\x1b.off")
        self.assertEqual(result.returncode, UNUSABLE_INPUT)
        self.assertIn("no?mesh?.off: there is no such file", result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1)
        mesh = shutil.copy(self.sphere, self.path / "a\n\x1bmesh.off")
        self.assertIn("a??mesh.off: ", self.succeed("info", mesh).stdout)

    def test_names_in_files_lead_nowhere(self):
        """What a table calls a shape is text, and no place to write to."""
        evil = "../evil"
        names = [f"{evil}{i}.off" for i in range(6)]
        table = self.write("hapt.csv", "file,h0,h1\n" +
                           "".join(f"{n},{i / 10},{1 - i / 10}\n" for i, n in enumerate(names)))
        labels = self.write("labels.csv", "file,class\n" + "".join(f"{n},{evil}{i % 2}\n"
                                                                   for i, n in enumerate(names)))
        before, above = self.files(), sorted(self.path.parent.glob("evil*"))
        self.succeed("retrieve", table, "--labels", labels, "--distances", self.path / "d.csv",
                     "--precision-recall", self.path / "pr.csv")
        self.assertEqual(self.files(), sorted(before + ["d.csv", "pr.csv"]))
        self.assertEqual(sorted(self.path.parent.glob("evil*")), above)


if __name__ == "__main__":
    unittest.main()
