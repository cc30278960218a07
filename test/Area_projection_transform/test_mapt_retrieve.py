# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mapt retrieve: scores, curves and neighbours that are worked out by hand."""

import csv
import math
import struct
import unittest

from mapt_test import (OUTPUT_NOT_WRITTEN, UNUSABLE_INPUT, WRONG_USAGE, Test, icosphere, off)

# Rows (p, 1 - p): the L1 distance is twice the difference of p, so that each shape ranks the others by it.
#   a0: a1 a2 b0 b1 b2     those of its class come at 1, 2
#   a1: a0 a2 b0 b1 b2     1, 2
#   a2: b0 a1 b1 a0 b2     2, 4
#   b0: a2 b1 a1 b2 a0     2, 4
#   b1: b2 b0 a2 a1 a0     1, 2
#   b2: b1 b0 a2 a1 a0     1, 2
SHAPES = {"a0": 0.0, "a1": 0.1, "a2": 0.4, "b0": 0.5, "b1": 0.75, "b2": 0.95}


class Retrieve(Test):
    def setUp(self):
        super().setUp()
        self.table = self.write("hapt.csv", "file,h0,h1\n" + "".join(
            f"meshes/{name}.off,{p},{1 - p}\n" for name, p in SHAPES.items()))
        self.labels = self.write("labels.csv", "file,class\n" + "".join(
            f"{name},{name[0]}\n" for name in SHAPES))
        self.common = (self.table, "--labels", self.labels, "--distance", "l1")

    def test_scores(self):
        report = self.report("retrieve", *self.common)
        # Those with ranks 2, 4: no first, one of two in the first two, both in the first four; the gain is
        # 1/log2(2) + 1/log2(4), the best is 2. All have 2 of the 5 others in the list of 32.
        expected = {"NN": 4 / 6, "FT": (4 + 2 / 2) / 6, "ST": 1, "E": 4 / 7, "E_ceiling": 4 / 7,
                    "DCG": (4 + 2 * 1.5 / 2) / 6}
        for scores in (report, report["macro"]):
            for name, value in expected.items():
                self.assertAlmostEqual(scores[name], value, places=12, msg=name)
        self.assertEqual(list(report["classes"]), ["a", "b"])
        self.assertAlmostEqual(report["classes"]["a"]["NN"], 2 / 3)
        self.assertEqual(report["classes"]["a"]["queries"], 3)
        text = self.succeed("retrieve", *self.common).stdout
        self.assertIn("NN      FT      ST       E  (most)     DCG", text)
        self.assertRegex(text, r"mean of queries +0\.6667 +0\.8333 +1\.0000 +0\.5714 +0\.5714 +0\.9167")

    def test_means_over_queries_and_over_classes(self):
        labels = self.write("uneven.csv", "file,class\na0,a\na1,a\na2,a\nb0,b\nb1,b\nb2,alone\n")
        arguments = ("retrieve", self.table, "--labels", labels, "--distance", "l1")
        report = self.report(*arguments, "--smallest-class", 2)
        self.assertEqual(report["queries"], 5)
        self.assertAlmostEqual(report["NN"], 2 / 5)
        self.assertAlmostEqual(report["macro"]["NN"], (2 / 3 + 0) / 2)
        self.assertEqual(list(self.report(*arguments)["classes"]), ["a"])
        self.fail_with(UNUSABLE_INPUT, ["uneven.csv", "no class of 4", "--smallest-class"],
                       *arguments, "--smallest-class", 4)

    def test_labels_of_the_princeton_benchmark(self):
        table = self.write("T.csv", "file,h0,h1\n" + "".join(
            f"T{i}.obj,{p},{1 - p}\n" for i, p in enumerate(SHAPES.values())))
        labels = self.write("l.cla", "PSB 1\n2 6\n\na 0 3\n0\n1\n2\n\nb 0 3\n3\n4\n5\n")
        report = self.report("retrieve", table, "--labels", labels, "--distance", "l1")
        self.assertAlmostEqual(report["DCG"], 11 / 12)

    def test_shapes_without_a_class(self):
        labels = self.write("few.csv", "file,class\na0,a\na1,a\na2,a\n")
        result = self.succeed("retrieve", self.table, "--labels", labels, "--distance", "l1")
        self.assertIn("no class for 3 shapes", result.stderr)
        self.assertRegex(result.stdout, r"\na +0\.6667")

    def test_neighbours(self):
        expected = [("meshes/b0.off", 0.2, "b"), ("meshes/a1.off", 0.6, "a")]
        for query in ("a2", "a2.off", "meshes/a2.off"):
            answer, = self.report("retrieve", *self.common, "--query", query, "-k", 2)["neighbours"]
            self.assertEqual(answer["query"], "meshes/a2.off")
            self.assertEqual([(n["file"], n["class"]) for n in answer["neighbours"]],
                             [(f, c) for f, _, c in expected])
            for n, (_, distance, _) in zip(answer["neighbours"], expected):
                self.assertAlmostEqual(n["distance"], distance, places=6)
        answers = self.report("retrieve", self.table, "--query", "a0", "--query", "b0")
        self.assertEqual([len(a["neighbours"]) for a in answers["neighbours"]], [5, 5])
        self.assertNotIn("NN", answers)
        text = self.succeed("retrieve", self.table, "--query", "b2", "-k", 1).stdout
        self.assertIn("Nearest to meshes/b2.off:", text)
        self.assertIn("meshes/b1.off", text)

    def test_neighbours_of_equal_rows(self):
        table = self.write("equal.csv", "file,h0\n" + "".join(f"{c},1\n" for c in "abcd"))
        answer, = self.report("retrieve", table, "--query", "d", "-k", 2)["neighbours"]
        self.assertEqual([n["file"] for n in answer["neighbours"]], ["a", "b"])

    def test_distances(self):
        places = list(SHAPES.values())
        for distance, of in (
                ("l1", lambda p, q: 2 * abs(p - q)),
                ("earth-mover", lambda p, q: abs(p - q)),
                ("jeffrey", lambda p, q: 2 * self.jensen_shannon(p, q)),
                ("jensen-shannon", lambda p, q: math.sqrt(self.jensen_shannon(p, q)))):
            options = ["--distance", distance]
            options += ["--bins", 2] if distance in ("earth-mover", "jensen-shannon") else []
            self.succeed("retrieve", self.table, *options, "--distances", self.path / "d.f32")
            floats = struct.unpack("<36f", (self.path / "d.f32").read_bytes())
            self.succeed("retrieve", self.table, *options, "--distances", self.path / "d.csv")
            with open(self.path / "d.csv", newline="", encoding="utf-8") as stream:
                header, *rows = csv.reader(stream)
            names = [f"meshes/{name}.off" for name in SHAPES]
            self.assertEqual(header, ["file", *names])
            self.assertEqual([row[0] for row in rows], names)
            for i, p in enumerate(places):
                for j, q in enumerate(places):
                    # The table holds floats: p has an error of 2^-25, and so, nearly, has the distance;
                    # the root of a small divergence has more.
                    self.assertAlmostEqual(floats[6 * i + j], of(p, q), delta=3e-7)
                    self.assertEqual(struct.pack("f", float(rows[i][j + 1])),
                                     struct.pack("f", floats[6 * i + j]))

    @staticmethod
    def jensen_shannon(p, q):
        return sum(h * math.log(2 * h / (h + k)) / 2
                   for a, b in ((p, q), (1 - p, 1 - q)) for h, k in ((a, b), (b, a)) if h > 0)

    def test_precision_recall(self):
        output = self.path / "pr.csv"
        self.succeed("retrieve", *self.common, "--precision-recall", output)
        with open(output, newline="", encoding="utf-8") as stream:
            rows = list(csv.DictReader(stream))
        at = {(r["class"], float(r["recall"])): r for r in rows}
        self.assertEqual({r["class"] for r in rows}, {"", "a", "b"})
        # Ranks 2, 4: the precision is 1/2 of the first, 2/4 of both; with the query before, 3/5 of all three.
        self.assertAlmostEqual(float(at["", 0.5]["precision"]), (4 + 2 / 2) / 6)
        self.assertAlmostEqual(float(at["", 1]["precision"]), (4 + 2 / 2) / 6)
        self.assertAlmostEqual(float(at["", 1]["precision_with_query"]), (4 + 2 * 3 / 5) / 6)
        self.assertAlmostEqual(float(at["a", 1]["precision"]), (2 + 1 / 2) / 3)
        # No query has so little recall if it does not count.
        self.assertEqual((at["", 0.05]["precision"], at["", 0.05]["queries"]), ("", "0"))

    def test_from_meshes_to_scores(self):
        (self.path / "meshes").mkdir()
        labels = "file,class\n"
        for kind, axes in (("ball", (1, 1, 1)), ("disc", (1, 1, 0.3)), ("rod", (0.3, 0.3, 1))):
            for i in range(3):
                points, faces = icosphere(3)
                points = [tuple(a * (1 + 0.02 * i * j) * x for j, (a, x) in enumerate(zip(axes, p)))
                          for p in points]
                self.write(f"meshes/{kind}{i}.off", off(points, faces))
                labels += f"{kind}{i}.off,{kind}\n"
        labels = self.write("kinds.csv", labels)
        table = self.path / "described.csv"
        self.succeed("describe", self.path / "meshes", "-o", table)
        for distance in ("jeffrey", "jensen-shannon", "chi-squared", "l1", "earth-mover"):
            report = self.report("retrieve", table, "--labels", labels, "--distance", distance)
            self.assertEqual((report["NN"], report["FT"]), (1, 1), distance)

    def test_what_cannot_be_done(self):
        bad = self.write("bad.csv", "file,h0,h1\na,0.5,x\n")
        negative = self.write("negative.csv", "file,h0,h1\na,0.5,-1\n")
        short = self.write("short.csv", "file,h0,h1\na,0.5\n")
        nothing = self.write("nothing.csv", "file,h0,h1\n")
        twice = self.write("twice.csv", "file,h0\nx/a.off,1\ny/a.off,1\n")
        strange = self.write("strange.csv", "file,class\nzebra,striped\n")
        labels = ["--labels", self.labels]
        for code, parts, arguments in (
                (WRONG_USAGE, ["TABLE"], []),
                (WRONG_USAGE, ["nothing to do", "--labels"], [self.table]),
                (UNUSABLE_INPUT, ["nowhere.csv"], [self.path / "nowhere.csv", *labels]),
                (UNUSABLE_INPUT, ["bad.csv", "line 2", "h1", "not a number"], [bad, *labels]),
                (UNUSABLE_INPUT, ["negative.csv", "line 2", "negative"], [negative, *labels]),
                (UNUSABLE_INPUT, ["short.csv", "line 2", "2 fields"], [short, *labels]),
                (UNUSABLE_INPUT, ["nothing.csv", "no row"], [nothing, *labels]),
                (UNUSABLE_INPUT, ["labels.csv", "line 2", "h0"], [self.labels, *labels]),
                (UNUSABLE_INPUT, ["nowhere.cla"], [self.table, "--labels", self.path / "nowhere.cla"]),
                (UNUSABLE_INPUT, ["strange.csv", "none of the shapes"],
                 [self.table, "--labels", strange]),
                (WRONG_USAGE, ["zebra", "not in the table"], [self.table, "--query", "zebra"]),
                (WRONG_USAGE, ["2 rows", "x/a.off"], [twice, "--query", "a"]),
                (WRONG_USAGE, ["--distance", "l2"], [self.table, *labels, "--distance", "l2"]),
                (WRONG_USAGE, ["blocks of 12", "--bins"],
                 [self.table, *labels, "--distance", "earth-mover"]),
                (WRONG_USAGE, ["--bins", "jeffrey"], [self.table, *labels, "--bins", 2]),
                (WRONG_USAGE, ["--distances", "d.txt", ".csv or .f32"],
                 [self.table, "--distances", self.path / "d.txt"]),
                (WRONG_USAGE, ["--max-memory", "144 bytes"],
                 [self.table, "--distances", self.path / "d.f32", "--max-memory", "100"]),
                (WRONG_USAGE, ["--precision-recall", "--labels"],
                 [self.table, "--query", "a0", "--precision-recall", self.path / "pr.csv"]),
                (WRONG_USAGE, ["replace"], [self.table, "--distances", self.table]),
                (OUTPUT_NOT_WRITTEN, ["nowhere/d.csv"],
                 [self.table, "--distances", self.path / "nowhere/d.csv"])):
            with self.subTest(arguments=arguments):
                self.fail_with(code, parts, "retrieve", *arguments)


if __name__ == "__main__":
    unittest.main()
