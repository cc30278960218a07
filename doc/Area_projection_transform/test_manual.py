# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The manual is made without a warning of Doxygen, asks no other host for anything, and its links lead somewhere."""

import html.parser
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ROOT / "doc" / "Area_projection_transform"
EXAMPLES = ROOT / "examples" / "Area_projection_transform"

# What a browser fetches by itself; that an <a> leads to another host is fine.
FETCHED = {"script": "src", "link": "href", "img": "src", "iframe": "src", "object": "data",
           "source": "src", "embed": "src"}

VOID = ("area", "br", "col", "hr", "img", "input", "link", "meta")  # elements without an end


class Page(html.parser.HTMLParser):
    """The places that a page has, what it fetches, what it links to, and its text without code."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.fetched, self.linked = set(), [], []
        self.text = ""
        self.code_depth = 0  # of elements, from the outermost of code on
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag in VOID:
            pass
        elif self.code_depth or tag in ("pre", "script", "style") or attributes.get("class") == "fragment":
            self.code_depth += 1
        self.anchors.update(attributes[name] for name in ("id", "name") if attributes.get(name))
        if attributes.get(FETCHED.get(tag)):
            self.fetched.append(attributes[FETCHED[tag]])
        if tag == "a" and attributes.get("href"):
            self.linked.append(attributes["href"])

    def handle_endtag(self, tag):
        if self.code_depth and tag not in VOID:
            self.code_depth -= 1

    def handle_data(self, data):
        if not self.code_depth:
            self.text += data


def is_elsewhere(address):
    parts = urllib.parse.urlsplit(address)
    return bool(parts.netloc) or parts.scheme not in ("", "data", "javascript")


def defects(folder):
    """What is wrong with the pages and style sheets of a folder, a line each."""
    pages = {path.resolve(): Page(path.read_text(encoding="utf-8")) for path in folder.rglob("*.html")}
    found = []
    for path, page in pages.items():
        found += [f"{path.name} fetches {address}" for address in page.fetched if is_elsewhere(address)]
        for address in page.fetched + page.linked:
            parts = urllib.parse.urlsplit(address)
            if is_elsewhere(address) or parts.scheme:
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            anchor = urllib.parse.unquote(parts.fragment)
            if not target.exists():
                found.append(f"{path.name} leads to {address}, which is not there")
            elif anchor and target in pages and anchor not in pages[target].anchors:
                found.append(f"{path.name} leads to {address}, a page without that place")
    for path in folder.rglob("*.css"):
        text = path.read_text(encoding="utf-8")
        found += [f"{path.name} fetches {address}"
                  for address in re.findall(r"url\(\s*[\"']?([^\"')]*)", text) if is_elsewhere(address)]
    return found


class Manual(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name) / "manual"
        cls.result = subprocess.run([ROOT / "scripts" / "manual", "--no-install", cls.folder],
                                    capture_output=True, text=True, check=False)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_no_warning(self):
        self.assertEqual(self.result.stderr, "")
        self.assertEqual(self.result.returncode, 0)

    def test_links_and_hosts(self):
        self.assertEqual(defects(self.folder), [])

    def test_formulas_are_drawn_by_a_script_of_the_manual(self):
        text = (self.folder / "index.html").read_text(encoding="utf-8")
        scripts = [a for a in Page(text).fetched if "MathJax.js" in a]
        self.assertEqual(scripts, ["mathjax/MathJax.js?config=TeX-AMS_SVG"])
        self.assertRegex(text, r"\\\[[^<]*\\\]")
        self.assertTrue((self.folder / "mathjax" / "config" / "TeX-AMS_SVG.js").exists())

    @unittest.skipUnless(shutil.which("chromium"), "chromium is not installed")
    def test_formulas_are_drawn_in_a_browser(self):
        with tempfile.TemporaryDirectory() as profile:
            page = subprocess.run(
                ["chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}",
                 "--virtual-time-budget=20000", "--dump-dom", (self.folder / "index.html").as_uri()],
                capture_output=True, text=True, timeout=120, check=True).stdout
        self.assertEqual(page.count('class="MathJax_SVG_Display"'), 4)
        self.assertNotIn("Math Processing Error", page)

    def test_markdown_is_understood(self):
        for path in [self.folder / "index.html", *self.folder.glob("md_*.html")]:
            text = Page(path.read_text(encoding="utf-8")).text
            self.assertGreater(len(text), 1000, path.name)
            self.assertEqual(re.findall(r".*(?:\*\*|`|@ref|\]\().*", text), [], path.name)

    def test_no_page_is_left_out(self):
        titles = [title.strip() for path in self.folder.glob("*.html")
                  for title in re.findall(r'<div class="title">([^<]*)', path.read_text(encoding="utf-8"))]
        wanted = [page.read_text(encoding="utf-8").splitlines()[0].lstrip("# ") for page in PAGES.glob("*.md")]
        wanted += [f"{concept.stem} Concept Reference" for concept in (PAGES / "Concepts").glob("*.h")]
        wanted += [example.name for example in EXAMPLES.glob("*.cpp")]
        self.assertGreater(len(wanted), 30)
        self.assertEqual([title for title in wanted if title not in titles], [])


class Checks(unittest.TestCase):
    """What the tests above rely on finds what it must."""

    def test_defects_are_found(self):
        for text, defect in (
                ('<script src="https://polyfill.io/v3/polyfill.min.js"></script>', "fetches https"),
                ('<script src="//cdn.example.org/x.js"></script>', "fetches //cdn"),
                ('<link href="http://example.org/a.css" rel="stylesheet"/>', "fetches http"),
                ('<img src="fig/none.png"/>', "not there"),
                ('<a href="none.html">', "not there"),
                ('<a href="#none">', "without that place"),
        ):
            with self.subTest(text), tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "index.html").write_text(text, encoding="utf-8")
                self.assertEqual(len(defects(pathlib.Path(folder))), 1)
                self.assertIn(defect, defects(pathlib.Path(folder))[0])

    def test_links_to_others_are_fine(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "index.html").write_text(
                '<a id="here" href="https://example.org">there</a><a href="index.html#here">here</a>',
                encoding="utf-8")
            self.assertEqual(defects(pathlib.Path(folder)), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
