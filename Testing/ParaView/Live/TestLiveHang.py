# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A server hangs in mid-contact while the client waits for it: the servo removes the force, and killing the server ends
the wait."""
import os
import signal
import subprocess
import time

from paraview import simple

import live

LOG = os.path.join(live.FOLDER, "hang.csv")
HANG = 6.0  # s, far longer than the servo waits
server = live.Server()


def later(name):
    """Sends a signal to the server later, from outside: the client, with Python's threads, is blocked meanwhile."""
    subprocess.Popen(["sh", "-c", "sleep %g; kill -s %s %d" % (HANG, name, server.process.pid)])


with server:
    live.load_plugin(remote=True)
    touch = simple.VolumeHaptics(Input=simple.Wavelet())
    device = simple.HapticDevice(Touch=touch, RecordingFile=LOG)
    live.press(device, [-9, 0, 0], [-4, 0, 0])
    device.Recording = 1
    live.check(live.poll(device, lambda: live.norm(device.Force) > 0.5), "a hand is held", device.StatusText)
    began = time.monotonic()
    later("CONT")
    os.killpg(server.process.pid, signal.SIGSTOP)
    # The client sends a request, and waits for the reply until the stopped server continues.
    simple.Wavelet(WholeExtent=[-3, 3, -3, 3, -3, 3]).UpdatePipeline()
    waited = time.monotonic() - began
    device.UpdatePipeline()
    live.check(waited > HANG - 0.5, "the client waited", waited)
    live.check(live.norm(device.Force) == 0.0 and device.Armed == 0, "the force was switched off", device.StatusText)
    live.check("Attention Time" in device.StatusText, "what happened, and the cure", device.StatusText)
    device.Recording = 0
    device.Armed = 1
    device.VirtualTip = [-9, 0, 0]
    live.check(live.poll(device, lambda: live.distance(device.TipPosition, [-9, 0, 0]) < 1e-9), "the tip is led out")
    live.wait_ramp(device)
    device.VirtualTip = [-4, 0, 0]
    live.check(live.poll(device, lambda: live.norm(device.Force) > 0.5), "armed again, it goes on", device.StatusText)
    later("KILL")
    os.killpg(server.process.pid, signal.SIGSTOP)
    try:
        live.poll(device, lambda: device.Running == 0)
    except RuntimeError as error:
        print(error)
    live.check(live.poll(device, lambda: device.Running == 0), "a server that never comes back", device.StatusText)
    live.check(live.norm(device.Force) == 0.0 and device.Armed == 0, "without force")

log = live.read_log(LOG)
commands = [live.norm([log["Command %s (N)" % a][i] for a in "xyz"]) for i in range(len(log["Time (s)"]))]
steps = [abs(a - b) for a, b in zip(commands, commands[1:])]
first = next(i for i, c in enumerate(commands) if i and c == 0.0 and max(commands[:i]) > 0.5)
silent = log["Time (s)"][-1] - log["Time (s)"][first]
print("held %.3f N, largest step %.3f N, without force for %.2f s of the hang" % (max(commands), max(steps), silent))
live.check(max(steps) <= 0.5 + 1e-9, "force fades within the slew limit", max(steps))
live.check(any(0 < c < 1 for c in log["Residency"]), "it fades rather than ends")
live.check(max(commands[first:]) == 0.0, "it does not come back by itself")
live.check(silent > 0.5, "force was gone while the client still waited", silent)
