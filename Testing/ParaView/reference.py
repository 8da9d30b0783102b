#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the results of the VTK build, to be compared with those of ParaView's filter.

    reference.py FOLDER PHANTOM [HEAD_CT.mhd]

Writes to FOLDER the volumes and paths of scenes.py, the traces of every method (SCENE-METHOD.npz: the point arrays, and
the points as "Proxy"), and classes.json: the setters of the filter and its property, and the presets.
"""

import json
import os
import shutil
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkMetaImageReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from volumehaptics import (
    vtkHapticPathSource, vtkHapticProperty, vtkVolumeHapticsFilter)

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from scenes import METHODS, SCENES  # noqa: E402

FUNCTIONS = ("Stiffness", "Friction", "Viscosity", "SurfaceStrength", "Distinctness")


def write_volume(source, file):
    writer = vtkXMLImageDataWriter()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(file)
    writer.SetDataModeToBinary()
    assert writer.Write(), file


def write_path(points, file):
    path = vtkPolyData()
    path.SetPoints(vtkPoints())
    path.GetPoints().SetDataTypeToDouble()
    for point in points:
        path.GetPoints().InsertNextPoint(point)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(path)
    writer.SetFileName(file)
    writer.SetDataModeToBinary()
    assert writer.Write(), file
    return path


def arrays_of(trace):
    data = trace.GetPointData()
    arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    arrays["Proxy"] = vtk_to_numpy(trace.GetPoints().GetData())
    return arrays


def touch(scene, volume, path, settings):
    haptics = vtkVolumeHapticsFilter()
    haptics.SetInputConnection(volume.GetOutputPort())
    haptics.SetPathData(path)
    haptics.SetIsoValue(scene.iso_value)
    if scene.preset != "Custom":
        haptics.GetProperty().ApplyPreset(scene.preset)
    for name, value in settings.items():
        getattr(haptics, "Set" + name)(value)
    haptics.Update()
    assert haptics.GetOutput().GetNumberOfPoints() > 0
    return arrays_of(haptics.GetOutput())


def setters(cls, ancestor):
    """Returns the settings of a class that its ancestor lacks. Of choices that also have a method for each name or a
    status, only the main setter counts."""
    names = [name[3:] for name in dir(cls) if name.startswith("Set") and not hasattr(ancestor, name)]
    names = [name for name in names if not name.endswith("Status")]
    return sorted(name for name in names if not any(name.startswith(other + "To") for other in names))


def describe_classes(head):
    """Returns the settings, and the presets as they are fitted to an image."""
    presets = {}
    for i in range(vtkHapticProperty.GetPresetNames().GetNumberOfValues()):
        material = vtkHapticProperty()
        name = vtkHapticProperty.GetPresetNames().GetValue(i)
        material.ApplyPreset(name, head)
        presets[name] = {"SurfaceSide": material.GetSurfaceSide()}
        for function in FUNCTIONS:
            nodes, node = [], [0.0] * 4
            for k in range(getattr(material, "Get" + function)().GetSize()):
                getattr(material, "Get" + function)().GetNodeValue(k, node)
                nodes += node
            presets[name][function] = nodes
    fresh = {"Algorithm": vtkVolumeHapticsFilter(), "Property": vtkHapticProperty()}
    algorithm = setters(vtkVolumeHapticsFilter, vtkVolumeHapticsFilter.__bases__[0])
    # Skip the setters that begin with Tissue, because tissues come from presets and their files.
    material = [
        name for name in setters(vtkHapticProperty, vtkHapticProperty.__bases__[0]) if not name.startswith("Tissue")]
    defaults = {}
    for names, made in ((algorithm, fresh["Algorithm"]), (material, fresh["Property"])):
        for name in names:
            value = getattr(made, "Get" + name)() if hasattr(made, "Get" + name) else None
            if isinstance(value, (bool, int, float)):
                defaults[name] = value
    path = setters(vtkHapticPathSource, vtkHapticPathSource.__bases__[0])
    return {"Algorithm": algorithm, "Property": material, "Path": path, "Defaults": defaults, "Presets": presets}


def main(folder, phantom, head_ct=None):
    os.makedirs(folder, exist_ok=True)
    write_volume(vtkRTAnalyticSource(), os.path.join(folder, "Wavelet.vti"))
    shutil.copy(phantom, os.path.join(folder, "Head.vti"))
    if head_ct:
        reader = vtkMetaImageReader()
        reader.SetFileName(head_ct)
        write_volume(reader, os.path.join(folder, "CT.vti"))
    for name, scene in SCENES.items():
        if name == "CT" and not head_ct:
            continue
        volume = vtkXMLImageDataReader()
        volume.SetFileName(os.path.join(folder, name + ".vti"))
        path = write_path(scene.path(), os.path.join(folder, name + "Path.vtp"))
        for method, settings in METHODS.items():
            numpy.savez(os.path.join(folder, f"{name}-{method}.npz"), **touch(scene, volume, path, settings))
    head = vtkXMLImageDataReader()
    head.SetFileName(phantom)
    head.Update()
    with open(os.path.join(folder, "classes.json"), "w", encoding="utf-8") as file:
        json.dump(describe_classes(head.GetOutput()), file, indent=1)


if __name__ == "__main__":
    main(*sys.argv[1:])
