# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input of add_haptics() gives an error that names the input and the cure, and leaves the plotter unchanged."""

import numpy as np
import pytest
import pyvista as pv
from volumehaptics import vtkHapticDevice, vtkHapticProperty
from volumehaptics.pyvista import add_haptics


@pytest.fixture
def plotter(window):
    made = pv.Plotter(off_screen=True)
    yield made
    made.close()


def grid(values=None):
    made = pv.ImageData(dimensions=(9, 9, 9))
    made["value"] = 100.0 * made.points[:, 2] if values is None else values
    return made


def refused(kind, text, plotter, *arguments, **settings):
    style = plotter.iren.style
    with pytest.raises(kind, match=text):
        add_haptics(plotter, *arguments, **settings)
    assert plotter.iren.style is style


def test_no_plotter():
    with pytest.raises(TypeError, match="pyvista.Plotter, not to PolyData"):
        add_haptics(pv.Sphere(), grid())


def test_closed_plotter(plotter):
    plotter.close()
    with pytest.raises(ValueError, match="closed. Cure: make a new one"):
        add_haptics(plotter, grid())


def test_no_volume_or_several(plotter):
    plotter.add_mesh(pv.Sphere())
    refused(ValueError, r"no volume. Cure: .*add_volume", plotter)
    plotter.add_volume(grid(), name="one")
    plotter.add_volume(grid(), name="two")
    refused(ValueError, "2 volumes: one, two", plotter, visibility=False)


def test_twice(plotter):
    add_haptics(plotter, grid())
    refused(ValueError, r"already. Cure: close\(\)", plotter, grid())


def test_what_is_no_image(plotter):
    unstructured = plotter.add_volume(grid().cast_to_unstructured_grid())
    refused(TypeError, "not UnstructuredGrid. Cure: give the grid itself", plotter, unstructured)
    refused(TypeError, "not ndarray", plotter, np.zeros((3, 3, 3)))


def test_colours(plotter):
    colours = plotter.add_volume(grid(np.zeros((729, 4), np.uint8)), scalars="value")
    refused(ValueError, "4 components, such as colours", plotter, colours)
    one = vtkHapticProperty()
    one.SetComponent(3)
    add_haptics(plotter, colours, property=one)


def test_no_scalars(plotter):
    empty = pv.ImageData(dimensions=(9, 9, 9))
    refused(ValueError, "no active point scalars", plotter, empty)


def test_settings(plotter):
    refused(TypeError, "kernel_radius", plotter, grid(), kernel_radii=3)
    refused(ValueError, "MRT", plotter, grid(), "MRT")
    refused(TypeError, "not both", plotter, grid(), "MRI", property=vtkHapticProperty())
    refused(ValueError, "image", plotter, grid(), kernel_radius=6)


def test_device(plotter):
    refused(RuntimeError, "nothing", plotter, grid(), device="nothing")
    closed = vtkHapticDevice()
    refused(ValueError, "Open", plotter, grid(), device=closed)
    assert not closed.HasObserver("ErrorEvent")  # errors of the user's own device still reach the user
