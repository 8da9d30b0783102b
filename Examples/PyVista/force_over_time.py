# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A hand presses into a cheek and slides: the parts of the force, and the felt tissue, over time."""
import gallery
import numpy as np
from volumehaptics.pyvista import touch

# Upper limits of the values of tissues (HU).
TISSUES = {"air": -500, "skin's edge": -150, "fat": -20, "muscle": 90, "cartilage": 300, "bone": 3000}

head, picture = gallery.options(__doc__)
turn = np.linspace(0.45, 1.3, 60)
depth = 6.0 - 18.0 * (2 * (turn - 0.875) / 0.85) ** 6
tip = gallery.over_skin(head, np.column_stack([np.sin(turn), -np.cos(turn), 0 * turn - 0.25]), depth, speed=60)
trace = touch(head, tip, "CT contrast")
time = trace["Time"]
print(f"strongest {gallery.strength(trace).max():.3f} N after {time[gallery.strength(trace).argmax()]:.3f} s")

plotter = gallery.make_plotter(picture, size=(1300, 750), shape="1|2")
plotter.subplot(0)
gallery.add_head(plotter, head)
gallery.add_trail(plotter, trace)
gallery.add_title(plotter, "A stroke over the cheek")
plotter.view_vector((1, -0.7, 0.15), (0, 0, 1))
plotter.camera.zoom(1.15)
plotter.subplot(1)
gallery.add_chart(plotter, "Force on the hand", "Time (s)", "Force (N)", {
    "normal": (time, trace["NormalForce"]), "friction": (time, trace["FrictionForce"]),
    "drag": (time, trace["DragForce"]), "whole": (time, gallery.strength(trace), "#444444")})
plotter.subplot(2)
tissue = np.where(trace["Contact"] > 0, np.searchsorted(list(TISSUES.values()), trace["SurfaceValue"]), 0)
chart = gallery.add_chart(plotter, "Tissue that is touched", "Time (s)", "", {"": (time, tissue)})
chart.y_range = (-0.3, len(TISSUES) - 0.7)
chart.y_axis.tick_locations, chart.y_axis.tick_labels = range(len(TISSUES)), list(TISSUES)
gallery.show(plotter, picture)
