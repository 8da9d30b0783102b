# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A burr that is pressed into a half-space removes the volume Q = mu F v/U, which its energy allows; wrong settings are
errors."""

import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk  # noqa: E402
from vtkmodules.vtkCommonCore import vtkPoints  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData  # noqa: E402

RADIUS, SPEED, FRICTION, ENERGY, SURFACE = 3.0, 30000.0, 0.3, 4.0, 7.5  # mm, 1/min, 1, J/mm^3, mm


def half_space():
    image = vtkImageData()
    image.SetDimensions(24, 24, 24)
    image.SetSpacing(0.5, 0.5, 0.5)
    image.GetPointData().SetScalars(numpy_to_vtk(numpy.repeat(1000.0 * (numpy.arange(24) > 14.5), 576), deep=True))
    image.GetPointData().GetScalars().SetName("values")
    return rig.produce(image)


def path():
    z = numpy.concatenate([numpy.linspace(4, 6, 1001), numpy.full(5000, 6.0)])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.stack([numpy.full_like(z, 5.8), numpy.full_like(z, 5.7), z], 1), deep=True))
    line = vtkPolyData()
    line.SetPoints(points)
    return rig.produce(line)


image = half_space()
simple.SetActiveSource(image)
touch = rig.VolumeHaptics(Input=image, Path=path(), Preset="CT contrast")
touch.InvokeCommand("CopyPreset")
touch.SurfaceStrength.Points = [0, 0, 0.5, 0, 499, 0, 0.5, 0, 501, 1, 0.5, 0, 1500, 1, 0.5, 0]
touch.SurfaceStrengthScale = 1000.0
touch.Tool = "Burr"
# By default, the radius is three voxels, whatever the spacing.
for factor in 1.0, 0.5:
    data = image.GetClientSideObject().GetOutputDataObject(0)
    spacing = data.GetSpacing()
    data.SetSpacing([factor * edge for edge in spacing])
    image.GetClientSideObject().Modified()
    touch.BurrRadius = 0
    whole = rig.arrays_of(touch)["RemovedVolume"].sum()
    touch.BurrRadius = 3.0 * factor * max(spacing)
    assert rig.arrays_of(touch)["RemovedVolume"].sum() == whole, factor
    data.SetSpacing(spacing)
    image.GetClientSideObject().Modified()
touch.BurrRadius = RADIUS
touch.BurrSpeed = SPEED
touch.BurrSpecificEnergy = str(ENERGY)
arrays = rig.arrays_of(touch)
rim = 2.0 * numpy.pi * RADIUS * 1e-3 * SPEED / 60.0
expected = FRICTION * rim * 1e-3 * arrays["NormalForce"].sum() / ENERGY
removed = arrays["RemovedVolume"].sum()
assert expected > 0.5, expected
assert abs(removed - expected) < 0.02 * expected, (removed, expected)

# Paths start from the tissue that a live hand has left over. No hand has removed tissue here, so these commands change
# nothing.
for command in ("UndoRemoval", "RedoRemoval", "RestoreTissue"):
    touch.InvokeCommand(command)
    assert rig.arrays_of(touch)["RemovedVolume"].sum() == removed, command

# Above 500, tissue is ten times as hard. All values here are above 500.
touch.BurrSpecificEnergy = f"0 {ENERGY}, 500 {10 * ENERGY}, 2000 {10 * ENERGY}"
assert rig.arrays_of(touch)["RemovedVolume"].sum() < 0.3 * removed
touch.BurrSpecificEnergy = "hard"
rig.expect(touch, "Burr Specific Energy")
touch.BurrSpecificEnergy = ""
touch.BurrRadius = 0.1
rig.expect(touch, "voxel")
touch.Tool = "None"
assert "RemovedVolume" not in rig.arrays_of(touch)
