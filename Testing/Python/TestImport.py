# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestImport.py BUILD_DIR VERSION: this build's package can be imported, in any order."""

import os
import subprocess
import sys

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
BEFORE = (
    "",
    "import vtkmodules.all",
    "from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction",
    "from volumehaptics import *\nvtkVolumeHapticsFilter, vtkHapticProperty",
    "import volumehaptics.vtkVolumeHaptics",
)


def main(build, version):
    for first in BEFORE:
        # Without an image the executive complains; the filter must survive that.
        command = [sys.executable, "-W", "error", "-c", first + CHECK]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        assert run.returncode == 0, f"{first!r}: {run.stderr}"
        file, said = run.stdout.split("\n")[:2]
        inside = os.path.commonpath([os.path.realpath(file), os.path.realpath(build)])
        assert inside == os.path.realpath(build), f"{file} is not of this build"
        assert said == version, (said, version)

    import volumehaptics

    assert "haptics" in volumehaptics.__doc__
    assert volumehaptics.vtkVolumeHapticsFilter().GetClassName() == "vtkVolumeHapticsFilter"


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2]) if len(sys.argv) == 3 else sys.exit(__doc__)
