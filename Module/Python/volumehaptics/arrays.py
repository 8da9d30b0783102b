# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""NumPy arrays as volumes and paths of the tip, and traces as NumPy arrays, without copies.

    volume = np.load("head.npy")                         # [z, y, x], Hounsfield units
    head = image(volume, spacing=(0.5, 0.5, 1.0))        # mm; shares the array's memory
    tip = path(np.linspace((64, -10, 40), (64, 40, 40), 1000))
    force = arrays(touch(head, tip, "CT contrast"))["Force"]    # N, of shape (1000, 3)

After changing an array that an image or a path shares, call Modified() of the image or the path to notify VTK. The
array stays alive as long as VTK's data do, and VTK's data as long as the arrays made of them.
"""

from __future__ import annotations

import os
from collections.abc import Sequence

try:
    import numpy as np
except ImportError as error:
    raise ImportError("volumehaptics.arrays needs NumPy. Cure: pip install numpy, or apt-get install python3-numpy.") \
        from error
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_SIGNED_CHAR, vtkDataArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkPolyData,
    vtkRectilinearGrid,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from ._touch import touch

__all__ = ["arrays", "image", "path", "touch"]

_REAL = ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64")


def _shared(array: np.ndarray, name: str | None = None) -> vtkDataArray:
    """Makes a VTK array that shares a contiguous array of one or two dimensions, and keeps it alive."""
    # Choose the type explicitly: by default, NumPy's int8 becomes VTK's plain char, which is unsigned on some machines.
    shared = numpy_to_vtk(array, array_type=VTK_SIGNED_CHAR if array.dtype == np.int8 else None)
    if name is not None:
        shared.SetName(name)
    return shared


def _cure(wrong: object) -> str:
    """Returns a hint on how to make a volume of another object; empty if there is no way."""
    if isinstance(wrong, (str, os.PathLike)):
        return (". Cure: volumehaptics-explore FILE --write-volume volume.vti writes it where it lies, which readers of VTK's "
                "and PyVista's do not all know; then read that with pyvista.read() or vtkXMLImageDataReader")
    if isinstance(wrong, vtkAlgorithm):
        return ". Cure: Update() it, and take its GetOutput()"
    if isinstance(wrong, (vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid)):
        return ". Cure: sample it on an image, such as with vtkResampleToImage or pyvista's image.sample(grid)"
    return ""


def image(
    array: np.ndarray,
    spacing: Sequence[float] = (1.0, 1.0, 1.0),
    origin: Sequence[float] = (0.0, 0.0, 0.0),
    name: str = "Scalars",
    direction: Sequence[float] | None = None,
) -> vtkImageData:
    """Makes a volume that shares the memory of a NumPy array [z, y, x].

    array: real numbers of 8 to 64 bits, in C's order. nibabel's arrays are [x, y, z]: pass their .T.
    spacing: the size of a voxel along x, y and z (world units, mm), each above 0.
    origin: the position of the first voxel (world units, mm): x, y and z.
    name: name of the point scalars.
    direction: nine numbers, row by row, whose columns are the directions of the array's x, y and z in the world, of any
        length: SimpleITK's GetDirection(), or nibabel's affine[:3, :3] with origin=affine[:3, 3]. Default: the world's.

    TypeError: no such array, or numbers of another kind. ValueError: not three dimensions, no voxels, masked ones,
    not contiguous and aligned, or an invalid spacing, origin or direction.

    >>> import numpy as np
    >>> from volumehaptics import image
    >>> image(np.zeros((30, 20, 10), np.int16), spacing=(0.5, 0.5, 2.0)).GetDimensions()
    (10, 20, 30)
    """
    if not isinstance(array, np.ndarray):
        wrong = f"{type(array).__name__}{_cure(array)}"
        raise TypeError(f"a volume is a vtkImageData or a NumPy array [z, y, x], not {wrong}")
    if array.dtype.name not in _REAL or not array.dtype.isnative:
        raise TypeError(f"a volume can't have numbers of type {array.dtype}. Cure: array.astype(np.float32)")
    if array.ndim != 3 or array.size == 0:
        raise ValueError(f"a volume has three dimensions [z, y, x], and voxels; this array's shape is {array.shape}")
    if np.ma.is_masked(array):
        raise ValueError("the array has masked voxels, which would be felt. Cure: array.filled(VALUE)")
    if not array.flags.c_contiguous:
        cure = "np.ascontiguousarray(array)"
        if abs(array.strides[0]) < abs(array.strides[2]):
            straight = "array.T" if array.T.flags.c_contiguous else "np.ascontiguousarray(array.T)"
            cure = f"{straight} if its axes are [x, y, z], as nibabel's are, and {cure} if they are [z, y, x]"
        raise ValueError(f"the array is not contiguous, so that it can't be shared. Cure: {cure}")
    if not array.flags.aligned:
        raise ValueError("the array's numbers are not aligned in memory, so that it can't be shared. Cure: "
                         "array.copy()")
    for what, three in (("spacing", spacing), ("origin", origin)):
        if np.shape(three) != (3,):
            raise ValueError(f"{what} is three numbers, along x, y and z, not {three!r}")
    volume = vtkImageData()
    volume.SetDimensions(array.shape[::-1])
    volume.SetSpacing(spacing)
    volume.SetOrigin(origin)
    if direction is not None:
        axes = np.array(direction, float).reshape(-1)
        lengths = np.linalg.norm(axes.reshape(3, 3), axis=0) if axes.size == 9 else np.zeros(3)
        axes = axes.reshape(3, 3) / lengths if lengths.all() else np.zeros((3, 3))
        if not abs(np.linalg.det(axes)) > 1e-6:
            raise ValueError(f"direction is nine numbers, whose columns are three different directions, not {direction!r}")
        volume.SetDirectionMatrix(axes.reshape(-1).tolist())
    volume.GetPointData().SetScalars(_shared(array.reshape(-1), name))
    return volume


def _floats(array: np.ndarray | Sequence, what: str) -> np.ndarray:
    """Returns the array itself if VTK can share it, otherwise a copy that VTK can share."""
    if np.ma.is_masked(array):
        raise ValueError(f"{what} are masked. Cure: leave those out, or array.filled(VALUE)")
    array = np.asarray(array)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{what} are real numbers, not {array.dtype}")
    keep = array.dtype in (np.float32, np.float64) and array.dtype.isnative
    return np.require(array, None if keep else np.float64, ("C", "ALIGNED"))


def path(points: np.ndarray | Sequence, time: np.ndarray | Sequence | None = None) -> vtkPolyData:
    """Makes the path of the stylus' tip, a polyline.

    points: array of shape (N, 3), x, y and z in world units (mm), one point for each tick. Shared if it is
        contiguous, aligned and float64 or float32; otherwise copied.
    time: times (s) at which the tip is at the points, N numbers that never decrease. Default: one tick for each point,
        1 ms at 1000 Hz.

    TypeError: no real numbers. ValueError: another shape, or masked.

    >>> import numpy as np
    >>> from volumehaptics import path
    >>> path(np.linspace((0, 0, 90), (0, 0, 80), 101)).GetNumberOfPoints()
    101
    """
    points = _floats(points, "points of a path")
    if points.ndim != 2 or points.shape[1] != 3 or len(points) == 0:
        raise ValueError(f"points of a path have the shape (N, 3), N at least 1, not {points.shape}")
    tip = vtkPolyData()
    tip.SetPoints(vtkPoints())
    tip.GetPoints().SetData(_shared(points))
    # Copy the offsets: vtkCellArray may keep the memory alive, but not the object that owns NumPy's array.
    ends = numpy_to_vtkIdTypeArray(np.array([0, len(points)], np.int64), deep=True)
    indices = numpy_to_vtkIdTypeArray(np.arange(len(points), dtype=np.int64), deep=True)
    line = vtkCellArray()
    line.SetData(ends, indices)
    tip.SetLines(line)
    if time is not None:
        time = _floats(time, "times of a path")
        if time.shape != (len(points),):
            raise ValueError(f"times of this path have the shape ({len(points)},), not {time.shape}")
        tip.GetPointData().AddArray(_shared(time, "Time"))
    return tip


def arrays(trace: vtkPolyData) -> dict[str, np.ndarray]:
    """Returns the point arrays of a trace as NumPy arrays by name, and its points as "Proxy" (world units).

    They share the trace's memory: numbers for each tick, in the units of vtkVolumeHapticsFilter's output.

    >>> from volumehaptics import examples, touch
    >>> from volumehaptics.arrays import arrays
    >>> trace = touch(examples.phantom(), examples.stroke())
    >>> arrays(trace)["Force"].shape == (trace.GetNumberOfPoints(), 3)
    True
    """
    found = {}
    if trace.GetPoints() is not None:
        found["Proxy"] = vtk_to_numpy(trace.GetPoints().GetData())
    data = trace.GetPointData()
    for i in range(data.GetNumberOfArrays()):
        one = data.GetArray(i)
        if one is not None and one.GetName():
            found[one.GetName()] = vtk_to_numpy(one)
    return found
