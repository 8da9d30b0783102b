# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView, every method gives the trace of the VTK build, bit for bit."""

import os
import pathlib
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import simple  # noqa: E402
from scenes import METHODS, SCENES  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk  # noqa: E402
from vtkmodules.vtkCommonCore import vtkPoints  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid, vtkStructuredGrid  # noqa: E402

sys.path.insert(0, os.path.join(rig.SOURCE, "Testing", "Python"))
from foam import write_foam  # noqa: E402

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



def block(kind):
    """Returns a flow U along x on the points of a grid of the given kind, from -10 to 10 in each direction."""
    data = kind()
    data.SetDimensions(21, 21, 21)
    ticks = numpy.linspace(-10, 10, 21)
    if kind is vtkRectilinearGrid:
        data.SetXCoordinates(numpy_to_vtk(ticks, deep=True))
        data.SetYCoordinates(numpy_to_vtk(ticks, deep=True))
        data.SetZCoordinates(numpy_to_vtk(ticks, deep=True))
    else:
        z, y, x = numpy.meshgrid(ticks, ticks, ticks, indexing="ij")
        points = vtkPoints()
        points.SetData(numpy_to_vtk(numpy.stack([x, y, z], -1).reshape(-1, 3), deep=True))
        data.SetPoints(points)
    array = numpy_to_vtk(numpy.tile([3.0, 0.0, 0.0], (21**3, 1)), deep=True)
    array.SetName("U")
    data.GetPointData().SetVectors(array)
    return rig.produce(data)


def feel_across(data, y, time=None):
    """Returns the force of a path that goes 4 along the flow and 4 across it: a spring of 500 N/m across, and none
    along the flow."""
    across = simple.Line(Point1=[-2, 0, 0], Point2=[2, y, 0], Resolution=300)
    simple.SetActiveSource(data)
    felt = rig.VolumeHaptics(Input=data, Path=across, Method="Primitives", Modes=["VectorFollow", "U", "2", ""])
    chooser = felt.SMProxy.GetProperty("Input")
    chooser.SetUncheckedInputConnection(0, data.SMProxy, 0)
    assert chooser.IsInDomains(), f"the menu offers no {data}"
    chooser.ClearUncheckedElements()
    if time is not None:
        felt.UpdatePipeline(time)
    force = rig.arrays_of(felt)["Force"]
    assert len(force) == 301, data
    assert numpy.allclose(force, [(0, -0.5 * y, 0) for y in numpy.linspace(0, y, 301)], atol=0.005), data


# Make a flow along x, as image data and as data of other kinds.
wavelet = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
flow = simple.Calculator(Input=wavelet, ResultArrayName="U", Function="3*iHat")
cells = simple.AppendDatasets(Input=flow)
grouped = simple.GroupDatasets(Input=[cells, flow])
for data in (flow, cells, grouped, block(vtkRectilinearGrid), block(vtkStructuredGrid)):
    data.UpdatePipeline()
    feel_across(data, 3.0)

# Write a case of OpenFOAM whose flow, in a row of cells, exists only at its second time step. The cells are so thin
# that the samples, whose spacing is the mean width of a cell, are 1.5 apart.
case = write_foam(pathlib.Path(rig.OUTPUT) / "case", (20.0, 6.0, 12.0), numpy.tile([3.0, 0.0, 0.0], (850, 1)))
reader = simple.OpenFOAMReader(FileName=str(case))
reader.UpdatePipeline(10.0)
moved = simple.Transform(Input=reader)
moved.Transform.Translate = [-10.0, 0.0, -6.0]
moved.UpdatePipeline(10.0)
feel_across(moved, 1.5, time=10.0)
