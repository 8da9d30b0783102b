# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests modes from Python: the force agrees with the drawn shapes, and the demonstrations show what they claim."""

import contextlib
import importlib
import re
import shutil
import time

import numpy as np
import pytest
from demonstration import DEMONSTRATIONS, run
from foam import write_foam
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkRectilinearGrid, vtkStaticPointLocator)
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkTensorGlyph
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from volumehaptics import (
    touch, vtkHapticDevice, vtkHapticGuideMode, vtkHapticMode, vtkVolumeHapticsFilter)


def make_image(name, components, function):
    image = vtkImageData()
    image.SetDimensions(31, 31, 31)
    image.SetOrigin(-15, -15, -15)
    z, y, x = np.meshgrid(*[np.arange(-15.0, 16.0)] * 3, indexing="ij")
    values = np.zeros((x.size, components))
    for c, value in enumerate(function(x.ravel(), y.ravel(), z.ravel())):
        values[:, c] = value
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    image.GetPointData().AddArray(array)
    return image


@contextlib.contextmanager
def felt(mode, image, tip):
    """Opens the virtual device with a mode and its tip at a place; yields the device and a function that moves the
    tip."""
    touch = vtkVolumeHapticsFilter()
    touch.SetInputData(image)
    touch.AddMode(mode)
    touch.SetMethodToPrimitives()
    device = vtkHapticDevice()
    device.SetVolumeHaptics(touch)
    assert device.Open("virtual")

    def lead(place):
        device.GetVirtualHand().SetPosition(*place)
        device.UpdateState()
        tick, end = device.GetState().GetTick(), time.monotonic() + 30.0
        while not (device.UpdateState() and device.GetState().GetTick() > tick + 20):
            assert time.monotonic() < end, device.GetStatusText()
            time.sleep(0.002)
        return np.array(device.GetState().GetProxyPosition())

    device.GetVirtualHand().SetPosition(*tip)
    assert device.Start()
    lead(tip)
    yield device, lead
    device.Close()


def followed(mode, image, tip):
    """Returns the shapes that a mode shows at a tip of the virtual device, and the proxy's position."""
    with felt(mode, image, tip) as (device, _):
        shapes = vtkPolyData()
        device.GetState().GetFollowed(shapes, 24.0)
        return shapes, np.array(device.GetState().GetProxyPosition())


def distance_to(line, place):
    """Returns the distance of a place from a polyline."""
    first, along = line[:-1], np.diff(line, axis=0)
    share = np.clip(((place - first) * along).sum(1) / (along**2).sum(1), 0, 1)
    return np.linalg.norm(first + share[:, None] * along - place, axis=1).min()


def test_a_stream_line_of_a_rotation_is_a_circle():
    image = make_image("flow", 3, lambda x, y, z: (-y, x, 0.0 * z))
    mode = vtkHapticMode()
    mode.SetArrayName("flow")
    shapes, proxy = followed(mode, image, (3.0, -2.0, 1.0))
    line = vtk_to_numpy(shapes.GetPoints().GetData())
    assert shapes.GetNumberOfLines() == 1 and len(line) > 40
    assert np.abs(np.hypot(line[:, 0], line[:, 1]) - np.hypot(proxy[0], proxy[1])).max() < 1e-3
    assert np.abs(line[:, 2] - proxy[2]).max() < 1e-3
    assert np.linalg.norm(line[0] - line[-1]) == 0.0, "it is closed"


