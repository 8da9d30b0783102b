# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Keys in a render view with a device, without Qt: pvpython TestKeys.py PLUGIN VOLUME CASE."""

import os
import sys
import tempfile
import time

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from view import force, lead_in, lead_out, press, run, wait_until


def hit(view, key, event="KeyPressEvent"):
    view.GetInteractor().SetKeySym(key)
    view.GetInteractor().InvokeEvent(event)


def clutch(view, device, link):
    """A hand that holds still before the head: no force comes back with the clutch when Armed went to 0 meanwhile."""
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
    """Armed goes to 0 with whatever takes the force away, so that the next order to arm is one."""
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


def method(view, device, link):
    """The panel and a saved state say what is felt."""
    link.Attached = 1
    press(view, device)
    touch = device.Touch
    for wanted in (("Proxy", "Paper"), ("Force field", "Paper"), ("Surface proxy", "Paper")):
        hit(view, "m")
        now = (touch.GetPropertyValue("Method"), touch.GetPropertyValue("Solver"))
        assert now == wanted, f"the panel says {now}, and felt is {wanted}"


run(globals()[sys.argv[3]])
