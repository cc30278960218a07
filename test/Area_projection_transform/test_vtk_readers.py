# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The files of the command mapt in the hands of VTK, and VTK's files in those of the command.

The environment names the command (MAPT) and the folder of the bundled meshes (MAPT_DATA). Only the
modules of VTK that read and write files are imported: the whole of it wants MPI for NRRD.
"""

import itertools
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkNrrdReader
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataReader,
    vtkXMLImageDataWriter,
    vtkXMLPolyDataWriter,
)

MAPT = os.environ.get("MAPT", "mapt")
DATA = pathlib.Path(os.environ.get("MAPT_DATA", "data"))

CENTRE = numpy.array([10.3, -4.7, 2.1])
RADIUS = 1.0
VOXEL = 0.1


def icosphere(subdivisions):
    """Points on the unit sphere and triangles with outward normals."""
    t = (1 + math.sqrt(5)) / 2
    points = [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t),
              (0, -1, -t), (0, 1, -t), (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    points = [numpy.array(p) / numpy.linalg.norm(p) for p in points]
    for _ in range(subdivisions):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                p = points[a] + points[b]
                points.append(p / numpy.linalg.norm(p))
            return middles[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return numpy.array(points), numpy.array(faces)


def write_off(name, points, faces):
    with open(name, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        for p in points:
            file.write(" ".join(repr(float(x)) for x in p) + "\n")
        for f in faces:
            file.write(f"3 {f[0]} {f[1]} {f[2]}\n")


def mapt(*arguments):
    """Runs the command and returns the JSON object it prints."""
    run = subprocess.run([MAPT, *map(str, arguments), "--json"], capture_output=True, text=True,
                         timeout=300, check=False)
    assert run.returncode == 0, f"exit {run.returncode}\n{run.stdout}\n{run.stderr}"
    return json.loads(run.stdout)


def read_vti(name):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(name))
    reader.Update()
    return reader.GetOutput()


def arrays_of(image):
    data = image.GetPointData()
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
            for i in range(data.GetNumberOfArrays())}


def place(image, index):
    """Where the voxel with that index is, as VTK says."""
    return numpy.array(image.GetPoint(int(index)))


def poly_data(points, faces):
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points.astype(numpy.float32), deep=True))
    data.SetPoints(vtk_points)
    cells = vtkCellArray()
    rows = faces if faces is not None else numpy.arange(len(points)).reshape(-1, 1)
    cells.SetData(rows.shape[1], numpy_to_vtkIdTypeArray(rows.astype(numpy.int64).ravel(), deep=True))
    if faces is not None:
        data.SetPolys(cells)
    else:
        data.SetVerts(cells)
    normals = numpy_to_vtk(points.astype(numpy.float32), deep=True)
    normals.SetName("Normals")
    data.GetPointData().SetNormals(normals)
    return data


def modes():
    """All ways in which VTK's writers store data."""
    for mode, compress, header, encode in itertools.product(
            ("Ascii", "Binary", "Appended"), (False, True), (32, 64), (False, True)):
        if mode == "Appended" or not encode:
            yield mode, compress, header, encode


def write_with_vtk(writer, name, data, mode):
    kind, compress, header, encode = mode
    writer.SetFileName(str(name))
    writer.SetInputData(data)
    getattr(writer, f"SetDataModeTo{kind}")()
    getattr(writer, "SetCompressorTypeTo" + ("ZLib" if compress else "None"))()
    getattr(writer, f"SetHeaderTypeToUInt{header}")()
    writer.SetEncodeAppendedData(encode)
    assert writer.Write() == 1


