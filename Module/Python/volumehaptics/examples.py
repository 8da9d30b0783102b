# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A head to touch, a stroke over it, and the force of the stroke.

The head is the project's own phantom, drawn and not scanned: see data/README.txt beside this file.
"""

from __future__ import annotations

from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from ._touch import Errors, touch
from .vtkVolumeHaptics import vtkHapticPathSource

__all__ = ["first_touch", "phantom", "phantom_file", "stroke"]

SKIN = -300.0  # HU, at the phantom's visible skin


def phantom_file() -> str:
    """Returns the path of the head phantom, a .vti file.

    >>> from volumehaptics import examples
    >>> examples.phantom_file().endswith("HeadPhantom.vti")
    True
    """
    return str(Path(__file__).parent / "data" / "HeadPhantom.vti")


def phantom() -> vtkImageData:
    """Returns the head phantom: 64 x 64 x 64 voxels of 3.75 mm in Hounsfield units (HU), the origin in its middle.

    +x is to the patient's left, +y to the back, +z to the top. RuntimeError: its file can't be read.

    >>> from volumehaptics import examples
    >>> examples.phantom().GetSpacing()
    (3.75, 3.75, 3.75)
    """
    reader = vtkXMLImageDataReader()
    if not reader.CanReadFile(phantom_file()):
        raise RuntimeError(f"{phantom_file()} can't be read. Cure: install the package again.")
    reader.SetFileName(phantom_file())
    reader.Update()
    return reader.GetOutput()


def _crown() -> float:
    """Returns the height of the skin above the origin (mm)."""
    head = phantom()
    values = head.GetPointData().GetScalars()
    for k in reversed(range(head.GetDimensions()[2])):
        point = head.FindPoint(0.0, 0.0, head.GetOrigin()[2] + k * head.GetSpacing()[2])
        if values.GetTuple1(point) > SKIN:
            return head.GetPoint(point)[2]
    raise RuntimeError("the phantom has no crown")


def stroke(depth: float = 3.0, length: float = 24.0, speed: float = 80.0, clearance: float = 5.0) -> vtkPolyData:
    """Makes the path of a tip that comes down on the phantom's crown, presses, slides from right to left and lifts.

    depth: depth of the press below the skin (mm), 0 or more. Default 3.
    length: length of the slide (mm), 0 or more. Default 24.
    speed: speed of the hand (mm/s), above 0. Default 80.
    clearance: height above the skin at which the path begins and ends (mm), 0 or more. Default 5.

    The path has one point for each tick of 1 ms, and the point array "Time" (s). ValueError: the settings make no path.

    >>> from volumehaptics import examples
    >>> low, high = examples.stroke(depth=3.0, clearance=5.0).GetBounds()[4:]
    >>> round(high - low, 6)
    8.0
    """
    crown = _crown()
    source = vtkHapticPathSource()
    with Errors(source) as errors, Errors(source.GetExecutive()) as quiet:
        source.SetShapeToPressAndSlide()
        source.SetBoxBounds(-length / 2, length / 2, 0.0, 0.0, crown, crown)  # the surface that the stroke presses on
        source.SetDepth(depth)
        source.SetClearance(clearance)
        source.SetSpeed(speed)
        source.Update()
    if errors or quiet:
        raise ValueError("; ".join(errors or quiet))
    return source.GetOutput()


def first_touch() -> None:
    """Prints the largest force on a hand that strokes the phantom's crown.

    >>> from volumehaptics import examples
    >>> examples.first_touch()
    1.432 N
    """
    trace = touch(phantom(), stroke(), preset="CT contrast")
    print(f"{trace.GetPointData().GetArray('Force').GetMaxNorm():.3f} N")
