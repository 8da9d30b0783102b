# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures of errors about files of labels, setups, recordings and measurements, and about data made from
them."""

import gzip
import math
import re
import struct

import numpy as np
import pytest
from TestCures import RAMP
from cure_bench import TOLD, Bench, Calls, line_to, told, try_calls
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkFieldData, vtkImageData, vtkPolyData, vtkTable
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataReader
from volumehaptics import (
    image,
    vtkHapticBurr,
    vtkHapticDevice,
    vtkHapticTimeStepSource,
    vtkHapticVolumeReader,
    vtkHapticFunctionEditor,
    vtkHapticHeadUpDisplay,
    vtkHapticLabelTable,
    vtkHapticMeasurements,
    vtkHapticNeedle,
    vtkHapticPathSource,
    vtkHapticProperty,
    vtkHapticRemoval,
    vtkHapticSetup,
    vtkVolumeHapticsFilter,
)
from volumehaptics._touch import Errors
from volumehaptics.arrays import arrays

result = Calls()

# Refused label tables, words of the remedy, and a function that corrects each table: material 1, "bone", of 800 N/m.

NRRD = ("NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\n"
        "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\nspace origin: (0,0,0)\n")
SEGMENT = "Segment0_LabelValue:=1\nSegment0_Name:=bone\n"
CSV = "label,name,stiffness\n1,bone,800\n"


def nifti(table):
    """Returns a file as nifti1.h defines it, with the names in an extension, as TotalSegmentator writes them."""
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, 2, 2, 2, 1, 1, 1, 1)
    struct.pack_into("<hh", header, 70, 2, 8)
    xml = ('<?xml version="1.0" encoding="UTF-8"?><CaretExtension><VolumeInformation Index="0"><LabelTable>'
           f'<Label Key="1">{table}</LabelTable></VolumeInformation></CaretExtension>').encode()
    size = (len(xml) + 8 + 15) // 16 * 16
    struct.pack_into("<f", header, 108, 352.0 + size)
    header[344:349] = b"n+1\0\1"
    return bytes(header) + struct.pack("<ii", size, 30) + xml.ljust(size - 8, b"\0") + bytes(8)


LONG = gzip.compress(CSV.encode() + b"".join(b"%d,n%d,%d\n" % (i, i * i, i % 97) for i in range(2, 9000)))
DAMAGED = LONG[:len(LONG) // 2] + b"\xff" * 40 + LONG[len(LONG) // 2 + 40:]
TABLES = {
    "Correct the line, or begin it with # to leave it out": ("a.ctbl", b"1 bone 300 0 0 255\n", (b"1 bone 255 0 0 255\n", )),
    ", or leave the cell empty": ("a.csv", b"label,stiffness\n1,hard\n", (CSV.encode(), b"label,stiffness\n1,\n")),
    "Write a whole number in its column": ("a.csv", b"label,name\n,bone\n", (CSV.encode(), )),
    "or from 0 to 255, or leave the cells empty":
        ("a.csv", b"label,red,green,blue\n1,300,0,0\n",
         (b"label,red,green,blue\n1,1,0,0\n", b"label,red,green,blue\n1,255,0,0\n", b"label,red,green,blue\n1,,,\n")),
    "). Check that the file is complete": ("a.csv.gz", DAMAGED, (LONG, )),
    "Save it as UTF-8": ("a.csv", CSV.encode("utf-16"), (CSV.encode("utf-8"), )),
    "can't be used: …. Save the segmentation again":
        ("a.seg.nrrd", f"{NRRD}Segment0_LabelValue:=one\n\n".encode(), (f"{NRRD}{SEGMENT}\n".encode(), )),
    "its NRRD header has no end. Check that the file is complete":
        ("a.seg.nrrd", f"{NRRD}{SEGMENT}"[:200].encode(), (f"{NRRD}{SEGMENT}\n".encode(), )),
    "Save it as a segmentation (.seg.nrrd), or give the names in a table of their own":
        ("a.nrrd", f"{NRRD}\n".encode(), (f"{NRRD}{SEGMENT}\n".encode(), CSV.encode())),
    "Save the file again, or give the names in a table of their own":
        ("a.nii", nifti("bone"), (nifti("bone</Label>"), CSV.encode())),
}


@pytest.mark.parametrize("words", TABLES)
def test_cures_of_tables(words, tmp_path):
    name, wrong, cures = TABLES[words]
    table = vtkHapticLabelTable()
    (tmp_path / name).write_bytes(wrong)
    with Errors(table) as errors:
        assert not table.ReadFile(str(tmp_path / name))
    said = re.sub(r"can't be used: .*(?=\. Save the seg)", "can't be used: …", errors[0])
    assert len(errors) == 1 and words in said, errors
    for right in cures:
        (tmp_path / name).write_bytes(right)
        assert vtkHapticLabelTable().ReadFile(str(tmp_path / name))
    if b"#" not in wrong and "begin it with #" in words:
        (tmp_path / name).write_bytes(b"# " + wrong + b"2 skin 255 0 0 255\n")
        assert table.ReadFile(str(tmp_path / name)) and not table.HasColor(1) and table.HasColor(2)


@pytest.mark.parametrize("lost", (1, 8, 9, 300, len(LONG) // 2))
def test_a_table_that_is_cut_off_is_refused(lost, tmp_path):
    """Cuts off the end of the compressed file (8 bytes, RFC 1952), or lines of its text. The table takes nothing from
    such a file."""
    table, file = vtkHapticLabelTable(), tmp_path / "a.csv.gz"
    file.write_bytes(LONG[:-lost])
    with Errors(table) as errors:
        assert not table.ReadFile(str(file))
    assert len(errors) == 1 and "Check that the file is complete" in errors[0] and str(file) in errors[0], errors
    assert table.GetNumberOfLabels() == 0
    file.write_bytes(LONG)
    assert table.ReadFile(str(file)) and table.GetNumberOfLabels() == 8999 and table.GetStiffness(1) == 800.0


@result(". Check its name.", "Write the table with WriteFieldData()", "tuples of …. Give one of … for each of the", "Give 0 or more, or -1 to leave it unset", "Save an image with the table",
        "it is damaged. Check that the file is complete")
def field_data(folder):
    table, read, data, short = vtkHapticLabelTable(), vtkHapticLabelTable(), vtkFieldData(), vtkFieldData()
    for label in (1, 2):
        table.SetStiffness(label, 800.0)
    with told(read, "Write the table with WriteFieldData()"):
        assert not read.ReadFieldData(data)
    table.WriteFieldData(data)
    assert read.ReadFieldData(data) and read.GetStiffness(1) == 800.0
    short.DeepCopy(data)
    short.GetArray("LabelStiffness").SetNumberOfTuples(1)
    with Errors(read) as errors:
        assert not read.ReadFieldData(short)
    assert len(errors) == 1 and re.search(r"tuples of \d+. Give one of \d+ for each of the", errors[0]), errors
    TOLD.add("tuples of …. Give one of … for each of the")
    short.GetArray("LabelStiffness").InsertNextValue(700.0)
    assert read.ReadFieldData(short) and read.GetStiffness(2) == 700.0
    short.GetArray("LabelStiffness").SetValue(1, -5.0)
    with told(read, "Give 0 or more, or -1 to leave it unset"):
        assert not read.ReadFieldData(short)
    short.GetArray("LabelStiffness").SetValue(1, -1.0)
    assert read.ReadFieldData(short)
    file, volume, writer = folder / "a.vti", vtkImageData(), vtkXMLImageDataWriter()
    with told(read, ". Check its name."):
        assert not read.ReadFile(str(file))
    file.write_text('<?xml version="1.0"?>\n<VTKFile type="PolyData">\n')
    with told(read, "Save an image with the table"):
        assert not read.ReadFile(str(file))
    volume.DeepCopy(image(RAMP))
    table.WriteFieldData(volume.GetFieldData())
    writer.SetInputData(volume)
    writer.SetFileName(str(file))
    writer.Write()
    good = file.read_bytes()
    assert vtkHapticLabelTable().ReadFile(str(file))
    file.write_bytes(good[:len(good) // 2])
    with told(read, "it is damaged. Check that the file is complete"):
        assert not read.ReadFile(str(file))
    file.write_bytes(good)
    assert vtkHapticLabelTable().ReadFile(str(file))


@result("Give a .seg.nrrd of 3D Slicer; VTK reads other label images",
        "it has fewer samples than its header says. Check that the file is complete",
        ". Save it again in 3D Slicer as one file, .seg.nrrd, of a binary labelmap")
def segmentations(folder):
    reader, file = vtkHapticVolumeReader(), folder / "a.seg.nrrd"
    reader.AsLabelsOn()
    good = f"{NRRD}{SEGMENT}\n".encode() + bytes([0, 1] * 4)

    def refuses(word, bytes_now):
        file.write_bytes(bytes_now)
        reader.SetFileName(str(file))
        reader.Modified()
        with told(reader, word, reader.GetExecutive()):
            reader.Update()

    def reads():
        file.write_bytes(good)
        reader.SetFileName(str(file))
        reader.Modified()
        reader.Update()
        assert list(vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())) == [0, 1] * 4
        assert reader.GetLabelTable().GetLabelName(1) == "bone"

    reads()
    for word, wrong in (
            ("Give a .seg.nrrd of 3D Slicer; VTK reads other label images", b"P5 no NRRD"),
            ("it has fewer samples than its header says. Check that the file is complete", good[:-3]),
            (". Save it again in 3D Slicer as one file, .seg.nrrd, of a binary labelmap", good.replace(b"raw", b"hex"))):
        refuses(word, wrong)
        reads()


# -- setups and presets --

@result("that vtkHapticProperty::WritePreset() wrote", '". Choose a file ', "Correct this function first",
        "Correct it, or write the preset again", "the system says: ", "that vtkHapticSetup saved", "Correct this setting first",
        "Save the many labels with vtkHapticLabelTable::WriteFile()")
def setups(folder):
    feel, file = vtkHapticProperty(), folder / "own.json"
    feel.GetStiffness().AddPoint(0.0, -1.0)
    with told(feel, "Correct this function first"):
        assert not feel.WritePreset(str(file))
    feel.GetStiffness().RemoveAllPoints()
    feel.GetStiffness().AddPoint(0.0, 700.0)
    with told(feel, "the system says: "):
        assert not feel.WritePreset(str(folder / ("n" * 300 + ".json")))
    assert feel.WritePreset(str(file))
    good, read = file.read_text(), vtkHapticProperty()
    for word, wrong in ((("that vtkHapticProperty::WritePreset() wrote", '". Choose a file '), '{"Format": "other"}'),
                        (("Correct it, or write the preset again", ), re.sub(r"\[ *[\d.]+", '["x"', good, count=1))):
        file.write_text(wrong)
        with told(read, word[0]):
            assert not read.ReadPreset(str(file))
        TOLD.update(word)
        assert feel.WritePreset(str(file)) and read.ReadPreset(str(file))
        assert read.GetStiffness().GetValue(0.0) == 700.0
    setup, haptics = vtkHapticSetup(), vtkVolumeHapticsFilter()
    setup.SetVolumeHaptics(haptics)
    file.write_text('{"Format": "other"}')
    with told(setup, "that vtkHapticSetup saved"):
        assert not setup.Load(str(file))
    haptics.SetForceFieldGain(math.nan)
    with told(setup, "Correct this setting first"):
        assert not setup.Save(str(file))
    haptics.SetForceFieldGain(0.5)
    assert setup.Save(str(file)) and setup.Load(str(file)) and haptics.GetForceFieldGain() == 0.5
    many = vtkHapticLabelTable()
    for label in range(70000):
        many.SetLabelName(label, "n" * 200)
    haptics.SetLabelTable(many)
    with told(setup, "Save the many labels with vtkHapticLabelTable::WriteFile()"):
        assert not setup.Save(str(file))
    assert many.WriteFile(str(folder / "many.csv"))
    haptics.SetLabelTable(None)
    assert setup.Save(str(file)) and setup.Load(str(file))
    table = vtkHapticLabelTable()
    assert table.ReadFile(str(folder / "many.csv")) and table.GetNumberOfLabels() == 70000


# Recordings.

def recorder():
    device, bench = vtkHapticDevice(), Bench()
    device.SetVolumeHaptics(bench.haptics)
    device.SetAttentionTime(0.0)
    assert device.Open("virtual") and device.Start()
    device.bench = bench
    return device


def wait(device, ticks=300):
    tick = device.GetState().GetTick()
    while device.GetState().GetTick() < tick + ticks:
        device.UpdateState()


@result("is of a recording that is still under way: stop that one first", "Remove some, or give another name",
        "make a recording of it with vtkHapticRecorder::Recover, or remove it", ". Remove that, or give another name",
        "it is being recorded already. Give another name", "Record again with vtkHapticRecorder::Start, or give another file", "Give another FileName")
def recordings(folder):
    device, other = recorder(), recorder()
    file = folder / "a.vtp"
    part = folder / "a.vtp.part"
    assert device.GetRecorder().Start(str(file))
    wait(device)
    with told(device, "is of a recording that is still under way: stop that one first"):
        assert not device.GetRecorder().Recover(str(part), str(folder / "b.vtp"))
    with told(other, "it is being recorded already. Give another name"):
        assert not other.GetRecorder().Start(str(file))
    assert other.GetRecorder().Start(str(folder / "other.vtp")) and other.GetRecorder().Stop()
    left = part.read_bytes()
    assert device.GetRecorder().Stop() and file.stat().st_size > 0
    assert len(left) > 0
    # Start() must warn about a partial file that a program left behind.
    part.write_bytes(left)
    with Errors(device, event="WarningEvent") as warnings:
        assert device.GetRecorder().Start(str(file))
    word = "make a recording of it with vtkHapticRecorder::Recover, or remove it"
    assert len(warnings) == 1 and word in warnings[0], warnings
    TOLD.add(word)
    assert device.GetRecorder().Stop()
    assert device.GetRecorder().Recover(f"{part}.1", str(folder / "found.vtp"))
    for name in (file, folder / "found.vtp"):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(name))
        reader.Update()
        assert reader.GetOutput().GetPointData().HasArray("Force")
    part.mkdir()
    with told(device, ". Remove that, or give another name"):
        assert not device.GetRecorder().Start(str(file))
    part.rmdir()
    assert device.GetRecorder().Start(str(file)) and device.GetRecorder().Stop()
    part.write_bytes(left)
    for i in range(1, 1001):
        (folder / f"a.vtp.part.{i}").touch()
    with told(device, "Remove some, or give another name"):
        assert not device.GetRecorder().Start(str(file))
    assert device.GetRecorder().Start(str(folder / "c.vtp")) and device.GetRecorder().Stop()
    (folder / "a.vtp.part.7").unlink()
    with Errors(device, event="WarningEvent"):
        assert device.GetRecorder().Start(str(file))
    assert device.GetRecorder().Stop()
    device.Close()
    good = file.read_bytes()
    file.write_bytes(good[:300])
    with told(device, "Record again with vtkHapticRecorder::Start, or give another file"):
        assert not device.Open(f"replay:{file}")
    assert device.Open(f"replay:{folder / 'found.vtp'}")
    source = vtkHapticPathSource()
    source.SetShapeToFromFile()
    source.SetFileName(str(file))
    with told(source, "Give another FileName", source.GetExecutive()):
        source.Update()
    source.SetFileName(str(folder / "found.vtp"))
    source.Update()
    assert source.GetOutput().GetNumberOfPoints() > 0


# -- traces, tools and regions --

@result("Give it another one for the track", "keep both arrays in SetTraceArrays()", "Give it a 1 or a 0 a point, or remove it",
        'Take "all", "none", or some of ')
def traces(_):
    b, track = Bench(), vtkPolyData()
    b.haptics.SetTool(vtkHapticNeedle())
    b.feel.GetSurfaceStrength().AddPoint(0.0, 0.2)
    for i in range(21):
        b.path.GetPoints().SetPoint(i, 5.0, 8.0, 8.0 + 0.5 * i)
    with told(b.haptics, 'Take "all", "none", or some of '):
        assert not b.haptics.SetTraceArrays("Colour")

    def trace(names):
        assert b.haptics.SetTraceArrays(names)
        b.haptics.Update()
        made = vtkPolyData()
        made.DeepCopy(b.haptics.GetOutput())
        return made

    with told(track, "keep both arrays in SetTraceArrays()"):
        assert not vtkHapticNeedle.MakeTrack(trace("none"), track)
    whole = trace("Depth Normal")
    with told(whole, "Give it another one for the track"):
        assert not vtkHapticNeedle.MakeTrack(whole, whole)
    for names in "Depth Normal", "all":
        assert vtkHapticNeedle.MakeTrack(trace(names), track)
        assert track.GetNumberOfLines() == 1 and vtk_to_numpy(track.GetFieldData().GetArray("Depth"))[0] > 3.0
    b.haptics.SetTool(None)
    b = Bench()
    drilled(b)
    spinning = numpy_to_vtk(np.full(21, 0.5), deep=True)
    spinning.SetName("Spinning")
    b.path.GetPointData().AddArray(spinning)
    with told(b.haptics, "Give it a 1 or a 0 a point, or remove it", b.haptics.GetExecutive()):
        b.haptics.Update()
    spinning.Fill(1.0)
    b.path.Modified()
    always = b.force()
    assert always > 0.1
    b.path.GetPointData().RemoveArray("Spinning")
    assert b.force() == always


def drilled(b):
    burr = vtkHapticBurr()
    burr.SetRadius(3.0)
    burr.SetSpeed(30000.0)
    burr.SetContactValue(1000.0)
    burr.SetSolidToAbove()
    burr.GetSpecificEnergy().AddPoint(0.0, 5.0)
    b.haptics.SetTool(burr)
    for i in range(21):
        b.path.GetPoints().SetPoint(i, 10.0, 8.0, 5.0 + 0.4 * i)
    seconds = numpy_to_vtk(np.linspace(0.0, 1.0, 21), deep=True)
    seconds.SetName("Time")
    b.path.GetPointData().AddArray(seconds)


@result("Give the filter a vtkHapticBurr with SetTool() and feel with it first", "Update() the filter with a vtkHapticBurr first",
        "Make it with a vtkHapticBurr and a single path", "can't be read: …. Make it again")
def removals(folder):
    removal, b = vtkHapticRemoval(), Bench()
    b.haptics.SetRemoval(removal)
    with told(removal, "Give the filter a vtkHapticBurr with SetTool() and feel with it first"):
        assert not removal.WriteFile(str(folder / "a.vti"))
    with told(removal, "Update() the filter with a vtkHapticBurr first"):
        assert not removal.ReadTrace(vtkPolyData())
    drilled(b)
    b.haptics.Update()
    trace = vtkPolyData()
    trace.DeepCopy(b.haptics.GetOutput())
    with told(removal, "Make it with a vtkHapticBurr and a single path"):
        assert not removal.ReadTrace(vtkPolyData())
    whole = arrays(trace)["NormalForce"].sum()
    assert removal.ReadTrace(trace) and not removal.IsEmpty()
    b.haptics.Modified()
    b.haptics.Update()
    assert arrays(b.haptics.GetOutput())["NormalForce"].sum() < 0.99 * whole
    assert removal.WriteFile(str(folder / "a.vti"))
    cut = vtkPolyData()
    cut.DeepCopy(trace)
    cut.GetFieldData().GetAbstractArray("FinalShares").SetNumberOfTuples(1)
    cut.GetFieldData().GetAbstractArray("FinalBricks").SetNumberOfTuples(2)
    with Errors(removal) as errors:
        assert not removal.ReadTrace(cut)
    assert len(errors) == 1 and re.search(r"can't be read: .*\. Make it again", errors[0]), errors
    TOLD.add("can't be read: …. Make it again")
    assert removal.ReadTrace(trace)


@result("Give positions in the world that are finite", "Give polydata of vtkHapticMeasurements::CopyToPolyData, as it is",
        "there is none. Give a vtkPolyData", "give a 3D image with point scalars", "is not above 0. Give both",
        "Give a path along it, another value, or a larger radius", "has no lists of points and triangles. Save the area again",
        "is no list of three whole numbers. Save the area again")
def measurements(folder):
    measured, flat = vtkHapticMeasurements(), vtkImageData()
    with told(measured, "Give positions in the world that are finite"):
        assert measured.AddMeasurement(measured.PATH, line_to(math.nan)) == -1
    assert measured.AddMeasurement(measured.PATH, line_to(3.0)) == 0
    with told(measured, "there is none. Give a vtkPolyData"):
        assert not measured.ReadPolyData(None)
    with told(measured, "Give polydata of vtkHapticMeasurements::CopyToPolyData, as it is"):
        assert not measured.ReadPolyData(line_to(3.0))
    shapes, read = vtkPolyData(), vtkHapticMeasurements()
    measured.CopyToPolyData(shapes)
    assert read.ReadPolyData(shapes) and read.GetValue(0) == pytest.approx(3.0)
    ramp, stroke = image(RAMP), line_to(20.0)
    with told(measured, "give a 3D image with point scalars"):
        assert measured.AddPaintedArea(flat, 1000.0, stroke, 2.0) == -1
    with told(measured, "is not above 0. Give both"):
        assert measured.AddPaintedArea(ramp, 1000.0, stroke, 0.0) == -1
    for value, radius in ((2900.0, 2.0), (1700.0, 2.0)):
        with told(measured, "Give a path along it, another value, or a larger radius"):
            assert measured.AddPaintedArea(ramp, value, stroke, radius) == -1
    for value, radius in ((1000.0, 2.0), (1700.0, 9.0)):
        assert measured.AddPaintedArea(ramp, value, stroke, radius) > 0
    file = folder / "list.mrk.json"
    assert measured.WriteFile(str(file))
    good = file.read_text()
    for word, old, new in (
            ("has no lists of points and triangles. Save the area again", r'"triangles" *:', '"corners":'),
            ("is no list of three whole numbers. Save the area again", r'("triangles" *:\s*\[\s*\[)[^]]*\]', r"\1 0.5 ]")):
        assert re.search(old, good), old
        file.write_text(re.sub(old, new, good, count=1))
        with told(read, word):
            assert not read.ReadFile(str(file))
        assert measured.WriteFile(str(file)) and read.ReadFile(str(file))


@result("Set it to world units per metre, or to 0", "call AddTimeStep() for each of them first",
        "call SetProperty and SetInputData", "gives it. Pass its table as it is", "Pass the table of vtkHapticState::Drain",
        "give the smaller bound first")
def other_classes(_):
    fit, source, b = vtkHapticDevice(), vtkHapticTimeStepSource(), Bench()
    touched, known = vtkPoints(), vtkPoints()
    for x in ((0, 0, 0), (50, 0, 0), (0, 50, 0)):
        touched.InsertNextPoint([0.001 * one for one in x])
        known.InsertNextPoint(x)
    with told(fit, "Set it to world units per metre, or to 0"):
        assert fit.FitDeviceToWorld(touched, known, math.nan) == -1.0
    for scale in (0.0, 1000.0):
        assert fit.FitDeviceToWorld(touched, known, scale) >= 0.0 and fit.GetDeviceToWorld().GetElement(0, 0) == pytest.approx(1000.0)
    with told(source, "call AddTimeStep() for each of them first", source.GetExecutive()):
        source.Update()
    source.AddTimeStep(b.image, 0.0)
    b.haptics.SetInputConnection(source.GetOutputPort())
    assert b.force() == pytest.approx(1.0)
    editor = vtkHapticFunctionEditor()
    with told(editor, "call SetProperty and SetInputData"):
        assert not editor.Propose()
    step = image(np.where(RAMP < 1550.0, 0.0, 1000.0))
    editor.SetProperty(b.feel)
    editor.SetInputData(step)
    assert editor.Propose()
    display, device, states = vtkHapticHeadUpDisplay(), recorder(), vtkTable()
    with told(display, "gives it. Pass its table as it is"):
        display.AddStates(vtkTable())
    device.GetState().Drain(states)
    wait(device, 50)
    device.GetState().Drain(states)
    changed = vtkTable()
    changed.DeepCopy(states)
    changed.GetColumnByName("Time").SetValue(0, math.nan)
    with told(display, "Pass the table of vtkHapticState::Drain"):
        display.AddStates(changed)
    display.Clear()
    display.AddStates(states)
    assert f"States: {states.GetNumberOfRows()}\n" in str(display) and states.GetNumberOfRows() > 10
    path = vtkHapticPathSource()
    path.SetShapeToPressAndSlide()
    path.SetBoxBounds(9.0, 0.0, 0.0, 9.0, 0.0, 9.0)
    with told(path, "give the smaller bound first", path.GetExecutive()):
        path.Update()
    path.SetBoxBounds(0.0, 9.0, 0.0, 9.0, 0.0, 9.0)
    path.Update()
    assert path.GetOutput().GetNumberOfPoints() > 10


@pytest.mark.parametrize("words", result)
def test_cures_of_calls(words, tmp_path):
    try_calls(words, result[words], tmp_path)
