# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A file is larger than memory: ParaView shows its coarse level, which is 0 everywhere here. Hand and path feel the
samples, which rise by 8 along x. By eq. 1 of the method Force field, the force is -8 times its gain everywhere.
"""
import json
import os
import shutil
import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import live

IS_REMOTE = sys.argv[3] == "Remote"
SIZE, GAIN, SLOPE = 48, 0.05, 8.0
FORCE = [-GAIN * SLOPE, 0.0, 0.0]


def write(folder):
    """Writes an OME-Zarr image of two levels in Zarr's version 2, uncompressed, after the format's specification."""
    shutil.rmtree(folder, ignore_errors=True)
    rising = numpy.broadcast_to(SLOPE * numpy.arange(SIZE), (SIZE, SIZE, SIZE))
    for level, samples in enumerate([rising, numpy.zeros((SIZE // 4,) * 3)]):
        n = len(samples) // 2
        os.makedirs(f"{folder}/{level}")
        head = {"zarr_format": 2, "shape": [2 * n] * 3, "chunks": [n] * 3, "dtype": "<i2", "compressor": None, "fill_value": 0,
                "order": "C", "filters": None}
        with open(f"{folder}/{level}/.zarray", "w") as file:
            json.dump(head, file)
        for chunk in numpy.ndindex(2, 2, 2):
            part = samples[tuple(slice(n * i, n * i + n) for i in chunk)]
            part.astype("<i2").tofile(f"{folder}/{level}/" + ".".join(map(str, chunk)))
    datasets = [{"path": "0", "coordinateTransformations": [{"type": "scale", "scale": [1, 1, 1]}]},
                {"path": "1", "coordinateTransformations": [{"type": "scale", "scale": [4, 4, 4]},
                                                            {"type": "translation", "translation": [1.5, 1.5, 1.5]}]}]
    axes = [{"name": name, "type": "space"} for name in "zyx"]
    with open(f"{folder}/.zgroup", "w") as file:
        json.dump({"zarr_format": 2}, file)
    with open(f"{folder}/.zattrs", "w") as file:
        json.dump({"multiscales": [{"version": "0.4", "axes": axes, "datasets": datasets}]}, file)


def write_raw(name):
    """Writes a MetaImage with its samples in a separate file, long along z, so that a region is only a part of the
    file."""
    size = (64, 64, 3000)
    samples = numpy.broadcast_to(SLOPE * numpy.arange(size[0]), size[::-1]).astype("<i2")
    samples.tofile(f"{name}.raw")
    with open(f"{name}.mhd", "w") as file:
        file.write(f"ObjectType = Image\nNDims = 3\nDimSize = {size[0]} {size[1]} {size[2]}\nElementType = MET_SHORT\n"
                   f"ElementByteOrderMSB = False\nElementSpacing = 1 1 1\nElementDataFile = {os.path.basename(name)}.raw\n")


def is_exact(force):
    return live.distance(force, FORCE) < 1e-9 * live.norm(FORCE)


def feel():
    live.load_plugin(IS_REMOTE)
    folder = os.path.join(live.FOLDER, "Rising.zarr")
    write(folder)
    volume = simple.OpenDataFile(folder)
    live.check(volume and volume.GetXMLName() == "HapticLargeFolder", "File > Open knows the folder", volume)
    volume.UpdatePipeline()
    shown = volume.GetDataInformation()
    live.check(shown.GetExtent() == (0, 11, 0, 11, 0, 11), "the coarse level is shown", shown.GetExtent())
    live.check(shown.GetPointDataInformation().GetArrayInformation(0).GetComponentRange(0) == (0.0, 0.0), "it is 0")
    settings = {"Method": "Force field", "ForceFieldGain": GAIN, "ForceFieldDamping": 0.0}
    path = simple.Line(Point1=[10, 20, 20], Point2=[30, 25, 22], Resolution=50)
    touch = simple.VolumeHaptics(Input=volume, Path=path, **settings)
    touch.UpdatePipeline()
    forces = vtk_to_numpy(servermanager.Fetch(touch).GetPointData().GetArray("Force"))
    # The first tick has no force, because no time has passed.
    live.check(len(forces) == 51 and all(is_exact(force) for force in forces[1:]), "the path feels the samples", forces)

    device = simple.HapticDevice(Touch=touch)
    live.press(device, [20, 20, 20], [25, 20, 22])
    live.check(live.poll(device, lambda: is_exact(device.ComputedForce)), "the hand feels the samples",
               list(device.ComputedForce), device.StatusText)
    if not IS_REMOTE:
        volume.FileName = os.path.join(live.FOLDER, "Missing.zarr")
        live.check(live.poll(device, lambda: "no image" in device.StatusText), "a missing file is told", device.StatusText)
        live.check(live.poll(device, lambda: live.norm(device.Force) == 0.0 and not device.Armed), "and fades",
                   list(device.Force), device.Armed)
        volume.FileName = folder
        live.check(live.poll(device, lambda: is_exact(device.ComputedForce)), "the file is felt again", device.StatusText)
        live.check(live.norm(device.Force) == 0.0, "but not before it is armed", list(device.Force))
        device.Armed = 1
        live.check(live.poll(device, lambda: live.distance(device.Force, FORCE) < 1e-9), "again", list(device.Force))
    device.Running = 0
    if not IS_REMOTE:
        feel_vanishing(settings)


def feel_vanishing(settings):
    """Feels the samples of a header, then deletes them: the rest is missing, which the status reports."""
    name = os.path.join(live.FOLDER, "Long")
    write_raw(name)
    touch = simple.VolumeHaptics(Input=simple.HapticLargeFile(FileName=f"{name}.mhd"), **settings)
    device = simple.HapticDevice(Touch=touch)
    live.press(device, [20, 20, 20], [25, 20, 22])
    live.check(live.poll(device, lambda: is_exact(device.ComputedForce)), "the hand feels the samples of a header",
               list(device.ComputedForce), device.StatusText)
    os.remove(f"{name}.raw")
    device.VirtualTip = [25, 20, 2900]
    live.check(live.poll(device, lambda: device.TipPosition[2] > 2899 and device.Residency < 1.0), "samples are missing",
               device.Residency, device.StatusText)
    live.check(live.poll(device, lambda: "can't be read from the file" in device.StatusText), "a deleted file is told",
               device.StatusText)
    live.check(live.poll(device, lambda: live.norm(device.Force) <= 0.5 * live.norm(FORCE) + 1e-9), "and fades",
               list(device.Force), device.StatusText)
    device.Running = 0


if IS_REMOTE:
    with live.Server(2):
        feel()
        simple.Disconnect()
else:
    feel()
