# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""touch() with a segmentation and the materials of its labels.

The volume is a ramp, V = 100 z, pressed 2 mm from z = 10 on, so that the force is k times 2 mm: 1 N with 500 N/m.
"""

import gzip
import math
import re

import numpy as np
import pytest
from demonstration import run
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageWriter, vtkNIFTIImageWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from volumehaptics import image, touch, vtkHapticLabelTable, vtkHapticProperty
from volumehaptics.arrays import arrays

SIZE = (32, 17, 24)
VOLUME = np.broadcast_to(100.0 * np.arange(32).reshape(-1, 1, 1), SIZE).copy()
# Label 1 in the half of small x, 2 in the other.
LABELS = np.where(np.arange(24) < 12, 1, 2).astype(np.int16) * np.ones(SIZE, np.int16)


def press(x, labels=LABELS, volume=VOLUME, **options):
    """The force (N)."""
    points = np.linspace((x, 8, 10), (x, 8, 12), 21)
    return -arrays(touch(volume, points, labels=labels, **options))["Force"][-1][2]


def felt(**options):
    return [round(press(x, **options), 9) for x in (5, 18)]


def named_table():
    table = vtkHapticLabelTable()
    table.SetLabelName(1, "liver")
    table.SetLabelName(2, "spleen")
    return table


def test_labels_of_the_same_values_feel_different():
    assert felt(materials={1: dict(stiffness=200), 2: dict(stiffness=800)}) == [0.4, 1.6]
    assert felt(materials={1: dict(stiffness=200)}) == [0.4, 1.0]
    assert felt(materials={np.int64(2): {"felt": False}}) == [1.0, 0.0]
    assert felt() == felt(labels=None) == [1.0, 1.0]


@pytest.mark.parametrize("dtype", ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"))
def test_labels_of_every_type(dtype):
    assert felt(labels=LABELS.astype(dtype), materials={2: dict(stiffness=800)}) == [1.0, 1.6]


def test_a_mask_is_labels():
    assert felt(labels=LABELS == 2, materials={1: dict(stiffness=800)}) == [1.0, 1.6]


def test_materials_by_name():
    named = named_table()
    named.SetLabelName(7, "spleen")  # two labels of one name
    soft = {"spleen": dict(stiffness=100.0, surface_strength=9.0, friction=0.5, viscosity=0.25, color=(1, 0, 0.5),
                           felt=True, forbidden=False, name="the spleen")}
    assert felt(materials=[named, soft]) == [1.0, 0.2]
    assert named.GetStiffness(2) == -1.0  # it is the user's


def test_files_add_up(tmp_path):
    names = tmp_path / "Höhle.csv"
    names.write_text("label,name\n1,Leber\n2,Höhle 肝\n", encoding="utf-8")
    assert felt(materials=[names, {"Höhle 肝": dict(stiffness=800)}]) == [1.0, 1.6]
    values = tmp_path / "values.csv"
    values.write_text("label,stiffness\n1,100\n2,200\n", encoding="utf-8")
    assert felt(materials=values) == [0.2, 0.4]
    assert felt(materials=[str(values), str(names), {"Leber": dict(stiffness=300)}]) == [0.6, 0.4]


def test_a_table_is_used_as_it_is():
    table = named_table()
    table.SetStiffness(1, 200)
    assert felt(materials=table) == felt(label_table=table) == [0.4, 1.0]


def test_an_image_has_its_own_geometry_and_names():
    """Its voxels are half as large, it begins elsewhere, and its axes y and z run backwards."""
    segmentation = image(np.full((64, 40, 12), 2, np.uint8), spacing=(0.5, 0.5, 0.5), origin=(15, 18, 31.5))
    segmentation.SetDirectionMatrix(1, 0, 0, 0, -1, 0, 0, 0, -1)
    named_table().WriteFieldData(segmentation.GetFieldData())
    assert felt(labels=segmentation, materials={"spleen": dict(stiffness=800)}) == [1.0, 1.6]


def test_an_array_lies_on_the_volume():
    volume = image(VOLUME, spacing=(1, 1, 1), origin=(-7, 0, 0))
    assert round(press(6, volume=volume, materials={2: dict(stiffness=800)}), 9) == 1.6
    assert round(press(3, volume=volume, materials={2: dict(stiffness=800)}), 9) == 1.0
    cut = vtkImageData()
    cut.ShallowCopy(volume)
    cut.SetExtent(3, 26, 0, 16, 0, 31)
    assert round(press(9, volume=cut, materials={2: dict(stiffness=800)}), 9) == 1.6


def test_goes_with_a_property():
    soft = vtkHapticProperty()
    soft.GetStiffness().AddPoint(0.0, 50.0)
    assert felt(property=soft, materials={1: dict(stiffness=200)}) == [0.4, 0.1]


def write_nrrd(file, labels, origin="(0,0,0)"):
    """After teem.sourceforge.net/nrrd/format.html: two layers of the value 1 each, along the first, fastest axis."""
    sizes = " ".join(map(str, labels.shape[::-1]))
    layers = np.stack([labels == 1, labels == 2], axis=-1).astype(np.uint8)
    file.write_bytes((f"NRRD0004\ntype: uchar\ndimension: 4\nspace: left-posterior-superior\nsizes: 2 {sizes}\n"
                      f"space directions: none (1,0,0) (0,1,0) (0,0,1)\nspace origin: {origin}\nencoding: gzip\n"
                      "Segment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Name:=liver\n"
                      "Segment1_LabelValue:=1\nSegment1_Layer:=1\nSegment1_Name:=spleen\n\n").encode()
                     + gzip.compress(layers.tobytes()))


def test_a_file_has_labels_and_names(tmp_path):
    file = tmp_path / "Höhle.seg.nrrd"
    write_nrrd(file, LABELS)
    assert felt(labels=file, materials={"spleen": dict(stiffness=800)}) == [1.0, 1.6]
    assert felt(labels=str(file), materials={1: dict(stiffness=200)}) == [0.4, 1.0]
    # As many voxels, so that it lies on the volume; with fewer, where it says.
    write_nrrd(file, LABELS, "(5,5,5)")
    assert felt(labels=file, materials={"spleen": dict(stiffness=800)}) == [1.0, 1.6]
    write_nrrd(file, LABELS[:, :, :-1], "(8,0,0)")
    assert felt(labels=file, materials={"liver": dict(stiffness=200)}) == [1.0, 0.4]


@pytest.mark.parametrize("ending", (".nii", ".nii.gz", ".mha", ".vti"))
def test_files_that_vtk_reads(tmp_path, ending):
    """VTK's writers; NIfTI's has no names."""
    file = str(tmp_path / f"labels{ending}")
    segmentation = image(LABELS)
    named_table().WriteFieldData(segmentation.GetFieldData())
    writer = {".mha": vtkMetaImageWriter, ".vti": vtkXMLImageDataWriter}.get(ending, vtkNIFTIImageWriter)()
    writer.SetInputData(segmentation)
    writer.SetFileName(file)
    writer.Write()
    key = "spleen" if ending == ".vti" else 2
    assert felt(labels=file, materials={key: dict(stiffness=800)}) == [1.0, 1.6]


def test_files_of_labels_that_cannot_be(tmp_path):
    with pytest.raises(ValueError, match="no file 'none.seg.nrrd'"):
        press(5, labels="none.seg.nrrd")
    file = tmp_path / "labels.seg.nrrd"
    file.write_bytes(b"NRRD0004\ntype: float\n\n")
    with pytest.raises(ValueError, match="labels.seg.nrrd.*whole numbers"):
        press(5, labels=file)
    (tmp_path / "labels.xyz").write_bytes(b"1")
    with pytest.raises(ValueError, match="ending"):
        press(5, labels=tmp_path / "labels.xyz")


@pytest.mark.parametrize("materials, error, said", (
    ({"livr": dict(stiffness=1)}, ValueError, "'livr'; is it 'liver'.*'spleen'"),
    ({1: dict(stifness=1)}, TypeError, "'stifness'; is it 'stiffness'"),
    ({1: dict(stiffness=-1)}, ValueError, "stiffness of label 1 can't be -1"),
    ({1: dict(stiffness="soft")}, TypeError, "stiffness='soft' of label 1"),
    ({1: dict(color=(1, 2, 3))}, ValueError, "colour of label 1"),
    ({1: dict(color="red")}, TypeError, "color='red' of label 1"),
    ({1: 300}, TypeError, "label 1 is a dict"),
    ({1.5: dict(stiffness=1)}, TypeError, "number or a name, not 1.5"),
    ({True: dict(stiffness=1)}, TypeError, "number or a name, not True"),
    ({1 << 40: dict(stiffness=1)}, ValueError, "label 1099511627776"),
    ("none.csv", ValueError, "none.csv: does not exist"),
    (5, TypeError, "materials are a dict"),
))
def test_materials_that_cannot_be(materials, error, said):
    with pytest.raises(error, match=said):
        press(5, materials=[named_table(), materials])


def test_labels_that_cannot_be():
    with pytest.raises(TypeError, match="give labels="):
        touch(VOLUME, [(5, 8, 10)], materials={1: dict(stiffness=1)})
    with pytest.raises(ValueError, match=r"\(32, 17, 23\).*\(32, 17, 24\)"):
        press(5, labels=LABELS[:, :, :-1].copy())
    with pytest.raises(ValueError, match="whole"):
        press(5, labels=LABELS + 0.5, materials={1: dict(stiffness=1)})
    with pytest.raises(TypeError, match="label_table"):
        press(5, materials={}, label_table=vtkHapticLabelTable())


def write_chest(folder):
    """A block of two organs that face the front, heart above liver, in NIfTI of a patient's axes."""
    labels = np.zeros((130, 48, 48), np.uint8)  # z to the top, y to the front, x to the right
    labels[5:65, 8:32, 4:44] = 5
    labels[65:125, 8:32, 4:44] = 51
    for name, samples in (("mask", labels), ("cxr", np.where(labels > 0, 50, -100).astype(np.int16))):
        writer, place = vtkNIFTIImageWriter(), vtkMatrix4x4()
        for axis in range(3):
            place.SetElement(axis, axis, (-1.0, 1.0, 1.0)[axis])
        writer.SetInputData(image(samples, spacing=(1.5, 1.5, 1.5)))
        writer.SetSFormMatrix(place)
        writer.SetQFac(-1.0)
        writer.SetFileName(str(folder / f"{name}.nii.gz"))
        writer.Write()
    (folder / "structures.csv").write_text("group,structure,id\norgans,liver,5\norgans,heart,51\n", encoding="utf-8")


def test_organs_of_a_chest_are_stroked(tmp_path):
    """Springs of 700 N/m on the heart and 500 N/m on the liver, stretched by 2.5 mm, with a friction of 0.2."""
    write_chest(tmp_path)
    said = run("chest_labels.py", tmp_path / "picture.png", tmp_path)
    newtons = {organ: float(median) for organ, median in re.findall(r"(\w+): ([\d.]+) N as a median", said)}
    slide = 2.5 * math.hypot(1.0, 0.2)  # mm
    assert newtons == {"heart": pytest.approx(0.7 * slide, rel=0.03), "liver": pytest.approx(0.5 * slide, rel=0.03)}, said
