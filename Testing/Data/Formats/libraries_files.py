# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what pydicom and nibabel report about each of their own test files: libraries_files.py FOLDER.

FOLDER/libraries.json has for each file the kind of object that it is, and, if it is a volume, or a slice of one, the
affine from index (x, y, z) to left-posterior-superior; FOLDER/N.npy the voxels [x, y, z] of the first volume."""

import json
import logging
import sys
import warnings
from pathlib import Path

import nibabel
import numpy as np
import pydicom

TO_LPS = np.diag([-1.0, -1.0, 1.0, 1.0])


def say_nibabel(path):
    """Returns the class of the image, the voxels and the affine, or the reason why they are missing."""
    try:
        image = nibabel.load(path)
        voxels = np.asarray(image.dataobj, dtype=float)
        affine = TO_LPS @ image.affine
    except Exception as error:  # noqa: BLE001 each loader has its own
        return {"kind": "", "why": str(error)[:200]}, None
    while voxels.ndim > 3:
        # MINC stores the slowest dimension first.
        voxels = voxels[0] if isinstance(image, nibabel.Minc1Image) else voxels[..., 0]
    if voxels.ndim < 3 or affine.shape != (4, 4):
        return {"kind": type(image).__name__, "why": "no volume"}, None
    return {"kind": type(image).__name__, "affine": affine.tolist()}, voxels


def read_dicom(path):
    try:
        return pydicom.dcmread(path)
    except Exception:  # noqa: BLE001
        try:
            read = pydicom.dcmread(path, force=True)
        except Exception:  # noqa: BLE001
            return None
        return read if "SOPClassUID" in read or "PixelData" in read else None


def place(first, step):
    """Returns the affine of slices, whose first slice has the position of `first`."""
    along, down = np.reshape(np.array(first.ImageOrientationPatient, dtype=float), (2, 3))
    spacing = np.array(first.PixelSpacing, dtype=float)  # the step from row to row comes first
    affine = np.eye(4)
    affine[:3, :3] = np.stack([along * spacing[1], down * spacing[0], step], axis=1)
    affine[:3, 3] = np.array(first.ImagePositionPatient, dtype=float)
    return affine


def measured(slice_, pixels):
    scale = float(slice_.get("DoseGridScaling", slice_.get("RescaleSlope", 1.0)))
    return pixels * scale + float(slice_.get("RescaleIntercept", 0.0))


def say_dicom(path, everything):
    """Prints what a file is, and the volume that it contains or belongs to."""
    one = everything.get(path)
    if one is None:
        return {"kind": "", "why": "no DICOM"}, None
    kind = pydicom.uid.UID(one.get("SOPClassUID", one.file_meta.get("MediaStorageSOPClassUID", ""))).name
    facts = {"kind": kind, "modality": str(one.get("Modality", "")), "pixels": "PixelData" in one}
    if path.name == "DICOMDIR":  # the largest volume below it is read
        volumes = [say_dicom(name, everything) for name in everything if name.parent != path.parent and path.parent in name.parents]
        return {**facts, **max(volumes, key=lambda volume: 0 if volume[1] is None else volume[1].size, default=({}, 0))[0],
                "kind": kind}, max((volume[1] for volume in volumes if volume[1] is not None), key=np.size, default=None)
    try:
        frames = int(one.get("NumberOfFrames", 1) or 1)
        pixels = one.pixel_array.astype(float)
        if kind == "Segmentation Storage":
            groups = [one.PerFrameFunctionalGroupsSequence[0], one.SharedFunctionalGroupsSequence[0]]
            first = pydicom.Dataset()
            for group in groups:
                for name in ("PlanePositionSequence", "PlaneOrientationSequence", "PixelMeasuresSequence"):
                    first.update(group[name][0] if name in group else {})
            normal = np.cross(*np.reshape(np.array(first.ImageOrientationPatient, dtype=float), (2, 3)))
            affine = place(first, normal * float(first.SpacingBetweenSlices))
            return {**facts, "affine": affine.tolist()}, pixels.reshape(-1, *pixels.shape[-2:]).transpose(2, 1, 0)
        if frames > 1 and "GridFrameOffsetVector" in one:
            normal = np.cross(*np.reshape(np.array(one.ImageOrientationPatient, dtype=float), (2, 3)))
            offsets = np.array(one.GridFrameOffsetVector, dtype=float)
            return {**facts, "affine": place(one, normal * (offsets[1] - offsets[0])).tolist()}, measured(
                one, pixels.transpose(2, 1, 0))
        series = [other for name, other in everything.items() if name.parent == path.parent and other is not None
                  and other.get("SeriesInstanceUID", name) == one.get("SeriesInstanceUID")
                  and other.get("ImageOrientationPatient") == one.get("ImageOrientationPatient")]
        facts["frames"], facts["slices"] = frames, len({str(other.get("ImagePositionPatient")) for other in series})
        if frames > 1 or facts["slices"] < 5 or pixels.ndim != 2:
            return facts, None
        normal = np.cross(*np.reshape(np.array(one.ImageOrientationPatient, dtype=float), (2, 3)))
        series.sort(key=lambda other: np.dot(np.array(other.ImagePositionPatient, dtype=float), normal))
        ends = [np.array(series[i].ImagePositionPatient, dtype=float) for i in (0, -1)]
        voxels = np.stack([measured(other, other.pixel_array.astype(float)).T for other in series], axis=2)
        return {**facts, "affine": place(series[0], (ends[1] - ends[0]) / (len(series) - 1)).tolist()}, voxels
    except Exception as error:  # noqa: BLE001 of what pydicom can't unpack, or what lacks a fact
        return {**facts, "why": str(error)[:200]}, None


warnings.simplefilter("ignore")
logging.disable(logging.CRITICAL)
folder = Path(sys.argv[1]).resolve()
folder.mkdir(parents=True)
roots = {"pydicom": Path(pydicom.__file__).parent / "data", "nibabel": Path(nibabel.__file__).parent / "tests" / "data"}
said = []
for library, root in roots.items():
    files = sorted(file for file in root.rglob("*") if file.is_file() and file.suffix not in (".py", ".pyc"))
    dicom = {file: read_dicom(file) for file in files if library == "pydicom" or file.suffix == ".dcm"}
    for file in files:
        facts, voxels = say_dicom(file, dicom) if file in dicom else say_nibabel(file)
        if voxels is not None:
            facts["voxels"] = str(folder / f"{len(said)}.npy")
            np.save(facts["voxels"], voxels)
        said.append({"path": str(file), "name": f"{library}/{file.relative_to(root)}", "library": library, **facts})
(folder / "libraries.json").write_text(json.dumps(said, indent=1))
print(len(said), "files of pydicom and nibabel")
