# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests in ParaView: the plugin, and traces as arrays.

Every test is `pvbatch TestNAME.py PLUGIN REFERENCE_FOLDER SOURCE_FOLDER OUTPUT_FOLDER`, and ends with an exception if
something is wrong.
"""

import json
import os
import sys

import numpy
from paraview import servermanager, simple
from paraview.modules.vtkRemotingCore import vtkProcessModule
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

PLUGIN, REFERENCE, SOURCE, OUTPUT = sys.argv[1:5]
simple.LoadPlugin(PLUGIN, remote=False, ns=globals())
os.makedirs(OUTPUT, exist_ok=True)


def is_first_rank():
    return vtkProcessModule.GetProcessModule().GetPartitionId() == 0


def classes():
    """Returns the classes as reference.py describes them."""
    with open(os.path.join(REFERENCE, "classes.json"), encoding="utf-8") as file:
        return json.load(file)


def read(name):
    """Returns a pipeline source for a .vti or .vtp of the reference folder."""
    file = os.path.join(REFERENCE, name)
    reader = simple.XMLImageDataReader if name.endswith(".vti") else simple.XMLPolyDataReader
    source = reader(FileName=[file])
    source.UpdatePipeline()
    return source


def produce(data):
    """Returns a pipeline source of data that a test has made."""
    source = simple.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def report_of(action):
    """Returns what ParaView reports during an action."""
    log, console = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(log)
    action()
    vtkOutputWindow.SetInstance(console)
    return log.GetOutput()


def report_of_update(source, time=None, **settings):
    """Returns what ParaView reports when a source is set and updated."""
    def update():
        for name, value in settings.items():
            setattr(source, name, value)
        source.UpdatePipeline() if time is None else source.UpdatePipeline(time)

    return report_of(update)


def expect(touch, *words, **settings):
    """Expects that an update with these settings reports all the words and has an empty output; without words, that it
    reports nothing."""
    text = report_of_update(touch, **settings)
    for word in words:
        assert word in text, f"{word} is not in: {text}"
    assert words or "ERROR" not in text, text
    if words:
        assert touch.GetDataInformation().GetNumberOfPoints() == 0


def arrays_of(proxy):
    """Returns all point arrays of a trace, and its points as "Proxy"."""
    proxy.UpdatePipeline()
    trace = servermanager.Fetch(proxy)
    data = trace.GetPointData()
    arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    if trace.GetPoints():
        arrays["Proxy"] = vtk_to_numpy(trace.GetPoints().GetData())
    return {name: numpy.array(array) for name, array in arrays.items()}


def assert_same(arrays, expected, what):
    """Expects arrays that are equal to the bit, so that two NaN are equal."""
    assert sorted(arrays) == sorted(expected), f"{what}: arrays {sorted(arrays)}, not {sorted(expected)}"
    for name, array in arrays.items():
        wanted = expected[name]
        assert array.dtype == wanted.dtype and array.shape == wanted.shape, (
            f"{what}: {name} is {array.dtype} {array.shape}, not {wanted.dtype} {wanted.shape}")
        if array.tobytes() != wanted.tobytes():
            tick = int(numpy.argmax((array != wanted).reshape(len(array), -1).any(axis=1)))
            raise AssertionError(f"{what}: {name} is {array[tick]} instead of {wanted[tick]} in tick {tick}")


def touch(name, **settings):
    """Returns the filter on a scene of scenes.py, with preset and isovalue left out."""
    volume, path = read(name + ".vti"), read(name + "Path.vtp")
    simple.SetActiveSource(volume)  # ParaView takes the active source's arrays for granted
    return VolumeHaptics(Input=volume, Path=path, **settings)  # noqa: F821, from the plugin


def head(**settings):
    """Returns the filter on the head phantom, stroked as in scenes.py, with the preset for CT."""
    return touch("Head", **{"Preset": "CT contrast", **settings})
