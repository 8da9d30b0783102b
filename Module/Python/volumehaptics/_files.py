# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads files and folders by the explorer: a volume has the same values, axes and lengths in every front end."""

from __future__ import annotations

import os
import subprocess
import tempfile
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from .__main__ import PROGRAM, find_explorer


def run_explorer(explorer: str, *arguments: str) -> str:
    """Returns what volumehaptics-explore prints. ValueError: it failed; with what it said."""
    result = subprocess.run([explorer, *arguments], capture_output=True, text=True, errors="replace", check=False)
    if result.returncode != 0:
        raise ValueError(result.stderr.strip() or f"{PROGRAM} failed with status {result.returncode}")
    return result.stdout


def read(path: str | os.PathLike, *options: str) -> tuple[vtkImageData, list[str]]:
    """Returns the volume of a file or a folder, left-posterior-superior in mm if it says so, and notes on what was
    assumed, dropped, filled or turned. options: options of volumehaptics-explore, such as "--series", "2".

    ValueError: the file or folder can't be read; with the cure."""
    explorer = find_explorer()
    if explorer is None:
        raise ValueError(f"there is no {PROGRAM}, which reads volumes, neither in the package nor on PATH. Cure: the wheel "
                         "brings it along (CMake/wheel/build.sh)")
    with tempfile.TemporaryDirectory() as folder:
        file = str(Path(folder) / "volume.vti")
        printed = run_explorer(explorer, os.path.abspath(path), *options, "--write-volume", file)
        reader = vtkXMLImageDataReader()
        reader.SetFileName(file)
        reader.Update()
    image = vtkImageData()
    image.ShallowCopy(reader.GetOutput())  # the image must not keep the reader alive
    said = [line.strip() for line in printed.splitlines()]
    return image, [line for line in said if line and not line.startswith("Written: ") and "slices, sorted by" not in line]
