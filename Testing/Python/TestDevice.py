# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Uses vtkHapticDevice from Python: a press on a ramp is recorded, replayed and compared."""

import math
import time

import compare_traces
from ramp import make_ramp
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from volumehaptics import vtkHapticDevice, vtkVolumeHapticsFilter


def wait(device, holds):
    """Polls the device until `holds` is true; no test depends on the time this takes."""
    end = time.monotonic() + 30.0
    while not (device.UpdateState() and holds()):
        assert time.monotonic() < end, device.GetStatusText()
        time.sleep(0.001)


class Errors:
    """Collects the errors of an object instead of printing them."""

    def __init__(self, watched):
        self.count = 0
        watched.AddObserver("ErrorEvent", self)

    def __call__(self, *_):
        self.count += 1


def test_devices_are_listed():
    ids = vtkHapticDevice.EnumerateDevices()
    assert "virtual" in [ids.GetValue(i) for i in range(ids.GetNumberOfValues())]
    table = vtkTable()
    vtkHapticDevice.ListDevices(table)
    assert [table.GetColumnName(c) for c in range(3)] == ["Id", "Name", "State"]
    assert table.GetValueByName(0, "Id").ToString() == "virtual" and table.GetNumberOfRows() >= 1


def test_settings_come_back():
    device = vtkHapticDevice()
    device.SetFirmwareFile("image.bin")
    device.SetNewtonsPerFullScale(2.0, -3.0)
    device.SetHomingTime(0.0)
    assert device.GetFirmwareFile() == "image.bin" and device.GetHomingTime() == 1.0
    assert device.GetNewtonsPerFullScale() == (2.0, -3.0) and device.GetState().GetTurnRate() == (0.0, 0.0, 0.0)


def test_what_cannot_be_opened(tmp_path):
    device = vtkHapticDevice()
    errors = Errors(device)
    assert device.GetStatus() == vtkHapticDevice.CLOSED and "Open" in device.GetStatusText()
    for bad in ("", "nothing", f"replay:{tmp_path / 'missing.vtp'}", None):
        assert not device.Open(bad), bad
    assert errors.count == 4 and not device.Start() and errors.count == 5


def test_push_is_recorded_and_replayed(tmp_path):
    haptics, device = vtkVolumeHapticsFilter(), vtkHapticDevice()
    haptics.SetInputData(0, make_ramp(16))
    errors = Errors(device)
    assert device.Open("virtual") and device.GetStatus() == vtkHapticDevice.READY
    assert device.GetMaximumForce() > 0.0 and device.GetMaximumForceRate() == 500.0
    device.SetVolumeHaptics(haptics)
    device.GetVirtualHand().SetPosition(7.0, 7.0, 5.0)
    assert device.Start() and device.IsRunning()
    wait(device, lambda: device.GetState().GetTick() > 1)  # the tip starts at the first position that the servo sees
    recording = str(tmp_path / "push.vtp")
    assert device.GetRecorder().Start(recording)
    device.Arm()
    wait(device, lambda: "100 % of the force" in device.GetStatusText())  # a wall that is pressed earlier stays soft
    for z in (5.5, 6.0, 6.5, 7.0, 7.5, 8.0):  # slow enough for the slew limit
        device.GetVirtualHand().SetPosition((7.0, 7.0, z))
        wait(device, lambda z=z: abs(device.GetState().GetTipPosition()[2] - z) < 1e-9)
    wait(device, lambda: device.GetState().GetForce()[2] < -1.49)
    assert device.GetStatus() == vtkHapticDevice.ACTIVE
    assert abs(device.GetState().GetComputedForce()[2] + 1.5) < 1e-6
    assert math.dist(device.GetState().GetTipPosition(), (7.0, 7.0, 8.0)) < 1e-9
    assert math.dist(device.GetState().GetProxyPosition(), (7.0, 7.0, 5.0)) < 1e-6
    assert device.GetState().GetContact() == 1 and device.GetState().GetButtons() == 0 and device.GetState().GetTick() > 0

    # Rotate the device by 90 degrees, and publish the change during the recording.
    matrix = vtkMatrix4x4()
    matrix.DeepCopy((0, -1000, 0, 0, 1000, 0, 0, 0, 0, 0, 1000, 0, 0, 0, 0, 1))
    device.SetDeviceToWorld(matrix)
    assert device.Publish()
    for z in (9.0, 6.0, 8.0):
        device.GetVirtualHand().SetPosition(7.0, 7.0, z)
        wait(device, lambda: math.dist(device.GetState().GetTipPosition(), (7.0, 7.0, z)) < 1e-6)
    assert device.GetTickRate() >= 0.0 and device.GetMissedTicks() >= 0
    assert device.GetTickPercentile(50) <= device.GetTickPercentile(99)
    assert device.GetWakePercentile(50) <= device.GetWakePercentile(99)
    device.ResetStatistics()
    assert device.GetRecorder().Stop()
    device.Stop()
    assert device.GetState().GetForce() == (0.0, 0.0, 0.0) and not device.IsRunning()

    # Computed offline from the recording, the trace must be the same.
    haptics.SetInputData(1, compare_traces.read_trace(recording))
    haptics.Update()
    recorded = compare_traces.read_trace(recording)
    differences = compare_traces.compare(recorded, haptics.GetOutput())
    assert not differences, [str(d) for d in differences]

    # When the servo replays the recording, the tip must end at the recorded end.
    assert device.Open("replay:" + recording)
    assert device.Start()
    wait(device, lambda: math.dist(device.GetState().GetTipPosition(), (7.0, 7.0, 8.0)) < 1e-6)
    assert device.GetDeviceToWorld() is matrix
    device.Arm()
    del device  # delete it while armed: it stops by itself
    assert errors.count == 0


