# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures that the filter's error texts name: after the cure, the force is right.

Most press the ramp of cure_bench.py, which gives 1 N, unless a case says otherwise. Cures of Python itself are in
TestCures.py.
"""

import math

import numpy as np
import pytest
from TestCures import RAMP
from cure_bench import Cases, ball, filtered, hold_ball, line_to, table, times, try_case, vectors
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_INT, vtkBitArray, vtkFloatArray, vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkImageData, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData, vtkPolyDataNormals, vtkReverseSense
from vtkmodules.vtkFiltersModeling import vtkFillHolesFilter
from vtkmodules.vtkImagingCore import vtkImageExtractComponents
from volumehaptics import image, vtkHapticGuideMode, vtkHapticMode, vtkHapticNeedle, vtkHapticPointShell

case = Cases()


# -- the volume --

@case("Update its source, or give it dimensions of at least ")
def _(b):
    empty = vtkImageData()
    empty.AllocateScalars(VTK_DOUBLE, 1)
    b.haptics.SetInputData(empty)
    return lambda: sheet(b, 5)


def sheet(b, planes):
    """Gives the filter some planes of the ramp only, with the path in their middle."""
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
    """Returns bits, all of which are 1."""
    bits = vtkBitArray()
    bits.SetNumberOfComponents(components)
    bits.SetNumberOfTuples(number // components)
    for i in range(number):
        bits.SetValue(i, 1)
    return bits


@case("for example with vtkFloatArray::DeepCopy(), and make that the active scalars", 0.0)
def _(b):
    """Where all values are 1, there is no edge."""
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


# -- settings and functions --

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
    # Tissue above z = 25 must not be felt.
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


# -- the path --

@case("is NaN or infinite at point …. Replace or remove that point")
def _(b):
    b.path.GetPoints().SetPoint(20, 5.0, math.nan, 12.0)
    return lambda: (b.path.GetPoints().SetPoint(20, 5.0, 8.0, 12.0), b.path.GetPoints().Modified(), b.path.Modified())


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
    times(b, 1e9 * np.arange(21.0))  # ns instead of s, for a path of 20 s
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


# Labels: material 1 has 200 N/m, which results in 0.4 N.

def labels_of(values, kind=np.uint8):
    return image(np.full(RAMP.shape, values, kind))


@case("Connect a segmentation, not an image of intensities or probabilities", 0.4)
def _(b):
    b.haptics.SetLabelTable(table())
    b.haptics.SetLabelData(labels_of(0.5, np.float32))
    return lambda: b.haptics.SetLabelData(labels_of(1))


@case("Connect one to input port 3 with SetLabelConnection")
def _(b):
    b.haptics.SetGeometryFromLabels()
    return lambda: (b.haptics.SetGeometryFromScalars())


# -- tools and modes --

@case("Choose it with SetMethodToProxy(), or remove the needle")
def _(b):
    b.haptics.SetTool(vtkHapticNeedle())
    b.haptics.SetMethodToForceField()
    return lambda: (b.haptics.SetMethodToProxy(), b.haptics.SetTool(None))


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
    """A distance field holds the hand at the distance 0, at z = 10."""
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
    """Vectors (1, 1, 1): the spring of 500 N/m holds across them. Its length is 2 mm times sqrt(2/3), and 2/3 of the
    force acts along z."""
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


def modes_along(b, count):
    vectors(b)
    modes = [b.follow(vtkHapticMode()) for _ in range(count)]
    for mode in modes:
        mode.SetArrayName("along")
    return modes


@case("Take some away with RemoveMode()")
def _(b):
    modes = modes_along(b, 9)
    return lambda: [b.haptics.RemoveMode(mode) for mode in modes[1:]]


@case("or switch them off with SetActive(false)")
def _(b):
    modes = modes_along(b, 5)
    return lambda: [mode.SetActive(False) for mode in modes[1:]]


@case("Set it with SetLateralStrength()")
def _(b):
    """The needle is held only by the wall that it has not punctured."""
    needle = vtkHapticNeedle()
    needle.SetLateralStrength(math.nan)
    b.haptics.SetTool(needle)
    return lambda: (needle.SetLateralStrength(0.0), b.haptics.SetTool(None))


# -- more labels --

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


# -- shaped tools; Testing/Core/Tools compares the forces of valid tools with closed forms --

@case("with vtkCleanPolyData and SetTolerance()", "ball")
def _(b):
    """Gives each triangle its own points, slightly apart from those of its neighbours."""
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


@pytest.mark.parametrize("words", case)
def test_cures_of_the_filter(words):
    try_case(words, *case[words])
