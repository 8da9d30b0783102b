# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests live touch as a user sees it: the documented script, and a real window with its event loop, timer and keys."""

import pytest
import pyvista as pv
import volumehaptics.pyvista
from volumehaptics import vtkHapticDevice, vtkInteractorStyleHaptic


def script(root):
    text = (root / "Examples" / "PyVista" / "touch_live.py").read_text(encoding="utf-8")
    return text.split('"""\n', 1)[1]


def test_script_is_the_documented_one_and_short(root):
    text = (root / "Documentation" / "python.md").read_text(encoding="utf-8")
    section = text.split("\n## PyVista\n")[1].split("\n## ")[0]
    code = script(root)
    assert f"```python\n{code}```" in section
    assert len(code.strip().splitlines()) < 20


def test_script_is_felt(window, root, monkeypatch):
    made, forces = [], []

    def show(plotter):
        """Acts as a user: touches the middle of the head, presses, strokes, and closes the window."""
        pv_show(plotter, auto_close=False)
        haptics, interactor = made[0], plotter.iren.interactor
        x, y = (size // 2 for size in plotter.window_size)
        interactor.SetEventInformation(x, y, 0, 0)
        interactor.SetKeySym("t")
        interactor.KeyPressEvent()
        assert haptics.style.GetTouchMode()
        while "100 % of the force" not in haptics.device.GetStatusText():  # a wall that is pressed earlier stays soft
            assert haptics.device.IsRunning()
            haptics.update()
        for step in range(12):
            interactor.MouseWheelForwardEvent() if step < 3 else None
            interactor.SetEventInformation(x + step, y, 0, 0)
            interactor.MouseMoveEvent()
            tick = haptics.device.GetState().GetTick()
            while haptics.device.GetState().GetTick() < tick + 30:
                assert haptics.device.IsRunning()
                haptics.update()
            forces.append(sum(f * f for f in haptics.device.GetState().GetForce()) ** 0.5)
        plotter.close()

    def add_haptics(*arguments, **settings):
        made.append(original(*arguments, **settings))
        return made[-1]

    pv_show, original = pv.Plotter.show, volumehaptics.pyvista.add_haptics
    monkeypatch.setattr(pv.Plotter, "show", show)
    monkeypatch.setattr(volumehaptics.pyvista, "add_haptics", add_haptics)
    monkeypatch.setattr(pv, "OFF_SCREEN", True)
    monkeypatch.setattr(pv.global_theme, "window_size", [320, 240])  # small, since the processor draws the frames
    exec(compile(script(root), "touch_live.py", "exec"), {})
    assert max(forces) > 0.2
    assert made[0].closed and not made[0].device.IsRunning()


def end_with(hand, key):
    """Runs the window's own loop; presses t, then `key` when a force is felt."""
    interactor, style = hand.plotter.iren.interactor, hand.haptics.style
    felt = []

    def states(*_):
        if not felt and not style.GetTouchMode():
            interactor.SetEventInformation(*hand.pointer, 0, 0)
            hand.press("t")
            for _ in range(4):
                interactor.MouseWheelForwardEvent()
        elif not felt and hand.device.GetState().GetForce()[1] != 0.0:
            felt.append(hand.device.GetState().GetForce())
            hand.press(key)

    style.AddObserver(vtkInteractorStyleHaptic.StatesEvent, states)
    return felt


def test_key_q_closes_a_window_and_stops_the_device(window, hands):
    hand = hands(off_screen=False)
    felt = end_with(hand, "q")
    hand.plotter.show()
    assert felt and hand.haptics.closed
    assert hand.device.GetStatus() == vtkHapticDevice.CLOSED and not hand.device.IsRunning()


def test_window_that_stays_keeps_its_style_and_can_be_closed(window, hands):
    hand = hands(off_screen=False)
    felt = end_with(hand, "q")
    hand.plotter.show(auto_close=False)
    assert felt and not hand.haptics.closed and hand.device.IsRunning()
    hand.plotter.close()
    assert hand.haptics.closed and not hand.device.IsRunning()


@pytest.mark.parametrize("error", (KeyboardInterrupt, RuntimeError))
def test_exception_ends_it(window, hands, error):
    hand = hands()
    with pytest.raises(error), hand.haptics:
        hand.push()
        raise error
    assert not hand.device.IsOpen()
