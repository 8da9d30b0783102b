# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls every public method of every class in any order with any arguments; each call returns or reports an error. See
chaos.py."""

import os

import chaos
import pytest
import volumehaptics.vtkVolumeHaptics as module

# Number of seeds, and of calls per seed: `VOLUMEHAPTICS_CHAOS=1000x2000` makes a long search.
SEEDS, CALLS = map(int, os.environ.get("VOLUMEHAPTICS_CHAOS", "10x600").split("x"))


def test_every_method_is_known():
    """The documentation of the wrapped classes names the argument types of each method."""
    classes = [cls for cls in vars(module).values() if isinstance(cls, type) and cls.__name__.startswith("vtk")]
    assert len(classes) >= 15
    for cls in classes:
        for name, choices in chaos.methods(cls, module).items():
            assert choices or name not in vars(cls), f"{cls.__name__}.{name} has no C++ signature"
    device = chaos.methods(module.vtkHapticDevice, module)
    hand = chaos.methods(module.vtkHapticVirtualHand, module)
    assert hand["SetPosition"] == [["double", "double", "double"], ["const double [3]"]]
    assert device["SetVolumeHaptics"] == [["vtkVolumeHapticsFilter *"]] and device["Open"] == [["const char *"]]
    state = chaos.methods(module.vtkHapticState, module)
    assert state["Drain"] == [["vtkTable *", "int"]] and device["Arm"] == [[]]
    assert "IsA" not in device and "Update" in chaos.methods(module.vtkHapticPathSource, module)


def test_errors_with_false_are_read_from_the_documentation():
    """If the documentation's wording changes, the check for silent failures must not be dropped unnoticed."""
    for cls, names in (
            (module.vtkHapticDevice, ("Open", "Start", "Publish")), (module.vtkHapticSetup, ("Save", "Load")),
            (module.vtkHapticRegionSource, ("OpenFile", "OpenDataSet")), (module.vtkHapticProperty, ("ApplyPreset",)),
            (module.vtkHapticLabelTable, ("ReadFile", "WriteFile")), (module.vtkVolumeHapticsFilter, ("SetMethodByName",)),
            (module.vtkInteractorStyleHaptic, ("TouchVolume", "NextMethod")), (module.vtkHapticMeasurements, ("WriteFile",))):
        for name in names:
            documented = " ".join(getattr(cls, name).__doc__.split())
            assert chaos.ERROR_WITH_FALSE.search(documented), f"{cls.__name__}.{name}: {documented}"


@pytest.mark.parametrize("fault, words", (
    ("crash", "Segmentation fault"), ("hang", "Timeout"), ("force", "above its limit of 4.0 N"), ("silence", "without text")))
def test_what_goes_wrong_is_found(tmp_path, fault, words):
    """Makes a process go wrong on purpose, to show that the search finds such faults."""
    trouble = chaos.run_seed(7, 20, tmp_path, "--fault", fault, "--slowest", "5")
    assert trouble.startswith("seed 7: ") and words in trouble and f"going wrong: {fault}" in trouble, trouble


def test_any_calls_in_any_order(tmp_path):
    # Leave out these methods under the address sanitizer, which ends a process that requests more memory than exists,
    # for example for a path of 1e8 points.
    left_out = "PathSource.Set(Speed|PointsPerSecond)" if "VOLUMEHAPTICS_SANITIZED" in os.environ else chaos.NONE
    troubles = list(chaos.run_seeds(range(SEEDS), CALLS, os.cpu_count() or 1, tmp_path, "--left-out", left_out))
    assert not troubles, "\n\n".join(troubles)
