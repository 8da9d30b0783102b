# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Hidden tissue is not felt: the same hand feels the skin if the skin is shown, and otherwise the skull."""
import gallery
import numpy as np
from volumehaptics import vtkHapticProperty
from volumehaptics.pyvista import touch

head, picture = gallery.options(__doc__)
turn = np.linspace(-1.0, 1.0, 80)
tip = gallery.over_skin(
    head, np.column_stack([np.sin(turn), -0.9 + 0 * turn, np.cos(turn)]), np.linspace(-6.0, 13.0, 80))

plotter = gallery.make_plotter(picture, size=(1300, 650), shape=(1, 2))
looks = {"Skin is seen, and felt": gallery.OPACITY, "Bone alone is seen, and felt": [0, 0, 0, 0, 0, 0.7, 0.9, 1]}
for column, (title, opacity) in enumerate(looks.items()):
    plotter.subplot(0, column)
    volume = gallery.add_head(plotter, head, opacity)
    material = vtkHapticProperty()
    material.ApplyPreset("CT contrast")
    material.SetVisibilityFrom(volume.prop)
    trace = touch(head, tip, property=material)
    felt = trace["Contact"] > 0
    print(f"{title}: from {trace['Time'][felt].min():.3f} s on, values from {trace['SurfaceValue'][felt].min():.0f} HU")
    gallery.add_trail(plotter, trace, largest=15.0)
    gallery.add_title(plotter, title)
    plotter.view_vector((0.5, -1, 0.45), (0, 0, 1))
    plotter.camera.zoom(1.35)
gallery.show(plotter, picture)
