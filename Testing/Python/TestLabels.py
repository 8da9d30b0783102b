# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""touch() with a segmentation and the materials of its labels.

The volume is a ramp, V = 100 z, pressed 2 mm from z = 10 on, so that the force is k times 2 mm: 1 N with 500 N/m.
"""

import functools
import gzip
import math
import re
import struct
import time
import warnings
import zlib

import numpy as np
import pytest
from demonstration import run
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageWriter, vtkNIFTIImageWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from volumehaptics import image, touch, vtkHapticLabelTable, vtkHapticProperty, vtkHapticVolumeReader
from volumehaptics._touch import Errors
from volumehaptics.arrays import arrays

SIZE = (32, 17, 24)
VOLUME = np.broadcast_to(100.0 * np.arange(32).reshape(-1, 1, 1), SIZE).copy()
# Label 1 fills the half of small x, label 2 the other half.
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
    named.SetLabelName(7, "spleen")  # two labels with one name
    soft = {"spleen": dict(stiffness=100.0, surface_strength=9.0, friction=0.5, viscosity=0.25, color=(1, 0, 0.5),
                           felt=True, forbidden=False, name="the spleen")}
    assert felt(materials=[named, soft]) == [1.0, 0.2]
    assert named.GetStiffness(2) == -1.0  # the user's table is unchanged


def test_files_add_up(tmp_path):
    names = tmp_path / "Höhle.csv"
    names.write_text("label,name\n1,Leber\n2,Höhle 肝\n", encoding="utf-8")
    assert felt(materials=[names, {"Höhle 肝": dict(stiffness=800)}]) == [1.0, 1.6]
    values = tmp_path / "values.csv"
    values.write_text("label,stiffness\n1,100\n2,200\n", encoding="utf-8")
    assert felt(materials=values) == [0.2, 0.4]
    assert felt(materials=[str(values), str(names), {"Leber": dict(stiffness=300)}]) == [0.6, 0.4]


def test_numbers_of_a_table_that_are_in_no_voxel_are_told():
    with pytest.warns(UserWarning, match="1 of 2 labels of the table are in no voxel, such as 77 .tumour."):
        assert felt(materials={1: dict(stiffness=200), 77: dict(name="tumour", stiffness=9)}) == [0.4, 1.0]
    table = named_table()
    table.SetStiffness(3, 200)
    with pytest.warns(UserWarning, match="1 of 3 labels of the table are in no voxel, such as 3$"):
        felt(label_table=table)


@pytest.mark.parametrize("origin", [(500, 0, 0), (24, 0, 0), (0, -17, 0), (0, 0, 32)])
def test_labels_that_miss_the_volume_are_told(origin):
    """Labels that lie just beyond a face are reported, too: their first voxel is one voxel beyond the volume's last
    voxel."""
    with pytest.warns(UserWarning, match="no voxel of the volume has a label: the labels are all 0, or belong to another scan"):
        assert felt(labels=image(LABELS, origin=origin), materials={1: dict(stiffness=200)}) == [1.0, 1.0]
    turned = image(LABELS, origin=(23, 16, 0))
    turned.SetDirectionMatrix(-1, 0, 0, 0, -1, 0, 0, 0, 1)
    nearer = [x - (x > 0) + (x < 0) for x in origin] if 500 not in origin else (0, 0, 0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        felt(labels=image(LABELS, origin=nearer))
        felt(labels=turned, materials={2: dict(stiffness=800)})


def test_empty_labels_are_told():
    with pytest.warns(UserWarning, match="no voxel of the volume has a label: the labels are all 0"):
        assert felt(labels=LABELS * 0) == [1.0, 1.0]


def test_a_table_is_used_as_it_is():
    table = named_table()
    table.SetStiffness(1, 200)
    assert felt(materials=table) == felt(label_table=table) == [0.4, 1.0]


def test_an_image_has_its_own_geometry_and_names():
    """The labels' voxels are half as large, begin elsewhere, and their axes y and z run backwards."""
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
    """Writes a file as teem.sourceforge.net/nrrd/format.html defines it: two layers along the first, fastest axis, each
    with the value 1."""
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
    write_nrrd(file, LABELS[:, :, :-1], "(1,2,0)")
    placed = image(VOLUME, origin=(-7, 2, 0))
    assert round(press(6, volume=placed, labels=file, materials={"liver": dict(stiffness=200)}), 9) == 0.4


