# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""With the data on a server of one or more ranks, every tick has the force that the whole volume gives."""
import sys

from paraview import servermanager, simple
from vtkmodules.numpy_interface import dataset_adapter
import numpy

import live

RANKS = int(sys.argv[3])
LOG = live.FOLDER + "/remote%d.csv" % RANKS
HEAD = sys.argv[4]


def touch_head():
    head = simple.XMLImageDataReader(FileName=[HEAD])
    # With a power of two as the scale, converting a tip from the device's space to the world and back preserves every
    # bit.
    return simple.VolumeHaptics(Input=head, Preset="CT contrast", MetersPerWorldUnit=2.0**-10)


def offline(touch, tips):
    """Returns the forces along a path with one point for each tick, from the data in this process."""
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.util.numpy_support import numpy_to_vtk

    points = vtkPoints()
    points.SetData(numpy_to_vtk(tips, deep=True))
    path = vtkPolyData()
    path.SetPoints(points)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(path)
    touch.Path = producer
    touch.UpdatePipeline()
    output = dataset_adapter.WrapDataObject(servermanager.Fetch(touch))
    return numpy.array(output.PointData["Force"])


def lead(device):
    """Records the armed hand's way to the head, from a tip that the data surround."""
    device.VirtualTip = [-60, -100, 60]
    live.check(live.poll(device, lambda: live.distance(device.TipPosition, [-60, -100, 60]) < 1e-9), "the tip is at its start")
    live.check(live.poll(device, lambda: device.Residency == 1.0), "the region is here", device.StatusText)
    device.Recording = 1
    device.Armed = 1
    for way in numpy.linspace([-60, -100, 60], [30, -78, 20], 300):
        device.VirtualTip = list(way)
        live.poll_for(device, 0.01)
    device.Recording = 0


with live.Server(RANKS):
    live.load_plugin(remote=True)
    touch = touch_head()
    device = simple.HapticDevice(Touch=touch, MaximumRegionVoxels=48**3)
    device.RecordingFile = LOG
    device.VirtualTip = [-60, -100, 60]
    device.Running = 1
    live.check(live.poll(device, lambda: device.TickRate > 0), "the servo ticks", device.StatusText)
    lead(device)
    for _ in range(3):
        if device.Armed == 0 and "AttentionTime" in device.StatusText:
            lead(device)  # a busy machine kept this client from polling the device in time
    live.check(device.Armed == 1, "the hand is still held", device.StatusText)
    print("latency %.1f ms, missed ticks %d" % (1e3 * device.Latency, device.MissedTicks))
    points = servermanager.Fetch(device).GetNumberOfPoints()
    live.check(points == 12, "the server shows the hand once", points)
    simple.Disconnect()

simple.Connect()
live.load_plugin()
log = live.read_log(LOG)
tips = numpy.column_stack([log["Tip %s (world)" % a] for a in "xyz"])
felt = numpy.column_stack([log["Force %s (N)" % a] for a in "xyz"])
resident = numpy.array(log["Residency"])
whole = offline(touch_head(), tips)
live.check(len(whole) == len(felt), "ticks are complete", len(whole), len(felt))
first_absent = int(numpy.argmax(resident < 1.0)) if (resident < 1.0).any() else len(resident)
# After a pause of the loop on a busy machine, a new contact begins.
pauses = numpy.nonzero(numpy.diff(log["Time (s)"]) > 0.02)[0]
first_end = min(first_absent, pauses[0] + 1) if len(pauses) else first_absent
difference = numpy.abs(whole - felt).max(axis=1)
print("ticks %d, resident %d, largest force %.3f N, largest difference %.3g N"
      % (len(felt), (resident == 1.0).sum(), numpy.abs(felt).max(), difference[resident == 1.0].max()))
live.check(numpy.abs(felt).max() > 0.5, "something was felt")
live.check(first_absent > 2000, "the data were there for most of the way", first_absent)
live.check(first_end > 500, "the loop ticked for some way", first_end)
live.check(difference[:first_end].max() < 1e-9, "forces are those of the whole", difference[:first_end].max())
