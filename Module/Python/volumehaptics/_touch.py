# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import ctypes
import difflib
import functools
import numbers
import os
import re
import sys
import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, overload

from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataSet, vtkImageData, vtkPolyData

from . import vtkVolumeHaptics
from ._grids import is_grid, overview, suggest_mode, unwrap
from ._labels import Labels, Materials, set_labels
from ._tools import make_tool
from .vtkVolumeHaptics import vtkHapticProperty, vtkHapticRegionSource, vtkVolumeHapticsFilter

if TYPE_CHECKING:
    import numpy as np


def plain(text: str) -> str:
    """Returns a message of VTK without source file and line, which do not help the caller."""
    return re.sub(r"^(ERROR|Warning): In .*, line \d+\n.*?\(\w+\): ", "", text).strip()


class Errors(list):
    """Collects errors (or, with an event, warnings) of objects in a with statement, instead of printing them.

    Observers are removed at the end of the statement. Otherwise observer and object would reference each other, and
    keep a volume alive until Python's garbage collection.
    """

    def __init__(self, *watched: Any, event: str = "ErrorEvent") -> None:
        super().__init__()

        def note(_caller, _event, text):
            self.append(plain(text))

        note.CallDataType = VTK_STRING
        self._watched = [(one, one.AddObserver(event, note)) for one in watched]

    def __enter__(self) -> Errors:
        return self

    def __exit__(self, *_: object) -> None:
        for one, tag in self._watched:
            one.RemoveObserver(tag)
        self._watched.clear()


def _settings() -> list[str]:
    """Returns the names of settings that can be read back, in snake_case."""
    names = dir(vtkVolumeHapticsFilter)
    return [
        re.sub(r"(?<!^)(?=[A-Z])", "_", name[3:]).lower()
        for name in names
        if name.startswith("Set") and f"G{name[1:]}" in names
    ]


def _unknown(name: str) -> str:
    """Returns a hint on settings with names similar to one that does not exist."""
    plain = name.replace("_", "").lower()
    known = _settings()
    close = [one for one in known if one.replace("_", "") == plain]
    if not close and hasattr(vtkHapticProperty, f"Get{_in_camel_case(name)}"):
        return f"the material has it: property=p, with p = vtkHapticProperty(), and p.Get{_in_camel_case(name)}()"
    close = close or difflib.get_close_matches(name.lower(), known, cutoff=0.4)
    return (f"is it {' or '.join(map(repr, close))}? " if close else "") + (
        "help(volumehaptics.vtkVolumeHapticsFilter) explains all of them")


def _in_camel_case(name: str) -> str:
    return "".join(word.capitalize() for word in name.split("_"))


def _by_name(name: str, value: Any) -> str:
    """Returns a hint on the value that may be meant if a word was given instead of a number."""
    if not isinstance(value, str):
        return ""
    if hasattr(vtkVolumeHapticsFilter, f"Set{_in_camel_case(name)}ByName"):
        return f"; is it {name}_by_name={value!r}?"
    meant = re.sub(r"[^a-z0-9]", "", f"set{name}to{value}".lower())
    known = any(method.lower() == meant for method in dir(vtkVolumeHapticsFilter))
    constant = re.sub(r"\W", "_", value).upper()
    return f"; is it {name}=vtkVolumeHapticsFilter.{constant}?" if known else ""


