# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Feels one stroke with each method. Methods with a proxy look ahead by KernelRadius, and so hold the proxy earlier by
this radius. The surface proxy is a sphere, and the local surface has no size."""
import gallery
import numpy as np
from volumehaptics import vtkHapticProperty, vtkVolumeHapticsFilter
from volumehaptics.pyvista import touch

head, picture = gallery.options(__doc__)
turn = np.linspace(-0.9, 0.9, 60)
tip = gallery.over_skin(
    head, np.column_stack([np.sin(turn), -0.35 + 0 * turn, np.cos(turn)]), 3.0 - 15.0 * np.abs(turn / 0.9) ** 5)

solid = vtkHapticProperty()  # a solid that begins at the skin, like the isosurface of the other methods
for value, newtons in ((-350, 0.0), (-250, 50.0)):
    solid.GetSurfaceStrength().AddPoint(value, newtons)
names = vtkVolumeHapticsFilter.GetMethodNames()
curves = {}
for name in [names.GetValue(i) for i in range(names.GetNumberOfValues())]:
    if name == "primitives":
        continue  # this method needs vectors, which the head lacks
    trace = touch(head, tip, property=solid, method_by_name=name, iso_value=-300.0, force_field_gain=1 / 450)
    curves[name] = (trace["Time"], gallery.strength(trace))
    print(f"{name}: strongest {gallery.strength(trace).max():.3f} N")
    if name == "proxy":
        shown = trace

plotter = gallery.make_plotter(picture, size=(1300, 650), shape=(1, 2))
gallery.add_head(plotter, head)
gallery.add_trail(plotter, shown)
gallery.add_title(plotter, "The stroke, as the proxy method feels it")
plotter.view_vector((0.35, -1, 0.8), (0, 0, 1))
plotter.camera.zoom(1.3)
plotter.subplot(0, 1)
gallery.add_chart(plotter, "The same stroke with each method", "Time (s)", "Force on the hand (N)", curves)
gallery.show(plotter, picture)
