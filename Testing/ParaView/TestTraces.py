# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every method gives in ParaView what it gives in the VTK build, bit for bit."""

import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from scenes import METHODS, SCENES  # noqa: E402

compared = 0
for name, scene in SCENES.items():
    if not os.path.exists(os.path.join(rig.REFERENCE, name + ".vti")):
        print(f"{name}: not compared; Examples/explore.sh fetches it")
        continue
    touch = rig.touch(name)
    touch.IsoValue = scene.iso_value
    touch.Preset = scene.preset
    fresh = {prop: touch.GetProperty(prop).GetData() for settings in METHODS.values() for prop in settings}
    for method, settings in METHODS.items():
        for prop, value in {**fresh, **settings}.items():
            touch.SetPropertyWithName(prop, value)
        with numpy.load(os.path.join(rig.REFERENCE, f"{name}-{method}.npz")) as expected:
            arrays = rig.arrays_of(touch)
            rig.assert_same(arrays, dict(expected), f"{name}, {method}")
        force = numpy.linalg.norm(arrays["Force"], axis=1)
        assert force.max() > 0.01, f"{name}, {method}: nothing is felt"
        print(f"{name}, {method}: {len(force)} ticks, {len(arrays)} arrays, up to {force.max():.3g} N")
        compared += 1
assert compared >= 2 * len(METHODS)
