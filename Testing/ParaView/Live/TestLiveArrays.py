# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Data on a server of two ranks: bits, which are refused with an error, and a volume with no part on the first rank."""
from paraview import simple

import live

INFORMATION = """
executive = self.GetExecutive()
executive.GetOutputInformation(0).Set(executive.WHOLE_EXTENT(), 0, 30, 0, 30, 0, 30)
"""
DATA = """
from vtkmodules.vtkCommonCore import vtkBitArray, vtkFloatArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController
image = self.GetImageDataOutput()
if vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 1:
    image.SetExtent(0, 30, 0, 30, 0, 30)
    count = image.GetNumberOfPoints()
    for array, name in ((vtkFloatArray(), "Value"), (vtkBitArray(), "Bits")):
        array.SetName(name)
        array.SetNumberOfTuples(count)
        for i in range(count):
            array.SetTuple1(i, 8.0 * (i % 31) if name == "Value" else i % 2)
        image.GetPointData().AddArray(array)
"""

with live.Server(2):
    live.load_plugin(remote=True)
    volume = simple.ProgrammableSource(OutputDataSetType="vtkImageData", ScriptRequestInformation=INFORMATION, Script=DATA)
    touch = simple.VolumeHaptics(Input=volume, Scalars=["POINTS", "Bits"])
    device = simple.HapticDevice(Touch=touch, VirtualTip=[5, 15, 15], MaximumRegionVoxels=2**40)
    device.Running = 1
    live.check(live.poll(device, lambda: "bits" in device.StatusText), "bits are refused", device.StatusText)
    touch.Scalars = ["POINTS", "Value"]
    live.press(device, [5, 15, 15], [12, 15, 15])
    live.check(live.poll(device, lambda: live.norm(device.Force) > 0.5), "the other rank's array is felt", device.StatusText)
    device.Running = 0
    simple.Disconnect()
