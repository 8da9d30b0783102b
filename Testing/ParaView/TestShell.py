# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A ball-shaped tool that is pressed into a half-space has the force of the closed form; wrong settings are errors.

A ball of radius a whose points are pressed with kappa = k/A is in balance with the hand's spring c, 2 mm beyond the
surface, at the depth delta where c (2 mm - delta) = pi kappa a delta^2.
"""

import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk  # noqa: E402
from vtkmodules.vtkCommonCore import vtkPoints  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData  # noqa: E402

RADIUS, SURFACE, STIFFNESS, COUPLING, AREA = 3.0, 8.0, 500.0, 500.0, 25.0  # mm, mm, N/m, N/m, mm^2


def ramp():
    image = vtkImageData()
    image.SetDimensions(16, 16, 16)
    image.GetPointData().SetScalars(numpy_to_vtk(numpy.repeat(100.0 * numpy.arange(16.0), 256), deep=True))
    image.GetPointData().GetScalars().SetName("values")
    return rig.produce(image)


def path():
    z = numpy.concatenate([numpy.linspace(4, 7, 101), numpy.full(50, 7.0)])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.stack([numpy.full_like(z, 7.0), numpy.full_like(z, 7.0), z], 1), deep=True))
    line = vtkPolyData()
    line.SetPoints(points)
    return rig.produce(line)


image = ramp()
simple.SetActiveSource(image)
ball = simple.Sphere(Radius=RADIUS, ThetaResolution=200, PhiResolution=100)
touch = rig.VolumeHaptics(Input=image, Path=path(), Preset="CT contrast")
touch.InvokeCommand("CopyPreset")
touch.Stiffness.Points = [0, 0.5, 0.5, 0, 1500, 0.5, 0.5, 0]
touch.StiffnessScale = 2 * STIFFNESS
touch.SurfaceStrength.Points = [0, 0, 0.5, 0, 799, 0, 0.5, 0, 801, 1, 0.5, 0, 1500, 1, 0.5, 0]
touch.SurfaceStrengthScale = 1000.0

touch.Tool = "Point shell"
rig.expect(touch, "Choose closed polygons as Surface")
touch.Surface = ball
arrays = rig.arrays_of(touch)
kappa = STIFFNESS / (AREA * 1e-6)
b = COUPLING / (numpy.pi * kappa * RADIUS * 1e-3)
delta = 0.5 * (numpy.sqrt(b * b + 4.0 * b * 2e-3) - b)
force = COUPLING * (2e-3 - delta)
assert abs(arrays["Force"][-1, 2] + force) < 0.01 * force, (arrays["Force"][-1], force)
assert abs(arrays["Proxy"][-1, 2] - (SURFACE - RADIUS + 1e3 * delta)) < 0.02, arrays["Proxy"][-1]
assert {"Torque", "ToolOrientation"} <= set(arrays)

# A larger ball is a different tool, even if the polygons are changed in place.
ball.Radius = 3.5
touch.UpdatePipeline()
assert abs(rig.arrays_of(touch)["Force"][-1, 2]) > 1.1 * force
ball.EndTheta = 180.0
rig.expect(touch, "closed")
ball.EndTheta = 360.0
touch.Tool = "None"
assert "Torque" not in rig.arrays_of(touch)
