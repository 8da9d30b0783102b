# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Touch a head with the mouse: press t with the pointer on it. touch_live.py [VOLUME] [--picture FILE]"""
import sys

import pyvista as pv
from volumehaptics import examples
from volumehaptics.pyvista import add_haptics

head = pv.wrap(examples.phantom())
plotter = pv.Plotter()
skin = plotter.add_volume(head, clim=(-500, 1000), opacity=[0, 0.3, 0.6], cmap="copper", shade=True)
add_haptics(plotter, skin, "CT contrast")
plotter.camera_position = "xz"
plotter.show()
