# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""touch() gives the same trace as the filter, with settings by name and errors as exceptions."""

import contextlib
import gc
import types
import weakref

import compare_traces
import numpy as np
import pytest
from vtkmodules.vtkCommonDataModel import vtkPolyData
from volumehaptics import examples, image, path, touch, vtkHapticProperty, vtkVolumeHapticsFilter
from volumehaptics.arrays import arrays


@pytest.fixture(scope="module")
def head():
    return examples.phantom()


@pytest.fixture(scope="module")
def tip():
    return examples.stroke()


def test_is_the_filter_to_the_bit(head, tip):
    haptics = vtkVolumeHapticsFilter()
    haptics.SetInputData(head)
    haptics.SetPathData(tip)
    haptics.GetProperty().ApplyPreset("CT contrast")
    haptics.SetKernelRadius(3)
    haptics.SetSolverToPaper()
    haptics.SetMetersPerWorldUnit(0.002)
    haptics.Update()
    trace = touch(
        head, tip, "CT contrast", kernel_radius=3, solver=vtkVolumeHapticsFilter.PAPER, meters_per_world_unit=0.002)
    assert arrays(trace)["Force"].any()
    assert not compare_traces.compare(trace, haptics.GetOutput())
    assert compare_traces.compare(trace, touch(head, tip, "CT contrast"))


@pytest.mark.parametrize("last", (7.0, np.nan))
def test_the_volume_goes_with_the_trace(last):
    """The volume is freed together with the trace, without Python's garbage collector: otherwise a few volumes in a row
    would fill the memory."""
    gc.disable()
    try:
        volume = np.zeros((9, 9, 9))
        memory = weakref.ref(volume)
        with contextlib.suppress(ValueError):
            touch(volume, [(5.0, 5.0, last)])
        del volume
        touch(np.zeros((9, 9, 9)), [(5.0, 5.0, 5.0)])  # VTK frees unused memory when the next object is deleted
        assert memory() is None
    finally:
        gc.enable()


def test_takes_arrays():
    """V = 100 z, 500 N/m: 1 N at 2 mm."""
    volume = np.broadcast_to(100.0 * np.arange(32).reshape(-1, 1, 1), (32, 17, 17)).copy()
    points = np.linspace((8, 8, 10), (8, 8, 12), 21)
    for given in (points, points.tolist(), path(points)):
        assert abs(arrays(touch(volume, given))["Force"][-1] - [0, 0, -1]).max() < 1e-9


@pytest.mark.parametrize("kind", ("_vtk_obj", "dataset"))
def test_takes_what_wraps_a_data_set(head, tip, kind):
    """Wraps the data set as tvtk (Mayavi) and vedo do."""
    trace = touch(types.SimpleNamespace(**{kind: head}), tip, "CT contrast")
    assert not compare_traces.compare(trace, touch(head, tip, "CT contrast"))


def test_takes_volumes_of_nibabel():
    """Takes [x, y, z] of any byte order, and an affine: here V = 100 world z, with x mirrored. 500 N/m gives 1 N at 2
    mm."""
    values = np.broadcast_to(200.0 * np.arange(16), (17, 17, 16)).astype(">i2")
    affine = np.array([[-1.0, 0, 0, 16], [0, 1, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]])
    points = np.linspace((8, 8, 10), (8, 8, 12), 21)
    scan = types.SimpleNamespace(dataobj=values, affine=affine)
    assert abs(arrays(touch(scan, points))["Force"][-1] - [0, 0, -1]).max() < 1e-9
    moving = types.SimpleNamespace(dataobj=np.stack((values, values), axis=3), affine=affine)
    with pytest.raises(ValueError, match=r"Cure: one of its times, volume\.slicer\[\.\.\., 0\]"):
        touch(moving, points)
    moving.dataobj = moving.dataobj[..., 0]  # as slicer does
    assert abs(arrays(touch(moving, points))["Force"][-1] - [0, 0, -1]).max() < 1e-9


def test_a_volume_that_fills_its_image_has_no_outer_wall():
    """A layer of air, one voxel wide, gives the volume a wall, as Documentation/window.md describes."""
    full = np.full((24, 24, 24), 1000.0)
    points = np.linspace((12, 12, -5), (12, 12, 12), 400)
    assert not arrays(touch(full, points))["Force"].any()
    walled = image(np.pad(full, 1, constant_values=-1000), origin=(-1, -1, -1))
    assert np.linalg.norm(arrays(touch(walled, points))["Force"], axis=1).max() > 0.5


