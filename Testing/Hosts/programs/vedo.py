# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
import vedo

volume = vedo.Volume(image)
volume.alpha(opacity).color([(value, color) for value, color in colors])
plotter = vedo.Plotter(size=(500, 500), title="host", bg="black")
plotter.add_callback("key press", lambda event: hear(event.keypress))
# code of Documentation/hosts.md
