# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests presets from Python: their names, their effect, and that a filter notices a change."""

import pytest
import volumehaptics
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkVolumeProperty
from volumehaptics import vtkHapticProperty, vtkVolumeHapticsFilter


def names():
    array = vtkHapticProperty.GetPresetNames()
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def make_filter(hounsfield):
    """Returns a filter whose tip goes 3 mm down into a ramp that ends at one tissue."""
    image = vtkImageData()
    image.SetDimensions(16, 16, 16)
    image.AllocateScalars(4, 1)  # VTK_SHORT
    scalars = image.GetPointData().GetScalars()
    for i in range(image.GetNumberOfPoints()):
        z = i // 256
        scalars.SetTuple1(i, max(-1000, hounsfield - 100 * max(0, 8 - z)))
    path = vtkPolyData()
    path.SetPoints(vtkPoints())
    for tick in range(31):
        path.GetPoints().InsertNextPoint(7, 7, 6 + 0.1 * tick)
    haptics = vtkVolumeHapticsFilter()
    haptics.SetInputData(image)
    haptics.SetPathData(path)
    return haptics


def last(haptics, name):
    haptics.Update()
    array = haptics.GetOutput().GetPointData().GetArray(name)
    return array.GetComponent(array.GetNumberOfTuples() - 1, array.GetNumberOfComponents() - 1)


def test_names():
    assert names() == [
        "CT contrast", "CT physical", "CT angiography", "CT chest", "MRI", "Micro-CT", "Labels"], names()
    prop = vtkHapticProperty()
    for name in names():
        assert prop.ApplyPreset(name) is True
        assert prop.GetStiffness().GetSize() > 0
    assert prop.GetSurfaceSide() == vtkHapticProperty.BOTH


def test_presets_are_felt():
    # Below the ramp, there is one tissue: muscle, then bone.
    for hounsfield, stiffness, friction in ((60, 400.0, 0.30), (900, 400.0, 0.30)):
        haptics = make_filter(hounsfield)
        haptics.GetProperty().ApplyPreset("CT contrast")
        assert abs(last(haptics, "Stiffness") - stiffness) < 1e-9
        assert abs(last(haptics, "Friction") - friction) < 1e-9
    assert last(haptics, "Force") < -0.5, "bone pushes back"
    haptics.GetProperty().ApplyPreset("CT physical")
    assert abs(last(haptics, "Friction") - 0.32) < 1e-9, "the filter runs again by itself"


def test_a_preset_of_ones_own_is_a_file(tmp_path):
    haptics = make_filter(900)
    own = vtkHapticProperty()
    own.ApplyPreset("CT contrast")
    bone = own.GetNumberOfTissues() - 1
    assert own.GetTissueName(bone) == "bone"
    own.SetTissueStiffness(bone, 250.0)
    file = str(tmp_path / "soft.json")
    assert own.WritePreset(file) is True
    haptics.GetProperty().ApplyPreset(file)
    assert abs(last(haptics, "Stiffness") - 250.0) < 1e-9
    trace = volumehaptics.touch(haptics.GetInputDataObject(0, 0), haptics.GetInputDataObject(1, 0), preset=file)
    assert abs(trace.GetPointData().GetArray("Stiffness").GetTuple1(30) - 250.0) < 1e-9
    with pytest.raises(ValueError, match="nowhere.json can't be read"):
        volumehaptics.touch(haptics.GetInputDataObject(0, 0), haptics.GetInputDataObject(1, 0), preset="nowhere.json")


def test_what_is_not_seen_is_not_felt():
    haptics = make_filter(900)
    haptics.GetProperty().ApplyPreset("CT physical")
    volume = vtkVolumeProperty()
    volume.GetScalarOpacity().RemoveAllPoints()
    volume.GetScalarOpacity().AddPoint(0.0, 0.0)
    haptics.GetProperty().SetVisibilityFrom(volume)
    assert last(haptics, "Force") == 0.0
    volume.GetScalarOpacity().AddPoint(0.0, 0.5)
    assert last(haptics, "Force") < -0.5
    haptics.GetProperty().SetVisibilityFrom(None)
    assert haptics.GetProperty().GetVisibilityFrom() is None
