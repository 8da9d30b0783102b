# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
import pyvista
import pyvistaqt

said = []


def open_window():
    plotter = pyvistaqt.BackgroundPlotter(title="host", window_size=(600, 600), auto_update=False)
    volume = plotter.add_volume(pyvista.wrap(image), clim=(-10, 10), opacity="linear", show_scalar_bar=False)
    if is_scan:
        volume.prop.DeepCopy(make_volume(image).GetProperty())
        plotter.set_background("black")
    plotter.add_slider_widget(said.append, (0.0, 1.0), pointa=(0.3, 0.1), pointb=(0.7, 0.1), color="white")
    plotter.add_key_event("u", lambda: hear("u"))
    return plotter


drag = ((0.32, 0.1), (0.5, 0.1))
plotter = open_window()
plotter.app.setQuitOnLastWindowClosed(False)
again = f"plotter = open_window(); {page.rstrip()}".replace("app.exec()", "app.setQuitOnLastWindowClosed(True)")
# code of Documentation/hosts.md
