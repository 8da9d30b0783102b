# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sets modes as rows: the gradient of the Wavelet source is a flow, felt along a path and with a device, also on a
server.

Whatever the flow is, the spring pulls by 0.5 N/mm from the tip to the proxy. A mode that follows the flow holds the
hand across it, a mode of its fronts holds it along the flow, and no mode holds with more than its strength. The flow
at the proxy is interpolated here by cubic B-splines from the samples that ParaView computed.
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
    """Returns a unit vector at right angles to `vector`."""
    found = numpy.cross(vector, (0.0, 0.0, 1.0))
    return found / numpy.linalg.norm(found)


def cosine(force, place):
    flow = flow_at(place)
    return abs(numpy.dot(force, flow)) / numpy.linalg.norm(force) / numpy.linalg.norm(flow)


def check_trace(what, modes, end, is_along):
    """Moves the hand straight from START to `end`, which is further than the strength holds."""
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


def update(modes):
    """Returns what is reported when the modes are felt along the path."""
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

    log, console = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(log)
    touch.Modes = modes
    touch.UpdatePipeline()
    vtkOutputWindow.SetInstance(console)
    return log.GetOutput()


def check_error(modes, *words):
    report = update(modes)
    live.check(all(word in report for word in words), "a row that can't be read", modes, report)
    live.check(touch.GetDataInformation().GetNumberOfPoints() == 0, "and gives nothing")


def check_presets():
    """Every name in the menu is a preset and every preset is in the menu; rows are added to the preset's modes."""
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

    menu = touch.SMProxy.GetProperty("ModePreset").GetDomain("list")
    names = [menu.GetString(i) for i in range(menu.GetNumberOfStrings())]
    log, console = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(log)
    touch.Modes = []
    touch.SMProxy.GetProperty("ModePreset").SetElement(0, "Something")
    touch.SMProxy.UpdateVTKObjects()
    touch.UpdatePipeline()
    vtkOutputWindow.SetInstance(console)
    known = log.GetOutput().split("Use one of:")[1].split("\n")[0].split('"')[1::2]
    live.check(known == names and len(names) > 9, "the menu has all presets", known, names)
    touch.ModePreset = "Follow the flow"
    touch.Path = simple.Line(Point1=list(START), Point2=list(START + 1.0 * across(flow_at(START))), Resolution=100)
    touch.UpdatePipeline()
    trace = servermanager.Fetch(touch)
    force = vtk_to_numpy(trace.GetPointData().GetArray("Force"))[-1]
    place = numpy.array(trace.GetPoint(100))
    live.check(numpy.linalg.norm(force) > 0.1 and cosine(force, place) < MOST_OFF, "a preset holds across the flow", force)
    touch.ModePreset = "None"


def check_guides():
    """Takes a sphere of 5 mm as a guide; the hand goes from inside to 1 mm outside of the sphere, against 0.5 N/mm."""
    touch.Surface = simple.Sphere(Radius=5.0, ThetaResolution=64, PhiResolution=64)
    touch.Path = simple.Line(Point1=[3.0, 0.1, 0.2], Point2=[6.0, 0.1, 0.2], Resolution=300)
    for kind, first, last in (("Guide", 1.0, -0.5), ("GuideOutside", 1.0, 0.0), ("GuideInside", 0.0, -0.5)):
        touch.Modes = [kind, "", "9", ""]
        touch.UpdatePipeline()
        force = vtk_to_numpy(servermanager.Fetch(touch).GetPointData().GetArray("Force"))[:, 0]
        live.check(abs(force[0] - first) < 0.02 and abs(force[-1] - last) < 0.02, kind, force[0], force[-1])
    touch.Surface = simple.Line(Point1=[-5.0, 0.0, 0.0], Point2=[5.0, 0.0, 0.0], Resolution=4)
    touch.Path = simple.Line(Point1=[1.0, 0.0, 0.0], Point2=[2.0, 2.0, 0.0], Resolution=300)
    report = update(["Guide", "", "9", ""])
    live.check(not report, "lines need no second look", report)
    force = vtk_to_numpy(servermanager.Fetch(touch).GetPointData().GetArray("Force"))[-1]
    live.check(numpy.abs(force - [0.0, -1.0, 0.0]).max() < 0.02, "lines lead along themselves", force)
    check_error(["GuideOutside", "", "9", ""], "GuideOutside", "lines", "choose polygons as Surface")
    touch.Surface = None
    check_error(["Guide", "", "9", ""], '"Guide"', "Choose polygons or lines as Surface")


