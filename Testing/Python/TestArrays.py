# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK uses NumPy's memory and NumPy uses VTK's; the memory stays as long as either side holds it."""

import gc
import weakref

import numpy as np
import pytest
from vtkmodules import vtkCommonCore
from vtkmodules.util.numpy_support import vtk_to_numpy
from volumehaptics import image, path, touch, vtkVolumeHapticsFilter
from volumehaptics.arrays import arrays

REAL = ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8")


def scalars(volume):
    return vtk_to_numpy(volume.GetPointData().GetScalars())


def ramp(dtype=np.float64, shape=(16, 12, 10)):
    """Returns V = 7 z, whose values fit into every type."""
    return np.broadcast_to(7 * np.arange(shape[0]).reshape(-1, 1, 1), shape).astype(dtype)


@pytest.mark.parametrize("dtype", REAL)
def test_image_shares_memory(dtype):
    array = ramp(dtype)
    volume = image(array, spacing=(0.5, 1.0, 2.0), origin=(-1.0, 2.0, 3.0), name="HU")
    assert volume.GetDimensions() == (10, 12, 16)
    assert volume.GetSpacing() == (0.5, 1.0, 2.0) and volume.GetOrigin() == (-1.0, 2.0, 3.0)
    assert volume.GetPointData().GetScalars().GetName() == "HU"
    assert np.shares_memory(scalars(volume), array) and scalars(volume).dtype == array.dtype
    array[3, 4, 5] = 99
    assert volume.GetScalarComponentAsDouble(5, 4, 3, 0) == 99.0
    # A spring of 500 N/m that the ramp compresses by 1 mm exerts 0.5 N.
    trace = touch(image(ramp(dtype)), [(5.0, 6.0, 6.0), (5.0, 6.0, 7.0)])
    assert abs(arrays(trace)["Force"][1, 2] + 0.5) < 1e-6


@pytest.mark.parametrize("is_rendered", (False, True))
def test_components_in_memory_of_their_own_are_felt(is_rendered):
    """VTK 9.6 keeps such components in one memory while the array is new, and again after a mapper has asked for a
    pointer."""
    if not hasattr(vtkCommonCore, "vtkSOATypeFloat64Array"):
        pytest.skip(f"VTK {vtkCommonCore.vtkVersion.GetVTKVersion()} has no such arrays in Python; 9.6 has")
    expected = ramp().reshape(-1)
    scalars = vtkCommonCore.vtkSOATypeFloat64Array()
    scalars.SetNumberOfComponents(2)
    parts = [np.zeros(len(expected)), expected.copy()]
    if is_rendered:
        for component, part in enumerate(parts):
            scalars.SetArray(component, part, len(part), True, True, 0)
    else:
        scalars.SetNumberOfTuples(len(expected))
        for i, value in enumerate(expected):
            scalars.SetTuple2(i, 0.0, value)
    volume = image(ramp())
    volume.GetPointData().SetScalars(scalars)
    haptics = vtkVolumeHapticsFilter()
    haptics.SetInputData(0, volume)
    haptics.SetPathData(path([(5.0, 6.0, 6.0), (5.0, 6.0, 7.0)]))
    haptics.GetProperty().SetComponent(1)
    for _ in range(2):
        haptics.Modified()
        haptics.Update()
        assert abs(arrays(haptics.GetOutput())["Force"][1, 2] + 0.5) < 1e-6
        if is_rendered:
            # Request a pointer, as a mapper does. Afterwards, VTK 9.6 stores the components in a different buffer.
            scalars.GetVoidPointer(0)


def test_image_of_a_file_that_is_only_read(tmp_path):
    np.save(tmp_path / "ramp.npy", ramp())
    array = np.load(tmp_path / "ramp.npy", mmap_mode="r")
    assert np.shares_memory(scalars(image(array)), array)


