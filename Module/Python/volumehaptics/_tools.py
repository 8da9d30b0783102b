# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes tools for the hand from meshes and mesh files."""
from __future__ import annotations

import os
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .vtkVolumeHaptics import vtkHapticPointShell, vtkHapticVolumeReader


def _read(path: str) -> vtkPolyData:
    """Reads the surface in a file. ValueError: the file has no surface."""
    if os.path.splitext(path)[1].lower() not in (".stl", ".obj", ".ply", ".vtp"):
        raise ValueError(f"tool={path!r} has an unknown extension: use one that ends in .stl, .ply, .obj or .vtp")
    if not os.path.isfile(path):
        raise ValueError(f"tool={path!r}: there is no such file")
    mesh = vtkPolyData()
    error = vtkHapticVolumeReader.ReadSurface(path, mesh)
    if error or mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() == 0:
        raise ValueError(f"tool={path!r} has no surface: " + (error or "there are no polygons"))
    return mesh


def make_tool(tool: Any) -> Any:
    """Makes a tool with the shape of a mesh or of a mesh file. Returns other values unchanged."""
    if isinstance(tool, (str, os.PathLike)):
        tool = _read(os.fspath(tool))
    if not isinstance(tool, vtkPolyData):
        return tool
    shell = vtkHapticPointShell()
    shell.SetMesh(tool)
    return shell
