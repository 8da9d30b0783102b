# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""State files of both kinds, and ParaView's Python trace, restore a filter that gives the same trace of the hand."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple, smstate, smtrace  # noqa: E402


def build():
    """Builds a pipeline with many settings that differ from their defaults."""
    path = rig.HapticPath(registrationName="stroke", Shape="Press and slide", PressDirection="-Z", Depth=5.0)
    volume = rig.read("Head.vti")
    simple.SetActiveSource(volume)
    touch = rig.VolumeHaptics(registrationName="touch", Input=volume, Path=path, KernelRadius=3)
    # Record the effect of the panel's button Apply in the trace.
    applied = [smtrace.PropertiesModified(proxy.SMProxy) for proxy in (path, touch)]
    path.BoxCorner, path.BoxSize = [-30, -5, 0], [30, 10, 105]
    touch.Scalars = ["POINTS", "HU"]
    touch.StiffnessScale = 800.0
    touch.Stiffness.Points = [-1000, 0.0, 0.5, 0, 0, 0.4, 0.5, 0, 2000, 1.0, 0.5, 0]
    touch.Friction.Points = [0, 0.1, 0.5, 0, 1000, 0.3, 0.5, 0]
    touch.DistinctnessFromNoise = 0
    touch.Distinctness.Points = [5, 0.0, 0.5, 0, 50, 1.0, 0.5, 0]
    touch.SurfaceSide = "Both"
    for item in applied:
        item.finalize()
    return touch


def found_again(what):
    touch = simple.FindSource("touch")
    assert touch, f"{what}: no filter came back"
    rig.assert_same(rig.arrays_of(touch), expected, what)
    return touch


smtrace.start_trace()
touch = build()
expected = rig.arrays_of(touch)
traced = smtrace.stop_trace()
assert expected["Contact"].max() > 0, "nothing is touched"
state = os.path.join(rig.OUTPUT, "haptics.pvsm")
simple.SaveState(state)
script = smstate.get_state()

simple.ResetSession()
assert not simple.FindSource("touch")
simple.LoadState(state)
found_again("the state file").StiffnessScale = 400.0
assert rig.arrays_of(simple.FindSource("touch"))["Stiffness"].max() < expected["Stiffness"].max()

for what, text in (("the state in Python", script), ("the trace in Python", traced)):
    assert "VolumeHaptics" in text and "HapticPath" in text, f"{what}:\n{text}"
    simple.ResetSession()
    file = os.path.join(rig.OUTPUT, what.split()[1] + "-in-python.py")
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(text)
    names = vars(rig).copy()
    exec(compile(text, file, "exec"), names)
    found_again(what)
