# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes small files of the cases as seeds of the fuzzer, a folder for each target of Testing/Fuzz: seeds.py FOLDER."""

import sys
import tempfile
from pathlib import Path

import phantom

SIZE = 6  # voxels along each axis; the writers' default is about 42
_init = phantom.Grid.__init__


def _make_small(self, size=(SIZE, SIZE, SIZE), **options):
    _init(self, [max(1, min(SIZE, n)) for n in size], **options)


phantom.Grid.__init__ = _make_small

import write_brain  # noqa: E402, F401 the writers register their cases
import write_codecs  # noqa: E402, F401
import write_dicom  # noqa: E402, F401
import write_images  # noqa: E402, F401
import write_nifti  # noqa: E402, F401
import write_odd  # noqa: E402, F401
import write_threads  # noqa: E402, F401
from cases import CASES  # noqa: E402

TARGETS = {"dicom": "TouchDicom", "nifti": "TouchNifti", "analyze": "TouchNifti", "nrrd": "TouchNrrd", "metaimage": "TouchMetaImage",
           "tiff": "TouchTiff", "zarr": "TouchZarr", "vti": "TouchVti", "vtkhdf": "TouchHdf", "mgh": "TouchBrain", "minc": "TouchBrain"}
LARGEST = 60000  # bytes


def pack(folder):
    """Packs a folder into one buffer: see Testing/Fuzz/TouchFiles.h."""
    packed = b"PACK"
    for file in sorted(folder.rglob("*")):
        if file.is_file() and file.stat().st_size < 1 << 16:
            name, data = str(file.relative_to(folder)).encode(), file.read_bytes()
            packed += bytes([len(name)]) + name + len(data).to_bytes(2, "little") + data
    return packed


def target_of(case, named):
    ending = "".join(named.suffixes[-2:]).lower()
    by_ending = {".mha": "TouchMetaImage", ".mhd": "TouchMetaImage", ".nrrd": "TouchNrrd", ".nhdr": "TouchNrrd", ".vti": "TouchVti",
                 ".zarr": "TouchZarr", ".tif": "TouchTiff", ".tiff": "TouchTiff", ".vtkhdf": "TouchHdf", ".mgh": "TouchBrain", ".mgz": "TouchBrain",
                 ".mnc": "TouchBrain", ".nii": "TouchNifti",
                 ".nii.gz": "TouchNifti", ".hdr": "TouchNifti", ".img": "TouchNifti"}
    found = [by_ending[one] for one in (ending, named.suffix.lower()) if one in by_ending]
    return (found or [TARGETS.get(case.name.split("-")[0], "TouchDicom")])[0]


folder = Path(sys.argv[1]).resolve()
written = 0
for case in CASES:
    with tempfile.TemporaryDirectory() as place:
        try:
            named = Path(case.write(Path(place)))
        except Exception:  # noqa: BLE001 some writers count on the size of the phantom
            continue
        only = named.is_file() and sum(1 for one in Path(place).rglob("*") if one.is_file()) == 1
        seed = named.read_bytes() if only else pack(named if named.is_dir() else named.parent)
        if len(seed) <= LARGEST:
            into = folder / target_of(case, named)
            into.mkdir(parents=True, exist_ok=True)
            (into / case.name).write_bytes(seed)
            written += 1
# Grids, images and tables in VTK's file formats. The first byte selects the file's extension.
FRAME = '<?xml version="1.0"?><VTKFile type="{0}" version="0.1" byte_order="LittleEndian"><{0}{1}</{0}></VTKFile>'
NUMBERS = '<DataArray type="Float32" Name="v" format="ascii"{}>{}</DataArray>'
PLACES = " ".join(f"{i & 1} {i >> 1 & 1} {i >> 2}" for i in range(8))
VALUES = "<PointData Scalars='v'>" + NUMBERS.format("", "0 1 2 3 4 5 6 7") + "</PointData>"
POINTS = "<Points>" + NUMBERS.format(' NumberOfComponents="3"', PLACES) + "</Points>"
CELL = "<Cells>" + "".join(f'<DataArray type="{kind}" Name="{name}" format="ascii">{text}</DataArray>' for kind, name, text in (
    ("Int32", "connectivity", "0 1 2 3 4 5 6 7"), ("Int32", "offsets", "8"), ("UInt8", "types", "11"))) + "</Cells>"
EXTENT = "0 1 0 1 0 1"
GRIDS = {
    b"\0": "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n" + PLACES
            + "\nCELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n11\nPOINT_DATA 8\nSCALARS v float 1\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7\n",
    b"\1": FRAME.format("UnstructuredGrid", '><Piece NumberOfPoints="8" NumberOfCells="1">' + VALUES + POINTS + CELL + "</Piece>"),
    b"\2": FRAME.format("RectilinearGrid", f' WholeExtent="{EXTENT}"><Piece Extent="{EXTENT}">' + VALUES + "<Coordinates>"
                        + 3 * NUMBERS.format("", "0 1") + "</Coordinates></Piece>"),
    b"\3": FRAME.format("StructuredGrid", f' WholeExtent="{EXTENT}"><Piece Extent="{EXTENT}">' + VALUES + POINTS + "</Piece>"),
}
IMAGE = FRAME.format("ImageData", ' WholeExtent="0 4 0 4 0 4" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 4 0 4 0 4">'
                     + VALUES.replace("0 1 2 3 4 5 6 7", " ".join(map(str, range(125)))) + "</Piece>")
TABLES = {b"\0": "label,name\n1,liver\n", b"\1": '1 255 0 0 1 1 1 "liver"\n', b"\2": "1 liver 255 0 0 0\n"}
for target, texts in (("TouchGrid", GRIDS), ("TouchVti", {b"": IMAGE}), ("TouchLabelFile", TABLES)):
    (folder / target).mkdir(parents=True, exist_ok=True)
    for number, (choice, text) in enumerate(texts.items()):
        (folder / target / f"text{number}").write_bytes(choice + text.encode())
print(written, "seeds")
