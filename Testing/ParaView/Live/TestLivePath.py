# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""On a server of two ranks, a filter that has felt a path is also felt live: all of the volume is available."""
from paraview import simple

import live

with live.Server(2):
    live.load_plugin(remote=True)
    wavelet = simple.Wavelet()
    felt = []
    for line in (None, simple.Line(Point1=[-9, 0, 0], Point2=[-4, 0, 0], Resolution=500)):
        touch = simple.VolumeHaptics(Input=wavelet)
        if line:
            touch.Path = line
        touch.UpdatePipeline()  # an update with a path requests nothing from the second rank
        device = simple.HapticDevice(Touch=touch)
        live.press(device, [-9, 0, 0], [-4, 0, 0], armed=False)
        live.poll_for(device, 0.2)
        felt.append(live.norm(device.ComputedForce))
        live.check("do not hold" not in device.StatusText, "no part is missing", device.StatusText)
        device.Running = 0
        device.UpdatePipeline()
    live.check(felt[0] > 0.5, "something was felt", felt)
    live.check(abs(felt[1] - felt[0]) < 0.01, "and the same with a path", felt)
    simple.Disconnect()
