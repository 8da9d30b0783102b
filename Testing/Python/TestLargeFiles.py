# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that describe their own volume: vtkHapticRegionSource reads what their own libraries wrote. VTKHDF is written
by HDF5's own library after VTK's specification, and read by VTK's own reader for comparison; Zarr is written by
zarr, its version 3 by hand after the specification.
"""

import ctypes
import ctypes.util
import gzip
import itertools
import json
import os
import re
import signal
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest
from TestExplorerCures import dicom
from volumehaptics import _files, image, open_large, touch, vtkHapticRegionSource, vtkHapticVolumeReader
from volumehaptics._touch import Errors
from volumehaptics.arrays import arrays
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageReader

EXTENT = (2, 21, -3, 8, 5, 22)  # 20 x 12 x 18
SHAPE = (18, 12, 20)
SPACING = (0.5, 1.0, 1.5)
ORIGIN = (-3.0, 4.0, 5.0)
EARLIEST, LATEST = 0, 2  # versions of the format, as numbers of HDF5 1.10

ids = ctypes.c_int64


class Hdf5:
    """The part of HDF5's C interface that is needed to write an image file."""

    def __init__(self):
        name = ctypes.util.find_library("hdf5_serial") or ctypes.util.find_library("hdf5")
        assert name, "the tests need HDF5's library, which VTK's vtkIOHDF brings along"
        self.hdf5 = ctypes.CDLL(name)
        assert self.hdf5.H5open() >= 0

    def __getattr__(self, name):
        function = getattr(self.hdf5, "H5" + name)
        function.restype = ids

        def call(*values):
            plain = [ids(value) if isinstance(value, int) else value for value in values]
            result = function(*plain)
            assert result >= 0, name
            return result
        return call

    def known(self, name):
        return ids.in_dll(self.hdf5, f"H5{name}_g").value

    def sizes(self, numbers):
        return (ctypes.c_uint64 * len(numbers))(*numbers)


@pytest.fixture(scope="module")
def hdf5():
    return Hdf5()


STORED = {"int8": "STD_I8LE", "uint8": "STD_U8LE", "int16": "STD_I16LE", "uint16": "STD_U16LE", "int32": "STD_I32LE",
          "uint32": "STD_U32LE", "int64": "STD_I64LE", "uint64": "STD_U64LE", "float32": "IEEE_F32LE",
          "float64": "IEEE_F64LE", ">i2": "STD_I16BE", ">f4": "IEEE_F32BE", ">f8": "IEEE_F64BE"}


def write_attribute(h, where, name, values):
    if isinstance(values, str):
        kind = h.Tcopy(h.known("T_C_S1"))
        h.Tset_size(kind, len(values))
        space, data = h.Screate(0), values.encode()
    else:
        whole = all(isinstance(value, int) for value in values)
        kind = h.known("T_NATIVE_INT64" if whole else "T_NATIVE_DOUBLE")
        data = np.array(values, np.int64 if whole else float).tobytes()
        space = h.Screate_simple(1, h.sizes([len(values)]), None)
    attribute = h.Acreate2(where, name.encode(), kind, space, 0, 0)
    h.Awrite(attribute, kind, data)
    for close, one in ((h.Aclose, attribute), (h.Sclose, space)):
        close(one)


def write_array(h, where, name, array, chunk=None, filters=(), early=False, empty=None, most=None):
    stored = h.known("T_" + STORED[array.dtype.name if array.dtype.isnative else array.dtype.str])
    options = h.Pcreate(h.known("P_CLS_DATASET_CREATE_ID"))
    if chunk:
        h.Pset_chunk(options, len(chunk), h.sizes(chunk))
    for one, *values in filters:
        getattr(h, "Pset_" + one)(options, *values)
    if early:
        h.Pset_alloc_time(options, 1)
    if empty is not None:
        h.Pset_fill_value(options, stored, np.array(empty, array.dtype).tobytes())
    space = h.Screate_simple(array.ndim, h.sizes(array.shape), most and h.sizes(most))
    data = h.Dcreate2(where, name.encode(), stored, space, 0, options, 0)
    if empty is None:
        h.Dwrite(data, stored, 0, 0, 0, np.ascontiguousarray(array).tobytes())
    for close, one in ((h.Dclose, data), (h.Sclose, space), (h.Pclose, options)):
        close(one)


def write_vtkhdf(h, path, array, version=EARLIEST, before=0, kind="ImageData", extent=EXTENT, names=("density",),
                 **layout):
    access = h.Pcreate(h.known("P_CLS_FILE_ACCESS_ID"))
    h.Pset_libver_bounds(access, version, LATEST)
    creation = h.Pcreate(h.known("P_CLS_FILE_CREATE_ID"))
    h.Pset_userblock(creation, before)
    file = h.Fcreate(str(path).encode(), 2, creation, access)
    group = h.Gcreate2(file, b"VTKHDF", 0, 0, 0)
    write_attribute(h, group, "Version", [1, 0])
    write_attribute(h, group, "Type", kind)
    write_attribute(h, group, "WholeExtent", list(extent))
    write_attribute(h, group, "Origin", list(ORIGIN))
    write_attribute(h, group, "Spacing", list(SPACING))
    write_attribute(h, group, "Direction", [0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0])
    points = h.Gcreate2(group, b"PointData", 0, 0, 0)
    write_attribute(h, points, "Scalars", names[-1])
    for name in names:
        write_array(h, points, name, array if name == names[-1] else np.zeros_like(array), **layout)
    for close, one in ((h.Gclose, points), (h.Gclose, group), (h.Fclose, file), (h.Pclose, access),
                       (h.Pclose, creation)):
        close(one)
    return path


def make_array(dtype="int16", shape=SHAPE):
    return np.random.default_rng(3).integers(0, 127, shape).astype(dtype)


def region_of(source, extent):
    region = vtkImageData()
    assert source.ReadRegion(extent, region)
    sizes = [b - a + 1 for a, b in zip(extent[::2], extent[1::2])]
    return vtk_to_numpy(region.GetPointData().GetScalars()).reshape(sizes[::-1])


def expect_samples(path, array):
    source = vtkHapticRegionSource()
    assert source.OpenFile(str(path))
    first = source.GetWholeExtent()[::2]
    whole = [(0, size - 1) for size in array.shape[::-1]]
    for part in (whole, [(3, 9), (2, 2), (7, 17)], [(0, 0), (11, 11), (0, 3)], [(15, 19), (0, 11), (8, 8)]):
        extent = [f + bound for f, bounds in zip(first, part) for bound in bounds]
        (x0, x1), (y0, y1), (z0, z1) = part
        assert np.array_equal(region_of(source, extent), array[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1])
    return source


