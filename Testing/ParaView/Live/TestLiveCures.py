# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures that the plugin's errors name: after the cure, the Wavelet source is felt, along a path or with a
device."""
import os

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

import live

HELD = 0.3  # N


def report_of(action):
    """Returns the text of VTK's output window during an action."""
    log, console = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(log)
    action()
    vtkOutputWindow.SetInstance(console)
    return log.GetOutput()


def felt():
    touch.UpdatePipeline()
    trace = servermanager.Fetch(touch)
    force = trace.GetPointData().GetArray("NormalForce")
    return vtk_to_numpy(force).max() if force else 0.0


def told(word, **settings):
    def change():
        for name, value in settings.items():
            if name in ("Tool", "ModePreset"):  # ParaView's menus refuse other names
                touch.SMProxy.GetProperty(name).SetElement(0, value)
                touch.SMProxy.UpdateVTKObjects()
            else:
                setattr(touch, name, value)
        touch.UpdatePipeline()
    report = report_of(change)
    live.check(word in report, word, report)


def cured(what, **settings):
    for name, value in settings.items():
        setattr(touch, name, value)
    live.check(felt() > HELD, "felt: " + what, felt())


live.load_plugin()
wavelet = simple.Wavelet()
wavelet.UpdatePipeline()
path = simple.Line(Point1=[0.0, 0.0, 9.0], Point2=[0.0, 0.0, 0.0], Resolution=300)
touch = simple.VolumeHaptics(Input=wavelet, Path=path, Scalars=["POINTS", "RTData"], Preset="Custom")
live.check(felt() > HELD, "felt at first", felt())

# Test the tables of modes and tools.
touch.Method = "Primitives"
told("has no kind of mode. Give one of", Modes=["", "", "1", ""])
told("Give one of", Modes=["Followw", "", "1", ""])
cured("a kind", Modes=["Surface", "", "2", ""])
told("Leave it empty", Modes=["Surface", "", "2", "1"])
told('Give one, or pairs such as "0 0, 0.5 2"', Modes=["Surface", "", "2 N", ""])
for strength in ("2", "0 2, 300 2"):
    cured("a strength", Modes=["Surface", "", strength, ""])
touch.Modes = []
touch.Method = "Proxy"
told("There is no tool", Tool="Spoon")
cured("a point", Tool="None")
told('Give a number, or pairs of a scalar and a number, such as "-100 0, 300 50"', Tool="Needle", NeedleShaftFriction="hard")
for friction in ("30", "-100 0, 300 50"):
    live.check(not report_of(lambda value=friction: (setattr(touch, "NeedleShaftFriction", value), touch.UpdatePipeline())),
               "a friction")
cured("a point again", Tool="None")

# Test files with samples.
samples = os.path.join(live.FOLDER, "ramp.raw")
with open(samples, "wb") as file:
    file.write(b"".join(bytes([4 * z]) * 400 for z in range(20)))
with open(os.path.join(live.FOLDER, "ramp.mhd"), "w", encoding="utf-8") as file:
    file.write("NDims = 3\nDimSize = 20 20 20\nElementType = MET_UCHAR\nElementDataFile = ramp.raw\n")
made = []
report = report_of(lambda: made.append(simple.HapticLargeFile()))
live.check("No file is chosen. Set FileName" in report, "without a file", report)
large, = made
large.FileName = os.path.join(live.FOLDER, "ramp.mhd")
whole = simple.VolumeHaptics(Input=large, Path=simple.Line(Point1=[9, 9, 12], Point2=[9, 9, 16], Resolution=300), Preset="Custom")
report = report_of(whole.UpdatePipeline)
force = vtk_to_numpy(servermanager.Fetch(whole).GetPointData().GetArray("NormalForce")).max()
live.check(not report and force > HELD, "a file is felt", force, report)

# A device.
device = simple.HapticDevice(Touch=wavelet)
device.Running = 1
live.check(live.poll(device, lambda: "Touch does not name a Volume Haptics filter" in device.StatusText),
           "no filter", device.StatusText)


def hold():
    live.press(device, [0.0, 0.0, 9.0], [0.0, 0.0, 4.0])
    live.check(live.poll(device, lambda: live.norm(device.Force) > HELD), "a hand is held", device.StatusText)


device.Running = 0
device.Touch = touch
hold()
device.Touch = None
live.check(live.poll(device, lambda: "there is nothing left to touch: set Touch" in device.StatusText), "nothing to touch",
           device.StatusText)
device.Touch = touch
hold()
other = simple.VolumeHaptics(Input=wavelet, Scalars=["POINTS", "RTData"])
device.Running = 0
device.Touch = other
hold()
simple.Delete(other)
del other
live.check(live.poll(device, lambda: "was deleted. Set Touch, and Running, again" in device.StatusText), "it was deleted",
           device.StatusText)
device.Touch = touch
hold()

# Views.
view, device.Running = simple.CreateRenderView(), 0
link, second = servermanager.misc.HapticView(), servermanager.misc.HapticView()


def attach(one):
    def change():
        one.Attached = 1
        one.UpdateVTKObjects()
    return report_of(change)


report = attach(link)
live.check("Set View to a render view, such as GetActiveView(), and Device to a Haptic Device" in report, "no view", report)
link = servermanager.misc.HapticView(View=view, Device=device)
live.check(not attach(link), "attached")
other = simple.HapticDevice(Touch=touch)
second = servermanager.misc.HapticView(View=view, Device=other)
report = attach(second)
live.check("Another device is attached to this view. Detach that one first" in report, "attached twice", report)
link.Attached = 0
link.UpdateVTKObjects()
second = servermanager.misc.HapticView(View=view, Device=other)
live.check(not attach(second), "attached instead")
second.Attached = 0
second.UpdateVTKObjects()


def ends(word, end):
    """Checks that `end` ends the attachment of a device to a view; `word` is a part of the dock's text."""
    made = servermanager.misc.HapticView(View=view, Device=other)
    live.check(not attach(made), "attached for: " + word)
    end()
    made.UpdatePropertyInformation()
    live.check(made.GetProperty("Attached").GetData() == 0, word)


ends("ParaView gave the view another way of interaction. Attach again when it is done",
     lambda: setattr(view, "InteractionMode", "2D"))
view.InteractionMode = "3D"
ends("The haptic device was deleted. Attach again with another one", lambda: simple.Delete(other))
other = simple.HapticDevice(Touch=touch)
ends("The view was closed. Attach the device to another one", lambda: simple.Delete(view))
view = simple.CreateRenderView()
live.check(not attach(servermanager.misc.HapticView(View=view, Device=other)), "attached to another view")
