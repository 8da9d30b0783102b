# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A hand strokes the side of a head: the trail of the proxy is coloured by the force on the hand."""
import gallery
import numpy as np
from volumehaptics.pyvista import touch

head, picture = gallery.options(__doc__)

# The path goes from the forehead to the back of the head, in waves, 1 to 5 mm below the skin.
turn = np.linspace(0.35, 2.35, 90)
wave = 0.42 + 0.16 * np.cos(4 * turn)
tip = gallery.over_skin(
    head, np.column_stack([np.sin(turn), -np.cos(turn), wave]), depth=3.0 + 2.0 * np.sin(6 * turn))
trace = touch(head, tip, "CT contrast")
print(f"strongest {gallery.strength(trace).max():.3f} N")

plotter = gallery.make_plotter(picture)
gallery.add_head(plotter, head)
gallery.add_trail(plotter, trace)
gallery.add_title(plotter, "The way of the proxy, coloured by the force on the hand")
gallery.show(plotter, picture, direction=(1, -0.7, 0.3))