class Maps(unittest.TestCase):
    """A map of a sphere whose centre is nowhere in particular."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        points, faces = icosphere(4)
        write_off(cls.path / "sphere.off", CENTRE + RADIUS * points, faces)
        for name, options in (("zlib.vti", []), ("raw.vti", ["--no-compress"]),
                              ("zlib.nrrd", []), ("raw.nrrd", ["--no-compress"])):
            mapt("transform", cls.path / "sphere.off", "-o", cls.path / name, "--radii", RADIUS,
                 "--voxel", VOXEL, "--side", "inside", *options)
        cls.image = read_vti(cls.path / "raw.vti")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_maximum_is_at_the_centre(self):
        arrays = arrays_of(self.image)
        self.assertEqual(self.image.GetSpacing(), (VOXEL, VOXEL, VOXEL))
        self.assertEqual(set(arrays), {"JMAPT", "SMAPT"})
        values = arrays["JMAPT"]
        # all voxels within sigma of the centre see the whole sphere: the middle of them counts
        best = numpy.flatnonzero(values >= values.max() * (1 - 1e-3))
        middle = numpy.mean([place(self.image, i) for i in best], axis=0)
        self.assertLess(numpy.abs(middle - CENTRE).max(), VOXEL)
        self.assertAlmostEqual(values.max(), 1, delta=0.02)
        self.assertEqual(arrays["SMAPT"][best[0]], RADIUS)

    def test_vti_values_do_not_depend_on_compression(self):
        other = read_vti(self.path / "zlib.vti")
        self.assertLess((self.path / "zlib.vti").stat().st_size,
                        (self.path / "raw.vti").stat().st_size)
        self.assertEqual(other.GetDimensions(), self.image.GetDimensions())
        self.assertEqual(other.GetOrigin(), self.image.GetOrigin())
        for name, values in arrays_of(self.image).items():
            numpy.testing.assert_array_equal(arrays_of(other)[name], values)

    def test_nrrd_has_the_values_of_vti(self):
        reader = vtkNrrdReader()
        reader.SetFileName(str(self.path / "raw.nrrd"))
        reader.Update()
        image = reader.GetOutput()
        self.assertEqual(image.GetDimensions(), self.image.GetDimensions())
        self.assertEqual(image.GetOrigin(), self.image.GetOrigin())
        self.assertEqual(image.GetSpacing(), self.image.GetSpacing())
        values = vtk_to_numpy(image.GetPointData().GetScalars())
        for component, name in enumerate(("JMAPT", "SMAPT")):
            numpy.testing.assert_array_equal(values[:, component], arrays_of(self.image)[name])

    def test_compressed_nrrd_has_the_bytes_of_the_raw_one(self):
        # not by VTK, which reads a part only of compressed data with several components
        raw = (self.path / "raw.nrrd").read_bytes().split(b"\n\n", 1)
        compressed = (self.path / "zlib.nrrd").read_bytes().split(b"\n\n", 1)
        self.assertIn(b"encoding: gzip\n", compressed[0])
        self.assertEqual(zlib.decompress(compressed[1], 31), raw[1])

    def test_parameters_are_recorded(self):
        data = self.image.GetFieldData()
        self.assertEqual(vtk_to_numpy(data.GetArray("radii")).tolist(), [RADIUS])
        self.assertEqual(vtk_to_numpy(data.GetArray("sigma_ratio")).tolist(), [0.5])
        self.assertEqual(data.GetAbstractArray("side").GetValue(0), "inside")
        for name in ("normals", "method", "version"):
            self.assertTrue(data.GetAbstractArray(name).GetValue(0), name)

    def test_bundled_mesh(self):
        mesh = DATA / "hand.obj"
        if not mesh.exists():
            self.skipTest(f"{mesh} is not there")
        mapt("transform", mesh, "-o", self.path / "hand.vti", "-n", 2)
        image = read_vti(self.path / "hand.vti")
        values = arrays_of(image)["JMAPT"]
        self.assertEqual(values.size, image.GetNumberOfPoints())
        self.assertTrue(numpy.isfinite(values).all())
        self.assertGreater(values.max(), 0)


class Files_of_vtk(unittest.TestCase):
    """What VTK writes is read, however it is stored."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def test_meshes(self):
        points, faces = icosphere(2)
        data = poly_data(points, faces)
        for mode in modes():
            with self.subTest(mode=mode):
                write_with_vtk(vtkXMLPolyDataWriter(), self.path / "mesh.vtp", data, mode)
                info = mapt("info", self.path / "mesh.vtp")
                self.assertEqual(info["vertices"], len(points))
                self.assertEqual(info["faces"], len(faces))

    def test_points(self):
        points, _ = icosphere(2)
        write_with_vtk(vtkXMLPolyDataWriter(), self.path / "points.vtp", poly_data(points, None),
                       ("Appended", True, 64, False))
        info = mapt("info", self.path / "points.vtp")
        self.assertEqual(info["vertices"], len(points))
        self.assertEqual(info["faces"], 0)

    def test_maps(self):
        values = numpy.linspace(0, 1, 4 * 5 * 6).astype(numpy.float32)
        image = vtkImageData()
        image.SetDimensions(4, 5, 6)
        image.SetOrigin(1, 2, 3)
        image.SetSpacing(0.5, 0.5, 0.5)
        array = numpy_to_vtk(values, deep=True)
        array.SetName("JMAPT")
        image.GetPointData().SetScalars(array)
        for mode in modes():
            with self.subTest(mode=mode):
                write_with_vtk(vtkXMLImageDataWriter(), self.path / "map.vti", image, mode)
                mapt("info", self.path / "map.vti")


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=1))
