# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Touch volume data: proxy-based volume haptics for VTK.

vtkVolumeHapticsFilter computes the forces on a hand from a vtkImageData and the path of a stylus;
vtkHapticProperty describes how the tissues feel; vtkHapticDevice computes the forces live, for a device in a hand.
One call does this for images and polydata, or for NumPy arrays:

    import volumehaptics
    trace = volumehaptics.touch(volume, tip, preset="CT contrast", kernel_radius=3)

touch() computes what a hand feels; image() and path() make VTK's data of NumPy arrays without a copy;
volumehaptics.arrays.arrays() makes NumPy arrays of a trace. identify() computes which materials a hand could tell
apart; inspect() says what a file holds, and what of it can be felt; open_large() opens volumes that are larger than memory. add_haptics() makes the volumes in the window of any VTK
program touchable. volumehaptics.pyvista does all this with PyVista's data and plotters. volumehaptics.examples has a
head to try them on, and

    python -m volumehaptics --demo

explores it in a window. Lengths are in world units, which are millimetres unless MetersPerWorldUnit is
changed; forces are in newtons (N), times in seconds.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

# Import the modules of the objects that the classes below accept and return: an object whose module was never imported
# would be returned as an object of a superclass.
import vtkmodules.vtkCommonCore
import vtkmodules.vtkCommonDataModel
import vtkmodules.vtkCommonExecutionModel
import vtkmodules.vtkCommonMath
import vtkmodules.vtkRenderingCore

from ._version import HAS_RENDERING as _HAS_RENDERING
from ._version import VTK_VERSION as _COMPILED_WITH
from ._version import __version__

if _HAS_RENDERING:
    import vtkmodules.vtkInteractionStyle

_vtk = vtkmodules.vtkCommonCore.vtkVersion
_FOUND = f"{_vtk.GetVTKMajorVersion()}.{_vtk.GetVTKMinorVersion()}.{_vtk.GetVTKBuildVersion()}"
if _FOUND != _COMPILED_WITH:
    # Check VTK's version first. Otherwise the loader would report a missing library, or an incompatible memory layout
    # would cause a later crash, while the force is on.
    raise ImportError(f"this volumehaptics is for VTK {_COMPILED_WITH}, and VTK {_FOUND} is installed. "
                      f"Cure: pip install vtk=={_COMPILED_WITH}, or a volumehaptics that was built for VTK {_FOUND}")

from . import vtkVolumeHaptics
from ._touch import touch
from .vtkVolumeHaptics import *

if TYPE_CHECKING:
    from . import arrays, examples, pyvista
    from ._hosts import add_haptics
    from ._identify import identify
    from ._inspect import inspect
    from ._large import open_large
    from .arrays import image, path

__all__ = [*sorted(name for name in vars(vtkVolumeHaptics) if name.startswith("vtk")), "touch"]

# Imported on demand: names that need NumPy, which the classes and touch() don't need, and the module pyvista, only if
# it is requested by name.
_MODULES = ("arrays", "examples")
_FUNCTIONS = {"add_haptics": "._hosts", "identify": "._identify",
              "inspect": "._inspect", "image": ".arrays", "open_large": "._large", "path": ".arrays"}

if not TYPE_CHECKING:  # hidden from type checkers, because with __getattr__ they would accept every misspelt name

    def __getattr__(name: str):
        if name in ("add_haptics", "pyvista") and not _HAS_RENDERING:
            raise ImportError("this volumehaptics was built without rendering, which windows need. "
                              "Cure: one that was built with VolumeHaptics_USE_RENDERING=ON")
        if name in _MODULES or name == "pyvista":
            return importlib.import_module(f".{name}", __name__)
        if name in _FUNCTIONS:
            return getattr(importlib.import_module(_FUNCTIONS[name], __name__), name)
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*__all__, *_MODULES, *_FUNCTIONS, *(name for name in globals() if name.startswith("__"))])