@pytest.mark.parametrize("tensors", (False, True))
def test_a_hand_travels_along_the_line_that_is_drawn(tensors):
    """A flow of short waves, or fibres along it, in a rotated image with flat voxels: moved a millimetre beside the
    line, in both directions, the hand stays on the line, and the line follows the flow."""
    image = vtkImageData()
    image.SetDimensions(41, 41, 61)
    image.SetSpacing(1.0, 1.0, 0.7)
    turn = np.array([[0.8, -0.6, 0.0], [0.36, 0.48, -0.8], [0.48, 0.64, 0.6]])
    image.SetDirectionMatrix(*turn.ravel())
    image.SetOrigin(*(-turn @ [20.0, 20.0, 21.0]))
    places = np.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])

    def flow(x):  # waves of Arnold, Beltrami and Childress
        a, b, c = np.moveaxis(2 * np.pi / 18 * x, -1, 0)
        return np.stack([np.sin(c) + 0.8 * np.cos(b), 0.7 * np.sin(a) + np.cos(c), 0.8 * np.sin(b) + 0.7 * np.cos(a)], -1)

    v = flow(places)
    values = 0.1 * np.eye(3) + v[:, :, None] * v[:, None, :] if tensors else v
    array = numpy_to_vtk(values.reshape(len(v), -1), deep=True)
    array.SetName("flow")
    image.GetPointData().AddArray(array)
    mode = vtkHapticMode()
    mode.SetKind(mode.TENSOR_FOLLOW if tensors else mode.VECTOR_FOLLOW)
    mode.SetArrayName("flow")
    mode.GetStrength().AddPoint(0.0, 2.0)
    shapes, apart = vtkPolyData(), []
    with felt(mode, image, (2.0, -3.0, 1.0)) as (device, lead):
        device.GetState().GetFollowed(shapes, 20.0)
        ids = vtkIdList()
        shapes.GetCellPoints(shapes.GetNumberOfVerts(), ids)
        line = np.array([shapes.GetPoint(ids.GetId(i)) for i in range(ids.GetNumberOfIds())])
        assert len(line) > 70
        begin = np.linalg.norm(line - device.GetState().GetProxyPosition(), axis=1).argmin()
        for half in (line[begin:-4:2], line[begin:4:-2]):
            assert len(half) > 15
            lead(half[0])
            for near, place in zip(half, half[1:]):
                across = np.cross(place - near, [0.3, -0.4, 0.5])
                proxy = lead(place + across / np.linalg.norm(across))
                apart.append(distance_to(line, proxy))
                assert np.linalg.norm(proxy - place) < 0.6, "and it is led along"
    assert max(apart) < 0.05
    along, wanted = np.diff(line, axis=0), flow(0.5 * (line[1:] + line[:-1]))
    cosines = np.abs((along * wanted).sum(1)) / np.linalg.norm(along, axis=1) / np.linalg.norm(wanted, axis=1)
    assert cosines.min() > np.cos(np.radians(4)), "but for what kernels smooth"


def test_a_stream_line_is_that_of_the_stream_tracer():
    # The field is linear, so VTK's trilinear values equal the servo's splines.
    image = make_image("flow", 3, lambda x, y, z: (-y + 0.1 * z, x, 2.0 + 0.05 * x))
    mode = vtkHapticMode()
    mode.SetArrayName("flow")
    shapes, proxy = followed(mode, image, (6.0, -2.0, -1.0))
    assert shapes.GetNumberOfLines() == 1
    ours = vtk_to_numpy(shapes.GetPoints().GetData())
    seed = vtkPolyData()
    seed.SetPoints(vtkPoints())
    seed.GetPoints().SetDataTypeToDouble()
    seed.GetPoints().InsertNextPoint(proxy)
    tracer = vtkStreamTracer()
    tracer.SetInputData(image)
    tracer.SetInputArrayToProcess(0, 0, 0, 0, "flow")
    tracer.SetSourceData(seed)
    tracer.SetIntegratorTypeToRungeKutta45()
    tracer.SetIntegrationDirectionToBoth()
    tracer.SetMaximumError(1e-8)
    tracer.SetIntegrationStepUnit(vtkStreamTracer.LENGTH_UNIT)
    tracer.SetMaximumPropagation(30.0)
    tracer.SetMaximumNumberOfSteps(5000)
    for setting in (tracer.SetInitialIntegrationStep, tracer.SetMinimumIntegrationStep, tracer.SetMaximumIntegrationStep):
        setting(0.01)
    tracer.Update()
    locator = vtkStaticPointLocator()
    locator.SetDataSet(tracer.GetOutput())
    locator.BuildLocator()
    assert len(ours) > 60
    apart = [np.linalg.norm(place - tracer.GetOutput().GetPoint(locator.FindClosestPoint(place))) for place in ours]
    assert max(apart) < 0.01  # voxels; half of the tracer's step is 0.005


def test_a_tensor_is_an_ellipsoid_at_the_proxy():
    # The eigenvalues are 2, 1 and 0.5, the first one along (1, 1, 0).
    image = make_image("tensor", 6, lambda x, y, z: (1.5, 1.5, 0.5, 0.5, 0.0, 0.0))
    mode = vtkHapticMode()
    mode.SetKindToTensorFollow()
    mode.SetArrayName("tensor")
    shapes, proxy = followed(mode, image, (1.0, 2.0, -1.0))
    assert shapes.GetNumberOfVerts() == 1 and shapes.GetNumberOfLines() == 1
    modes = vtk_to_numpy(shapes.GetCellData().GetArray("Mode"))
    assert list(modes) == [0, 0]
    assert np.linalg.norm(np.array(shapes.GetPoint(0)) - proxy) < 1e-9
    place = vtkPolyData()
    place.SetPoints(vtkPoints())
    place.GetPoints().InsertNextPoint(proxy)
    tensor = np.array(shapes.GetPointData().GetTensors().GetTuple(0))
    place.GetPointData().SetTensors(numpy_to_vtk(tensor.reshape(1, 9), deep=True))
    glyph, sphere = vtkTensorGlyph(), vtkSphereSource()
    sphere.SetThetaResolution(60)
    sphere.SetPhiResolution(60)
    glyph.SetInputData(place)
    glyph.SetSourceConnection(sphere.GetOutputPort())
    glyph.Update()
    points = vtk_to_numpy(glyph.GetOutput().GetPoints().GetData()) - proxy
    # The half axis along the fibre is an eighth of the reach of 24 voxels; those across it are half and a quarter of
    # that.
    half = np.sqrt(0.5)
    for axis, length in (((half, half, 0), 3.0), ((half, -half, 0), 1.5), ((0, 0, 1), 0.75)):
        assert abs(np.ptp(points @ axis) - length) < 0.03 * length


