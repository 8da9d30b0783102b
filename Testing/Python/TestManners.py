# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The classes follow the Python conventions of VTK 9.4 and later: properties, pipelines, arrays by name."""

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from volumehaptics import examples, touch, vtkHapticDevice, vtkHapticPathSource, vtkVolumeHapticsFilter

VERSION = vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()
pytestmark = pytest.mark.skipif(
    VERSION < (9, 4), reason=f"VTK {vtkVersion.GetVTKVersion()} has no properties and pipelines of Python; 9.4 has")


def make_source():
    source = vtkHapticPathSource(point1=(0.0, -120.0, 60.0), point2=(0.0, -40.0, 60.0), speed=80.0)
    assert source.GetPoint1() == (0.0, -120.0, 60.0) and source.GetSpeed() == 80.0
    return source


def test_properties():
    haptics = vtkVolumeHapticsFilter(kernel_radius=3, servo_rate=500.0)
    assert haptics.GetKernelRadius() == 3 and haptics.servo_rate == 500.0
    haptics.kernel_radius = 4
    haptics.meters_per_world_unit = 0.01
    haptics.solver = vtkVolumeHapticsFilter.PAPER
    assert haptics.GetKernelRadius() == 4 and haptics.GetMetersPerWorldUnit() == 0.01
    assert haptics.GetSolver() == vtkVolumeHapticsFilter.PAPER
    assert haptics.property is haptics.GetProperty()
    assert vtkHapticDevice(servo_rate=2000.0).GetServoRate() == 2000.0
    with pytest.raises(TypeError, match="kernel_radus"):
        vtkVolumeHapticsFilter(kernel_radus=3)


def test_pipeline():
    from vtkmodules.util.execution_model import select_ports

    reader = vtkXMLImageDataReader(file_name=examples.phantom_file())
    source, haptics = make_source(), vtkVolumeHapticsFilter()
    source >> select_ports(1, haptics)
    trace = (reader >> haptics).update().output
    reader.Update()
    again = vtkVolumeHapticsFilter()
    again.SetInputData(reader.GetOutput())
    again.SetPathConnection(source.GetOutputPort())
    again.Update()
    forces = [np.asarray(one.point_data["Force"]) for one in (trace, again.GetOutput())]
    assert forces[0].any() and (forces[0] == forces[1]).all()


def test_arrays_by_name():
    trace = touch(examples.phantom(), examples.stroke())
    force = trace.point_data["Force"]
    assert isinstance(force, np.ndarray) and force.shape == (trace.GetNumberOfPoints(), 3)
    force[0] = (1.0, 2.0, 3.0)
    assert trace.GetPointData().GetArray("Force").GetTuple3(0) == (1.0, 2.0, 3.0)
    assert {"Time", "Tip", "Contact", "Energy"} <= set(trace.point_data.keys())
    assert np.asarray(trace.points).shape == force.shape
