# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors reach Python: as ErrorEvent if the data are wrong, as an exception if a call is wrong."""

import math

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import VTK_STRING, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPolyData
from volumehaptics import (
    image,
    vtkHapticDevice,
    vtkHapticPathSource,
    vtkHapticProperty,
    vtkHapticSetup,
    vtkVolumeHapticsFilter,
)


class Log(list):
    """Collects the error texts of an object instead of printing them."""

    def __init__(self, watched):
        super().__init__()

        def note(_caller, _event, text):
            self.append(text)

        note.CallDataType = VTK_STRING
        watched.AddObserver("ErrorEvent", note)


def make_image(n=12):
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.AllocateScalars(10, 1)  # VTK_FLOAT
    image.GetPointData().GetScalars().Fill(100.0)
    return image


def make_path(*points):
    path = vtkPolyData()
    path.SetPoints(vtkPoints())
    for point in points:
        path.GetPoints().InsertNextPoint(point)
    return path


def test_bad_data():
    haptics = vtkVolumeHapticsFilter()
    log = Log(haptics)
    quiet = Log(haptics.GetExecutive())
    image, path = make_image(), make_path((5, 5, 5), (5, 5, 6))
    haptics.SetInputData(image)
    haptics.SetPathData(path)
    haptics.Update()
    assert haptics.GetOutput().GetNumberOfPoints() == 2 and not log and not quiet

    cases = (
        ("spacing", lambda: image.SetSpacing(1, math.nan, 1), lambda: image.SetSpacing(1, 1, 1)),
        ("tip path", lambda: haptics.SetPathData(make_path((math.nan, 5, 5))),
         lambda: haptics.SetPathData(path)),
        ("KernelRadius", lambda: haptics.SetKernelRadius(9), lambda: haptics.SetKernelRadius(2)),
        ("Stiffness", lambda: haptics.GetProperty().GetStiffness().AddPoint(0, -1),
         lambda: haptics.GetProperty().GetStiffness().RemoveAllPoints()),
    )
    for word, spoil, mend in cases:
        spoil()
        haptics.Update()
        assert len(log) == 1 and word in log[0], (word, log)
        assert haptics.GetOutput().GetNumberOfPoints() == 0
        mend()
        log.clear()
        haptics.Update()
        assert not log and haptics.GetOutput().GetNumberOfPoints() == 2, word


def test_bad_calls():
    haptics, prop = vtkVolumeHapticsFilter(), vtkHapticProperty()
    with pytest.raises(TypeError):
        haptics.SetKernelRadius("two")
    with pytest.raises(TypeError):
        haptics.SetKernelRadius()
    with pytest.raises(TypeError):
        haptics.SetProperty(vtkPiecewiseFunction())
    with pytest.raises(TypeError):
        prop.SetStiffness(500.0)
    with pytest.raises(TypeError):
        prop.SetVisibilityFrom(prop)
    with pytest.raises(TypeError):
        haptics.SetPathData(make_image())
    # None becomes the C++ nullptr, which restores the defaults.
    prop.GetStiffness().AddPoint(0.0, 5.0)
    prop.SetStiffness(None)
    assert prop.GetStiffness().GetSize() == 0
    haptics.SetProperty(prop)
    haptics.SetProperty(None)
    assert haptics.GetProperty() is not None and haptics.GetProperty() is not prop


def test_unknown_preset():
    prop = vtkHapticProperty()
    log = Log(prop)
    for name in ("bones", None):
        assert prop.ApplyPreset(name) is False
    assert len(log) == 2 and '"bones"' in log[0] and '"MRI"' in log[0], log


@pytest.mark.parametrize("settings", ({"spacing": 2.0}, {"origin": (1.0, 2.0)}))
def test_image_is_laid_out_in_three_dimensions(settings):
    with pytest.raises(ValueError, match=f"{next(iter(settings))} is three numbers"):
        image(np.zeros((4, 4, 4)), **settings)


def test_names_that_are_not_utf8(tmp_path):
    # Messages about file names that are not UTF-8 used to arrive empty, because Python can't represent these names as
    # text.
    folder = bytes(tmp_path)
    device, setup, source = vtkHapticDevice(), vtkHapticSetup(), vtkHapticPathSource()
    haptics = vtkVolumeHapticsFilter()
    haptics.SetInputData(make_image())
    haptics.SetInputArrayToProcess(0, 0, 0, 0, b"\xe4\xff")
    source.SetShapeToFromFile()
    source.SetFileName(folder + b"/\xe4\xff.vtp")
    quiet = Log(haptics.GetExecutive()), Log(source.GetExecutive())
    for speaker, call in (
        (device, lambda: device.Open(b"replay:" + folder + b"/\xe4\xff.vtp")),
        (device, lambda: device.Open(b"\xe4\xff")),
        (device, lambda: device.GetRecorder().Recover(folder + b"/\xe4\xff.part", "a.vtp")),
        (setup, lambda: setup.Load(folder + b"/\xe4\xff.json")),
        (setup, lambda: setup.Save(folder + b"/missing/\xe4\xff.json")),
        (haptics, haptics.Update),
        (haptics.GetProperty(), lambda: haptics.GetProperty().ApplyPreset(b"\xe4\xff")),
        (source, source.Update),
    ):
        log = Log(speaker)
        assert not call()
        assert len(log) == 1 and r"\xE4\xFF" in log[0], log
    assert quiet
