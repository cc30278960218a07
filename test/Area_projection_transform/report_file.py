# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Reads a page of mapt report without a browser, by what tool/page_arrays.h says."""

import base64
import html.parser
import json
import zlib

import numpy


class Elements(html.parser.HTMLParser):
    """The elements of a page as a parser sees them: (name, attributes, text up to the next tag)."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.elements, self._is_open = [], False
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.elements.append([tag, dict(attrs), ""])
        self._is_open = True

    def handle_endtag(self, tag):
        self._is_open = False

    def handle_data(self, data):
        if self._is_open:
            self.elements[-1][2] += data

    def find(self, tag, **attributes):
        return [e for e in self.elements if e[0] == tag and attributes.items() <= e[1].items()]


class Report:

    def __init__(self, file):
        self.text = file.read_bytes().decode()
        self.page = Elements(self.text)
        self.json = json.loads(self.page.find("script", id="report")[0][2])
        self.arrays = self.page.find("script", id="arrays")[0][2]
        self.bytes = numpy.frombuffer(zlib.decompress(base64.b64decode(self.arrays)), numpy.uint8)

    def _slice(self, entry, width):
        return self.bytes[entry["offset"]:entry["offset"] + width * entry["number"]]

    def floats(self, entry):
        return self._slice(entry, 4).view("<f4")

    def integers(self, entry):
        planes = self._slice(entry, 4).reshape(4, -1).astype(numpy.int64)
        folded = planes[0] + (planes[1] << 8) + (planes[2] << 16) + (planes[3] << 24)
        differences = (folded >> 1) ^ -(folded & 1)
        return differences.reshape(-1, entry["stride"]).cumsum(axis=0)

    def points(self, entry):
        lattice = self.json["lattice"]
        return lattice["origin"] + lattice["step"] * self.integers(entry)

    def voxels(self, entry):
        """By z, y, x."""
        differences = self._slice(entry, 1).reshape(entry["size"][::-1])
        return differences.cumsum(axis=1, dtype=numpy.uint8).cumsum(axis=2, dtype=numpy.uint8)