def test_stylus_turns_is_recorded_and_replayed(tmp_path):
    haptics, device = vtkVolumeHapticsFilter(), vtkHapticDevice()
    haptics.SetInputData(0, make_ramp(16))
    errors = Errors(device)
    assert device.Open("virtual")
    device.SetVolumeHaptics(haptics)
    matrix = vtkMatrix4x4()  # a quarter turn about z: w = z = cos 45 degrees
    matrix.DeepCopy((0, -1000, 0, 0, 1000, 0, 0, 0, 0, 0, 1000, 0, 0, 0, 0, 1))
    device.SetDeviceToWorld(matrix)
    device.GetVirtualHand().SetPosition(7.0, 7.0, 5.0)
    assert device.Start()
    wait(device, lambda: device.GetState().GetTick() > 1)
    assert not device.GetState().HasTipOrientation() and device.GetState().GetTipOrientation() == (1.0, 0.0, 0.0, 0.0)

    recording = str(tmp_path / "turn.vtp")
    assert device.GetRecorder().Start(recording)
    device.UpdateState()  # ignore earlier ticks
    first = device.GetState().GetTick()
    wait(device, lambda: device.GetState().GetTick() > first + 3)
    angle = 0.8  # about x
    turn = (math.cos(angle / 2), math.sin(angle / 2), 0.0, 0.0)
    device.GetVirtualHand().SetOrientation(*turn)
    wait(device, device.GetState().HasTipOrientation)
    assert math.dist(device.GetState().GetTipOrientation(), turn) < 1e-14
    device.GetVirtualHand().SetOrientation((0.0, 0.0, -2.0, 0.0))
    wait(device, lambda: math.dist(device.GetState().GetTipOrientation(), (0.0, 0.0, -1.0, 0.0)) < 1e-14)
    assert device.GetRecorder().Stop()

    trace = compare_traces.read_trace(recording).GetPointData()
    last = trace.GetArray("Tick").GetNumberOfTuples() - 1
    assert trace.GetArray("Orientation").GetTuple4(0) == (0.0, 0.0, 0.0, 0.0)
    assert math.dist(trace.GetArray("Orientation").GetTuple4(last), (0.0, 0.0, -1.0, 0.0)) < 1e-14
    # Rotate back by 90 degrees: (cos 45, 0, 0, -sin 45) times (0, 0, -1, 0) is (0, -sin 45, -cos 45, 0).
    half = math.sqrt(0.5)
    assert math.dist(trace.GetArray("DeviceOrientation").GetTuple4(last), (0.0, -half, -half, 0.0)) < 1e-14

    assert device.Open("replay:" + recording) and device.Start()
    wait(device, lambda: math.dist(device.GetState().GetTipOrientation(), (0.0, 0.0, -1.0, 0.0)) < 1e-14)
    assert errors.count == 0
    device.GetVirtualHand().SetOrientation(*turn)
    assert errors.count == 1
    device.Close()
