# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests a device in a render view, without Qt: pvpython TestView.py PLUGIN VOLUME CASE.

Each process opens one view only: if pvpython of ParaView 5.11 has closed a view, ProcessEvents() of the next one
crashes, with or without this plugin.
"""

import re
import sys
import tempfile
import time
from pathlib import Path

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

from view import PATIENCE, force, get, hands, lead_out, make_link, press, run, wait_until


def detach(view, device, link):
    style = view.GetInteractor().GetInteractorStyle()
    link.Attached = 1
    assert view.GetInteractor().GetInteractorStyle() is not style, "nothing is attached"
    assert hands(view) == ["vtkHapticHeadUpDisplay", "vtkHapticRepresentation"], "the hand is not shown"
    press(view, device)
    link.Attached = 0
    assert view.GetInteractor().GetInteractorStyle() is style, "the view has not got its own style back"
    assert not hands(view), "something is left in the view"
    assert device.Armed == 0 and force(device) == 0.0, "a detached device has force"


def refuse_second(view, device, link):
    link.Attached = 1
    haptic = view.GetInteractor().GetInteractorStyle()
    other = make_link(view, device)
    other.Attached = 1
    assert other.Attached == 0 and link.Attached == 1
    assert view.GetInteractor().GetInteractorStyle() is haptic


def two_hands(view, device, link):
    """Each has a tip, a force and an order of its own in the one view, which polls both."""
    one = ["vtkHapticHeadUpDisplay", "vtkHapticRepresentation"]
    second = simple.HapticDevice(Touch=device.Touch)
    link.Attached = 1
    link.SecondDevice = device
    assert link.SecondDevice is None and hands(view) == one, "one tip in two hands"
    link.SecondDevice = second
    assert link.SecondDevice == second and hands(view) == one + ["vtkHapticRepresentation"], hands(view)
    press(view, device)
    wait_until(view, lambda: get(device, "TipPosition") == [-25, -70, 45], "the tip did not get there")
    wait_until(view, lambda: get(device, "ComputedForce") == get(device, "ComputedForce") != [0, 0, 0], "the proxy did not come to rest")
    held = get(device, "ComputedForce")
    assert second.Running == 0 and second.Armed == 0, "the other hand waits for its user"
    press(view, second, 25)
    wait_until(view, lambda: get(second, "TipPosition") == [25, -70, 45], "the second tip did not get there")
    assert get(device, "TipPosition") == [-25, -70, 45], "one hand has led both tips"
    assert abs(get(device, "ProxyPosition")[0] - get(second, "ProxyPosition")[0]) > 20, "one proxy in two hands"
    assert max(abs(a - b) for a, b in zip(get(device, "ComputedForce"), held)) < 0.01, "beside another hand it feels different"

    second.Armed = 0
    wait_until(view, lambda: force(second) == 0.0, "the second hand was not let go")
    assert force(device) > 0.5 and device.Armed == 1, "one let go, and the other one's force is gone"
    press(view, second, 25)
    simple.Delete(second)
    assert force(second) == 0.0 and link.SecondDevice is None and hands(view) == one, "a deleted device is in the view"
    assert link.Attached == 1 and device.Armed == 1 and force(device) > 0.5, "one deleted, and the other one's force is gone"

    third = simple.HapticDevice(Touch=device.Touch)
    link.SecondDevice = third
    press(view, third, 25)
    link.Attached = 0
    assert third.Armed == 0 and force(third) == 0.0 and not hands(view), "detached, and a hand or its force is left"


def change_style(view, device, link):
    """If ParaView gives the view another style meanwhile, that style stays."""
    style = view.GetInteractor().GetInteractorStyle()
    link.Attached = 1
    haptic = view.GetInteractor().GetInteractorStyle()
    press(view, device)
    view.InteractionMode = "2D"
    assert view.GetInteractor().GetInteractorStyle() not in (style, haptic)
    assert link.Attached == 0 and not hands(view)
    assert device.Armed == 0 and force(device) == 0.0, "force, and no hand in the view"
    view.InteractionMode = "3D"
    assert view.GetInteractor().GetInteractorStyle() is style


def close_view(view, device, link):
    link.Attached = 1
    press(view, device)
    simple.Delete(view)
    assert link.Attached == 0 and device.Armed == 0 and force(device) == 0.0, "the view is closed, and force is left"
    assert link.View is None, "a closed view is kept"


def delete_device(view, device, link):
    style = view.GetInteractor().GetInteractorStyle()
    link.Attached = 1
    press(view, device)
    simple.Delete(device)
    assert link.Attached == 0 and force(device) == 0.0, "the device is deleted, and force is left"
    assert view.GetInteractor().GetInteractorStyle() is style and not hands(view)


def slices(view, device, link):
    """The slices of an Orthographic Slice View follow the tip inside the volume, and stay when the tip rests."""
    sliced = simple.CreateView("OrthographicSliceView", ViewSize=[200, 200])
    simple.Show(simple.FindSource("Head"), sliced)
    simple.Render(sliced)
    link.Attached = 1
    press(view, device)
    wait_until(view, lambda: list(sliced.SlicePosition) == [-25, -70, 45], "the slices did not follow the tip")
    bounds = simple.FindSource("Head").GetDataInformation().GetBounds()
    device.Armed = 0
    device.VirtualTip = [-25, bounds[2] - 20, 45]
    wait_until(view, lambda: list(sliced.SlicePosition) == [-25, bounds[2], 45], "the slices left the volume")
    sliced.SlicePosition = [0, 0, 0]
    for _ in range(50):
        view.GetInteractor().ProcessEvents()
        time.sleep(0.005)
    assert list(sliced.SlicePosition) == [0, 0, 0], "a tip at rest has moved the slices"
    link.SlicesFollowTip = 0
    lead_out(view, device)
    assert list(sliced.SlicePosition) == [0, 0, 0], "the slices follow although they should not"


def look_at(view, left, right, bottom, top):
    pixels = vtkUnsignedCharArray()
    view.GetRenderWindow().GetPixelData(left, bottom, right - 1, top - 1, 0, pixels, 0)
    return vtk_to_numpy(pixels).reshape(top - bottom, right - left, 3).astype(float)


def axes(view, device, link):
    """The plot does not cover ParaView's orientation axes, which a small renderer draws at the lower left."""
    window = view.GetRenderWindow()
    renderers = [window.GetRenderers().GetItemAsObject(i) for i in range(window.GetRenderers().GetNumberOfItems())]
    for width, height in ((300, 300), (400, 300), (700, 560)):
        view.ViewSize = [width, height]
        for visible in (1, 0):
            view.OrientationAxesVisibility = visible
            simple.Render(view)
            small = min(renderer.GetSize() for renderer in renderers)
            assert 30 < small[0] < 0.5 * width and 30 < small[1] < 0.5 * height, small
            box = (0, small[0], 0, small[1])
            corner = look_at(view, *box)
            below = look_at(view, 0, width, 0, height // 2)
            link.Attached = 1
            simple.Render(view)
            is_alone = (look_at(view, *box) == corner).all()
            assert is_alone == bool(visible), f"the axes are visible: {visible}, at {width} x {height}"
            assert (look_at(view, 0, width, 0, height // 2) != below).any(), "there is no plot"
            link.Attached = 0


def volume(view, device, link):
    """With software OpenGL, frames during motion have no speckles; afterwards the view has its own ray caster again."""
    window = view.GetRenderWindow()
    shown = simple.GetRepresentation(simple.FindSource("Head"), view)
    simple.ColorBy(shown, ("POINTS", "HU"))
    simple.GetColorTransferFunction("HU").ApplyPreset("Grayscale", True)
    opacity = simple.GetOpacityTransferFunction("HU")
    opacity.Points = [-1000, 0, 0.5, 0, -600, 0, 0.5, 0, -200, 0.35, 0.5, 0, 2000, 0.9, 0.5, 0]
    shown.SetRepresentationType("Volume")
    view.OrientationAxesVisibility = 0  # the plot is below the temple
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-315, -400, 60], [0, 0, 0], [0, 0, 1]

    def look():
        pixels = vtkUnsignedCharArray()
        # region at the temple, without the hand and the texts
        window.GetPixelData(110, 150, 169, 199, 0, pixels, 0)
        return vtk_to_numpy(pixels).reshape(50, 60, 3)[:, :, 0].astype(float)

    def speckles(picture):
        """Returns the mean difference between pixels and the mean of their neighbours."""
        mean = (picture[:-2, 1:-1] + picture[2:, 1:-1] + picture[1:-1, :-2] + picture[1:-1, 2:]) / 4
        return abs(picture[1:-1, 1:-1] - mean).mean()

    simple.Render(view)
    before = look()
    if "llvmpipe" not in window.ReportCapabilities():
        print("Not software OpenGL: nothing to see", flush=True)
        return
    link.Attached = 1
    press(view, device)
    quick = []

    def note(*_):
        if window.GetDesiredUpdateRate() > 1:
            quick.append(speckles(look()))

    tag = window.AddObserver("EndEvent", note)
    for x in range(20):
        device.VirtualTip = [-25 + x, -72, 45]
        count = len(quick)
        wait_until(view, lambda: len(quick) > count, "no frame in motion was drawn")
    window.RemoveObserver(tag)
    assert max(quick) < 2.0 * speckles(before) + 0.5, f"speckles: {quick} in motion, {speckles(before)} at rest"
    assert shown.VolumeRenderingMode == "Smart", "a property of the user's was changed"
    link.Attached = 0
    simple.Render(view)
    assert (look() == before).all(), "the view has not got its own ray caster back"


def notes(view, device, link):
    """What was assumed about a file is told when the device is attached, and after another file was opened."""

    def notice():
        props = view.SMProxy.GetClientSideObject().GetNonCompositedRenderer().GetViewProps()
        said = [str(prop) for prop in props if prop.GetClassName() == "vtkHapticHeadUpDisplay"]
        return re.search(r"^ *Notice: (.*(?:\n\S.*)*)", said[0], re.MULTILINE)[1]

    def write(name, *lines):
        path = Path(folder, name + ".mha")
        header = ["ObjectType = Image", "NDims = 3", "DimSize = 16 16 16", "ElementType = MET_UCHAR", *lines]
        path.write_bytes("\n".join([*header, "ElementDataFile = LOCAL\n"]).encode() + bytes(range(256)) * 16)
        return str(path)

    with tempfile.TemporaryDirectory() as folder:
        files = [write("plain"), write("told", "ElementSpacing = 2 2 2"),
                 write("scaled", "ElementSpacing = 2 2 2", "DistanceUnits = um")]
        reader = simple.HapticVolume(FileName=files[0])
        device.Touch.Input = reader
        simple.Show(reader, view, "UniformGridRepresentation")
        simple.Render(view)
        link.Attached = 1
        assert "1 mm are assumed" in notice(), notice()
        reader.FileName = files[1]
        simple.Render(view)
        assert "1 mm" not in notice(), notice()
        reader.FileName = files[2]
        simple.Render(view)
        assert "um" in notice(), notice()


def end_session(view, device, link):
    link.Attached = 1
    press(view, device)
    simple.Disconnect()
    assert "Attach again with another one" in str(link.SMProxy)
    simple.Connect()
    run(attach_again)


def attach_again(view, device, link):
    link.Attached = 1
    assert link.Attached == 1 and hands(view) == ["vtkHapticHeadUpDisplay", "vtkHapticRepresentation"]
    device.VirtualTip = [-25, -110, 45]
    device.Running = 1
    end = time.monotonic() + PATIENCE
    while force(device) < 0.5:  # without the view's events: see above
        assert time.monotonic() < end, get(device, "StatusText")
        device.UpdatePipeline()
        ready = "100 % of the force" in "".join(get(device, "StatusText"))
        device.Armed = 1
        device.VirtualTip = [-25, -70 if ready else -110, 45]
        time.sleep(0.005)


run(globals()[sys.argv[3]])
