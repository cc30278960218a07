# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""viewer/dist/viewer.html is committed: it must be what scripts/build-viewer makes of the sources."""

import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

VIEWER = pathlib.Path(__file__).resolve().parents[2] / "viewer"
PAGE = VIEWER / "dist" / "viewer.html"


def hash_of_sources():
    """As viewer/build.mjs computes it."""
    names = ["build.mjs", "package-lock.json", "package.json", "template.html", "viewer.css",
             *sorted(f"src/{file.name}" for file in (VIEWER / "src").iterdir())]
    lines = "".join(f"{name} {hashlib.sha256((VIEWER / name).read_bytes()).hexdigest()}\n" for name in names)
    return hashlib.sha256(lines.encode()).hexdigest()


class Viewer_page(unittest.TestCase):

    def test_was_built_since_the_sources_changed(self):
        found = re.search('<meta name="sources" content="([0-9a-f]*)">', PAGE.read_text(encoding="utf-8")).group(1)
        self.assertEqual(found, hash_of_sources(), "run scripts/build-viewer, and commit what it makes")

    @unittest.skipUnless(shutil.which("node") and shutil.which("npm"), "there is no node, or no npm")
    def test_is_what_the_sources_make(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "viewer"
            shutil.copytree(VIEWER, copy, ignore=shutil.ignore_patterns("node_modules", "dist"))
            installed = subprocess.run(["npm", "ci"], cwd=copy, capture_output=True, text=True, check=False)
            if re.search("ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ETIMEDOUT|ENETUNREACH", installed.stderr):
                self.skipTest("there is no network")
            self.assertEqual(installed.returncode, 0, installed.stderr)
            built = copy / "built.html"
            subprocess.run(["node", "build.mjs", built], cwd=copy, check=True, stdout=subprocess.DEVNULL)
            self.assertTrue(built.read_bytes() == PAGE.read_bytes(), "the page differs: run scripts/build-viewer")

    def test_holds_the_licence_of_three(self):
        text = PAGE.read_text(encoding="utf-8")
        self.assertRegex(text, "<!-- three.js [0-9.]+, which the script holds:\n\nThe MIT License\n\nCopyright © ")
        self.assertIn("The above copyright notice and this permission notice shall be included", text)
        # Browsers look for the encoding no further.
        self.assertIn(b'<meta charset="utf-8">', PAGE.read_bytes()[:1024])

    def test_needs_three_and_esbuild_only(self):
        package = json.loads((VIEWER / "package.json").read_text(encoding="utf-8"))
        self.assertEqual(set(package["devDependencies"]), {"three", "esbuild"})
        # The lock file names versions and hashes, but no registry: each has its own.
        lock = json.loads((VIEWER / "package-lock.json").read_text(encoding="utf-8"))
        for name, entry in lock["packages"].items():
            self.assertNotIn("resolved", entry, name)
            if name:
                self.assertTrue(entry["integrity"].startswith("sha512-"), name)


if __name__ == "__main__":
    unittest.main()
