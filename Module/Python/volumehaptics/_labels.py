# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels and their materials for touch() and add_haptics()."""

from __future__ import annotations

import difflib
import math
import numbers
import os
import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Union

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonMath import vtkMatrix4x4

from .vtkVolumeHaptics import vtkHapticLabelTable, vtkHapticVolumeReader, vtkVolumeHapticsFilter

if TYPE_CHECKING:
    import numpy as np

Labels = Union[vtkImageData, "np.ndarray", str, os.PathLike]
Materials = Union[vtkHapticLabelTable, Mapping[Union[int, str], Mapping[str, Any]], str, os.PathLike, Iterable]

_SETTERS = {
    "name": "SetLabelName",
    "color": "SetColor",
    "stiffness": "SetStiffness",
    "friction": "SetFriction",
    "viscosity": "SetViscosity",
    "surface_strength": "SetSurfaceStrength",
    "shaft_friction": "SetShaftFriction",
    "specific_energy": "SetSpecificEnergy",
    "felt": "SetFelt",
    "forbidden": "SetForbidden",
}


def _one_of(known: Iterable[str], wrong: str) -> str:
    close = difflib.get_close_matches(wrong, list(known), n=1)
    return f"is it {close[0]!r}? " if close else ""


def _labels_of(table: vtkHapticLabelTable, key: int | str) -> list[int]:
    """Returns the labels for which a key of materials stands: a number stands for one label, a name for all labels of
    this name."""
    if isinstance(key, numbers.Integral) and not isinstance(key, bool):
        if not -2**31 <= key < 2**31:
            raise ValueError(f"label {key} is out of range: labels are from {-2**31} to {2**31 - 1}")
        return [int(key)]
    if not isinstance(key, str):
        raise TypeError(f"a label is a number or a name, not {key!r}")
    names: dict[str, list[int]] = {}
    for index in range(table.GetNumberOfLabels()):
        label = table.GetLabel(index)
        names.setdefault(table.GetLabelName(label), []).append(label)
    names.pop("", None)
    if key not in names:
        there = ", ".join(map(repr, sorted(names)[:20])) or "none"
        raise ValueError(f"no label is called {key!r}; {_one_of(names, key)}There are: {there}. Cure: its number, or "
                         "names first, as in materials=['names.csv', {'liver': dict(stiffness=300)}]")
    return names[key]


def _fill(table: vtkHapticLabelTable, materials: Mapping[int | str, Mapping[str, Any]]) -> None:
    for key, material in materials.items():
        if not isinstance(material, Mapping):
            raise TypeError(f"the material of label {key!r} is a dict such as dict(stiffness=300), not {material!r}")
        for label in _labels_of(table, key):
            for quantity, value in material.items():
                setter = _SETTERS.get(quantity)
                if setter is None:
                    raise TypeError(f"the material of label {key!r} has no {quantity!r}; "
                                    f"{_one_of(_SETTERS, str(quantity))}There are: {', '.join(_SETTERS)}")
                try:
                    getattr(table, setter)(label, *(value if quantity == "color" else (value,)))
                except TypeError:
                    raise TypeError(f"{quantity}={value!r} of label {key!r} is of a type that can't be set") from None


def _make_table(table: vtkHapticLabelTable, materials: Materials | None) -> None:
    """Adds materials to a table."""
    if materials is None:
        return
    if isinstance(materials, vtkHapticLabelTable):
        # Read the table from field data, because only they contain the whole table, so that it is merged.
        carrier = vtkImageData()
        materials.WriteFieldData(carrier.GetFieldData())
        table.ReadFieldData(carrier.GetFieldData())
    elif isinstance(materials, Mapping):
        _fill(table, materials)
    elif isinstance(materials, (str, os.PathLike)):
        table.ReadFile(os.fspath(materials))
    elif isinstance(materials, Iterable):
        for part in materials:
            _make_table(table, part)
    else:
        raise TypeError("materials are a dict, a vtkHapticLabelTable, the name of a file, or several of them, not "
                        f"{type(materials).__name__}")


def _copy(image: vtkImageData) -> vtkImageData:
    """Copies an image without the reader's record of its origin. The copy shares the samples."""
    copy = vtkImageData()
    copy.ShallowCopy(image)
    return copy


