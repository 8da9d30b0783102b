# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""touch() of volumehaptics.pyvista takes and returns PyVista's data, with the values of the plain touch() and its
errors."""

import doctest

import numpy as np
import pytest
import pyvista as pv
import volumehaptics
import volumehaptics.pyvista
from volumehaptics.pyvista import touch

LINE = np.linspace((0, -120, 60), (0, -70, 60), 501)
PRESS = np.linspace((7, 7, 5), (7, 7, 8), 301)  # into the ramp


def ramp():
    """Returns V = 100 z on 16^3 voxels of 1 mm."""
    grid = pv.ImageData(dimensions=(16, 16, 16))
    grid["value"] = 100.0 * grid.points[:, 2]
    return grid


def test_documentation():
    tried = doctest.testmod(volumehaptics.pyvista)
    assert tried.attempted > 0 and tried.failed == 0


@pytest.mark.parametrize("tip", (LINE, pv.Line(pointa=LINE[0], pointb=LINE[-1], resolution=500)), ids=type)
def test_trace_is_that_of_the_package(head, tip):
    trace = touch(head, tip, "CT contrast", kernel_radius=3)
    points = tip.points if isinstance(tip, pv.PolyData) else tip
    other = pv.wrap(volumehaptics.touch(head, np.array(points), preset="CT contrast", kernel_radius=3))
    assert isinstance(trace, pv.PolyData) and trace.n_points == 501
    assert (trace["Force"] == other["Force"]).all() and abs(trace["Force"]).max() > 0.1


def test_force_is_that_of_the_spring():
    # With the defaults (500 N/m, at most 2 N), a stretch of 3 mm results in 1.5 N against the hand.
    trace = touch(ramp(), PRESS)
    assert abs(trace["Force"][-1] - (0, 0, -1.5)).max() < 1e-3


def test_spline_with_time_has_a_point_a_tick():
    spline = pv.Spline([(4, 7, 5), (7, 7, 8), (10, 7, 5)], 50)
    spline["Time"] = spline["arc_length"].astype(float) / 40
    trace = touch(ramp(), spline)
    assert abs(trace.n_points - 1000 * spline["arc_length"][-1] / 40) <= 2


def test_volume_is_not_copied_nor_changed():
    grid = ramp()
    before = grid["value"].copy()
    touch(grid, PRESS)
    assert (grid["value"] == before).all() and grid.array_names == ["value"]


def test_array_is_chosen():
    grid = ramp()
    grid["nothing"] = np.zeros(grid.n_points)
    grid.set_active_scalars("nothing")
    assert not touch(grid, PRESS)["Force"].any()
    assert touch(grid, PRESS, scalars="value")["Force"][-1][2] < -1.0
    with pytest.raises(KeyError, match="'none'.*'value'.*'nothing'"):
        touch(grid, PRESS, scalars="none")


def test_cell_data_are_refused_with_the_cure():
    cells = pv.ImageData(dimensions=(16, 16, 16))
    cells.cell_data["value"] = np.zeros(cells.n_cells)
    with pytest.raises(ValueError, match="cell_data_to_point_data"):
        touch(cells, PRESS)
    assert touch(cells.cell_data_to_point_data(), PRESS).n_points == len(PRESS)


def test_other_errors_are_those_of_the_package(head):
    with pytest.raises(ValueError, match="no such preset|preset"):
        touch(head, LINE, "MRT")
    with pytest.raises(TypeError, match="kernel_radius"):
        touch(head, LINE, kernel_radii=3)
