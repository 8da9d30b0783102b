# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads files and folders through vtkHapticVolumeReader, so that a volume has the same values, axes and lengths in
every front end."""

from __future__ import annotations

import os
import re

from vtkmodules.vtkCommonDataModel import vtkImageData

from .vtkVolumeHaptics import vtkHapticVolumeReader

# Patterns of explorer options in the reader's texts, and the arguments that replace them here.
_OPTIONS = ((r"--series (\w+)", r"series=\1"), )


def _in_python(text: str) -> str:
    for option, argument in _OPTIONS:
        text = re.sub(option, argument, text)
    return text


def run(path: str | os.PathLike, series: int = 0, are_labels: bool = False) -> vtkHapticVolumeReader:
    """Returns a reader that has read a file or a folder. ValueError: it can't be read; the text has the cure."""
    from ._touch import Errors

    reader = vtkHapticVolumeReader()
    reader.SetFileName(os.path.abspath(path))
    reader.SetSeries(series)
    reader.SetAsLabels(are_labels)
    with Errors(reader, reader.GetExecutive()) as errors:
        reader.Update()
    if errors:
        raise ValueError(_in_python(errors[0]))
    return reader


def take(reader: vtkHapticVolumeReader) -> vtkImageData:
    """Returns the output of a reader as an image that does not keep the reader alive."""
    image = vtkImageData()
    image.ShallowCopy(reader.GetOutput())
    return image


def read(path: str | os.PathLike, series: int = 0) -> tuple[vtkImageData, list[str]]:
    """Returns the volume of a file or a folder, and notes on what was assumed, dropped, filled or turned. If the file
    defines its axes, the volume is in left-posterior-superior and mm. series: see vtkHapticVolumeReader.SetSeries().

    ValueError: the file or folder can't be read; the text has the cure."""
    reader = run(path, series)
    said = _in_python(reader.GetNotes()).splitlines()
    return take(reader), [line.strip() for line in said if line.strip() and "slices, sorted by" not in line]
