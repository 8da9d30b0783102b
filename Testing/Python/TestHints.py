# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the type hints tell editors and type checkers which names exist."""

import ast
import importlib.util
import inspect
from pathlib import Path

import pytest
import volumehaptics
from vtkmodules.vtkCommonCore import vtkVersion
from volumehaptics import arrays, examples, vtkVolumeHaptics

PACKAGE = Path(volumehaptics.__file__).parent
METHODS = {
    "vtkVolumeHapticsFilter": (
        "SetPathData", "HashScalars", "SetKernelRadius", "GetKernelRadius", "SetSolverToPaper", "GetProperty"),
    "vtkHapticProperty": ("ApplyPreset", "GetStiffness", "SetVisibilityFrom"),
    "vtkHapticDevice": ("EnumerateDevices", "Open", "Arm", "GetState", "GetRecorder"),
    "vtkHapticState": ("GetForce", "Drain"),
    "vtkHapticRecorder": ("Start", "Stop"),
}


def test_package_is_marked():
    assert (PACKAGE / "py.typed").exists()


@pytest.fixture(scope="module")
def hints():
    """Returns the classes of the hints, with the names of their methods."""
    if importlib.util.find_spec("vtkmodules.generate_pyi") is None:
        pytest.skip(f"VTK {vtkVersion.GetVTKVersion()} of this Python has no vtkmodules.generate_pyi")
    tree = ast.parse((PACKAGE / "vtkVolumeHaptics.pyi").read_text(encoding="utf-8"))
    classes = (node for node in tree.body if isinstance(node, ast.ClassDef))
    return {
        one.name: {node.name: node for node in one.body if isinstance(node, ast.FunctionDef)} for one in classes
    }


def test_every_class_has_hints(hints):
    assert set(hints) == {name for name in vars(vtkVolumeHaptics) if name.startswith("vtk")}
    for name, methods in METHODS.items():
        assert set(methods) <= set(hints[name]), name


def test_hints_say_types(hints):
    radius = hints["vtkVolumeHapticsFilter"]["SetKernelRadius"]
    assert ast.unparse(radius.args.args[1].annotation) == "int" and ast.unparse(radius.returns) == "None"
    assert ast.unparse(hints["vtkHapticProperty"]["ApplyPreset"].returns) == "bool"


@pytest.mark.parametrize("module", (arrays, examples), ids=lambda module: module.__name__)
def test_functions_have_hints(module):
    for name in module.__all__:
        signature = inspect.signature(getattr(module, name))
        assert signature.return_annotation is not inspect.Signature.empty, name
        for parameter in signature.parameters.values():
            assert parameter.annotation is not inspect.Parameter.empty, (name, parameter)


def test_misspelt_names_are_seen_by_type_checkers():
    """Type checkers assume that a module with __getattr__() has every name."""
    tree = ast.parse((PACKAGE / "__init__.py").read_text(encoding="utf-8"))
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    assert "__dir__" in functions and "__getattr__" not in functions
    assert hasattr(volumehaptics, "__getattr__")
