# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Defines a case: a writer of files, and the expected content."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path


@dataclass
class Case:
    """One input of a user. `write(folder)` writes the files and returns the path that the user names."""

    name: str
    write: Callable[[Path], Path]
    source: str = ""  #: the public thread, or the part of the standard, that says what is right
    refused: str | None = None  #: a pattern that the one line of refusal has; None: the volume is read
    told: tuple[str, ...] = ()  #: patterns of what is told beside the volume
    tolerance: float = 1.0  #: of values; more where something is resampled
    scale: float = 1.0  #: the values are the phantom's times this ...
    offset: float = 0.0  #: ... and this is added
    # : Only for files without patient coordinates: spacing (mm) along the index axes in the resulting world, and the
    # first voxel.
    steps: tuple[float, float, float] | None = None
    first: tuple[float, float, float] = (0.0, 0.0, 0.0)
    outside: bool = False  #: where nothing was measured, the value is air's or below
    labels: tuple[str, ...] = ()  #: the file has labels, with these names: 1 is the ball, 2 its left knob
    first_label: int = 1  #: the ball's; that of its left knob is the next
    alone: str = ""  #: the only label that is read: 1 in the "body", which is the ball and its knobs, or 2 in the "knob"
    options: tuple[str, ...] = ()  #: of the explorer


CASES: list[Case] = []


def case(name: str, **facts) -> Callable:
    """Registers a writer: `@case("dicom-tilted", source="...")`."""

    def register(write: Callable[[Path], Path]) -> Callable[[Path], Path]:
        if any(known.name == name for known in CASES):
            raise ValueError(f"there are two cases {name}")
        CASES.append(Case(name, write, **facts))
        return write

    return register
