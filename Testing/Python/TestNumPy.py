# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A NumPy array is touched in place; the results are NumPy arrays that agree with the closed form."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from volumehaptics import vtkVolumeHapticsFilter


def make_image(volume, spacing=(1.0, 1.0, 1.0), origin=(0.0, 0.0, 0.0)):
    """Returns an image that shares the memory of volume[z, y, x]."""
    image = vtkImageData()
    image.SetDimensions(volume.shape[::-1])
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    image.GetPointData().SetScalars(numpy_to_vtk(volume.reshape(-1)))
    return image


def make_path(points):
    path = vtkPolyData()
    path.SetPoints(vtkPoints())
    path.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    return path


def touch(image, points, **settings):
    haptics = vtkVolumeHapticsFilter()
    haptics.SetInputData(image)
    haptics.SetPathData(make_path(points))
    for name, value in settings.items():
        getattr(haptics, name)(value)
    haptics.Update()
    return haptics


def array(haptics, name):
    return vtk_to_numpy(haptics.GetOutput().GetPointData().GetArray(name))


def press(ticks, x=8.0, y=8.0, z=10.0):
    """Returns a path from z on, by 0.1 mm a tick."""
    points = np.tile([x, y, z], (ticks, 1))
    points[:, 2] += 0.1 * np.arange(ticks)
    return points


def slab(dtype=float):
    z = np.arange(32).reshape(-1, 1, 1)
    return np.broadcast_to(100.0 * z, (32, 17, 17)).astype(dtype)


def test_press_to_10_mm():
    """T1: 1 N at 2 mm, 2 N at 4 mm and on to 10 mm, with the proxy at 6 mm."""
    for dtype in (float, np.float32, np.int16, np.uint16, np.int32):
        haptics = touch(make_image(slab(dtype)), press(101))
        force = array(haptics, "Force")
        assert force.shape == (101, 3) and force.dtype == np.float64
        depth = 1e-4 * np.arange(101)
        expected = np.minimum(500.0 * depth, 2.0)
        assert np.abs(force[:, 2] + expected).max() < 1e-9, dtype
        assert np.abs(force[:, :2]).max() < 1e-9
        proxy = vtk_to_numpy(haptics.GetOutput().GetPoints().GetData())
        assert abs(proxy[-1, 2] - 16.0) < 1e-9
        assert np.abs(array(haptics, "NormalForce") - expected).max() < 1e-9
        contact = array(haptics, "Contact")
        assert contact.dtype == np.uint8
        assert contact[0] == 0 and contact[20] in (1, 2) and contact[60] == 3
        # Without an array Time, every point is a tick at 1 kHz, so the interval is 1 ms.
        assert np.abs(array(haptics, "Time") - 1e-3 * np.arange(101)).max() < 1e-12


def test_geometry():
    """The same slab, with other voxels at another place, is pressed from the other side."""
    z = 3.0 * np.arange(20).reshape(-1, 1, 1) - 7.0
    volume = np.broadcast_to(-40.0 * z, (20, 9, 11)).copy()
    image = make_image(volume, spacing=(2.0, 2.5, 3.0), origin=(-5.0, 4.0, -7.0))
    points = press(51, x=5.0, y=14.0)[:, :] * [1, 1, -1] + [0, 0, 40.0]
    haptics = touch(image, points)
    assert np.abs(array(haptics, "Normal")[1:] - [0, 0, -1]).max() < 1e-9
    assert np.abs(array(haptics, "GradientMagnitude")[1:] - 40.0).max() < 1e-9
    assert abs(array(haptics, "Force")[30, 2] - 1.5) < 1e-9


def test_in_place():
    """The image shares the array's memory, and the filter shares the image's."""
    volume = slab()
    image = make_image(volume)
    haptics = touch(image, press(11))
    assert array(haptics, "Value")[0] == 1000.0
    volume *= 2.0
    image.GetPointData().GetScalars().Modified()
    haptics.Update()
    assert array(haptics, "Value")[0] == 2000.0


def test_settings():
    limited = touch(make_image(slab()), press(61), SetMaximumForce=0.5)
    assert np.abs(array(limited, "Force")).max() <= 0.5
    field = touch(make_image(slab()), press(11), SetMethod=1, SetForceFieldGain=0.01)
    assert np.abs(array(field, "Force")[1:] - [0, 0, -1.0]).max() < 1e-9
