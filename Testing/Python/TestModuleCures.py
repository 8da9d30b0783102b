# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Cures that errors of the C++ module name are tried: after them the right force is felt, or the right result is there.

The volume is V = 100 z over 24 x 17 x 32 voxels, pressed 2 mm from z = 10 on: 500 N/m give 1 N, unless a case says
otherwise. Those of Python itself are in TestCures.py.
"""

import json
import math
import re
from contextlib import contextmanager

import numpy as np
import pytest
from TestCures import PRESS, RAMP
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_INT, vtkBitArray, vtkFloatArray, vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkDataObject,
    vtkImageData,
    vtkPlane,
    vtkPolyData,
)
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData, vtkPolyDataNormals, vtkReverseSense
from vtkmodules.vtkFiltersModeling import vtkFillHolesFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageExtractComponents
from volumehaptics import (
    image,
    path,
    vtkHapticDevice,
    vtkHapticGuideMode,
    vtkHapticLabelTable,
    vtkHapticMeasurements,
    vtkHapticMode,
    vtkHapticNeedle,
    vtkHapticPathSource,
    vtkHapticPointShell,
    vtkHapticProperty,
    vtkHapticSetup,
    vtkVolumeHapticsFilter,
)
from volumehaptics._touch import Errors
from volumehaptics.arrays import arrays

class Cases(dict):
    """Functions that spoil a bench and return the cure, with the force after it, by words of the cure in the error."""

    def __call__(self, words, force=1.0):
        def keep(spoil):
            assert words not in self, words
            self[words] = spoil, force
            return spoil
        return keep


class Calls(dict):
    """Functions that provoke errors in a folder and apply each cure, by the words of these cures."""

    def __call__(self, *words):
        def keep(function):
            assert words not in self, words
            self[words] = function
            return function
        return keep


case, result = Cases(), Calls()


class Bench:
    """A filter that presses the ramp."""

    def __init__(self):
        self.image = vtkImageData()
        self.image.DeepCopy(image(RAMP))
        self.path = vtkPolyData()
        self.path.DeepCopy(path(PRESS))
        self.haptics = vtkVolumeHapticsFilter()
        self.haptics.SetInputData(self.image)
        self.haptics.SetPathData(self.path)
        self.feel = self.haptics.GetProperty()
        self.points = self.image.GetPointData()

    def force(self):
        self.haptics.Update()
        felt = self.haptics.GetOutput()
        return -arrays(felt)["Force"][-1][2] if felt.GetNumberOfPoints() else math.nan

    def scalars(self, values, components=1):
        """Gives the image an array V."""
        array = numpy_to_vtk(np.ascontiguousarray(values).reshape(-1, components), deep=True)
        array.SetName("V")
        self.points.SetScalars(array)

    def follow(self, mode):
        """The method PRIMITIVES with a mode."""
        self.haptics.SetMethodToPrimitives()
        self.haptics.AddMode(mode)
        return mode


# The volume.

@case("Update its source, or give it dimensions of at least ")
def _(b):
    empty = vtkImageData()
    empty.AllocateScalars(VTK_DOUBLE, 1)
    b.haptics.SetInputData(empty)
    return lambda: sheet(b, 5)


def sheet(b, planes):
    """Some planes of the ramp, with the path in their middle."""
    b.haptics.SetInputData(image(RAMP[:, :planes, :].copy(), origin=(0, 8 - planes // 2, 0)))


@case("Give it a volume of at least ")
def _(b):
    sheet(b, 1)
    return lambda: sheet(b, 5)


@case("(3 are enough with SetKernelRadius(1))")
def _(b):
    sheet(b, 1)
    return lambda: (sheet(b, 3), b.haptics.SetKernelRadius(1))


@case("Lower KernelRadius or use a larger image")
def _(b):
    b.haptics.SetKernelRadius(9)
    return lambda: b.haptics.SetKernelRadius(2)


@case("Use point scalars with one tuple a point")
def _(b):
    b.scalars(RAMP.reshape(-1)[:-1])
    return lambda: b.scalars(RAMP)


@case("Lower vtkHapticProperty::SetComponent (it counts from 0)")
def _(b):
    b.feel.SetComponent(1)
    return lambda: b.feel.SetComponent(0)


def bits_of(number, components=1):
    """All of them are 1."""
    bits = vtkBitArray()
    bits.SetNumberOfComponents(components)
    bits.SetNumberOfTuples(number // components)
    for i in range(number):
        bits.SetValue(i, 1)
    return bits


@case("for example with vtkFloatArray::DeepCopy(), and make that the active scalars", 0.0)
def _(b):
    """Nothing has an edge where all is 1."""
    bits, copy = bits_of(RAMP.size), vtkFloatArray()
    b.points.SetScalars(bits)

    def cure():
        copy.DeepCopy(bits)
        assert copy.GetRange() == (1.0, 1.0)
        b.points.SetScalars(copy)
    return cure


@case("Set the distance between voxels with vtkImageData::SetSpacing")
def _(b):
    b.image.SetSpacing(1.0, 0.0, 1.0)
    return lambda: b.image.SetSpacing(1.0, 1.0, 1.0)


@case("Set it with vtkImageData::SetOrigin")
def _(b):
    b.image.SetOrigin(0.0, math.inf, 0.0)
    return lambda: b.image.SetOrigin(0.0, 0.0, 0.0)


@case("Set three independent axes with vtkImageData::SetDirectionMatrix")
def _(b):
    b.image.SetDirectionMatrix(1, 0, 0, 1, 0, 0, 0, 0, 1)
    return lambda: b.image.SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1)


def no_scalars(b):
    values = numpy_to_vtk(RAMP.reshape(-1), deep=True)
    values.SetName("V")
    b.points.Initialize()
    b.points.AddArray(values)
    b.points.SetActiveScalars(None)
    text = vtkStringArray()
    text.SetName("text")
    text.SetNumberOfValues(RAMP.size)
    b.points.AddArray(text)


@case("Give its point data active scalars")
def _(b):
    no_scalars(b)
    return lambda: b.points.SetActiveScalars("V")


@case("or name a numeric point array with SetInputArrayToProcess(0, 0, 0,")
def _(b):
    no_scalars(b)
    return lambda: b.haptics.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "V")


# Settings and functions.

@case("is not a finite number. Set")
def _(b):
    b.haptics.SetIsoValue(math.nan)
    return lambda: b.haptics.SetIsoValue(0.0)


@case("Correct this point of ")
def _(b):
    b.feel.GetStiffness().AddPoint(0.0, -1.0)
    return lambda: (b.feel.GetStiffness().RemoveAllPoints(), b.feel.GetStiffness().AddPoint(0.0, 500.0))


def plane(b, normal):
    one = vtkPlane()
    one.SetOrigin(0.0, 0.0, 25.0)
    b.haptics.AddClippingPlane(one)
    one.SetNormal(1.0, 0.0, 0.0)
    return one


@case("Correct them with vtkPlane::SetNormal() and SetOrigin()")
def _(b):
    one = plane(b, None)
    one.SetOrigin(math.nan, 0.0, 0.0)
    # What is above z = 25 is not felt.
    return lambda: (one.SetNormal(0.0, 0.0, -1.0), one.SetOrigin(0.0, 0.0, 25.0))


@case("or call RemoveClippingPlane()")
def _(b):
    one = plane(b, None)
    one.SetOrigin(math.nan, 0.0, 0.0)
    return lambda: b.haptics.RemoveClippingPlane(one)


def crop_wrongly(b):
    b.haptics.CroppingOn()
    b.haptics.SetCroppingRegionPlanes(9.0, 0.0, 0.0, 16.0, 0.0, 31.0)


@case("Correct them with SetCroppingRegionPlanes()")
def _(b):
    crop_wrongly(b)
    return lambda: b.haptics.SetCroppingRegionPlanes(0.0, 23.0, 0.0, 16.0, 0.0, 31.0)


@case("or call CroppingOff()")
def _(b):
    crop_wrongly(b)
    return b.haptics.CroppingOff


# The path.

@case("is NaN or infinite at point …. Replace or remove that point")
def _(b):
    b.path.GetPoints().SetPoint(20, 5.0, math.nan, 12.0)
    return lambda: (b.path.GetPoints().SetPoint(20, 5.0, 8.0, 12.0), b.path.GetPoints().Modified(), b.path.Modified())


def times(b, values):
    array = numpy_to_vtk(np.asarray(values, float), deep=True)
    array.SetName("Time")
    b.path.GetPointData().AddArray(array)


@case("Give it one number of seconds a point")
def _(b):
    times(b, np.arange(20.0))
    return lambda: times(b, 0.001 * np.arange(21.0))


@case("number of seconds a point, or remove the array")
def _(b):
    times(b, np.arange(20.0))
    return lambda: b.path.GetPointData().RemoveArray("Time")


@case("Time is in seconds; convert it if it is in other units")
def _(b):
    times(b, 1e9 * np.arange(21.0))  # ns, of a path of 20 s
    return lambda: times(b, np.arange(21.0))


def lines_of(b, last):
    lines = vtkCellArray()
    for stroke in (range(10), (*range(10, 20), last)):
        lines.InsertNextCell(len(stroke))
        for point in stroke:
            lines.InsertCellPoint(point)
    b.path.SetLines(lines)


@case("Make the line of points that exist", 0.5)
def _(b):
    """The second stroke begins at z = 11."""
    lines_of(b, 21)
    return lambda: lines_of(b, 20)


@case("or remove DeviceTip to use the points as a path")
def _(b):
    tip = numpy_to_vtk(np.zeros((21, 3)), deep=True)
    tip.SetName("DeviceTip")
    b.path.GetPointData().AddArray(tip)
    return lambda: b.path.GetPointData().RemoveArray("DeviceTip")


# Labels: those of material 1 have 200 N/m, which give 0.4 N.

def labels_of(values, kind=np.uint8):
    return image(np.full(RAMP.shape, values, kind))


def table():
    materials = vtkHapticLabelTable()
    materials.SetStiffness(1, 200.0)
    return materials


@case("Connect a segmentation, not an image of intensities or probabilities", 0.4)
def _(b):
    b.haptics.SetLabelTable(table())
    b.haptics.SetLabelData(labels_of(0.5, np.float32))
    return lambda: b.haptics.SetLabelData(labels_of(1))


@case("Connect one to input port 3 with SetLabelConnection")
def _(b):
    b.haptics.SetGeometryFromLabels()
    return lambda: (b.haptics.SetGeometryFromScalars())


# Tools and modes.

@case("Choose it with SetMethodToProxy(), or take the needle away")
def _(b):
    b.haptics.SetTool(vtkHapticNeedle())
    b.haptics.SetMethodToForceField()
    return lambda: (b.haptics.SetMethodToProxy(), b.haptics.SetTool(None))


def vectors(b):
    """The component of the spring across vectors along x: 500 N/m times 2 mm."""
    along = numpy_to_vtk(np.tile([1.0, 0.0, 0.0], (RAMP.size, 1)), deep=True)
    along.SetName("along")
    b.points.AddArray(along)


@case("Name a point array of ")
def _(b):
    vectors(b)
    mode = b.follow(vtkHapticMode())
    mode.SetArrayName("across")
    return lambda: mode.SetArrayName("along")


@case("Name another array with SetArrayName()")
def _(b):
    vectors(b)
    mode = b.follow(vtkHapticMode())
    mode.SetArrayName(b.points.GetScalars().GetName())
    return lambda: mode.SetArrayName("along")


@case("Take it away with SetSecondStrength(nullptr), or choose another kind")
def _(b):
    vectors(b)
    mode = b.follow(vtkHapticMode())
    mode.SetArrayName("along")
    mode.SetKindToShear()
    mode.GetSecondStrength().AddPoint(0.0, 0.0)
    return mode.SetKindToVectorFollow


@case("Give it exactly one with SetPath(), SetSurface() or SetDistanceField()")
def _(b):
    mode = b.follow(vtkHapticGuideMode())
    return lambda: mode.SetPath(line_to(20.0))


@case("Give it polylines with SetPath()")
def _(b):
    mode = b.follow(vtkHapticGuideMode())
    mode.SetPath(line_to(0.0))
    return lambda: mode.SetPath(line_to(20.0))


def line_to(x):
    """From (0, 8, 10) along x."""
    line = vtkPolyData()
    line.SetPoints(vtkPoints())
    line.GetPoints().InsertNextPoint(0.0, 8.0, 10.0)
    line.GetPoints().InsertNextPoint(x, 8.0, 10.0)
    lines = vtkCellArray()
    lines.InsertNextCell(2)
    lines.InsertCellPoint(0)
    lines.InsertCellPoint(1)
    line.SetLines(lines)
    return line


@case("Correct it, or give the mode another one with SetPath()")
def _(b):
    mode = b.follow(vtkHapticGuideMode())
    mode.SetPath(line_to(math.nan))
    return lambda: mode.SetPath(line_to(20.0))


@case("Set a number of world units with SetDistance()")
def _(b):
    mode = b.follow(vtkHapticGuideMode())
    mode.SetPath(line_to(20.0))
    mode.SetDistance(math.inf)
    return lambda: mode.SetDistance(0.0)


@case("Name them with SetActiveScalars() of its point data")
def _(b):
    """A distance field: it holds the hand where the distance is 0, at z = 10."""
    mode = b.follow(vtkHapticGuideMode())
    field = image(RAMP / 100.0 - 10.0)
    name = field.GetPointData().GetScalars().GetName()
    field.GetPointData().SetActiveScalars(None)
    mode.SetDistanceField(field)
    return lambda: field.GetPointData().SetActiveScalars(name)


@case("Give it one tuple a point")
def _(b):
    short = numpy_to_vtk(np.tile([1.0, 0.0, 0.0], (RAMP.size - 1, 1)), deep=True)
    short.SetName("along")
    b.points.AddArray(short)
    b.follow(vtkHapticMode()).SetArrayName("along")
    return lambda: vectors(b)


@case("for example with vtkFloatArray::DeepCopy(), and give the mode that one", 2.0 / 3.0)
def _(b):
    """Vectors (1, 1, 1): the spring holds across them, 2 mm times sqrt(2/3) of which are 2/3 along z."""
    bits = bits_of(3 * RAMP.size, 3)
    bits.SetName("bits")
    b.points.AddArray(bits)
    mode = b.follow(vtkHapticMode())
    mode.SetArrayName("bits")

    def cure():
        copy = vtkFloatArray()
        copy.DeepCopy(bits)
        copy.SetName("copy")
        b.points.AddArray(copy)
        mode.SetArrayName("copy")
    return cure


@case("Take some away with RemoveMode()")
def _(b):
    vectors(b)
    modes = [b.follow(vtkHapticMode()) for _ in range(9)]
    for mode in modes:
        mode.SetArrayName("along")
    return lambda: [b.haptics.RemoveMode(mode) for mode in modes[1:]]


@case("or switch them off with SetActive(false)")
def _(b):
    vectors(b)
    modes = [b.follow(vtkHapticMode()) for _ in range(5)]
    for mode in modes:
        mode.SetArrayName("along")
    return lambda: [mode.SetActive(False) for mode in modes[1:]]


@case("Set it with SetLateralStrength()")
def _(b):
    """A needle that is held by nothing but the wall that it has not punctured."""
    needle = vtkHapticNeedle()
    needle.SetLateralStrength(math.nan)
    b.haptics.SetTool(needle)
    return lambda: (needle.SetLateralStrength(0.0), b.haptics.SetTool(None))


# More labels.

def with_labels(b, labels):
    b.haptics.SetLabelTable(table())
    b.haptics.SetLabelData(labels)
    return labels


@case("for example with vtkIntArray::DeepCopy(), and make that the active scalars", 0.4)
def _(b):
    labels = with_labels(b, labels_of(1))
    bits, copy = bits_of(RAMP.size), vtkIntArray()
    labels.GetPointData().SetScalars(bits)

    def cure():
        copy.DeepCopy(bits)
        labels.GetPointData().SetScalars(copy)
    return cure


@case("Extract one of them, for example with vtkImageExtractComponents", 0.4)
def _(b):
    both = labels_of(1)
    pairs = numpy_to_vtk(np.ones((RAMP.size, 2), np.uint8), deep=True)
    both.GetPointData().SetScalars(pairs)
    with_labels(b, both)
    extract = vtkImageExtractComponents()
    extract.SetInputData(both)
    extract.SetComponents(0)
    return lambda: b.haptics.SetLabelConnection(extract.GetOutputPort())


@case("SetInputArrayToProcess(1, 3, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name)", 0.4)
def _(b):
    labels = with_labels(b, labels_of(1))
    name = labels.GetPointData().GetScalars().GetName()
    labels.GetPointData().SetActiveScalars(None)
    return lambda: b.haptics.SetInputArrayToProcess(1, 3, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)


@case("Update its source, or disconnect it", 1.0)
def _(b):
    empty = vtkImageData()
    empty.AllocateScalars(VTK_INT, 1)
    with_labels(b, empty)
    return lambda: b.haptics.SetLabelData(None)


# Tools with a shape: a ball of 2 mm, whose centre goes from z = 7 to 9 where z = 10 is the surface. What a good one
# feels is compared with closed forms in Testing/Core/Tools.

def ball():
    sphere = vtkSphereSource()
    sphere.SetRadius(2.0)
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(16)
    sphere.Update()
    mesh = vtkPolyData()
    mesh.DeepCopy(sphere.GetOutput())
    return mesh


def hold_ball(b, mesh):
    b.haptics.SetMetersPerWorldUnit(0.001)
    shell = vtkHapticPointShell()
    shell.SetContactValue(1000.0)
    shell.SetSolidToAbove()
    shell.SetMesh(mesh)
    b.haptics.SetTool(shell)
    points = b.path.GetPoints()
    for i in range(21):
        points.SetPoint(i, 11.0, 8.0, 7.0 + 0.1 * i)
    b.path.Modified()
    return shell


def ball_force():
    bench = Bench()
    hold_ball(bench, ball())
    return bench.force()


def filtered(algorithm, mesh):
    algorithm.SetInputData(mesh)
    algorithm.Update()
    return algorithm.GetOutput()


@case("with vtkCleanPolyData and SetTolerance()", "ball")
def _(b):
    """Each triangle has points of its own, a little beside those of its neighbours."""
    mesh, apart, clean = ball(), vtkAppendPolyData(), vtkCleanPolyData()
    for cell in range(mesh.GetNumberOfCells()):
        one, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
        points.SetDataTypeToDouble()
        ids = mesh.GetCell(cell).GetPointIds()
        cells.InsertNextCell(ids.GetNumberOfIds())
        for i in range(ids.GetNumberOfIds()):
            x, y, z = mesh.GetPoint(ids.GetId(i))
            cells.InsertCellPoint(points.InsertNextPoint(x, y, z + 1e-9 * cell))
        one.SetPoints(points)
        one.SetPolys(cells)
        apart.AddInputData(one)
    apart.Update()
    clean.SetTolerance(1e-6)
    shell = hold_ball(b, apart.GetOutput())
    return lambda: shell.SetMesh(filtered(clean, apart.GetOutput()))


def without_a_cell(mesh):
    mesh.BuildCells()
    mesh.DeleteCell(5)
    mesh.RemoveDeletedCells()
    return mesh


@case("Close it, for example with vtkFillHolesFilter and then vtkPolyDataNormals", "ball")
def _(b):
    mesh, fill = without_a_cell(ball()), vtkFillHolesFilter()
    fill.SetHoleSize(100.0)
    shell = hold_ball(b, mesh)
    return lambda: shell.SetMesh(filtered(vtkPolyDataNormals(), filtered(fill, mesh)))


@case("Turn them to one side with vtkPolyDataNormals and ConsistencyOn()", "ball")
def _(b):
    mesh, normals = ball(), vtkPolyDataNormals()
    mesh.BuildCells()
    mesh.ReverseCell(5)
    normals.SplittingOff()
    normals.ConsistencyOn()
    shell = hold_ball(b, mesh)
    return lambda: shell.SetMesh(filtered(normals, mesh))


@case("Turn them with vtkReverseSense and ReverseCellsOn()", "ball")
def _(b):
    wrong, right = vtkReverseSense(), vtkReverseSense()
    for reverse in (wrong, right):
        reverse.ReverseCellsOn()
    mesh = filtered(wrong, ball())
    shell = hold_ball(b, mesh)
    return lambda: shell.SetMesh(filtered(right, mesh))


@case("Give a closed surface, such as that of an STL file", "ball")
def _(b):
    mesh = vtkPolyData()
    mesh.SetPoints(ball().GetPoints())
    shell = hold_ball(b, mesh)
    return lambda: shell.SetMesh(ball())


@case("Set it with SetContactValue()", "ball")
def _(b):
    shell = hold_ball(b, ball())
    shell.SetContactValue(math.nan)
    return lambda: shell.SetContactValue(1000.0)


@case("and SetSolidToAbove() or SetSolidToBelow()", "ball")
def _(b):
    shell = hold_ball(b, ball())
    shell.SetSolidToFromFunctions() if hasattr(shell, "SetSolidToFromFunctions") else shell.SetSolid(0)
    return lambda: (shell.SetContactValue(1000.0), shell.SetSolidToAbove())


@case("set it with SetNumberOfPoints()", "ball")
def _(b):
    shell = hold_ball(b, ball())
    b.haptics.SetServoRate(1000.0)
    shell.SetNumberOfPoints(0)
    return lambda: shell.SetNumberOfPoints(vtkHapticPointShell().GetNumberOfPoints())


FORCES = {"ball": ball_force}


def try_case(words, spoil, force):
    """A force that has a name is that of a bench without the fault."""
    bench = Bench()
    cure = spoil(bench)
    with Errors(bench.haptics.GetExecutive()), Errors(bench.haptics) as errors:
        bench.haptics.Update()
    assert len(errors) == 1 and words in re.sub(r"(?<=number |.point )\d+(?=\.)", "…", errors[0]), (words, errors)
    cure()
    with Errors(bench.haptics) as errors:
        # A hole that was closed has other triangles.
        right = pytest.approx(FORCES[force](), rel=1e-3) if force in FORCES else pytest.approx(force, abs=1e-6)
        assert bench.force() == right
    assert not errors


@pytest.mark.parametrize("words", case)
def test_cures_of_the_filter(words):
    try_case(words, *case[words])


# Cures after which something else than a force is right.

TOLD = set()


@contextmanager
def told(watched, word, silent=None):
    """The statements give one error, with the cure."""
    with Errors(silent or watched), Errors(watched) as errors:
        yield
    assert len(errors) == 1 and word in errors[0], (word, errors)
    TOLD.add(word)


@result(", or a file of WritePreset() that ends in .json", "Give WritePreset() the name of one", "Give ReadPreset() the name of one",
        "was written by vtkHapticProperty::WritePreset()", "Write the preset again",
        "Check that the folder exists, or choose another one", "Give the name of a file")
def presets(folder):
    feel, file = vtkHapticProperty(), str(folder / "own.json")
    with told(feel, ", or a file of WritePreset() that ends in .json"):
        assert not feel.ApplyPreset("bones")
    assert feel.ApplyPreset("MRI")
    with told(feel, "Give WritePreset() the name of one"):
        assert not feel.WritePreset("")
    with told(feel, "Check that the folder exists, or choose another one"):
        assert not feel.WritePreset(str(folder / "none" / "own.json"))
    with told(feel, "Give the name of a file"):
        assert not feel.WritePreset(str(folder))
    assert feel.WritePreset(file)
    read = vtkHapticProperty()
    with told(read, "Give ReadPreset() the name of one"):
        assert not read.ReadPreset("")
    with told(read, "was written by vtkHapticProperty::WritePreset()"):
        assert not read.ReadPreset(str(folder / "none.json"))
    assert read.ReadPreset(file)
    assert read.GetStiffness().GetValue(500.0) == feel.GetStiffness().GetValue(500.0) > 0.0
    broken = json.loads((folder / "own.json").read_text())
    for name in list(broken):
        if isinstance(broken[name], (dict, list)):
            del broken[name]
    (folder / "own.json").write_text(json.dumps(broken))
    with told(read, "Write the preset again"):
        assert not read.ReadPreset(file)
    assert feel.WritePreset(file) and read.ReadPreset(file)


@result("Give two numbers, the lower one first", "Give it others, or remove all tissues first")
def tissues(_):
    feel = vtkHapticProperty()
    with told(feel, "Give two numbers, the lower one first"):
        assert feel.AddTissue("bone", 3000.0, 300.0) == -1
    assert feel.AddTissue("bone", 300.0, 3000.0) == 0
    with told(feel, "Give it others, or remove all tissues first"):
        assert feel.AddTissue("skull", 400.0, 500.0) == -1
    assert feel.AddTissue("skull", 3100.0, 3200.0) == 1
    feel.RemoveAllTissues()
    assert feel.AddTissue("skull", 400.0, 500.0) == 0


@result("Take one of ")
def methods(_):
    haptics = vtkVolumeHapticsFilter()
    with told(haptics, "Take one of "):
        assert not haptics.SetMethodByName("feel")
    assert haptics.SetMethodByName("surface-proxy") and haptics.GetMethod() == haptics.SURFACE_PROXY


@result("Give Save the name of one", "Give Load the name of one", "was saved by vtkHapticSetup and may be read by you",
        "Correct it, or remove this key to leave the setting as it is")
def setups(folder):
    setup, haptics, file = vtkHapticSetup(), vtkVolumeHapticsFilter(), folder / "setup.json"
    setup.SetVolumeHaptics(haptics)
    haptics.SetKernelRadius(3)
    with told(setup, "Give Save the name of one"):
        assert not setup.Save("")
    assert setup.Save(str(file))
    with told(setup, "Give Load the name of one"):
        assert not setup.Load("")
    with told(setup, "was saved by vtkHapticSetup and may be read by you"):
        assert not setup.Load(str(folder / "none.json"))
    text = file.read_text()
    file.write_text(re.sub(r'"KernelRadius"( *): 3', r'"KernelRadius"\1: "wide"', text))
    with told(setup, "Correct it, or remove this key to leave the setting as it is"):
        assert not setup.Load(str(file))
    haptics.SetKernelRadius(2)
    file.write_text(re.sub(r'"KernelRadius"( *): 3,?', "", text))
    assert setup.Load(str(file)) and haptics.GetKernelRadius() == 2
    file.write_text(text)
    assert setup.Load(str(file)) and haptics.GetKernelRadius() == 3


@result("Set it to three numbers", "Move one of them", "or lower PointsPerSecond")
def planned_paths(_):
    def ends(source):
        source.Update()
        return source.GetOutput().GetPoint(source.GetOutput().GetNumberOfPoints() - 1)

    source = vtkHapticPathSource()
    source.SetPathTypeToLine() if hasattr(source, "SetPathTypeToLine") else source.SetShapeToLine()
    source.SetPoint2(math.nan, 0.0, 0.0)
    with told(source, "Set it to three numbers", source.GetExecutive()):
        source.Update()
    source.SetPoint1(0.0, 0.0, 0.0)
    source.SetPoint2(0.0, 0.0, 0.0)
    with told(source, "Move one of them", source.GetExecutive()):
        source.Update()
    source.SetPoint2(0.0, 0.0, 9.0)
    assert ends(source) == pytest.approx((0.0, 0.0, 9.0))
    source.SetPointsPerSecond(1e5)
    source.SetSpeed(1e-6)
    with told(source, "or lower PointsPerSecond", source.GetExecutive()):
        source.Update()
    source.SetSpeed(50.0)
    assert ends(source) == pytest.approx((0.0, 0.0, 9.0))


@result('for example with Open("virtual")', "Give an id that EnumerateDevices() lists", "with N counting from 0",
        "There is nothing to record: Start() the servo first", "has an unknown ending: name it .vtp or .csv",
        "No recording is under way: Start() the recorder first", "A recording is under way: Stop() it first",
        'to lead: Open("virtual") first',
        "give the name of an unfinished recording, FILE.part", "Build it from such transforms only")
def devices(folder):
    device = vtkHapticDevice()
    with told(device, 'for example with Open("virtual")'):
        assert not device.Start()
    with told(device, 'to lead: Open("virtual") first'):
        device.GetVirtualHand().SetPosition(1.0, 2.0, 3.0)
    with told(device, "Give an id that EnumerateDevices() lists"):
        assert not device.Open("pen")
    with told(device, "with N counting from 0"):
        assert not device.Open("falcon:first")
    assert device.Open("virtual")
    with told(device, "There is nothing to record: Start() the servo first"):
        assert not device.GetRecorder().Start(str(folder / "touch.vtp"))
    bench = Bench()
    device.SetVolumeHaptics(bench.haptics)
    device.SetAttentionTime(0.0)
    assert device.Start()
    with told(device, "has an unknown ending: name it .vtp or .csv"):
        assert not device.GetRecorder().Start(str(folder / "touch.vtk"))
    with told(device, "No recording is under way: Start() the recorder first"):
        assert not device.GetRecorder().Stop()
    assert device.GetRecorder().Start(str(folder / "touch.vtp"))
    with told(device, "A recording is under way: Stop() it first"):
        assert not device.GetRecorder().Start(str(folder / "again.vtp"))
    device.GetVirtualHand().SetPosition(5.0, 8.0, 9.0)
    device.UpdateState()
    tick = device.GetState().GetTick()
    while device.GetState().GetTick() < tick + 50:
        device.UpdateState()
    assert device.GetState().GetTipPosition() == pytest.approx((5.0, 8.0, 9.0), abs=0.5)
    assert device.GetRecorder().Stop() and (folder / "touch.vtp").stat().st_size > 0
    device.Stop()
    with told(device, "give the name of an unfinished recording, FILE.part"):
        assert not device.GetRecorder().Recover("", str(folder / "found.vtp"))
    matrix = vtkMatrix4x4()
    matrix.SetElement(0, 0, 2.0)
    device.SetDeviceToWorld(matrix)
    with told(bench.haptics, "Build it from such transforms only"):
        assert not device.Publish()
    for axis in range(3):
        matrix.SetElement(axis, axis, 2.0)
    device.SetDeviceToWorld(matrix)
    assert device.Publish()


@result("can't be …. Give 0 or more", "Give red, green and blue from 0 to 1",
        "Give 0 or more (world units)")
def label_tables(_):
    labels = vtkHapticLabelTable()
    with Errors(labels) as errors:
        labels.SetStiffness(1, -1.0)
    assert len(errors) == 1 and "can't be -1. Give 0 or more" in errors[0], errors
    TOLD.add("can't be …. Give 0 or more")
    labels.SetStiffness(1, 300.0)
    assert labels.HasMaterial(1)
    labels.RemoveMaterial(1)
    assert not labels.HasMaterial(1)
    with told(labels, "Give red, green and blue from 0 to 1"):
        labels.SetColor(1, 255.0, 0.0, 0.0)
    labels.SetColor(1, 1.0, 0.0, 0.0)
    assert labels.HasColor(1)
    with told(labels, "Give 0 or more (world units)"):
        labels.SetStandOff(-1.0)
    labels.SetStandOff(2.0)
    assert labels.GetStandOff() == 2.0


@result("take POINT (0) to AREA (4)", "There is no shape to measure: give a vtkPolyData", "Choose a name that ends in .csv, .vtp or .mrk.json",
        "Choose a file that exists and may be read by you", "Name them there", "Write a number",
        "Close it, or check that the file is complete", "Write Point, Distance, Angle, Path or Area",
        "Choose a file that 3D Slicer, or this software, saved as .mrk.json", "it is not a complete .vtp file. Write it again",
        'Write "LPS" or "RAS"', 'Write "mm" or "um"', "Save the markups again", "Write the coordinates there")
def measurements(folder):
    measured = vtkHapticMeasurements()
    measured.AddDistance((0, 0, 0), (0, 3, 4))
    with told(measured, "take POINT (0) to AREA (4)"):
        assert measured.AddMeasurement(7, vtkPolyData()) == -1
    with told(measured, "There is no shape to measure: give a vtkPolyData"):
        assert measured.AddMeasurement(measured.PATH, None) == -1
    assert measured.AddMeasurement(measured.PATH, line_to(3.0)) == 1
    with told(measured, "Choose a name that ends in .csv, .vtp or .mrk.json"):
        assert not measured.WriteFile(str(folder / "list.txt"))
    for name in ("list.csv", "list.vtp", "list.mrk.json"):
        assert measured.WriteFile(str(folder / name))

    def refuses(name, old, new, word):
        good = (folder / name).read_text()
        assert re.search(old, good), old
        (folder / name).write_text(re.sub(old, new, good, count=1))
        with told(read, word):
            assert not read.ReadFile(str(folder / name))
        (folder / name).write_text(good)
        assert read.ReadFile(str(folder / name)) and read.GetNumberOfMeasurements() == 2
        assert read.GetValue(0) == pytest.approx(5.0)

    read = vtkHapticMeasurements()
    with told(read, "Choose a file that exists and may be read by you"):
        assert not read.ReadFile(str(folder / "none.csv"))
    refuses("list.csv", ",x,y,z,", ",u,v,w,", "Name them there")
    refuses("list.csv", ",3,4,", ",three,4,", "Write a number")
    refuses("list.csv", ",Distance,", ",Length,", "Write Point, Distance, Angle, Path or Area")
    refuses("list.csv", r"\n1,", '\n1,"', "Close it, or check that the file is complete")
    refuses("list.mrk.json", '"@schema"', '"schema"', "Choose a file that 3D Slicer, or this software, saved as .mrk.json")
    refuses("list.mrk.json", '"coordinateSystem" *: *"...?"', '"coordinateSystem": "XYZ"', 'Write "LPS" or "RAS"')
    refuses("list.mrk.json", '"coordinateUnits" *: *"[^"]*"', '"coordinateUnits": "inch"', 'Write "mm" or "um"')
    refuses("list.mrk.json", '"type" *:', '"kind":', "Save the markups again")
    refuses("list.mrk.json", r'"position" *: *\[[^]]*\]', '"position": [1, 2]', "Write the coordinates there")
    good = (folder / "list.vtp").read_bytes()
    (folder / "list.vtp").write_bytes(good[:len(good) // 2])
    with told(read, "it is not a complete .vtp file. Write it again"):
        assert not read.ReadFile(str(folder / "list.vtp"))
    assert measured.WriteFile(str(folder / "list.vtp")) and read.ReadFile(str(folder / "list.vtp"))


@result("pass a vtkImageData", "pass a vtkImageData, or call ApplyPreset(name)", "choose an array with GetPointData()->SetActiveScalars(name)",
        "there are no edges to propose functions from. Use another array or component", "points along every axis, or set the functions by hand",
        "has no finite value. Use another array or component")
def proposals(_):
    feel, step = vtkHapticProperty(), np.where(RAMP < 1550.0, 0.0, 1000.0)
    with told(feel, "pass a vtkImageData"):
        assert not feel.ProposeFromImage(None)
    volume = image(step)
    name = volume.GetPointData().GetScalars().GetName()
    volume.GetPointData().SetActiveScalars(None)
    with told(feel, "choose an array with GetPointData()->SetActiveScalars(name)"):
        assert not feel.ProposeFromImage(volume)
    with told(feel, "choose an array with GetPointData()->SetActiveScalars(name)"):
        assert not feel.ApplyPreset("MRI", volume)
    with told(feel, "pass a vtkImageData, or call ApplyPreset(name)"):
        assert not feel.ApplyPreset("MRI", None)
    volume.GetPointData().SetActiveScalars(name)
    assert feel.ApplyPreset("MRI") and feel.ApplyPreset("MRI", volume)
    assert feel.ProposeFromImage(volume)
    assert feel.GetStiffness().GetValue(1000.0) > 0.0
    for wrong, word in (
            (np.full(RAMP.shape, 7.0), "there are no edges to propose functions from. Use another array or component"),
            (np.full(RAMP.shape, math.nan), "has no finite value. Use another array or component"),
            (step[:, :3, :].copy(), "points along every axis, or set the functions by hand")):
        with told(feel, word):
            assert not feel.ProposeFromImage(image(wrong))
        assert feel.ProposeFromImage(image(step))


@result("Touch three or more different ones", "Touch one well beside it", "three or more are needed. Touch more", "Touch again, while the device is ready", "Give each touched point its known position")
def calibrations(_):
    """Of a device whose axes are the world's, in metres instead of millimetres."""
    fit = vtkHapticDevice()

    def add(*points):
        touched, known = vtkPoints(), vtkPoints()
        for x in points:
            touched.InsertNextPoint([0.001 * one for one in x])
            known.InsertNextPoint(x)
        return fit.FitDeviceToWorld(touched, known) >= 0.0

    with told(fit, "Give each touched point its known position"):
        known = vtkPoints()
        known.InsertNextPoint(1.0, 2.0, 3.0)
        assert fit.FitDeviceToWorld(None, known) == -1.0

    with told(fit, "three or more are needed. Touch more"):
        assert not add((0, 0, 0), (50, 0, 0))
    with told(fit, "Touch three or more different ones"):
        assert not add((1, 2, 3), (1, 2, 3), (1, 2, 3))
    with told(fit, "Touch one well beside it"):
        assert not add((0, 0, 0), (50, 0, 0), (100, 0, 0))
    with told(fit, "Touch again, while the device is ready"):
        assert not add((0, 0, 0), (50, 0, 0), (math.inf, 0, 0))
    assert add((0, 0, 0), (50, 0, 0), (0, 50, 0))
    assert fit.GetDeviceToWorld().GetElement(0, 0) == pytest.approx(1000.0)


def try_calls(words, function, folder):
    TOLD.clear()
    function(folder)
    assert set(words) == TOLD


@pytest.mark.parametrize("words", result)
def test_cures_of_calls(words, tmp_path):
    try_calls(words, result[words], tmp_path)
