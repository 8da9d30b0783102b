# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Feel a pair of vortices: a hand moves through the flow, and the cores hold it back.

python3 vortex_pair.py [--picture FILE]
"""
import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkLineSource
from volumehaptics import vtkHapticMode, vtkVolumeHapticsFilter

from force_scene import STRONGEST, make_actor, make_bar, make_colours, make_renderer, show, trace_stream

CORE, APART = 8.0, 24.0  # mm: radius of a core, distance between the axes


def make_flow():
    """Returns two Lamb-Oseen vortices that turn against each other: v = (1 - exp(-r^2/CORE^2))/r around each axis."""
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
    """Returns the trace of a hand that moves through both cores along x."""
    mode = vtkHapticMode()
    mode.SetKindToVortex()
    mode.SetArrayName("velocity")
    mode.GetStrength().AddPoint(0.0, 0.0)  # N, as a function of the vorticity
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
    lines = trace_stream(flow, "velocity", seeds, 130)
    lines.SetIntegrationDirectionToBoth()
    return lines


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

    colours = make_colours()
    renderer = make_renderer(make_actor(stream_lines(flow), 0.12), make_actor(trace, 0.7, colours))
    renderer.AddActor2D(make_bar(colours))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, -60, 140)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 1, 0)
    renderer.ResetCamera(-52, 52, -33, 33, -2, 2)
    camera.Zoom(1.45)
    show(renderer, picture, (1100, 700))


if __name__ == "__main__":
    main()
