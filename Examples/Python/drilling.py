# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Drill into the side of a skull: a burr moves over it layer by layer, and removes as much bone as its energy allows.

python3 drilling.py [FILE] [--picture FILE]

Without a file, the head is a phantom. FILE is a CT of a head in Hounsfield units (.mha, .mhd, .nii or .nii.gz). The
hand comes from the side of the largest x (left in LPS), behind the middle of the head; the back of the head is at the
largest y. Energies are examples.
"""
import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNIFTIImageReader
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction
from volumehaptics import examples, vtkHapticBurr, vtkVolumeHapticsFilter

from force_scene import make_actor, make_renderer, show

BONE = 300.0  # HU
RADIUS = 4.0  # mm: radius of the burr
DEPTH = 9.0  # mm: final depth of the hand in the bone
PATCH = 8.0  # mm: half of the side length of the drilled square
LAYER = 0.7  # mm: depth of a layer
SPEED = 30.0  # mm/s
BEHIND = 16.0  # mm: distance of the hole behind the centre of the head
SPRING = 2.0  # mm: distance of the hand beyond the burr: 1 N at 500 N/m


def read(file):
    reader = vtkMetaImageReader() if file.endswith((".mha", ".mhd")) else vtkNIFTIImageReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def find_bone(head):
    """Returns where a ray from the side of the largest x, behind the middle of the head, meets the bone (mm)."""
    (nx, ny, nz), (x0, y0, z0), (dx, dy, dz) = head.GetDimensions(), head.GetOrigin(), head.GetSpacing()
    first = head.GetExtent()
    values = vtk_to_numpy(head.GetPointData().GetScalars()).reshape(nz, ny, nx)
    j, k = ny // 2 + round(BEHIND / dy), nz // 2
    hit = np.nonzero(values[k, j] > BONE)[0]
    if len(hit) == 0:
        raise SystemExit(f"There is no bone (more than {BONE} HU) at the side of this head: give a CT of a head.")
    return np.array([x0 + (first[0] + hit[-1]) * dx, y0 + (first[2] + j) * dy, z0 + (first[4] + k) * dz])


def make_path(bone):
    """Returns a path that goes to and fro over a square, layer by layer, at 1000 points per second."""
    corners = []
    for layer, depth in enumerate(np.arange(0.0, DEPTH, LAYER)):
        x = bone[0] + RADIUS - depth - SPRING
        rows = np.linspace(-PATCH, PATCH, 8)
        for i, across in enumerate(rows if layer % 2 == 0 else rows[::-1]):
            ends = (-PATCH, PATCH) if (i + layer) % 2 == 0 else (PATCH, -PATCH)
            corners += [(x, bone[1] + end, bone[2] + across) for end in ends]
    corners = [(bone[0] + 2.0 * RADIUS, *corners[0][1:]), *corners]
    ways = np.linalg.norm(np.diff(corners, axis=0), axis=1)
    counts = np.maximum(1, np.ceil(ways / SPEED * 1000.0).astype(int))
    return np.concatenate([np.linspace(a, b, n, endpoint=False)
                           for a, b, n in zip(corners[:-1], corners[1:], counts)])


def drill(head, bone):
    """Runs the filter. Returns the filter, which has the removed tissue, and the trace."""
    burr = vtkHapticBurr()
    burr.SetRadius(RADIUS)
    burr.SetSolidToAbove()
    burr.SetContactValue(BONE)
    energy = burr.GetSpecificEnergy()
    energy.AddPoint(BONE, 0.5)
    energy.AddPoint(1500.0, 4.0)
    path, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(make_path(bone), deep=True))
    path.SetPoints(points)
    touch = vtkVolumeHapticsFilter()
    touch.SetInputData(0, head)
    touch.SetPathData(path)
    touch.GetProperty().ApplyPreset("CT contrast")
    touch.SetTool(burr)
    touch.Update()
    return touch, touch.GetOutput()


def make_left(head, removal):
    """Returns the head without the removed bone: V - (1 - rho) (V - air)."""
    shares = vtkImageData()
    removal.MakeShares(shares)
    rho = vtk_to_numpy(shares.GetPointData().GetScalars()) / 255.0
    values = vtk_to_numpy(head.GetPointData().GetScalars()).astype(np.float32)
    left = vtkImageData()
    left.CopyStructure(head)
    left.GetPointData().SetScalars(
        numpy_to_vtk(values - (1.0 - rho).astype(np.float32) * (values - removal.GetAirValue()), deep=True))
    left.GetPointData().AddArray(shares.GetPointData().GetScalars())
    return left


def draw_bone(left):
    """Returns an actor of the bone's surface, which is reddish where the burr was."""
    surface, colours = vtkFlyingEdges3D(), vtkColorTransferFunction()
    surface.SetInputData(left)
    surface.SetValue(0, BONE)
    surface.InterpolateAttributesOn()
    colours.AddRGBPoint(150.0, 0.86, 0.45, 0.36)
    colours.AddRGBPoint(255.0, 0.93, 0.89, 0.78)
    actor = make_actor(surface)
    mapper = actor.GetMapper()
    mapper.SetLookupTable(colours)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("RemainingShares")
    mapper.UseLookupTableScalarRangeOn()
    mapper.ScalarVisibilityOn()
    return actor


def draw_burr(place):
    ball, line, shaft = vtkSphereSource(), vtkLineSource(), vtkTubeFilter()
    ball.SetRadius(RADIUS)
    ball.SetCenter(place)
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(24)
    line.SetPoint1(place)
    line.SetPoint2(np.asarray(place) + [20.0, 34.0, 30.0])
    shaft.SetInputConnection(line.GetOutputPort())
    shaft.SetRadius(0.35 * RADIUS)
    shaft.SetNumberOfSides(24)
    actors = [make_actor(ball), make_actor(shaft)]
    for actor in actors:
        actor.GetProperty().SetColor(0.66, 0.72, 0.8)
        actor.GetProperty().SetAmbient(0.25)
        actor.GetProperty().SetSpecular(0.5)
    return actors


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", nargs="?", help="a CT of a head in Hounsfield units")
    parser.add_argument("--picture", metavar="FILE", help="write a PNG instead of opening a window")
    chosen = parser.parse_args()
    head = read(chosen.file) if chosen.file else examples.phantom()
    bone = find_bone(head)
    touch, trace = drill(head, bone)
    data = trace.GetPointData()
    removed = vtk_to_numpy(data.GetArray("RemovedVolume"))
    force = np.linalg.norm(vtk_to_numpy(data.GetArray("Force")), axis=1)
    removal = touch.GetRemoval()
    removal.ReadTrace(trace)
    print(f"{removed.sum():.0f} mm^3 in {len(removed) / 1000.0:.0f} s, with {force.mean():.2f} N on average, "
          f"{force.max():.2f} N at most")
    above = np.asarray(trace.GetPoint(len(removed) - 1)) + [2.5 * RADIUS, 0.0, 0.0]
    scene = make_renderer(draw_bone(make_left(head, removal)), *draw_burr(above))
    camera = scene.GetActiveCamera()
    camera.SetFocalPoint(bone)
    camera.SetPosition(bone + [105.0, 55.0, 45.0])
    camera.SetViewUp(0.0, 0.0, 1.0)
    scene.ResetCameraClippingRange()
    show(scene, chosen.picture)


if __name__ == "__main__":
    main()
