# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the trace of a hand on the head, coloured by force, over the volume rendering: a new user's first picture.

Compares it with Testing/Data/Baseline/ParaViewHead.png; the new picture is in the output folder.
"""

import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkIOImage import vtkPNGReader  # noqa: E402

# Colours and opacities by Hounsfield units: the skull is visible through the skin.
COLOURS = [-1000, 0.55, 0.3, 0.2, -300, 0.78, 0.52, 0.4, 60, 0.9, 0.66, 0.52, 400, 0.97, 0.93, 0.85, 2000, 1, 1, 0.96]
OPACITY = [-1000, 0, 0.5, 0, -500, 0, 0.5, 0, -300, 0.35, 0.5, 0, 150, 0.2, 0.5, 0, 300, 0.2, 0.5, 0, 900, 0.9, 0.5, 0]
LARGEST_ERROR = 0.4  # mean over all pixels, of 255; the trail covers a hundredth of the pixels
SIZE = [520, 440]


def show_head(head, view):
    shown = simple.Show(head, view)
    simple.ColorBy(shown, ("POINTS", "HU"))
    shown.SetRepresentationType("Volume")
    shown.LookupTable.RGBPoints = COLOURS
    shown.LookupTable.ColorSpace = "RGB"
    shown.ScalarOpacityFunction.Points = OPACITY
    shown.ScalarOpacityUnitDistance = 4.0
    shown.Shade = 1
    shown.SetScalarBarVisibility(view, False)


def show_trace(touch, view):
    tube = simple.Tube(Input=touch, Radius=2.0, Scalars=["POINTS", ""], Vectors=["POINTS", ""])
    shown = simple.Show(tube, view)
    simple.ColorBy(shown, ("POINTS", "Force", "Magnitude"))
    colours = shown.LookupTable
    colours.ApplyPreset("Plasma (matplotlib)", True)
    colours.RescaleTransferFunction(0.0, 4.0)
    bar = simple.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = "Force (N)", ""
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength = [0.82, 0.25], 0.5
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.0f", "%.0f"
    bar.TitleFontSize, bar.LabelFontSize = 18, 16
    shown.SetScalarBarVisibility(view, True)


view = simple.CreateView("RenderView", ViewSize=SIZE)
view.UseColorPaletteForBackground = 0
view.Background = [0.09, 0.11, 0.14]
view.OrientationAxesVisibility = 0
head = rig.read("Head.vti")
simple.SetActiveSource(head)
# The path starts outside over the left temple, runs through the forehead, and leaves over the right temple.
path = rig.HapticPath(Shape="Circle", Center=[0, 9, 52], Radius=81.0, Turns=0.5, Normal=[0.05, -0.1, -1])
touch = rig.VolumeHaptics(Input=head, Path=path, Preset="CT contrast", Scalars=["POINTS", "HU"])
arrays = rig.arrays_of(touch)
assert numpy.linalg.norm(arrays["Force"], axis=1).max() > 0.3
show_head(head, view)
show_trace(touch, view)
simple.Render(view)  # the first rendering resets the camera
view.CameraPosition = [-260, -480, 150]
view.CameraFocalPoint = [18, 0, -4]
view.CameraViewUp = [0, 0, 1]
view.CameraViewAngle = 27
simple.Render(view)
picture = os.path.join(rig.OUTPUT, "head.png")
simple.SaveScreenshot(picture, view, ImageResolution=SIZE)


def pixels(file):
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(float)


baseline = os.path.join(rig.SOURCE, "Testing", "Data", "Baseline", "ParaViewHead.png")
error = numpy.abs(pixels(picture) - pixels(baseline)).mean()
print(f"mean error of a pixel: {error:.3f} of 255")
assert error <= LARGEST_ERROR, f"{picture} is not {baseline}: the mean error is {error:.2f} of 255"
