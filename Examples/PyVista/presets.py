# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Feels the same stroke with presets, and with the program's own transfer functions."""
import gallery
import numpy as np
from volumehaptics import vtkHapticProperty
from volumehaptics.pyvista import touch

head, picture = gallery.options(__doc__)
turn = np.linspace(-0.9, 0.9, 60)
tip = gallery.over_skin(
    head, np.column_stack([np.sin(turn), -0.35 + 0 * turn, np.cos(turn)]), 5.0 - 15.0 * np.abs(turn / 0.9) ** 5)

materials = {}
for name in ("CT contrast", "CT physical"):
    materials[name] = vtkHapticProperty()
    materials[name].ApplyPreset(name)
own = materials["own functions"] = vtkHapticProperty()
for value, stiffness, friction in ((-400, 300, 0.1), (100, 300, 0.1), (300, 900, 0.4)):
    own.GetStiffness().AddPoint(value, stiffness)  # HU, N/m
    own.GetFriction().AddPoint(value, friction)
for value, strength in ((-350, 0), (-250, 4)):
    own.GetSurfaceStrength().AddPoint(value, strength)  # HU, N

traces = {name: touch(head, tip, property=material) for name, material in materials.items()}
for name, trace in traces.items():
    print(f"{name}: strongest {gallery.strength(trace).max():.3f} N")

plotter = gallery.make_plotter(picture, size=(1300, 600), shape=(1, 2))
values = np.linspace(-1000, 400, 500)
gallery.add_chart(plotter, "What the materials are", "Value (HU)", "Surface strength (N), up to 15 N", {
    name: (values, [min(material.GetSurfaceStrength().GetValue(v), 15.0) for v in values])
    for name, material in materials.items()})
plotter.subplot(0, 1)
gallery.add_chart(plotter, "What they feel like on one stroke", "Time (s)", "Force on the hand (N)", {
    name: (trace["Time"], gallery.strength(trace)) for name, trace in traces.items()})
gallery.show(plotter, picture)
