# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Describes what a file contains, and what of it can be felt."""

from __future__ import annotations

import json
import os
import subprocess
from typing import Any

from .__main__ import CURE, PROGRAM, find_explorer

__all__ = ["inspect"]


def inspect(file: str | os.PathLike, *options: str) -> dict[str, Any]:
    """Returns what volumehaptics-explore --inspect says of a file or a folder, as a dictionary.

    file: any volume that the explorer reads, such as a NIfTI file or a folder of DICOM slices.
    options: further options of the explorer, such as "--series", "2", or "--as-labels".

    Keys: name and format; size, spacing, origin and direction (mm; directions are the columns of nine numbers, row by
    row), axes, meters_per_unit (of the hand's movement); type, range, usual_range (0.5 to 99.5 %) and padding of the
    values; modality and modality_reason; noise (standard deviation) and local_noise (smallest and largest of 27 parts);
    smallest_sheet (mm) and smallest_sheet_step, smallest_step (differences of values that are felt in spite of the
    noise); preset and preset_reason; notes on what was guessed, dropped, filled, resampled or turned.

    ValueError: the file can't be read, with the cure. FileNotFoundError: there is no volumehaptics-explore.
    """
    explorer = find_explorer()
    if explorer is None:
        raise FileNotFoundError(CURE.partition(": ")[2].strip())
    result = subprocess.run([explorer, os.fspath(file), "--inspect", "--json", *options], capture_output=True, text=True,
                            errors="replace", check=False)
    if result.returncode != 0:
        raise ValueError(result.stderr.strip() or f"{PROGRAM} failed with status {result.returncode}")
    return json.loads(result.stdout)
