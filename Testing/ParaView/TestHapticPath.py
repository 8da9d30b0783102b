# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The source Haptic Path is vtkHapticPathSource, its output is felt, and Plot Data takes the trace unchanged."""

import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple  # noqa: E402

path = rig.HapticPath()
for name in sorted(set(path.ListProperties())):
    documentation = path.SMProxy.GetProperty(name).GetDocumentation()
    assert documentation and len(documentation.GetDescription() or "") > 20, f"{name} is not documented"
missing = set(rig.classes()["Path"]) - set(path.ListProperties()) - {"BoxBounds"}
assert not missing, f"the source in ParaView lacks {missing}"

ends = {
    "Line": ([-50, 0, 0], [50, 0, 0]),
    "Circle": ([20, 0, 0], [20, 0, 0]),
    "Spiral": ([0, 0, 0], [20, 0, 0]),
    "Press and slide": ([-25, 0, 35], [25, 0, 35]),
}
for shape, (first, last) in ends.items():
    path.Shape = shape
    arrays = rig.arrays_of(path)
    points = arrays["Proxy"]
    numpy.testing.assert_allclose([points[0], points[-1]], [first, last], atol=1e-9, err_msg=shape)
    steps = numpy.linalg.norm(numpy.diff(points, axis=0), axis=1)
    assert steps.max() <= 0.1 * (1 + 1e-9), f"{shape}: {steps.max()}"
    assert (numpy.diff(arrays["Time"]) > 0).all(), shape

# Save the path as .csv with ParaView, and read it back.
table = os.path.join(rig.OUTPUT, "path.csv")
path.Shape = "Line"
path.Point1, path.Point2 = [0, 0, 115], [0, 0, 98]
written = rig.arrays_of(path)
simple.SaveData(table, proxy=path, Precision=17, UseScientificNotation=1)
again = rig.arrays_of(rig.HapticPath(Shape="From file", FileName=table))
rig.assert_same(again, written, "a path by way of ParaView's .csv")

haptics = rig.head()
haptics.Path = path
felt = rig.arrays_of(haptics)
assert numpy.linalg.norm(felt["Force"], axis=1).max() > 0.1

# The plot must have one row per tick, with all arrays, over the time.
plot = simple.PlotData(Input=haptics)
plot.UpdatePipeline()
assert plot.GetDataInformation().GetNumberOfPoints() == len(felt["Time"])
view = simple.CreateView("XYChartView")
display = simple.Show(plot, view)
display.UseIndexForXAxis = 0
display.XArrayName = "Time"
display.SeriesVisibility = ["NormalForce", "1", "Stiffness", "0"]
simple.Render(view)
assert "NormalForce" in list(display.SeriesVisibility) and "Time" in str(display.XArrayName)
picture = os.path.join(rig.OUTPUT, "plot.png")
simple.SaveScreenshot(picture, view, ImageResolution=[400, 300])
assert os.path.getsize(picture) > 3000
