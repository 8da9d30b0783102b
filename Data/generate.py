#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the small volumes and tip paths of this folder, or series that move; README.md says what they are."""

import argparse
import os
import sys

# Prevent __pycache__: generated data must be the only new files beside the sources.
sys.dont_write_bytecode = True

try:
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
    from vtkmodules.vtkIOImage import vtkNIFTIImageReader
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter, vtkXMLPolyDataWriter
except ModuleNotFoundError as error:
    sys.exit(f"{error}: install the Debian packages python3-vtk9 and python3-numpy, "
             "and run this with /usr/bin/python3")

import fields
import moving
import paths
import phantom

NOISE_SEED = 20021127


def write(writer, data, path):
    """Text only (base64) and compressed, so that the files survive every tool; and in place, as ParaView 5.11 with a
    newer expat (Debian's since 2.5.0-1+deb12u2) can't read data that are appended."""
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()
    writer.SetHeaderTypeToUInt32()
    writer.SetByteOrderToLittleEndian()
    writer.SetCompressorTypeToZLib()
    writer.SetCompressionLevel(9)
    writer.SetBlockSize(1 << 20)
    if writer.Write() != 1:
        sys.exit(f"cannot write {path}")
    print(f"{path}: {os.path.getsize(path)} bytes")


def write_image(path, name, values, origin, spacing, motion=None):
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetOrigin(origin)
    image.SetSpacing(spacing if isinstance(spacing, tuple) else (spacing,) * 3)
    array = numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=True)
    array.SetName(name)
    image.GetPointData().SetScalars(array)
    if motion is not None:
        displacements = numpy_to_vtk(np.ascontiguousarray(motion).reshape(-1, 3), deep=True)
        displacements.SetName("motion")
        image.GetPointData().AddArray(displacements)
    write(vtkXMLImageDataWriter(), image, path)


def write_series(folder, name, make_frame, frames, origin, spacing):
    """A file for each frame, and one with their times, a period of a second, which ParaView opens."""
    entries = []
    for frame in range(frames + 1):  # the last frame repeats the first one
        values, motion = make_frame(frame, frames)
        file = f"{name}{frame:03}.vti"
        write_image(os.path.join(folder, file), "HU", values, origin, spacing, motion)
        entries.append(f'    <DataSet timestep="{frame / frames!r}" part="0" file="{file}"/>')
    lines = ["<VTKFile type=\"Collection\" version=\"0.1\">", "  <Collection>", *entries, "  </Collection>", "</VTKFile>"]
    with open(os.path.join(folder, f"{name}.pvd"), "w", encoding="utf-8") as collection:
        collection.write("\n".join(lines) + "\n")


def read_image(path):
    """Values, origin and spacing of a .vti or NIfTI file."""
    reader = vtkXMLImageDataReader() if path.endswith(".vti") else vtkNIFTIImageReader()
    if not reader.CanReadFile(path):
        sys.exit(f"cannot read {path}: it has to be a .vti, .nii or .nii.gz file")
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    shift = reader.GetRescaleIntercept() if isinstance(reader, vtkNIFTIImageReader) else 0.0
    scalars = image.GetPointData().GetScalars()
    if scalars is None or scalars.GetNumberOfComponents() != 1 or min(image.GetDimensions()) < 2:
        sys.exit(f"cannot let {path} breathe: it needs point scalars of one component on a volume")
    values = vtk_to_numpy(scalars).reshape(image.GetDimensions()[::-1])
    return (values + values.dtype.type(shift)), image.GetOrigin(), image.GetSpacing()


def write_path(path, positions):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    line = vtkCellArray()
    line.InsertNextCell(len(positions))
    for position in positions:
        line.InsertCellPoint(points.InsertNextPoint(position))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(line)
    write(vtkXMLPolyDataWriter(), data, path)


def noisy(values, sigma):
    """Adds Gaussian noise of a fixed seed, in Hounsfield units."""
    noise = np.random.RandomState(NOISE_SEED).normal(0.0, sigma, values.shape)
    return np.rint(np.clip(values + noise, -1024, 3071)).astype(np.int16)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", help="the folder to write to; made if it is missing")
    parser.add_argument("--noise", type=float, default=0.0, metavar="SIGMA",
                        help="Gaussian noise on the head phantom, in HU (default: none)")
    parser.add_argument("--beating", type=int, metavar="FRAMES",
                        help="write a beating heart of so many frames instead: Beating.pvd")
    parser.add_argument("--breathing", metavar="CT",
                        help="write a .vti or NIfTI file that breathes instead: Breathing.pvd")
    parser.add_argument("--frames", type=int, default=8, help="of --breathing (default: 8)")
    arguments = parser.parse_args()
    if min(arguments.frames, arguments.beating or 2) < 2:
        parser.error("a series needs two frames at least")
    if not 0.0 <= arguments.noise < float("inf"):
        parser.error("--noise must be zero or a positive number of HU")
    try:
        os.makedirs(arguments.output, exist_ok=True)
    except OSError as error:
        parser.error(f"cannot make the output folder: {error}")

    if arguments.beating:
        write_series(arguments.output, "Beating", moving.beating_frame, arguments.beating,
                     (moving.BEAT_ORIGIN,) * 3, moving.BEAT_SPACING)
    if arguments.breathing:
        values, origin, spacing = read_image(arguments.breathing)
        breath = moving.Breath(values, origin, spacing)
        write_series(arguments.output, "Breathing", breath.frame, arguments.frames, origin, spacing)
    if arguments.beating or arguments.breathing:
        return

    def target(name):
        return os.path.join(arguments.output, name)

    for name, make in (("Slab", fields.slab), ("Ball", fields.ball), ("Cavity", fields.cavity),
                       ("ThinWall", fields.thin_wall)):
        field = make()
        write_image(target(f"{name}.vti"), "V", field.values, field.origin, 1.0)
    head = phantom.head_phantom()
    if arguments.noise > 0.0:
        head = noisy(head, arguments.noise)
    write_image(target("HeadPhantom.vti"), "HU", head, (phantom.ORIGIN,) * 3, phantom.SPACING)
    for name, make in (("SlabPress", paths.slab_press), ("SlabSlide", paths.slab_slide),
                       ("BallCircle", paths.ball_circle), ("CavityCircle", paths.cavity_circle)):
        write_path(target(f"{name}.vtp"), make())


if __name__ == "__main__":
    main()
