# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The presets are those of vtkHapticProperty, fitted to the image, and feel the same when copied into functions; every
setting has a property."""

import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple  # noqa: E402

# Setters that ParaView replaces by a property of the filter, or that exist for C++ only.
ELSEWHERE = {
    "Property", "MethodByName", "VisibilityFrom", "GeometryFromScalars", "GeometryFromLabels", "GeometryFromBoth",
    "PathConnection", "PathData", "SurfaceConnection", "SurfaceData", "LabelConnection", "LabelData", "LabelTable",
    "ClippingPlanes", "Cropping", "CroppingRegionPlanes", "CroppingRegionFlags", "FeelCutFaces", "Removal"}
FUNCTIONS = ("Stiffness", "Friction", "Viscosity", "SurfaceStrength", "Distinctness")

classes = rig.classes()
touch = rig.head()

listed = touch.GetProperty("Preset").GetAvailable()
assert listed == ["Custom"] + list(classes["Presets"]), f"{listed} is not {list(classes['Presets'])}"

setters = set(classes["Algorithm"]) | set(classes["Property"])
properties = set(touch.ListProperties())
assert {"KernelRadius", "SurfaceSide", "Viscosity"} < setters, setters
missing = setters - ELSEWHERE - properties
assert not missing, f"the filter in ParaView lacks {missing}"
for name in sorted(properties):
    documentation = touch.SMProxy.GetProperty(name).GetDocumentation()
    assert documentation and len(documentation.GetDescription() or "") > 20, f"{name} is not documented"

fresh = rig.touch("Head")
for name, value in classes["Defaults"].items():
    if name in ELSEWHERE:
        continue
    data = fresh.GetProperty(name).GetData()
    data = fresh.GetProperty(name).SMProperty.GetElement(0) if isinstance(data, str) else data
    assert data == value, f"{name} is {data} by default, and {value} in VTK"

for name, preset in classes["Presets"].items():
    touch.Preset = name
    expected = rig.arrays_of(touch)
    touch.InvokeCommand("CopyPreset")
    assert touch.Preset == "Custom", touch.Preset
    assert touch.GetProperty("SurfaceSide").SMProperty.GetElement(0) == preset["SurfaceSide"], name
    for function in FUNCTIONS:
        points = numpy.array(touch.GetProperty(function).GetData().Points).reshape(-1, 4)
        scale = touch.GetPropertyValue(function + "Scale") if function != "Distinctness" else 1.0
        wanted = numpy.array(preset[function]).reshape(-1, 4)
        numpy.testing.assert_allclose(points * [1, scale, 1, 1], wanted, rtol=1e-15, err_msg=f"{name}, {function}")
        shown = points[points[:, 1] < 1000, 1]  # without impenetrable tissue
        assert not shown.any() or 0.4 <= shown.max() <= 1.0, f"{name}, {function}: {points} do not fill the editor's 0 to 1"
    copied = rig.arrays_of(touch)
    for array, wanted in expected.items():
        numpy.testing.assert_allclose(copied[array], wanted, rtol=1e-9, atol=1e-9, err_msg=f"{name}, {array}")
    # Edited values must change the force.
    touch.StiffnessScale = 800.0
    touch.Stiffness.Points = [0, 0.25, 0.5, 0, 100, 0.25, 0.5, 0]
    # The weights of mixed labels are rounded, hence the tolerance.
    numpy.testing.assert_allclose(rig.arrays_of(touch)["Stiffness"], 200.0, rtol=1e-12, err_msg=name)

# Grey levels have no unit: an image with another brightness must feel the same, even if it is set after the preset.
touch = rig.head(Preset="MRI")
head = touch.Input
expected = rig.arrays_of(touch)
assert numpy.linalg.norm(expected["Force"], axis=1).max() > 0.1
touch.UpdatePropertyInformation()
scale = numpy.array(touch.GetPropertyValue("PresetScale"))
assert scale.min() > 0 and abs(scale[0] - 1) > 0.1, scale
name = head.PointData.GetArray(0).GetName()
touch.Input = simple.Calculator(Input=head, ResultArrayName=name, Function=f"0.25*{name}")
dark = rig.arrays_of(touch)
touch.UpdatePropertyInformation()
numpy.testing.assert_allclose(touch.GetPropertyValue("PresetScale"), 0.25 * scale, rtol=1e-3)
numpy.testing.assert_allclose(dark["Force"], expected["Force"], atol=2e-3)
assert numpy.linalg.norm(dark["Force"], axis=1).max() > 0.1
