# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Opens volumes larger than memory: any object that provides the samples of a box."""

from __future__ import annotations

import atexit
import ctypes
import itertools
import math
import mmap
import os
import sys
import time
import weakref
from collections.abc import Sequence
from typing import Any, NamedTuple

try:
    import numpy as np
except ImportError as error:
    raise ImportError("volumehaptics.open_large() needs NumPy. Cure: pip install numpy, or apt-get install "
                      "python3-numpy.") from error
from vtkmodules.vtkCommonCore import (
    VTK_DOUBLE,
    VTK_FLOAT,
    VTK_INT,
    VTK_LONG_LONG,
    VTK_SHORT,
    VTK_SIGNED_CHAR,
    VTK_UNSIGNED_CHAR,
    VTK_UNSIGNED_INT,
    VTK_UNSIGNED_LONG_LONG,
    VTK_UNSIGNED_SHORT,
    vtkWeakReference,
)

from vtkmodules.vtkCommonDataModel import vtkImageData

from . import vtkVolumeHaptics
from ._files import in_words
from ._touch import Errors, _warn
from .arrays import image
from .vtkVolumeHaptics import vtkHapticRegionSource

__all__ = ["open_large"]

_TYPES = {
    "int8": VTK_SIGNED_CHAR,
    "uint8": VTK_UNSIGNED_CHAR,
    "int16": VTK_SHORT,
    "uint16": VTK_UNSIGNED_SHORT,
    "int32": VTK_INT,
    "uint32": VTK_UNSIGNED_INT,
    "int64": VTK_LONG_LONG,
    "uint64": VTK_UNSIGNED_LONG_LONG,
    "float32": VTK_FLOAT,
    "float64": VTK_DOUBLE,
}

# A call of a ctypes function waits for Python's lock, on whatever thread. During a call into the library, other Python
# threads can run.
_Read = ctypes.CFUNCTYPE(
    ctypes.c_int, ctypes.c_void_p, ctypes.POINTER(ctypes.c_int), ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int)
_Release = ctypes.CFUNCTYPE(None, ctypes.c_void_p)


class _Array(NamedTuple):
    """An array that C++ may read, with the source that reads it."""

    array: Any
    dtype: np.dtype
    source: vtkWeakReference


class _Source(vtkHapticRegionSource):
    """A source that lives as long as any of its output ports is in use. VTK's ports do not hold their source."""

    def GetOutputPort(self, *index: int) -> Any:
        port = super().GetOutputPort(*index)
        weakref.finalize(port, _let_go, self)
        return port


def _let_go(_source: _Source) -> None:
    pass


_arrays: dict[int, _Array] = {}
_numbers = itertools.count(1)
_MOST_COARSE = 2**22  # largest number of voxels of a coarse level


def _expect_in_file(part: np.ndarray) -> None:
    """Raises an error if a mapped file ends before a part of it, because reading beyond its end would end the program
    (SIGBUS)."""
    mapped = part
    while isinstance(mapped.base, np.ndarray):
        mapped = mapped.base
    if not (isinstance(mapped, np.memmap) and isinstance(mapped.base, mmap.mmap)):
        return
    ahead = sum((count - 1) * stride for count, stride in zip(part.shape, part.strides) if stride > 0)
    end = mapped.offset + part.ctypes.data + ahead + part.itemsize - mapped.ctypes.data
    size = mapped.base.size()
    if end > size:
        raise OSError(f"{mapped.filename or 'the file'} ends at byte {size}, and the samples at byte {end}: it was cut off "
                      "after it was opened. Cure: write it again")


def _fill(array: Any, dtype: np.dtype, extent: Any, samples: int) -> None:
    """Reads a box of an array into memory."""
    x0, x1, y0, y1, z0, z1 = extent[:6]
    shape = (z1 - z0 + 1, y1 - y0 + 1, x1 - x0 + 1)
    part = np.asarray(array[z0 : z1 + 1, y0 : y1 + 1, x0 : x1 + 1])
    if part.shape != shape:
        raise ValueError(f"its part is of shape {part.shape}, not {shape}")
    _expect_in_file(part)
    memory = (ctypes.c_char * (dtype.itemsize * part.size)).from_address(samples)
    np.copyto(np.frombuffer(memory, dtype).reshape(shape), part, casting="same_kind")


