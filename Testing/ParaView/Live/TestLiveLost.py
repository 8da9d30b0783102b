# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A server is killed in mid-contact: the force fades, the user is told, and the client goes on and connects again."""
import os

from paraview import servermanager, simple
from vtkmodules.util.misc import calldata_type

import live

LOG = os.path.join(live.FOLDER, "lost.csv")
server = live.Server()
with server:
    live.load_plugin(remote=True)
    touch = simple.VolumeHaptics(Input=simple.Wavelet())
    device = simple.HapticDevice(Touch=touch, RecordingFile=LOG)
    live.press(device, [-9, 0, 0], [-4, 0, 0])
    device.Recording = 1
    live.check(live.poll(device, lambda: live.norm(device.Force) > 0.5), "a hand is held", device.StatusText)
    server.kill()
    # Polling only runs the timer, so no error reaches the script.
    live.check(live.poll(device, lambda: device.Running == 0), "the device stops", device.StatusText)
    live.check(device.Armed == 0 and live.norm(device.Force) == 0.0, "without force")
    live.check("server" in device.StatusText and "Connect" in device.StatusText, "what happened, and the cure", device.StatusText)
    print(device.StatusText)
    device.UpdatePipeline()
    device.VirtualTip = [0, 0, 0]
    device.Running = 1
    device.UpdatePipeline()
    live.check(live.norm(device.Force) == 0.0, "it does not start without its server")

log = live.read_log(LOG)
commands = [[log["Command %s (N)" % a][i] for a in "xyz"] for i in range(len(log["Time (s)"]))]
steps = [live.distance(a, b) for a, b in zip(commands, commands[1:])]
held = max(range(len(commands)), key=lambda i: live.norm(commands[i]))
print("held %.3f N, largest step %.3f N, ticks from full force to none %d"
      % (live.norm(commands[held]), max(steps), sum(1 for c in log["Residency"] if 0 < c < 1)))
live.check(max(steps) <= 0.5 + 1e-9, "force fades within the slew limit", max(steps))
live.check(live.norm(commands[-1]) == 0.0, "the last command is zero", commands[-3:])
live.check(any(0 < c < 1 for c in log["Residency"]), "it fades rather than ends")

simple.Disconnect()
with live.Server():
    live.load_plugin(remote=True)
    touch = simple.VolumeHaptics(Input=simple.Wavelet())
    device = simple.HapticDevice(Touch=touch)
    live.press(device, [-9, 0, 0], [-4, 0, 0])
    live.check(live.poll(device, lambda: live.norm(device.Force) > 0.5), "a new server is touched", device.StatusText)
    # A missing folder and a full disk must be reported.
    full, errors = os.path.join(live.FOLDER, "full.csv"), []
    if not os.path.islink(full):
        os.symlink("/dev/full", full)

    @calldata_type("string0")
    def note(_, __, message):
        errors.append(message)

    device.SMProxy.AddObserver("ErrorEvent", note)
    device.RecordingFile = os.path.join(live.FOLDER, "nowhere", "felt.csv")
    device.Recording = 1
    live.check(len(errors) == 1 and "Choose a RecordingFile in a folder that you may write to" in errors[0], "there is no folder", errors)
    errors.clear()
    device.Recording = 0
    device.RecordingFile = os.path.join(live.FOLDER, "felt.csv")
    device.Recording = 1
    live.poll_for(device, 0.1)
    device.Recording = 0
    log = live.read_log(device.RecordingFile)
    live.check(not errors and max(map(abs, log["Force x (N)"])) > 0.5, "another folder has what is felt", errors)
    device.RecordingFile = full
    device.Recording = 1
    live.poll_for(device, 0.1)
    live.check(not errors, "a recording begins")
    device.Recording = 0
    live.check(errors, "and an error says that it is not complete")
    device.Running = 0
    simple.Disconnect()
# The client writes the recording, so open it on the client's computer.
simple.Connect()
table = simple.CSVReader(FileName=[os.path.join(live.FOLDER, "felt.csv")])
table.UpdatePipeline()
force = servermanager.Fetch(table).GetRowData().GetArray("Force x (N)")
live.check(max(map(abs, force.GetRange())) > 0.5, "the recording of a server's volume is opened")
