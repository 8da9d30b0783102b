# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Feel fields along a path: a hand moves through one of five fields, and the picture shows the force that stops it.

python3 felt_fields.py pipe      a swirling flow in a bent pipe, on an unstructured grid
python3 felt_fields.py openfoam  a swirling flow in a straight pipe; OpenFOAM computes it the first time
python3 felt_fields.py fibres    a diffusion phantom: a bundle that turns, crossed by a straight one
python3 felt_fields.py charges   the equipotentials of point charges
python3 felt_fields.py vessels   a tree of vessels; the hand follows the ridge of one

Add --picture FILE for a PNG instead of a window. ../openfoam/pipe_cyclic.sh computes the flow of OpenFOAM without
feeling it; felt_fields.py openfoam CASE.foam feels it wherever it is.
"""
import argparse
import shutil
import subprocess
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData, vtkStructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkContourFilter, vtkTensorGlyph, vtkTubeFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
from volumehaptics import vtkHapticMode, vtkVolumeHapticsFilter

from force_scene import STRONGEST, make_actor, make_bar, make_colours, make_renderer, show, trace_stream


def add_array(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.GetPointData().AddArray(array)
    return array


def make_image(size, spacing=1.0):
    """Returns an image around the origin, and the coordinates of its points."""
    image = vtkImageData()
    image.SetDimensions(size)
    image.SetSpacing(spacing, spacing, spacing)
    image.SetOrigin([-0.5 * spacing * (n - 1) for n in size])
    axes = [spacing * (np.arange(n) - 0.5 * (n - 1)) for n in size]
    z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    return image, np.stack([x, y, z], -1).reshape(-1, 3)


def make_path(places, speed=50.0):
    """Returns a path through positions (mm) at a speed (mm/s), with a point for each tick of a millisecond."""
    places = np.asarray(places, float)
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(places, axis=0), axis=1))])
    ticks = np.arange(0.0, way[-1], 1e-3 * speed)
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for along in ticks:
        points.InsertNextPoint([np.interp(along, way, places[:, c]) for c in range(3)])
    path = vtkPolyData()
    path.SetPoints(points)
    return path


def pipe():
    """Returns the flow in a bend of 90 degrees: Poiseuille's profile, with a swirl around the pipe's axis."""
    # mm: radius of the bend, radius of the pipe; numbers of points along the bend, along the radius, around the axis
    bend, radius, n = 40.0, 10.0, (49, 17, 25)
    angle, out, turn = (a.ravel(order="F") for a in np.meshgrid(
        np.linspace(0, np.pi / 2, n[0]), np.linspace(0, radius, n[1]), np.linspace(0, 2 * np.pi, n[2]), indexing="ij"))
    away = bend + out * np.cos(turn)
    places = np.stack([away * np.cos(angle), away * np.sin(angle), out * np.sin(turn)], -1)
    along = np.stack([-np.sin(angle), np.cos(angle), 0 * angle], -1)
    outward = np.stack([np.cos(angle), np.sin(angle), 0 * angle], -1)
    around = -np.sin(turn)[:, None] * outward + np.cos(turn)[:, None] * [[0, 0, 1]]
    speed = 0.4 * (1 - (out / radius) ** 2)  # m/s
    grid = vtkStructuredGrid()
    grid.SetDimensions(n)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    grid.SetPoints(points)
    add_array(grid, "U", speed[:, None] * (along + 0.8 * (out / radius)[:, None] * around))
    append = vtkAppendFilter()
    append.SetInputData(grid)
    append.Update()
    steps = np.linspace(0.1, np.pi / 2 - 0.1, 60)
    middle = np.stack([(bend + 4) * np.cos(steps), (bend + 4) * np.sin(steps), 3 * np.sin(6 * steps)], -1)
    seeds = places[(angle == 0) & (out > 0)][::9]  # leaves out the axis, where cells have edges of length zero
    return append.GetOutput(), follow_flow(0.3), make_path(middle), stream_lines(append.GetOutput(), seeds)


def follow_flow(speed):
    """Returns the mode that follows U, with full strength above a speed."""
    mode = vtkHapticMode()
    mode.SetKindToVectorFollow()
    mode.SetArrayName("U")
    mode.GetStrength().AddPoint(0.0, 0.0)
    mode.GetStrength().AddPoint(speed, STRONGEST)
    return mode


def compute_pipe():
    """Returns the case of OpenFOAM's tutorial pipeCyclic in the build folder. Computes it first if it is missing."""
    root = Path(__file__).resolve().parents[2]
    case = root / "build" / "pipe_cyclic"
    if not (case / "computed").exists():
        if not shutil.which("simpleFoam"):
            raise SystemExit("OpenFOAM is not installed: there is no program simpleFoam.\n"
                             "Cure: apt install openfoam openfoam-examples (Debian 12), or see felt_fields.py pipe")
        if subprocess.run(["bash", root / "Examples" / "openfoam" / "pipe_cyclic.sh", case], check=False).returncode:
            raise SystemExit("OpenFOAM's pipe could not be computed: see the messages above.")
    return str(case / "pipe_cyclic.foam")


