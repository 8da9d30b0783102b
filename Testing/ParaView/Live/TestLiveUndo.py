# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The user's changes can be undone and redone while a live device follows them; the device's polls add no undo
entries."""
from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager, vtkSMUndoStack, vtkSMUndoStackBuilder

import live

live.load_plugin()
# As in the paraview program, each change of a property adds an undo entry unless it is excluded.
stack, builder = vtkSMUndoStack(), vtkSMUndoStackBuilder()
builder.SetUndoStack(stack)
vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(builder)
wavelet = simple.Wavelet()
touch = simple.VolumeHaptics(Input=wavelet, Preset="Custom")
device = simple.HapticDevice(Touch=touch)
live.press(device, [-9, 0, 0], [-4, 0, 0], armed=False)


def entries():
    return stack.GetNumberOfUndoSets(), stack.GetNumberOfRedoSets()


def change(name, act):
    builder.Begin(name)
    act()
    builder.EndAndPushToStack()


def poll(wanted):
    before = entries()
    change("poll", lambda: live.poll_for(device, 0.1))
    live.check(entries() == before, "polls leave the stack alone", before, entries())
    touch.UpdatePropertyInformation()
    live.check(touch.Preset == wanted, "the filter has " + wanted, touch.Preset)


def choose(preset):
    touch.Preset = preset
    touch.SMProxy.UpdateVTKObjects()


poll("Custom")
change("preset", lambda: choose("MRI"))
live.check(entries() == (1, 0), "a preset is one entry", entries())
poll("MRI")
change("another", lambda: choose("CT contrast"))
poll("CT contrast")
device.VirtualTip = [-3, 0, 0]
for act, wanted in ((stack.Undo, "MRI"), (stack.Undo, "Custom"), (stack.Redo, "MRI"), (stack.Redo, "CT contrast")):
    act()
    poll(wanted)
live.check(entries() == (2, 0), "nothing is lost", entries())
vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(None)
