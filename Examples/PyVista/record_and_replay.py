# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Records a live servo, and computes its forces again from the recording. They are the same to the bit."""
import tempfile
import time

import gallery
import numpy as np
import pyvista as pv
from volumehaptics import vtkHapticDevice, vtkVolumeHapticsFilter
from volumehaptics.pyvista import touch

head, picture = gallery.options(__doc__)
turn = np.linspace(0.2, 1.5, 60)
depth = 3.0 - 6.0 * (2 * (turn - 0.85) / 1.3) ** 4
tip = gallery.over_skin(head, np.column_stack([np.sin(turn), -np.cos(turn), 0.5 + 0 * turn]), depth)

felt, device = vtkVolumeHapticsFilter(), vtkHapticDevice()
felt.SetInputData(head)
felt.GetProperty().ApplyPreset("CT contrast")
device.SetVolumeHaptics(felt)
device.Open("virtual")
device.GetVirtualHand().SetPosition(tip.points[0])
device.Start()
device.Arm()
with tempfile.TemporaryDirectory() as folder:
    device.GetRecorder().Start(f"{folder}/stroke.vtp")
    start = time.monotonic()
    while (now := time.monotonic() - start) < tip["Time"][-1]:
        device.GetVirtualHand().SetPosition([np.interp(now, tip["Time"], tip.points[:, axis]) for axis in range(3)])
        device.UpdateState()
        time.sleep(0.005)
    device.GetRecorder().Stop()
    device.Close()
    recording = pv.read(f"{folder}/stroke.vtp")

replay = touch(head, recording, "CT contrast")
difference = np.abs(replay["Force"] - recording["Force"]).max()
print(f"{recording.n_points} ticks, largest difference {difference} N")

plotter = gallery.make_plotter(picture, size=(1300, 650), shape=(1, 2))
gallery.add_head(plotter, head)
gallery.add_trail(plotter, replay)
gallery.add_title(plotter, "A live hand, recorded at 1000 Hz")
plotter.view_vector((1, -0.8, 0.4), (0, 0, 1))
plotter.camera.zoom(1.3)
plotter.subplot(0, 1)
seconds = recording["Time"] - recording["Time"][0]
chart = gallery.add_chart(plotter, "Recorded, and computed again", "Time (s)", "Force on the hand (N)", {
    "recorded": (seconds, gallery.strength(recording), "#9cc3e6")}, legend=("center", "bottom"))
next(chart.plots("line")).line_width = 9  # so wide that it is visible on both sides of the computed curve
chart.line(seconds, gallery.strength(replay), color="#c0392b", width=2.5, label="computed again")
chart.legend_visible = True
gallery.show(plotter, picture)
