# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every method gives in ParaView what it gives in the VTK build, bit for bit."""

import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple  # noqa: E402
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

# A flow along x, as image data and as data of other kinds: across it, a spring of 500 N/m, and nothing along it.
wavelet = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
flow = simple.Calculator(Input=wavelet, ResultArrayName="U", Function="3*iHat")
cells = simple.AppendDatasets(Input=flow)
across = simple.Line(Point1=[-2, 0, 0], Point2=[2, 3, 0], Resolution=300)
for data in (flow, cells, simple.GroupDatasets(Input=[cells, flow])):
    data.UpdatePipeline()
    simple.SetActiveSource(data)
    felt = rig.VolumeHaptics(Input=data, Path=across, Method="Primitives", Modes=["VectorFollow", "U", "2", ""])
    chooser = felt.SMProxy.GetProperty("Input")
    chooser.SetUncheckedInputConnection(0, data.SMProxy, 0)
    assert chooser.IsInDomains(), f"the menu offers no {data}"
    chooser.ClearUncheckedElements()
    force = rig.arrays_of(felt)["Force"]
    assert len(force) == 301, data
    assert numpy.allclose(force, [(0, -0.5 * y, 0) for y in numpy.linspace(0, 3, 301)], atol=0.005), data
