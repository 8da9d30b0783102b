# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests add_haptics(..., tool=...): a needle, a burr and a mesh in the hand, in a window with its mouse and keys."""

import math

import pytest
import pyvista as pv
from volumehaptics import vtkHapticBurr, vtkHapticNeedle, vtkHapticPointShell


def test_a_needle_goes_in_and_comes_out(hands, window):
    hand = hands(tool=vtkHapticNeedle())
    assert hand.haptics.device.GetVolumeHaptics().GetTool().IsA("vtkHapticNeedle")
    strength = hand.device.GetVolumeHaptics().GetProperty().GetSurfaceStrength()
    strength.RemoveAllPoints()
    strength.AddPoint(0.0, 0.5)  # N, the force that punctures the ball
    hand.push(steps=6)
    hand.wait(lambda: hand.device.GetState().GetNeedleDepth() > 0.5)
    track = pv.PolyData()

    def has_track():
        hand.device.GetState().GetNeedleTrack(track)
        return track.GetNumberOfLines() >= 1

    hand.wait(has_track)  # the track belongs to the tick before the latest state
    assert track.field_data["Depth"][0] > 0.5
    assert "ForbiddenTouches" in track.field_data
    for _ in range(12):
        hand.plotter.iren.interactor.MouseWheelBackwardEvent()
    hand.wait(lambda: hand.device.GetState().GetNeedleDepth() == 0.0)


def test_a_burr_drills_while_the_left_button_is_pressed(hands, window):
    burr = vtkHapticBurr()
    burr.SetRadius(8.0)
    burr.SetSolidToAbove()
    burr.SetContactValue(0.0)
    burr.GetSpecificEnergy().AddPoint(0.0, 0.05)  # J/mm^3: soft
    hand = hands(tool=burr)
    removal = hand.device.GetVolumeHaptics().GetRemoval()
    hand.push()
    assert removal.IsEmpty()
    interactor = hand.plotter.iren.interactor
    interactor.LeftButtonPressEvent()
    hand.wait(lambda: removal.GetRemovedVolume() > 1.0)
    interactor.LeftButtonReleaseEvent()
    hand.wait(lambda: not hand.device.GetState().IsSpinning())
    removed = removal.GetRemovedVolume()
    assert removal.Undo()
    hand.wait(lambda: removal.GetRemovedVolume() < removed)


@pytest.mark.parametrize("kind", ["mesh", "file"])
def test_a_shape_is_felt_with_its_size(hands, window, tmp_path, kind):
    radius = 6.0
    mesh = pv.Sphere(radius=radius)
    tool = mesh
    if kind == "file":
        tool = tmp_path / "ball.stl"
        mesh.save(tool)
    hand = hands(tool=tool)
    shell = hand.device.GetVolumeHaptics().GetTool()
    assert isinstance(shell, vtkHapticPointShell)
    shell.SetSolidToAbove()
    shell.SetContactValue(0.0)
    hand.push()
    # The ball of 20 mm stops the tool's ball: the distance of their centres is the sum of both radii, less the depth of
    # the press.
    apart = math.dist(hand.device.GetState().GetProxyPosition(), (0.0, 0.0, 0.0))
    assert 20.0 + radius - 3.0 < apart < 20.0 + radius + 2.0
    assert abs(math.sqrt(sum(x * x for x in hand.device.GetState().GetToolOrientation())) - 1.0) < 1e-9
