# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A live servo in a plotter. A program leads the hand; tip, proxy, forces, and figures are shown over the scene."""
import time

import gallery
import numpy as np
from volumehaptics.pyvista import add_haptics
from vtkmodules.vtkCommonDataModel import vtkTable

head, picture = gallery.options(__doc__)
turn = np.linspace(0.4, 1.1, 60)
way = gallery.over_skin(
    head, np.column_stack([np.sin(turn), -np.cos(turn), 0.5 + 0 * turn]), 3.5 - 12.0 * ((1.1 - turn) / 0.7) ** 6, 25.0)

plotter = gallery.make_plotter(picture)
haptics = add_haptics(plotter, gallery.add_head(plotter, head), "CT contrast")
for tissue, low, high in (("fat", -150, -20), ("muscle", -20, 90), ("bone", 300, 3000)):  # HU
    haptics.head_up_display.AddTissue(tissue, low, high)
plotter.view_vector((0.45, -1, 0.2), (0, 0, 1))
plotter.camera.focal_point = way.points[-1] - (0, 0, 30)
plotter.camera.zoom(1.6)
plotter.camera.SetWindowCenter(-0.28, 0.0)  # leaves room for the diagrams
plotter.show(interactive_update=True)

haptics.device.GetVirtualHand().Place(*way.points[0])
haptics.device.Arm()
start, strongest, states = time.monotonic(), 0.0, vtkTable()
while (now := time.monotonic() - start) < way["Time"][-1] and not haptics.closed:
    haptics.device.GetVirtualHand().SetPosition([np.interp(now, way["Time"], way.points[:, axis]) for axis in range(3)])
    if picture:  # draw only at the end: with software rendering, further frames would make the hand jerk
        haptics.device.UpdateState()
        haptics.device.GetState().Drain(states)
        haptics.head_up_display.AddStates(states)
        time.sleep(0.005)
    else:
        haptics.update()
        plotter.update()
    strongest = max(strongest, np.linalg.norm(haptics.device.GetState().GetForce()))
print(f"strongest {strongest:.3f} N, {haptics.device.GetStatusText()}")
plotter.render()
if picture:
    plotter.screenshot(picture)
plotter.close()
