# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Presses every key that PyVista binds and every key of ours: each key acts once, and the touch still works after
it."""

import pytest

pv = pytest.importorskip("pyvista", reason="needs PyVista: pip install pyvista")

CLOSING = ("q",)  # keys of PyVista that close the plotter


def keys_of_pyvista(plotter):
    return sorted(plotter.iren._key_press_event_callbacks)


def keys_of_style(style):
    actions = style.GetKeyActions()
    return [key for i in range(actions.GetNumberOfValues()) for key in style.GetKey(actions.GetValue(i)).split()]


def is_listed(haptics, key):
    labels = {"question": "?", "plus": "+", "minus": "-", "comma": ",", "period": ".", "BackSpace": "Backspace", "Ctrl+z": "Ctrl+Z",
              "Ctrl+y": "Ctrl+Y", "Ctrl+BackSpace": "Ctrl+Backspace"}
    return any(labels.get(key, key) in line.split("\t")[0].split("  ") for line in haptics.style.GetKeys().splitlines())


def begin(hand):
    """Returns whether t begins the touch."""
    if hand.haptics.widget.GetTouchMode():
        hand.press("Escape")
    hand.plotter.iren.interactor.SetEventInformation(*hand.pointer, 0, 0)
    hand.press("t")
    return hand.haptics.widget.GetTouchMode()


def is_alive(hand):
    """Returns whether t begins and Escape ends the touch."""
    began = begin(hand)
    hand.press("Escape")
    return began and not hand.haptics.widget.GetTouchMode()


@pytest.fixture(params=["one image", "frames"])
def hand(request, window, hands):
    if request.param == "one image":
        hand = hands()
    else:
        hand = hands()
        grid = hand.volume.mapper.dataset
        hand.haptics.close()
        from volumehaptics.pyvista import add_haptics

        hand.haptics = add_haptics(hand.plotter, [grid, grid.copy()], [0.0, 1.0])
    hand.plotter.show(auto_close=False)
    return hand


def test_no_key_does_two_things(hand):
    plotter, haptics = hand.plotter, hand.haptics
    called = []
    for key in (*keys_of_pyvista(plotter), *keys_of_style(haptics.style)):
        plotter.iren.clear_events_for_key(key, raise_on_missing=False)
        plotter.add_key_event(key, lambda key=key: called.append(key))
    for key in sorted({*keys_of_pyvista(plotter), *keys_of_style(haptics.style)} - {"Home", *CLOSING}):
        called.clear()
        hand.press(key)
        assert called == ([] if key == "t" else [key]), f"{key}, before the touch"
        assert begin(hand), key
        called.clear()
        hand.press(key)
        # The key Delete finds no measurement to remove here, so it is passed to PyVista.
        assert called == ([] if is_listed(haptics, key) and key != "Delete" else [key]), f"{key}, in the touch"
        hand.press("Escape")
    assert is_alive(hand)  # after each of our keys
    for key in ("y", "t", "Escape"):
        assert is_listed(haptics, key)
    for key in ("Up", "Down", "v"):
        assert not is_listed(haptics, key)
    assert is_listed(haptics, "b") == (haptics.frames is not None)  # a key for volumes that move


def test_the_hand_is_there_after_each_key_of_pyvista(hand, capfd):
    assert is_alive(hand)
    for key in sorted({*keys_of_pyvista(hand.plotter)} - {*CLOSING}):
        hand.press(key)
        assert is_alive(hand), key
    assert "Traceback" not in capfd.readouterr().err


def test_a_key_that_is_given_back_is_pyvistas(hand):
    plotter, haptics = hand.plotter, hand.haptics
    called = []
    plotter.iren.clear_events_for_key("y", raise_on_missing=False)
    plotter.add_key_event("y", lambda: called.append("y"))
    assert begin(hand)
    assert haptics.style.SetKey("Compare", "")
    hand.press("y")
    assert called == ["y"]
    assert haptics.style.SetKey("Compare", "y")
    hand.press("y")
    assert called == ["y"]
    haptics.close()
    hand.press("y")
    assert called == ["y", "y"]