@_Read
def _read(number: int, extent: Any, samples: int, why: int, room: int) -> int:
    try:
        one = _arrays[number]
        _fill(one.array, one.dtype, extent, samples)
    except BaseException as error:  # any exception, because C++ would discard it
        text = f"{type(error).__name__}: {error}".encode()[: room - 1] + b"\0"
        ctypes.memmove(why, text, len(text))
        return 0
    return 1


@_Release
def _release(number: int) -> None:
    _arrays.pop(number, None)


def _set_reader(source: vtkHapticRegionSource, read: Any, number: int) -> None:
    library = ctypes.CDLL(vtkVolumeHaptics.__file__)
    library.vtkHapticRegionSourceSetReader.argtypes = [ctypes.c_void_p, _Read, _Release, ctypes.c_void_p]
    library.vtkHapticRegionSourceSetReader.restype = None
    library.vtkHapticRegionSourceSetReader(int(source.__this__.split("_")[1], 16), read, _release, number)


def _let_read(_source: vtkHapticRegionSource, _event: str) -> None:
    """Releases Python's lock for the reading thread, because VTK's event loop holds the lock all the time."""
    time.sleep(sys.getswitchinterval())


_process = os.getpid()


@atexit.register
def _end_reading() -> None:
    """Stops reading before Python ends, because no thread may call Python after that."""
    if os.getpid() != _process:
        return  # in a forked process, the threads belong to the parent
    for one in list(_arrays.values()):
        source = one.source.Get()
        if source is not None:
            _set_reader(source, _Read(), 0)
    while _arrays:
        time.sleep(0.001)


class _Volume:
    """The volume [z, y, x] of an array with further axes before these, at one chosen index along each of them."""

    def __init__(self, array: Any, before: tuple[int, ...]) -> None:
        self._array, self._before = array, before
        self.shape, self.dtype = tuple(array.shape[len(before):]), array.dtype

    def __getitem__(self, box: tuple[slice, ...]) -> Any:
        return self._array[(*self._before, *box)]


def _scale_and_translation(transformations: list, axes: int) -> tuple[list[float], list[float]]:
    """Returns the spacing and the origin in OME-Zarr's coordinate transformations, along all axes."""
    scale, translation = [1.0] * axes, [0.0] * axes
    for one in transformations:
        if one.get("type") == "scale" and "scale" in one:
            scale = [a * b for a, b in zip(scale, one["scale"])]
            translation = [a * b for a, b in zip(translation, one["scale"])]
        elif one.get("type") == "translation" and "translation" in one:
            translation = [a + b for a, b in zip(translation, one["translation"])]
        elif one.get("type") != "identity":
            raise ValueError(f"its coordinate transformation {one!r} is neither a scale nor a translation. Cure: open "
                             "its array with zarr, and give open_large() that, with spacing and origin")
    return scale, translation


def _units(axes: list) -> list[str]:
    """Returns the names of the units of the last three axes; empty ones if they are not known."""
    return [str(one.get("unit", "")) if isinstance(one, dict) else "" for one in axes[-3:]] or [""] * 3


def _in_millimetres(lengths: Sequence[float], axes: list) -> list[float]:
    """Converts lengths along the last three axes, which are z, y and x, to millimetres. Returns them as x, y and z."""
    names = _units(axes)
    units = [vtkHapticRegionSource.GetMillimetersPerUnit(name) or 1.0 for name in names]
    return [length * unit for length, unit in zip(lengths[-3:], units)][::-1]


class _Level(NamedTuple):
    """A volume, and its spacing and origin along x, y and z, if they are known, and whether it tells their unit."""

    array: Any
    spacing: Sequence[float] | None = None
    origin: Sequence[float] | None = None
    has_unit: bool = True


