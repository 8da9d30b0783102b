# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import difflib
import re
from typing import TYPE_CHECKING, Any

from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

from .vtkVolumeHaptics import vtkVolumeHapticsFilter

if TYPE_CHECKING:
    import numpy as np


class Errors(list):
    """What objects complain of, instead of on the console."""

    def __init__(self, *watched: Any) -> None:
        super().__init__()

        def note(_caller, _event, text):
            # Without the file and the line in it, which are of no help to who calls.
            self.append(re.sub(r"^ERROR: In .*, line \d+\n.*?\(\w+\): ", "", text).strip())

        note.CallDataType = VTK_STRING
        self._watched = [(one, one.AddObserver("ErrorEvent", note)) for one in watched]

    def end(self) -> None:
        """From here on, errors are for the console again."""
        while self._watched:
            one, tag = self._watched.pop()
            one.RemoveObserver(tag)


def _settings() -> list[str]:
    """The settings that can be read back, in snake_case."""
    names = dir(vtkVolumeHapticsFilter)
    return [
        re.sub(r"(?<!^)(?=[A-Z])", "_", name[3:]).lower()
        for name in names
        if name.startswith("Set") and f"G{name[1:]}" in names
    ]


def _set(haptics: vtkVolumeHapticsFilter, name: str, value: Any) -> bool:
    method = "Set" + "".join(word.capitalize() for word in name.split("_"))
    setter = getattr(haptics, method, None)
    if setter is None or name != name.lower():
        close = difflib.get_close_matches(name.lower(), _settings(), cutoff=0.4)
        raise TypeError(
            f"touch() has no setting {name!r}; "
            + (f"is it {' or '.join(map(repr, close))}? " if close else "")
            + "help(volumehaptics.vtkVolumeHapticsFilter) explains all of them"
        )
    return (setter(*value) if isinstance(value, tuple) else setter(value)) is not False


def touch(
    volume: vtkImageData | np.ndarray,
    tip: vtkPolyData | np.ndarray,
    preset: str | None = None,
    **settings: Any,
) -> vtkPolyData:
    """What a hand feels whose stylus goes through a volume.

    volume: a vtkImageData (pyvista.ImageData is one), or a NumPy array [z, y, x], voxels of 1 world unit from
        (0, 0, 0) on: see image() for others. It is not copied.
    tip: where the stylus is in world units (mm), one point a tick, 1 ms: a vtkPolyData, with a point array
        "Time" (s) where ticks are something else, or an array of shape (N, 3).
    preset: what the tissues feel like, "CT contrast", "CT physical" or "MRI": see vtkHapticProperty. Default:
        500 N/m everywhere.
    settings: what vtkVolumeHapticsFilter can be set to, in snake_case: kernel_radius=3 (voxels) is
        SetKernelRadius(3), method_by_name="force-field" SetMethodByName("force-field"), and property=... is a
        vtkHapticProperty of one's own. A tuple is several arguments.

    The trace has a point for each tick, at the proxy (world units), and point arrays such as "Force" (N, on the
    hand): see vtkVolumeHapticsFilter. arrays.arrays(trace) has them as NumPy arrays; so have trace.point_data["Force"]
    with VTK 9.4 or later, and, where PyVista is imported, which does without that, pyvista.wrap(trace)["Force"].

    TypeError: a setting that there is not, or data of another kind. ValueError: data, a preset or a value that
    can't be touched; the text says why, and what helps. RuntimeError: the pipeline failed.

    >>> from volumehaptics import examples, touch
    >>> trace = touch(examples.phantom(), examples.stroke(), preset="CT contrast", kernel_radius=3)
    >>> trace.GetPointData().GetArray("Force").GetNumberOfComponents()
    3
    """
    if isinstance(volume, vtkImageData):
        image = volume
    else:
        from . import arrays

        image = arrays.image(volume)
    if isinstance(tip, vtkPolyData):
        path = tip
    else:
        from . import arrays

        path = arrays.path(tip)
    if preset is not None and "property" in settings:
        raise TypeError("touch() takes a preset or a property, not both: call the property's ApplyPreset()")

    haptics = vtkVolumeHapticsFilter()
    errors, failures = Errors(haptics, haptics.GetProperty()), Errors(haptics.GetExecutive())
    try:
        for name, value in settings.items():
            if not _set(haptics, name, value):
                raise ValueError("; ".join(errors) or f"{name}={value!r} is not known")
        if preset is not None and not haptics.GetProperty().ApplyPreset(preset):
            raise ValueError("; ".join(errors))
        haptics.SetInputData(image)
        haptics.SetPathData(path)
        haptics.Update()
    finally:
        # Who is watched and who watches keep each other, and the volume with them, until Python looks for garbage.
        errors.end()
        failures.end()
    # The executive only repeats that the filter failed.
    if errors:
        raise ValueError("; ".join(errors))
    if failures:
        raise RuntimeError("; ".join(failures))
    return haptics.GetOutput()
