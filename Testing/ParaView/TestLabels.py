# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sets labels as a second input, and their materials from files and rows.

The whole volume has one label, so the trace shows the values of the table. Without a material, the trace is the same
to the bit.
"""

import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from vtkmodules.vtkCommonCore import VTK_SHORT  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData  # noqa: E402


def everywhere(label):
    image = vtkImageData()
    image.SetDimensions(3, 3, 3)
    image.SetSpacing(500, 500, 500)
    image.SetOrigin(-500, -500, -500)
    image.AllocateScalars(VTK_SHORT, 1)
    image.GetPointData().GetScalars().Fill(label)
    return rig.produce(image)


def arrays_with_labels(touch):
    """Returns the trace's arrays without the label, which is 5 wherever a label was read."""
    found = rig.arrays_of(touch)
    assert set(found.pop("Label")) <= {0, 5} and found["Force"].any()
    return found


def write(name, text):
    path = os.path.join(rig.OUTPUT, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


touch = rig.head()
plain = rig.arrays_of(touch)
assert numpy.linalg.norm(plain["Force"], axis=1).max() > 0.1
touch.Labels = everywhere(5)
rig.assert_same(arrays_with_labels(touch), plain, "without a table")
touch.LabelMaterials = [6, 123, 0.5, 0, 9]
rig.assert_same(arrays_with_labels(touch), plain, "with a material of another label")

touch.LabelMaterials = [6, 1, 1, 1, 1, 5, 123, 0.25, -1, 9]
found = rig.arrays_of(touch)
assert (found["Stiffness"] == 123).all() and (found["Friction"] == 0.25).all()
assert 0.0 < found["SurfaceStrength"].max() <= 9.0  # times distinctness

touch.LabelFiles = [write("names.csv", "label,name,stiffness,friction\n5,all,77,0.75\n")]
assert (rig.arrays_of(touch)["Stiffness"] == 123).all(), "rows come after files"
touch.LabelMaterials = []
found = rig.arrays_of(touch)
assert (found["Stiffness"] == 77).all() and (found["Friction"] == 0.75).all()
touch.LabelFiles = [touch.LabelFiles[0], write("unfelt.csv", "label,felt\n5,0\n")]
assert not rig.arrays_of(touch)["NormalForce"].any(), "a label that is not felt"

rig.expect(touch, "bad.csv", "Line 2", "maybe", LabelFiles=[write("bad.csv", "label,felt\n5,maybe\n")])
touch.LabelFiles = []
rig.expect(touch, "Label Materials", "5.5", "whole number", LabelMaterials=[5.5, 1, 1, 1, 1])
rig.expect(touch, "Label Materials", "-3", "0 or more", LabelMaterials=[5, -3, 1, 1, 1])
touch.LabelMaterials = []
rig.assert_same(arrays_with_labels(touch), plain, "without materials again")
touch.Labels = None
rig.assert_same(rig.arrays_of(touch), plain, "without labels again")
