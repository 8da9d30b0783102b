# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests keys in a render view with a device, without Qt: pvpython TestKeys.py PLUGIN VOLUME CASE."""

import os
import sys
import tempfile
import time

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from view import force, get, lead_in, lead_out, press, run, wait_until


def hit(view, key, event="KeyPressEvent"):
    view.GetInteractor().SetKeySym(key)
    view.GetInteractor().InvokeEvent(event)


def clutch(view, device, link):
    """The hand holds still before the head. If Armed became 0 during the clutch, the end of the clutch restores no
    force."""
    def is_armed():
        device.UpdatePipeline()
        return device.GetPropertyValue("StatusText").startswith(("Active", "Armed"))

    def stay_disarmed(what):
        end = time.monotonic() + 0.3
        while time.monotonic() < end:
            view.GetInteractor().ProcessEvents()
            assert not is_armed(), what

    points = vtkPoints()
    for _ in range(100000):
        points.InsertNextPoint(-25, -150, 45)
    path = vtkPolyData()
    path.SetPoints(points)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "still.vtp")
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(file)
        writer.SetInputData(path)
        writer.SetDataModeToBinary()
        writer.Write()
        device.Device = "replay:" + file
        device.Running = 1
        device.UpdatePipeline()
    link.Attached = 1
    wait_until(view, lambda: device.GetPropertyValue("TickRate") > 0, "the servo did not tick")
    for stop in ("key", "Armed", "Escape"):
        device.Armed = 1
        wait_until(view, is_armed, "the device was not armed")
        hit(view, "k")
        wait_until(view, lambda: not is_armed(), "force was not taken off the hand")
        assert device.Armed == 1
        if stop == "Armed":
            device.Armed = 0
        else:
            hit(view, "a" if stop == "key" else stop)
        assert device.Armed == 0
        hit(view, "k", "KeyReleaseEvent")
        stay_disarmed(f"force came back with the clutch, after {stop}")
    device.Armed = 1
    wait_until(view, is_armed, "the device was not armed")
    hit(view, "k")
    hit(view, "k", "KeyReleaseEvent")
    wait_until(view, is_armed, "the clutch has not given force back")
    device.Armed = 0
    wait_until(view, lambda: not is_armed(), "Armed = 0 had no effect")


def disarm(view, device, link):
    """Whatever removes the force sets Armed to 0, so that setting Armed to 1 arms again."""
    link.Attached = 1
    press(view, device)
    view.GetInteractor().Disable()
    assert device.Armed == 0, "a view that takes no input has disarmed the device, and Armed is left"
    view.GetInteractor().Enable()
    wait_until(view, lambda: force(device) == 0.0, "the force was not taken away")
    hit(view, "a")
    assert device.Armed == 1, "the key took Armed for on"
    lead_out(view, device)
    lead_in(view, device)


def two_keys(view, device, link):
    """The key arms the hands that are not armed, and disarms both if both are; Escape lets both go."""
    second = simple.HapticDevice(Touch=device.Touch)
    link.Attached = 1
    link.SecondDevice = second
    press(view, device)
    press(view, second, 25)
    for key, before, after in (("a", (1, 1), (0, 0)), ("a", (1, 0), (1, 1)), ("a", (0, 1), (1, 1)), ("a", (0, 0), (1, 1)),
                               ("Escape", (1, 1), (0, 0))):
        device.Armed, second.Armed = before
        hit(view, key)
        assert (device.Armed, second.Armed) == after, (key, before, device.Armed, second.Armed)
    wait_until(view, lambda: force(device) == 0.0 and force(second) == 0.0, "a force is left")


def method(view, device, link):
    """The panel and a saved state show the method that is felt."""
    link.Attached = 1
    press(view, device)
    touch = device.Touch
    for wanted in (("Proxy", "Paper"), ("Force field", "Paper"), ("Surface proxy", "Paper")):
        hit(view, "m")
        now = (touch.GetPropertyValue("Method"), touch.GetPropertyValue("Solver"))
        assert now == wanted, f"the panel says {now}, and felt is {wanted}"


def removal(view, device, link):
    """The panel's buttons undo and redo strokes of a burr, exactly to the last bit of the remaining tissue."""
    touch = device.Touch
    touch.Tool, touch.BurrRadius, touch.BurrSpecificEnergy = "Burr", 8.0, "0.02"
    # The line is in the air in front of the face. Its trace contains the tissue's state after the live hand has touched
    # it.
    line = simple.Line(Point1=[-25, -140, 45], Point2=[-25, -139, 45], Resolution=1)
    touch.Path = line
    interactor = view.GetInteractor()

    def shares():
        line.Resolution = 3 - line.Resolution
        touch.UpdatePipeline()
        data = servermanager.Fetch(touch).GetFieldData()
        return {name: vtk_to_numpy(data.GetArray(name)).tobytes() for name in ("FinalBricks", "FinalShares")}

    def lead(to):
        device.VirtualTip = to
        wait_until(view, lambda: max(abs(a - b) for a, b in zip(get(device, "TipPosition"), to)) < 1e-9, "the tip did not get there")

    def drill(x):
        """Drills deeper with the left button pressed until tissue is removed, then leaves the tissue."""
        before = shares()
        lead([x, -110, 45])
        interactor.InvokeEvent("LeftButtonPressEvent")
        for y in range(-100, -60):
            lead([x, y, 45])
            if y > -85 and shares() != before:
                break
        interactor.InvokeEvent("LeftButtonReleaseEvent")
        lead([x, -110, 45])
        after = shares()
        assert after != before, "nothing was removed"
        return after

    def choose(command, wanted):
        touch.InvokeCommand(command)
        wait_until(view, lambda: shares() == wanted, command + " has not left what was there")

    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-25, -600, 45], [-25, -70, 45], [0, 0, 1]
    simple.Render(view)
    link.Attached = 1
    device.Running = 1
    device.UpdatePipeline()
    interactor.SetEventInformation(150, 150, 0, 0)
    hit(view, "t")
    assert device.Armed == 1, "the touch mode has not begun"
    wait_until(view, lambda: "100 % of the force" in "".join(get(device, "StatusText")), "the ramp was not over")
    whole = shares()
    first = drill(-25)
    second = drill(-20)
    for command, wanted in (("UndoRemoval", first), ("UndoRemoval", whole), ("RedoRemoval", first), ("RedoRemoval", second),
                            ("UndoRemoval", first), ("RestoreTissue", whole)):
        choose(command, wanted)


run(globals()[sys.argv[3]])
