# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Presses a needle into a cheek: fat and muscle each give way at their own force; bone does not give way."""
import gallery
import numpy as np
from volumehaptics import vtkVolumeHapticsFilter
from volumehaptics.pyvista import touch

STRENGTH = {"fat": 1.0, "muscle": 2.2}  # N, as in the preset

head, picture = gallery.options(__doc__)
outwards = np.array([0.62, -0.62, -0.48])
middle = np.asarray(head.center)
skin = head.contour([-300.0]).ray_trace(middle + head.length * outwards, middle, first_point=True)[0]
depth = np.linspace(-14, 26, 2001)  # mm
# Read materials from behind the blurred edges, and place surfaces in the middle of the edges.
trace = touch(
    head, skin - depth[:, None] * outwards, "CT contrast", contact_alignment=vtkVolumeHapticsFilter.EDGE,
    material_placement=vtkVolumeHapticsFilter.FAR_SIDE)
force = gallery.strength(trace)
print(f"fat holds {np.median(force[(depth > 1) & (depth < 7)]):.3f} N")
print(f"strongest {force.max():.3f} N, at {depth[force.argmax()]:.2f} mm")

plotter = gallery.make_plotter(picture, size=(1300, 650), shape=(1, 2))
plotter.set_background("black", all_renderers=False)
aside = np.cross((0, 0, 1), outwards)
plotter.add_mesh(head.slice(aside, origin=skin), cmap="gray", clim=(-1000, 1500), show_scalar_bar=False, lighting=False)
needle = trace.copy()
needle.points = trace["Tip"] + 2.0 * aside  # moves the trail in front of the slice
gallery.add_trail(plotter, needle)
gallery.add_title(plotter, "The way of the needle's tip, and the force")
plotter.view_vector(aside, (0, 0, 1))
plotter.camera.focal_point = skin - 15 * outwards
plotter.camera.zoom(2.6)
plotter.subplot(0, 1)
chart = gallery.add_chart(
    plotter, "Tissues that give way, and their surface strengths", "Depth below the skin (mm)", "Force on the hand (N)",
    {"force": (depth, force)})
for (tissue, newtons), colour in zip(STRENGTH.items(), ("#c9a227", "#b1342b")):
    ends, label = [depth[0], depth[-1]], f"{tissue}, {newtons} N"
    chart.line(ends, [newtons, newtons], color=colour, width=2, style="--", label=label)
chart.y_range = (0.0, 3.0)  # leaves room for the legend
chart.legend_visible = True
gallery.show(plotter, picture)
