# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures that error texts of add_haptics() name: V = 100 z is pressed 2 mm deep from z = 3 on; 500 N/m give 1
N."""

import numpy as np
import pytest
import pyvista as pv
from volumehaptics import vtkHapticDevice, vtkHapticProperty
from volumehaptics.arrays import arrays
from volumehaptics.pyvista import add_haptics, touch
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData


def grid(shift=0.0, values=None):
    made = pv.ImageData(dimensions=(9, 9, 9), origin=(shift, 0, 0))
    made["value"] = 100.0 * made.points[:, 2] if values is None else values
    return made


def cells():
    made = pv.ImageData(dimensions=(10, 10, 10), origin=(-0.5, -0.5, -0.5))
    made.cell_data["value"] = 100.0 * made.cell_centers().points[:, 2]
    return made


PRESS = np.linspace((4.0, 4.0, 3.0), (4.0, 4.0, 5.0), 21)


def force(haptics):
    points, path = vtkPoints(), vtkPolyData()
    for point in PRESS:
        points.InsertNextPoint(*point)
    path.SetPoints(points)
    haptics.filter.SetPathData(path)
    haptics.filter.Update()
    return -arrays(haptics.filter.GetOutput())["Force"][-1][2]


def in_a_new_one():
    plotter = pv.Plotter(off_screen=True)
    return plotter, grid()


def closed(plotter):
    plotter.close()
    return lambda: add_haptics(plotter, grid()), [lambda: add_haptics(*in_a_new_one())]


def none(plotter):
    return lambda: add_haptics(plotter), [lambda: add_haptics(plotter, plotter.add_volume(grid()))]


def several(plotter):
    one = plotter.add_volume(grid(), name="one")
    plotter.add_volume(grid(), name="two")
    return lambda: add_haptics(plotter, visibility=False), [lambda: add_haptics(plotter, one, visibility=False)]


def twice(plotter):
    first = add_haptics(plotter, grid())

    def cure():
        first.close()
        return add_haptics(plotter, grid())
    return lambda: add_haptics(plotter, grid()), [cure]


def actor_of_a_grid(plotter):
    one = grid().cast_to_unstructured_grid()
    actor = plotter.add_volume(one)
    return lambda: add_haptics(plotter, actor), [lambda: add_haptics(plotter, one)]


def one_frame(plotter):
    return lambda: add_haptics(plotter, [grid()]), [lambda: add_haptics(plotter, grid())]


def times(plotter):
    return lambda: add_haptics(plotter, grid(), times=[0, 1]), [lambda: add_haptics(plotter, [grid(), grid()], times=[0, 1])]


def other_frames(plotter):
    fine = pv.ImageData(dimensions=(17, 17, 17), spacing=(0.5, 0.5, 0.5))
    fine["value"] = 100.0 * fine.points[:, 2]
    return lambda: add_haptics(plotter, [grid(), fine]), [lambda: add_haptics(plotter, [grid(), grid().sample(fine)])]


def no_scalars(plotter):
    bare, celled = grid(), cells()
    bare.point_data.set_scalars(bare["value"], "value")
    bare.GetPointData().SetActiveScalars(None)

    def activate():
        bare.set_active_scalars("value")
        return add_haptics(plotter, bare)
    return lambda: add_haptics(plotter, bare), [activate, lambda: add_haptics(pv.Plotter(off_screen=True), celled.cells_to_points())]


def colours(plotter):
    values = np.repeat(grid()["value"][:, None], 3, axis=1)
    one = vtkHapticProperty()
    one.SetComponent(0)
    return lambda: add_haptics(plotter, grid(values=values)), [lambda: add_haptics(plotter, grid(values=values), property=one)]


def two_hands_on_frames(plotter):
    second = vtkHapticDevice()
    assert second.Open("virtual")
    hands = ["virtual", second]
    return lambda: add_haptics(plotter, [grid(), grid()], device=hands), [
        lambda: add_haptics(plotter, [grid(), grid()], device="virtual"),
        lambda: add_haptics(pv.Plotter(off_screen=True), grid(), device=hands)]


CASES = {
    "Cure: give one device": two_hands_on_frames,
    "the plotter is closed. Cure: make a new one": closed,
    "Cure: add_haptics(plotter, plotter.add_volume(image))": none,
    "Cure: give the one to be touched, as plotter.add_volume() returned it": several,
    "Cure: close() what add_haptics() has returned before": twice,
    "Cure: give the grid itself instead of its actor": actor_of_a_grid,
    "Cure: give one image alone, not in a list": one_frame,
    "Cure: add_haptics(plotter, [first, second, ...], times)": times,
    "Cure: frame.sample() of the others on one grid": other_frames,
    "Cure: image.set_active_scalars(NAME), or image.cells_to_points() if it has cell data": no_scalars,
    "Cure: property=p, where p.SetComponent(0) of a vtkHapticProperty says which": colours,
}


def test_cells_are_made_points():
    with pytest.raises(ValueError) as caught:
        touch(cells(), PRESS)
    assert "Cure: volume.cell_data_to_point_data(), or volume.cells_to_points(), which copies nothing" in str(caught.value)
    for cured in cells().cell_data_to_point_data(), cells().cells_to_points():
        assert -arrays(touch(cured, PRESS))["Force"][-1][2] == pytest.approx(1.0, abs=0.02)


@pytest.mark.parametrize("words", CASES)
def test_cures(window, words):
    plotter = pv.Plotter(off_screen=True)
    wrong, cures = CASES[words](plotter)
    with pytest.raises((TypeError, ValueError)) as caught:
        wrong()
    assert words in str(caught.value)
    for cure in cures:
        haptics = cure()
        assert force(haptics) == pytest.approx(1.0, abs=1e-6)
        haptics.close()
    plotter.close()
