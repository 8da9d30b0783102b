# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Shows a head to touch in a plotter of PyVista, for close.sh. Writes "felt" when a surface first holds the hand."""

import pyvista as pv
from volumehaptics import examples, vtkInteractorStyleHaptic
from volumehaptics.pyvista import add_haptics

plotter = pv.Plotter(title="Touch in PyVista", window_size=(200, 200))
skin = plotter.add_volume(
    pv.wrap(examples.phantom()), clim=(-600, 1000), opacity=[0, 0.35, 0.35, 0.2, 0.14, 0.6, 0.9, 1],
    show_scalar_bar=False)
haptics = add_haptics(plotter, skin, "CT contrast", iso_value=-300)
haptics.style.AddObserver(vtkInteractorStyleHaptic.ContactBeginEvent, lambda *_: print("felt", flush=True))
plotter.view_vector((1, -0.8, 0.35), (0, 0, 1))
plotter.show()