# The files are written byte by byte according to NIfTI-1 (nifti1.h) and MetaImage (itk.org, ITK/MetaIO). The expected
# positions follow from these definitions: NIfTI's world is right-anterior-superior, MetaImage's
# left-posterior-superior.

def write_nifti(file, labels, step, origin):
    """Writes NIfTI with index axes along the world's axes, with these steps (mm)."""
    types = {"int16": (4, 16), "int64": (1024, 64), "uint8": (2, 8), "float64": (64, 64)}
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *labels.shape[::-1], 1, 1, 1, 1)
    struct.pack_into("<hh", header, 70, *types[labels.dtype.name])
    struct.pack_into("<4f", header, 76, 1.0, *map(abs, step))
    struct.pack_into("<f", header, 108, 352.0)  # offset of the voxels
    struct.pack_into("<hh", header, 252, 0, 1)  # sform of the scanner
    for row in range(3):
        struct.pack_into("<4f", header, 280 + 16 * row, *(step[row] * (row == column) for column in range(3)), origin[row])
    header[344:348] = b"n+1\0"
    with (gzip.open if str(file).endswith(".gz") else open)(file, "wb") as stream:
        stream.write(bytes(header) + labels.tobytes())


def write_meta_image(file, labels, step, origin, type_name=None, compressed=False, sizes=None):
    """Writes the same labels in left-posterior-superior axes, as SimpleITK.WriteImage() does."""
    names = {"int16": "MET_SHORT", "int64": "MET_LONG_LONG", "uint8": "MET_UCHAR", "int32": "MET_INT"}
    turned = np.array((-1, -1, 1))
    sizes = sizes or labels.shape[::-1]
    axes = len(sizes)
    matrix, where = np.eye(axes), np.zeros(axes)
    matrix[:3, :3] = np.diag(np.sign(step) * turned)
    where[:3] = turned * origin
    samples = zlib.compress(labels.tobytes()) if compressed else labels.tobytes()
    fields = {"ObjectType": "Image", "NDims": axes, "BinaryData": "True", "BinaryDataByteOrderMSB": "False",
              "CompressedData": compressed, **({"CompressedDataSize": len(samples)} if compressed else {}),
              "TransformMatrix": " ".join(f"{x:g}" for x in matrix.ravel()), "Offset": " ".join(f"{x:g}" for x in where),
              "ElementSpacing": " ".join(f"{x:g}" for x in [*np.abs(step), 1][:axes]),
              "DimSize": " ".join(map(str, sizes)), "ElementType": type_name or names[labels.dtype.name],
              "ElementDataFile": "LOCAL"}
    file.write_bytes("".join(f"{key} = {value}\n" for key, value in fields.items()).encode() + samples)


WRITERS = {"nii": write_nifti, "nii.gz": write_nifti, "mha": write_meta_image}
ORIGIN = np.array((-7.0, 3.0, 0.0))  # origin of the volume, right-anterior-superior


def felt_of(file, volume, at):
    """Returns the forces (N) of two presses, at the indices 5 and 18 along x; `at` gives their positions."""
    points = [np.linspace((x, at[1], 10), (x, at[1], 12), 21) for x in at[0]]
    traces = touch(volume, points, labels=file, materials={1: dict(stiffness=200), 2: dict(stiffness=800)})
    return [round(-arrays(trace)["Force"][-1][2], 9) for trace in traces]


@pytest.mark.parametrize("ending", WRITERS)
@pytest.mark.parametrize("world", ("RAS", "LPS"))
def test_labels_of_a_file_lie_where_it_says(tmp_path, ending, world):
    """The file has the same labels, with an axis x that runs backwards, or only a part of them, or both."""
    turn = -1.0 if world == "LPS" else 1.0
    direction = np.diag((turn, turn, 1.0))
    volume = image(VOLUME, origin=tuple(direction @ ORIGIN), direction=direction)
    at = turn * (ORIGIN[0] + np.array((5, 18))), turn * (ORIGIN[1] + 8)
    file = tmp_path / f"labels.{ending}"
    for first, last, step in ((0, 24, 1), (0, 24, -1), (3, 24, 1), (2, 20, -1)):
        part = LABELS[:, :, first:last][:, :, ::step].copy()
        begin = ORIGIN + ((first if step > 0 else last - 1), 0, 0)
        WRITERS[ending](file, part, (step, 1, 1), begin)
        assert felt_of(file, volume, at) == [0.4, 1.6], (first, last, step)


