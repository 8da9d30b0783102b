# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures that error texts name for moving volumes, surfaces, modes, tools and paths, on the bench of
cure_bench.py."""

import math
import re

import numpy as np
import pytest
from TestCures import RAMP
from cure_bench import FORCES, TOLD, Bench, Calls, Cases, ball, filtered, hold_ball, table, times, told
from cure_bench import try_calls, try_case, vectors
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkImagingCore import vtkImageReslice
from vtkmodules.vtkImagingGeneral import vtkImageGaussianSmooth
from volumehaptics import (
    image,
    vtkHapticBurr,
    vtkHapticDevice,
    vtkHapticTimeStepSource,
    vtkHapticGuideMode,
    vtkHapticMode,
    vtkHapticNeedle,
)
from volumehaptics._touch import Errors
from volumehaptics.arrays import arrays

case, result = Cases(), Calls()


# -- moving volumes: two equal time steps --

def frames(b, *images, name=None):
    source = vtkHapticTimeStepSource()
    for time, one in enumerate(images or (b.image, b.image)):
        source.AddTimeStep(one, float(time))
    b.haptics.SetInputConnection(source.GetOutputPort())
    b.haptics.SetTimeUnitsPerSecond(1.0)
    if name:
        b.haptics.SetDisplacementArrayName(name)
    return source


def ramp(values=RAMP, **place):
    one = vtkImageData()
    one.DeepCopy(image(values, **place))
    return one


@case("Give all time steps the same array")
def _(b):
    other = ramp()
    other.GetPointData().Initialize()
    source = frames(b, b.image, other)
    values = numpy_to_vtk(RAMP.reshape(-1), deep=True)
    values.SetName(b.points.GetScalars().GetName())

    def cure():
        other.GetPointData().SetScalars(values)
        source.Modified()
    return cure


@case("Resample them to one geometry, for example with vtkImageReslice")
def _(b):
    fine = image(np.broadcast_to(50.0 * np.arange(63.0).reshape(-1, 1, 1), (63, 17, 24)).copy(), spacing=(1, 1, 0.5))
    frames(b, b.image, fine)
    reslice = vtkImageReslice()
    reslice.SetInputData(fine)
    reslice.SetInformationInput(b.image)
    reslice.SetInterpolationModeToLinear()

    def cure():
        reslice.Update()
        frames(b, b.image, reslice.GetOutput())
    return cure


@case("or stop time with SetTimeUnitsPerSecond(0).")
def _(b):
    frames(b, b.image, image(RAMP[:20]))
    return lambda: b.haptics.SetTimeUnitsPerSecond(0.0)


@case("Choose another method, or stop time with SetTimeUnitsPerSecond(0)")
def _(b):
    frames(b)
    b.haptics.SetMethodToPrimitives()
    return b.haptics.SetMethodToProxy


@case("give points whose motion is not known the displacement 0")
def _(b):
    motion = numpy_to_vtk(np.zeros((RAMP.size, 3)), deep=True)
    motion.SetName("motion")
    motion.SetComponent(77, 1, math.nan)
    b.points.AddArray(motion)
    source = frames(b, name="motion")
    return lambda: (motion.SetComponent(77, 1, 0.0), motion.Modified(), b.image.Modified(), source.Modified())


@case("or remove the needle with SetTool(nullptr)")
def _(b):
    frames(b)
    b.haptics.SetTool(vtkHapticNeedle())
    return lambda: b.haptics.SetTool(None)


@case("Stop time with SetTimeUnitsPerSecond(0), or remove the tool", "ball")
def _(b):
    frames(b)
    hold_ball(b, ball())
    return lambda: b.haptics.SetTimeUnitsPerSecond(0.0)


@case("or take SetFramesToTimeSteps()")
def _(b):
    b.haptics.SetFramesToComponents()
    b.haptics.SetTimeUnitsPerSecond(1.0)
    return b.haptics.SetFramesToTimeSteps


@case('or take SetDisplacementArrayName("")')
def _(b):
    b.scalars(np.stack([RAMP, RAMP], axis=-1), 2)
    b.haptics.SetFramesToComponents()
    b.haptics.SetTimeUnitsPerSecond(1.0)
    b.haptics.SetDisplacementArrayName("motion")
    return lambda: b.haptics.SetDisplacementArrayName("")


# A wall that jumps by four times its width between two time steps. A blend of the two would fade one wall out and the
# other in.

def leaping(spread=0.0):
    """Returns two time steps with a wall at x = 20 and at x = 26, solid below, perhaps smoothed."""
    made = []
    for wall in (20.0, 26.0):
        values = 500.0 * (1.0 - np.tanh((np.arange(64.0) - wall) / 1.5))
        one, motion = ramp(np.broadcast_to(values, (12, 12, 64)).copy()), numpy_to_vtk(np.tile([6.0, 0, 0], (9216, 1)), deep=True)
        if spread:
            smooth = vtkImageGaussianSmooth()
            smooth.SetStandardDeviation(spread, 0.0, 0.0)
            smooth.SetRadiusFactor(4.0)
            one.DeepCopy(filtered(smooth, one))
        motion.SetName("motion")
        one.GetPointData().AddArray(motion)
        made.append(one)
    return made


@result("Smooth the image to a width of", "give the time steps displacements (SetDisplacementArrayName)")
def fast_motion(_):
    """Rests the tip at x = 22. After 5/6 of the time, the wall is at x = 25."""
    def feel(images, name=""):
        b = Bench()
        frames(b, *images, name=name)
        for point in range(21):
            b.path.GetPoints().SetPoint(point, 22.0, 6.0, 6.0)
        times(b, np.linspace(0.0, 1.0, 21))
        with Errors(b.haptics, event="WarningEvent") as warnings:
            b.force()
        return warnings, arrays(b.haptics.GetOutput())["Force"][833][0]

    words = "Smooth the image to a width of", "give the time steps displacements (SetDisplacementArrayName)"
    (told_now, ), fades = feel(leaping())
    assert all(word in told_now for word in words)
    TOLD.update(words)
    assert fades < 0.1
    warnings, moves = feel(leaping(), "motion")
    assert not warnings and moves == pytest.approx(0.5 * 3.0, abs=0.1)
    width = float(re.search(r"to a width of ([0-9.]+) or more", told_now).group(1))
    warnings, smoothed = feel(leaping(width))
    assert not warnings and smoothed == pytest.approx(0.5 * 3.0, abs=0.3)


# -- labels, surfaces and guides --

@case("Lower vtkHapticLabelTable::SetStandOff", 0.4)
def _(b):
    materials = table()
    materials.SetForbidden(2, True)
    materials.SetStandOff(1e4)
    values = np.ones(RAMP.shape, np.uint8)
    values[-2:, -2:, -2:] = 2
    b.haptics.SetLabelTable(materials)
    b.haptics.SetLabelData(image(values))
    return lambda: materials.SetStandOff(1.0)


def floor(b, divisions=1):
    """Sets the method SURFACE_PROXY and a plane at z = 10, solid above it."""
    plane = vtkPlaneSource()
    plane.SetOrigin(0.0, 0.0, 10.0)
    plane.SetPoint1(0.0, 16.0, 10.0)
    plane.SetPoint2(23.0, 0.0, 10.0)
    plane.SetResolution(divisions, divisions)
    plane.Update()
    b.haptics.SetMethodToSurfaceProxy()
    b.haptics.SetProxyRadius(0.1)
    # The tip starts below, in free space.
    for i in range(21):
        b.path.GetPoints().SetPoint(i, 5.0, 8.0, 9.0 + 0.15 * i)
    made = vtkPolyData()
    made.DeepCopy(plane.GetOutput())
    return made


@case("or connect a coarser surface to input port 2", "floor")
def _(b):
    b.haptics.SetSurfaceData(floor(b, 200))
    b.haptics.SetProxyRadius(5.0)

    def cure():
        b.haptics.SetSurfaceData(floor(b))
        b.haptics.SetProxyRadius(0.1)
    return cure


@case("Lower ProxyRadius, or", "floor")
def _(b):
    b.haptics.SetSurfaceData(floor(b, 200))
    b.haptics.SetProxyRadius(5.0)
    return lambda: b.haptics.SetProxyRadius(0.1)


@case("Correct its polygons and strips", "floor")
def _(b):
    wrong = floor(b)
    cells = vtkCellArray()
    cells.DeepCopy(wrong.GetPolys())
    cells.InsertNextCell(3)
    for point in (0, 1, 99):
        cells.InsertCellPoint(point)
    right = wrong.GetPolys()
    wrong.SetPolys(cells)
    b.haptics.SetSurfaceData(wrong)
    return lambda: (wrong.SetPolys(right), wrong.Modified())


@case("or beyond 1e30 at point …. Replace or remove that point", "floor")
def _(b):
    wrong = floor(b)
    place = wrong.GetPoint(1)
    wrong.GetPoints().SetPoint(1, math.nan, 0.0, 0.0)
    b.haptics.SetSurfaceData(wrong)
    return lambda: (wrong.GetPoints().SetPoint(1, *place), wrong.GetPoints().Modified(), wrong.Modified())


@case("is not finite at point …. Replace or remove that point")
def _(b):
    wrong = np.linspace(0.0, 0.02, 21)
    wrong[7] = math.nan
    times(b, wrong)
    return lambda: times(b, np.linspace(0.0, 0.02, 21))


@case("Connect a vtkPolyData with polygons or strips, or nothing to touch the isosurface at IsoValue", "floor")
def _(b):
    surface = floor(b)
    b.haptics.SetSurfaceData(vtkPolyData())
    return lambda: b.haptics.SetSurfaceData(surface)


@case("Give the mode a vtkPolyData with polygons or strips with SetSurface()")
def _(b):
    """A plane at z = 10 holds the tip."""
    mode = b.follow(vtkHapticGuideMode())
    mode.SetSurface(vtkPolyData())
    surface = floor(Bench())
    return lambda: mode.SetSurface(surface)


@case("or switch it off with SetActive(false)", 0.0)
def _(b):
    mode = b.follow(vtkHapticGuideMode())
    mode.SetSurface(vtkPolyData())
    return lambda: mode.SetActive(False)


# Tools.

def touched_by(b, tool):
    tool.SetContactValue(1000.0)
    tool.SetSolidToAbove()
    b.haptics.SetTool(tool)
    return tool


@case("Set it to some voxels with SetRadius()", "burr")
def _(b):
    burr = touched_by(b, vtkHapticBurr())
    burr.SetRadius(0.2)
    return lambda: burr.SetRadius(3.0)


@case("Set them with SetSpeed() and SetFriction()", "burr")
def _(b):
    burr = touched_by(b, vtkHapticBurr())
    burr.SetRadius(3.0)
    speed = burr.GetSpeed()
    burr.SetSpeed(math.nan)
    return lambda: burr.SetSpeed(speed)


@case("which only the method PROXY knows. Choose it with SetMethodToProxy(), or remove the tool", "ball")
def _(b):
    hold_ball(b, ball())
    b.haptics.SetMethodToForceField()
    return b.haptics.SetMethodToProxy


@case("Set it to more than 0 with Set", "ball")
def _(b):
    shell = hold_ball(b, ball())
    area = shell.GetContactArea()
    shell.SetContactArea(0.0)
    return lambda: shell.SetContactArea(area)


def wrong_mesh(b, spoil):
    mesh = ball()
    spoil(mesh)
    shell = hold_ball(b, mesh)
    return lambda: shell.SetMesh(ball())


@case("points. Correct the mesh", "ball")
def _(b):
    def spoil(mesh):
        mesh.GetPolys().InsertNextCell(3)
        for point in (0, 1, 10**6):
            mesh.GetPolys().InsertCellPoint(point)
    return wrong_mesh(b, spoil)


@case("number …. Correct the mesh", "ball")
def _(b):
    return wrong_mesh(b, lambda mesh: mesh.GetPoints().SetPoint(7, math.nan, 0.0, 0.0))


@case("Give it a surface with an extent", "ball")
def _(b):
    def spoil(mesh):
        for point in range(mesh.GetNumberOfPoints()):
            mesh.GetPoints().SetPoint(point, 1.0, 2.0, 3.0)
    return wrong_mesh(b, spoil)


def burr_force():
    bench = Bench()
    touched_by(bench, vtkHapticBurr()).SetRadius(3.0)
    return bench.force()


def floor_force():
    """Force (N) of the spring of 500 N/m. The proxy is a sphere of 0.1 mm whose centre stops at z = 9.9, and the tip is
    at z = 12."""
    return 0.5 * (12.0 - 9.9)


FORCES.update(burr=burr_force, floor=floor_force)


@pytest.mark.parametrize("words", case)
def test_cures_of_the_filter(words):
    try_case(words, *case[words])


# -- calls that bake --

@result("Give it a vtkPolyData, or nothing: then the isosurface at the IsoValue is touched",
        "There is no image to touch. Connect a vtkImageData to input port 0")
def surfaces_of_a_device(_):
    """VTK's executive refuses such a surface itself, but a device has no executive."""
    b, device = Bench(), vtkHapticDevice()
    surface = floor(b)
    b.haptics.SetInputDataObject(2, vtkImageData())
    b.haptics.SetIsoValue(1000.0)
    device.SetVolumeHaptics(b.haptics)
    assert device.Open("virtual")
    with told(b.haptics, "Give it a vtkPolyData, or nothing: then the isosurface at the IsoValue is touched", device):
        assert not device.Start()
    b.haptics.SetInputDataObject(2, None)
    b.haptics.SetInputDataObject(0, None)
    with told(b.haptics, "There is no image to touch. Connect a vtkImageData to input port 0", device):
        assert not device.Start()
    b.haptics.SetInputData(b.image)
    for right in (surface, None):
        b.haptics.SetInputDataObject(2, right)
        assert device.Start()
        device.Stop()
        assert b.force() == pytest.approx(floor_force(), abs=1e-3)


