# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A fault in the input is reported to the user with a cure, and has no other effect."""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple  # noqa: E402
from vtkmodules.vtkCommonCore import vtkPoints  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkPolyData  # noqa: E402


def path_through(*points):
    path = vtkPolyData()
    path.SetPoints(vtkPoints())
    path.GetPoints().SetDataTypeToDouble()
    for point in points:
        path.GetPoints().InsertNextPoint(point)
    return rig.produce(path)


def touch(**inputs):
    simple.SetActiveSource(inputs["Input"])
    return rig.VolumeHaptics(**inputs)


head = rig.read("Head.vti")
line = rig.HapticPath(Point1=[0, 0, 115], Point2=[0, 0, 98])

# Without a path, the applied filter must have an empty output and no error. Then set a path, and remove it again.
haptics = touch(Input=head)
rig.expect(haptics)
assert haptics.GetDataInformation().GetNumberOfPoints() == 0
haptics.Path = line
rig.expect(haptics)
assert haptics.GetDataInformation().GetNumberOfPoints() == 171
haptics.Path = None
rig.expect(haptics)
assert haptics.GetDataInformation().GetNumberOfPoints() == 0

# The panel's list offers only polygonal data as a path.
chooser = haptics.SMProxy.GetProperty("Path")
chooser.SetUncheckedInputConnection(0, line.SMProxy, 0)
assert chooser.IsInDomains(), "a line is no path"
chooser.SetUncheckedInputConnection(0, head.SMProxy, 0)
assert not chooser.IsInDomains(), "an image is a path"
chooser.ClearUncheckedElements()

wavelet = simple.Wavelet()
cells = simple.PointDatatoCellData(Input=wavelet)
cells.UpdatePipeline()
rig.expect(touch(Input=cells, Path=line), "no point scalars", "active scalars")
wrong = touch(Input=head, Path=line)
wrong.Scalars = ["POINTS", "Nothing"]
rig.expect(wrong, "Nothing", "numeric point array")
thin = simple.Wavelet(WholeExtent=[-5, 5, 0, 0, -5, 5])
thin.UpdatePipeline()
rig.expect(touch(Input=thin, Path=line), "voxel")
rig.expect(touch(Input=head, Path=path_through((0, 0, 115), (math.nan, 0, 98))), "NaN", "point 1")
rig.expect(touch(Input=head, Path=line, Component=3), "omponent")
rig.expect(touch(Input=head, Path=line, Preset="Wood"), "Wood", "CT contrast")
rig.expect(rig.HapticPath(Point1=[1, 2, 3], Point2=[1, 2, 3]), "Point1 and Point2", "Move")
rig.expect(rig.HapticPath(Shape="From file", FileName="nowhere.vtp"), "nowhere.vtp", "does not exist")
rig.expect(rig.HapticPath(Shape="Spiral", Radius=-1.0), "Radius", "more than 0")

# After the errors, a correct path still works.
haptics.Path = line
rig.expect(haptics)
assert haptics.GetDataInformation().GetNumberOfPoints() == 171
