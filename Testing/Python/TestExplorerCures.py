# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures that errors of volumehaptics-explore name: with the cure, it writes its summary, which contains
forces."""

import functools
import json
import os
import re
import struct
import subprocess

import numpy as np
import pytest
from TestCures import RAMP
from TestFileCures import recorder, wait
from cure_bench import line_to
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLPolyDataReader,
    vtkXMLPolyDataWriter,
    vtkXMLUnstructuredGridWriter,
)
from volumehaptics import image, vtkHapticMeasurements
from volumehaptics.__main__ import find_explorer

# Wrong options of the explorer, words of the remedy, and right options, with which the explorer writes its summary. {}
# is a folder with the ramp as ramp.vti, a label map as labels.vti, a surface as ball.stl and the files that the
# functions below write. The right options are combined into few runs, because each run takes time.
ALL = "--newtons 2.5 --size 200 --tool needle --preset MRI --front -y --stereo anaglyph --measurements {}/list.csv"
TWO = "--device virtual --device falcon"
LABELLED = "--labels {}/labels.vti --materials {}/table.csv"
GUIDED = "--mode surface --guide {}/ball.stl"
OPTIONS = (
    ("--newtons much", "use -100 to 100, or two such numbers", ALL),
    ("--size 20", "use a whole number from 100 to 8000", ALL),
    ("--series 0", "use 1 or more; without --series", ""),
    ("--measurements {}/list.txt", "use one that ends in .csv, .vtp or .mrk.json", ALL),
    ("--movie {}/movie.avi", "use one that ends in .ogv", None),
    ("--tool spoon", "use needle, burr, or point", ALL),
    ("--write-volume {}/copy.nii", "use one that ends in .vti", "--write-volume {}/copy.vti"),
    ("--as-labels --labels {}/labels.vti", "leave out this option, or --labels", LABELLED),
    ("--materials {}/table.csv", "give the segmentation, as in --labels", LABELLED),
    ("--preset bones", "use auto, propose, histogram, one of the presets", ALL),
    ("--mode tickle", "the name of an array may follow after a colon", GUIDED),
    ("--front up", "use one of +x -x +y -y +z -z", ALL),
    ("--stereo best", "use one of ", ALL),
    ("--device falcon --device pid --device wooden", "give two devices at most, one for each hand", TWO),
    ("--device falcon --device virtual", "give it before the real device", TWO),
    ("--device virtual --device falcon --replay {}/touch.vtp", "give one device, or leave out --replay", TWO),
    ("--array colour", "use one of ", ""),
    ("--guide {}/none.vtp", "check its path", GUIDED),
    ("--guide {}/ball.dae", "use lines or a surface that end in .vtp", GUIDED),
    ("--guide {}/point.vtk", "use a polyline, or the triangles of a surface", GUIDED),
    ("--guide {}/far.stl", "give it the volume's coordinates and units", GUIDED),
    ("--labels {}/none.vti", "check the spelling; what can be read is ", LABELLED),
    ("--as-labels", "leave --as-labels out", ""),
    ("--mode vector-follow", "give a .vti file that has them, or use another mode", GUIDED),
    ("--pictures {}/table.csv", "choose one that you may write to with --pictures DIR", ""),
)


@pytest.fixture(scope="module")
def shelf(tmp_path_factory):
    folder = tmp_path_factory.mktemp("explorer")
    rng = np.random.default_rng(4)
    for name, values in (("ramp", RAMP + rng.normal(0.0, 0.3, RAMP.shape)), ("labels", (RAMP > 1500).astype(np.uint8))):
        writer = vtkXMLImageDataWriter()
        writer.SetFileName(str(folder / f"{name}.vti"))
        writer.SetInputData(image(values))
        writer.Write()
    for name, middle in (("ball", 15.0), ("far", 1e6)):
        sphere, writer = vtkSphereSource(), vtkSTLWriter()
        sphere.SetCenter(11.0, 8.0, middle)
        sphere.SetRadius(5.0)
        writer.SetInputConnection(sphere.GetOutputPort())
        writer.SetFileName(str(folder / f"{name}.stl"))
        writer.Write()
    (folder / "table.csv").write_text("label,name,stiffness\n1,bone,800\n")
    (folder / "point.vtk").write_text("# vtk DataFile Version 3.0\npoint\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n1 2 3\n")
    (folder / "ball.dae").write_text("<COLLADA/>")
    fill(folder, RAMP + rng.normal(0.0, 0.3, RAMP.shape))
    return folder


@pytest.fixture(scope="module")
def explore(shelf, build):
    """Returns a function that runs the explorer on the ramp, once for equal options."""
    explorer = find_explorer() or next(iter(build.rglob("volumehaptics-explore")), None)
    if explorer is None or "DISPLAY" not in os.environ:
        pytest.skip("needs the explorer and a display")

    @functools.cache
    def run(options):
        words = [word.replace("{}", str(shelf)).replace("%", " ") for word in options.split()]
        needs_none = any(word in options for word in ("--pictures", "--script", "--write-volume")) or not words
        out = shelf / f"out{run.cache_info().misses}"
        told = subprocess.run([explorer, *words, *([] if needs_none else ["--pictures", out])], capture_output=True, text=True,
                              timeout=60)
        told.summary = (out / "summary.txt").read_text() if (out / "summary.txt").exists() else ""
        return told

    run.program = str(explorer)
    return run


@pytest.mark.parametrize("wrong, words, right", OPTIONS)
def test_cures_of_options(shelf, explore, wrong, words, right):
    told = explore(f"{{}}/ramp.vti {wrong}")
    assert told.returncode != 0 and words in told.stderr, told.stderr
    if right is not None:
        expect_forces(shelf, explore, f"{{}}/ramp.vti {right}")


# Options whose argument is a file to read.
READ = ("--device replay:{}.vtp", "--guide {}.csv", "--guide {}.mrk.json", "--guide {}.stl", "--guide {}.vtp", "--labels {}.nii",
        "--labels {}.seg.nrrd", "--labels {}/labels.vti --materials {}.csv", "--measurements {}.csv", "--measurements {}.mrk.json",
        "--measurements {}.vtp", "--preset {}.json", "--replay {}.vtp", "--script {}.txt", "--setup {}.json", "--tool {}.ply",
        "--tool {}.stl", "--tool {}.vtp")


@pytest.mark.parametrize("option", READ)
def test_no_option_waits_for_a_pipe(shelf, explore, option):
    ending = re.search(r"{}([.][.a-z]+)", option).group(1)
    if not (shelf / f"pipe{ending}").exists():
        os.mkfifo(shelf / f"pipe{ending}")
    window = "" if "--script" in option else " --script {}/close.txt"
    told = explore("{}/ramp.vti --size 150 " + option.replace("{}.", "{}/pipe.") + window)
    assert told.returncode != 0 and f"pipe{ending}" in told.stderr and "is a pipe" in told.stderr, told.stderr


def expect_forces(shelf, explore, options):
    cured = explore(f"{options} --size 100" if "--size" not in options else options)
    assert cured.returncode == 0, cured.stderr
    if "--write-volume" in options:
        assert (shelf / "copy.vti").stat().st_size > 0
    elif "--script" not in options:
        largest = re.search(r"Largest force\n +([0-9.]+) N", cured.summary)
        assert float(largest.group(1)) > 0.1
    return cured


# Volumes, and options that need a window: wrong arguments, words of the remedy, and right arguments. A script closes
# the window.
WINDOW = "{}/ramp.vti --size 150 --script {}/close.txt"
# Right options that need a window, combined into one run.
OPEN = f"{WINDOW} --device virtual --setup {{}}/own.json --measurements {{}}/paths.csv --movie {{}}/movie.ogv --cut box"
REPLAY = f"{WINDOW} --replay {{}}/touch.vtp"
HEARD = "{}/ramp.vti --sound {}/touch.wav --method proxy"
RAMP_MHD = "{}/ramp.mhd --large"
# VTK before 9.4 can't read polyhedra that later versions write.
POLYHEDRA = (("{}/polyhedra.vtu", "write it as tetrahedra", ("{}/grid.vtu", )),)
OLD = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) < (9, 4)
COMMANDS = (
    ("{}/ramp.vti --script {}/close.txt --bogus", "--bogus: is not an option", ()),
    ("{}/ramp.vti --script {}/close.txt --size", "--size: needs a value", ()),
    ("{}/text.vti", "check what the file really is", ("{}/ramp.vti", )),
    ("{}/text.dcm", "give a DICOM slice, or the folder of its series", ("{}/series/0.dcm", "{}/series")),
    ("{}/notes.txt", "convert it to one of these: ", ("{}/ramp.vti", )),
    ("{}/empty.nrrd", "copy or download it again", ("{}/ramp.nhdr", )),
    ("{}/novoxels.vti", "export the volume again", ("{}/ramp.vti", )),
    ("{}/slice.vti", "export the whole series as one three-dimensional image", ("{}/ramp.vti", )),
    ("{}/thin.vti", "export more slices", ("{}/ramp.vti", )),
    ("{}/flat.vti", "correct the spacing in the file's header", ("{}/ramp.vti", )),
    ("{}/singular.vti", "correct it in the file's header", ("{}/ramp.vti", )),
    ("{}/bare.vti", "write the file with a point-data array of numbers", ("{}/ramp.vti", )),
    ("{}/nan.vti", "check the export, in particular its rescale slope and window", ("{}/ramp.vti", )),
    ("{}/damaged.vtu", "check what the file really is, export it again, and check that the copy is complete", ("{}/grid.vtu", )),
    ("{}/points.vtu", "write grids of three-dimensional cells, such as hexahedra and tetrahedra", ("{}/grid.vtu", )),
    *(POLYHEDRA if OLD else ()),
    ("{}/ramp.vti --series 2", "has one volume only, which needs no number", ("{}/ramp.vti", )),
    ("{}/ramp.vti --labels {}/text.seg.nrrd", "…choose another file", (f"{{}}/ramp.vti {LABELLED}", )),
    ("{}/ramp.vti --labels {}/labels.vti --materials {}/wrong.csv", "--materials …choose another file",
     (f"{{}}/ramp.vti {LABELLED}", )),
    ("{}/ramp.vti --labels {}/grid.vtu", "write the labels as an image", (f"{{}}/ramp.vti {LABELLED}", )),
    ("{}/cut.zarr", "can't be read (…)…copy it again, and check that the copy is complete", ("{}/ramp.zarr", )),
    ("{}/none.vtkhdf", "check the spelling", (RAMP_MHD, )),
    ("{}/untimed.pvd", "write it again, with <DataSet timestep=", ("{}/moves.pvd", )),
    ("{}/other.pvd", "choose the files themselves, or their folder", ("{}/ramp.vti", "{}/frames")),
    ("{}/twice.pvd", "give it one image (.vti) for each", ("{}/moves.pvd", )),
    (f"{RAMP_MHD} --array V", "is for volumes in memory…leave it out", (RAMP_MHD, )),
    ("{}/ramp.vti --displacements motion", "give all of its frames", ("{}/moved.pvd --displacements motion", )),
    (f"{RAMP_MHD} --live", "leave out --live", (RAMP_MHD, )),
    ("{}/ramp.vti --sound", "Cure: give a file, as in --sound touch.wav", (HEARD, )),
    ("{}/ramp.vti --sound={}/touch.mp3", "use one that ends in .wav", (HEARD, )),
    ("{}/ramp.vti --sound {}/none/touch.wav", "the folder exists, and you may write to it", (HEARD, )),
    ("{}/ramp.vti --write-volume {}/none/copy.vti", "the folder exists, and you may write to it", ("{}/ramp.vti --write-volume {}/copy.vti", )),
    ("{}/ramp.vti --method feel", "…use one of: …", (HEARD, )),
    ("", "give a volume file or a DICOM folder", ("{}/ramp.vti", )),
    ("{}/ramp.vti --guide {}/wrong.csv", "give a file saved with Ctrl+S in the window", ("{}/ramp.vti --guide {}/paths.csv", )),
    ("{}/ramp.vti --mode Find%a%vortex", "--mode '…'…use another mode", (f"{{}}/ramp.vti {GUIDED}", )),
    ("{}/flow.vti --mode vector-follow:still", "use another mode or array",
     ("{}/flow.vti --mode vector-follow:flow", )),
    ("{}/ramp.vti --mode surface:V", "leave out the array's name", (f"{{}}/ramp.vti {GUIDED}", )),
    ("{}/noise.vti --preset propose", "--preset propose…use another preset", ("{}/noise.vti --preset MRI", )),
    ("{}/unspaced", "export it again from its source, with its PixelSpacing", ("{}/series", )),
    ("{}/unplaced", "export it again from its source, with positions", ("{}/series", )),
    ("{}/ball.stl", "choose a volume; a surface can be a tool or a guide in it", (f"{{}}/ramp.vti {GUIDED}", )),
    ("{}/face.png", "choose the volume that it was made from", ("{}/ramp.vti", )),
    ("{}/ramp.vti --labels {}/series/0.dcm", "give it as the volume", ("{}/series", )),
    ("{}/cut.zarr --write-volume {}/copy.vti", "Check whether it is complete",
     ("{}/ramp.zarr --write-volume {}/copy.vti", )),
    ("{}/twofold", "put the slices of one volume into a folder of their own", ("{}/series", )),
    ("/", "choose the folder that has the slices", ("{}/series", )),
    ("{}/nothing", "choose a folder of DICOM slices, or a volume file", ("{}/series", "{}/ramp.vti")),
    ("{}/series --series 2", "has no series ", ("{}/series --series 1", )),
    ("{}/cutoff", "copy or export the series again, or remove that file", ("{}/series", )),
    (f"{WINDOW} --measurements {{}}/wrong.csv", "--measurements …correct it or choose another file", (OPEN, )),
    (f"{WINDOW} --replay {{}}/none.vtp", "give a .vtp written by key F10 or vtkHapticRecorder::Start()", (REPLAY, )),
    (f"{WINDOW} --replay {{}}/back.vtp", "record the touch again", (REPLAY, )),
    (f"{WINDOW} --device pen", "choose another device, or none; volumehaptics-device list shows those that can be used", (OPEN, REPLAY)),
    (f"{WINDOW.replace('ramp.vti', 'moves.pvd')} {TWO.replace('falcon', 'vibration:xr')}", "can be touched with one only…give one device", (OPEN, )),
    (f"{WINDOW} --setup {{}}/wrong.json", "--setup …correct it or choose another file", (OPEN, )),
    (f"{WINDOW} --setup {{}}/none/own.json", "can't be written…choose a file in a folder that you may write to", (OPEN, )),
    (f"{WINDOW.replace('close', 'point')} --measurements {{}}/none/list.csv", "--measurements …choose a file in a folder that you may write to",
     (OPEN, )),
    (f"{WINDOW} --movie {{}}/none/movie.ogv", "--movie …choose a file in a folder that you may write to", (OPEN, )),
    (f"{WINDOW.replace('ramp.vti', 'ramp.mhd')} --large --cut box", "use --cut plane, or leave out --large",
     (f"{WINDOW.replace('ramp.vti', 'ramp.mhd')} --large --cut plane", OPEN)),
    ("{}/ramp.vti --script {}/jump.txt", "Use move, stroke, wheel, key, press or release", (REPLAY, )),
    ("{}/ramp.vti --script {}/short.txt", "and a duration in seconds: stroke 0.7 0.5 1.5", (REPLAY, )),
    ("{}/ramp.vti --script {}/long.txt", "write one event a line", (REPLAY, )),
    ("{}/ramp.vti --script {}/none.txt", "--script …can't be read…check its path", (REPLAY, )),
    ("{}/bowl.vti", "turn it with --front and --up", ("{}/bowl.vti --front +y", "{}/bowl.vti --front +y --up -z")),
    ("{}/speck.vti", "or crop it closely to what you want to feel", ("{}/cropped.vti", )),
    ("{}/ramp.vti --preset CT%chest", "use another --preset, or press e in the window", (f"{{}}/ramp.vti {ALL}", )),
)


@pytest.mark.parametrize("wrong, words, rights", COMMANDS)
def test_cures_of_commands(shelf, explore, wrong, words, rights):
    told = explore(wrong)
    said = told.stderr + told.stdout
    assert all(part in said for part in words.split("…")), said
    assert told.returncode != 0 or wrong.endswith(("--sound", "chest"))
    for right in rights:
        expect_forces(shelf, explore, right)


def dicom(values, z, uid="1.2.3.1", series="1.2.3"):
    """Returns a slice as DICOM's parts 5 and 10 define it: a preamble, then explicit VR, little endian, in order of the
    tags."""
    def element(tag, kind, value):
        value = value if isinstance(value, bytes) else value.encode()
        value += (b"\0" if kind == "UI" else b" ") * (len(value) % 2)
        head = struct.pack("<HH", tag >> 16, tag & 0xffff) + kind.encode()
        return head + (struct.pack("<HI", 0, len(value)) if kind in ("OW", "OB") else struct.pack("<H", len(value))) + value

    sop, explicit = "1.2.840.10008.5.1.4.1.1.4", "1.2.840.10008.1.2.1"
    meta = (element(0x00020001, "OB", b"\0\1") + element(0x00020002, "UI", sop) + element(0x00020003, "UI", uid)
            + element(0x00020010, "UI", explicit))
    rows, columns = (struct.pack("<H", n) for n in values.shape)
    short = {number: struct.pack("<H", number) for number in (0, 1, 15, 16)}
    body = (element(0x00080016, "UI", sop) + element(0x00080018, "UI", uid) + element(0x00080060, "CS", "MR")
            + element(0x0020000d, "UI", "1.2") + element(0x0020000e, "UI", series) + element(0x00200013, "IS", "1")
            + element(0x00200032, "DS", f"0\\0\\{z}") + element(0x00200037, "DS", "1\\0\\0\\0\\1\\0")
            + element(0x00280002, "US", short[1]) + element(0x00280004, "CS", "MONOCHROME2") + element(0x00280010, "US", rows)
            + element(0x00280011, "US", columns) + element(0x00280030, "DS", "1\\1") + element(0x00280100, "US", short[16])
            + element(0x00280101, "US", short[16]) + element(0x00280102, "US", short[15])
            + element(0x00280103, "US", short[0]) + element(0x7fe00010, "OW", values.astype("<u2").tobytes()))
    return bytes(128) + b"DICM" + element(0x00020000, "UL", struct.pack("<I", len(meta))) + meta + body


def polyhedra():
    """Returns a cube in the form in which VTK 9.6.2's vtkXMLUnstructuredGridWriter writes a polyhedron."""
    def array(kind, name, numbers, components=1):
        return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">{numbers}'
                '</DataArray>')
    points = " ".join(f"{i % 2} {i // 2 % 2} {i // 4}" for i in range(8))
    faces = "0 2 3 1 2 6 7 3 6 4 5 7 4 0 1 5 2 0 4 6 1 3 7 5"
    return ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="2.3" byte_order="LittleEndian" '
            'header_type="UInt32"><UnstructuredGrid><Piece NumberOfPoints="8" NumberOfCells="1"><PointData Scalars="T">'
            + array("Float32", "T", "0 1 2 3 4 5 6 7") + "</PointData><Points>" + array("Float32", "Points", points, 3)
            + "</Points><Cells>" + array("Int64", "connectivity", "0 1 2 3 4 5 6 7") + array("Int64", "offsets", "8")
            + array("UInt8", "types", "42") + array("Int64", "face_connectivity", faces)
            + array("Int64", "face_offsets", "4 8 12 16 20 24") + array("Int64", "polyhedron_to_faces", "0 1 2 3 4 5")
            + array("Int64", "polyhedron_offsets", "6") + "</Cells></Piece></UnstructuredGrid></VTKFile>")


