# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever is deleted while a hand is held, the device's own recording ends with a force command of zero."""
import os
import sys

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import live

HOW = sys.argv[3]
FILE = os.path.join(live.FOLDER, HOW + ".vtp")
if HOW == "AfterExit":
    FILE = os.path.join(sys.argv[4], "Exit.vtp")
elif os.path.exists(FILE):
    os.remove(FILE)


def commands_in_file():
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(FILE)
    reader.Update()
    data = reader.GetOutput().GetPointData()
    return vtk_to_numpy(data.GetArray("Command"))


def hold_and_delete():
    live.load_plugin()
    wavelet = simple.Wavelet()
    touch = simple.VolumeHaptics(Input=wavelet)
    device = simple.HapticDevice(Touch=touch, RecordingFile=FILE)
    view = None
    if HOW == "View":
        view = simple.CreateRenderView()
        shown = simple.Show(wavelet, view, "UniformGridRepresentation")
        shown.SetRepresentationType("Volume")
        simple.ColorBy(shown, ("POINTS", "RTData"))
        simple.Render(view)
    device.VirtualTip = [-9, 0, 0]
    device.Running = 1
    live.check(live.poll(device, lambda: device.TickRate > 0), "the servo ticks", device.StatusText)
    device.Recording = 1
    device.Armed = 1
    live.wait_ramp(device)
    device.VirtualTip = [-4, 0, 0]
    live.check(live.poll(device, lambda: live.norm(device.Force) > 0.5), "a hand is held", device.StatusText)

    if HOW == "Device":
        simple.Delete(device)
    elif HOW == "DeviceLastReference":
        simple.Delete(device)
        device = None
    elif HOW == "Touch":
        simple.Delete(touch)
    elif HOW == "Volume":
        simple.Delete(wavelet)
    elif HOW == "View":
        simple.Delete(view)
    elif HOW == "All":
        for proxy in (wavelet, device, touch):
            simple.Delete(proxy)
        del wavelet, touch, device, proxy
        device = None
    elif HOW == "Session":
        simple.ResetSession()
    elif HOW == "Disconnect":
        simple.Disconnect()
    elif HOW == "Exit":
        sys.exit(0)
    return device


device = hold_and_delete() if HOW != "AfterExit" else None
live.check(os.path.exists(FILE), "the recording was written")
commands = commands_in_file()
live.check((commands**2).sum(axis=1).max() > 0.5**2, "it has the force")
live.check((commands[-1] == 0.0).all(), "the last command is zero", commands[-3:])
if HOW in ("Touch", "Volume", "View"):
    device.UpdatePipeline()
    live.check(device.Armed == 0 and device.Running == 0 and "deleted" in device.StatusText, "and says why", device.StatusText)
