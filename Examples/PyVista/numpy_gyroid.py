# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A volume that NumPy makes on the spot, a gyroid, and a hand that slides along its wall."""
import gallery
import numpy as np
import pyvista as pv
from volumehaptics import vtkHapticProperty
from volumehaptics.pyvista import touch

PERIOD = 30.0  # mm
picture = gallery.options(__doc__, volume=False)


def gyroid(points):
    """Returns values and gradients at points of shape (..., 3)."""
    x, y, z = np.moveaxis(2 * np.pi / PERIOD * points, -1, 0)
    sx, sy, sz, cx, cy, cz = *np.sin([x, y, z]), *np.cos([x, y, z])
    slope = np.stack([cx * cy - sz * sx, cy * cz - sx * sy, cz * cx - sy * sz], axis=-1)
    return sx * cy + sy * cz + sz * cx, 2 * np.pi / PERIOD * slope


volume = pv.ImageData(dimensions=(91, 91, 91), spacing=(2 / 3, 2 / 3, 2 / 3), origin=(-30, -30, -30))
volume["gyroid"] = gyroid(volume.points.astype(float))[0]

wall = vtkHapticProperty()  # solid if the value is above 0
for value, newtons in ((-0.02, 0.0), (0.02, 50.0)):
    wall.GetSurfaceStrength().AddPoint(value, newtons)

# A line across the volume, projected onto the wall. The tip enters the wall by 0.5 to 3.5 mm, and returns.
turn = np.linspace(0, 1, 150)
way = np.linspace((-16.4, -10.9, -3.8), (1.4, 23.4, 21.8), 150)
for _ in range(20):
    value, slope = gyroid(way)
    way -= (value / (slope**2).sum(axis=1))[:, None] * slope
depth = 2.0 + 1.5 * np.sin(14 * turn) - 7.0 * (2 * turn - 1) ** 8
tip = way + (depth / np.linalg.norm(slope, axis=1))[:, None] * slope
trace = touch(volume, gallery.at_speed(tip, 80), property=wall)
print(f"strongest {gallery.strength(trace).max():.3f} N")

plotter = gallery.make_plotter(picture)
view = np.array([0.4, -1.0, 1.3])
before = trace.points.mean(axis=0) + 3.0 * view  # objects nearer to the eye than this would hide the trail
plotter.add_mesh(volume.contour([0.0]).clip(view, origin=before), color="#c9d3e0", smooth_shading=True)
gallery.add_trail(plotter, trace)
gallery.add_title(plotter, "A gyroid made with NumPy, and the way of the proxy along its wall")
gallery.show(plotter, picture, direction=view, zoom=0.95)