def _read(volume: vtkImageData, file: str, is_file: bool) -> vtkImageData:
    """Returns a label image that is placed in the volume's world, with its table in its field data."""
    from ._files import run, take
    from ._touch import _warn

    if not os.path.exists(file):
        raise ValueError(f"there is no file {file!r} of labels")
    try:
        reader = run(file, are_labels=True)
    except ValueError as error:  # the argument series concerns the volume, not the labels
        raise ValueError(re.sub(r"use series=1 to series=\d+, or ", "", str(error))) from None
    for note in reader.GetNotes().splitlines():
        _warn(f"{os.path.basename(file)}: {note}")
    return _find_place(take(reader), reader.HasPlace(), volume, file, is_file)


def _find_place(image: vtkImageData, is_placed: bool, volume: vtkImageData, file: str, is_file: bool) -> vtkImageData:
    """Returns the labels of a file, placed in the world of a volume: in left-posterior-superior, as in ITK and the
    explorer, or in right-anterior-superior, as in nibabel. ValueError: the position can't be determined."""
    if is_file and is_placed and _overlaps(image, volume):
        return image  # both files place their voxels in the same world
    if not is_file and image.GetDimensions() == volume.GetDimensions() and (
            not is_placed or any(_has_voxels_of(one, volume) for one in (image, _turn(image)))):
        return _lay(image, volume)
    if is_placed and not is_file and not _is_bare(volume):
        fitting = [one for one in (image, _turn(image)) if _has_grid_of(one, volume) and _overlaps(one, volume)]
        if len(fitting) == 1:
            return fitting[0]
    raise ValueError(
        f"the labels of {file!r} do not lie on the volume: they have {image.GetDimensions()} voxels along x, y and z from "
        f"{_tell(image)} on, left-posterior-superior, and the volume {volume.GetDimensions()} from {_tell(volume)} on. "
        "Cure: place the volume, as with volumehaptics.image(array, spacing, origin, direction), where its own file says; "
        "or give the labels as an image in the volume's world, or as an array [z, y, x] of the volume's voxels")


def _tell(image: vtkImageData) -> str:
    return "(" + ", ".join(f"{x:.4g}" for x in image.GetOrigin()) + ")"


def _is_bare(volume: vtkImageData) -> bool:
    """Whether an image seems to have no position, as from a reader that ignores it or from an array."""
    return _matrix(volume)[:2] == [[1, 0, 0], [0, 1, 0]] and tuple(volume.GetOrigin()) == (0, 0, 0)


def _matrix(image: vtkImageData) -> list[list[float]]:
    matrix = image.GetDirectionMatrix()
    return [[matrix.GetElement(row, column) for column in range(3)] for row in range(3)]


def _set_frame(image: vtkImageData, axes: list[list[float]], origin: Iterable[float]) -> None:
    """Sets the axes of an image. The columns, which may have any length, are the directions of the index axes."""
    lengths = [math.hypot(*column) for column in zip(*axes)]
    if min(lengths) > 0:
        image.SetDirectionMatrix([x / length for row in axes for x, length in zip(row, lengths)])
        image.SetOrigin(*origin)


def _turn(image: vtkImageData) -> vtkImageData:
    """Converts left-posterior-superior to right-anterior-superior, or back."""
    turned = _copy(image)
    x, y, z = image.GetOrigin()
    axes = _matrix(image)
    _set_frame(turned, [[-a for a in axes[0]], [-a for a in axes[1]], axes[2]], (-x, -y, z))
    return turned


def _to_voxels(image: vtkImageData, volume: vtkImageData) -> vtkMatrix4x4:
    """Returns the matrix from the indices of an image to the indices of a volume."""
    to_voxels = vtkMatrix4x4()
    vtkMatrix4x4.Invert(volume.GetIndexToPhysicalMatrix(), to_voxels)
    vtkMatrix4x4.Multiply4x4(to_voxels, image.GetIndexToPhysicalMatrix(), to_voxels)
    return to_voxels


