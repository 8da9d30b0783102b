# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Round trips of 0, 20 and 100 ms: whatever the hand does, force grows without a step; a slow hand always has its
data."""
import os
import subprocess
import sys
import time

from paraview import simple

import live

ROUND_TRIP = float(sys.argv[3])  # s
SLEW = 0.5  # N a tick
relays = []


def relay(port):
    command = ["/usr/bin/python3", os.path.join(os.path.dirname(os.path.abspath(__file__)), "relay.py")]
    process = subprocess.Popen(command + [str(port), str(0.5 * ROUND_TRIP)], stdout=subprocess.PIPE, text=True)
    relays.append(process)
    return int(process.stdout.readline())


def lead(name, speed, longest):
    """Moves the tip across the volume at a speed (world units per second), in steps no longer than `longest`."""
    device.RecordingFile = os.path.join(live.FOLDER, name + ".csv")
    device.VirtualTip = [-50, 3, 2]
    live.check(live.poll(device, lambda: live.distance(device.TipPosition, [-50, 3, 2]) < 1e-9
                         and device.Residency == 1.0), "at the start", device.StatusText)
    device.Recording = 1
    device.UpdatePipeline()
    gone, last = 0.0, time.time()
    while gone < 100.0:
        now = time.time()
        gone += min(longest, speed * (now - last))
        last = now
        device.VirtualTip = [-50 + gone, 3, 2]
        device.UpdatePipeline()
        time.sleep(0.005)
    device.Recording = 0
    log = live.read_log(device.RecordingFile)
    commands = list(zip(*(log["Command %s (N)" % a] for a in "xyz")))
    step = max(live.growth(a, b) for a, b in zip(commands, commands[1:]))
    absent = sum(1 for r in log["Residency"] if r < 1.0) / len(commands)
    print("round trip %3.0f ms, %3.0f mm/s: %5d ticks, latency %3.0f ms, largest force %.3f N, largest growth %.3f N, "
          "without data %.1f %%" % (1e3 * ROUND_TRIP, speed, len(commands), 1e3 * device.Latency,
                                    max(map(live.norm, commands)), step, 100 * absent), flush=True)
    live.check(device.Armed == 1, "the hand is still held", device.StatusText)
    live.check(max(map(live.norm, commands)) > 0.2, "something is felt")
    live.check(step <= SLEW + 1e-9, "no growth beyond the slew limit", step)
    return absent


try:
    with live.Server(relay=relay):
        live.load_plugin(remote=True)
        # The image has 128^3 samples; a region has 44^3 at most.
        wavelet = simple.Wavelet(WholeExtent=[-64, 63, -64, 63, -64, 63])
        touch = simple.VolumeHaptics(Input=wavelet)
        device = simple.HapticDevice(Touch=touch, MaximumRegionVoxels=44**3)
        live.press(device, [-52, 3, 2], [-50, 3, 2])
        # Limit the length of a step, so that a stall of the computer does not make the slow hand jump.
        absent = lead("slow", 20.0, 1.0 if ROUND_TRIP == 0 else 100.0)
        live.check(ROUND_TRIP > 0 or absent == 0.0, "a slow hand always has its data", absent)
        lead("fast", 200.0, 100.0)
        device.Running = 0
        simple.Disconnect()
finally:
    for process in relays:
        process.kill()
