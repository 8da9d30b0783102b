# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""For a hand that strokes the head phantom, every method gives the same trace as before.

    python3 -m pytest TestBaselineTraces.py --write-baselines # writes new baselines

The stroke comes from above, presses 3 mm into the crown and slides 24 mm towards the right ear. The baselines hold
the proxy, the force and the contact. Other tests show that the values are right. The materials are defined here, so
that presets may change.
"""

import math

import compare_traces
import pytest
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataWriter
from volumehaptics import vtkVolumeHapticsFilter

SKIN = -300.0  # isovalue (HU) of the phantom's skin
ARRAYS = ("Force", "Contact")
# Baselines, and the points of vtkFlyingEdges3D, have single precision.
TOLERANCE = 1e-5

# Nodes of each function: HU or HU/mm, and the function's value.
MATERIALS = {
    "Stiffness": ((0, 400.0),),
    "Friction": ((0, 0.2),),
    "Viscosity": (
        (-1024, 0), (-955, 0), (-950, 0.05), (-500, 0.05), (-150, 0.2), (-30, 0.2), (-10, 0.3), (15, 0.3), (20, 0.4),
        (80, 0.4), (100, 0.4), (300, 0.4), (310, 0), (3071, 0)),
    "SurfaceStrength": (
        (-1024, 0), (-955, 0), (-950, 0.3), (-500, 0.3), (-150, 0.7), (-30, 0.7), (-10, 0.1), (15, 0.1), (20, 1.5),
        (80, 1.5), (100, 2.5), (300, 2.5), (310, 1e6), (3071, 1e6)),
    "Distinctness": ((8, 0), (40, 1)),
}

METHODS = {
    "Paper": lambda f: f.SetSolverToPaper(),
    "Precise": lambda f: (f.SetMaterialPlacementToKernel(), f.SetContactAlignmentToDistinctness()),
    "ForceField": lambda f: (f.SetMethodToForceField(), f.SetForceFieldGain(0.005)),
    "SurfaceProxy": lambda f: f.SetMethodToSurfaceProxy(),
    "LocalPlane": lambda f: f.SetMethodToLocalSurface(),
    "LocalQuadric": lambda f: (f.SetMethodToLocalSurface(), f.SetLocalSurfaceShapeToQuadric()),
}


def make_stroke(top):
    """A press and a slide, 1 ms a point, from 5 mm above the crown (world, mm)."""
    path = vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for tick in range(400):
        press = min(tick, 100) * 0.08
        slide = max(0, tick - 100) * 0.08
        points.InsertNextPoint(-slide, 3.0 * math.sin(0.2 * slide), top + 5.0 - press)
    path.SetPoints(points)
    return path


def find_crown(image):
    """Returns the height (mm) at which the axis through the origin meets the skin from above."""
    scalars = image.GetPointData().GetScalars()
    for k in reversed(range(image.GetDimensions()[2])):
        point = image.FindPoint(0.0, 0.0, image.GetOrigin()[2] + k * image.GetSpacing()[2])
        if scalars.GetTuple1(point) > SKIN:
            return image.GetPoint(point)[2]
    raise AssertionError("the phantom has no crown")


def touch(image, path, choose):
    touch_filter = vtkVolumeHapticsFilter()
    touch_filter.SetInputData(0, image)
    touch_filter.SetPathData(path)
    touch_filter.SetIsoValue(SKIN)
    for function, nodes in MATERIALS.items():
        material = getattr(touch_filter.GetProperty(), "Get" + function)()
        for value, height in nodes:
            material.AddPoint(value, height)
    choose(touch_filter)
    touch_filter.Update()
    trace = vtkPolyData()
    trace.ShallowCopy(touch_filter.GetOutput())
    return trace


def write(trace, name):
    """Writes the arrays of a baseline in as few bytes as possible."""
    small = vtkPolyData()
    points = vtkPoints()
    points.SetDataType(VTK_FLOAT)
    points.DeepCopy(trace.GetPoints())
    small.SetPoints(points)
    for array in ARRAYS:
        source = trace.GetPointData().GetArray(array)
        copy = source.NewInstance() if array == "Contact" else points.GetData().NewInstance()
        copy.SetName(array)
        copy.DeepCopy(source)
        small.GetPointData().AddArray(copy)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(name)
    writer.SetInputData(small)
    writer.SetDataModeToBinary()
    assert writer.Write(), name


@pytest.fixture(scope="module")
def image(data):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(data / "HeadPhantom.vti"))
    reader.Update()
    return reader.GetOutput()


@pytest.mark.parametrize("name", METHODS)
def test_trace_is_that_of_the_baseline(name, image, baselines, tmp_path, pytestconfig):
    trace = touch(image, make_stroke(find_crown(image)), METHODS[name])
    contact = trace.GetPointData().GetArray("Contact")
    touched = sum(contact.GetTuple1(i) > 0.0 for i in range(trace.GetNumberOfPoints()))
    assert name == "ForceField" or touched > 200, f"{name} touched {touched} ticks long"
    baseline = baselines / f"Trace{name}.vtp"
    target = baseline if pytestconfig.getoption("--write-baselines") else tmp_path / baseline.name
    write(trace, str(target))
    result = compare_traces.main([str(target), str(baseline), "--tolerance", str(TOLERANCE)])
    assert result == 0, f"{target} is not as {baseline} says"
