# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt describe in several processes, which mpirun starts: the bytes are those of one."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

from mapt_test import MAPT, UNUSABLE_INPUT, WRONG_USAGE, Test, icosphere, off, run

# Root may run the tests, on fewer processors than there are processes.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_hwloc_base_binding_policy": "none"}

SLOW = ("--normals", "smoothed") # so that there is time to kill it


def command_line(ranks, *arguments):
    return ["mpirun", "-n", str(ranks), MAPT, "describe", *map(str, arguments)]


def run_ranks(ranks, *arguments):
    return subprocess.run(command_line(ranks, *arguments), capture_output=True, text=True,
                          env=ENVIRONMENT, timeout=120, check=False)


def process_of(launcher, rank):
    """The process number of a rank."""
    for child in pathlib.Path(f"/proc/{launcher}/task/{launcher}/children").read_text().split():
        environment = pathlib.Path(f"/proc/{child}/environ").read_bytes().split(b"\0")
        if f"OMPI_COMM_WORLD_RANK={rank}".encode() in environment:
            return int(child)
    raise LookupError(f"there is no rank {rank}")


@unittest.skipUnless(shutil.which("mpirun"), "there is no mpirun")
class Ranks(Test):
    def setUp(self):
        super().setUp()
        result = run_ranks(2, self.sphere, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        try:
            report = json.loads(result.stdout)
        except json.JSONDecodeError:
            self.skipTest("mapt was built without MPI") # each process spoke for itself
        self.assertEqual(report["parameters"]["ranks"], 2)
        self.output = self.path / "hapt.csv"
        self.journal = self.path / "hapt.csv.partial"

    def corpus(self, number):
        files = []
        for i in range(number):
            points, faces = icosphere(3)
            points = [(x, (1 + i / number) * y, z) for x, y, z in points]
            files.append(self.write(f"{i:03}.off", off(points, faces)))
        return files

    def expected(self, files, *options):
        run("describe", *files, *options, "-o", self.path / "one.csv")
        return (self.path / "one.csv").read_bytes()

    def test_same_bytes(self):
        files = self.corpus(12)
        expected = self.expected(files)
        for ranks in (1, 2, 3):
            result = run_ranks(ranks, *files, "-o", self.output)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(self.output.read_bytes(), expected)
            self.assertFalse(self.journal.exists())
            self.output.unlink()

    def test_failed_files(self):
        files = self.corpus(6)
        files[1:1] = [self.write("bad.off", "OFF\n1 1 0\n")]
        files[4:4] = [self.path / "nowhere.off"]
        expected = self.expected(files)
        result = run_ranks(3, *files, "-o", self.output)
        self.assertEqual(result.returncode, UNUSABLE_INPUT, result.stderr)
        self.assertEqual(self.output.read_bytes(), expected)
        self.assertEqual(len(expected.splitlines()), 7)
        for name in ("bad.off", "nowhere.off"):
            self.assertEqual(sum(f"/{name}: " in line for line in result.stderr.splitlines()), 1)

    def test_more_ranks_than_files(self):
        result = run_ranks(3, self.sphere)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, run("describe", self.sphere).stdout)

    def test_only_one_speaks(self):
        for code, arguments in ((WRONG_USAGE, ["--bins", 1]), (WRONG_USAGE, ["-j", 2]),
                                (0, ["--help"])):
            result = run_ranks(3, self.sphere, *arguments)
            self.assertEqual(result.returncode, code, result.stderr)
            errors = [l for l in result.stderr.splitlines() if l.startswith("mapt: error")]
            self.assertEqual(len(errors), 0 if code == 0 else 1)
            self.assertEqual(result.stdout.count("Usage: mapt describe"),
                             1 if code == 0 else 0)

    def killed(self, files, rank):
        """Ends a rank, or all (None), after some meshes; returns how many are in the journal then, or
        None: the others were faster than the launcher, which ends them, and have finished."""
        command = subprocess.Popen(command_line(3, *files, *SLOW, "-o", self.output), env=ENVIRONMENT,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not self.journal.exists() or self.journal.read_bytes().count(b"\n") < 6:
            self.assertIsNone(command.poll())
            time.sleep(0.002)
        if rank is None:
            command.send_signal(signal.SIGINT)
        else:
            os.kill(process_of(command.pid, rank), signal.SIGKILL)
        self.assertNotEqual(command.wait(timeout=60), 0)
        return self.journal.read_bytes().count(b"\n") - 1 if self.journal.exists() else None

    def test_death_loses_nothing(self):
        files = self.corpus(60)
        expected = self.expected(files, *SLOW)
        for rank in (1, 0, None):
            done = self.killed(files, rank)
            if done is not None:
                report = json.loads(run_ranks(3, *files, *SLOW, "-o", self.output, "--json").stdout)
                self.assertGreaterEqual(report["counts"]["resumed"], done - 1) # the last may be torn
            self.assertEqual(self.output.read_bytes(), expected)
            self.output.unlink()


if __name__ == "__main__":
    unittest.main()