def _ends(image: vtkImageData, volume: vtkImageData) -> list[tuple[float, ...]]:
    """Returns an image's first voxel, and its last voxel along each axis, as indices of a volume."""
    matrix, extent = _to_voxels(image, volume), image.GetExtent()
    ends = [[extent[2 * axis + (axis == end)] for axis in range(3)] for end in (-1, 0, 1, 2)]
    return [matrix.MultiplyPoint((*index, 1.0))[:3] for index in ends]


_TOLERANCE = 0.05  # voxels


def _has_voxels_of(image: vtkImageData, volume: vtkImageData) -> bool:
    """Whether the voxels of both images coincide, in the same order. Both have the same number of voxels along each
    axis."""
    return all(math.dist(a, b) < _TOLERANCE for a, b in zip(_ends(image, volume), _ends(volume, volume)))


def _has_grid_of(image: vtkImageData, volume: vtkImageData) -> bool:
    """Whether the voxels of an image are voxels of the volume, or would be beyond its border. The order of the axes may
    differ."""
    matrix = _to_voxels(image, volume)
    steps = [matrix.GetElement(row, column) for row in range(3) for column in range(3)]
    return all(abs(abs(step) - 0.5) > 0.4 and abs(step) < 1.1 for step in steps) and all(
        abs(x - round(x)) < _TOLERANCE for end in _ends(image, volume) for x in end)


def _overlaps(image: vtkImageData, volume: vtkImageData) -> bool:
    a, b = image.GetBounds(), volume.GetBounds()
    return all(a[2 * i] <= b[2 * i + 1] and b[2 * i] <= a[2 * i + 1] for i in range(3))


def _lay(image: vtkImageData, volume: vtkImageData) -> vtkImageData:
    image.SetExtent(volume.GetExtent())
    image.SetOrigin(volume.GetOrigin())
    image.SetSpacing(volume.GetSpacing())
    image.SetDirectionMatrix(volume.GetDirectionMatrix())
    return image


def _make_image(volume: vtkImageData, labels: Labels, is_file: bool) -> vtkImageData:
    if isinstance(labels, vtkImageData):
        return labels
    if isinstance(labels, (str, os.PathLike)):
        return _read(volume, os.fspath(labels), is_file)
    from . import arrays

    if is_file:
        raise TypeError("an array of labels has no place in the patient, which the volume of a file has. Cure: give the file "
                        "of the labels, or volumehaptics.image(labels, spacing, origin, direction)")
    if getattr(getattr(labels, "dtype", None), "name", "") == "bool":
        labels = labels.view("uint8")
    image = arrays.image(labels, name="Labels")
    if image.GetDimensions() != volume.GetDimensions():
        raise ValueError(f"the labels have the shape {labels.shape}, and the volume has {volume.GetDimensions()[::-1]} "
                         "voxels [z, y, x]. Cure: volumehaptics.image(labels, spacing, origin)")
    return _lay(image, volume)


def set_labels(
    haptics: vtkVolumeHapticsFilter, volume: vtkImageData, labels: Labels | None, materials: Materials | None,
    is_file: bool = False
) -> None:
    """Sets the labels of a filter, and their table. is_file: whether the volume was read from a file, as the explorer
    does."""
    if labels is None:
        if materials is not None:
            raise TypeError("materials are those of labels: give labels=..., an image or an array of whole numbers")
        return
    from ._touch import Errors, _warn

    image = _make_image(volume, labels, is_file)
    haptics.SetLabelData(image)
    table = haptics.GetLabelTable()
    if materials is not None and table is not None:
        raise TypeError("give materials or label_table, not both: materials=[table, {...}] adds to a table")
    has_table = image.GetFieldData().HasArray("Label")
    if table is None and isinstance(materials, vtkHapticLabelTable) and not has_table:
        table = materials
    elif table is None:
        table = vtkHapticLabelTable()
        with Errors(table) as errors:
            if has_table:
                table.ReadFieldData(image.GetFieldData())
            _make_table(table, materials)
        if errors:
            raise ValueError("; ".join(errors))
    haptics.SetLabelTable(table)
    for note in vtkHapticVolumeReader.DescribeLabels(image, volume, table).splitlines():
        _warn(f"{os.path.basename(os.fspath(labels))}: {note}" if isinstance(labels, (str, os.PathLike)) else note)
