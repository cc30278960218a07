# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The page of mapt report in a headless Chromium: what it draws, what it answers, and what it does not do."""

import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from mapt_test import icosphere, off, run

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
from chromium_page import Page, find_chromium  # noqa: E402

NAME = "<img src=x onerror=alert(1)>.off"
SIZE = (480, 320)
FRONT = "view=0,0,0,1&panel=0"  # x to the right, y upward, the picture all over the page
NOTHING = "map=0&points=0&lines=0&holes=0"


def pixels_of(png):
    """The colours of a picture, the upper row first."""
    reader = vtkPNGReader()
    reader.SetFileName(str(png))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    colours = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return colours.reshape(height, width, -1)[::-1, :, :3].astype(int)


@unittest.skipUnless(find_chromium(), "there is no Chromium: see scripts/install-dependencies")
class Report_page(unittest.TestCase):
    """A ball of radius 1 that lost a face."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.file = cls.folder / "ball.html"
        points, faces = icosphere(3)
        mesh = cls.folder / NAME
        mesh.write_text(off(points, faces[1:]), encoding="utf-8")
        result = run("report", mesh, "-o", cls.file, "--resolution", "40")
        assert result.returncode == 0, result.stderr

    def open(self, state="", **settings):
        """The page with a state, when it has drawn its first picture."""
        page = Page(f"{self.file.as_uri()}#{state}", **{"size": SIZE, **settings})
        self.addCleanup(page.__exit__)
        page.wait_for("document.body?.matches('.ready, .failed')")
        return page

    def picture(self, page):
        page.wait_for("document.body.matches('.refined')")
        # What lies over the picture is not of it.
        page.evaluate("document.querySelectorAll('.stage > :not(canvas)').forEach((e) => e.style.visibility = 'hidden')")
        file = self.folder / "picture.png"
        file.write_bytes(page.screenshot())
        return pixels_of(file)

    def shape(self, page):
        """Where the picture is not the ground."""
        colours = self.picture(page)
        return abs(colours - colours[2, 2]).max(axis=2) > 8


class Picture(Report_page):

    def test_is_of_the_right_size_and_place(self):
        shape = self.shape(self.open(f"{FRONT}&{NOTHING}&mesh=1"))
        # The ball around the box, of radius sqrt(3), fills the shorter side but for 2 %.
        radius = SIZE[1] / 2 / 1.02 / math.sqrt(3)
        self.assertAlmostEqual(shape.sum() / (math.pi * radius ** 2), 1, delta=0.01)
        y, x = shape.nonzero()
        self.assertAlmostEqual(x.mean(), SIZE[0] / 2 - 0.5, delta=1)
        self.assertAlmostEqual(y.mean(), SIZE[1] / 2 - 0.5, delta=1)

    def test_shows_the_map_inside_the_surface(self):
        middle = numpy.s_[155:165, 235:245]
        with_map = self.picture(self.open(f"{FRONT}&points=0&lines=0"))[middle].mean(axis=(0, 1))
        without = self.picture(self.open(f"{FRONT}&points=0&lines=0&map=0"))[middle].mean(axis=(0, 1))
        self.assertLess(without.max() - without.min(), 25)  # grey
        self.assertGreater(with_map[1] - with_map[2], 40)  # the last colour of viridis is yellow, before it green

    def test_is_cut_by_planes(self):
        shape = self.shape(self.open(f"{FRONT}&{NOTHING}&mesh=1&clip=0,0.5,0,1,0,1"))
        middle = SIZE[0] // 2
        self.assertEqual(shape[:, middle + 2:].sum(), 0)
        radius = SIZE[1] / 2 / 1.02 / math.sqrt(3)
        self.assertAlmostEqual(shape[:, :middle].sum() / (math.pi * radius ** 2 / 2), 1, delta=0.02)

    def test_shows_edges_of_holes_in_green(self):
        colours = self.picture(self.open(f"{NOTHING}&holes=1&mesh=0"))
        green = (colours[:, :, 1] - colours[:, :, [0, 2]].max(axis=2)) > 60
        self.assertGreater(green.sum(), 20)

    def test_is_dark_if_wanted(self):
        self.assertGreater(self.picture(self.open())[2, 2].min(), 200)
        self.assertLess(self.picture(self.open("theme=dark"))[2, 2].max(), 60)
        self.assertLess(self.picture(self.open(dark=True))[2, 2].max(), 60)
        self.assertGreater(self.picture(self.open("theme=light", dark=True))[2, 2].min(), 200)


class Behaviour(Report_page):

    def test_makes_no_errors_and_no_requests(self):
        page = self.open()
        self.assertEqual(page.errors, [])
        self.assertEqual(page.requests, [self.file.as_uri()])
        self.assertEqual(page.evaluate("document.querySelector('h1').textContent"), NAME)
        self.assertEqual(page.evaluate("document.images.length"), 0)
        self.assertIn("'none'", page.evaluate("fetch('http://localhost/').catch(String).then(() => document.querySelector('meta[http-equiv]').content)"))
        self.assertTrue(any("Content Security Policy" in text for text in page.errors), page.errors)

    def test_state_is_that_of_the_address(self):
        page = self.open("scale=2&threshold=0.3&mip=1&points=0&clip=0,0.5,0,1,0,1&mesh=0.5&nonsense=1&zoom=x")

        def value(key, what="value"):
            return page.evaluate(f"document.querySelector('[data-key=\"{key}\"]').{what}")

        self.assertEqual(float(value("scale")), 2)
        self.assertAlmostEqual(float(value("threshold")), 0.3, delta=0.01)
        self.assertTrue(value("mip", "checked"))
        self.assertFalse(value("points", "checked"))
        self.assertEqual(float(value("clip1")), 0.5)
        self.assertEqual(float(value("mesh")), 0.5)
        self.assertIn("R = ", page.evaluate("document.querySelector('.bar-title').textContent"))

    def test_stands_an_address_that_makes_no_sense(self):
        page = self.open("scale=99&zoom=0&top=0&palette=x&pointcolour=__proto__&select=7&view=0,0,0,0&clip=1,0,1,0,1,0&constructor=1&select=0.5&map=9&mesh=-1")
        self.assertEqual(page.errors, [])
        self.assertTrue(page.evaluate("document.body.matches('.ready')"))

    def test_slider_changes_map_and_address(self):
        page = self.open(f"{FRONT}&points=0&lines=0")
        before = self.picture(page)
        page.evaluate("{ const s = document.querySelector('[data-key=scale]'); s.value = 0; s.dispatchEvent(new Event('input')); }")
        page.wait_for("location.hash.includes('scale=0')")
        self.assertIn("R = ", page.evaluate("document.querySelector('.bar-title').textContent"))
        page.wait_for("document.body.matches('.refined')")
        self.assertGreater(abs(self.picture(page) - before).max(), 40)

    def test_pointer_is_answered(self):
        page = self.open(FRONT)
        page.move_mouse(SIZE[0] / 2, SIZE[1] / 2)
        page.wait_for("!document.querySelector('.note').hidden")
        text = page.evaluate("document.querySelector('.note').innerText")
        self.assertIn("Salient point 1: sphere", text)
        # The vertices lie on the sphere.
        self.assertAlmostEqual(float(re.search(r"R\s+([\d.]+) ±", text).group(1)), 1, delta=0.005)
        page.move_mouse(SIZE[0] - 5, 160)
        page.wait_for("document.querySelector('.note').hidden")

        page = self.open(f"{FRONT}&points=0&lines=0")
        page.move_mouse(SIZE[0] / 2, SIZE[1] / 2)
        page.wait_for("!document.querySelector('.note').hidden")
        text = page.evaluate("document.querySelector('.note').innerText")
        # At the centre all of the surface projects into the ball of each radius R down to 2/3: MAPT is 1/R^2.
        radius = float(re.search(r"R\s+([\d.]+)", text).group(1))
        self.assertTrue(2 / 3 - 0.01 < radius < 1, text)
        self.assertAlmostEqual(float(re.search(r"MAPT\s+([\d.]+)", text).group(1)) * radius ** 2, 1, delta=0.03)

    def test_table_selects_points(self):
        page = self.open()
        page.evaluate("document.querySelector('tbody tr').click()")
        page.wait_for("location.hash.includes('select=0')")
        self.assertEqual(page.evaluate("document.querySelectorAll('.halo circle').length"), 1)
        self.assertEqual(page.evaluate("document.querySelector('tbody tr').ariaSelected"), "true")

    def test_keys_work(self):
        page = self.open()
        for key, address in [("m", "mip=1"), ("]", "scale=0"), ("p", "points=0"), ("z", "view=0,0,0,1")]:
            page.press(key)
            page.wait_for(f"location.hash.includes('{address}')", 5)
        page.press("0")
        page.wait_for("!location.hash.includes('view')", 5)

    def test_fits_a_phone(self):
        page = self.open(size=(360, 740))
        self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), 360)
        self.assertGreaterEqual(page.evaluate("document.querySelector('.panel').getBoundingClientRect().top"),
                                page.evaluate("document.querySelector('.stage').getBoundingClientRect().bottom") - 1)

    def test_says_what_the_browser_lacks(self):
        for before, word in [("delete globalThis.DecompressionStream", "DecompressionStream"),
                             ("HTMLCanvasElement.prototype.getContext = () => null", "WebGL 2")]:
            page = self.open(before=before)
            self.assertTrue(page.evaluate("document.body.matches('.failed')"))
            self.assertIn(word, page.evaluate("document.body.innerText"))

    def test_says_that_a_file_is_damaged(self):
        text = self.file.read_text(encoding="utf-8")
        start = text.index('<script id="arrays" type="text/plain">') + 200
        damaged = self.folder / "damaged.html"
        damaged.write_text(text[:start] + text[start + 400:], encoding="utf-8")
        page = Page(damaged.as_uri(), SIZE)
        self.addCleanup(page.__exit__)
        page.wait_for("document.body?.matches('.refined, .failed')")
        self.assertIn("damaged", page.evaluate("document.body.innerText"))


class Render(Report_page):

    def render(self, *arguments):
        return subprocess.run([sys.executable, SCRIPTS / "render", *map(str, arguments)], capture_output=True, text=True,
                              timeout=120, check=False)

    def test_makes_the_same_picture_again(self):
        files = [self.folder / "one.png", self.folder / "two.png"]
        for file in files:
            result = self.render(self.file, "-o", file, "--state", "#view=0,0,0,1&mip=1", "--size", "300x200", "--scale", "2")
            self.assertEqual(result.returncode, 0, result.stderr)
        first, second = map(pixels_of, files)
        self.assertEqual(first.shape[:2], (400, 600))
        self.assertGreater(first.std(), 5)
        self.assertLess(abs(first - second).mean(), 1)

    def test_fails_in_one_line(self):
        (self.folder / "empty.html").write_text("<!doctype html><body class=failed>nothing")
        for arguments, text in [([self.folder / "none.html", "-o", self.folder / "p.png"], "no such file"),
                                ([self.folder / "empty.html", "-o", self.folder / "p.png"], "nothing"),
                                ([self.file, "-o", self.folder / "no" / "p.png"], "no/p.png")]:
            result = self.render(*arguments)
            self.assertEqual(result.returncode, 1)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
            self.assertIn(text, result.stderr)
            self.assertFalse((self.folder / "p.png").exists())


if __name__ == "__main__":
    unittest.main()
