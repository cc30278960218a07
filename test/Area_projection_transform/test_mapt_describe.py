# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt describe: rows of numbers for many meshes, whatever is among them and whatever happens."""

import csv
import json
import math
import os
import pty
import random
import shutil
import signal
import struct
import subprocess
import time
import unittest

from mapt_test import (INTERRUPTED, MAPT, OUTPUT_NOT_WRITTEN, SHELF, UNUSABLE_INPUT, WRONG_USAGE,
                       Test, icosphere, off, run)

SLOW = ("--normals", "smoothed") # so that there is time to stop or kill it


def ellipsoid(subdivisions, axes):
    points, faces = icosphere(subdivisions)
    return [tuple(a * x for a, x in zip(axes, p)) for p in points], faces


class Corpus(Test):
    """Ellipsoids with axes of their own, in a folder."""

    def setUp(self):
        super().setUp()
        self.output = self.path / "hapt.csv"
        self.journal = self.path / "hapt.csv.partial"

    def corpus(self, number, subdivisions=2, folder="corpus"):
        (self.path / folder).mkdir()
        files = []
        for i in range(number):
            axes = (1, 1 + 0.4 * math.sin(i), 1 + 0.1 * i / number)
            files.append(self.write(f"{folder}/{i:03}.off", off(*ellipsoid(subdivisions, axes))))
        return files

    def rows(self, path):
        with open(path, newline="", encoding="utf-8") as stream:
            return list(csv.reader(stream))

    def describe(self, *arguments):
        self.succeed("describe", *arguments, "-o", self.output)
        return self.rows(self.output)

    def start(self, *arguments):
        return subprocess.Popen([MAPT, "describe", *map(str, arguments), "-o", str(self.output)],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def finished(self):
        """How many lines of the journal are whole, the header left out."""
        return self.journal.read_bytes().count(b"\n") - 1 if self.journal.exists() else -1

    def wait_for(self, lines, command):
        while command.poll() is None and self.finished() < lines:
            time.sleep(0.002)

    def stopped_in_the_middle(self, lines, files, *options):
        """The command, standing still: some lines are written, and more than one is not. On a busy
        machine it may be done before this test has seen the lines; then once more."""
        for _ in range(50):
            command = self.start(*files, *options, "-j", 1)
            self.wait_for(lines, command)
            if command.poll() is None:
                command.send_signal(signal.SIGSTOP)
                os.waitid(os.P_PID, command.pid, os.WSTOPPED | os.WEXITED | os.WNOWAIT)
                if lines <= self.finished() < len(files) - 1:
                    return command
                command.kill()
            command.communicate()
            self.output.unlink(missing_ok=True)
            self.journal.unlink(missing_ok=True)
        return self.fail("the command was always faster than this test")


class Table(Corpus):
    def test_columns(self):
        header, row = self.describe(self.sphere)
        self.assertEqual(header, ["file"] + [f"h{i}" for i in range(96)])
        self.assertEqual(row[0], str(self.sphere))
        values = [float(v) for v in row[1:]]
        # Eight histograms, each with the same share of 1.
        for k in range(8):
            self.assertAlmostEqual(sum(values[12 * k:12 * k + 12]), 1 / 8, delta=1e-6)
        self.assertFalse(self.journal.exists())

    def test_numbers_follow_the_shape_only(self):
        # Half the size, elsewhere: by a power of two, so that not even rounding differs by much.
        points, faces = ellipsoid(3, (1, 1.3, 1.7))
        first = self.write("a.off", off(points, faces))
        moved = [tuple(0.5 * x + 8 for x in p) for p in points]
        second = self.write("b.off", off(moved, faces))
        _, a, b = self.describe(first, second)
        distance = sum(abs(float(x) - float(y)) for x, y in zip(a[1:], b[1:]))
        self.assertLess(distance, 0.01)

    def test_options_change_the_columns(self):
        for options, number in ((["--bins", 16], 128), (["--kind", "soft"], 96),
                                (["--kind", "pairs"], 256), (["--kind", "pairs", "--bins", 4], 64),
                                (["--radius-max", 4], 36)):
            with self.subTest(options=options):
                header, row = self.describe(self.sphere, *options)
                self.assertEqual((len(header), len(row)), (number + 1, number + 1))
                self.assertAlmostEqual(sum(map(float, row[1:])), 1, delta=1e-5)
        self.assertEqual(len(self.describe(self.sphere, "--normals", "averaged")[1]), 97)
        self.assertNotEqual(self.describe(self.sphere, "--subdivide")[1], self.describe(self.sphere)[1])
        self.fail_with(WRONG_USAGE, ["--subdivide", "--normals"], "describe", self.sphere, "--subdivide",
                       "--normals", "averaged")
        self.fail_with(WRONG_USAGE, ["PAIRS", "even", "--radius-max"], "describe", self.sphere,
                       "--kind", "pairs", "--radius-max", 4)
        self.fail_with(WRONG_USAGE, ["--smoothing-ratio", "face"], "describe", self.sphere,
                       "--smoothing-ratio", 0.2)

    def test_order_and_threads(self):
        files = self.corpus(8)
        random.Random(5).shuffle(files)
        tables = []
        for threads in (1, 2, 5):
            rows = self.describe(*files, "-j", threads)
            self.assertEqual([row[0] for row in rows[1:]], [str(f) for f in files])
            tables.append(self.output.read_bytes())
        self.assertEqual(tables[0], tables[1])
        self.assertEqual(tables[0], tables[2])
        # Rows do not depend on their neighbours; standard output gets the same bytes.
        self.assertEqual(self.describe(files[3])[1], rows[4])
        self.assertEqual(run("describe", *files).stdout.encode(), tables[0])

    def test_folders_and_lists(self):
        files = self.corpus(3)
        (self.path / "corpus/deep").mkdir()
        deep = self.write("corpus/deep/x.OFF", off(self.points, self.faces))
        self.write("corpus/notes.txt", "no mesh")
        names = [row[0] for row in self.describe(self.sphere, self.path / "corpus")[1:]]
        self.assertEqual(names, [str(f) for f in [self.sphere, *files, deep]])
        listed = self.write("list.txt", f"{files[2]}\r\n\n{self.path / 'corpus/deep'}\n{files[0]}")
        names = [row[0] for row in self.describe(files[1], "--list", listed)[1:]]
        self.assertEqual(names, [str(f) for f in (files[1], files[2], deep, files[0])])
        result = subprocess.run([MAPT, "describe", "--list", "-"], input=f"{self.sphere}\n",
                                capture_output=True, text=True, timeout=60, check=True)
        self.assertEqual(len(result.stdout.splitlines()), 2)

    def test_names_of_all_kinds(self):
        files = [self.path / name for name in ("a,b.off", 'say "x".off', "two\nlines.off", "#1.off",
                                               "percent%0A.off", "%.off", "ümläut.off",
                                               " blank .off")]
        for f in files:
            shutil.copy(self.sphere, f)
        command = self.start(*files, "-j", 1) # and the journal knows them again
        self.wait_for(5, command)
        command.kill()
        command.communicate()
        rows = self.describe(*files)
        self.assertEqual([row[0] for row in rows[1:]], [str(f) for f in files])

    def test_report(self):
        files = self.corpus(2)
        report = self.report("describe", *files)
        self.assertEqual(report["counts"],
                         {"files": 2, "described": 2, "resumed": 0, "failed": 0})
        self.assertEqual((report["parameters"]["dimension"], report["parameters"]["block_size"]),
                         (96, 12))
        # As floats they are those of the table; the object has them as double numbers.
        rows = self.describe(*files)
        for entry, row in zip(report["descriptors"], rows[1:]):
            self.assertEqual(entry["file"], row[0])
            as_float = lambda x: struct.unpack("f", struct.pack("f", float(x)))[0]
            self.assertEqual(entry["values"], [as_float(v) for v in row[1:]])
        report = self.report("describe", *files, "-o", self.output)
        self.assertEqual(report["outputs"], [str(self.output)])
        self.assertNotIn("descriptors", report)

    def test_progress_is_for_terminals(self):
        files = self.corpus(2)
        master, slave = pty.openpty()
        subprocess.run([MAPT, "describe", *files], stdout=subprocess.DEVNULL, stderr=slave,
                       timeout=60, check=True)
        os.close(slave)
        text = os.read(master, 100000)
        os.close(master)
        self.assertIn(b"of 2 meshes", text)
        self.assertIn(b"left", text)
        self.assertEqual(self.succeed("describe", *files).stderr, "")


class Defects(Corpus):
    def test_bad_files_are_listed_and_left_out(self):
        good = self.corpus(2)
        points = self.write("points.ply", "ply\nformat ascii 1.0\nelement vertex 2\n"
                            "property float x\nproperty float y\nproperty float z\n"
                            "property float nx\nproperty float ny\nproperty float nz\n"
                            "end_header\n0 0 0 0 0 1\n1 0 0 0 0 1\n")
        flat = self.write("flat.off", off([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]))
        bad = [SHELF / "nan_vertex.off", self.path / "nowhere.off", points, flat]
        reference = self.describe(*good)
        for more in ([], ["--json"]):
            result = run("describe", bad[0], good[0], bad[1], bad[2], good[1], bad[3], "-j", 2, "-o",
                         self.output, *more)
            self.assertEqual(result.returncode, UNUSABLE_INPUT)
            self.assertEqual(self.rows(self.output), reference)
            self.assertFalse(self.journal.exists())
            lines = result.stderr.splitlines()
            self.assertEqual(len(lines), 5, result.stderr)
            for file, cause in zip(bad, ("vertex", "no such file", "points only", "no volume")):
                told = [line for line in lines if str(file) in line]
                self.assertEqual(len(told), 1, result.stderr)
                self.assertIn(cause, told[0])
            self.assertIn("4 of 6 files could not be described", lines[-1])
        report = json.loads(result.stdout)
        self.assertEqual(report["exit_code"], UNUSABLE_INPUT)
        self.assertEqual([f["file"] for f in report["failures"]], [str(f) for f in bad])
        self.assertEqual(report["counts"]["described"], 2)

    def test_nothing_good(self):
        result = run("describe", self.path / "nowhere.off", "-o", self.output)
        self.assertEqual(result.returncode, UNUSABLE_INPUT)
        self.assertIn("nothing was written", result.stderr)
        self.assertEqual(list(self.path.glob("hapt*")), [])

    def test_what_is_no_list(self):
        (self.path / "empty").mkdir()
        for code, parts, arguments in (
                (WRONG_USAGE, ["MESH", "--list"], []),
                (WRONG_USAGE, ["sphere.off", "twice"], [self.sphere, self.sphere]),
                (WRONG_USAGE, ["sphere.off", "twice"], [self.path, self.sphere]),
                (UNUSABLE_INPUT, ["empty", "no mesh"], [self.path / "empty"]),
                (UNUSABLE_INPUT, ["nowhere.txt"], ["--list", self.path / "nowhere.txt"]),
                (UNUSABLE_INPUT, ["empty list"], ["--list", os.devnull]),
                (WRONG_USAGE, ["--bins", "1"], [self.sphere, "--bins", 1]),
                (WRONG_USAGE, ["--voxel 0.1", "300 voxels"], [self.sphere, "--voxel", 0.1]),
                (WRONG_USAGE, ["--kind", "hapt"], [self.sphere, "--kind", "hapt"]),
                (WRONG_USAGE, ["replace"], ["--list", self.sphere, "-o", self.sphere]),
                (OUTPUT_NOT_WRITTEN, ["nowhere/hapt.csv"],
                 [self.sphere, "-o", self.path / "nowhere/hapt.csv"]),
                (OUTPUT_NOT_WRITTEN, ["empty"], [self.sphere, "-o", self.path / "empty"])):
            with self.subTest(arguments=arguments):
                self.fail_with(code, parts, "describe", *arguments)

    def test_odd_meshes_are_counted_once(self):
        inward = self.write("inward.off", off(self.points, [f[::-1] for f in self.faces]))
        rows = self.describe(self.sphere, inward)
        result = self.succeed("describe", self.sphere, inward, "-o", self.output)
        self.assertEqual(len(result.stderr.splitlines()), 1)
        self.assertIn("1 mesh is odd", result.stderr)
        self.assertEqual(rows[1][1:], rows[2][1:]) # turned over, it is the same
        self.assertIn("turned over", self.succeed("describe", inward, "-v").stderr)


class Resumption(Corpus):
    """Whatever ends the command: nothing is lost, nothing is double, the bytes are the same."""

    def reference(self, files, *options):
        self.describe(*files, *options)
        bytes_ = self.output.read_bytes()
        self.output.unlink()
        return bytes_

    def test_killed_again_and_again(self):
        files = self.corpus(16, subdivisions=3)
        expected = self.reference(files, *SLOW)
        generator = random.Random(7)
        kills = 0
        while not self.output.exists():
            command = self.start(*files, *SLOW, "-j", generator.choice([1, 2, 3]))
            self.wait_for(self.finished() + generator.randint(1, 3), command)
            time.sleep(generator.uniform(0, 0.01))
            command.send_signal(signal.SIGKILL)
            command.communicate(timeout=60)
            kills += 1
            self.assertLess(kills, 100)
        self.assertGreater(kills, 3)
        if self.journal.exists(): # killed after the last byte, before the journal was removed
            self.describe(*files, *SLOW)
        self.assertEqual(self.output.read_bytes(), expected)
        self.assertFalse(self.journal.exists())

    def interrupted(self, files, lines=4):
        command = self.stopped_in_the_middle(lines, files, "--json")
        command.send_signal(signal.SIGINT)
        command.send_signal(signal.SIGCONT)
        out, err = command.communicate(timeout=60)
        self.assertEqual(command.returncode, INTERRUPTED, err)
        return out, err

    def test_interruption_tells_how_to_go_on(self):
        files = self.corpus(40, subdivisions=3)
        expected = self.reference(files)
        out, err = self.interrupted(files)
        self.assertEqual(json.loads(out)["exit_code"], INTERRUPTED)
        self.assertIn("of 40 meshes are done; the same command goes on from there", err)
        self.assertFalse(self.output.exists())
        done = self.finished()
        report = self.report("describe", *files, "-o", self.output)
        self.assertEqual(report["counts"], {"files": 40, "described": 40, "resumed": done,
                                            "failed": 0})
        self.assertEqual(self.output.read_bytes(), expected)

    def test_torn_and_damaged_lines_are_left_out(self):
        files = self.corpus(30, subdivisions=3)
        expected = self.reference(files)
        self.interrupted(files, 6)
        journal = self.journal.read_bytes().splitlines(keepends=True)
        middle = journal[3].replace(b" 0", b" 1", 3)
        self.assertNotEqual(middle, journal[3])
        for damaged, known in ((journal[:3] + [journal[3][:-200]], 2), # cut off within a line
                               (journal[:1] + [journal[1][:-1]], 1),   # … or before its end
                               (journal[:3] + [middle] + journal[4:5], 3),
                               ([journal[0][:20]], 0), ([], 0)):
            self.journal.write_bytes(b"".join(damaged))
            self.output.unlink(missing_ok=True)
            report = self.report("describe", *files, "-o", self.output)
            self.assertEqual(report["counts"]["resumed"], known)
            self.assertEqual(self.output.read_bytes(), expected)

    def test_files_that_changed_are_described_anew(self):
        files = self.corpus(20, subdivisions=3)
        self.interrupted(files)
        shutil.copy(files[-1], files[0])
        expected = self.reference_elsewhere(files)
        self.describe(*files)
        self.assertEqual(self.output.read_bytes(), expected)

    def reference_elsewhere(self, files):
        other = self.path / "other.csv"
        self.succeed("describe", *files, "-o", other)
        return other.read_bytes()

    def test_other_options_are_refused(self):
        files = self.corpus(20, subdivisions=3)
        self.interrupted(files)
        self.fail_with(WRONG_USAGE, [str(self.journal), "other options", "remove it"], "describe",
                       *files, "-o", self.output, "--bins", 16)
        self.journal.write_text("dear diary\n", encoding="utf-8")
        self.fail_with(WRONG_USAGE, [str(self.journal), "not the journal"], "describe", *files,
                       "-o", self.output)

    def test_two_at_once_are_refused(self):
        files = self.corpus(10, subdivisions=3)
        command = self.stopped_in_the_middle(1, files)
        result = run("describe", *files, "-o", self.output)
        command.kill()
        command.communicate()
        self.assertEqual(result.returncode, WRONG_USAGE)
        self.assertIn("another mapt describe is writing it", result.stderr)

    def test_pipes_have_no_journal(self):
        pipe = self.path / "pipe"
        os.mkfifo(pipe)
        command = subprocess.Popen([MAPT, "describe", self.sphere, "-o", pipe, "-q"])
        self.assertEqual(len(pipe.read_text(encoding="utf-8").splitlines()), 2)
        self.assertEqual(command.wait(timeout=60), 0)
        self.assertEqual(list(self.path.glob("*.partial")), [])

    def test_failures_are_tried_again(self):
        files = self.corpus(30, subdivisions=3)
        good = files[0].read_bytes()
        files[0].write_bytes(b"")
        self.interrupted(files)
        files[0].write_bytes(good)
        self.assertEqual(len(self.describe(*files)), 31)


if __name__ == "__main__":
    unittest.main()