@pytest.mark.parametrize("ending", WRITERS)
def test_labels_that_lie_elsewhere_are_refused_with_the_cure(tmp_path, ending):
    """An array has lost its placement when it was read, and the file could be mirrored, so no placement is assumed."""
    file = tmp_path / f"labels.{ending}"
    bare = (5.0, 18.0), 8.0
    WRITERS[ending](file, LABELS[:, :, ::-1].copy(), (-1, 1, 1), ORIGIN + (23, 0, 0))
    with pytest.raises(ValueError, match="do not lie on the volume.*Cure: place the volume.*direction"):
        felt_of(file, VOLUME, bare)
    # Apply the three remedies in the error's text.
    placed = image(VOLUME, (1, 1, 1), tuple(ORIGIN), direction=np.eye(3))
    assert felt_of(file, placed, (ORIGIN[0] + np.array((5, 18)), ORIGIN[1] + 8)) == [0.4, 1.6]
    assert felt_of(image(LABELS), VOLUME, bare) == felt_of(LABELS, VOLUME, bare) == [0.4, 1.6]
    # Use a part of the labels, smaller voxels, or another origin.
    for labels, step, origin in ((LABELS[:, :, 3:].copy(), (1, 1, 1), ORIGIN + (3, 0, 0)),
                                 (LABELS, (0.5, 1, 1), ORIGIN), (LABELS, (1, 1, 1), ORIGIN + (0.5, 0, 0)),
                                 (LABELS, (1, 1, 1), ORIGIN + (500, 0, 0))):
        WRITERS[ending](file, labels, step, origin)
        for volume in (VOLUME, placed) if labels is LABELS else (VOLUME,):
            with pytest.raises(ValueError, match="do not lie on the volume"):
                felt_of(file, volume, bare)


def scale(file, slope, intercept):
    """Sets scl_slope and scl_inter, by which nifti1.h multiplies stored numbers, and what it adds to them."""
    header = bytearray(file.read_bytes())
    struct.pack_into("<2f", header, 112, slope, intercept)
    file.write_bytes(header)


def test_labels_that_nifti_scales(tmp_path):
    """Scaling as in nibabel's issue 1069: rounding errors of the labels are removed; values that are not integers are
    refused."""
    file = tmp_path / "labels.nii"
    volume, at = image(VOLUME, origin=tuple(ORIGIN), direction=np.eye(3)), (ORIGIN[0] + np.array((5, 18)), ORIGIN[1] + 8)
    for stored, slope, intercept in ((LABELS, 1.00002, 0.0), (20 * LABELS, 0.05, 0.0), (LABELS - 4, 1.0, 4.0),
                                     (LABELS, 0.0, 7.0), (LABELS, math.nan, 0.0)):
        write_nifti(file, stored, (1, 1, 1), ORIGIN)
        scale(file, slope, intercept)
        assert felt_of(file, volume, at) == [0.4, 1.6], (slope, intercept)
    write_nifti(file, LABELS, (1, 1, 1), ORIGIN)
    scale(file, 0.3, 0.0)
    with pytest.raises(ValueError, match="(?s)not label numbers, such as 0.3.*with the slope 1"):
        felt_of(file, volume, at)
    scale(file, 1.0, 0.0)
    assert felt_of(file, volume, at) == [0.4, 1.6]


PROMISES = "more samples than|announces more voxels than the file has"