def _set(haptics: vtkVolumeHapticsFilter, name: str, value: Any, caller: str) -> bool:
    """Sets a value. Returns False if the filter does not know it; the filter's error may have the reason. ValueError:
    the number is out of range, so that the filter would clamp it."""
    setter = getattr(haptics, f"Set{_in_camel_case(name)}", None)
    if setter is None or name != name.lower():
        raise TypeError(f"{caller}() has no setting {name!r}; {_unknown(name)}")
    if name == "tool":
        value = make_tool(value)
    if name == "trace_arrays" and isinstance(value, (list, tuple)) and all(isinstance(one, str) for one in value):
        value = ", ".join(value) or "none"
    try:
        known = setter(*value) if isinstance(value, tuple) else setter(value)
    except TypeError:
        takes = setter.__doc__.splitlines()[0]
        raise TypeError(f"{name}={value!r} is of a type that can't be set: {takes}{_by_name(name, value)}") from None
    if isinstance(value, numbers.Real) and (getter := getattr(haptics, f"Get{_in_camel_case(name)}", None)):
        if getter() != value:
            raise ValueError(f"{name}={value!r} is out of range; the nearest valid one is {getter()!r}")
    return known is not False


def apply_preset(material: vtkHapticProperty, name: str, volume: Any) -> bool:
    """Applies a preset. Fits it to the grey levels of a large volume, or of an image with scalars at its points."""
    if name == "MRI" and isinstance(volume, vtkHapticRegionSource):
        source, volume = volume, vtkImageData()
        # Read only 3 x 3 x 3 samples: ReadRegion() adds field arrays that describe the whole volume, such as its noise
        # (WholeFacts.h), to which the preset is fitted. If the read fails, apply the preset without fitting it.
        if not source.ReadRegion([one + end for one in source.GetWholeExtent()[::2] for end in (0, 2)], volume):
            return material.ApplyPreset(name)
    if isinstance(volume, vtkImageData) and volume.GetPointData().GetScalars() is not None:
        return material.ApplyPreset(name, volume)
    return material.ApplyPreset(name)


def configure(
    haptics: vtkVolumeHapticsFilter,
    image: vtkImageData,
    preset: str | None,
    settings: dict[str, Any],
    errors: Errors,
    caller: str,
    large: vtkHapticRegionSource | None = None,
) -> None:
    """Applies the settings, then the preset. An unknown setting is an error, which `errors` may explain. `image` is the
    coarse level of a large volume."""
    for name, value in settings.items():
        if not _set(haptics, name, value, caller):
            raise ValueError("; ".join(errors) or f"{name}={value!r} is not known")
    material = haptics.GetProperty()
    if preset == "propose":
        known = material.ProposeFromImage(image)
        if known and "kernel_radius" not in settings:
            haptics.SetKernelRadius(material.GetProposedKernelRadius())
    else:
        known = preset is None or apply_preset(material, preset, large or image)
    if not known:
        raise ValueError("; ".join(errors))


def choose_mode(
    haptics: vtkVolumeHapticsFilter,
    volume: Any,
    image: vtkImageData | None,
    mode: str | None,
    preset: str | None,
    settings: dict[str, Any],
    errors: Errors,
) -> None:
    """Applies the modes of the named preset. Without a name, applies modes that suit a grid of vectors or tensors."""
    said = preset is not None or any(name in settings for name in ("property", "method", "method_by_name"))
    if mode is None and is_grid(volume) and not said:
        mode = suggest_mode(image)
    if mode is not None and not haptics.ApplyModePreset(mode, image):
        raise ValueError("; ".join(errors))


def frame_of(source: vtkHapticRegionSource) -> vtkImageData:
    """Returns the extent and the position of a large volume, without its samples."""
    frame = vtkImageData()
    frame.SetExtent(source.GetWholeExtent())
    frame.SetOrigin(source.GetOrigin())
    frame.SetSpacing(source.GetSpacing())
    frame.SetDirectionMatrix(source.GetDirection())
    return frame


def _misses(volume: vtkImageData, tip: vtkPolyData, trace: vtkPolyData) -> bool:
    force = trace.GetPointData().GetArray("Force")
    if not trace.GetNumberOfPoints() or (force is not None and force.GetMaxNorm() > 0):
        return False
    box, way = volume.GetBounds(), tip.GetBounds()
    return any(way[i + 1] < box[i] or way[i] > box[i + 1] for i in (0, 2, 4))


