# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The bench on which cures are tried: a function spoils it, and after the cure the force is right.

The volume is V = 100 z over 24 x 17 x 32 voxels, pressed 2 mm from z = 10 on: 500 N/m give 1 N.
"""

import math
import re
from contextlib import contextmanager

import numpy as np
import pytest
from TestCures import PRESS, RAMP
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from volumehaptics import image, path, vtkHapticLabelTable, vtkHapticPointShell, vtkVolumeHapticsFilter
from volumehaptics._touch import Errors
from volumehaptics.arrays import arrays


class Cases(dict):
    """Registers functions that spoil a bench and return the cure. The key is words of the cure in the error; the force
    is expected after the cure."""

    def __call__(self, words, force=1.0):
        def keep(spoil):
            assert words not in self, words
            self[words] = spoil, force
            return spoil
        return keep


class Calls(dict):
    """Registers functions that provoke errors in a folder and apply each cure. The key is words of these cures."""

    def __call__(self, *words):
        def keep(function):
            assert words not in self, words
            self[words] = function
            return function
        return keep


class Bench:
    """A filter that presses the ramp."""

    def __init__(self):
        self.image = vtkImageData()
        self.image.DeepCopy(image(RAMP))
        self.path = vtkPolyData()
        self.path.DeepCopy(path(PRESS))
        self.haptics = vtkVolumeHapticsFilter()
        self.haptics.SetInputData(self.image)
        self.haptics.SetPathData(self.path)
        self.feel = self.haptics.GetProperty()
        self.points = self.image.GetPointData()

    def force(self):
        self.haptics.Update()
        felt = self.haptics.GetOutput()
        return -arrays(felt)["Force"][-1][2] if felt.GetNumberOfPoints() else math.nan

    def scalars(self, values, components=1):
        """Gives the image a scalar array V."""
        array = numpy_to_vtk(np.ascontiguousarray(values).reshape(-1, components), deep=True)
        array.SetName("V")
        self.points.SetScalars(array)

    def follow(self, mode):
        """Sets the method PRIMITIVES with a mode."""
        self.haptics.SetMethodToPrimitives()
        self.haptics.AddMode(mode)
        return mode


def times(b, values):
    array = numpy_to_vtk(np.asarray(values, float), deep=True)
    array.SetName("Time")
    b.path.GetPointData().AddArray(array)


def table():
    materials = vtkHapticLabelTable()
    materials.SetStiffness(1, 200.0)
    return materials


def vectors(b):
    """Adds vectors along x. The spring acts across them: 500 N/m times 2 mm."""
    along = numpy_to_vtk(np.tile([1.0, 0.0, 0.0], (RAMP.size, 1)), deep=True)
    along.SetName("along")
    b.points.AddArray(along)


def line_to(x):
    """Returns a line from (0, 8, 10) along x."""
    line = vtkPolyData()
    line.SetPoints(vtkPoints())
    line.GetPoints().InsertNextPoint(0.0, 8.0, 10.0)
    line.GetPoints().InsertNextPoint(x, 8.0, 10.0)
    lines = vtkCellArray()
    lines.InsertNextCell(2)
    lines.InsertCellPoint(0)
    lines.InsertCellPoint(1)
    line.SetLines(lines)
    return line


# Makes a shaped tool: a ball of 2 mm, whose centre moves from z = 7 to 9; the surface is at z = 10.

def ball():
    sphere = vtkSphereSource()
    sphere.SetRadius(2.0)
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(16)
    sphere.Update()
    mesh = vtkPolyData()
    mesh.DeepCopy(sphere.GetOutput())
    return mesh


def hold_ball(b, mesh):
    b.haptics.SetMetersPerWorldUnit(0.001)
    shell = vtkHapticPointShell()
    shell.SetContactValue(1000.0)
    shell.SetSolidToAbove()
    shell.SetMesh(mesh)
    b.haptics.SetTool(shell)
    points = b.path.GetPoints()
    for i in range(21):
        points.SetPoint(i, 11.0, 8.0, 7.0 + 0.1 * i)
    b.path.Modified()
    return shell


def ball_force():
    bench = Bench()
    hold_ball(bench, ball())
    return bench.force()


def filtered(algorithm, mesh):
    algorithm.SetInputData(mesh)
    algorithm.Update()
    return algorithm.GetOutput()


FORCES = {"ball": ball_force}


def try_case(words, spoil, force):
    """Tries one cure. If `force` is a name, the expected force is that of a bench without the fault."""
    bench = Bench()
    cure = spoil(bench)
    with Errors(bench.haptics.GetExecutive()), Errors(bench.haptics) as errors:
        bench.haptics.Update()
    assert len(errors) == 1 and words in re.sub(r"(?<=number |.point )\d+(?=\.)", "…", errors[0]), (words, errors)
    cure()
    with Errors(bench.haptics) as errors:
        # Allow a wider tolerance, because closing a tool's hole changes its triangles.
        right = pytest.approx(FORCES[force](), rel=1e-3) if force in FORCES else pytest.approx(force, abs=1e-6)
        assert bench.force() == right
    assert not errors


TOLD = set()


@contextmanager
def told(watched, word, silent=None):
    """Expects one error, with the cure, from the statements inside."""
    with Errors(silent or watched), Errors(watched) as errors:
        yield
    assert len(errors) == 1 and word in errors[0], (word, errors)
    TOLD.add(word)


def try_calls(words, function, folder):
    TOLD.clear()
    function(folder)
    assert set(words) == TOLD
