# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Takes a needle as the filter's tool: its forces follow from layers of known tissue, and bad settings are errors.

The layers (mm, N/m of the shaft, N to cut) are 3, 20, 0.3 | 12, 5, 0.1 | 20, 25, 0.3 | 3, 60, 0.8 | fluid. A needle that
is pushed feels the cutting force around its point and, in and out, the sum of friction times length along its shaft.
"""

import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk  # noqa: E402
from vtkmodules.vtkCommonCore import vtkPoints  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData  # noqa: E402

LAYERS = ((3, 20, 0.3), (12, 5, 0.1), (20, 25, 0.3), (3, 60, 0.8), (100, 0, 0))
SKIN = 4.5  # mm
# Columns: depth (mm), force (N) during insertion, force (N) during extraction.
EXPECTED = ((2.5, 0.35, 0.05), (14.5, 0.1 + 0.06 + 0.0575, 0.06 + 0.0575), (25, 0.67, 0.37), (34.5, 0.9075, 0.6075),
            (37.5, 1.57, 0.77), (40, 0.8, 0.8))


def stack(values):
    image = vtkImageData()
    image.SetDimensions(16, 16, 56)
    samples = numpy.repeat(numpy.array([values(k) for k in range(56)], numpy.int16), 256)
    image.GetPointData().SetScalars(numpy_to_vtk(samples, deep=True))
    image.GetPointData().GetScalars().SetName("values")
    return rig.produce(image)


def label_at(depth):
    ends = numpy.cumsum([layer[0] for layer in LAYERS])
    return 0 if depth < 0 else 1 + int(numpy.searchsorted(ends, depth))


def path(*places):
    z = numpy.concatenate([numpy.arange(a, b, 0.01 if b > a else -0.01) for a, b in zip(places, places[1:])])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.stack([numpy.full_like(z, 7.0), numpy.full_like(z, 7.0), z], 1), deep=True))
    line = vtkPolyData()
    line.SetPoints(points)
    return rig.produce(line)


def forces(touch):
    """Returns the forces along the needle (N) by depth (mm): pushed in and drawn out."""
    arrays = rig.arrays_of(touch)
    depth, force = arrays["Depth"], arrays["Force"][:, 2]
    inside, deepest = depth > 0, int(numpy.argmax(depth))
    assert inside.any(), "the needle was not inserted"
    going_in = inside & (numpy.arange(len(depth)) < deepest)
    out = inside & (numpy.arange(len(depth)) > deepest)
    return {name: (depth[part], sign * force[part]) for name, part, sign in (("in", going_in, -1), ("out", out, 1))}


def at(curve, depth):
    order = numpy.argsort(curve[0])
    return numpy.interp(depth, curve[0][order], curve[1][order])


def refuse(touch, name, value, *words):
    before = touch.GetProperty(name).GetData()
    rig.expect(touch, *words, **{name: value})
    setattr(touch, name, before)


table = os.path.join(rig.OUTPUT, "tissues.csv")
with open(table, "w", encoding="utf-8") as file:
    file.write("label,name,stiffness,strength,viscosity,shaft\n")
    for number, (_, shaft, cutting) in enumerate(LAYERS, 1):
        file.write(f"{number},layer {number},500,0,{cutting},{shaft}\n")

image, labels = stack(lambda k: 0), stack(lambda k: label_at(k - SKIN))
simple.SetActiveSource(image)
touch = rig.VolumeHaptics(Input=image, Path=path(2, 48, 1), Labels=labels, LabelFiles=[table],
                          Geometry="From labels")
assert "Depth" not in rig.arrays_of(touch), "without a tool"
touch.Tool = "Needle"
felt = forces(touch)
for depth, going_in, out in EXPECTED:
    assert abs(at(felt["in"], depth) - going_in) < 0.01 * going_in, (depth, at(felt["in"], depth), going_in)
    assert abs(at(felt["out"], depth) - out) < 0.01 * out, (depth, at(felt["out"], depth), out)

# Without labels, the scalars select the material: friction of 10 N per metre of the shaft, and 0.25 N to cut, where the
# value is 100.
plain = stack(lambda k: 100 if k > SKIN else 0)
simple.SetActiveSource(plain)
touch = rig.VolumeHaptics(Input=plain, Path=path(2, 30, 1), Tool="Needle",
                          NeedleShaftFriction="50 0, 51 10", NeedleCuttingForce="50 0, 51 0.25")
felt = forces(touch)
deepest = felt["in"][0].max()
assert deepest > 15, deepest
lost = at(felt["in"], 15) - at(felt["out"], 15)
assert abs(lost - 0.25) < 0.01 * 0.25, f"{lost} N to cut"
assert abs((at(felt["out"], 15) - at(felt["out"], 5)) / 0.01 - 10) < 0.1, "N per metre"

refuse(touch, "NeedleShaftFriction", "much", "Needle Shaft Friction", "much", "pairs")
refuse(touch, "NeedleCuttingForce", "1 2 3", "Needle Cutting Force", "1 2 3")
refuse(touch, "Tool", "Spoon", "Spoon", '"Point shell" or "Burr"')
refuse(touch, "Method", "Force field", "SetMethodToProxy()")
touch.Tool = "None"
assert "Depth" not in rig.arrays_of(touch)