def _warn(text: str) -> None:
    """Warns with the line of the caller outside this package."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    warnings.warn(text, stacklevel=level)


def _warn_outside(volume: vtkImageData, tips: list[vtkPolyData], traces: list[vtkPolyData]) -> None:
    """Warns about paths that miss the volume, because they give zero force and are seldom intended."""
    out = [i for i, (tip, trace) in enumerate(zip(tips, traces)) if _misses(volume, tip, trace)]
    if out:
        bounds = tips[out[0]].GetBounds(), volume.GetBounds()
        show = ["{:g} to {:g}, {:g} to {:g}, {:g} to {:g}".format(*one) for one in bounds]
        which = f" in path {out[0]} (from 0), the first of {len(out)}," if len(tips) > 1 else ""
        _warn(f"the way of the tip{which} (x, y, z: {show[0]}) is outside of the volume ({show[1]}), and feels nothing")


@functools.lru_cache(maxsize=1)
def _library() -> ctypes.CDLL:
    """Loads the library so that other Python threads run during its calls, which VTK's wrappers before VTK 9.4 do not
    allow."""
    library = ctypes.CDLL(vtkVolumeHaptics.__file__)
    library.vtkVolumeHapticsFilterUpdate.argtypes = [ctypes.c_void_p]
    library.vtkVolumeHapticsFilterUpdate.restype = None
    return library


def _update(haptics: vtkVolumeHapticsFilter) -> None:
    """Calls Update() while other Python threads run."""
    _library().vtkVolumeHapticsFilterUpdate(int(haptics.__this__.split("_")[1], 16))


def _are_several(tip: Any) -> bool:
    """Whether an argument is several paths, and not the points of one path."""
    if not isinstance(tip, (list, tuple)) or not tip:
        return False
    first = tip[0]
    if isinstance(first, (list, tuple)):
        return bool(first) and hasattr(first[0], "__len__")
    return isinstance(first, vtkPolyData) or getattr(first, "ndim", 1) > 1


def _path(tip: vtkPolyData | np.ndarray | Sequence) -> vtkPolyData:
    if isinstance(tip, vtkPolyData):
        return tip
    from . import arrays

    return arrays.path(tip)


class _Feeling:
    """A filter that computes one path after another, and raises its errors as exceptions."""

    def __init__(self, haptics: vtkVolumeHapticsFilter, errors: Errors, failures: Errors) -> None:
        self._haptics, self._errors, self._failures = haptics, errors, failures

    def feel(self, path: vtkPolyData | None) -> vtkPolyData:
        """Returns the trace of a path. The next path does not change it."""
        self._haptics.SetPathData(path)
        _update(self._haptics)
        # Omit the executive's own error, which only repeats that the filter failed.
        if self._errors:
            raise ValueError("; ".join(self._errors))
        if self._failures:
            raise RuntimeError("; ".join(self._failures))
        trace = vtkPolyData()
        trace.ShallowCopy(self._haptics.GetOutput())
        return trace

    def feel_all(self, paths: list[vtkPolyData]) -> list[vtkPolyData]:
        """Returns the trace of each path, computing as many at once as there are cores. Errors name the number of the
        path."""
        from . import _paths

        try:
            traces = {}
            for group in _paths.groups(paths):
                if len(group) == 1:
                    traces[group[0]] = self.feel(paths[group[0]])
                else:
                    together = self.feel(_paths.together([paths[i] for i in group]))
                    traces.update(zip(group, _paths.apart(together)))
            return [traces[i] for i in range(len(paths))]
        except ValueError:
            self._forget()
        self.feel(None)  # raises errors that don't depend on a path
        for i, path in enumerate(paths):
            try:
                self.feel(path)
            except ValueError as error:
                raise ValueError(f"path {i} (from 0): {error}") from None
        raise AssertionError("paths that can be felt alone can be felt together")

    def _forget(self) -> None:
        self._errors.clear()
        self._failures.clear()


@overload
def touch(
    volume: vtkDataSet | vtkCompositeDataSet | np.ndarray | vtkHapticRegionSource | str | os.PathLike,
    tip: vtkPolyData | np.ndarray,
    preset: str | None = None,
    *,
    mode: str | None = None,
    labels: Labels | None = None,
    materials: Materials | None = None,
    series: int = 0,
    **settings: Any,
) -> vtkPolyData: ...


@overload
def touch(
    volume: vtkDataSet | vtkCompositeDataSet | np.ndarray | vtkHapticRegionSource | str | os.PathLike,
    tip: Sequence[vtkPolyData | np.ndarray],
    preset: str | None = None,
    *,
    mode: str | None = None,
    labels: Labels | None = None,
    materials: Materials | None = None,
    series: int = 0,
    **settings: Any,
) -> list[vtkPolyData]: ...


def touch(
    volume: vtkDataSet | vtkCompositeDataSet | np.ndarray | vtkHapticRegionSource | str | os.PathLike,
    tip: vtkPolyData | np.ndarray | Sequence[vtkPolyData | np.ndarray],
    preset: str | None = None,
    *,
    mode: str | None = None,
    labels: Labels | None = None,
    materials: Materials | None = None,
    series: int = 0,
    **settings: Any,
) -> vtkPolyData | list[vtkPolyData]:
    """Computes the forces on a hand whose stylus moves through a volume.

    volume: a vtkImageData (pyvista.ImageData is one), or a NumPy array [z, y, x], voxels of 1 world unit from
        (0, 0, 0) on: see image() for others. It is not copied. Or a volume larger than memory: see open_large().
        Or a rectilinear, structured or unstructured grid, or a composite data set of these, as vtkOpenFOAMReader
        has it: its point and cell arrays are felt, resampled along the path. Or a volume
        of vedo, of tvtk (Mayavi) or of nibabel (MNE, nilearn). Or a file or folder that volumehaptics-explore reads,
        such as a folder of DICOM slices: as there, left-posterior-superior in mm, and what was assumed, dropped, filled
        or turned is a UserWarning.
    tip: positions of the stylus in world units (mm), one point a tick, 1 ms: a vtkPolyData, with a point array
        "Time" (s) if ticks are something else, or an array of shape (N, 3). A list of these is several paths, which
        are felt as if each were alone, and on all cores: the result is the list of their traces, in this order.
        Several polylines in a vtkPolyData are several paths, too: their trace has a line for each.
    preset: how the tissues feel, such as "CT contrast" or "MRI": see vtkHapticProperty. Default:
        500 N/m everywhere. Or a file ".json" that vtkHapticProperty.WritePreset() has written, or key F8 of
        volumehaptics-explore. "propose", for data of any unit: functions from the edges of the volume, with the kernel
        radius that suits them unless settings have one: see vtkHapticProperty.ProposeFromImage().
    mode: a way to feel vectors, tensors or vessels, such as "Follow the flow", "Find a vortex" or "Slide along
        fibres": see vtkVolumeHapticsFilter.ApplyModePreset(). Default: none for an image; for a grid without a preset,
        method or property, "Follow the flow" if it has vectors, or else "Slide along fibres" if it has tensors.
    labels: a segmentation: a vtkImageData of whole numbers with a geometry of its own, or an array [z, y, x] with
        the volume's voxels. Its field data may have the names: see vtkHapticLabelTable.WriteFieldData(). Or a file,
        .seg.nrrd, .nii, .nii.gz, .mgz, .mnc, .mha, .mhd, .vti or a DICOM SEG (.dcm), or a folder with a mask for each
        organ, with its names, if it has any. It lies where it says, if the
        volume has a place, too, in left-posterior-superior or right-anterior-superior: see image(). Labels that lie
        elsewhere than a volume without one, or on other voxels, are refused.
    materials: how the labels feel: {"liver": dict(stiffness=300, surface_strength=1.5), 52: dict(felt=False)},
        by name or number, with the quantities of vtkHapticLabelTable; or such a table, or a file for its
        ReadFile(), or several of these, of which the later ones add to the earlier ones. What is not set comes from
        the preset.
    series: which series of a DICOM folder, which segment of a segmentation, or which channel, time or component of
        another file, from 1 on. Default: the series with most pixels, all segments, or the first one; a UserWarning
        says what there is.
    settings: what vtkVolumeHapticsFilter can be set to, in snake_case: kernel_radius=3 (voxels) is
        SetKernelRadius(3), method_by_name="force-field" SetMethodByName("force-field"), and property=... is a
        vtkHapticProperty of one's own. tool=vtkHapticNeedle() puts a needle into the hand, and
        tool="drill.stl", or a vtkPolyData, a tool of that closed surface, in world units: see vtkHapticPointShell;
        tool=vtkHapticBurr() removes tissue. A tuple is several arguments. trace_arrays=["Force", "Contact"] are the
        only arrays that the trace gets, which takes less time and memory.

    The trace has a point for each tick, at the proxy (world units), and point arrays such as "Force" (N, on the
    hand): see vtkVolumeHapticsFilter. arrays.arrays(trace) has them as NumPy arrays; so have trace.point_data["Force"]
    with VTK 9.4 or later, and, with older VTK but PyVista imported, pyvista.wrap(trace)["Force"].

    Other threads of Python run meanwhile.

    TypeError: a setting that does not exist, or data of another kind. ValueError: data, a preset or a value that can't
    be touched; the text has the reason and the cure. RuntimeError: the pipeline failed. UserWarning: the path of the
    tip is outside the volume.

    >>> from volumehaptics import examples, touch
    >>> trace = touch(examples.phantom(), examples.stroke(), preset="CT contrast", kernel_radius=3)
    >>> trace.GetPointData().GetArray("Force").GetNumberOfComponents()
    3
    """
    is_file = isinstance(volume, (str, os.PathLike))
    if is_file:
        from ._files import read

        volume, notes = read(volume, series)
        if notes:
            _warn("\n".join(notes))
    elif series:
        raise TypeError("series is of a file or a folder: give its name as the volume")
    volume = unwrap(volume)
    source = volume if isinstance(volume, vtkHapticRegionSource) else None
    if source is not None:
        image = frame_of(source)
        if preset == "propose" and source.GetCoarseImage() is None:
            raise ValueError("functions can't be proposed for a volume that is larger than memory. Cure: give "
                             "open_large() a coarse level, or propose them for a part of it and give property=...")
    elif isinstance(volume, vtkImageData):
        image = volume
    elif is_grid(volume):
        image = overview(volume)
    else:
        from . import arrays

        image = arrays.image(volume)
    several = _are_several(tip)
    paths = [_path(one) for one in tip] if several else [_path(tip)]
    if preset is not None and "property" in settings:
        raise TypeError("touch() takes a preset or a property, not both: call the property's ApplyPreset()")

    haptics = vtkVolumeHapticsFilter()
    with Errors(haptics, haptics.GetProperty()) as errors, Errors(haptics.GetExecutive()) as failures, Errors(
            haptics, event="WarningEvent") as told:
        coarse = source.GetCoarseImage() if source is not None else None
        configure(haptics, coarse or image, preset, settings, errors, "touch", source)
        if source is not None:
            haptics.SetInputConnection(source.GetOutputPort())
        else:
            haptics.SetInputDataObject(0, volume if is_grid(volume) else image)
        choose_mode(haptics, volume, image if source is None else coarse, mode, preset, settings, errors)
        set_labels(haptics, image, labels, materials, is_file)
        feeling = _Feeling(haptics, errors, failures)
        traces = feeling.feel_all(paths) if several else [feeling.feel(paths[0])]
    for text in told:
        _warn(text)
    _warn_outside(image, paths, traces)
    return traces if several else traces[0]
