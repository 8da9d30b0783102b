# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A path from the source is felt through the pipeline, at the speed that it sets, whatever the servo's rate."""

import math

from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from volumehaptics import vtkHapticPathSource, vtkVolumeHapticsFilter


def test_circle_is_felt_at_its_speed():
    volume, path, touch = vtkRTAnalyticSource(), vtkHapticPathSource(), vtkVolumeHapticsFilter()
    path.SetShapeToCircle()
    path.SetRadius(8.0)
    path.SetTurns(1.0)
    path.SetSpeed(20.0)
    touch.SetInputConnection(volume.GetOutputPort())
    touch.SetPathConnection(path.GetOutputPort())

    for rate in (1000.0, 250.0):
        touch.SetServoRate(rate)
        touch.Update()
        trace = touch.GetOutput()
        times = trace.GetPointData().GetArray("Time")
        last = times.GetTuple1(times.GetNumberOfTuples() - 1)
        assert abs(last - 2.0 * math.pi * 8.0 / 20.0) < 0.01, f"a turn takes {last} s at {rate} Hz"
        tips = trace.GetPointData().GetArray("Tip")
        for i in range(tips.GetNumberOfTuples()):
            assert abs(math.hypot(*tips.GetTuple3(i)) - 8.0) < 1e-3, f"tick {i} at {rate} Hz leaves the circle"
        assert trace.GetPointData().GetArray("Force").GetMaxNorm() > 0.1


def test_settings_come_back():
    path = vtkHapticPathSource()
    path.SetBoxBounds(0.0, 1.0, 2.0, 4.0, 5.0, 8.0)
    assert path.GetBoxCorner() == (0.0, 2.0, 5.0) and path.GetBoxSize() == (1.0, 2.0, 3.0)
    path.SetFileName("trace.vtp")
    assert path.GetFileName() == "trace.vtp"
