# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The data are in this process: changes anywhere reach the servo, errors are reported once, and a loaded state is not
armed."""
import os
import xml.etree.ElementTree as ElementTree

from paraview import servermanager, simple, smstate
from vtkmodules.vtkCommonCore import VTK_SHORT
from vtkmodules.vtkCommonDataModel import vtkImageData

import live

live.load_plugin()
OUTSIDE, INSIDE = [-9.0, 0.0, 0.0], [-4.0, 0.0, 0.0]


def force_follows(what, change, holds):
    before = list(device.ComputedForce)
    change()
    live.check(live.poll(device, lambda: holds(before)), what, before, list(device.ComputedForce), device.StatusText)


def felt():
    return live.norm(device.ComputedForce)


wavelet = simple.Wavelet()
touch = simple.VolumeHaptics(Input=wavelet)
device = simple.HapticDevice(Touch=touch)
device.UpdatePipeline()
live.check(device.Running == 0 and device.Armed == 0, "neither runs by itself")
live.press(device, OUTSIDE, INSIDE)
live.check(live.poll(device, lambda: live.norm(device.Force) > 0.5), "force leaves", device.StatusText)
live.check(device.Contact > 0 and device.TickRate > 0 and device.Latency == 0.0 and device.Residency == 1.0, "information")
live.check(servermanager.Fetch(device).GetNumberOfPoints() == 12, "the state is geometry")
bounds = servermanager.Fetch(device).GetBounds()
live.check(bounds[0] <= INSIDE[0] <= bounds[1], "where the hand is", bounds)

device.MaximumForce = 0.3
live.check(live.poll(device, lambda: live.norm(device.Force) < 0.31), "the largest force is limited", list(device.Force))
device.MaximumForce = 0
live.check(live.poll(device, lambda: live.norm(device.Force) > 0.5), "0 is the device's own limit again", list(device.Force))

force_follows("a setting", lambda: setattr(touch, "Method", "Force field"), lambda f: live.distance(f, device.ComputedForce) > 1e-6)
touch.Method = "Proxy"
live.press(device, OUTSIDE, INSIDE)
force_follows("a function of the material", lambda: setattr(touch.Stiffness, "Points", [0, 0.1, 0.5, 0, 1000, 0.1, 0.5, 0]),
              lambda f: live.distance(f, device.ComputedForce) > 0.1)
touch.Stiffness.Points = [0, 0.5, 0.5, 0, 1000, 0.5, 0.5, 0]
live.press(device, OUTSIDE, INSIDE)
force_follows("the volume", lambda: setattr(wavelet, "Maximum", -1000.0), lambda f: live.distance(f, device.ComputedForce) > 1e-3)
wavelet.Maximum = 255.0
live.press(device, OUTSIDE, INSIDE)
image = vtkImageData()
image.SetDimensions(2, 2, 2)
image.SetSpacing(100, 100, 100)
image.SetOrigin(-50, -50, -50)
image.AllocateScalars(VTK_SHORT, 1)
image.GetPointData().GetScalars().Fill(5)
labels = simple.PVTrivialProducer()
labels.GetClientSideObject().SetOutput(image)
touch.Labels = labels
force_follows("the material of a label", lambda: setattr(touch, "LabelMaterials", [5, 100, 0, 0, 9]),
              lambda f: live.distance(f, device.ComputedForce) > 0.1)
touch.LabelMaterials = []
touch.Labels = None
live.check(touch.Preset == "Custom", "the filter is as it was")

# Disarming and stopping work without the timer.
device.Armed = 0
live.check(live.norm(device.Force) == 0.0 or live.poll(device, lambda: live.norm(device.Force) == 0.0), "disarmed")
device.Running = 0
live.check("Running" not in device.StatusText or live.poll(device, lambda: device.TickRate == 0), "stopped")

# A state that is saved while the device is armed and recording must restore neither, but only harmless settings.
live.press(device, OUTSIDE, INSIDE)
device.RecordingFile = os.path.join(live.FOLDER, "state.vtp")
device.Recording = 1
state, script = os.path.join(live.FOLDER, "live.pvsm"), smstate.get_state()
simple.SaveState(state)
live.check("HapticDevice(" in script and "VirtualTip" in script, "a script makes the device", script)
orders = ("Armed", "Running", "Recording")
live.check(not any(" = 1" in line and "." + order + " " in line for line in script.splitlines() for order in orders),
           "no order in a script")
values = {p.get("name"): p.findall("Element") for p in ElementTree.parse(state).iter("Property")}
live.check(values["VirtualTip"] and not any(values.get(order) for order in orders), "no order in a state")
# A state must not arm the device even if its file sets Armed to 1.
text = open(state).read()
tip = text.index('<Property name="VirtualTip"')
forged = "".join('<Property name="%s" number_of_elements="1"><Element index="0" value="1"/></Property>' % order
                 for order in orders)
with open(state, "w") as file:
    file.write(text[:tip] + forged + text[tip:])
simple.ResetSession()
simple.LoadState(state)
again = simple.FindSource("HapticDevice1")
live.check(again is not None and again.Touch is not None, "the state has the device and what it touches")
again.UpdatePipeline()
live.check(again.Running == 0 and again.Armed == 0 and again.Recording == 0, "and it waits for its user")
device = again
live.press(device, OUTSIDE, INSIDE)
live.check(live.poll(device, lambda: felt() > 0.5), "and is felt as before")

# Errors must be reported once, with a remedy, and must not stop the hand.
simple.SetActiveSource(None)
device.RecordingFile = "nowhere.xyz"
device.Recording = 1
live.check(device.Recording == 0, "a recording that can't be is off")
device.Device = "replay:missing.vtp"
device.UpdatePipeline()
live.check(device.Running == 0 and live.norm(device.Force) == 0.0, "another device stops this one")
device.Running = 1
device.UpdatePipeline()
live.check(device.Running == 0 and "missing.vtp" in device.StatusText, "a device that is not there", device.StatusText)