# -- modes that are proposed for an image --

@result("Give it such an array, or use another preset: see GetModePresetNames()", "Use one of: ",
        "Name one with SetArrayName(), or give the image active vectors", "Name another one with SetArrayName()",
        "Make a vtkHapticGuideMode instead", "Make a vtkHapticMode for another kind")
def proposed_modes(_):
    b = Bench()
    with told(b.haptics, "Use one of: "):
        assert not b.haptics.ApplyModePreset("Waltz", b.image)
    names = b.haptics.GetModePresetNames()
    assert "Find a vortex" in [names.GetValue(i) for i in range(names.GetNumberOfValues())]
    with told(b.haptics, "Give it such an array, or use another preset: see GetModePresetNames()"):
        assert not b.haptics.ApplyModePreset("Find a vortex", b.image)
    assert b.haptics.ApplyModePreset("Follow a dark vessel", ramp_of_a_ridge())
    b.haptics.RemoveAllModes()
    mode, guide = vtkHapticMode(), vtkHapticGuideMode()
    with told(mode, "Make a vtkHapticGuideMode instead"):
        mode.SetKind(mode.GUIDE)
    with told(guide, "Make a vtkHapticMode for another kind"):
        guide.SetKindToVortex()
    assert (mode.GetKind(), guide.GetKind()) == (mode.VECTOR_FOLLOW, mode.GUIDE)
    with told(mode, "Name one with SetArrayName(), or give the image active vectors"):
        assert not mode.ProposeFromImage(vtkImageData())
    still = numpy_to_vtk(np.zeros((RAMP.size, 3)), deep=True)
    still.SetName("still")
    b.points.AddArray(still)
    mode.SetArrayName("still")
    with told(mode, "Name another one with SetArrayName()"):
        assert not mode.ProposeFromImage(b.image)
    vectors(b)
    mode.SetArrayName("along")
    assert mode.ProposeFromImage(b.image)
    b.follow(mode)
    assert b.force() == pytest.approx(1.0, abs=1e-6)


def ramp_of_a_ridge():
    z, y, x = np.indices(RAMP.shape)
    return image(500.0 - 400.0 * np.exp(-((y - 8.0)**2 + (z - 16.0)**2) / 8.0) + 0.0 * x)


@pytest.mark.parametrize("words", result)
def test_cures_of_calls(words, tmp_path):
    try_calls(words, result[words], tmp_path)