def error_of(path):
    source = vtkHapticRegionSource()
    with Errors(source) as errors:
        assert not source.OpenFile(str(path))
    assert len(errors) == 1
    assert source.GetWholeExtent() == (0, -1, 0, -1, 0, -1)
    return errors[0]


@pytest.mark.parametrize("dtype", STORED)
def test_vtkhdf_of_all_types(hdf5, tmp_path, dtype):
    array = make_array(dtype)
    source = expect_samples(write_vtkhdf(hdf5, tmp_path / "a.vtkhdf", array), array)
    assert (source.GetWholeExtent(), source.GetSpacing(), source.GetOrigin()) == (EXTENT, SPACING, ORIGIN)
    assert source.GetDirection() == (0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0)


GZIP, SHUFFLE, SUM = ("deflate", 6), ("shuffle",), ("fletcher32",)
ENDLESS = -1
LAYOUTS = {
    "newest": dict(version=LATEST), "behind a header": dict(before=2048), "several": dict(names=("a", "b", "c")),
    "many": dict(names=tuple(f"array{i}" for i in range(60))),
    "chunks": dict(chunk=(5, 4, 7)), "one chunk": dict(chunk=SHAPE, version=LATEST),
    "one packed chunk": dict(chunk=SHAPE, version=LATEST, filters=[SHUFFLE, GZIP]),
    "chunks in order": dict(chunk=(5, 4, 7), version=LATEST, early=True),
    "many chunks": dict(chunk=(1, 2, 3)),
    "fixed array": dict(chunk=(5, 4, 7), version=LATEST), "fixed pages": dict(chunk=(1, 1, 3), version=LATEST),
    "packed fixed array": dict(chunk=(5, 4, 7), version=LATEST, filters=[GZIP], most=(30, 40, 50)),
    "extensible": dict(chunk=(1, 1, 3), version=LATEST, most=(ENDLESS, 12, 20)),
    "packed extensible": dict(chunk=(2, 2, 3), version=LATEST, most=(18, 30, ENDLESS), filters=[SHUFFLE, GZIP]),
    "extensible in the middle": dict(chunk=(2, 1, 3), version=LATEST, most=(25, ENDLESS, 20)),
    "several extensible": dict(chunk=(5, 4, 7), version=LATEST, most=(ENDLESS, ENDLESS, 20)),
    "many, newest": dict(version=LATEST, names=tuple(f"array{i}" for i in range(60))),
    "packed": dict(chunk=(5, 4, 7), filters=[GZIP]), "all filters": dict(chunk=(8, 8, 8), filters=[SHUFFLE, GZIP, SUM]),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_vtkhdf_is_read_as_vtk_reads_it(hdf5, tmp_path, layout):
    array = make_array()
    extent = (0, 19, 0, 11, 0, 17)  # VTK 9.1 needs an extent that begins at 0
    path = write_vtkhdf(hdf5, tmp_path / "a.vtkhdf", array, extent=extent, **LAYOUTS[layout])
    source = expect_samples(path, array)
    vtk = pytest.importorskip("vtkmodules.vtkIOHDF")
    reader = vtk.vtkHDFReader()
    reader.SetFileName(str(path))
    reader.Update()
    read = reader.GetOutput()
    name = LAYOUTS[layout].get("names", ("density",))[-1]
    assert np.array_equal(vtk_to_numpy(read.GetPointData().GetArray(name)), array.ravel())
    assert (read.GetExtent(), read.GetSpacing(), read.GetOrigin()) == (extent, SPACING, ORIGIN)
    assert source.GetScalarType() == read.GetPointData().GetArray(name).GetDataType()


def test_chunks_that_were_never_written_have_the_fill_value(hdf5, tmp_path):
    array = np.full(SHAPE, 77, np.int16)
    expect_samples(write_vtkhdf(hdf5, tmp_path / "a.vtkhdf", array, chunk=(5, 4, 7), empty=77), array)


def test_vtkhdf_of_so_many_chunks_that_their_lists_have_pages(hdf5, tmp_path):
    array = make_array("uint8", (140000, 1, 1))
    path = write_vtkhdf(hdf5, tmp_path / "a.vtkhdf", array, extent=(0, 0, 0, 0, 0, 139999), chunk=(1, 1, 1),
                        version=LATEST, most=(ENDLESS, 1, 1))
    source = vtkHapticRegionSource()
    assert source.OpenFile(str(path))
    for first in (0, 131000, 139900):
        assert np.array_equal(region_of(source, (0, 0, 0, 0, first, first + 90)), array[first:first + 91])


def test_vtkhdf_is_felt_as_its_array(hdf5, tmp_path):
    z, y, x = np.meshgrid(*map(np.arange, (60, 50, 70)), indexing="ij", sparse=True)
    bed = np.round(1000 / (1 + np.exp(z - 30 - 3 * np.sin(0.2 * x) + 0.1 * y))).astype(np.int16)
    tip = [(8 + 0.05 * t, 25, 31 + 2 * np.sin(0.03 * t)) for t in range(900)]
    path = write_vtkhdf(hdf5, tmp_path / "a.vtkhdf", bed, extent=(0, 69, 0, 49, 0, 59), chunk=(16, 16, 16),
                        filters=[SHUFFLE, GZIP])
    source = open_large(path, spacing=(1, 1, 1), origin=(0, 0, 0))
    source.SetDirection((1, 0, 0, 0, 1, 0, 0, 0, 1))
    whole, large = (arrays(touch(volume, tip, iso_value=500)) for volume in (image(bed), source))
    assert abs(whole["Force"]).max() > 0.1
    for name in whole:
        assert np.array_equal(whole[name], large[name], equal_nan=True), name


def test_vtkhdf_that_is_not_read_is_told_with_the_cure(hdf5, tmp_path):
    array = make_array()
    path = tmp_path / "a.vtkhdf"

    def told(array=array, **how):
        return error_of(write_vtkhdf(hdf5, path, array, **how))
    assert "of an image" in told(kind="UnstructuredGrid")
    assert "18 x 12 x 20" in told(extent=(0, 3, 0, 3, 0, 3))
    assert "components" in told(array[..., None] + np.zeros(3, np.int16))
    assert "16777216 chunks" in told(np.zeros((300, 300, 300), np.uint8), chunk=(1, 1, 1), empty=7,
                                     extent=(0, 299, 0, 299, 0, 299))
    assert "filter 6" in told(chunk=(5, 4, 7), filters=[("scaleoffset", 2, 0)])
    path.write_bytes(b"no HDF5" * 1000)
    assert "no HDF5 file" in error_of(path)
    path.write_bytes(b"")
    assert "no HDF5 file" in error_of(path)
    with pytest.raises(ValueError, match="no HDF5 file"):
        open_large(path)
    assert "No such file" in error_of(tmp_path / "b.vtkhdf")
    assert "its ending is not known" in error_of(tmp_path / "b.abc")


@pytest.mark.parametrize("how", [{}, {"version": LATEST}, {"version": LATEST, "most": (ENDLESS, 12, 20)}],
                         ids=["tree", "fixed", "extensible"])
def test_a_damaged_vtkhdf_ends_nothing(hdf5, tmp_path, how):
    """Whichever byte is wrong, and wherever the file ends, the source returns samples or one error."""
    good = write_vtkhdf(hdf5, tmp_path / "good.vtkhdf", make_array(), chunk=(9, 6, 10), filters=[SHUFFLE, GZIP], **how)
    good = good.read_bytes()
    assert len(good) < 40000
    chance = np.random.default_rng(5)
    path = tmp_path / "a.vtkhdf"
    results = {True: 0, False: 0}
    ends = [good[:end] for end in chance.integers(0, len(good), 60)]
    for flipped in itertools.chain(ends, range(900)):
        if isinstance(flipped, int):
            changed = bytearray(good)
            for place in chance.integers(0, len(good) // 2, 3):
                changed[place] = chance.integers(0, 256)
            flipped = bytes(changed)
        path.write_bytes(flipped)
        source = vtkHapticRegionSource()
        source.AddObserver("ErrorEvent", lambda *_: None)
        opened = bool(source.OpenFile(str(path)))
        results[opened] += 1
        if opened:
            region = vtkImageData()
            region.AddObserver("ErrorEvent", lambda *_: None)
            source.ReadRegion((2, 9, -3, 3, 5, 20), region)
    assert min(results.values()) > 50


GRID = """# vtk DataFile Version 3.0
grid
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 8 float
0 0 0 1 0 0 0 1 0 0 0 1 1 1 0 1 0 1 0 1 1 1 1 1
CELLS 2 10
4 0 1 2 3
4 7 4 5 {point}
CELL_TYPES 2
10 {kind}
POINT_DATA 8
SCALARS density float 1
LOOKUP_TABLE default
1 2 3 4 5 6 7 8
"""


@pytest.mark.parametrize("point, kind", [(999999999, 10), (-999999999, 10), (6, 12)], ids=["far", "before", "corners"])
def test_a_grid_that_ends_its_reader_ends_nothing(tmp_path, point, kind):
    """VTK's filters read at points and cell corners that the grid does not have."""
    path, good = tmp_path / "a.vtk", tmp_path / "good.vtk"
    path.write_text(GRID.format(point=point, kind=kind))
    good.write_text(GRID.format(point=6, kind=10))
    for _ in range(2):
        with pytest.raises(ValueError, match="(?s)legacy VTK .its reader ended.*Cure: check what the file really is"):
            _files.read(path)
        read, _ = _files.read(good)
        assert 1.0 <= read.GetScalarRange()[0] < read.GetScalarRange()[1] <= 8.0


def test_a_grid_that_asks_for_much_memory_is_refused(tmp_path):
    """A file of 300 bytes declares cells with 5,000,000,000 numbers, which take 40 GB."""
    path = tmp_path / "a.vtk"
    path.write_text(GRID.format(point=6, kind=10).replace("CELLS 2 10", "CELLS 2 5000000000"))

    before = most_memory()
    with pytest.raises(ValueError, match="legacy VTK"):
        _files.read(path)
    assert most_memory() - before < 2 << 20


def helpers():
    """Returns the ids of the processes that read files for this process."""
    children = [one for task in Path("/proc/self/task").glob("*/children") for one in task.read_text().split()]
    return [int(one) for one in children if Path(f"/proc/{one}/comm").read_text().startswith("volumehaptics-r")]


def test_a_reader_that_was_ended_is_started_again(tmp_path):
    """VTK's reader would crash this process as it crashes the reading process."""
    path = tmp_path / "a.vtk"
    path.write_text(GRID.format(point=999999999, kind=10))
    for _ in range(3):
        with pytest.raises(ValueError, match="its reader ended"):
            _files.read(path)
        running = helpers()
        assert len(running) == 1
        os.kill(running[0], signal.SIGKILL)


def test_names_of_components_reach_the_list(tmp_path):
    """The names come from the reading process. The first component is uniform, so the cure names another component."""
    path = tmp_path / "a.vtk"
    path.write_text("""# vtk DataFile Version 4.2
components
ASCII
DATASET STRUCTURED_POINTS
DIMENSIONS 6 6 6
SPACING 1 1 1
ORIGIN 0 0 0
POINT_DATA 216
SCALARS flow double 2
LOOKUP_TABLE default
""" + "\n".join(f"7 {number}" for number in range(216)) + """
METADATA
COMPONENT_NAMES
pressure
speed

""")
    reader = vtkHapticVolumeReader()
    reader.SetFileName(str(path))
    with Errors(reader) as errors:
        reader.Update()
    assert "use another of the 2 that it has, such as --series 2 (Series = 2)" in errors[0], errors
    reader.SetSeries(2)
    reader.Update()
    assert reader.GetOutput().GetScalarRange() == (0.0, 215.0)
    assert [reader.GetSeriesName(i) for i in range(2)] == ["1 component 0 (pressure)", "2 component 1 (speed)"]


def damaged(good, chance, count):
    """Yields files that are cut off, and files with three wrong bytes, half of which are near the beginning."""
    for end in chance.integers(0, len(good), count // 6):
        yield good[:end]
    for number in range(count):
        changed = bytearray(good)
        for place in chance.integers(0, min(len(good), 400) if number % 2 else len(good), 3):
            changed[place] = chance.integers(0, 256)
        yield bytes(changed)


def expect_samples_or_an_error(damage):
    """Expects samples or an error from each file; `damage` writes one file after the other and yields its path."""
    results = {True: 0, False: 0}
    for path in damage:
        source = vtkHapticRegionSource()
        source.AddObserver("ErrorEvent", lambda *_: None)
        opened = bool(source.OpenWholeFile(str(path)))
        if opened:
            region = vtkImageData()
            region.AddObserver("ErrorEvent", lambda *_: None)
            opened = bool(source.ReadRegion((2, 9, 3, 8, 5, 20), region))
        results[opened] += 1
    assert min(results.values()) > 5, results


@pytest.mark.parametrize("encoding", ["raw", "gzip", "ascii"])
def test_a_damaged_nrrd_ends_nothing(tmp_path, encoding):
    array, path = make_array(), tmp_path / "a.nrrd"
    samples = {"raw": array.tobytes(), "gzip": gzip.compress(array.tobytes()),
               "ascii": " ".join(map(str, array.ravel())).encode()}[encoding]
    sizes = " ".join(map(str, array.shape[::-1]))
    good = (f"NRRD0005\ntype: short\ndimension: 4\nspace: right-anterior-superior\nsizes: {sizes} 1\nendian: little\n"
            f"encoding: {encoding}\nkinds: domain domain domain list\nspace units: \"um\" \"um\" \"um\"\n"
            "space directions: (1,0,0) (0,2,0) (0,0,3) none\nspace origin: (4,5,6)\n\n").encode() + samples

    def write():
        for one in damaged(good, np.random.default_rng(7), 600):
            path.write_bytes(one)
            yield path

    expect_samples_or_an_error(write())


@pytest.mark.parametrize("encoding", ["raw", "gzip", "ascii"])
@pytest.mark.parametrize("axis", range(4))
def test_a_volume_among_layers(tmp_path, encoding, axis):
    """Of a NRRD file with an axis of layers at any position, the first layer is felt, as numpy extracts it."""
    layers = np.moveaxis(np.random.default_rng(7).integers(-999, 999, (5, *SHAPE), "<i2"), 0, 3 - axis)
    first = np.ascontiguousarray(np.moveaxis(layers, 3 - axis, 0)[0])
    plain, kinds = np.ascontiguousarray(layers).tobytes(), ["domain"] * 3
    kinds.insert(axis, "list")
    sizes = " ".join(map(str, layers.shape[::-1]))
    path = tmp_path / "a.nrrd"
    path.write_bytes(f"NRRD0004\ntype: short\nendian: little\ndimension: 4\nsizes: {sizes}\nkinds: {' '.join(kinds)}\n"
                     f"encoding: {encoding}\n\n".encode()
                     + {"raw": plain, "gzip": gzip.compress(plain),
                        "ascii": " ".join(map(str, np.ascontiguousarray(layers).ravel())).encode()}[encoding])
    source, region = vtkHapticRegionSource(), vtkImageData()
    assert source.OpenWholeFile(str(path)) and source.ReadRegion((2, 9, 3, 8, 5, 12), region)
    assert np.array_equal(vtk_to_numpy(region.GetPointData().GetScalars()).reshape(8, 6, 8), first[5:13, 3:9, 2:10])


def test_layers_take_no_memory(tmp_path):
    """A file of half a megabyte has 2,000 layers that unpack to half a gigabyte; the volume needs a quarter of a
    megabyte."""
    path, noise = tmp_path / "a.seg.nrrd", np.random.default_rng(7).integers(0, 9, (64, 64, 64), "u1")
    layers = np.zeros((1000, 64, 64, 64), "u1")
    layers[0] = noise
    path.write_bytes(b"NRRD0004\ntype: uint8\ndimension: 4\nsizes: 64 64 64 2000\nkinds: domain domain domain list\n"
                     b"encoding: gzip\n\n" + gzip.compress(layers.tobytes())
                     + gzip.compress(bytes(layers.size)))
    program = """
import resource, sys
from volumehaptics import vtkHapticRegionSource
from vtkmodules.vtkCommonDataModel import vtkImageData
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
source, region = vtkHapticRegionSource(), vtkImageData()
assert source.OpenWholeFile(sys.argv[1]) and source.ReadRegion(source.GetWholeExtent(), region)
print(region.GetScalarRange(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""
    told = subprocess.run([sys.executable, "-c", program, path], check=True, capture_output=True, text=True).stdout
    assert told.startswith("(0.0, 8.0)") and int(told.split()[-1]) < 65536, told  # KiB


def test_many_elements_of_dicom_take_little_memory(tmp_path):
    """A header of 2.4 MB has 240,000 elements of 10 bytes (DICOM part 5, 7.1.2). Where each was kept, a header of 2.7 MB
    took 318 MB. The process that reads it keeps what the volume needs."""
    many = b"".join(struct.pack("<HH2sHH", 0x1001 + 2 * (i // 60000), 0x1000 + i % 60000, b"US", 2, 1) for i in range(240000))
    pixels = b"\xe0\x7f\x10\0OW"
    for z in range(6):
        whole = dicom(np.full((16, 16), 100 * z, "<i2"), z, f"1.2.3.{z + 1}")
        (tmp_path / f"{z}.dcm").write_bytes(whole.replace(pixels, many + pixels) if z == 3 else whole)
    program = """
import pathlib, sys
from volumehaptics import vtkHapticVolumeReader
reader = vtkHapticVolumeReader()
reader.SetFileName(sys.argv[1])
reader.Update()
print(reader.GetOutput().GetDimensions())
children = pathlib.Path("/proc/self/task").glob("*/children")
for child in " ".join(file.read_text() for file in children).split():
    status = dict(line.split(":", 1) for line in pathlib.Path(f"/proc/{child}/status").read_text().splitlines())
    if status["Name"].strip().startswith("volumehaptics-d"):
        print("took", status["VmHWM"].split()[0])
"""
    told = subprocess.run([sys.executable, "-c", program, tmp_path], check=True, capture_output=True, text=True)
    if "volumehaptics-dicom that reads it is missing" in told.stderr:
        pytest.skip("needs the program that reads DICOM")
    assert told.stdout.startswith("(16, 16, 6)"), told
    assert int(told.stdout.split("took")[1]) < 65536, told  # KiB


def tiff(path, pages=None, cut=0, description="", **entries):
    """Writes pages. `entries` adds or replaces tags, each as t256=number; None removes the tag."""
    file = bytearray(b"II*\0")
    link = len(file)
    file += bytes(4)
    for page in make_array() if pages is None else pages:
        samples = page.tobytes()
        at = len(file)
        file += samples
        tags = {256: page.shape[1], 257: page.shape[0], 258: 8 * page.dtype.itemsize, 259: 1, 262: 1, 273: at, 277: 1,
                278: page.shape[0], 279: len(samples), 339: 2, **{int(tag[1:]): value for tag, value in entries.items()}}
        text = description.encode() + b"\0"
        if description:
            tags[270] = len(file)
            file += text + bytes(len(text) % 2)
        file[link:link + 4] = struct.pack("<I", len(file))
        kept = [(tag, value) for tag, value in sorted(tags.items()) if value is not None]
        file += struct.pack("<H", len(kept))
        for tag, value in kept:
            file += struct.pack("<HHII", tag, 2, len(text), value) if tag == 270 else struct.pack("<HHII", tag, 4, 1, value)
        link = len(file)
        file += bytes(4)
    path.write_bytes(file[:len(file) - cut])
    return path


def most_memory():
    """Returns the peak of the reserved memory (KiB). It includes memory that was never touched, which is most of what a
    false file makes a reader request."""
    return int(re.search(r"VmPeak:\s+(\d+)", Path("/proc/self/status").read_text())[1])


def test_tiff_is_read_in_another_process(tmp_path):
    """A damaged file may crash libtiff, so another process runs it. Boxes are read in a process of their own, which no
    whole file delays."""
    array = make_array("uint16")
    tiff(tmp_path / "a.tif", array, t339=1)
    running = set(helpers())
    expect_samples(tmp_path / "a.tif", array)
    assert running != set(helpers())
    for one in helpers():
        os.kill(one, signal.SIGKILL)
    expect_samples(tmp_path / "a.tif", array)


def test_a_pipe_among_slices_is_told(tmp_path):
    """Nobody writes into the pipe, so that opening it would block."""
    for number, page in enumerate(make_array()[:3]):
        tiff(tmp_path / f"{number}.tif", [page])
    os.mkfifo(tmp_path / "3.tif")
    assert "3.tif is no regular file" in error_of(tmp_path)


def test_a_damaged_tiff_ends_nothing(tmp_path):
    chance, path = np.random.default_rng(4), tmp_path / "a.tif"

    def write():
        tiff(path, make_array())
        for changed in damaged(path.read_bytes(), chance, 200):
            path.write_bytes(changed)
            yield path

    expect_samples_or_an_error(write())


def test_a_tiff_that_asks_for_much_memory_is_refused(tmp_path):
    """The file declares strips of 2 GB in 120 kB."""
    path = tmp_path / "a.tif"
    tiff(path, np.zeros((2, 60, 1000), "uint8"), t257=2000000, t278=2000000, t259=8)
    before = most_memory()
    source = vtkHapticRegionSource()
    assert source.OpenFile(str(path))
    with Errors(source) as errors:
        assert not source.ReadRegion((0, 9, 0, 9, 0, 1), vtkImageData())
    assert "it is damaged" in errors[0]
    assert most_memory() - before < 1 << 20


@pytest.mark.parametrize("name", ["a.mha", "a.mhd", "a.nrrd", "a.nhdr"])
def test_a_file_of_holes_is_told(tmp_path, name):
    """A file of holes takes 4 KiB of the disk and 100 MiB of memory. Read by regions, only the regions take memory."""
    side = 464
    file, data, word = tmp_path / name, tmp_path / "a.raw", "a.raw" if name[-2:] == "hd" or name[-3:] == "hdr" else ""
    head = f"NRRD0004\ntype: uchar\ndimension: 3\nsizes: {side} {side} {side}\nencoding: raw\n" + (
        f"data file: {word}\n\n" if word else "\n") if "n" in name else (
        f"NDims = 3\nDimSize = {side} {side} {side}\nElementType = MET_UCHAR\nElementDataFile = {word or 'LOCAL'}\n")
    file.write_text(head)
    with (data if word else file).open("ab") as samples:
        samples.truncate(side**3 + (0 if word else len(head)))
    with pytest.raises(ValueError, match="holes for the rest"):
        _files.read(file)
    source, region = vtkHapticRegionSource(), vtkImageData()
    assert source.OpenFile(str(file)) and source.ReadRegion((0, 9, 0, 9, 0, 9), region)


def test_a_damaged_zarr_with_shards_ends_nothing(tmp_path):
    """The file is written by hand after Zarr's specification: two shards of eight uncompressed chunks, followed by the
    index."""
    array, path = make_array(), tmp_path / "a.zarr"
    chunk = [-(-count // 2) for count in array.shape]
    padded = np.pad(array, [(0, 2 * size - count) for size, count in zip(chunk, array.shape)])
    parts = [padded[tuple(slice(at * size, (at + 1) * size) for at, size in zip(place, chunk))].tobytes()
             for place in np.ndindex(2, 2, 2)]
    plain = [{"name": "bytes", "configuration": {"endian": "little"}}]
    head = json.dumps({
        "zarr_format": 3, "node_type": "array", "shape": array.shape, "data_type": "int16", "fill_value": 0,
        "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": padded.shape}},
        "chunk_key_encoding": {"name": "default", "configuration": {"separator": "/"}},
        "codecs": [{"name": "sharding_indexed", "configuration": {
            "chunk_shape": chunk, "codecs": plain, "index_codecs": plain, "index_location": "end"}}]}).encode()
    index = b"".join(struct.pack("<QQ", number * len(part), len(part)) for number, part in enumerate(parts))
    shard = b"".join(parts) + index
    (path / "c/0/0").mkdir(parents=True)
    (path / "zarr.json").write_bytes(head)
    (path / "c/0/0/0").write_bytes(shard)
    source, region = vtkHapticRegionSource(), vtkImageData()
    assert source.OpenFile(str(path)) and source.ReadRegion(source.GetWholeExtent(), region)
    assert np.array_equal(vtk_to_numpy(region.GetPointData().GetScalars()).reshape(array.shape), array)

    def write():
        chance = np.random.default_rng(7)
        for one in damaged(head, chance, 300):
            (path / "zarr.json").write_bytes(one)
            yield path
        (path / "zarr.json").write_bytes(head)
        for one in damaged(index, chance, 300):
            (path / "c/0/0/0").write_bytes(b"".join(parts) + one)
            yield path

    expect_samples_or_an_error(write())


def region_error(path):
    """Returns the error of reading the samples of a file whose header is valid; empty if they can be read."""
    source = vtkHapticRegionSource()
    assert source.OpenFile(str(path))
    with Errors(source) as errors:
        source.ReadRegion(source.GetWholeExtent(), vtkImageData())
    return "".join(errors)


def castagnoli(data):
    """Computes CRC-32C, bit by bit, with the polynomial of RFC 3720, section 12.1."""
    rest = 0xffffffff
    for byte in data:
        rest ^= byte
        for _ in range(8):
            rest = rest >> 1 ^ (0x82f63b78 if rest & 1 else 0)
    return struct.pack("<I", rest ^ 0xffffffff)


def test_a_wrong_checksum_is_told(hdf5, tmp_path):
    assert castagnoli(b"123456789") == struct.pack("<I", 0xe3069283)  # check value of the published catalogues of CRCs
    array = make_array("int16", (5, 4, 7))
    path = write_vtkhdf(hdf5, tmp_path / "a.vtkhdf", array, extent=(0, 6, 0, 3, 0, 4), chunk=(5, 4, 7), filters=[SUM])
    assert not region_error(path)
    good = path.read_bytes()
    at = good.index(array.tobytes())
    for place in at, at + array.nbytes // 2 + 1, at + array.nbytes - 1, at + array.nbytes + 2:
        path.write_bytes(good[:place] + bytes([good[place] ^ 4]) + good[place + 1:])
        assert "damaged (fletcher32)" in region_error(path)
    # Write a shard by hand according to Zarr's specification: two uncompressed chunks, and an index with swapped
    # entries.
    path = tmp_path / "a.zarr"
    chunks = [array[:, :2], array[:, 2:]]
    plain = [{"name": "bytes", "configuration": {"endian": "little"}}]
    (path / "c/0/0").mkdir(parents=True)
    (path / "zarr.json").write_text(json.dumps({
        "zarr_format": 3, "node_type": "array", "shape": array.shape, "data_type": "int16", "fill_value": 0,
        "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": array.shape}},
        "chunk_key_encoding": {"name": "default", "configuration": {"separator": "/"}},
        "codecs": [{"name": "sharding_indexed", "configuration": {
            "chunk_shape": (5, 2, 7), "codecs": plain, "index_codecs": [*plain, {"name": "crc32c"}]}}]}))
    size = chunks[0].nbytes
    entries = [struct.pack("<QQ", at, size) for at in (0, size)]
    good, exchanged = b"".join(entries), b"".join(entries[::-1])
    for index, said in (good, ""), (exchanged, "damaged (crc32c)"):
        (path / "c/0/0/0").write_bytes(b"".join(chunk.tobytes() for chunk in chunks) + index + castagnoli(good))
        assert said in region_error(path) and bool(said) == bool(region_error(path))


@pytest.mark.parametrize("codec", ["zlib", "gzip", "lz4", "blosc", "zstd"])
def test_a_chunk_may_not_promise_more_than_its_samples(tmp_path, codec):
    """Chunks of 64 bytes to 300 kB would unpack to gigabytes. A child process may use 700 MB more than at its start."""
    heads = {
        "lz4": struct.pack("<I", 0x7fffffff) + bytes(60),  # numcodecs: the size, then a block of LZ4
        "blosc": struct.pack("<BBBBIII", 2, 1, 0, 1, 0x7fffffff, 0x7fffffff, 64) + bytes(48),  # header of Blosc 1
        "zstd": b"\x28\xb5\x2f\xfd\xe0" + struct.pack("<Q", 1 << 40) + bytes(40),  # RFC 8878: a single segment
    }
    if codec in heads:
        packed = heads[codec]
    else:
        squeeze = zlib.compressobj(9, zlib.DEFLATED, 15 if codec == "zlib" else 31)
        packed = b"".join([*(squeeze.compress(bytes(1 << 20)) for _ in range(900)), squeeze.flush()])
    head = {"zarr_format": 2, "shape": [8, 8, 8], "chunks": [8, 8, 8], "dtype": "|u1", "compressor": {"id": codec},
            "fill_value": 0, "order": "C", "filters": None}
    folder = tmp_path / "a.zarr"
    folder.mkdir()
    (folder / ".zarray").write_text(json.dumps(head))
    (folder / "0.0.0").write_bytes(packed)
    program = """
import resource, sys
from volumehaptics import vtkHapticRegionSource
from vtkmodules.vtkCommonDataModel import vtkImageData
source = vtkHapticRegionSource()
assert source.OpenFile(sys.argv[1])
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
source.ReadRegion(source.GetWholeExtent(), vtkImageData())
print("took", resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""
    done = subprocess.run([sys.executable, "-c", program, str(folder)], capture_output=True, text=True, timeout=60)
    said = done.stdout + done.stderr
    assert "damaged" in said or "larger than its samples" in said or "can't unpack" in said, said
    assert int(done.stdout.split("took")[1]) < 20000  # kilobytes


@pytest.mark.parametrize("fill, value", [("NaN", np.nan), ("-Infinity", -np.inf), ("0x7fc00000", np.nan),
                                         ("0x7FC00001", np.nan), ("0x41280000", 10.5), (2.5, 2.5)])
def test_fill_values_of_zarr_version_3(tmp_path, fill, value):
    """Fill values as in the specification's list of data types: numbers, three words, or bits in hexadecimal digits."""
    path = tmp_path / "a.zarr"
    path.mkdir()
    head = {"zarr_format": 3, "node_type": "array", "shape": [2, 2, 2], "data_type": "float32", "fill_value": fill,
            "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [2, 2, 2]}},
            "chunk_key_encoding": {"name": "default"},
            "codecs": [{"name": "bytes", "configuration": {"endian": "little"}}]}
    (path / "zarr.json").write_text(json.dumps(head))
    source = vtkHapticRegionSource()
    assert source.OpenFile(str(path))
    assert np.array_equal(region_of(source, (0, 1, 0, 1, 0, 1)), np.full((2, 2, 2), value), equal_nan=True)
    for wrong in "0x7fc0", "nothing", "0x7fc0000g":
        (path / "zarr.json").write_text(json.dumps({**head, "fill_value": wrong}))
        assert "is no number" in error_of(path)


@pytest.mark.parametrize("word", ["True", "1", "t", "False", "0", "f"])
def test_words_of_a_meta_image(tmp_path, word):
    """MetaIO, by which VTK and ITK read, takes a word for true by its first letter (metaImage.cxx). VTK's reader
    agrees."""
    array, path = make_array(">i2" if word in "True 1 t" else "<i2"), tmp_path / "a.mha"
    head = "ObjectType = Image\nNDims = 3\nDimSize = 20 12 18\nElementType = MET_SHORT\nElementSpacing = 1 2 3\n"

    def told(line, data):
        path.write_bytes((head + line + "\nElementDataFile = LOCAL\n").encode() + data)
    told(f"BinaryData = True\nBinaryDataByteOrderMSB = {word}", array.tobytes())
    expect_samples(path, array)
    reader = vtkMetaImageReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert np.array_equal(vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()), array.ravel())
    if word not in "True 1 t":  # numbers as text
        told(f"BinaryData = {word}", " ".join(map(str, array.ravel())).encode())
        assert "region by region" in error_of(path)
    told("CompressedData = " + word, zlib.compress(array.tobytes()) if word in "True 1 t" else array.tobytes())
    if word in "True 1 t":
        assert "region by region" in error_of(path)
    else:
        expect_samples(path, array)


@pytest.mark.parametrize("spacing", ["0", "-1", "nan", "inf", "1e-320"])
def test_a_spacing_that_none_has_is_told(tmp_path, spacing):
    samples, path = make_array("uint8", (3, 3, 3)).tobytes(), tmp_path / "a.mha"
    path.write_bytes(f"NDims = 3\nDimSize = 3 3 3\nElementType = MET_UCHAR\nElementSpacing = 1 {spacing} 1\n"
                     "ElementDataFile = LOCAL\n".encode() + samples)
    assert "spacing is no finite number above zero" in error_of(path)
    path = tmp_path / "a.zarr"
    path.mkdir()
    head = {"zarr_format": 2, "shape": [3, 3, 3], "chunks": [3, 3, 3], "dtype": "|u1", "compressor": None,
            "fill_value": 0, "order": "C", "filters": None}
    (path / "0").mkdir()
    (path / "0/.zarray").write_text(json.dumps(head))
    (path / ".zattrs").write_text('{"multiscales": [{"axes": [{"name": "z"}, {"name": "y"}, {"name": "x"}], "datasets": [{'
                                  '"path": "0", "coordinateTransformations": [{"type": "scale", "scale": [1, SPACING, 1]}]'
                                  '}]}]}'.replace("SPACING", spacing.replace("nan", "NaN").replace("inf", "1e999")))
    assert error_of(path)


CODECS = {"none": None, "zlib": ("Zlib", 5), "gzip": ("GZip", 5), "lz4": ("LZ4",), "zstd": ("Zstd", 3),
          "blosc": ("Blosc", "lz4", 5, 1), "blosc plain": ("Blosc", "lz4hc", 9, 0), "blosc zlib": ("Blosc", "zlib", 5, 1),
          "blosc stored": ("Blosc", "lz4", 0, 1), "blosc zstd": ("Blosc", "zstd", 5, 2),
          "blosc blosclz": ("Blosc", "blosclz", 9, 1)}


@pytest.mark.parametrize("codec", CODECS)
@pytest.mark.parametrize("dtype", ["uint8", "int16", ">i2", "float64"])
def test_zarr_of_all_codecs(tmp_path, codec, dtype):
    zarr = pytest.importorskip("zarr")
    numcodecs = pytest.importorskip("numcodecs")
    name, *values = CODECS[codec] or (None,)
    smooth = np.add.outer(np.add.outer(np.arange(50) // 9, np.arange(33)), np.arange(41) // 5)
    array = (smooth + np.random.default_rng(2).integers(0, 3, smooth.shape)).astype(dtype)
    array[-20:] = np.random.default_rng(3).integers(0, 127, array[-20:].shape)
    stored = zarr.open(str(tmp_path / "a.zarr"), mode="w", shape=array.shape, chunks=(21, 16, 17), dtype=dtype,
                       compressor=name and getattr(numcodecs, name)(*values))
    stored[:] = array
    source = expect_samples(tmp_path / "a.zarr", array)
    assert source.GetSpacing() == (1.0, 1.0, 1.0)
    assert source.GetCoarseImage() is None


def test_zarr_chunks_that_are_not_there_have_the_fill_value(tmp_path):
    zarr = pytest.importorskip("zarr")
    stored = zarr.open(str(tmp_path / "a.zarr"), mode="w", shape=(30, 30, 30), chunks=(8, 8, 8), dtype="f4",
                       fill_value=float("nan"), dimension_separator="/")
    stored[:8, :8, :8] = 7
    array = np.full((30, 30, 30), np.nan, np.float32)
    array[:8, :8, :8] = 7
    source = vtkHapticRegionSource()
    assert source.OpenFile(str(tmp_path / "a.zarr"))
    assert np.array_equal(region_of(source, (0, 29, 0, 29, 0, 29)), array, equal_nan=True)


def test_ome_zarr_has_its_place_and_a_coarse_level(tmp_path):
    zarr = pytest.importorskip("zarr")
    fine = make_array("uint16", (1, 2, 40, 24, 30))
    group = zarr.open_group(str(tmp_path / "a.zarr"), mode="w")
    for name, level in ("0", fine), ("1", fine[..., ::2, ::2, ::2]):
        zarr.open(str(tmp_path / "a.zarr" / name), mode="w", shape=level.shape, chunks=(1, 1, 16, 16, 16),
                  dtype=level.dtype)[:] = level
    steps = [[{"type": "scale", "scale": [1, 1, 2.0 * f, 0.5 * f, 0.25 * f]},
              {"type": "translation", "translation": [0, 0, 10, 20, 30]}] for f in (1, 2)]
    group.attrs["multiscales"] = [{
        "version": "0.4", "axes": [{"name": name} for name in "tczyx"],
        "datasets": [{"path": str(i), "coordinateTransformations": steps[i]} for i in range(2)],
        "coordinateTransformations": [{"type": "scale", "scale": [1, 1, 10, 10, 10]}]}]
    source = expect_samples(tmp_path / "a.zarr", fine[0, 0])
    assert np.allclose(source.GetSpacing(), (2.5, 5, 20))
    assert np.allclose(source.GetOrigin(), (300, 200, 100))
    coarse = source.GetCoarseImage()
    assert np.allclose((*coarse.GetSpacing(), *coarse.GetOrigin()), (5, 10, 40, 300, 200, 100))
    values = vtk_to_numpy(coarse.GetPointData().GetScalars())
    assert np.array_equal(values, fine[0, 0, ::2, ::2, ::2].ravel())


def test_zarr_version_3(tmp_path):
    array = make_array(">i2")
    folder = tmp_path / "a.zarr" / "s0"
    folder.mkdir(parents=True)
    head = {"zarr_format": 3, "node_type": "array", "shape": SHAPE, "data_type": "int16", "fill_value": 3,
            "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [9, 6, 20]}},
            "chunk_key_encoding": {"name": "default", "configuration": {"separator": "/"}},
            "codecs": [{"name": "bytes", "configuration": {"endian": "big"}},
                       {"name": "gzip", "configuration": {"level": 5}}]}
    (folder / "zarr.json").write_text(json.dumps(head))
    for k, j in itertools.product(range(2), range(2)):
        (folder / f"c/{k}/{j}").mkdir(parents=True)
        chunk = np.ascontiguousarray(array[9 * k:9 * k + 9, 6 * j:6 * j + 6])
        (folder / f"c/{k}/{j}/0").write_bytes(gzip.compress(chunk.tobytes()))
    (folder / "c/1/1/0").unlink()
    array = array.astype("int16")
    array[9:, 6:] = 3
    scales = [{"axes": [{"name": "z"}, {"name": "y"}, {"name": "x"}], "datasets": [
        {"path": "s0", "coordinateTransformations": [{"type": "scale", "scale": [3, 2, 1]}]}]}]
    (tmp_path / "a.zarr/zarr.json").write_text(json.dumps(
        {"zarr_format": 3, "node_type": "group", "attributes": {"ome": {"version": "0.5", "multiscales": scales}}}))
    assert expect_samples(tmp_path / "a.zarr", array).GetSpacing() == (1.0, 2.0, 3.0)


def test_zarr_that_is_not_read_is_told_with_the_cure(tmp_path):
    path = tmp_path / "a.zarr"
    path.mkdir()
    assert "no folder of Zarr" in error_of(path)
    head = {"zarr_format": 2, "shape": [9, 9, 9], "chunks": [3, 3, 3], "dtype": "<i2", "compressor": None,
            "fill_value": 0, "order": "C", "filters": None}

    def told(**changed):
        (path / ".zarray").write_text(json.dumps({**head, **changed}))
        return error_of(path)
    assert "2 dimensions" in told(shape=[9, 9], chunks=[3, 3])
    assert "of type <c8" in told(dtype="<c8")
    assert "open_large() in Python" in told(compressor={"id": "bz2"})
    assert "order F" in told(order="F")
    assert "filters" in told(filters=[{"id": "delta"}])
    assert "size that no volume has" in told(shape=[9, 9, -9])
    assert "not as Zarr wants it" in told(compressor={"id": {}})
    (path / ".zarray").unlink()
    for text in '{"a": 1', "[" * 5000, '{"a": ' + "[" * 70 + "]" * 70 + "}":
        for name in ".zarray", ".zattrs", "zarr.json":
            (path / name).write_text(text)
            said = error_of(path)
            assert f"{name} can't be read: it is not JSON" in said
            assert ("nested more than 64 deep" in said) == ("[" in text)
            (path / name).unlink()
    (path / ".zarray").write_text("[]")
    assert ".zarray can't be read: it is no object" in error_of(path)
    (path / ".zarray").unlink()
    (path / ".zattrs").write_text('{"multiscales": [{"datasets": [{"path": "0"}]}]}')
    assert "has no head" in error_of(path)
    (path / ".zattrs").write_text("{}")
    assert "without OME-Zarr's multiscales" in error_of(path)


def test_damaged_chunks_are_an_error_of_the_region(tmp_path):
    zarr = pytest.importorskip("zarr")
    numcodecs = pytest.importorskip("numcodecs")
    chance = np.random.default_rng(9)
    results = {True: 0, False: 0}
    for name, *values in ("Blosc", "lz4", 5, 1), ("LZ4",), ("Zlib", 5):
        path = tmp_path / f"{name}.zarr"
        array = make_array("int16", (20, 20, 20)) // 9
        zarr.open(str(path), mode="w", shape=array.shape, chunks=(20, 20, 20), dtype="i2",
                  compressor=getattr(numcodecs, name)(*values))[:] = array
        good = (path / "0.0.0").read_bytes()
        for trial in range(150):
            bad = bytearray(good if trial % 3 else good[:chance.integers(0, len(good))])
            for place in chance.integers(0, max(len(bad) // (1 + trial % 30), 1), 3):
                bad[place:place + 1] = bytes([chance.integers(0, 256)])
            (path / "0.0.0").write_bytes(bad)
            source = vtkHapticRegionSource()
            assert source.OpenFile(str(path))
            with Errors(source) as errors:
                done = bool(source.ReadRegion((0, 19, 0, 19, 0, 19), vtkImageData()))
            results[done] += 1
            assert done or "can't be read from the file" in errors[0]
    assert results[False] > 100


def test_a_coarse_image_is_made_of_means(hdf5, tmp_path):
    array = make_array("float32", (50, 40, 60))
    array[3, 4, 5] = np.nan
    source = vtkHapticRegionSource()
    assert source.OpenFile(str(write_vtkhdf(hdf5, tmp_path / "a.vtkhdf", array, extent=(2, 61, -3, 36, 5, 54),
                                            chunk=(16, 16, 16))))
    assert source.MakeCoarseImage(10 * 14 * 20)  # cubes of 4^3 voxels give too many samples; 13 x 10 x 15 fit
    coarse = source.GetCoarseImage()
    assert coarse.GetDimensions() == (15, 10, 13)
    values = vtk_to_numpy(coarse.GetPointData().GetScalars()).reshape(13, 10, 15)
    expected = [[[np.nanmean(array[4 * k:4 * k + 4, 4 * j:4 * j + 4, 4 * i:4 * i + 4]) for i in range(15)]
                 for j in range(10)] for k in range(13)]
    assert np.allclose(values, expected, rtol=1e-6)
    # The expected origin is the middle of the first cube, which begins at the index (2, -3, 5). The x axis points along
    # the world's y, the y axis along the world's -x.
    assert np.allclose(coarse.GetOrigin(), (-3 - 1.0 * (-3 + 1.5), 4 + 0.5 * (2 + 1.5), 5 + 1.5 * (5 + 1.5)))
    assert np.allclose(coarse.GetSpacing(), (2, 4, 6))
    array.tofile(tmp_path / "a.raw")
    raw = vtkHapticRegionSource()
    raw.SetFileName(str(tmp_path / "a.raw"))
    raw.SetScalarType(10)
    raw.SetWholeExtent(0, 59, 0, 39, 0, 49)
    assert raw.MakeCoarseImage(15 * 10 * 13)
    values = vtk_to_numpy(raw.GetCoarseImage().GetPointData().GetScalars()).reshape(13, 10, 15)
    assert np.isclose(values[2, 3, 4], array[9, 13, 16:20].mean())


def test_raw_samples_behind_a_header_are_large(tmp_path):
    array = make_array()
    array.astype(">i2").tofile(tmp_path / "a.raw")
    (tmp_path / "a.mhd").write_text(f"NDims = 3\nDimSize = {' '.join(map(str, array.shape[::-1]))}\nElementSpacing = 1 2 3\n"
                                    "ElementType = MET_SHORT\nElementByteOrderMSB = True\nElementDataFile = a.raw\n")
    source = open_large(tmp_path / "a.mhd", origin=(4, 5, 6))
    assert (source.GetSpacing(), source.GetOrigin()) == ((1, 2, 3), (4, 5, 6))
    assert np.array_equal(region_of(source, source.GetWholeExtent()), array)
    (tmp_path / "a.raw").unlink()
    with pytest.raises(ValueError, match="a.raw, which can't be opened"):
        open_large(tmp_path / "a.mhd")