def _choose(shape: Sequence[int], path: str, series: int) -> tuple[int, ...]:
    """Returns the indices along the axes before z, y and x of the volume with a number, from 1 on; 0: the first one."""
    count = math.prod(shape)
    if series and count == 1:
        raise ValueError(f"{path} has one volume only, which needs no number. Cure: leave series out")
    if not 0 <= series <= count:
        raise ValueError(f"{path} has {count} volumes, and none with the number {series}. Cure: use series=1 to "
                         f"series={count}")
    return tuple(int(one) for one in np.unravel_index(max(series, 1) - 1, shape)) if shape else ()


def _open_dataset(group: Any, path: str, scales: dict, dataset: dict, series: int) -> _Level:
    if dataset["path"] not in group:
        raise ValueError(f"{path} has no array {dataset['path']}, which is one of its levels: it may not have been "
                         "copied. Cure: copy it, or open another level")
    array = group[dataset["path"]]
    axes = len(array.shape)
    names = [one["name"] if isinstance(one, dict) else one for one in scales.get("axes", "tczyx"[-axes:])]
    if axes < 3 or [name.lower() for name in names[-3:]] != ["z", "y", "x"]:
        raise ValueError(f"{path} has the axes {names}, and a volume needs z, y and x, as the last ones. Cure: open its "
                         "array with zarr, and give open_large() that, transposed, with spacing and origin")
    steps = [*dataset.get("coordinateTransformations", []), *scales.get("coordinateTransformations", [])]
    scale, translation = _scale_and_translation(steps, axes)
    told = scales.get("axes", [])
    known = all(vtkHapticRegionSource.GetMillimetersPerUnit(name) for name in _units(told))
    return _Level(_Volume(array, _choose(array.shape[:-3], path, series)), _in_millimetres(scale, told),
                  _in_millimetres(translation, told), known)


def _open_multiscales(group: Any, path: str, level: int, series: int) -> list[_Level]:
    """Opens the levels of an OME-Zarr group, from the wanted level to the coarsest."""
    attributes = dict(group.attrs)
    if "bioformats2raw.layout" in attributes.get("ome", attributes) and "1" not in group:
        group, attributes = group["0"], dict(group["0"].attrs)  # a collection that contains one image
    scales = attributes.get("ome", attributes).get("multiscales")
    if not scales:
        raise ValueError(f"{path} is a Zarr group without OME-Zarr's multiscales. Cure: open one of its arrays with "
                         "zarr, and give open_large() that")
    datasets = scales[0]["datasets"]
    if not -len(datasets) <= level < len(datasets):
        raise ValueError(f"{path} has {len(datasets)} levels, from 0 on, and none of number {level}")
    levels = []
    for dataset in datasets[level % len(datasets):]:
        try:
            levels.append(_open_dataset(group, path, scales[0], dataset, series))
        except (KeyError, ValueError):
            if not levels:
                raise
            break  # coarser levels are optional
    return levels


def _open_array(array: Any, path: str, series: int) -> _Level:
    return _Level(_Volume(array, _choose(array.shape[:-3], path, series)) if series else array)


def _open_path(path: str, level: int, series: int) -> list[_Level]:
    if path.endswith(".npy"):
        try:
            array = np.load(path, mmap_mode="r")
        except (EOFError, ValueError) as error:
            raise ValueError(f"{path} can't be read by NumPy: {error}. Cure: check that its copy is complete") from error
        return [_open_array(array, path, series)]
    if os.path.exists(path) and not path.endswith(".zip") and vtkHapticRegionSource.GetFileFormat(path) == "":
        raise ValueError(f"{path} can't be read in parts: that works for Zarr, .npy, "
                         f"{vtkHapticRegionSource.GetFileEndings().replace(' ', ', ')}. Cure: give it to touch(), which reads "
                         "it as a whole; or convert it")
    try:
        import zarr
    except ImportError as error:
        raise ImportError(f"{path} is opened with zarr, which is not installed. Cure: pip install zarr; or open it "
                          "with another library, and give open_large() the array") from error
    try:
        opened = zarr.open(path, mode="r")
    except Exception as error:  # zarr raises many types
        raise ValueError(f"{path} can't be opened by zarr: {type(error).__name__}: {error}. Cure: check that its copy is "
                         "complete") from error
    if hasattr(opened, "shape"):
        return [_open_array(opened, path, series)]
    return _open_multiscales(opened, path, level, series)


