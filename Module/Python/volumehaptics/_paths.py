# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Joins several paths as lines of one polydata, and divides their joint trace into several traces."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def _lines(ends: np.ndarray) -> vtkCellArray:
    """Makes polylines of consecutive points from the indices at which they end."""
    # Copy the offsets: vtkCellArray may keep the memory alive, but not the object that owns NumPy's array.
    offsets = numpy_to_vtkIdTypeArray(np.array(ends, np.int64), deep=True)
    points = numpy_to_vtkIdTypeArray(np.arange(ends[-1], dtype=np.int64), deep=True)
    lines = vtkCellArray()
    lines.SetData(offsets, points)
    return lines


def _is_plain(path: vtkPolyData) -> bool:
    """Whether a polydata is one path through its points in their order, so that it can become one line of several."""
    data = path.GetPointData()
    if path.GetNumberOfPoints() == 0 or data.HasArray("DeviceTip") or data.HasArray("Orientation"):
        return False
    lines, size = path.GetLines(), path.GetNumberOfPoints()
    if lines.GetNumberOfCells() == 0:
        return True
    if lines.GetNumberOfCells() > 1 or lines.GetNumberOfConnectivityIds() != size:
        return False
    return np.array_equal(vtk_to_numpy(lines.GetConnectivityArray()), np.arange(size))


def groups(paths: list[vtkPolyData]) -> list[list[int]]:
    """Groups the indices of paths that can be felt together: in a group, all paths have times, or none has."""
    timed: list[int] = []
    untimed: list[int] = []
    others: list[list[int]] = []
    for i, path in enumerate(paths):
        times = path.GetPointData().GetArray("Time")
        if not _is_plain(path):
            others.append([i])
        elif times is None:
            untimed.append(i)
        elif times.GetNumberOfComponents() == 1 and times.GetNumberOfTuples() == path.GetNumberOfPoints():
            timed.append(i)
        else:
            others.append([i])  # in a group of its own, so that the filter reports the error
    return [*(group for group in (timed, untimed) if group), *others]


def together(paths: list[vtkPolyData]) -> vtkPolyData:
    """Makes one polydata of the paths of a group, with a line for each."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.concatenate(
        [vtk_to_numpy(path.GetPoints().GetData()).astype(np.float64, copy=False) for path in paths])))
    tips = vtkPolyData()
    tips.SetPoints(points)
    tips.SetLines(_lines(np.cumsum([0, *(path.GetNumberOfPoints() for path in paths)])))
    if paths[0].GetPointData().HasArray("Time"):
        times = [vtk_to_numpy(path.GetPointData().GetArray("Time")).astype(np.float64) for path in paths]
        shared = numpy_to_vtk(np.concatenate(times))
        shared.SetName("Time")
        tips.GetPointData().AddArray(shared)
    return tips


def _slice(array: vtkDataArray, begin: int, end: int) -> vtkDataArray:
    """Returns a range of the tuples of an array. The memory is shared."""
    part = numpy_to_vtk(vtk_to_numpy(array)[begin:end], array_type=array.GetDataType())
    part.SetName(array.GetName())
    return part


def apart(trace: vtkPolyData) -> list[vtkPolyData]:
    """Returns a trace for each line of a joint trace, equal to the trace of each path alone. They share its memory."""
    ends = vtk_to_numpy(trace.GetLines().GetOffsetsArray())
    data = trace.GetPointData()
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    traces = []
    for begin, end in zip(ends[:-1].tolist(), ends[1:].tolist()):
        one = vtkPolyData()
        one.SetPoints(vtkPoints())
        one.GetPoints().SetData(_slice(trace.GetPoints().GetData(), begin, end))
        if end - begin > 1:
            one.SetLines(_lines(np.array([0, end - begin])))
        for array in arrays:
            one.GetPointData().AddArray(_slice(array, begin, end))
        traces.append(one)
    return traces
