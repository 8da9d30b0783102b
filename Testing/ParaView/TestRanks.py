# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""On several ranks, the trace is that of a single rank, and only the first rank has it: mpiexec -np N pvbatch."""

import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rig  # noqa: E402
from paraview import servermanager, simple  # noqa: E402
from paraview.modules.vtkRemotingCore import vtkProcessModule  # noqa: E402
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow  # noqa: E402

ranks = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
assert ranks > 1, "this is the test of several ranks"


def compare(haptics, name, method):
    """Compares the trace. All ranks take part in an update; the client's is the first."""
    haptics.UpdatePipeline()
    here = haptics.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints()
    with numpy.load(os.path.join(rig.REFERENCE, f"{name}-{method}.npz")) as expected:
        ticks = len(expected["Time"])
        assert here == (ticks if rig.is_first_rank() else 0), f"{name}: {here} points"
        arrays = rig.arrays_of(haptics)
        if rig.is_first_rank():
            rig.assert_same(arrays, dict(expected), f"{name}, {method}, {ranks} ranks")
            print(f"{name}, {method}: {ticks} ticks on the first of {ranks} ranks")


for name, settings in (("Wavelet", {"Scalars": ["POINTS", "RTData"], "IsoValue": 200.0}),
                       ("Head", {"Scalars": ["POINTS", "HU"], "IsoValue": -300.0, "Preset": "CT contrast"})):
    haptics = rig.touch(name, **settings)
    compare(haptics, name, "Precise")
    haptics.Method = "Surface proxy"
    haptics.ProxyRadius, haptics.ForceShading = 1.0, 0
    compare(haptics, name, "SurfaceProxy")

# Create a source that makes one piece of the image per rank, and a source of a path.
wavelet = simple.Wavelet()
simple.SetActiveSource(wavelet)
path = rig.HapticPath(Shape="Circle", Radius=8.0)
haptics = rig.VolumeHaptics(Input=wavelet, Path=path, Scalars=["POINTS", "RTData"])
ticks = rig.arrays_of(haptics)
if rig.is_first_rank():
    assert len(ticks["Force"]) == 1509, len(ticks["Force"])
    assert numpy.linalg.norm(ticks["Force"], axis=1).max() > 0.1

# Only the first rank has a view for a device. The other ranks get an error; its remedy (a path) was tested above.
device, view = rig.HapticDevice(Touch=haptics), simple.CreateRenderView()
log, console = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
vtkOutputWindow.SetInstance(log)
link = servermanager.misc.HapticView(View=view, Device=device)
link.Attached = 1
vtkOutputWindow.SetInstance(console)
told = "Attach the device to a render view of paraview or pvpython; a path can be felt anywhere" in log.GetOutput()
assert told != rig.is_first_rank(), log.GetOutput()
link.Attached = 0