def _choose_coarse(levels: list[_Level]) -> _Level | None:
    """Returns the finest coarser level that is small enough to stay in memory; None if there is none."""
    return next((one for one in levels[1:] if np.prod(one.array.shape, dtype=float) <= _MOST_COARSE), None)


def _beside(coarse: Any, fine: _Level) -> _Level:
    """Places a coarse image over the box of a volume whose spacing and origin are known."""
    ratio = [f / c for f, c in zip(fine.array.shape[::-1], coarse.shape[::-1])]
    spacing = [s * r for s, r in zip(fine.spacing, ratio)]
    return _Level(coarse, spacing, [o + 0.5 * (c - s) for o, c, s in zip(fine.origin, spacing, fine.spacing)])


def _read_coarse(level: _Level) -> vtkImageData:
    part = np.ascontiguousarray(np.asarray(level.array[:, :, :]))
    return image(part.astype(part.dtype.newbyteorder("="), copy=False), level.spacing, level.origin)


def _three(what: str, numbers: Sequence[float]) -> tuple[float, ...]:
    if np.shape(numbers) != (3,):
        raise ValueError(f"{what} is three numbers, along x, y and z, not {numbers!r}")
    return tuple(float(one) for one in numbers)


def _find_coarse(coarse: Any, levels: list[_Level], fine: _Level) -> vtkImageData | None:
    if coarse is None:
        found = _choose_coarse(levels)
        own = found is not None and (tuple(levels[0].spacing), tuple(levels[0].origin)) == (fine.spacing, fine.origin)
        return None if found is None else _read_coarse(found if own else _beside(found.array, fine))
    if coarse is False or isinstance(coarse, vtkImageData):
        return coarse or None
    if len(getattr(coarse, "shape", ())) != 3 or 0 in coarse.shape:
        raise TypeError("coarse is an array [z, y, x] with voxels, a vtkImageData, or False, not "
                        f"{type(coarse).__name__}")
    return _read_coarse(_beside(coarse, fine))


def _open_in_cpp(path: str, spacing: Any, origin: Any, coarse: Any, series: int) -> vtkHapticRegionSource:
    """Opens a file that C++ reads itself, on threads that do not need Python's lock."""
    source = _Source()
    with Errors(source) as errors:
        if not source.OpenFile(path, series):
            raise ValueError(in_words(errors[0]))
    if source.GetFileNotes():
        _warn(in_words(source.GetFileNotes()))
    if spacing is not None:
        source.SetSpacing(_three("spacing", spacing))
    if origin is not None:
        source.SetOrigin(_three("origin", origin))
    if coarse is not None or spacing is not None or origin is not None:
        coarse = coarse or None
        if coarse is not None and not isinstance(coarse, vtkImageData):
            raise TypeError(f"the coarse level of {path} is a vtkImageData, or False, not {type(coarse).__name__}")
        source.SetCoarseImage(coarse)  # replaces the file's own coarse image, which has another position
    return source