def check_distances():
    """Takes an image of the distances from that sphere. A B-spline of distances r is higher by 1 / (3 r), so that the
    hand is held at 4.932 mm. Returns the force at the path's beginning, 3 mm from the middle."""
    held = 4.932
    touch.Surface = simple.Calculator(Input=simple.Wavelet(), Function="mag(coords) - 5", ResultArrayName="distance")
    touch.Path = simple.Line(Point1=[3.0, 0.1, 0.2], Point2=[6.0, 0.1, 0.2], Resolution=300)
    inside, outside = 0.5 * (held - 3.0), 0.5 * (held - 6.0)
    for kind, array, first, last in (("Guide", "distance", inside, outside), ("Guide", "", inside, outside),
                                     ("GuideOutside", "distance", inside, 0.0), ("GuideInside", "distance", 0.0, outside)):
        report = update([kind, array, "9", ""])
        live.check(not report, kind, report)
        force = vtk_to_numpy(servermanager.Fetch(touch).GetPointData().GetArray("Force"))[:, 0]
        live.check(abs(force[0] - first) < 0.01 and abs(force[-1] - last) < 0.01, kind, array, force[0], force[-1])
    return inside


def check_distances_live():
    """Feels the distances with a device, and checks uses of distances that are refused."""
    inside = check_distances()
    check_error(["Guide", "distances", "9", ""], '"distances"', "Name it in this row")
    touch.Method = "Surface proxy"
    report = update([])
    live.check("vtkImageData" in report and "no triangles" in report, "distances are no polygons", report)
    touch.Method = "Primitives"
    touch.Modes = ["Guide", "distance", "9", ""]
    device = simple.HapticDevice(Touch=touch)
    live.press(device, [6.0, 0.1, 0.2], [3.0, 0.1, 0.2])
    live.check(live.poll(device, lambda: abs(device.Force[0] - inside) < 0.01), "a device's hand is held at the distance 0",
               list(device.Force), device.StatusText)
    device.Running = 0
    simple.Delete(device)
    touch.Surface = None


def press(data=None, voxels=21**3):
    """Moves the tip across the flow until the device's hand is held."""
    touch.Modes = ["VectorFollow", "flow", str(STRENGTH), ""]
    if data:
        touch.Input = data
    device = simple.HapticDevice(Touch=touch, MaximumRegionVoxels=voxels)
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
    simple.Delete(device)


def press_grids():
    """Feels the same flow as data of other kinds, which are resampled linearly around the tip, so the forces differ a
    little."""
    global MOST_OFF
    MOST_OFF = 0.05
    cells = simple.AppendDatasets(Input=touch.Input)
    press(cells, 32**3)
    press(simple.GroupDatasets(Input=[cells]), 32**3)


def make_flow():
    flow = simple.Gradient(Input=simple.Wavelet(), ScalarArray=["POINTS", "RTData"], ResultArrayName="flow")
    flow.UpdatePipeline()
    return flow


def make(scalars):
    global touch
    flow = make_flow()
    touch = simple.VolumeHaptics(Input=flow, Scalars=["POINTS", scalars], Method="Primitives")


flow_at = read_flow(make_flow())  # read the flow before the server starts, of which each process has a part
if REMOTE:
    with live.Server(2):
        live.load_plugin(remote=True)
        make("flow")  # this array is sent to the server
        press()
        press_grids()
        check_distances()
        simple.Disconnect()
else:
    live.load_plugin()
    make("RTData")
    here = flow_at(START)
    check_trace("VectorFollow", ["VectorFollow", "flow", str(STRENGTH), "0"], START + 4.0 * across(here), False)
    # The surface is where the vector's magnitude crosses 1, with larger magnitudes behind it.
    check_trace("VectorFrontTwoSided", ["VectorFrontTwoSided", "flow", f"0 0, 1 {STRENGTH}, 1e9 {STRENGTH}", ""],
                START + 2.0 * here / numpy.linalg.norm(here), True)
    check_error(["Followw", "flow", "1", ""], "Followw", "VectorFollow", "Surface")
    check_error(["Shear", "flow", "1", "2"], "Shear", "second strength")
    check_error(["Shear", "flow", "1 N", ""], "Shear", "number of newtons")
    check_presets()
    check_guides()
    check_distances_live()
    press()
    press_grids()