def write_image(path, one):
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(one)
    writer.Write()


def fill(folder, values):
    """Writes the files that the commands name."""
    for name in ("nothing", "frames", "series", "folders/one", "twofold", "cutoff", "unspaced", "unplaced"):
        (folder / name).mkdir(parents=True)
    texts = {
        "text.vti": "no image", "face.png": "a picture", "text.dcm": "no slice", "text.seg.nrrd": "not a segmentation", "notes.txt": "some notes", "empty.nrrd": "",
        "wrong.csv": "label,stiffness\n1,hard\n", "wrong.json": '{"Format": "other"}', "close.txt": "0.2 key q\n", "point.txt": "0.3 move 0.5 0.5\n0.4 key t\n0.6 wheel 8\n1.2 key 1\n1.4 key q\n",
        "jump.txt": "1 jump\n", "short.txt": "1 stroke 0.5 0.5\n", "long.txt": "1 key t now\n",
        "polyhedra.vtu": polyhedra(),
        "damaged.vtu": '<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid">\n<Unstr',
        "untimed.pvd": pvd('<DataSet file="ramp.vti"/>'), "other.pvd": "no collection",
        "twice.pvd": pvd('<DataSet timestep="0" part="0" file="ramp.vti"/>', '<DataSet timestep="0" part="1" file="ramp.vti"/>'),
        "moves.pvd": pvd(*(f'<DataSet timestep="{i}" file="ramp.vti"/>' for i in (0, 1))),
        "moved.pvd": pvd(*(f'<DataSet timestep="{i}" file="flow.vti"/>' for i in (0, 1))),
    }
    for name, text in texts.items():
        (folder / name).write_text(text)
    values.astype("<f4").tofile(folder / "ramp.raw")
    sizes = " ".join(map(str, values.shape[::-1]))
    (folder / "ramp.mhd").write_text(f"NDims = 3\nDimSize = {sizes}\nElementType = MET_FLOAT\nElementDataFile = ramp.raw\n")
    (folder / "cut.mhd").write_text(f"NDims = 3\nDimSize = {sizes}0\nElementType = MET_FLOAT\nElementDataFile = ramp.raw\n")
    (folder / "ramp.nhdr").write_text(f"NRRD0004\ntype: float\ndimension: 3\nsizes: {sizes}\nencoding: raw\nendian: little\n"
                                      "data file: ramp.raw\n\n")
    for name, samples in (("ramp", values.astype("<f4").tobytes()), ("cut", b"cut")):
        (folder / f"{name}.zarr").mkdir()
        (folder / f"{name}.zarr" / ".zarray").write_text(json.dumps({
            "zarr_format": 2, "shape": values.shape, "chunks": values.shape, "dtype": "<f4", "compressor": None,
            "fill_value": 0, "order": "C", "filters": None}))
        (folder / f"{name}.zarr" / "0.0.0").write_bytes(samples)
    for number, plane in enumerate(values):
        one = dicom(plane.clip(0, 65535), number, f"1.2.3.{number + 1}")
        for place in ("series", "folders/one", "cutoff", "twofold"):
            (folder / place / f"{number}.dcm").write_bytes(one)
        (folder / "unspaced" / f"{number}.dcm").write_bytes(one.replace(struct.pack("<HH", 0x28, 0x30), struct.pack("<HH", 0x28, 0x2f)))
        (folder / "unplaced" / f"{number}.dcm").write_bytes(one.replace(struct.pack("<HH", 0x20, 0x32), struct.pack("<HH", 0x20, 0x31)))
    (folder / "cutoff" / "7.dcm").write_bytes((folder / "series" / "7.dcm").read_bytes()[:-200])
    (folder / "twofold" / "more.dcm").write_bytes(dicom(values[3].clip(0, 65535), 3, "1.2.3.99"))
    for name, one in {
            "bowl": bowl(), "speck": speck(), "cropped": speck()[20:41, 20:41, 20:41],
            "slice": values[:1], "thin": values[:3], "nan": np.full(values.shape, np.nan),
            "noise": np.random.default_rng(2).normal(0.0, 30.0, values.shape)}.items():
        write_image(folder / f"{name}.vti", image(np.ascontiguousarray(one)))
    for name, place in (("flat", dict(spacing=(1, 0, 1))), ("singular", {}), ("flow", {}), ("bare", {}), ("novoxels", {})):
        one = vtkImageData()
        one.DeepCopy(image(values))
        if name == "flat":
            one.SetSpacing(1, 0, 1)
        if name == "singular":
            one.SetDirectionMatrix(1, 0, 0, 1, 0, 0, 0, 0, 1)
        if name == "bare":
            one.GetPointData().Initialize()
        if name == "novoxels":
            one = vtkImageData()
        if name == "flow":
            for array, vector in (("flow", (1.0, 0.0, 0.0)), ("still", (0.0, 0.0, 0.0)), ("motion", (0.0, 0.0, 0.1))):
                added = numpy_to_vtk(np.tile(vector, (values.size, 1)) * (1.0 + np.arange(values.size).reshape(-1, 1) % 7), deep=True)
                added.SetName(array)
                one.GetPointData().AddArray(added)
        write_image(folder / f"{name}.vti", one)
    for number in range(3):
        write_image(folder / "frames" / f"{number}.vti", image(values))
    grid, cells = vtkAppendFilter(), vtkXMLUnstructuredGridWriter()
    grid.AddInputData(image(values))
    cells.SetInputConnection(grid.GetOutputPort())
    cells.SetFileName(str(folder / "grid.vtu"))
    cells.Write()
    points = vtkUnstructuredGrid()
    points.SetPoints(grid.GetOutput().GetPoints())
    points.GetPointData().ShallowCopy(grid.GetOutput().GetPointData())
    cells.SetInputData(points)
    cells.SetFileName(str(folder / "points.vtu"))
    cells.Write()
    measured = vtkHapticMeasurements()
    measured.AddMeasurement(measured.PATH, line_to(20.0))
    measured.WriteFile(str(folder / "paths.csv"))
    device = recorder()
    assert device.GetRecorder().Start(str(folder / "touch.vtp"))
    wait(device, 100)
    assert device.GetRecorder().Stop()
    device.Close()
    reader, writer, back = vtkXMLPolyDataReader(), vtkXMLPolyDataWriter(), vtkPolyData()
    reader.SetFileName(str(folder / "touch.vtp"))
    reader.Update()
    back.DeepCopy(reader.GetOutput())
    back.GetPointData().GetArray("Time").Fill(1.0)
    writer.SetInputData(back)
    writer.SetFileName(str(folder / "back.vtp"))
    writer.Write()