def test_meta_images_that_vtk_does_not_know(tmp_path):
    """Tests samples of 64 bits, MetaIO's long (which has 4 bytes), a fourth axis, and headers that lie. VTK's reader
    would allocate memory for one voxel and read all samples into it."""
    file = tmp_path / "labels.mha"
    volume, at = image(VOLUME, origin=tuple(ORIGIN), direction=np.eye(3)), (ORIGIN[0] + np.array((5, 18)), ORIGIN[1] + 8)
    write = functools.partial(write_meta_image, file, step=(1, 1, 1), origin=ORIGIN)
    write(LABELS.astype(np.int64))
    assert felt_of(file, volume, at) == [0.4, 1.6]
    write(LABELS.astype(np.int32), type_name="MET_LONG")
    assert felt_of(file, volume, at) == [0.4, 1.6]
    write(LABELS, sizes=(*SIZE[::-1], 1))
    assert felt_of(file, volume, at) == [0.4, 1.6]
    write(LABELS, compressed=True)
    assert felt_of(file, volume, at) == [0.4, 1.6]
    write(LABELS.astype(np.int64), compressed=True)
    assert felt_of(file, volume, at) == [0.4, 1.6]
    for labels, options, said in (
            (LABELS, dict(sizes=(24, 17, 16, 2)), "(?s)several volumes.* into its own file"), (LABELS, dict(type_name="MET_STRING"), "of another type"),
            (LABELS, dict(sizes=(24, 17, 33)), PROMISES),
            (LABELS, dict(sizes=(40000, 40000, 40000)), PROMISES),
            (LABELS, dict(sizes=(40000, 40000, 40000), compressed=True), PROMISES),
            (LABELS, dict(sizes=SIZE[::-1], compressed=True, type_name="MET_LONG"), PROMISES)):
        write(labels, **options)
        with pytest.raises(ValueError, match=said):
            felt_of(file, volume, at)
    write(LABELS)
    assert felt_of(file, volume, at) == [0.4, 1.6]


def write_vti(file, labels, *_):
    """Writes appended samples without encoding, as other programs do."""
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image(labels))
    writer.SetCompressorTypeToNone()
    writer.EncodeAppendedDataOff()
    writer.SetFileName(str(file))
    writer.Write()


WHOLE = {"a.nii": write_nifti, "a.nii.gz": write_nifti, "raw.mha": write_meta_image, "a.vti": write_vti,
         "packed.mha": functools.partial(write_meta_image, compressed=True), "a.seg.nrrd": lambda file, labels, *_: write_nrrd(file, labels)}


