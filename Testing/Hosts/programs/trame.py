# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
import subprocess
import webbrowser
from pathlib import Path

import pyvista
from trame.app import get_server

said = []
plotter = pyvista.Plotter(off_screen=True, window_size=(600, 500))
plotter.add_volume(pyvista.wrap(image), clim=(-10, 10), opacity="linear", show_scalar_bar=False)
plotter.add_slider_widget(said.append, (0.0, 1.0), pointa=(0.3, 0.1), pointb=(0.7, 0.1), color="white")
plotter.add_key_event("u", lambda: hear("u"))
drag = ((0.32, 0.1), (0.5, 0.1))
server = get_server("volumehaptics-serve", client_type="vue3")  # the server that the page's lines use
server.state.trame__title = "host"


def open_page(address):
    """Opens the page in a window of its user's browser."""
    global browser, opened
    opened = address
    browser = subprocess.Popen([
        "chromium", f"--app={address}", "--no-sandbox", "--no-first-run", "--disable-gpu", "--disable-dev-shm-usage",
        f"--user-data-dir={Path.home() / 'chromium'}", "--window-size=700,650"], stderr=subprocess.DEVNULL)


webbrowser.open = open_page
again = "open_page(opened)"
# code of Documentation/hosts.md