def test_a_surface_holds_a_live_hand():
    """A sphere of 8 mm holds the hand by a spring of 500 N/m, from inside and from outside."""
    image = make_image("nothing", 1, lambda x, y, z: (0.0 * x,))
    image.GetPointData().SetActiveScalars("nothing")
    guide, sphere = vtkHapticGuideMode(), vtkSphereSource()
    sphere.SetRadius(8.0)
    sphere.SetThetaResolution(120)
    sphere.SetPhiResolution(120)
    sphere.Update()
    guide.SetSurface(sphere.GetOutput())
    for inwards in (0.0, 2.0):
        tip = np.array([6.5, 4.2, 2.0])
        tip *= (9.0 - inwards) / np.linalg.norm(tip)
        shapes, proxy = followed(guide, image, tip)
        assert abs(np.linalg.norm(proxy) - 8.0) < 0.02 and np.linalg.norm(proxy - 8.0 / np.linalg.norm(tip) * tip) < 0.1
        assert shapes.GetNumberOfVerts() + shapes.GetNumberOfPolys() + shapes.GetNumberOfLines() > 0


def test_a_preset_and_a_surface_from_python():
    image = make_image("flow", 3, lambda x, y, z: (-y, x, 0.0 * z))
    touch = vtkVolumeHapticsFilter()
    names = [touch.GetModePresetNames().GetValue(i) for i in range(touch.GetModePresetNames().GetNumberOfValues())]
    assert "Find a vortex" in names and touch.ApplyModePreset("Find a vortex", image)
    assert touch.GetMode(0).GetText() == "vortex, flow"
    guide, plane = vtkHapticGuideMode(), vtkPlaneSource()
    plane.SetOrigin(-15, -15, 2)
    plane.SetPoint1(15, -15, 2)
    plane.SetPoint2(-15, 15, 2)
    plane.Update()
    guide.SetSurface(plane.GetOutput())
    touch.RemoveAllModes()
    touch.AddMode(guide)
    image.GetPointData().SetScalars(numpy_to_vtk(np.zeros(image.GetNumberOfPoints()), deep=True))
    path = vtkPolyData()
    path.SetPoints(vtkPoints())
    for step in range(60):
        path.GetPoints().InsertNextPoint(0.1 * step, 3.0, 2.0 + 0.05 * step)
    touch.SetInputData(image)
    touch.SetPathData(path)
    touch.Update()
    trace = touch.GetOutput()
    assert trace.GetNumberOfPoints() == 60
    assert np.allclose(trace.GetPoint(59), (5.9, 3.0, 2.0), atol=1e-4)
    assert np.allclose(trace.GetPointData().GetArray("Force").GetTuple(59), (0, 0, -0.5 * 2.95), atol=1e-4)


def make_grid(first, last, components=3, of="cells"):
    """Returns a rectilinear grid from `first` to `last` in x, uneven in y, with a uniform flow, or a tensor, along
    x."""
    grid, sizes = vtkRectilinearGrid(), []
    for axis, places in (("X", np.linspace(first, last, 7)), ("Y", 12 * np.linspace(-1, 1, 8) ** 3), ("Z", [-9, 0, 9])):
        getattr(grid, f"Set{axis}Coordinates")(numpy_to_vtk(np.array(places, float), deep=True))
        sizes.append(len(places))
    grid.SetDimensions(sizes)
    data, count = (grid.GetCellData(), grid.GetNumberOfCells()) if of == "cells" else (
        grid.GetPointData(), grid.GetNumberOfPoints())
    array = numpy_to_vtk(np.tile(np.eye(1, components) * 3.0, (count, 1)), deep=True)
    array.SetName("U")
    data.AddArray(array)
    return grid


def in_blocks(*grids):
    blocks = vtkMultiBlockDataSet()
    for i, grid in enumerate(grids):
        blocks.SetBlock(i, grid)
    return blocks


def unstructured(grid):
    append = vtkAppendFilter()
    append.SetInputData(grid)
    append.Update()
    return append.GetOutput()


