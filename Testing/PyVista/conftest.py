# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the package with PyVista, in an environment that has both:

    xvfb-run -a python -m pytest Testing/PyVista
"""

import os
import sys
import time
from pathlib import Path

import pytest

pv = pytest.importorskip("pyvista", reason="needs PyVista: pip install pyvista")

from volumehaptics import examples  # noqa: E402
from volumehaptics.pyvista import add_haptics  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]


def pytest_collection_modifyitems(items):
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
        for item in items:
            if "window" in item.fixturenames:
                item.add_marker(pytest.mark.skip(reason="needs a display, such as of xvfb-run -a"))


class Hand:
    """A window with a ball that can be touched, with simulated mouse and key events."""

    def __init__(self, off_screen=True, columns=1, **settings):
        self.plotter = pv.Plotter(off_screen=off_screen, shape=(1, columns), window_size=(200, 200))
        self.plotter.subplot(0, columns - 1)
        self.pointer = (200 - 100 // columns, 100)  # middle of the last column
        grid = pv.ImageData(dimensions=(33, 33, 33), spacing=(2, 2, 2), origin=(-32, -32, -32))
        distance = (grid.points.astype(float) ** 2).sum(axis=1) ** 0.5
        grid["inside"] = 100.0 * (20.0 - distance)  # a ball of 20 mm
        self.volume = self.plotter.add_volume(grid, clim=(-1, 1), opacity=[0, 0, 1, 1], show_scalar_bar=False)
        self.haptics = add_haptics(self.plotter, self.volume, **settings)

    @property
    def device(self):
        return self.haptics.device

    def press(self, key):
        interactor = self.plotter.iren.interactor
        interactor.SetKeySym(key)
        interactor.SetKeyCode(key if len(key) == 1 else "\0")
        interactor.KeyPressEvent()
        interactor.CharEvent()
        interactor.KeyReleaseEvent()
        time.sleep(0.02)  # slower than the key repeat of a window system

    def push(self, steps=4):
        """Touches the middle of the ball, and presses."""
        if not self.plotter.iren.initialized:
            self.plotter.show(auto_close=False)  # the window handles events from now on
        interactor = self.plotter.iren.interactor
        interactor.SetEventInformation(*self.pointer, 0, 0)
        self.press("t")
        self.wait(lambda: "100 % of the force" in self.device.GetStatusText())
        for _ in range(steps):
            interactor.MouseWheelForwardEvent()
        self.wait(lambda: sum(x * x for x in self.device.GetState().GetForce()) > 0.01)

    def wait(self, holds):
        """Waits until `holds` is true; no test depends on the time this takes."""
        end = time.monotonic() + 30.0
        while not holds():
            assert time.monotonic() < end, self.device.GetStatusText()
            self.haptics.update()
            time.sleep(0.002)


@pytest.fixture
def hands():
    made = []

    def make(**settings):
        made.append(Hand(**settings))
        return made[-1]

    yield make
    for hand in made:
        hand.plotter.close()


@pytest.fixture
def window():
    """Requested by tests that render."""


@pytest.fixture(scope="session")
def head():
    return pv.wrap(examples.phantom())


@pytest.fixture(scope="session")
def root():
    return ROOT
