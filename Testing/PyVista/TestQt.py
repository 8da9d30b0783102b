# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests add_haptics() with plotters of pyvistaqt: no force stays on in a Qt widget that is no longer visible."""

import gc
import os
import weakref

import pytest

pytest.importorskip("PyQt5", reason="needs Qt: pip install pyvistaqt PyQt5")
os.environ.setdefault("QT_API", "pyqt5")
pyvistaqt = pytest.importorskip("pyvistaqt", reason="needs pyvistaqt: pip install pyvistaqt")

import pyvista as pv  # noqa: E402
import volumehaptics  # noqa: E402
from PyQt5 import QtWidgets, sip  # noqa: E402
from conftest import Hand  # noqa: E402
from volumehaptics import vtkHapticDevice  # noqa: E402
from volumehaptics._qt import watch_widget  # noqa: E402
from volumehaptics.pyvista import add_haptics  # noqa: E402
from vtkmodules.qt.QVTKRenderWindowInteractor import QVTKRenderWindowInteractor  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkRenderer  # noqa: E402


@pytest.fixture(scope="module")
def application():
    yield QtWidgets.QApplication.instance() or QtWidgets.QApplication([])


class QtHand(Hand):
    """A ball in a widget, which is in a tab of a window."""

    def __init__(self, background):
        grid = pv.ImageData(dimensions=(33, 33, 33), spacing=(2, 2, 2), origin=(-32, -32, -32))
        grid["inside"] = 100.0 * (20.0 - (grid.points.astype(float) ** 2).sum(axis=1) ** 0.5)
        if background:
            self.plotter = pyvistaqt.BackgroundPlotter(window_size=(200, 200), auto_update=False)
            self.window = self.plotter.app_window
        else:
            self.window = QtWidgets.QMainWindow()
            self.tabs = QtWidgets.QTabWidget()
            self.plotter = pyvistaqt.QtInteractor(self.tabs, auto_update=False)
            self.tabs.addTab(self.plotter, "scene")
            self.tabs.addTab(QtWidgets.QWidget(), "other")
            self.window.setCentralWidget(self.tabs)
            self.window.resize(300, 300)
            self.window.show()
        self.volume = self.plotter.add_volume(grid, clim=(-1, 1), opacity=[0, 0, 1, 1], show_scalar_bar=False)
        self.haptics = add_haptics(self.plotter, self.volume)
        QtWidgets.QApplication.processEvents()
        width, height = self.plotter.iren.interactor.GetSize()
        self.pointer = (width // 2, height // 2)


@pytest.fixture
def qt_hands(application):
    made = []

    def make(background=False):
        made.append(QtHand(background))
        return made[-1]

    yield make
    for hand in made:
        hand.haptics.close()
        hand.plotter.close()
        hand.window.close()
    application.processEvents()


WAYS = {
    "hidden": lambda hand: hand.plotter.hide(),
    "window hidden": lambda hand: hand.window.hide(),
    "window closed": lambda hand: hand.window.close(),
    "window minimised": lambda hand: hand.window.showMinimized(),
}


@pytest.mark.parametrize("background", (False, True))
@pytest.mark.parametrize("way", (*WAYS, "closed", "other tab"))
def test_what_is_no_longer_seen_is_let_go(window, qt_hands, application, background, way):
    if background and way == "other tab":
        pytest.skip("it has no tabs")
    hand = qt_hands(background)
    hand.push()
    {**WAYS, "closed": lambda hand: hand.plotter.close(),
     "other tab": lambda hand: hand.tabs.setCurrentIndex(1)}[way](hand)
    application.processEvents()
    device = hand.device
    if not hand.haptics.closed:
        assert not hand.haptics.style.GetTouchMode() and not device.IsArmOrdered()
        hand.wait(lambda: device.GetState().GetForce() == (0, 0, 0))
        assert device.GetStatus() == vtkHapticDevice.READY
    assert device.GetState().GetForce() == (0, 0, 0) or not device.IsRunning()


def test_a_widget_that_is_shown_keeps_its_hand(window, qt_hands, application):
    hand = qt_hands()
    hand.push()
    hand.window.resize(320, 320)
    application.processEvents()
    assert hand.haptics.style.GetTouchMode() and hand.device.GetStatus() == vtkHapticDevice.ACTIVE


def test_a_widget_is_followed_to_another_window_and_kept_by_nobody(window, application):
    calls = []
    first, second = QtWidgets.QMainWindow(), QtWidgets.QMainWindow()
    widget = QtWidgets.QWidget()
    first.setCentralWidget(widget)
    end = watch_widget(widget, lambda: calls.append(1))
    first.show()
    second.setCentralWidget(widget)
    second.show()
    widget.show()
    application.processEvents()
    calls.clear()
    first.showMinimized()
    application.processEvents()
    assert not calls
    second.showMinimized()
    application.processEvents()
    assert calls
    calls.clear()
    end()
    widget.hide()
    assert not calls
    alone = weakref.ref(widget)
    second.takeCentralWidget()
    del widget
    gc.collect()
    assert alone() is None and end
    first.close()
    second.close()


def test_a_widget_that_qt_has_deleted_is_closed_quietly(window, application, capfd):
    """When Qt deletes the widget, its timer, which VTK's widget would stop, is deleted, too."""
    frame = QtWidgets.QMainWindow()
    widget = QVTKRenderWindowInteractor(frame)
    frame.setCentralWidget(widget)
    grid = pv.ImageData(dimensions=(33, 33, 33))
    grid["value"] = 100.0 * grid.points[:, 2]
    plotter = pv.Plotter(off_screen=True)
    renderer = vtkRenderer()
    renderer.AddVolume(plotter.add_volume(grid))
    widget.GetRenderWindow().AddRenderer(renderer)
    frame.show()
    widget.Initialize()
    haptics = volumehaptics.add_haptics(widget)
    application.processEvents()
    frame.close()
    sip.delete(frame)
    haptics.close()
    assert haptics.closed and not haptics.device.IsRunning()
    assert "Traceback" not in capfd.readouterr().err
    plotter.close()


def test_what_is_no_widget_is_not_watched():
    assert watch_widget(object(), lambda: None) is None
