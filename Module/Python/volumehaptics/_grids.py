# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Handles data sets that are not images: grids, and composite data sets of grids. The filter resamples them where they
are felt."""

from __future__ import annotations

from typing import Any

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataSet, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkResampleToImage

# Points along the longest edge of an overview, from which only strengths and bounds are derived.
POINTS = 64


def is_grid(volume: Any) -> bool:
    """Whether data have cells in space and are not an image."""
    return isinstance(volume, (vtkDataSet, vtkCompositeDataSet)) and not isinstance(volume, (vtkImageData, vtkPolyData))


def unwrap(volume: Any) -> Any:
    """Returns VTK's data set in an object of another library: vedo, tvtk (Mayavi), nibabel (MNE, nilearn). A volume of
    nibabel becomes an image at the position that its affine defines, in right-anterior-superior. Returns other
    objects unchanged."""
    for inner in (getattr(volume, name, None) for name in ("_vtk_obj", "dataset")):
        if isinstance(inner, (vtkDataSet, vtkCompositeDataSet)):
            return inner
    if not (hasattr(volume, "affine") and hasattr(volume, "dataobj")):
        return volume
    import numpy as np

    from . import arrays

    values = np.asanyarray(volume.dataobj)
    if values.ndim > 3 and max(values.shape[3:]) > 1:
        raise ValueError(f"a volume has three dimensions, and this one's shape is {values.shape}. Cure: one of its times, "
                         "volume.slicer[..., 0]")
    values = np.ascontiguousarray(values.reshape(values.shape[:3]).T, values.dtype.newbyteorder("="))
    axes = np.asarray(volume.affine)[:3, :3]
    return arrays.image(values, np.linalg.norm(axes, axis=0), volume.affine[:3, 3], direction=axes)


def _leaves(grid: vtkDataSet | vtkCompositeDataSet) -> list[vtkDataSet]:
    if isinstance(grid, vtkDataSet):
        return [grid]
    leaves, iterator = [], grid.NewIterator()
    while not iterator.IsDoneWithTraversal():
        leaves.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return [leaf for leaf in leaves if isinstance(leaf, vtkDataSet) and leaf.GetNumberOfCells()]


def overview(grid: vtkDataSet | vtkCompositeDataSet) -> vtkImageData:
    """Makes a coarse image of the whole grid, with its point and cell arrays as point arrays."""
    all_bounds = [leaf.GetBounds() for leaf in _leaves(grid)]
    bounds = [(min if i % 2 == 0 else max)(one[i] for one in all_bounds) for i in range(6)] if all_bounds else [0.0] * 6
    edges = [bounds[i + 1] - bounds[i] for i in (0, 2, 4)]
    if not min(edges) > 0.0:
        raise ValueError("the data set has no cells, or they have no volume. Cure: give grids of three-dimensional "
                         "cells, such as hexahedra and tetrahedra")
    resample = vtkResampleToImage()
    resample.SetInputDataObject(grid)
    resample.SetSamplingDimensions(*[max(2, round(POINTS * edge / max(edges))) for edge in edges])
    resample.Update()
    image = vtkImageData()
    image.ShallowCopy(resample.GetOutput())
    for mask in ("vtkValidPointMask", "vtkGhostType"):
        image.GetPointData().RemoveArray(mask)
    return image


def suggest_mode(image: vtkImageData) -> str | None:
    """Returns the name of a preset of modes: for vectors or, if there are none, for tensors. Returns None for scalars,
    whose surfaces are felt."""
    points = image.GetPointData()
    sizes = {points.GetArray(i).GetNumberOfComponents() for i in range(points.GetNumberOfArrays()) if points.GetArray(i)}
    if 3 in sizes:
        return "Follow the flow"
    return "Slide along fibres" if sizes & {6, 9} else None
