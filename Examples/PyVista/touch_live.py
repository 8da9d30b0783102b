# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A head to touch with the mouse."""
import pyvista as pv
from volumehaptics import examples
from volumehaptics.pyvista import add_haptics

head = pv.wrap(examples.phantom())  # or pv.read("head.nii.gz")
plotter = pv.Plotter()
plotter.set_background("black", top="slategray")
skin = plotter.add_volume(
    head, clim=(-600, 1000), opacity=[0, 0.35, 0.35, 0.2, 0.14, 0.6, 0.9, 1], shade=True,
    cmap=["#edb08f", "#e0977d", "#f5ebd8", "#ffffff"], opacity_unit_distance=4, show_scalar_bar=False)
skin.prop.interpolation_type = "linear"
haptics = add_haptics(plotter, skin, "CT contrast", iso_value=-300)
plotter.view_vector((1, -0.8, 0.35), (0, 0, 1))
plotter.camera.zoom(1.3)
plotter.show()  # press t with the pointer on the head; then the wheel presses, and moving the mouse strokes