@pytest.mark.parametrize("make, mode", (
    (lambda: make_grid(-12, 12), None),
    (lambda: unstructured(make_grid(-12, 12, of="points")), "Follow the flow"),
    (lambda: in_blocks(make_grid(-12, 0), None, make_grid(0, 12)), None),
    (lambda: make_grid(-12, 12, components=6), None)))
def test_grids_are_felt(make, mode):
    """The tip goes 1 mm along a flow or a fibre and 6 mm across it: a spring of 500 N/m up to 2 N, then constant 2
    N."""
    across = np.linspace(0, 6, 121)
    trace = touch(make(), np.stack([across / 6, across, 0 * across], -1), mode=mode)
    force = vtk_to_numpy(trace.GetPointData().GetArray("Force"))
    assert np.allclose(force[:, 1], -np.minimum(0.5 * across, 2.0), atol=0.01)
    assert np.abs(force[:, [0, 2]]).max() < 0.01
    assert trace.GetPointData().HasArray("ModeForce_0")


def test_grids_that_can_not_be_felt_say_why():
    path = [[0, 0, 0], [1, 0, 0]]
    with pytest.raises(ValueError, match="(?s)Fly.*Follow the flow"):
        touch(make_grid(-12, 12), path, mode="Fly")
    flat = make_grid(-12, 12)
    flat.SetZCoordinates(numpy_to_vtk(np.zeros(3), deep=True))
    with pytest.raises(ValueError, match="no volume. Cure"):
        touch(flat, path)
    with pytest.raises(ValueError, match="no cells"):
        touch(vtkMultiBlockDataSet(), path)
    with pytest.raises(TypeError):
        touch(vtkPolyData(), path)


def test_a_case_of_openfoam_is_felt(tmp_path):
    """Touches the last time step of a flow along the pipe: the hand is held across the flow, as far as the path
    turns."""
    case = write_foam(tmp_path / "case", (5.0, 0.36, 0.5), np.tile([1.0, 0.0, 0.0], (20, 1)))
    said = run("felt_fields.py", tmp_path / "picture.png", "openfoam", case)
    assert re.match(r"vector follow, U: \d+ ticks, strongest 2.00 N", said), said


def test_openfoam_computes_its_case_once(tmp_path, monkeypatch):
    """Runs a script in place of OpenFOAM's programs; without OpenFOAM, the program says what to install."""
    monkeypatch.syspath_prepend(DEMONSTRATIONS)
    fields = importlib.import_module("felt_fields")
    monkeypatch.setattr(fields, "__file__", str(tmp_path / "Examples" / "Python" / "felt_fields.py"))
    monkeypatch.setattr(shutil, "which", lambda program: None)
    with pytest.raises(SystemExit, match="(?s)simpleFoam.*apt install openfoam openfoam-examples"):
        fields.compute_pipe()
    monkeypatch.setattr(shutil, "which", lambda program: f"/usr/bin/{program}")
    script = tmp_path / "Examples" / "openfoam" / "pipe_cyclic.sh"
    script.parent.mkdir(parents=True)
    script.write_text('echo once >> "$(dirname "$0")/log" && mkdir -p "$1" && touch "$1/computed"\n', encoding="ascii")
    for _ in range(2):
        assert fields.compute_pipe() == str(tmp_path / "build" / "pipe_cyclic" / "pipe_cyclic.foam")
    assert (script.parent / "log").read_text(encoding="ascii") == "once\n"
    shutil.rmtree(tmp_path / "build")
    script.write_text("exit 1\n", encoding="ascii")
    with pytest.raises(SystemExit, match="could not be computed"):
        fields.compute_pipe()


@pytest.mark.parametrize("field, kind, held", (
    ("pipe", "vector follow, U", 4.0),
    ("fibres", "tensor follow, tensor", 4.0),
    ("charges", "vector front, field", 4.0),
    ("vessels", "ridge", 4.0)))
def test_a_field_is_felt(field, kind, held, tmp_path):
    said = run("felt_fields.py", tmp_path / "picture.png", field)
    found = re.match(
        r"(.*): \d+ ticks, strongest ([\d.]+) N, felt in (\d+) % of them, held back by ([\d.]+) mm", said)
    assert found and found[1] == kind, said
    # The strength is 2 N, which the spring of 500 N/m reaches at 4 mm.
    assert 0.3 < float(found[2]) < 2.01 and int(found[3]) > 30 and 0.5 < float(found[4]) <= held + 0.1, said


def test_two_vortices_hold_the_hand(tmp_path):
    said = run("vortex_pair.py", tmp_path / "picture.png")
    found = re.findall(r"core at (-?\d+) mm: strongest ([\d.]+) N", said)
    assert [float(core) for core, _ in found] == [-12.0, 12.0], said
    assert all(1.0 < float(force) < 2.05 for _, force in found), said
