# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels and their materials for touch() and add_haptics()."""

from __future__ import annotations

import difflib
import math
import numbers
import os
import zlib
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Union

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkCommonMath import vtkMatrix4x4

from .vtkVolumeHaptics import (
    vtkHapticLabelTable,
    vtkHapticRegionSource,
    vtkHapticSegmentationReader,
    vtkVolumeHapticsFilter,
)

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
    """Returns the labels that a key of materials stands for: one number, or all labels of a name."""
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
        # Field data hold whole tables; merge them.
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
    """Copies an image without the reader's record of its origin; the copy shares the samples."""
    copy = vtkImageData()
    copy.ShallowCopy(image)
    return copy


def _count_unpacked(file: str) -> int:
    """Returns the number of bytes that zlib or gzip packed in a file; -1 if it is cut off or damaged."""
    count = 0
    with open(file, "rb") as packed:
        rest = packed.read(1 << 18)
        while rest:
            stream = zlib.decompressobj(zlib.MAX_WBITS | 32)  # header of zlib or gzip
            try:
                while rest and not stream.eof:
                    count += len(stream.decompress(rest, 1 << 20))
                    rest = stream.unconsumed_tail or stream.unused_data or packed.read(1 << 18)
                count += len(stream.flush())
            except zlib.error:
                return -1
            if not stream.eof:
                return -1
            if not rest.startswith(b"\x1f\x8b"):  # a gzip file may have several members
                break
    return count if count else -1


def _count_held(file: str) -> int:
    """Returns the most bytes of samples that a file can hold; -1 if it is cut off or damaged: VTK's readers fill missing
    samples with whatever was in memory."""
    name = file.lower()
    if name.endswith(".nii.gz"):
        return _count_unpacked(file)
    size = os.path.getsize(file)
    if name.endswith(".vti"):
        with open(file, "rb") as text:
            text.seek(max(0, size - 1024))
            if b"</VTKFile>" not in text.read():
                return -1
        return 10000 * size  # deflate packs zeros 1032 times smaller at most, LZMA 7000 times
    return size if name.endswith(".nii") else 1032 * size


def _run(reader: Any, file: str) -> vtkImageData:
    """Returns the output of a VTK reader. ValueError: an error, or a header that promises more than the file holds.

    Some readers continue after an error, and read all samples into memory for one voxel; all of them allocate first."""
    from ._touch import Errors

    held = _count_held(file)
    if held < 0:
        raise ValueError(f"{file!r} can't be read: it is damaged, or cut off. Cure: check that the copy is complete, or write "
                         "it again")
    with Errors(reader, reader.GetExecutive()) as errors:
        reader.SetFileName(file)
        reader.UpdateInformation()
        if not errors:
            extent = [0, -1] * 3
            reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), extent)
            voxels = math.prod(max(0, last + 1 - first) for first, last in zip(extent[::2], extent[1::2]))
            if not 0 < voxels <= held:
                raise ValueError(f"{file!r} can't be read: its header promises {voxels} voxels, which are not in the "
                                 "file. Cure: check that the copy is complete, or write it again")
            reader.Update()
    if errors:
        raise ValueError(f"{file!r} can't be read: {errors[0]}. Cure: check that the copy is complete, or write it again")
    return _copy(reader.GetOutput())


def _read_nrrd(file: str) -> tuple[vtkImageData, bool]:
    return _run(vtkHapticSegmentationReader(), file), True


def _scale(stored: Any, reader: Any, file: str) -> Any:
    """Returns the labels that a NIfTI header makes of stored numbers; rounded if it scales them a little, such as by 1.00002."""
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

    slope, intercept = reader.GetRescaleSlope(), reader.GetRescaleIntercept()
    if slope == 0.0 or not (math.isfinite(slope) and math.isfinite(intercept)):
        return stored  # nifti1.h: the numbers are as they are stored
    values = slope * vtk_to_numpy(stored).astype(float) + intercept
    labels = np.round(values)
    if not np.all(np.abs(values - labels) <= 1e-3):
        wrong = values[np.argmax(np.abs(values - labels))]
        raise ValueError(f"{file!r} can't be read as labels: its header scales the stored numbers by {slope:g} and adds "
                         f"{intercept:g}, which makes {wrong:g} of one. Cure: write the numbers of the labels, with the "
                         "slope 1")
    return numpy_to_vtk(labels.astype(np.int32), deep=True)


def _read_nifti(file: str) -> tuple[vtkImageData, bool]:
    from vtkmodules.vtkIOImage import vtkNIFTIImageReader

    reader = vtkNIFTIImageReader()
    image = _run(reader, file)
    if (reader.GetRescaleSlope(), reader.GetRescaleIntercept()) not in ((0.0, 0.0), (1.0, 0.0)):
        image.GetPointData().SetScalars(_scale(image.GetPointData().GetScalars(), reader, file))
    place = reader.GetSFormMatrix() or reader.GetQFormMatrix()
    if place is not None:
        rows = [[place.GetElement(row, column) for column in range(4)] for row in range(3)]
        _set_frame(image, [row[:3] for row in rows], [row[3] for row in rows])
        image = _turn(image)  # NIfTI has right-anterior-superior
    return image, place is not None


