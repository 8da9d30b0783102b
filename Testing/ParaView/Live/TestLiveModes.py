# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Modes as rows: the gradient of the Wavelet source as a flow, along a path and with a device, also on a server.

Whatever the flow is, the spring pulls by 0.5 N/mm from the tip to the proxy; what follows the flow is held across it, and
what feels its fronts along it; and no mode holds with more than its strength. The flow at the proxy is interpolated here
by cubic B-splines from the samples that ParaView computed.
"""
import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import live

REMOTE = sys.argv[3] == "Remote"
START, STRENGTH = numpy.array([3.3, -2.4, 1.2]), 0.8  # N
MOST_OFF = 0.02  # of the cosine


def read_flow(source):
    image = servermanager.Fetch(source)
    size, first = image.GetDimensions(), image.GetBounds()[::2]
    values = vtk_to_numpy(image.GetPointData().GetArray("flow")).reshape(size[2], size[1], size[0], 3)

    def flow_at(place):
        index = numpy.subtract(place, first)
        low = numpy.floor(index).astype(int)
        x, y, z = (((1 - t) ** 3 / 6, (3 * t**3 - 6 * t**2 + 4) / 6, (-3 * t**3 + 3 * t**2 + 3 * t + 1) / 6, t**3 / 6)
                   for t in index - low)
        cell = values[low[2] - 1:low[2] + 3, low[1] - 1:low[1] + 3, low[0] - 1:low[0] + 3]
        return numpy.einsum("i,j,k,ijkc->c", z, y, x, cell)

    return flow_at


def across(vector):
    """A unit vector at right angles."""
    found = numpy.cross(vector, (0.0, 0.0, 1.0))
    return found / numpy.linalg.norm(found)


def cosine(force, place):
    flow = flow_at(place)
    return abs(numpy.dot(force, flow)) / numpy.linalg.norm(force) / numpy.linalg.norm(flow)


def check_trace(what, modes, end, is_along):
    """The hand goes straight from START to an end, which is more than the strength holds."""
    touch.Modes = modes
    touch.Path = simple.Line(Point1=list(START), Point2=list(end), Resolution=400)
    touch.UpdatePipeline()
    trace = servermanager.Fetch(touch)
    data = trace.GetPointData()
    force, tip = (vtk_to_numpy(data.GetArray(name)) for name in ("Force", "Tip"))
    proxy = vtk_to_numpy(trace.GetPoints().GetData())
    length = numpy.linalg.norm(force, axis=1)
    live.check(numpy.abs(force - 0.5 * (proxy - tip)).max() < 1e-5, what + ": the force is the spring's")
    live.check(abs(length.max() - STRENGTH) < 1e-5, what + ": it gives way at its strength", length.max())
    angles = [cosine(f, p) for f, p in zip(force[length > 0.1][::20], proxy[length > 0.1][::20])]
    live.check(numpy.abs(numpy.subtract(angles, 1.0 if is_along else 0.0)).max() < MOST_OFF, what + ": the force's direction",
               angles)


def check_error(modes, *words):
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

    log, console = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(log)
    touch.Modes = modes
    touch.UpdatePipeline()
    vtkOutputWindow.SetInstance(console)
    live.check(all(word in log.GetOutput() for word in words), "a row that can't be read", modes, log.GetOutput())
    live.check(touch.GetDataInformation().GetNumberOfPoints() == 0, "and gives nothing")


def press():
    """Until the device's hand is held."""
    touch.Modes = ["VectorFollow", "flow", str(STRENGTH), ""]
    device = simple.HapticDevice(Touch=touch, MaximumRegionVoxels=21**3)
    end = START + across(flow_at(START))
    live.press(device, list(START), list(end))
    live.check(live.poll(device, lambda: live.norm(device.Force) > 0.4), "the device's hand is held across the flow",
               list(device.Force), device.StatusText)
    force = numpy.array(device.Force[:])
    proxy = end + 2.0 * force
    live.check(numpy.linalg.norm(force) <= STRENGTH + 1e-9 and cosine(force, proxy) < MOST_OFF, "and by no more",
               force, cosine(force, proxy))
    live.check("rror" not in device.StatusText, "nothing is wrong", device.StatusText)
    device.Running = 0


def make(scalars):
    global touch, flow_at
    flow = simple.Gradient(Input=simple.Wavelet(), ScalarArray=["POINTS", "RTData"], ResultArrayName="flow")
    flow.UpdatePipeline()
    flow_at = read_flow(flow)
    touch = simple.VolumeHaptics(Input=flow, Scalars=["POINTS", scalars], Method="Primitives")


if REMOTE:
    with live.Server(1):
        live.load_plugin(remote=True)
        make("flow")  # the array that is sent
        press()
        simple.Disconnect()
else:
    live.load_plugin()
    make("RTData")
    here = flow_at(START)
    check_trace("VectorFollow", ["VectorFollow", "flow", str(STRENGTH), "0"], START + 4.0 * across(here), False)
    # Of the magnitude, which is above 1 there.
    check_trace("VectorFrontTwoSided", ["VectorFrontTwoSided", "flow", f"0 0, 1 {STRENGTH}, 1e9 {STRENGTH}", ""],
                START + 2.0 * here / numpy.linalg.norm(here), True)
    check_error(["Followw", "flow", "1", ""], "Followw", "VectorFollow", "Surface")
    check_error(["Shear", "flow", "1", "2"], "Shear", "second strength")
    check_error(["Shear", "flow", "1 N", ""], "Shear", "number of newtons")
    press()
