# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The animation's time drives the device: a wall that moves with the time pushes a resting hand, in this process or
from a server.

The wall is at z = 10 + t and 500 N/m stiff, and the hand at z = 12: the force is 0.5 max(0, t - 2) N, whatever the
hand did before. If each time published a new volume, the wall would appear around the hand, without force. The
wall's mesh does the same to a sphere, one radius sooner. A state file restores all of this.
"""
import builtins  # ParaView gives scripts other functions of these names
import sys

from paraview import servermanager, simple

import live

REMOTE, MESH = (sys.argv[3] == case for case in ("Remote", "Mesh"))
TIP = 12.0
RADIUS = 0.25 if MESH else 0.0
INFORMATION = """
executive = self.GetExecutive()
information = executive.GetOutputInformation(0)
information.Set(executive.WHOLE_EXTENT(), 0, 99, 0, 23, 0, 23)
information.Remove(executive.TIME_STEPS())
for i in range(5):
    information.Append(executive.TIME_STEPS(), float(i))
information.Set(executive.TIME_RANGE(), [0.0, 4.0], 2)
"""
# The last rank has all of the data.
DATA = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkParallelCore import vtkMultiProcessController
image = self.GetImageDataOutput()
information = self.GetOutputInformation(0)
executive = self.GetExecutive()
time = information.Get(executive.UPDATE_TIME_STEP()) if information.Has(executive.UPDATE_TIME_STEP()) else 0.0
controller = vtkMultiProcessController.GetGlobalController()
if not controller or controller.GetLocalProcessId() + 1 == controller.GetNumberOfProcesses():
    image.SetExtent(0, 99, 0, 23, 0, 23)
    slices = 500.0 * (1.0 - numpy.tanh((numpy.arange(24.0) - 10.0 - time) / 1.5))
    array = numpy_to_vtk(numpy.repeat(slices, 100 * 24), deep=True)
    array.SetName("Wall")
    image.GetPointData().SetScalars(array)
"""


def expected(time):
    return 0.5 * builtins.max(0.0, time - 2.0 + RADIUS)


def is_force(time):
    return abs(device.ComputedForce[2] - expected(time)) < 0.02


def go(how, time):
    """Goes to a time by a button of the VCR, or directly."""
    how()
    live.check(keeper.Time == time, "the time of the animation", keeper.Time, time)
    live.check(live.poll(device, lambda: is_force(time)), "the force at time %g" % time,
               list(device.ComputedForce), expected(time), device.StatusText)
    live.poll_for(device, 0.15)
    live.check(is_force(time), "and it stays", list(device.ComputedForce), expected(time))


def rest():
    """Rests the hand where the wall will be."""
    device.Running = 1
    live.check(live.poll(device, lambda: device.TickRate > 0 and live.distance(device.TipPosition, [20, 12, TIP]) < 1e-9
                         and device.Residency == 1.0), "the hand rests where the wall will be", device.StatusText)
    live.check(is_force(0.0), "it is in the air", list(device.ComputedForce))


def touch():
    global volume, scene, keeper, device
    volume = simple.ProgrammableSource(OutputDataSetType="vtkImageData", ScriptRequestInformation=INFORMATION, Script=DATA)
    volume.UpdatePipelineInformation()
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    keeper = simple.GetTimeKeeper()
    scene.AnimationTime = 0.0
    filter = simple.VolumeHaptics(Input=volume, Scalars=["POINTS", "Wall"], MaterialPlacement=0)
    # At its end, the wall needs 1 N. A smaller strength would let it slip.
    filter.SurfaceStrength.Points = [0.0, 1.5, 0.5, 0.0, 1000.0, 1.5, 0.5, 0.0]
    if MESH:
        filter.Method, filter.IsoValue, filter.ProxyRadius = "Surface proxy", 500.0, RADIUS
    device = simple.HapticDevice(Touch=filter, MaximumRegionVoxels=44**3, VirtualTip=[20.0, 12.0, TIP])
    rest()
    device.RecordingFile = live.FOLDER + ("/time.csv" if REMOTE else "/time.vtp")
    device.Recording = 1
    for time in (1.0, 2.0, 3.0, 4.0):
        go(scene.GoToNext, time)
    for time in (3.0, 2.0):
        go(scene.GoToPrevious, time)
    # Play the animation while the hand slides. With a server, the hand slides into other regions, each of which needs
    # both time steps.
    for i, time in enumerate((3.0, 4.0, 3.0, 4.0, 3.0, 4.0)):
        scene.AnimationTime = time
        for j in range(8):
            device.VirtualTip = [20.0 + 8.0 * i + j, 12.0, TIP]
            live.poll_for(device, 0.02)
    live.check(live.poll(device, lambda: is_force(4.0) and device.Residency == 1.0), "the force after sliding",
               list(device.ComputedForce), device.StatusText)
    device.Recording = 0
    # Press a button that skips time steps, while other settings of the pipeline change.
    scene.GoToFirst()
    live.check(live.poll(device, lambda: is_force(0.0)), "the wall is gone", list(device.ComputedForce))
    volume.Script = DATA.replace("10.0 - time", "14.0")
    live.poll_for(device, 0.3)
    live.check(device.ComputedForce[2] < 0.02, "a wall that appears begins a contact anew", list(device.ComputedForce))
    live.check("rror" not in device.StatusText, "nothing is wrong", device.StatusText)


