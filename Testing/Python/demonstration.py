# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a script of Examples/Python, which draws a picture and prints what was felt."""

import subprocess
import sys

import numpy as np
from conftest import ROOT
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

DEMONSTRATIONS = ROOT / "Examples" / "Python"


def run(name, picture, *words):
    command = [sys.executable, DEMONSTRATIONS / name, *words, "--picture", picture]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=250, check=False)
    assert done.returncode == 0, done.stderr
    reader = vtkPNGReader()
    reader.SetFileName(str(picture))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
    assert len(np.unique(pixels, axis=0)) > 1000, "there is something to see"
    return done.stdout
