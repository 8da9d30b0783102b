# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads files and folders through vtkHapticVolumeReader, so that a volume has the same values, axes and lengths in
every front end."""

from __future__ import annotations

import os
import re

from vtkmodules.vtkCommonDataModel import vtkImageData

from .vtkVolumeHaptics import vtkHapticVolumeReader


def in_words(text: str, option: str = "series=") -> str:
    """Replaces the setting Series in the texts of the C++ classes by an option, or by an argument of Python."""
    text = re.sub(r"\bSeries = (\w)", rf"{option}\1", text)
    return text.replace("eave Series out", f"eave {option.rstrip('= ')} out")


def run(path: str | os.PathLike, series: int = 0, are_labels: bool = False,
        option: str = "series=") -> vtkHapticVolumeReader:
    """Returns a reader that has read a file or a folder. ValueError: it can't be read; the text has the cure, with the
    option that chooses a series."""
    from ._touch import Errors

    reader = vtkHapticVolumeReader()
    reader.SetFileName(os.path.abspath(path))
    reader.SetSeries(series)
    reader.SetAsLabels(are_labels)
    with Errors(reader, reader.GetExecutive()) as errors:
        reader.Update()
    if errors:
        raise ValueError(in_words(errors[0], option))
    return reader


def take(reader: vtkHapticVolumeReader) -> vtkImageData:
    """Returns the output of a reader as an image that does not keep the reader alive."""
    image = vtkImageData()
    image.ShallowCopy(reader.GetOutput())
    return image


def read(path: str | os.PathLike, series: int = 0, option: str = "series=") -> tuple[vtkImageData, list[str]]:
    """Returns the volume of a file or a folder, and notes on what was assumed, dropped, filled or turned. If the file
    defines its axes, the volume is in left-posterior-superior and mm. series: see vtkHapticVolumeReader.SetSeries().

    ValueError: the file or folder can't be read; the text has the cure."""
    reader = run(path, series, option=option)
    said = in_words(reader.GetNotes(), option).splitlines()
    return take(reader), [line.strip() for line in said if line.strip()]