def openfoam(case=None):
    """Returns the flow of OpenFOAM's tutorial pipeCyclic: a quarter of a pipe along x, made a whole pipe of 20 mm."""
    case = case or compute_pipe()
    reader = vtkOpenFOAMReader()
    reader.SetFileName(case)
    reader.CreateCellToPointOn()
    reader.UpdateInformation()
    steps = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    if not steps or not reader.UpdateTimeStep(steps[-1]):
        raise SystemExit(f"{case}: no OpenFOAM case with results. felt_fields.py openfoam computes one.")
    quarter = reader.GetOutput().GetBlock(0)
    append = vtkAppendFilter()
    append.MergePointsOn()
    for turn in range(4):
        turned, transform = vtkTransformFilter(), vtkTransform()
        transform.RotateX(90 * turn)
        turned.SetInputData(quarter)
        turned.SetTransform(transform)
        turned.TransformAllInputVectorsOn()
        append.AddInputConnection(turned.GetOutputPort())
    append.Update()
    flow, scale = append.GetOutput(), 20.0  # mm for each metre of OpenFOAM's case
    places = scale * vtk_to_numpy(flow.GetPoints().GetData())
    flow.GetPoints().SetData(numpy_to_vtk(places, deep=True))
    fastest = np.linalg.norm(vtk_to_numpy(flow.GetPointData().GetArray("U")), axis=1).max()
    length = np.linspace(4, 80, 40)
    away, turn = 5 + 2 * np.sin(0.25 * length), -0.09 * length  # the path twists at nearly the same rate as the flow
    middle = np.stack([length, away * np.cos(turn), away * np.sin(turn)], -1)
    seeds = places[(places[:, 0] < 1e-6) & (np.hypot(places[:, 1], places[:, 2]) < 9)]
    return flow, follow_flow(0.7 * fastest), make_path(middle), stream_lines(flow, seeds, 85)


