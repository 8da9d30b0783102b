# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""add_haptics() for a view of trame, with trame's own server and a browser's connection to it.

The test's view stands for trame.widgets.vtk.VtkRemoteView, which needs a VTK with web modules: as trame-vtk 2.11 has
it, a widget with a server, update(), and the window in a private attribute.
"""

import asyncio

import numpy as np
import pytest
import pyvista as pv
import volumehaptics

trame = pytest.importorskip("trame.app", reason="needs trame: pip install trame")
aiohttp = pytest.importorskip("aiohttp", reason="needs aiohttp, which trame brings along")


class VtkRemoteView:
    def __init__(self, server, window):
        self.server = server
        self.__view = window
        self.pictures = 0

    def update(self):
        self.pictures += 1


@pytest.mark.parametrize("leaves", ("closes", "breaks off"))
def test_the_touch_ends_with_the_browser(window, leaves):
    plotter = pv.Plotter(off_screen=True, window_size=(200, 200))
    grid = pv.ImageData(dimensions=(33, 33, 33), spacing=(2, 2, 2), origin=(-32, -32, -32))
    grid["inside"] = 100.0 * (20.0 - (grid.points.astype(float) ** 2).sum(axis=1) ** 0.5)
    plotter.add_volume(grid, clim=(-1, 1), opacity=[0, 0, 1, 1], show_scalar_bar=False)
    plotter.show(auto_close=False)
    server = trame.get_server(f"test {leaves}", client_type="vue3")
    view = VtkRemoteView(server, plotter.render_window)
    haptics = volumehaptics.add_haptics(view)
    device, interactor = haptics.device, plotter.render_window.GetInteractor()
    assert "Escape" not in haptics.style.GetKeys() and "wheel" in haptics.style.GetKeys(), "no key arrives"
    seen = {}

    async def until(holds):
        for _ in range(3000):
            if holds():
                return
            await asyncio.sleep(0.01)
        raise AssertionError(device.GetStatusText())

    async def browse():
        async with aiohttp.ClientSession() as session:
            socket = await session.ws_connect(f"http://localhost:{server.port}/ws")
            interactor.SetEventInformation(100, 100, 0, 0)
            haptics.widget.TouchModeOn()  # like a button of the program
            await until(lambda: "100 % of the force" in device.GetStatusText())
            for _ in range(4):
                interactor.MouseWheelForwardEvent()
            await until(lambda: np.linalg.norm(device.GetState().GetForce()) > 0.1)
            seen["hint"] = haptics.head_up_display.GetHint()
            await until(lambda: view.pictures > 2)
            if leaves == "closes":
                await socket.close()
            else:
                socket._response.connection.transport.abort()  # like a browser that is killed
            await until(lambda: device.GetState().GetForce() == (0, 0, 0))
            seen["touches"] = haptics.widget.GetTouchMode()

    async def run():
        try:
            await browse()
        except BaseException as error:
            seen["error"] = error
        finally:
            haptics.close()
            await server.stop()

    tasks = []
    server.controller.on_server_ready.add(lambda **_: tasks.append(asyncio.get_running_loop().create_task(run())))
    server.start(port=0, open_browser=False, show_connection_info=False, timeout=0)
    plotter.close()
    assert "error" not in seen, seen["error"]
    assert seen["touches"] is False
    assert "Escape" not in seen["hint"]
