# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A Python that crashes while a device is armed ends with the same report as one without a device."""

import os
import resource
import signal
import subprocess
import sys

import pytest

BEGIN = """
import faulthandler, os, signal
from volumehaptics import vtkHapticDevice

device = vtkHapticDevice()
device.Open("virtual")
device.Start()
"""
ARM = "device.Arm()\n"
REPORT = "faulthandler.enable()\n"
CRASHES = {
    "fault": ("import ctypes; ctypes.memset(8, 1, 1)", signal.SIGSEGV, "Segmentation fault"),
    "sent": ("os.kill(os.getpid(), signal.SIGSEGV)\nsignal.pause()", signal.SIGSEGV, "Segmentation fault"),
    "abort": ("os.abort()", signal.SIGABRT, "Aborted"),
}


def run(script):
    """Runs a script in a process of its own; returns the error output and the exit code."""
    no_core = lambda: resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    ended = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=60, preexec_fn=no_core,
        # for UCX, in the MPI of Debian 13's VTK
        env={**os.environ, "PYTHONFAULTHANDLER": "", "UCX_ERROR_SIGNALS": ""})
    return ended.stderr, ended.returncode


@pytest.mark.parametrize("crash", CRASHES)
@pytest.mark.parametrize("order", (REPORT + ARM, ARM + REPORT, ARM + REPORT + ARM), ids=("before", "after", "between"))
def test_faulthandler_reports_once(order, crash):
    code, number, text = CRASHES[crash]
    said, ended = run(BEGIN + order + code)
    assert said.count(f"Fatal Python error: {text}") == 1, said
    assert "<module>" in said
    assert ended == -number


@pytest.mark.parametrize("crash", CRASHES)
def test_without_a_report(crash):
    code, number, _ = CRASHES[crash]
    assert run(BEGIN + ARM + code) == ("", -number)


def test_handlers_of_the_program_stay():
    script = BEGIN + ARM + """
def handle(number, frame):
    raise SystemExit(7)

signal.signal(signal.SIGUSR1, handle)
device.Arm()
os.kill(os.getpid(), signal.SIGUSR1)
signal.pause()
"""
    assert run(script) == ("", 7)