def open_large(
    array_or_path: Any,
    spacing: Sequence[float] | None = None,
    origin: Sequence[float] | None = None,
    level: int = 0,
    coarse: Any = None,
    series: int = 0,
) -> vtkHapticRegionSource:
    """Opens a volume that is too large for memory, so that it is read where the hand needs it.

    array_or_path: anything with shape and dtype whose parts [z0:z1, y0:y1, x0:x1] NumPy accepts: an array of Zarr,
        HDF5 (h5py), dask or tensorstore, a DataArray of xarray, a numpy.memmap; or the path of a Zarr array, of an
        OME-Zarr image, of a .npy file, or of a file that vtkHapticRegionSource.OpenFile() reads.
    spacing: the size of a voxel along x, y and z (world units, mm). Default: that of an OME-Zarr image, in mm if
        its axes name a unit of OME-NGFF, or of the file; else 1, with a warning for what is in a file.
    origin: the position of the first voxel (world units, mm): x, y and z. Default: that of an OME-Zarr image or of
        the file; else 0.
    level: the level of an OME-Zarr image: 0 is the finest, -1 the coarsest.
    coarse: a smaller array of the same box, which is read at once and stays in memory, or a vtkImageData in the same
        world. Live, it replaces late samples, with half of its force; windows show it. Default:
        of an OME-Zarr image, its finest coarser level of at most 2^22 voxels; else nothing. False: nothing.
    series: which time, channel or component of a file or folder with several, from 1 on. Default: the first one.

    The result is a vtkHapticRegionSource. touch() takes it instead of a volume, and feels what it would feel with the
    whole volume in memory, to the bit. A vtkVolumeHapticsFilter takes its GetOutputPort(), live as well: then a thread
    reads around the tip, and needs Python's lock for that; so vtkHapticDevice.UpdateState(), which the interactor style
    calls, lets others have it for 5 ms while samples are awaited. What the array raises while it is read is an error of
    the filter or of the source.

    TypeError: no such array, or numbers of another kind. ValueError: not three dimensions, or no voxels; a spacing or an
    origin that is not three numbers; a level that does not exist; a file that can't be read. ImportError: a path
    that needs zarr.

    >>> import numpy as np
    >>> from volumehaptics import open_large
    >>> open_large(np.zeros((30, 20, 10), np.int16), spacing=(0.5, 0.5, 2.0)).GetWholeExtent()
    (0, 9, 0, 19, 0, 29)
    """
    levels = [_Level(array_or_path)]
    if isinstance(array_or_path, (str, os.PathLike)):
        # these formats are read without Python
        if vtkHapticRegionSource.GetFileFormat(os.fspath(array_or_path)) not in ("", "Zarr"):
            return _open_in_cpp(os.fspath(array_or_path), spacing, origin, coarse, series)
        levels = _open_path(os.fspath(array_or_path), level, series)
    elif series:
        raise TypeError("series is of a file or a folder: give its name, or choose a part of the array")
    array, own_spacing, own_origin, has_unit = levels[0]
    shape, kind = getattr(array, "shape", None), getattr(array, "dtype", None)
    if shape is None or kind is None or not hasattr(array, "__getitem__"):
        raise TypeError(f"a large volume is an array with shape, dtype and parts [z, y, x], or a path, not "
                        f"{type(array).__name__}")
    kind = getattr(kind, "numpy_dtype", kind)  # tensorstore's types have this attribute
    dtype = np.dtype(kind).newbyteorder("=")
    if dtype.name not in _TYPES:
        raise TypeError(f"a volume can't have numbers of type {kind}. Cure: an array of another type, such as dask's "
                        "array.astype(numpy.float32), which converts what is read")
    if len(shape) != 3 or 0 in shape:
        raise ValueError(f"a volume has three dimensions [z, y, x], and voxels; this array's shape is {tuple(shape)}")
    # also Zarr's and HDF5's objects
    is_file = isinstance(array_or_path, (str, os.PathLike)) or hasattr(array_or_path, "attrs")
    if spacing is None and is_file and (own_spacing is None or not has_unit):
        _warn("the array has no size of a voxel: cubes of 1 mm are assumed. Give spacing= otherwise" if own_spacing is None
              else "the axes name no unit of length: millimetres are assumed. Give spacing= otherwise")
    fine = _Level(array, _three("spacing", spacing if spacing is not None else own_spacing or (1.0, 1.0, 1.0)),
                  _three("origin", origin if origin is not None else own_origin or (0.0, 0.0, 0.0)))
    source = _Source()
    source.SetWholeExtent(0, int(shape[2]) - 1, 0, int(shape[1]) - 1, 0, int(shape[0]) - 1)
    source.SetScalarType(_TYPES[dtype.name])
    source.SetSpacing(fine.spacing)
    source.SetOrigin(fine.origin)
    source.SetCoarseImage(_find_coarse(coarse, levels, fine))
    number, reference = next(_numbers), vtkWeakReference()
    reference.Set(source)
    _arrays[number] = _Array(array, dtype, reference)
    _set_reader(source, _read, number)
    source.AddObserver("UserEvent", _let_read)
    return source
