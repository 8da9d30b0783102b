# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Regions of a volume from Python: planned, cropped, and felt as the whole."""

import pydoc
from pathlib import Path

import pytest
from ramp import make_ramp
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from volumehaptics import (
    vtkHapticDevice,
    vtkHapticRegionFilter,
    vtkHapticRegionPlanner,
    vtkHapticState,
    vtkVolumeHapticsFilter,
)


def test_settings_come_back_with_their_documentation():
    planner = vtkHapticRegionPlanner()
    for name, value in {
        "MaximumSpeed": 0.25,
        "MetersPerWorldUnit": 0.002,
        "SpringLength": 3.0,
        "Reach": 7.0,
        "Band": 2.0,
        "MaximumVoxels": 50000,
        "WholeExtent": (0, 39, 0, 39, 0, 39),
        "Origin": (1.0, 2.0, 3.0),
        "Spacing": (1.0, 1.5, 2.0),
        "Direction": (0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0),
    }.items():
        getattr(planner, "Set" + name)(value)
        assert getattr(planner, "Get" + name)() == value, name
    assert planner.GetLatency() == 0.2
    planner.AddLatency(0.01)
    assert planner.GetLatency() == 0.01
    text = pydoc.render_doc(vtkHapticRegionPlanner, renderer=pydoc.plaintext)
    assert 'method.md, "Regions of a volume", has the equation' in " ".join(text.replace("|", " ").split())
    method = (Path(__file__).parents[2] / "Documentation" / "method.md").read_text(encoding="utf-8")
    assert "h = v_max L + T_N/k + r + b" in method.split("## Regions of a volume")[1].split("\n## ")[0]
    assert "128^3" in text and "(m/s)" in text
    assert "MaximumVoxels: 50000" in str(planner)


@pytest.mark.parametrize("direction", ((1.0, 2.0), [], None, (1.0,) * 10, 1.0, "nine"))
def test_directions_that_are_no_nine_numbers_are_refused(direction):
    planner = vtkHapticRegionPlanner()
    with pytest.raises((TypeError, ValueError)):
        planner.SetDirection(direction)
    assert planner.GetDirection() == (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)


def test_region_is_felt_as_the_whole():
    image, planner = make_ramp(40), vtkHapticRegionPlanner()
    assert planner.SetWhole(image)
    assert planner.GetSpacing() == (1.0, 1.0, 1.0)
    crop = vtkHapticRegionFilter()
    crop.SetInputData(image)
    assert crop.GetRegion() == (0, -1, 0, -1, 0, -1)
    haptics = vtkVolumeHapticsFilter()
    haptics.ConfigurePlanner(planner)
    assert (planner.GetMetersPerWorldUnit(), planner.GetSpringLength()) == (0.001, 4.0)
    planner.SetMaximumVoxels(42000)
    resident, wanted = (0, -1, 0, -1, 0, -1), [0] * 6
    assert planner.Plan((20, 20, 15), (0, 0, 0), resident, wanted)
    assert not planner.Plan((20, 20, 15), (0, 0, 0), wanted, [0] * 6)

    crop.SetRegion(wanted)
    assert list(crop.GetRegion()) == wanted
    crop.Update()
    part = crop.GetOutput()
    assert 0 < part.GetNumberOfPoints() < image.GetNumberOfPoints()
    names = [crop.GetWholeExtentName(), crop.GetNoiseName(), crop.GetBorderValueName(), crop.GetSolidName(),
             crop.GetWholeTimeName()]
    assert names == ["HapticWholeExtent", "HapticNoise", "HapticBorderValue", "HapticSolid", "HapticWholeTime"]
    assert [part.GetFieldData().GetArray(names[0]).GetTuple1(i) for i in range(6)] == [0, 39] * 3

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
