# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The right copy of the package is imported, in any order of imports, each time in a fresh interpreter."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

CHECK = """
import volumehaptics
from volumehaptics import vtkHapticProperty, vtkVolumeHapticsFilter
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm
assert issubclass(vtkHapticProperty, vtkObject)
assert issubclass(vtkVolumeHapticsFilter, vtkPolyDataAlgorithm)
touch = vtkVolumeHapticsFilter()
assert isinstance(touch.GetProperty(), vtkHapticProperty)
assert touch.GetProperty() is touch.GetProperty()
touch.GetProperty().GetStiffness().AddPoint(0.0, 250.0)
assert touch.GetProperty().GetStiffness().GetValue(7.0) == 250.0
touch.Update()
print(volumehaptics.__file__, volumehaptics.__version__, sep="\\n")
"""
NOTHING = ""
BEFORE = (
    NOTHING,
    "import vtk\n",
    "import vtkmodules.all\n",
    "from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction\n",
    "from volumehaptics import *\nvtkVolumeHapticsFilter, vtkHapticProperty\n",
    "import volumehaptics.vtkVolumeHaptics\n",
)
AFTER = """import vtk
assert isinstance(touch, vtk.vtkAlgorithm)
assert isinstance(touch.GetOutput(), vtk.vtkPolyData)
"""


def run(code):
    """Runs code in a fresh interpreter that turns warnings into errors; returns the output."""
    command = [sys.executable, "-W", "error", "-c", code]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode == 0, f"{code}\n{result.stderr}"
    return result.stdout


# Without an image, VTK's executive reports an error, which the filter must survive.
@pytest.mark.parametrize("first", BEFORE, ids=lambda code: code.split("\n")[0])
@pytest.mark.parametrize("last", (NOTHING, AFTER), ids=("", "then vtk"))
def test_order_does_not_matter(first, last, build, version):
    file, said = run(first + CHECK + last).split("\n")[:2]
    inside = os.path.commonpath([os.path.realpath(file), build])
    assert Path(inside) == build, f"{file} is not in {build}"
    assert said == version


NAMES = """
import builtins
before = set(globals())
from volumehaptics import *
import volumehaptics
for name in set(globals()) - before - {"before", "volumehaptics"}:
    assert name == "touch" or name.startswith("vtk"), name
    assert not hasattr(builtins, name)
assert touch is volumehaptics.touch
assert {"arrays", "examples", "image", "path", "touch", "vtkHapticDevice"} <= set(dir(volumehaptics))
"""
# Simulate a Python without NumPy: importing a module that is None in sys.modules fails.
NO_NUMPY = """
import sys
sys.modules["numpy"] = None
import volumehaptics
trace = volumehaptics.touch(volumehaptics.examples.phantom(), volumehaptics.examples.stroke())
assert trace.GetNumberOfPoints() > 0
try:
    volumehaptics.image
except ImportError as error:
    assert "python3-numpy" in str(error)
    print("told")
"""


# Simulate another VTK version than the package was compiled with.
OTHER_VTK = """
from vtkmodules import vtkCommonCore
class Other(vtkCommonCore.vtkVersion):
    GetVTKBuildVersion = staticmethod(lambda: 99)
vtkCommonCore.vtkVersion = Other
try:
    import volumehaptics
except ImportError as error:
    print(error)
"""


def test_another_vtk_is_refused_by_name():
    from vtkmodules.vtkCommonCore import vtkVersion

    here = f"{vtkVersion.GetVTKMajorVersion()}.{vtkVersion.GetVTKMinorVersion()}"
    said = run(OTHER_VTK)
    assert f"VTK {here}.99 is installed" in said
    assert f"pip install vtk=={here}.{vtkVersion.GetVTKBuildVersion()}," in said


def test_names_are_clean():
    run(NAMES)


def test_numpy_is_needed_for_its_arrays_only():
    assert run(NO_NUMPY) == "told\n"


def test_there_is_no_other_name():
    import volumehaptics

    assert "touch" in volumehaptics.__doc__
    with pytest.raises(AttributeError, match="volumehaptics.*vtkNothing"):
        volumehaptics.vtkNothing
