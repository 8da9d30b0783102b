# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two devices share one filter: each has the force that it has alone, and arming, stopping and recording concern one
device only."""
import os

from paraview import simple

import live

live.load_plugin()
OUTSIDE, INSIDE = [-9.0, 0.0, 0.0], [-4.0, 0.0, 0.0]

touch = simple.VolumeHaptics(Input=simple.Wavelet())
first, second = simple.HapticDevice(Touch=touch), simple.HapticDevice(Touch=touch)
live.press(second, OUTSIDE, INSIDE)
live.check(live.poll(second, lambda: live.norm(second.Force) > 0.5), "one hand alone", second.StatusText)
alone = list(second.ComputedForce)
live.check(first.Running == 0 and first.Armed == 0, "the other one waits for its user")
live.press(first, [9.0, 0.0, 0.0], [4.0, 0.0, 0.0])
live.check(live.poll(first, lambda: live.norm(first.Force) > 0.5), "both hands", first.StatusText)
live.poll(second, lambda: live.norm(second.Force) > 0.5)
# Allow the proxy to come to rest during the first ticks of a press.
live.check(live.distance(second.ComputedForce, alone) < 1e-3, "the same force beside another hand", alone, list(second.ComputedForce))
live.check(live.distance(first.ProxyPosition, second.ProxyPosition) > 5.0, "two proxies")

# Each device must write its own recording.
for device, name in ((first, "first.vtp"), (second, "second.vtp")):
    device.RecordingFile = os.path.join(live.FOLDER, name)
    device.Recording = 1
    live.poll_for(device, 0.1)
for device in first, second:
    device.Recording = 0
    device.UpdatePipeline()
live.check(all(os.path.getsize(os.path.join(live.FOLDER, name)) > 0 for name in ("first.vtp", "second.vtp")), "two recordings")

first.Running = 0
first.UpdatePipeline()
live.check(live.poll(second, lambda: live.norm(second.Force) > 0.5), "one is stopped, and the other one goes on", second.StatusText)
touch.Method = "Force field"
live.check(live.poll(second, lambda: live.distance(second.ComputedForce, alone) > 1e-6), "and follows the filter")
