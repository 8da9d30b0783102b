# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A forked child has a copy of the device, but none of its threads: the device stays with the parent and keeps its
force."""

import os
import signal
import sys
import time

import numpy as np
import pytest
from volumehaptics import image, vtkHapticDevice, vtkVolumeHapticsFilter

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="nothing is forked elsewhere")


@pytest.fixture
def device():
    """Returns a device that is armed and presses: V = 100 z, 500 N/m."""
    haptics, made = vtkVolumeHapticsFilter(), vtkHapticDevice()
    haptics.SetInputData(image(np.broadcast_to(100.0 * np.arange(32).reshape(-1, 1, 1), (32, 17, 17)).copy()))
    made.SetVolumeHaptics(haptics)
    assert made.Open("virtual")
    made.GetVirtualHand().SetPosition(8, 8, 10)
    assert made.Start()
    press(made, 10, lambda: made.GetState().GetTick() > 1)
    press_slowly(made)
    yield made
    made.Close()


def press(device, z, holds):
    device.GetVirtualHand().SetPosition(8, 8, z)
    end = time.monotonic() + 30.0
    while not holds():
        assert time.monotonic() < end, device.GetStatusText()
        device.UpdateState()
        time.sleep(0.002)


def press_slowly(device):
    """Arms the device and presses as slowly as the slew limit demands; otherwise the wall stays soft."""
    device.Arm()
    for _ in range(5):
        press(device, 10, lambda: abs(device.GetState().GetTipPosition()[2] - 10) < 1e-6)
        press(device, 10, lambda: "100 % of the force" in device.GetStatusText())
        for z in (10.5, 11, 11.5):
            press(device, z, lambda z=z: abs(device.GetState().GetTipPosition()[2] - z) < 1e-6)
        tick = device.GetState().GetTick()
        press(device, 11.5, lambda tick=tick: device.GetState().GetForce()[2] < -0.7 or device.GetState().GetTick() > tick + 1000)
        if device.GetState().GetForce()[2] < -0.7:
            return
        # The machine stalled, so a new contact began at the tip. Approach again from outside.
    raise AssertionError(device.GetStatusText())


def lag(device):
    """Returns the time (s) by which the servo's ticks are behind the clock; each stall of the machine increases it."""
    device.UpdateState()
    return device.GetState().GetTime() - device.GetState().GetTick() / device.GetServoRate()


@pytest.mark.parametrize("way", ("Stop", "Close", "Disarm"))
def test_child_lets_go_of_its_copy(device, way):
    for _ in range(5):
        before = lag(device)
        child = os.fork()
        if child == 0:
            signal.alarm(30)  # ends a child that waits for threads that do not exist
            getattr(device, way)()
            device.Close()
            del device
            os._exit(7)
        assert os.waitpid(child, 0) == (child, 7 << 8)
        tick = device.GetState().GetTick()
        press(device, 11.5, lambda tick=tick: device.GetState().GetTick() > tick + 100)
        if lag(device) < before + 0.02:
            break
        # The machine stalled, so the force began again at the tip, as it must. Approach again from outside.
        press(device, 10, lambda: abs(device.GetState().GetTipPosition()[2] - 10) < 1e-6)
        press_slowly(device)
    assert device.GetStatus() == vtkHapticDevice.ACTIVE and device.GetState().GetForce()[2] < -0.7