def bowl():
    """Returns a bowl that opens towards the camera (38 degrees to the left of -y and 20 degrees above): between the
    camera and the bowl's middle there is only air."""
    left, above = np.radians((38.0, 20.0))
    toward = np.array([np.cos(above) * np.sin(left), -np.cos(above) * np.cos(left), np.sin(above)])
    z, y, x = np.mgrid[0:60, 0:60, 0:60].astype(float)
    from_middle = np.stack([x, y, z], -1) - 29.5 - 59.375 * toward
    radius = np.linalg.norm(from_middle, axis=-1)
    is_in = (radius > 60.0) & (radius < 65.0) & (from_middle @ -toward > np.cos(np.radians(25.0)) * radius)
    return 1000.0 * is_in + np.random.default_rng(4).normal(0.0, 0.3, x.shape)


def speck():
    """Returns a ball of 3 mm in air: seen from any side, it is less than 4 mm thick from its surface to its middle."""
    z, y, x = np.mgrid[0:60, 0:60, 0:60] - 30.0
    inside = np.clip(3.0 - np.sqrt(x * x + y * y + z * z), 0.0, 1.0)
    return 1000.0 * inside + np.random.default_rng(4).normal(0.0, 0.3, x.shape)


def pvd(*entries):
    return '<VTKFile type="Collection" version="0.1"><Collection>' + "".join(entries) + "</Collection></VTKFile>"


def test_cure_of_no_display(shelf, explore):
    """Runs 'xvfb-run -a volumehaptics-explore ...' as the error text writes it."""
    bare = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    command = [explore.program, str(shelf / "ramp.vti"), "--size", "100", "--pictures", str(shelf / "own")]
    told = subprocess.run(command, capture_output=True, text=True, env=bare)
    assert told.returncode == 3 and "Cure: run the program as 'xvfb-run -a volumehaptics-explore ...'" in told.stderr
    cured = subprocess.run(["xvfb-run", "-a", *command], capture_output=True, text=True, env=bare)
    assert cured.returncode == 0 and (shelf / "own" / "summary.txt").stat().st_size > 0
