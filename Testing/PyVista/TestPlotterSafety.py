# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""If something goes wrong with add_haptics(), no force stays on without a request or a visible reason."""

import os
import signal
import sys

import pytest
import pyvista as pv
from volumehaptics import _plotting, vtkHapticDevice
from volumehaptics.pyvista import add_haptics


@pytest.mark.parametrize("take_out", (
    lambda plotter, hand: plotter.clear(),
    lambda plotter, hand: plotter.remove_actor(hand.volume),
    lambda plotter, hand: plotter.renderer.RemoveAllViewProps(),
    lambda plotter, hand: plotter.add_volume(pv.ImageData(hand.volume.mapper.dataset), name=hand.volume.name),
))
def test_what_is_taken_out_of_the_scene_is_not_pressed_on(window, hands, take_out):
    hand = hands()
    hand.push()
    take_out(hand.plotter, hand)
    assert not hand.haptics.style.GetTouchMode()
    hand.wait(lambda: hand.device.GetState().GetForce() == (0, 0, 0))
    assert hand.device.GetStatus() == vtkHapticDevice.READY


def test_other_actors_may_come_and_go(window, hands):
    hand = hands()
    hand.push()
    hand.plotter.remove_actor(hand.plotter.add_mesh(pv.Sphere()))
    assert hand.haptics.style.GetTouchMode() and hand.device.GetStatus() == vtkHapticDevice.ACTIVE


@pytest.mark.parametrize("step", ("_prepare", "_choose_device", "_attach"))
def test_nothing_runs_while_the_exception_is_kept(window, hands, monkeypatch, step):
    hand, made = hands(), []

    class Noted(_plotting.Haptics):
        def __init__(self, *arguments):
            super().__init__(*arguments)
            made.append(self)

    def fail(*_):
        raise KeyboardInterrupt

    hand.haptics.close()
    monkeypatch.setattr(_plotting, "Haptics", Noted)
    monkeypatch.setattr(_plotting if step == "_prepare" else Noted, step, fail)
    with pytest.raises(KeyboardInterrupt) as kept:
        add_haptics(hand.plotter)
    device = made[0].device
    assert kept.traceback and made[0].closed and not device.IsOpen() and not device.IsRunning()
    monkeypatch.undo()
    assert add_haptics(hand.plotter).device.IsRunning()


def test_armed_device_of_ones_own_is_disarmed(window, hands):
    first = hands()
    first.push()
    second = hands(device=first.device)
    tick = first.device.GetState().GetTick()
    second.wait(lambda: second.device.GetState().GetTick() > max(tick, 100))
    assert second.device.GetStatus() == vtkHapticDevice.READY and second.device.GetState().GetForce() == (0, 0, 0)


@pytest.mark.skipif(sys.platform != "linux", reason="nothing is forked elsewhere")
def test_child_closes_its_copy(window, hands):
    hand = hands()
    hand.push()
    child = os.fork()
    if child == 0:
        signal.alarm(30)  # ends a child that waits for threads that do not exist
        _plotting._close_all()  # as at the exit of the child
        os._exit(7)
    assert os.waitpid(child, 0) == (child, 7 << 8)
    assert hand.device.GetStatus() == vtkHapticDevice.ACTIVE