def test_memory_lives_as_long_as_the_image():
    array = ramp()
    expected, memory = array.copy(), weakref.ref(array)
    volume = image(array)
    copy = volume.NewInstance()
    copy.ShallowCopy(volume)
    del array, volume
    gc.collect()
    assert memory() is not None
    assert (scalars(copy).reshape(expected.shape) == expected).all()
    del copy
    # VTK frees unused memory when the next object is deleted.
    image(ramp())
    gc.collect()
    assert memory() is None


@pytest.mark.parametrize("spoil, error, word", (
    (lambda a: a[::2], ValueError, "np.ascontiguousarray"),
    (lambda a: a.T, ValueError, "array.T if its axes are [x, y, z]"),
    (lambda a: a[0], ValueError, "(12, 10)"),
    (lambda a: a[:0], ValueError, "(0, 12, 10)"),
    (lambda a: a.astype(complex), TypeError, "complex128"),
    (lambda a: a.astype(bool), TypeError, "astype"),
    (lambda a: a.astype(np.float16), TypeError, "float16"),
    (lambda a: a.astype(np.dtype("f8").newbyteorder()), TypeError, "astype"),
    (lambda a: a.tolist(), TypeError, "list"),
    (lambda a: np.ma.masked_less(a, 20.0), ValueError, "masked"),
    (lambda a: np.ndarray(a.shape, a.dtype, bytearray(a.nbytes + 1), 1), ValueError, "aligned"),
))
def test_what_is_no_volume(spoil, error, word):
    with pytest.raises(error) as caught:
        image(spoil(ramp()))
    assert word in str(caught.value)


@pytest.mark.parametrize("dtype", ("f4", "f8"))
def test_path_shares_memory(dtype):
    points = np.linspace((0, 0, 9), (0, 0, 5), 41).astype(dtype)
    time = np.linspace(0.0, 0.04, 41)
    tip = path(points, time)
    shared = vtk_to_numpy(tip.GetPoints().GetData())
    assert np.shares_memory(shared, points) and shared.dtype == points.dtype
    assert np.shares_memory(vtk_to_numpy(tip.GetPointData().GetArray("Time")), time)
    assert tip.GetNumberOfCells() == 1 and tip.GetCell(0).GetNumberOfPoints() == 41
    assert tip.GetCell(0).GetPointId(40) == 40
    memory, expected = weakref.ref(points), points.copy()
    del points, shared
    gc.collect()
    assert memory() is not None and (vtk_to_numpy(tip.GetPoints().GetData()) == expected).all()


@pytest.mark.parametrize("points", (
    [(1, 2, 3), (4, 5, 6)], np.arange(12.0).reshape(4, 3)[::2], np.ndarray((4, 3), float, bytearray(97), 1)))
def test_path_copies_what_can_not_be_shared(points):
    tip = path(points)
    copied = vtk_to_numpy(tip.GetPoints().GetData())
    assert (copied == np.array(points)).all() and copied.flags.aligned


@pytest.mark.parametrize("points, time, error", (
    (np.zeros((4, 2)), None, ValueError),
    (np.zeros(3), None, ValueError),
    (np.zeros((0, 3)), None, ValueError),
    (np.zeros((4, 3)), np.zeros(3), ValueError),
    (np.zeros((4, 3), complex), None, TypeError),
    (np.ma.masked_equal(np.eye(3), 0.0), None, ValueError),
    ([("a", "b", "c")], None, TypeError),
))
def test_what_is_no_path(points, time, error):
    with pytest.raises(error):
        path(points, time)


def test_arrays_share_the_memory_of_the_trace_and_outlive_it():
    trace = touch(ramp(), np.linspace((5, 6, 5), (5, 6, 8), 31))
    found = arrays(trace)
    assert np.shares_memory(found["Force"], vtk_to_numpy(trace.GetPointData().GetArray("Force")))
    assert found["Proxy"].shape == found["Force"].shape == (31, 3) and found["Contact"].dtype == np.uint8
    copies = {name: array.copy() for name, array in found.items()}
    assert len(copies) == trace.GetPointData().GetNumberOfArrays() + 1
    del trace
    gc.collect()
    assert all((found[name] == copies[name]).all() for name in copies)