def test_a_tuple_is_several_arguments(head, tip):
    name = head.GetPointData().GetScalars().GetName()
    trace = touch(head, tip, input_array_to_process=(0, 0, 0, 0, name))
    assert trace.GetNumberOfPoints() == touch(head, tip).GetNumberOfPoints()
    with pytest.raises(ValueError, match="nothing"):
        touch(head, tip, input_array_to_process=(0, 0, 0, 0, "nothing"))


def test_method_and_property(head, tip):
    soft = vtkHapticProperty()
    soft.GetStiffness().AddPoint(0.0, 50.0)
    trace = touch(head, tip, property=soft, method_by_name="paper")
    assert (arrays(trace)["Stiffness"] == 50.0).all()
    with pytest.raises(TypeError, match="ApplyPreset"):
        touch(head, tip, "MRI", property=soft)


@pytest.mark.parametrize("name, close", (
    ("kernel_radus", "kernel_radius"),
    ("KernelRadius", "kernel_radius"),
    ("maximumforce", "maximum_force"),
    ("isovalue", "iso_value"),
    ("stiffness", "p.GetStiffness()"),
))
def test_unknown_setting(head, tip, name, close):
    with pytest.raises(TypeError, match=f"'{name}'") as caught:
        touch(head, tip, **{name: 1})
    assert close in str(caught.value)


@pytest.mark.parametrize("setting, said", (
    ({"kernel_radius": "three"}, r"kernel_radius='three' .*SetKernelRadius\("),
    ({"kernel_radius": 2.5}, r"kernel_radius=2.5 .*SetKernelRadius\("),
    ({"method": "paper"}, "method_by_name='paper'"),
    ({"solver": "paper"}, "solver=vtkVolumeHapticsFilter.PAPER"),
))
def test_setting_of_the_wrong_type(head, tip, setting, said):
    with pytest.raises(TypeError, match=said):
        touch(head, tip, **setting)


@pytest.mark.parametrize("name, value, nearest", (("kernel_radius", 50, 16), ("maximum_force", -1.0, 0.0)))
def test_number_out_of_range(head, tip, name, value, nearest):
    """The filter itself clamps the number silently."""
    with pytest.raises(ValueError, match=f"{name}={value} is out of range.* {nearest}$"):
        touch(head, tip, **{name: value})


def test_way_outside_of_the_volume(head, tip, recwarn):
    touch(head, tip)
    assert not [warning for warning in recwarn if warning.category is UserWarning]
    with pytest.warns(UserWarning, match="5000 to 5000.* outside .*-118.125 to 118.125") as warned:
        trace = touch(head, [(0.0, 0.0, 5000.0)])
    assert not arrays(trace)["Force"].any()
    assert [warning.filename for warning in warned if warning.category is UserWarning] == [__file__]


@pytest.mark.parametrize("word, arguments, settings", (
    ('"bones"', {"preset": "bones"}, {}),
    ('"touching"', {}, {"method_by_name": "touching"}),
    ("NaN", {"tip": [(0.0, 0.0, np.nan)]}, {}),
    ("scalars", {"volume": type(examples.phantom())()}, {}),
))
def test_errors_of_the_filter(head, tip, capfd, word, arguments, settings):
    with pytest.raises(ValueError) as caught:
        touch(**{"volume": head, "tip": tip, **arguments}, **settings)
    assert word in str(caught.value) and ".cxx" not in str(caught.value)
    assert capfd.readouterr().err == ""


def test_a_file_that_is_not_there(tip):
    with pytest.raises(ValueError, match="there is no such file|there is no volumehaptics-explore"):
        touch("head.vti", tip)


@pytest.mark.parametrize("volume, cure", (
    (None, "$"),
    ([[[1.0]]], "$"),
    (vtkVolumeHapticsFilter(), r"GetOutput\(\)"),
    (vtkPolyData(), "$"),
))
def test_what_is_no_volume(tip, volume, cure):
    with pytest.raises(TypeError, match=f"{type(volume).__name__}.*{cure}"):
        touch(volume, tip)
