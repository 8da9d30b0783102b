# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests cropped volumes from Python: they are felt like the whole volume."""

from pathlib import Path

from ramp import make_ramp
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from volumehaptics import (
    vtkHapticDevice,
    vtkHapticRegionFilter,
    vtkHapticRegionSource,
    vtkHapticState,
    vtkVolumeHapticsFilter,
)


def test_the_method_has_the_equation_that_the_source_names():
    text = " ".join(vtkHapticRegionSource.__doc__.split())
    assert 'method.md, "Regions of a volume"' in text
    method = (Path(__file__).parents[2] / "Documentation" / "method.md").read_text(encoding="utf-8")
    assert "h = v_max L + T_N/k + r + b" in method.split("## Regions of a volume")[1].split("\n## ")[0]


def test_region_is_felt_as_the_whole():
    image = make_ramp(40)
    crop = vtkHapticRegionFilter()
    crop.SetInputData(image)
    assert crop.GetRegion() == (0, -1, 0, -1, 0, -1)
    haptics = vtkVolumeHapticsFilter()
    wanted = [3, 37, 3, 37, 0, 32]
    crop.SetRegion(wanted)
    assert list(crop.GetRegion()) == wanted
    crop.Update()
    part = crop.GetOutput()
    assert 0 < part.GetNumberOfPoints() < image.GetNumberOfPoints()
    facts = part.GetFieldData()
    assert all(map(facts.GetArray, ("HapticNoise", "HapticBorderValue", "HapticSolid", "HapticWholeTime")))
    assert [facts.GetArray("HapticWholeExtent").GetTuple1(i) for i in range(6)] == [0, 39] * 3

    path, points = vtkPolyData(), vtkPoints()
    for i in range(60):
        points.InsertNextPoint(20.0, 20.0, 13.0 + 0.05 * i)
    path.SetPoints(points)
    haptics.SetPathData(path)
    forces = []
    for data in (image, part):
        haptics.SetInputData(0, data)
        haptics.Update()
        array = haptics.GetOutput().GetPointData().GetArray("Force")
        forces.append([array.GetTuple3(i) for i in range(array.GetNumberOfTuples())])
    assert forces[0] == forces[1] and max(abs(f[2]) for f in forces[0]) > 0.5


def test_device_says_how_much_of_the_data_is_there():
    device = vtkHapticDevice()
    assert device.GetState().GetResidency() == 1.0 and device.GetAbsentTicks() == 0
    device.FadeOut()
    assert "50 ms" in vtkHapticState.GetResidency.__doc__ and "50 ms" in vtkHapticDevice.Arm.__doc__
