# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes .vti files of scans in formats that the explorer does not read, and thick and noisy versions of the head CT.

usage: convert_scans.py FOLDER HEAD

FOLDER is that of get_real_volumes in scans.sh: the packages are unpacked below it, the results are written to it.
HEAD is the head CT (.mhd). Takes VTK's Python modules and NumPy, as Debian has them.
"""
import base64
import pathlib
import struct
import sys
import zlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkTIFFReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth


def write(file, samples, spacing):
    """Samples are [z, y, x]; lengths are millimetres."""
    image = vtkImageData()
    image.SetDimensions(samples.shape[::-1])
    image.SetSpacing(spacing)
    scalars = numpy_to_vtk(numpy.ascontiguousarray(samples).ravel(), deep=True)
    scalars.SetName("values")
    image.GetPointData().SetScalars(scalars)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(file))
    if writer.Write() != 1:
        raise SystemExit(f"{file} can't be written.")


def samples_of(image):
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])


def read_tiff(file):
    """A stack of pages, which has no spacing: voxels of 1 mm."""
    reader = vtkTIFFReader()
    reader.SetFileName(str(file))
    reader.Update()
    return samples_of(reader.GetOutput())


def read_den(file):
    """VolPack's format: 14 numbers of 3 shorts around a version, the count of warps and the length; then the bytes."""
    data = file.read_bytes()
    size = struct.unpack_from("<3h", data, 50)
    length = struct.unpack_from("<i", data, 58)[0]
    if length != size[0] * size[1] * size[2]:
        raise SystemExit(f"{file} is not laid out as VolPack's densities are.")
    return numpy.frombuffer(data, numpy.uint8, length, 62).reshape(size[::-1])


def read_ssdf(file, name):
    """An array of a file of visvis: blocks of zlib in base64."""
    for line in file.read_text().splitlines():
        if line.startswith(f"{name} = array "):
            shape, kind, text = line.split()[3:6]
            data = b"".join(zlib.decompress(base64.b64decode(block)) for block in text.split(";"))
            return numpy.frombuffer(data, kind).reshape([int(n) for n in shape.split("x")])
    raise SystemExit(f"{file} has no array {name}.")


def smooth(samples):
    """By a Gaussian of one voxel."""
    image = vtkImageData()
    image.SetDimensions(samples.shape[::-1])
    image.GetPointData().SetScalars(numpy_to_vtk(samples.ravel(), deep=True))
    blur = vtkImageGaussianSmooth()
    blur.SetInputData(image)
    blur.SetStandardDeviation(1.0)
    blur.Update()
    return samples_of(blur.GetOutput())


def main():
    folder, head = pathlib.Path(sys.argv[1]), sys.argv[2]
    packages = folder / "packages"
    for scan, pixels in (("shell", "225x128x128"), ("bone", "128x128x128"), ("fly", "150x256x256"),
                         ("fibers", "150x150x150"), ("NT", "128x128x128")):
        write(folder / f"{scan}.vti", read_tiff(packages / f"qim3d/examples/{scan}_{pixels}.tif"), (1, 1, 1))
    # Use 128 of the 256 pixels, which are 0.9375 mm wide; the distance of the slices is about 1.875 mm, too.
    write(folder / "volpack.vti",
          read_den(packages / "usr/share/doc/libvolpack1-dev/examples/brainsmall.den"), (1.875, 1.875, 1.875))
    write(folder / "stent.vti", read_ssdf(packages / "visvis/visvisResources/stent_vol.ssdf", "vol"), (1, 1, 1))

    reader = vtkMetaImageReader()
    reader.SetFileName(head)
    reader.Update()
    image = reader.GetOutput()
    samples, spacing = samples_of(image), image.GetSpacing()
    for step in (2, 4):
        write(folder / f"head-slice{step}.vti", samples[::step], (spacing[0], spacing[1], step * spacing[2]))
    white = numpy.random.default_rng(1).standard_normal(samples.shape)
    smoothed = smooth(white)
    smoothed /= smoothed.std()
    for noise in (20, 35, 60):
        for name, unit in (("white", white), ("smooth", smoothed)):
            write(folder / f"head-{name}{noise}.vti",
                  numpy.rint(samples + noise * unit).astype(numpy.int16), spacing)


main()
