# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Friction holds back a hand that slides over a surface; viscosity holds back a hand that moves inside."""
import gallery
import numpy as np
import pyvista as pv
from volumehaptics import vtkHapticProperty
from volumehaptics.pyvista import touch

picture = gallery.options(__doc__, volume=False)

# A block below z = 0, whose values rise by 100 per millimetre of depth.
block = pv.ImageData(dimensions=(81, 41, 41), origin=(-40, -20, -20))
block["depth"] = -100.0 * block.points[:, 2]


def slide(depth, **functions):
    """Makes the hand go down to a depth (mm), then 40 mm along the surface, at 40 mm/s. Returns the trace."""
    material = vtkHapticProperty()
    material.GetSurfaceStrength().AddPoint(-1, 0.0)  # nothing is felt above z = 0
    material.GetSurfaceStrength().AddPoint(1, functions.pop("strength"))
    for name, value in functions.items():
        getattr(material, f"Get{name}")().AddPoint(0, value)
    down = np.linspace((-20, 0, 4), (-20, 0, -depth), 400)
    along = np.linspace((-20, 0, -depth), (20, 0, -depth), 1000)
    return touch(block, np.vstack([down, along]), property=material)


plotter = gallery.make_plotter(picture, size=(1300, 600), shape=(1, 2))
curves = {}
for mu in (0.1, 0.3, 0.6):
    trace = slide(4.0, strength=100.0, Friction=mu)
    curves[f"friction {mu}"] = (trace["Time"], trace["FrictionForce"])
    normal = trace["NormalForce"][-1]
    print(f"friction {mu}: {trace['FrictionForce'][-1] / normal:.4f} of {normal:.3f} N")
gallery.add_chart(plotter, "Sliding on a surface, pressed with 3 N", "Time (s)", "Friction (N)", curves)
plotter.subplot(0, 1)
curves = {}
for drag in (0.2, 0.5, 1.0):
    trace = slide(10.0, strength=0.0, Viscosity=drag)
    curves[f"viscosity {drag} N"] = (trace["Time"], trace["DragForce"])
    print(f"viscosity {drag} N: {trace['DragForce'][-1]:.4f} N")
gallery.add_chart(plotter, "Moving inside, without a surface", "Time (s)", "Drag (N)", curves)
gallery.show(plotter, picture)