def play():
    """Presses Play and Stop of the VCR while the hand is touched, and runs the event loop's work between two
    pictures."""
    device.VirtualTip = [20.0, 12.0, TIP]
    volume.Script = DATA
    scene.GoToFirst()
    live.check(live.poll(device, lambda: is_force(0.0) and device.Residency == 1.0), "the hand rests in the air again",
               list(device.ComputedForce), device.StatusText)
    scene.PlayMode = "Snap To TimeSteps"
    player = scene.GetClientSideObject()
    stop_at, seen = None, []

    def between_pictures(*_):
        if not seen or keeper.Time != seen[-1]:
            seen.append(keeper.Time)
            live.check(live.poll(device, lambda: is_force(keeper.Time)), "the force comes with what is seen", keeper.Time,
                       list(device.ComputedForce), device.StatusText)
        if keeper.Time == stop_at:
            scene.Stop()

    tag = player.AddObserver("AnimationCueTickEvent", between_pictures)
    for stop_at, come in ((3.0, [0.0, 1.0, 2.0, 3.0]), (None, [0.0, 1.0, 2.0, 3.0, 4.0])):
        scene.GoToFirst()
        live.check(live.poll(device, lambda: is_force(0.0)), "the wall is gone again", list(device.ComputedForce))
        seen.clear()
        scene.Play()
        live.check(seen == come, "it plays, to its end or where it is stopped", seen, stop_at)
        live.poll_for(device, 0.3)
        live.check(is_force(come[-1]), "and the force stays", list(device.ComputedForce), device.StatusText)
    player.RemoveObserver(tag)
    live.check("rror" not in device.StatusText, "nothing is wrong", device.StatusText)


def come_back():
    global scene, keeper, device
    scene.GoToFirst()
    state = live.FOLDER + "/time.pvsm"
    simple.SaveState(state)
    simple.ResetSession()
    live.check(simple.FindSource("HapticDevice1") is None, "nothing is left")
    simple.LoadState(state)
    device, scene, keeper = simple.FindSource("HapticDevice1"), simple.GetAnimationScene(), simple.GetTimeKeeper()
    device.UpdatePipeline()
    live.check(device.Running == 0 and keeper.Time == 0.0, "the state waits for its user, at its time", keeper.Time)
    live.check(list(keeper.TimestepValues) == [0.0, 1.0, 2.0, 3.0, 4.0], "with its time steps", keeper.TimestepValues)
    rest()
    for how, time in ((scene.GoToNext, 1.0), (scene.GoToNext, 2.0), (scene.GoToNext, 3.0), (scene.GoToPrevious, 2.0)):
        go(how, time)
    device.Running = 0


def check_steps(forces, resident):
    steps = [abs(b - a) for a, b, r in zip(forces, forces[1:], resident[1:]) if r == 1.0]
    # The wall takes at least 18 ticks for each millimetre.
    strongest, largest = builtins.max(forces), builtins.max(steps)
    live.check(strongest > 0.9 and largest < 0.1, "no step of the force", strongest, largest)


if REMOTE:
    with live.Server(2):
        live.load_plugin(remote=True)
        touch()
        play()
        device.Running = 0
        simple.Disconnect()
    log = live.read_log(live.FOLDER + "/time.csv")
    check_steps(log["Force z (N)"], log["Residency"])
else:
    from vtkmodules.util.numpy_support import vtk_to_numpy

    live.load_plugin()
    touch()
    play()
    device.Running = 0
    reader = simple.XMLPolyDataReader(FileName=[live.FOLDER + "/time.vtp"])
    ticks = servermanager.Fetch(reader).GetPointData()
    forces, times = (vtk_to_numpy(ticks.GetArray(name)) for name in ("Force", "DataTime"))
    wrong = builtins.max(abs(f[2] - expected(t)) for f, t in zip(forces, times))
    # Blending two edges that are one voxel apart has an error of 0.02 of their width.
    live.check(wrong < 0.02, "the force is that of where the wall is, in every tick", wrong)
    check_steps(list(forces[:, 2]), [1.0] * len(forces))
    come_back()
