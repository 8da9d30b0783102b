# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels and their materials, as touch() and add_haptics() take them."""

from __future__ import annotations

import difflib
import numbers
import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Union

from vtkmodules.vtkCommonDataModel import vtkImageData

from .vtkVolumeHaptics import vtkHapticLabelTable, vtkHapticSegmentationReader, vtkVolumeHapticsFilter

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
    """The labels that a key of materials means: itself, or all with this name."""
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
    """Adds the materials to a table."""
    if materials is None:
        return
    if isinstance(materials, vtkHapticLabelTable):
        # Field data have all of a table, and merge.
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


def _make_reader(file: str) -> Any:
    """A reader for a label image, by the ending of its name."""
    ending = file.lower()
    if ending.endswith((".nrrd", ".seg")):
        return vtkHapticSegmentationReader()
    if ending.endswith((".nii", ".nii.gz")):
        from vtkmodules.vtkIOImage import vtkNIFTIImageReader

        return vtkNIFTIImageReader()
    if ending.endswith((".mha", ".mhd")):
        from vtkmodules.vtkIOImage import vtkMetaImageReader

        return vtkMetaImageReader()
    if ending.endswith(".vti"):
        from vtkmodules.vtkIOXML import vtkXMLImageDataReader

        return vtkXMLImageDataReader()
    raise ValueError(f"{file!r} has an ending that is not known here: .seg.nrrd, .nii, .nii.gz, .mha, .mhd or .vti. "
                     "Cure: read the labels yourself, and give the image")


def _read(volume: vtkImageData, file: str) -> vtkImageData:
    """A label image with its table in its field data. It lies on the volume if they have the same voxels."""
    from ._touch import Errors

    if not os.path.isfile(file):
        raise ValueError(f"there is no file {file!r} of labels")
    reader = _make_reader(file)
    with Errors(reader, reader.GetExecutive()) as errors:
        reader.SetFileName(file)
        reader.Update()
    if errors:
        raise ValueError(errors[0])
    image = vtkImageData()
    image.ShallowCopy(reader.GetOutput())
    if not image.GetFieldData().HasArray("Label"):
        table = vtkHapticLabelTable()
        with Errors(table):  # without names there are numbers
            table.ReadFile(file)
        table.WriteFieldData(image.GetFieldData())
    return _lay(image, volume) if image.GetDimensions() == volume.GetDimensions() else image


def _lay(image: vtkImageData, volume: vtkImageData) -> vtkImageData:
    image.SetExtent(volume.GetExtent())
    image.SetOrigin(volume.GetOrigin())
    image.SetSpacing(volume.GetSpacing())
    image.SetDirectionMatrix(volume.GetDirectionMatrix())
    return image


def _make_image(volume: vtkImageData, labels: Labels) -> vtkImageData:
    if isinstance(labels, vtkImageData):
        return labels
    if isinstance(labels, (str, os.PathLike)):
        return _read(volume, os.fspath(labels))
    from . import arrays

    if getattr(getattr(labels, "dtype", None), "name", "") == "bool":
        labels = labels.view("uint8")
    image = arrays.image(labels, name="Labels")
    if image.GetDimensions() != volume.GetDimensions():
        raise ValueError(f"the labels have the shape {labels.shape}, and the volume has {volume.GetDimensions()[::-1]} "
                         "voxels [z, y, x]. Cure: volumehaptics.image(labels, spacing, origin)")
    return _lay(image, volume)


def set_labels(
    haptics: vtkVolumeHapticsFilter, volume: vtkImageData, labels: Labels | None, materials: Materials | None
) -> None:
    """Gives a filter labels and their table."""
    if labels is None:
        if materials is not None:
            raise TypeError("materials are those of labels: give labels=..., an image or an array of whole numbers")
        return
    from ._touch import Errors

    image = _make_image(volume, labels)
    haptics.SetLabelData(image)
    if materials is not None and haptics.GetLabelTable() is not None:
        raise TypeError("give materials or label_table, not both: materials=[table, {...}] adds to a table")
    if haptics.GetLabelTable() is not None:
        return
    has_table = image.GetFieldData().HasArray("Label")
    if isinstance(materials, vtkHapticLabelTable) and not has_table:
        haptics.SetLabelTable(materials)
        return
    table = vtkHapticLabelTable()
    with Errors(table) as errors:
        if has_table:
            table.ReadFieldData(image.GetFieldData())
        _make_table(table, materials)
    if errors:
        raise ValueError("; ".join(errors))
    haptics.SetLabelTable(table)