def stream_lines(flow, seeds, longest=150):
    """Returns tubes along the lines of the flow U that begin at some positions."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(seeds), deep=True))
    source = vtkPolyData()
    source.SetPoints(points)
    lines, tubes = trace_stream(flow, "U", source, longest), vtkTubeFilter()
    tubes.SetInputConnection(lines.GetOutputPort())
    tubes.SetRadius(0.12)
    return tubes


def fibres():
    """Returns tensors of a bundle that turns by 90 degrees. Where a second bundle crosses it, the tensors are flat."""
    image, x = make_image((81, 61, 25))
    share = np.clip((x[:, 0] + 30) / 60, 0, 1)
    angle = 0.5 * np.pi * share
    turning = np.stack([np.sin(angle), np.cos(angle), 0 * angle], -1)
    crossing = np.broadcast_to([0.0, 1.0, 0.0], x.shape)
    weight = np.exp(-((x[:, 0] - 18) / 5) ** 2)[:, None, None]
    tensor = np.eye(3) * 0.3e-3 + 1.4e-3 * (
        (1 - 0.5 * weight) * turning[:, :, None] * turning[:, None, :]
        + 0.5 * weight * crossing[:, :, None] * crossing[:, None, :])
    add_array(image, "tensor", tensor[:, [0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]])
    mode = vtkHapticMode()
    mode.SetKindToTensorFollow()
    mode.SetArrayName("tensor")
    mode.ProposeFromImage(image)
    return image, mode, make_path([[-30, -20, 0], [30, 8, 0]]), ellipsoids(image, 5.0 / 1.7e-3)


def make_layer(image, rate=1):
    """Returns a filter that extracts the middle layer along z, with all samples or every `rate`-th sample."""
    layer = vtkExtractVOI()
    layer.SetInputData(image)
    layer.SetVOI(0, image.GetDimensions()[0] - 1, 0, image.GetDimensions()[1] - 1, *[image.GetDimensions()[2] // 2] * 2)
    layer.SetSampleRate(rate, rate, 1)
    return layer


def ellipsoids(image, scale):
    """Returns every sixth tensor of the middle layer as an ellipsoid."""
    layer = make_layer(image, 6)
    sphere = vtkSphereSource()
    glyphs = vtkTensorGlyph()
    glyphs.SetInputConnection(layer.GetOutputPort())
    glyphs.SetSourceConnection(sphere.GetOutputPort())
    glyphs.SetInputArrayToProcess(0, 0, 0, 0, "tensor")
    glyphs.SetScaleFactor(scale)
    glyphs.ColorGlyphsOff()
    return glyphs


def charges():
    """Returns the field of two charges and an opposite one, whose fronts the hand feels: it slides along
    equipotentials."""
    image, x = make_image((81, 61, 41))
    potential, field = np.zeros(len(x)), np.zeros_like(x)
    for charge, place in ((1.0, (-18, 0, 0)), (1.0, (18, 8, 0)), (-1.0, (4, -16, 0))):
        away = x - place
        distance = np.maximum(np.linalg.norm(away, axis=1), 3.0)
        potential += 100 * charge / distance
        field += 100 * charge * away / distance[:, None] ** 3
    add_array(image, "field", field)
    image.GetPointData().SetScalars(add_array(image, "potential", potential))
    mode = vtkHapticMode()
    mode.SetKindToVectorFront()
    mode.SetArrayName("field")
    mode.TwoSidedOn()
    mode.ProposeFromImage(image)
    layer, lines, tubes = make_layer(image), vtkContourFilter(), vtkTubeFilter()
    lines.SetInputConnection(layer.GetOutputPort())
    lines.GenerateValues(15, -7.0, 14.0)
    tubes.SetInputConnection(lines.GetOutputPort())
    tubes.SetRadius(0.15)
    return image, mode, make_path([[-8, 0, 0], [-14, 12, 0], [-30, 2, 0], [-20, -14, 0]]), tubes


def vessels():
    """Returns bright tubes that branch. The hand is held on the centre line of the tube that it follows."""
    image, x = make_image((81, 61, 31))
    value = np.zeros(len(x))
    ends = {"trunk": ((-38, -4, 0), (0, 0, 0), 4.0), "left": ((0, 0, 0), (32, 22, 6), 2.8),
            "right": ((0, 0, 0), (34, -18, -5), 2.5), "twig": ((16, 11, 3), (34, 2, 8), 1.8)}
    for start, end, width in ends.values():
        start, end = np.array(start, float), np.array(end, float)
        share = np.clip((x - start) @ (end - start) / np.dot(end - start, end - start), 0, 1)
        distance = np.linalg.norm(x - start - share[:, None] * (end - start), axis=1)
        value = np.maximum(value, 1000 * np.exp(-(distance / width) ** 2))
    image.GetPointData().SetScalars(add_array(image, "brightness", value))
    mode = vtkHapticMode()
    mode.SetKindToRidge()
    mode.ProposeFromImage(image)
    contour = vtkContourFilter()
    contour.SetInputData(image)
    contour.SetValue(0, 500.0)
    return image, mode, make_path([[-34, -2, 1], [-2, 1.5, 0.5], [28, 20, 6]]), contour


def as_line(path):
    line = vtkPolyData()
    line.SetPoints(path.GetPoints())
    cells = vtkCellArray()
    cells.InsertNextCell(path.GetNumberOfPoints())
    for i in range(path.GetNumberOfPoints()):
        cells.InsertCellPoint(i)
    line.SetLines(cells)
    return line


def main():
    fields = {function.__name__: function for function in (pipe, openfoam, fibres, charges, vessels)}
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("field", choices=fields)
    parser.add_argument("case", nargs="?", metavar="CASE.foam", help="of openfoam: a pipe that is computed already")
    parser.add_argument("--picture", metavar="FILE", help="write a PNG instead of opening a window")
    options = parser.parse_args()
    if options.case and options.field != "openfoam":
        parser.error("a case goes with openfoam only")
    cases = [options.case] if options.case else []
    data, mode, path, surface = fields[options.field](*cases)
    touch = vtkVolumeHapticsFilter()
    touch.SetInputData(0, data)
    touch.SetPathData(path)
    touch.AddMode(mode)
    touch.SetMethodToPrimitives()
    touch.Update()
    trace = touch.GetOutput()
    force = vtk_to_numpy(trace.GetPointData().GetArray("NormalForce"))
    if not len(force):
        raise SystemExit("Nothing was felt: see the errors above.")
    apart = vtk_to_numpy(trace.GetPoints().GetData()) - vtk_to_numpy(trace.GetPointData().GetArray("Tip"))
    print(f"{mode.GetText()}: {len(force)} ticks, strongest {force.max():.2f} N, "
          f"felt in {100 * (force > 0.01).mean():.0f} % of them, "
          f"held back by {np.linalg.norm(apart, axis=1).max():.1f} mm at most")

    colours = make_colours()
    renderer = make_renderer(make_actor(as_line(path), 0.15), make_actor(trace, 0.5, colours))
    renderer.AddActor2D(make_bar(colours))
    if surface:
        renderer.AddActor(make_actor(surface, opacity=0.4))
    if options.field == "openfoam":
        renderer.ResetCamera(-5, 85, -12, 12, -12, 12)  # bounds of the path
    else:
        renderer.ResetCamera(data.GetBounds())
    renderer.GetActiveCamera().Elevation(-35)
    renderer.GetActiveCamera().Zoom(1.3)
    renderer.GetActiveCamera().SetWindowCenter(0.08, 0.0)  # leaves room for the colour bar
    renderer.ResetCameraClippingRange()
    show(renderer, options.picture)


if __name__ == "__main__":
    main()