def _has_matrix(file: str) -> bool:
    """Whether a MetaImage's header has the directions of its axes."""
    with open(file, "rb") as header:
        for line in iter(lambda: header.readline(10000), b""):
            key, equals, value = line.decode("latin-1").partition("=")
            if key.strip() == "TransformMatrix" and value.strip():
                return True
            if not equals or key.strip() == "ElementDataFile":
                return False
    return False


def _read_meta_image(file: str) -> tuple[vtkImageData, bool]:
    from ._touch import Errors

    source, image = vtkHapticRegionSource(), vtkImageData()
    with Errors(source) as errors:
        is_read = source.OpenWholeFile(file) and source.ReadRegion(source.GetWholeExtent(), image)
    if not is_read:
        raise ValueError(errors[0])
    if "the first one is used" in source.GetFileNotes():
        raise ValueError(f"{file!r} can't be read as labels: {source.GetFileNotes()}. Cure: write the volume that is meant "
                         "into a file of its own")
    labels = vtkImageData()
    labels.CopyStructure(image)
    labels.GetPointData().SetScalars(image.GetPointData().GetScalars())
    return labels, _has_matrix(file)


def _read_vti(file: str) -> tuple[vtkImageData, bool]:
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader

    return _run(vtkXMLImageDataReader(), file), True


def _read_dicom(file: str) -> tuple[vtkImageData, bool]:
    from ._files import read

    image, _ = read(file)
    if not image.GetFieldData().HasArray("Label"):
        raise ValueError(f"{file!r} is DICOM, but no segmentation (SEG). Cure: give it as the volume")
    return image, True


_READERS = {".nrrd": _read_nrrd, ".seg": _read_nrrd, ".nii": _read_nifti, ".nii.gz": _read_nifti,
            ".mha": _read_meta_image, ".mhd": _read_meta_image, ".vti": _read_vti, ".dcm": _read_dicom}


def _read(volume: vtkImageData, file: str, is_file: bool) -> vtkImageData:
    """Returns a label image where it lies in the volume's world, with its table in its field data."""
    from ._touch import Errors

    if not os.path.isfile(file):
        raise ValueError(f"there is no file {file!r} of labels")
    read = next((_READERS[ending] for ending in _READERS if file.lower().endswith(ending)), None)
    if read is None:
        raise ValueError(f"{file!r} has an ending that is not known here: .seg.nrrd, .nii, .nii.gz, .mha, .mhd, .vti or .dcm. "
                         "Cure: read the labels yourself, and give the image")
    image, is_placed = read(file)
    if not image.GetFieldData().HasArray("Label"):
        table = vtkHapticLabelTable()
        with Errors(table):  # labels without names keep their numbers
            table.ReadFile(file)
        table.WriteFieldData(image.GetFieldData())
    return _find_place(image, is_placed, volume, file, is_file)


def _find_place(image: vtkImageData, is_placed: bool, volume: vtkImageData, file: str, is_file: bool) -> vtkImageData:
    """Returns the labels of a file, placed in the world of a volume: left-posterior-superior as in ITK and the explorer, or
    right-anterior-superior as in nibabel. ValueError: the position can't be determined."""
    if is_file and is_placed and _overlaps(image, volume):
        return image  # both files tell the same world
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
    """Whether an image seems to come from a reader, or from an array without a position."""
    return _matrix(volume)[:2] == [[1, 0, 0], [0, 1, 0]] and tuple(volume.GetOrigin()) == (0, 0, 0)


def _matrix(image: vtkImageData) -> list[list[float]]:
    matrix = image.GetDirectionMatrix()
    return [[matrix.GetElement(row, column) for column in range(3)] for row in range(3)]


def _set_frame(image: vtkImageData, axes: list[list[float]], origin: Iterable[float]) -> None:
    """Sets the axes of an image: columns of any length are the directions of the index axes."""
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
    """Returns an image's first voxel, and the last voxel along each axis, as indices of a volume."""
    matrix, extent = _to_voxels(image, volume), image.GetExtent()
    ends = [[extent[2 * axis + (axis == end)] for axis in range(3)] for end in (-1, 0, 1, 2)]
    return [matrix.MultiplyPoint((*index, 1.0))[:3] for index in ends]


_TOLERANCE = 0.05  # voxels


def _has_voxels_of(image: vtkImageData, volume: vtkImageData) -> bool:
    """Whether the voxels of both images coincide, in the same order; both have the same number along each axis."""
    return all(math.dist(a, b) < _TOLERANCE for a, b in zip(_ends(image, volume), _ends(volume, volume)))


def _has_grid_of(image: vtkImageData, volume: vtkImageData) -> bool:
    """Whether an image's voxels are voxels of the volume, or would be beyond its border; the axes may differ."""
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
    """Gives a filter labels and their table. is_file: the volume was read from a file, as the explorer does."""
    if labels is None:
        if materials is not None:
            raise TypeError("materials are those of labels: give labels=..., an image or an array of whole numbers")
        return
    from ._touch import Errors

    image = _make_image(volume, labels, is_file)
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
