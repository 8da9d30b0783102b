# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Feel a pair of vortices: a hand is drawn through the flow, and the cores hold it back.

python3 vortex_pair.py [--picture FILE]
"""
import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersSources import vtkLineSource
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor,
    vtkWindowToImageFilter)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from volumehaptics import vtkHapticVortexMode, vtkVolumeHapticsFilter

CORE, APART, STRONGEST = 8.0, 24.0, 2.0  # mm, mm, N


def make_flow():
    """Two Lamb-Oseen vortices that turn against each other: v = (1 - exp(-r^2/CORE^2))/r around each axis."""
    image = vtkImageData()
    image.SetDimensions(121, 81, 17)
    image.SetOrigin(-60, -40, -8)
    x, y = np.meshgrid(np.arange(-60.0, 61.0), np.arange(-40.0, 41.0))
    flow = np.zeros((17, 81, 121, 3))
    for sign, middle in ((1.0, -APART / 2), (-1.0, APART / 2)):
        square = (x - middle) ** 2 + y**2
        turn = sign * np.where(square > 0, -np.expm1(-square / CORE**2) / np.maximum(square, 1e-12), 1 / CORE**2)
        flow[..., 0] -= turn * y
        flow[..., 1] += turn * (x - middle)
    array = numpy_to_vtk(flow.reshape(-1, 3), deep=True)
    array.SetName("velocity")
    image.GetPointData().SetVectors(array)
    return image


def feel(flow):
    """A hand is drawn through both cores along x; the trace of what it feels."""
    mode = vtkHapticVortexMode()
    mode.SetArrayName("velocity")
    mode.GetStrength().AddPoint(0.0, 0.0)  # against the vorticity
    mode.GetStrength().AddPoint(2.0 / CORE**2, STRONGEST)
    path = vtkLineSource()
    path.SetPoint1(-50, 3, 0)
    path.SetPoint2(50, 3, 0)
    path.SetResolution(2000)  # 50 mm/s
    touch = vtkVolumeHapticsFilter()
    touch.SetInputData(flow)
    touch.SetPathConnection(path.GetOutputPort())
    touch.AddMode(mode)
    touch.SetMethodToPrimitives()
    touch.Update()
    return touch.GetOutput()


def stream_lines(flow):
    seeds = vtkLineSource()
    seeds.SetPoint1(-55, 0, 0)
    seeds.SetPoint2(55, 0, 0)
    seeds.SetResolution(36)
    lines = vtkStreamTracer()
    lines.SetInputData(flow)
    lines.SetSourceConnection(seeds.GetOutputPort())
    lines.SetMaximumPropagation(130)
    lines.SetIntegrationDirectionToBoth()
    lines.SetInterpolatorTypeToDataSetPointLocator()
    return lines


def make_actor(source, radius, colours=None, colour=(1, 1, 1)):
    tube = vtkTubeFilter()
    if hasattr(source, "GetOutputPort"):
        tube.SetInputConnection(source.GetOutputPort())
    else:
        tube.SetInputData(source)
    tube.SetRadius(radius)
    tube.SetNumberOfSides(12)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(tube.GetOutputPort())
    if colours:
        mapper.SetLookupTable(colours)
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("NormalForce")
        mapper.UseLookupTableScalarRangeOn()
    else:
        mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(colour)
    return actor


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--picture", metavar="FILE", help="write a PNG instead of opening a window")
    picture = parser.parse_args().picture
    flow = make_flow()
    trace = feel(flow)
    data = trace.GetPointData()
    force, proxy = vtk_to_numpy(data.GetArray("NormalForce")), vtk_to_numpy(trace.GetPoints().GetData())
    for middle in (-APART / 2, APART / 2):
        nearest = np.abs(proxy[:, 0] - middle).argmin()
        print(f"core at {middle:.0f} mm: strongest {force[np.abs(proxy[:, 0] - middle) < CORE].max():.3f} N, "
              f"proxy at y = {proxy[nearest, 1]:.2f} mm")

    colours = vtkColorTransferFunction()
    for share, name in ((0.0, "RoyalBlue"), (0.4, "MediumSeaGreen"), (0.7, "Gold"), (1.0, "OrangeRed")):
        colours.AddRGBPoint(share * STRONGEST, *vtkNamedColors().GetColor3d(name))
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetTitle("Force (N)")
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.1f")
    bar.UnconstrainedFontSizeOn()
    bar.GetLabelTextProperty().SetFontSize(16)
    bar.GetTitleTextProperty().SetFontSize(17)
    bar.SetPosition(0.9, 0.2)
    bar.SetHeight(0.6)
    bar.SetWidth(0.08)
    renderer = vtkRenderer()
    renderer.SetBackground(0.07, 0.08, 0.11)
    renderer.AddActor(make_actor(stream_lines(flow), 0.12, colour=(0.55, 0.62, 0.7)))
    renderer.AddActor(make_actor(trace, 0.7, colours))
    renderer.AddActor2D(bar)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(picture is not None)
    window.SetSize(1100, 700)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, -60, 140)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 1, 0)
    renderer.ResetCamera(-52, 52, -33, 33, -2, 2)
    camera.Zoom(1.45)
    if picture:
        window.Render()
        grab, writer = vtkWindowToImageFilter(), vtkPNGWriter()
        grab.SetInput(window)
        writer.SetInputConnection(grab.GetOutputPort())
        writer.SetFileName(picture)
        writer.Write()
        return
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    interactor.Start()


if __name__ == "__main__":
    main()
