# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests functions that are proposed from the image, from Python."""

import math

import numpy as np
import pytest
from volumehaptics import touch, vtkHapticProperty, vtkVolumeHapticsFilter
from volumehaptics.arrays import arrays, image

SIZE = 64
MIDDLE = 0.5 * (SIZE - 1)


@pytest.fixture(scope="module")
def ball():
    """Returns a ball of value 0.75, blurred by a Gaussian of 2 voxels, in air of 0.25: V1 + (V2 - V1) Phi(x/s)."""
    axis = np.arange(SIZE) - MIDDLE
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    depth = 20.0 - np.sqrt(x * x + y * y + z * z)
    return (0.25 + 0.25 * (1.0 + np.vectorize(math.erf)(depth / (2.0 * math.sqrt(2.0))))).astype(np.float32)


@pytest.fixture
def stroke():
    """Returns a path from the border towards the middle of the ball."""
    way = np.full((1000, 3), MIDDLE)
    way[:, 2] = np.linspace(1.0, MIDDLE - 14.0, len(way))
    return way


def test_boundaries_are_a_table(ball):
    feel = vtkHapticProperty()
    assert feel.GetProposedBoundaries() is None and feel.GetProposedKernelRadius() == 0
    assert feel.ProposeFromImage(image(ball)) is True
    table = feel.GetProposedBoundaries()
    assert table.GetNumberOfRows() == 1
    row = {table.GetColumnName(i): table.GetValue(0, i).ToDouble() for i in range(table.GetNumberOfColumns())}
    assert row["Low"] == pytest.approx(0.25, abs=0.01)
    assert row["High"] == pytest.approx(0.75, abs=0.01)
    assert row["Width"] == pytest.approx(2.0, rel=0.05)
    assert row["Share"] == pytest.approx(1.0)
    # A kernel of this radius blurs like a complete Gaussian of half the radius.
    width = math.hypot(2.0, 0.5 * feel.GetProposedKernelRadius())
    assert row["Slope"] == pytest.approx(0.5 / (math.sqrt(2.0 * math.pi) * width), rel=0.05)


def test_touch_feels_the_ball(ball, stroke):
    trace = arrays(touch(ball, stroke, preset="propose", contact_alignment=vtkVolumeHapticsFilter.EDGE))
    outside = stroke[:, 2] < MIDDLE - 26.0
    assert not trace["Force"][outside].any()
    # At the end, the tip is 6 mm deep, which gives 3 N at 500 N/m.
    assert -trace["Force"][-1, 2] == pytest.approx(3.0, abs=0.6)
    assert not arrays(touch(ball * 0.0 + 1.0, stroke))["Force"].any()


def test_a_kernel_radius_of_the_caller_stays(ball, stroke):
    suggested = arrays(touch(ball, stroke, preset="propose"))["GradientMagnitude"]
    feel = vtkHapticProperty()
    feel.ProposeFromImage(image(ball))
    radius = feel.GetProposedKernelRadius()
    assert radius > 2
    same = arrays(touch(ball, stroke, preset="propose", kernel_radius=radius))["GradientMagnitude"]
    other = arrays(touch(ball, stroke, preset="propose", kernel_radius=2))["GradientMagnitude"]
    assert np.array_equal(suggested, same)
    assert not np.array_equal(suggested, other)


def test_nothing_to_propose(stroke, capfd):
    with pytest.raises(ValueError, match="everywhere: there are no edges"):
        touch(np.ones((16, 16, 16)), stroke, preset="propose")
    assert capfd.readouterr().err == ""
