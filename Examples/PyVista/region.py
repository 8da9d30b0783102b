# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Loads only a region of a volume, as if the whole were too large. The region feels like the whole, to the bit."""
import gallery
import numpy as np
import pyvista as pv
from volumehaptics import vtkHapticRegionFilter
from volumehaptics.pyvista import touch

head, picture = gallery.options(__doc__)
turn = np.linspace(0.2, 2.2, 90)
depth = 4.0 - 14.0 * (turn - 1.2) ** 8
tip = gallery.over_skin(head, np.column_stack([np.sin(turn), -np.cos(turn), 0.6 + 0 * turn]), depth)

crop = vtkHapticRegionFilter()
crop.SetInputData(head)
size = head.dimensions
# Include the samples below the skin, from which materials are read.
crop.SetRegion(3 * size[0] // 8, size[0] - 1, 0, 5 * size[1] // 8, 7 * size[2] // 16, 15 * size[2] // 16)
crop.Update()
region = pv.wrap(crop.GetOutput())

whole, part = touch(head, tip, "CT contrast"), touch(region, tip, "CT contrast")
same = (whole["Force"] == part["Force"]).all(axis=1)
share = 100 * region.n_points / head.n_points
print(f"the same to the bit in {same.sum()} of {len(same)} ticks, with {share:.0f} % of the volume")

plotter = gallery.make_plotter(picture, size=(1300, 650), shape=(1, 2))
gallery.add_head(plotter, head)
gallery.add_trail(plotter, part)
plotter.add_mesh(pv.Box(region.bounds), style="wireframe", color="white", line_width=2)
gallery.add_title(plotter, "The region that is here")
plotter.view_vector((1, -0.8, 0.45), (0, 0, 1))
plotter.camera.zoom(1.3)
plotter.subplot(0, 1)
gallery.add_chart(plotter, "The same force, which fades where the region ends", "Time (s)", "Force on the hand (N)", {
    "whole volume": (whole["Time"], gallery.strength(whole), "#9cc3e6"),
    "region": (part["Time"], gallery.strength(part), "#c0392b")})
gallery.show(plotter, picture)