@pytest.mark.parametrize("name", WHOLE)
def test_files_that_are_cut_off_or_damaged_are_refused(tmp_path, name):
    """VTK's readers return arbitrary memory for data that are missing or that they fail to unpack."""
    file = tmp_path / name
    WHOLE[name](file, LABELS, (1, 1, 1), ORIGIN)
    volume, at = image(VOLUME, origin=tuple(ORIGIN), direction=np.eye(3)), (ORIGIN[0] + np.array((5, 18)), ORIGIN[1] + 8)
    if name in ("a.vti", "a.seg.nrrd"):  # formats without a placement
        volume, at = VOLUME, ((5.0, 18.0), 8.0)
    whole = file.read_bytes()
    damaged = [whole[:-lost] for lost in ((20, 100, len(whole) // 2) if name != "packed.mha" else (20, ))]  # of the samples
    if name not in ("a.vti", ):  # formats that end with blanks and tags
        damaged += [whole[:-lost] for lost in (1, 4, 8, 9)]
    if name in ("a.nii.gz", "packed.mha", "a.seg.nrrd"):
        for place in (-3, -len(whole) // 4):
            other = bytearray(whole)
            other[place] ^= 16
            damaged.append(other)
    for one in damaged:
        file.write_bytes(one)
        with pytest.raises(ValueError, match="[Cc]heck that the (copy|file)"):
            felt_of(file, volume, at)
    file.write_bytes(whole)
    assert felt_of(file, volume, at) == [0.4, 1.6]


def test_nifti_whose_header_lies(tmp_path):
    file = tmp_path / "labels.nii"
    write_nifti(file, LABELS, (1, 1, 1), ORIGIN)
    whole = bytearray(file.read_bytes())
    struct.pack_into("<8h", whole, 40, 3, 32767, 32767, 32767, 1, 1, 1, 1)
    file.write_bytes(whole)
    with pytest.raises(ValueError, match="its header announces more voxels than the file has"):
        press(5, labels=file)


@pytest.mark.parametrize("ending", (".nii", ".nii.gz", ".mha", ".vti"))
def test_files_that_vtk_reads(tmp_path, ending):
    """Reads files of VTK's writers; VTK's NIfTI writer stores no names."""
    file = str(tmp_path / f"labels{ending}")
    segmentation = image(LABELS)
    named_table().WriteFieldData(segmentation.GetFieldData())
    writer = {".mha": vtkMetaImageWriter, ".vti": vtkXMLImageDataWriter}.get(ending, vtkNIFTIImageWriter)()
    writer.SetInputData(segmentation)
    writer.SetFileName(file)
    writer.Write()
    key = "spleen" if ending == ".vti" else 2
    assert felt(labels=file, materials={key: dict(stiffness=800)}) == [1.0, 1.6]


LONG = {
    "numbers.csv": "label,name,stiffness\n" + "".join(f"{i},organ,100\n" for i in range(4500)),
    "twins.csv": "label,name,stiffness\n" + "1,organ,100\n" * 5000,
    "quotes.csv": "label,name,stiffness\n" + "1,\"organ\n" * 7000,
    "open.csv": "label,name,stiffness\n" + "\"" * 65000,
    "commas.csv": "label,name,stiffness\n" + "," * 65000,
    "columns.csv": ",".join(f"a{i}" for i in range(11000)) + "\n",
    "labels.txt": "".join(f"{i} organ 1 2 3 0\n" for i in range(4000)),
    "deep.json": "[" * 65000,
    "nested.json": "{\"a\":" * 13000,
    "segments.seg.nrrd": "".join(f"Segment{i}_Name:=organ\nSegment{i}_LabelValue:={i % 255}\n" for i in range(1200)),
    "same.seg.nrrd": "Segment0_Name:=organ\n" * 3000,
    "far.seg.nrrd": "".join(f"Segment{i * 1000}_Name:=organ\n" for i in range(2000)),
}


@pytest.mark.parametrize("name", LONG)
def test_a_table_of_64_kb_is_read_soon(tmp_path, name):
    """Tables with rows that a reader could compare with all others: such a table of 65 kB once took 900 s."""
    nrrd = ("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n" if name.endswith("nrrd") else "")
    file = tmp_path / name
    file.write_bytes((nrrd + LONG[name] + ("\n" if nrrd else "")).encode() + bytes(8 if nrrd else 0))
    table, begin = vtkHapticLabelTable(), time.process_time()
    with Errors(table):
        table.ReadFile(str(file))
    assert time.process_time() - begin < 1.0


def test_a_reader_asks_for_its_file():
    reader = vtkHapticVolumeReader()
    with Errors(reader, reader.GetExecutive()) as errors:
        reader.Update()
    assert "set FileName" in errors[0]


def test_files_of_labels_that_cannot_be(tmp_path):
    with pytest.raises(ValueError, match="no file 'none.seg.nrrd'"):
        press(5, labels="none.seg.nrrd")
    file = tmp_path / "labels.seg.nrrd"
    file.write_bytes(b"NRRD0004\ntype: float\n\n")
    with pytest.raises(ValueError, match="labels.seg.nrrd.*whole numbers"):
        press(5, labels=file)
    (tmp_path / "labels.xyz").write_bytes(b"1")
    with pytest.raises(ValueError, match="extension"):
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
    """Writes a block of two organs that face the front, heart above liver, as NIfTI in a patient's axes."""
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
    """The springs have 700 N/m on the heart and 500 N/m on the liver, are stretched by 2.5 mm, and the friction is
    0.2."""
    write_chest(tmp_path)
    said = run("chest_labels.py", tmp_path / "picture.png", tmp_path)
    newtons = {organ: float(median) for organ, median in re.findall(r"(\w+): ([\d.]+) N as a median", said)}
    slide = 2.5 * math.hypot(1.0, 0.2)  # mm
    assert newtons == {"heart": pytest.approx(0.7 * slide, rel=0.03), "liver": pytest.approx(0.5 * slide, rel=0.03)}, said
