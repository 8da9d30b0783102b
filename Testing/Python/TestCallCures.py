# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures that error texts of single calls name (properties, setups, devices, tables, measurements): after the
cure, the call succeeds.
"""

import json
import math
import re

import numpy as np
import pytest
from TestCures import RAMP
from cure_bench import TOLD, Bench, Calls, line_to, told, try_calls
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from volumehaptics import (
    image,
    vtkHapticDevice,
    vtkHapticLabelTable,
    vtkHapticMeasurements,
    vtkHapticPathSource,
    vtkHapticProperty,
    vtkHapticSetup,
    vtkVolumeHapticsFilter,
)
from volumehaptics._touch import Errors

result = Calls()


@result(", or a file of WritePreset() that ends in .json", "Give WritePreset() the name of one", "Give ReadPreset() the name of one",
        "was written by vtkHapticProperty::WritePreset()", "Write the preset again",
        "Check that the folder exists, or choose another one", "Give the name of a file")
def presets(folder):
    feel, file = vtkHapticProperty(), str(folder / "own.json")
    with told(feel, ", or a file of WritePreset() that ends in .json"):
        assert not feel.ApplyPreset("bones")
    assert feel.ApplyPreset("MRI")
    with told(feel, "Give WritePreset() the name of one"):
        assert not feel.WritePreset("")
    with told(feel, "Check that the folder exists, or choose another one"):
        assert not feel.WritePreset(str(folder / "none" / "own.json"))
    with told(feel, "Give the name of a file"):
        assert not feel.WritePreset(str(folder))
    assert feel.WritePreset(file)
    read = vtkHapticProperty()
    with told(read, "Give ReadPreset() the name of one"):
        assert not read.ReadPreset("")
    with told(read, "was written by vtkHapticProperty::WritePreset()"):
        assert not read.ReadPreset(str(folder / "none.json"))
    assert read.ReadPreset(file)
    assert read.GetStiffness().GetValue(500.0) == feel.GetStiffness().GetValue(500.0) > 0.0
    broken = json.loads((folder / "own.json").read_text())
    for name in list(broken):
        if isinstance(broken[name], (dict, list)):
            del broken[name]
    (folder / "own.json").write_text(json.dumps(broken))
    with told(read, "Write the preset again"):
        assert not read.ReadPreset(file)
    assert feel.WritePreset(file) and read.ReadPreset(file)


@result("Give two numbers, the lower one first", "Give it others, or remove all tissues first")
def tissues(_):
    feel = vtkHapticProperty()
    with told(feel, "Give two numbers, the lower one first"):
        assert feel.AddTissue("bone", 3000.0, 300.0) == -1
    assert feel.AddTissue("bone", 300.0, 3000.0) == 0
    with told(feel, "Give it others, or remove all tissues first"):
        assert feel.AddTissue("skull", 400.0, 500.0) == -1
    assert feel.AddTissue("skull", 3100.0, 3200.0) == 1
    feel.RemoveAllTissues()
    assert feel.AddTissue("skull", 400.0, 500.0) == 0


@result("Take one of ")
def methods(_):
    haptics = vtkVolumeHapticsFilter()
    with told(haptics, "Take one of "):
        assert not haptics.SetMethodByName("feel")
    assert haptics.SetMethodByName("surface-proxy") and haptics.GetMethod() == haptics.SURFACE_PROXY


@result("Give Save the name of one", "Give Load the name of one", "was saved by vtkHapticSetup and may be read by you",
        "Correct it, or remove this key to leave the setting as it is")
def setups(folder):
    setup, haptics, file = vtkHapticSetup(), vtkVolumeHapticsFilter(), folder / "setup.json"
    setup.SetVolumeHaptics(haptics)
    haptics.SetKernelRadius(3)
    with told(setup, "Give Save the name of one"):
        assert not setup.Save("")
    assert setup.Save(str(file))
    with told(setup, "Give Load the name of one"):
        assert not setup.Load("")
    with told(setup, "was saved by vtkHapticSetup and may be read by you"):
        assert not setup.Load(str(folder / "none.json"))
    text = file.read_text()
    file.write_text(re.sub(r'"KernelRadius"( *): 3', r'"KernelRadius"\1: "wide"', text))
    with told(setup, "Correct it, or remove this key to leave the setting as it is"):
        assert not setup.Load(str(file))
    haptics.SetKernelRadius(2)
    file.write_text(re.sub(r'"KernelRadius"( *): 3,?', "", text))
    assert setup.Load(str(file)) and haptics.GetKernelRadius() == 2
    file.write_text(text)
    assert setup.Load(str(file)) and haptics.GetKernelRadius() == 3


@result("Set it to three numbers", "Move one of them", "or lower PointsPerSecond")
def planned_paths(_):
    def ends(source):
        source.Update()
        return source.GetOutput().GetPoint(source.GetOutput().GetNumberOfPoints() - 1)

    source = vtkHapticPathSource()
    source.SetPathTypeToLine() if hasattr(source, "SetPathTypeToLine") else source.SetShapeToLine()
    source.SetPoint2(math.nan, 0.0, 0.0)
    with told(source, "Set it to three numbers", source.GetExecutive()):
        source.Update()
    source.SetPoint1(0.0, 0.0, 0.0)
    source.SetPoint2(0.0, 0.0, 0.0)
    with told(source, "Move one of them", source.GetExecutive()):
        source.Update()
    source.SetPoint2(0.0, 0.0, 9.0)
    assert ends(source) == pytest.approx((0.0, 0.0, 9.0))
    source.SetPointsPerSecond(1e5)
    source.SetSpeed(1e-6)
    with told(source, "or lower PointsPerSecond", source.GetExecutive()):
        source.Update()
    source.SetSpeed(50.0)
    assert ends(source) == pytest.approx((0.0, 0.0, 9.0))


@result('for example with Open("virtual")', "Give an id that EnumerateDevices() lists", "with N counting from 0",
        "There is nothing to record: Start() the servo first", "has an unknown extension: name it .vtp or .csv",
        "No recording is under way: Start() the recorder first", "A recording is under way: Stop() it first",
        'to lead: Open("virtual") first',
        "give the name of an unfinished recording, FILE.part", "Build it from such transforms only")
def devices(folder):
    device = vtkHapticDevice()
    with told(device, 'for example with Open("virtual")'):
        assert not device.Start()
    with told(device, 'to lead: Open("virtual") first'):
        device.GetVirtualHand().SetPosition(1.0, 2.0, 3.0)
    with told(device, "Give an id that EnumerateDevices() lists"):
        assert not device.Open("pen")
    with told(device, "with N counting from 0"):
        assert not device.Open("falcon:first")
    assert device.Open("virtual")
    with told(device, "There is nothing to record: Start() the servo first"):
        assert not device.GetRecorder().Start(str(folder / "touch.vtp"))
    bench = Bench()
    device.SetVolumeHaptics(bench.haptics)
    device.SetAttentionTime(0.0)
    assert device.Start()
    with told(device, "has an unknown extension: name it .vtp or .csv"):
        assert not device.GetRecorder().Start(str(folder / "touch.vtk"))
    with told(device, "No recording is under way: Start() the recorder first"):
        assert not device.GetRecorder().Stop()
    assert device.GetRecorder().Start(str(folder / "touch.vtp"))
    with told(device, "A recording is under way: Stop() it first"):
        assert not device.GetRecorder().Start(str(folder / "again.vtp"))
    device.GetVirtualHand().SetPosition(5.0, 8.0, 9.0)
    device.UpdateState()
    tick = device.GetState().GetTick()
    while device.GetState().GetTick() < tick + 50:
        device.UpdateState()
    assert device.GetState().GetTipPosition() == pytest.approx((5.0, 8.0, 9.0), abs=0.5)
    assert device.GetRecorder().Stop() and (folder / "touch.vtp").stat().st_size > 0
    device.Stop()
    with told(device, "give the name of an unfinished recording, FILE.part"):
        assert not device.GetRecorder().Recover("", str(folder / "found.vtp"))
    matrix = vtkMatrix4x4()
    matrix.SetElement(0, 0, 2.0)
    device.SetDeviceToWorld(matrix)
    with told(bench.haptics, "Build it from such transforms only"):
        assert not device.Publish()
    for axis in range(3):
        matrix.SetElement(axis, axis, 2.0)
    device.SetDeviceToWorld(matrix)
    assert device.Publish()


@result("can't be …. Give 0 or more", "Give red, green and blue from 0 to 1",
        "Give 0 or more (world units)")
def label_tables(_):
    labels = vtkHapticLabelTable()
    with Errors(labels) as errors:
        labels.SetStiffness(1, -1.0)
    assert len(errors) == 1 and "can't be -1. Give 0 or more" in errors[0], errors
    TOLD.add("can't be …. Give 0 or more")
    labels.SetStiffness(1, 300.0)
    assert labels.HasMaterial(1)
    labels.RemoveMaterial(1)
    assert not labels.HasMaterial(1)
    with told(labels, "Give red, green and blue from 0 to 1"):
        labels.SetColor(1, 255.0, 0.0, 0.0)
    labels.SetColor(1, 1.0, 0.0, 0.0)
    assert labels.HasColor(1)
    with told(labels, "Give 0 or more (world units)"):
        labels.SetStandOff(-1.0)
    labels.SetStandOff(2.0)
    assert labels.GetStandOff() == 2.0


@result("use POINT (0) to AREA (4)", "There is no shape to measure: give a vtkPolyData", "Choose a name that ends in .csv, .vtp or .mrk.json",
        "Choose a file that exists and may be read by you", "Name them there", "Write a number",
        "Close it, or check that the file is complete", "Write Point, Distance, Angle, Path or Area",
        "Choose a file that 3D Slicer, or this software, saved as .mrk.json", "it is not a complete .vtp file. Write it again",
        'Write "LPS" or "RAS"', 'Write "mm" or "um"', "Save the markups again", "Write the coordinates there")
def measurements(folder):
    measured = vtkHapticMeasurements()
    measured.AddDistance((0, 0, 0), (0, 3, 4))
    with told(measured, "use POINT (0) to AREA (4)"):
        assert measured.AddMeasurement(7, vtkPolyData()) == -1
    with told(measured, "There is no shape to measure: give a vtkPolyData"):
        assert measured.AddMeasurement(measured.PATH, None) == -1
    assert measured.AddMeasurement(measured.PATH, line_to(3.0)) == 1
    with told(measured, "Choose a name that ends in .csv, .vtp or .mrk.json"):
        assert not measured.WriteFile(str(folder / "list.txt"))
    for name in ("list.csv", "list.vtp", "list.mrk.json"):
        assert measured.WriteFile(str(folder / name))

    def refuses(name, old, new, word):
        good = (folder / name).read_text()
        assert re.search(old, good), old
        (folder / name).write_text(re.sub(old, new, good, count=1))
        with told(read, word):
            assert not read.ReadFile(str(folder / name))
        (folder / name).write_text(good)
        assert read.ReadFile(str(folder / name)) and read.GetNumberOfMeasurements() == 2
        assert read.GetValue(0) == pytest.approx(5.0)

    read = vtkHapticMeasurements()
    with told(read, "Choose a file that exists and may be read by you"):
        assert not read.ReadFile(str(folder / "none.csv"))
    refuses("list.csv", ",x,y,z,", ",u,v,w,", "Name them there")
    refuses("list.csv", ",3,4,", ",three,4,", "Write a number")
    refuses("list.csv", ",Distance,", ",Length,", "Write Point, Distance, Angle, Path or Area")
    refuses("list.csv", r"\n1,", '\n1,"', "Close it, or check that the file is complete")
    refuses("list.mrk.json", '"@schema"', '"schema"', "Choose a file that 3D Slicer, or this software, saved as .mrk.json")
    refuses("list.mrk.json", '"coordinateSystem" *: *"...?"', '"coordinateSystem": "XYZ"', 'Write "LPS" or "RAS"')
    refuses("list.mrk.json", '"coordinateUnits" *: *"[^"]*"', '"coordinateUnits": "inch"', 'Write "mm" or "um"')
    refuses("list.mrk.json", '"type" *:', '"kind":', "Save the markups again")
    refuses("list.mrk.json", r'"position" *: *\[[^]]*\]', '"position": [1, 2]', "Write the coordinates there")
    good = (folder / "list.vtp").read_bytes()
    (folder / "list.vtp").write_bytes(good[:len(good) // 2])
    with told(read, "it is not a complete .vtp file. Write it again"):
        assert not read.ReadFile(str(folder / "list.vtp"))
    assert measured.WriteFile(str(folder / "list.vtp")) and read.ReadFile(str(folder / "list.vtp"))


@result("pass a vtkImageData", "pass a vtkImageData, or call ApplyPreset(name)", "choose an array with GetPointData()->SetActiveScalars(name)",
        "there are no edges to propose functions from. Use another array or component", "points along every axis, or set the functions by hand",
        "has no finite value. Use another array or component")
def proposals(_):
    feel, step = vtkHapticProperty(), np.where(RAMP < 1550.0, 0.0, 1000.0)
    with told(feel, "pass a vtkImageData"):
        assert not feel.ProposeFromImage(None)
    volume = image(step)
    name = volume.GetPointData().GetScalars().GetName()
    volume.GetPointData().SetActiveScalars(None)
    with told(feel, "choose an array with GetPointData()->SetActiveScalars(name)"):
        assert not feel.ProposeFromImage(volume)
    with told(feel, "choose an array with GetPointData()->SetActiveScalars(name)"):
        assert not feel.ApplyPreset("MRI", volume)
    with told(feel, "pass a vtkImageData, or call ApplyPreset(name)"):
        assert not feel.ApplyPreset("MRI", None)
    volume.GetPointData().SetActiveScalars(name)
    assert feel.ApplyPreset("MRI") and feel.ApplyPreset("MRI", volume)
    assert feel.ProposeFromImage(volume)
    assert feel.GetStiffness().GetValue(1000.0) > 0.0
    for wrong, word in (
            (np.full(RAMP.shape, 7.0), "there are no edges to propose functions from. Use another array or component"),
            (np.full(RAMP.shape, math.nan), "has no finite value. Use another array or component"),
            (step[:, :3, :].copy(), "points along every axis, or set the functions by hand")):
        with told(feel, word):
            assert not feel.ProposeFromImage(image(wrong))
        assert feel.ProposeFromImage(image(step))


@result("Touch three or more different ones", "Touch a point well off the line", "three or more are needed. Touch more", "Touch again, while the device is ready", "Give each touched point its known position")
def calibrations(_):
    """Calibrations of a device whose axes are the world's, in metres instead of millimetres."""
    fit = vtkHapticDevice()

    def add(*points):
        touched, known = vtkPoints(), vtkPoints()
        for x in points:
            touched.InsertNextPoint([0.001 * one for one in x])
            known.InsertNextPoint(x)
        return fit.FitDeviceToWorld(touched, known) >= 0.0

    with told(fit, "Give each touched point its known position"):
        known = vtkPoints()
        known.InsertNextPoint(1.0, 2.0, 3.0)
        assert fit.FitDeviceToWorld(None, known) == -1.0

    with told(fit, "three or more are needed. Touch more"):
        assert not add((0, 0, 0), (50, 0, 0))
    with told(fit, "Touch three or more different ones"):
        assert not add((1, 2, 3), (1, 2, 3), (1, 2, 3))
    with told(fit, "Touch a point well off the line"):
        assert not add((0, 0, 0), (50, 0, 0), (100, 0, 0))
    with told(fit, "Touch again, while the device is ready"):
        assert not add((0, 0, 0), (50, 0, 0), (math.inf, 0, 0))
    assert add((0, 0, 0), (50, 0, 0), (0, 50, 0))
    assert fit.GetDeviceToWorld().GetElement(0, 0) == pytest.approx(1000.0)


@pytest.mark.parametrize("words", result)
def test_cures_of_calls(words, tmp_path):
    try_calls(words, result[words], tmp_path)
