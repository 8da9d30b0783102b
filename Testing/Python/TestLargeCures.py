# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures of errors about files that are read region by region: after the cure, all samples are read.

Commands are really run, such as h5repack of HDF5's own tools (Debian's hdf5-tools). The writers are those of
TestLargeFiles.py.
"""

import bz2
import ctypes
import gzip
import json
import shutil
import struct
import subprocess
import zlib
from pathlib import Path

import numpy as np
import pytest
from TestLargeFiles import ENDLESS, EXTENT, LATEST, SHAPE, Hdf5, error_of, make_array, region_of, write_attribute
from TestLargeFiles import tiff, write_vtkhdf
from vtkmodules.vtkCommonCore import VTK_SHORT
from vtkmodules.vtkCommonDataModel import vtkImageData
from volumehaptics import vtkHapticRegionSource
from volumehaptics._touch import Errors

ARRAY = make_array()


def samples_of(path):
    source = vtkHapticRegionSource()
    assert source.OpenWholeFile(str(path)), path
    return region_of(source, source.GetWholeExtent())


def case(*words):
    """Registers a generator that writes a file, yields its path, and applies the cure; it may yield the path of another
    file."""
    def keep(function):
        assert words not in FILES, words
        FILES[words] = function
        return function
    return keep


FILES = {}
WHOLE = set()  # words of cases in FILES whose file is read as a whole


@pytest.mark.parametrize("words", FILES)
def test_cures_of_files(words, tmp_path):
    write = FILES[words](tmp_path)
    path = next(write)
    source = vtkHapticRegionSource()
    with Errors(source) as errors:
        if source.OpenWholeFile(str(path)) if words in WHOLE else source.OpenFile(str(path)):
            source.ReadRegion(source.GetWholeExtent(), vtkImageData())
    assert len(errors) == 1 and all(word in errors[0] for word in words), errors
    for cured in write:
        if isinstance(cured, np.ndarray):
            assert np.array_equal(cured, ARRAY)
        else:
            assert np.array_equal(samples_of(cured or path), ARRAY)


# HDF5.

def vtkhdf(folder, name="a.vtkhdf", array=ARRAY, h=None, **how):
    return write_vtkhdf(h or Hdf5(), folder / name, array, **how)


def repacked(told_words, path):
    """Runs the command of an error text, from h5repack to OUT."""
    out = path.with_name("out.vtkhdf")
    command = told_words.replace("IN", str(path)).replace("OUT", str(out)).split()
    subprocess.run(command, check=True, capture_output=True)
    return out


# For each remedy: the command in the error's text, and the settings of a file that needs this command.
CONVERTED = {
    "h5repack -f GZIP=1 IN OUT": dict(chunk=(5, 4, 7), filters=[("scaleoffset", 2, 0)]),
    "h5repack -l CHUNK=64x64x64 IN OUT": dict(chunk=(1024, 1024, 1024), most=(ENDLESS,) * 3, empty=7),
    "array has no samples, or its storage layout is not supported. Convert it with h5repack -l CONTI IN OUT":
        dict(filters=[("layout", 0)]),
    "its samples lie in other files. Convert it with h5repack -l CONTI IN OUT":
        dict(filters=[("external", b"samples.raw", 0, ARRAY.nbytes)]),
}


@pytest.mark.parametrize("words", CONVERTED)
def test_cures_by_commands(words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = vtkhdf(tmp_path, **CONVERTED[words])
    assert words in error_of(path)
    right = np.full_like(ARRAY, 7) if "empty" in CONVERTED[words] else ARRAY
    assert np.array_equal(samples_of(repacked(words[words.index("h5repack"):], path)), right)


def test_h5repack_knows_versions():
    """No file can have a format that is newer than all existing ones; the test checks that the option of the cure
    exists."""
    shown = subprocess.run(["h5repack", "--help"], capture_output=True, text=True, check=True).stdout
    assert "--high=BOUND" in shown


@case("h5repack -l CHUNK=64x64x64 IN OUT", "16777216 chunks")
def _(folder):
    yield vtkhdf(folder, array=np.zeros((300, 300, 300), np.uint8), chunk=(1, 1, 1), empty=7,
                 extent=(0, 299, 0, 299, 0, 299))
    yield vtkhdf(folder, chunk=(5, 4, 7))


class Unclosed(Hdf5):
    """Writes a file that its writer has not closed, or shares with readers."""
    swmr = False

    def Fclose(self, file):
        self.Fflush(file, 1)
        if self.swmr:
            self.Fstart_swmr_write(file)
        name = ctypes.create_string_buffer(4096)
        self.Fget_name(file, name, len(name))
        copy = Path(name.value.decode())
        shutil.copy(copy, copy.with_name("copy.vtkhdf"))
        self.__getattr__("Fclose")(file)


def test_a_file_that_was_never_closed(tmp_path):
    vtkhdf(tmp_path, h=Unclosed(), version=LATEST, chunk=(5, 4, 7))
    path = tmp_path / "copy.vtkhdf"
    assert "never closed. Close it there; if its writer has ended, run h5clear -s FILE" in error_of(path)
    subprocess.run(["h5clear", "-s", str(path)], check=True, capture_output=True)
    assert np.array_equal(samples_of(path), ARRAY)


def test_a_file_whose_writer_allows_readers_is_read(tmp_path):
    writer = Unclosed()
    vtkhdf(tmp_path, h=writer, chunk=(5, 4, 7))  # oldest format, which does not record that it is open
    assert np.array_equal(samples_of(tmp_path / "copy.vtkhdf"), ARRAY)
    writer.swmr = True
    vtkhdf(tmp_path, h=writer, version=LATEST, chunk=(5, 4, 7))
    assert np.array_equal(samples_of(tmp_path / "copy.vtkhdf"), ARRAY)


class Shared(Hdf5):
    """Stores the type of the samples in the file, as a named type."""

    def Fcreate(self, *values):
        self.file = self.__getattr__("Fcreate")(*values)
        return self.file

    def known(self, name):
        if name != "T_STD_I16LE":
            return super().known(name)
        self.kind = self.Tcopy(super().known(name))
        self.Tcommit2(self.file, b"kind", self.kind, 0, 0, 0)
        return self.kind

    def Fclose(self, file):
        self.Tclose(self.kind)
        self.__getattr__("Fclose")(file)


def test_a_type_that_the_file_names_is_read(tmp_path):
    assert np.array_equal(samples_of(vtkhdf(tmp_path, h=Shared())), ARRAY)


class Bits(Hdf5):
    def known(self, name):
        return super().known("T_STD_B16LE" if name == "T_STD_I16LE" else name)


@case("Write it as integers or floating-point numbers of 1 to 8 bytes")
def _(folder):
    yield vtkhdf(folder, h=Bits())
    yield vtkhdf(folder)


@case("Check what it really is")
def _(folder):
    path = folder / "a.vtkhdf"
    (folder / "a.mhd").write_text(meta_header("a.raw"))
    ARRAY.tofile(folder / "a.raw")
    path.write_bytes((folder / "a.mhd").read_bytes())
    yield path
    yield folder / "a.mhd"


@case("its HDF5 structure ends too early or makes no sense. Copy or write it again")
def _(folder):
    path = vtkhdf(folder)
    good = path.read_bytes()
    path.write_bytes(good[:700])
    yield path
    path.write_bytes(good)
    yield None


def bare(folder, *, points=True):
    h, path = Hdf5(), folder / "a.vtkhdf"
    file = h.Fcreate(str(path).encode(), 2, 0, 0)
    group = h.Gcreate2(file, b"VTKHDF", 0, 0, 0)
    write_attribute(h, group, "Type", "ImageData")
    write_attribute(h, group, "WholeExtent", list(EXTENT))
    for name in ("Origin", "Spacing"):
        write_attribute(h, group, name, [1.0, 1.0, 1.0])
    if points:
        h.Gclose(h.Gcreate2(group, b"PointData", 0, 0, 0))
    h.Gclose(group)
    h.Fclose(file)
    return path


@case("it has no ", ". Give a VTKHDF file of an image with point data")
def _(folder):
    yield bare(folder, points=False)
    yield vtkhdf(folder)


@case("its PointData has no array. Give a VTKHDF file of an image with point data")
def _(folder):
    yield bare(folder)
    yield vtkhdf(folder)


@case("Write that as an array of three dimensions")
def _(folder):
    yield vtkhdf(folder, array=ARRAY[..., None] + np.zeros(3, np.int16))
    yield vtkhdf(folder)


@case("(z, y, x). Write it again")
def _(folder):
    yield vtkhdf(folder, extent=(0, 3, 0, 3, 0, 3))
    yield vtkhdf(folder)


@case("Give a VTKHDF file of an image.")
def _(folder):
    yield vtkhdf(folder, kind="UnstructuredGrid")
    yield vtkhdf(folder)


@case("or has other numbers than an image needs. Write it again")
def _(folder):
    yield vtkhdf(folder, extent=(0, 3))
    yield vtkhdf(folder)


# -- raw samples --

def meta_header(data, size=SHAPE[::-1], more=""):
    return (f"NDims = {len(size)}\nDimSize = {' '.join(map(str, size))}\nElementType = MET_SHORT\n{more}"
            f"ElementDataFile = {data}\n")


@case("Check its name and permissions")
def _(folder):
    ARRAY.tofile(folder / "a.raw")
    yield folder / "b.mhd"
    (folder / "a.mhd").write_text(meta_header("a.raw"))
    yield folder / "a.mhd"


@case("Check that the copy of that file is complete")
def _(folder):
    ARRAY[:-1].tofile(folder / "a.raw")
    (folder / "a.mhd").write_text(meta_header("a.raw"))
    yield folder / "a.mhd"
    ARRAY.tofile(folder / "a.raw")
    yield None


@case("Write them uncompressed into one raw file, or read the whole volume into memory")
def _(folder):
    (folder / "a.raw").write_bytes(zlib.compress(ARRAY.tobytes()))
    (folder / "a.mhd").write_text(meta_header("a.raw", more="CompressedData = True\n"))
    yield folder / "a.mhd"
    ARRAY.tofile(folder / "b.raw")
    (folder / "b.mhd").write_text(meta_header("b.raw"))
    yield folder / "b.mhd"


def whole_case(*words):
    WHOLE.add(words)
    return case(*words)


def nrrd(folder, encoding, samples):
    path = folder / "a.nrrd"
    sizes = " ".join(map(str, SHAPE[::-1]))
    path.write_bytes(f"NRRD0004\ntype: short\ndimension: 3\nsizes: {sizes}\nendian: little\nencoding: {encoding}\n\n".encode()
                     + samples)
    return path


@whole_case("Write them again, with the encoding gzip")
def _(folder):
    yield nrrd(folder, "bzip2", bz2.compress(ARRAY.tobytes()))
    yield nrrd(folder, "gzip", gzip.compress(ARRAY.tobytes()))


@whole_case("Write it again, with the encoding gzip or raw")
def _(folder):
    text = " ".join(map(str, ARRAY.ravel()))
    yield nrrd(folder, "ascii", f"none {text}".encode())
    yield nrrd(folder, "ascii", text.encode())
    yield nrrd(folder, "gzip", gzip.compress(ARRAY.tobytes()))
    yield nrrd(folder, "raw", ARRAY.tobytes())


@whole_case("Check that the copy is complete, or write it again")
def _(folder):
    yield nrrd(folder, "gzip", gzip.compress(ARRAY.tobytes())[:-1])
    yield nrrd(folder, "gzip", gzip.compress(ARRAY.tobytes()))


@case("or, if it is raw, SetFileName() with extent, type and spacing")
def _(folder):
    ARRAY.tofile(folder / "a.img")
    yield folder / "a.img"
    source = raw_source(folder / "a.img")
    yield region_of(source, source.GetWholeExtent())


def raw_source(path, extent=EXTENT):
    source = vtkHapticRegionSource()
    source.SetFileName(str(path))
    source.SetScalarType(VTK_SHORT)
    source.SetWholeExtent(*extent)
    source.SetSpacing(1.0, 1.0, 1.0)
    return source


# Zarr.

HEAD = {"zarr_format": 2, "shape": list(SHAPE), "chunks": list(SHAPE), "dtype": "<i2", "compressor": None, "fill_value": 0,
        "order": "C", "filters": None}


def zarr(folder, where="a.zarr", **changed):
    path = folder / where
    path.mkdir(parents=True, exist_ok=True)
    (path / ".zarray").write_text(json.dumps({**HEAD, **changed}))
    (path / "0.0.0").write_bytes(ARRAY.tobytes())
    return path


for _words, _changed in {
    "Check its head": dict(shape=[9, 9, -9]), "Write it as integers or floating-point numbers.": dict(dtype="<c8"),
    "has a head that is not as Zarr wants it. Write it again": dict(compressor={"id": {}}),
    "Write it with chunks such as 64 x 64 x 64": dict(chunks=[1024, 1024, 1024]),
    "', which is no number. Write it again": dict(dtype="<f4", fill_value="nothing"),
}.items():
    @case(_words)
    def _(folder, changed=_changed):
        yield zarr(folder, **changed)
        yield zarr(folder)


def sharded(folder, shards=SHAPE, index=None):
    """Writes an array of Zarr's version 3 with a shard of one chunk, by hand after its specification."""
    path = folder / "a.zarr"
    (path / "c/0/0").mkdir(parents=True, exist_ok=True)
    plain = [{"name": "bytes", "configuration": {"endian": "little"}}]
    (path / "zarr.json").write_text(json.dumps({
        "zarr_format": 3, "node_type": "array", "shape": SHAPE, "data_type": "int16", "fill_value": 0,
        "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": shards}},
        "chunk_key_encoding": {"name": "default", "configuration": {"separator": "/"}},
        "codecs": [{"name": "sharding_indexed", "configuration": {
            "chunk_shape": SHAPE, "codecs": plain, "index_codecs": plain, "index_location": "end"}}]}))
    (path / "c/0/0/0").write_bytes(ARRAY.tobytes() + (struct.pack("<QQ", 0, ARRAY.nbytes) if index is None else index))
    return path


for _words, _wrong in {
    ("that are no whole number of chunks. Write it again", ): dict(shards=[n + 1 for n in SHAPE]),
    ("its index names bytes that it does not have. Copy or write it again", ): dict(index=struct.pack("<QQ", 1, ARRAY.nbytes + 17)),
}.items():
    @case(*_words)
    def _(folder, wrong=_wrong):
        yield sharded(folder, **wrong)
        yield sharded(folder)


@case("a shard of it is cut off. Copy or write it again")
def _(folder):
    path = sharded(folder)
    good = (path / "c/0/0/0").read_bytes()
    (path / "c/0/0/0").write_bytes(good[:15])
    yield path
    (path / "c/0/0/0").write_bytes(good)
    yield None


def blosc(folder, kind, shuffle):
    stored = pytest.importorskip("zarr").open(
        str(folder / "a.zarr"), mode="w", shape=SHAPE, chunks=SHAPE, dtype="i2",
        compressor=pytest.importorskip("numcodecs").Blosc(kind, 5, shuffle))
    stored[:] = ARRAY
    return folder / "a.zarr"


@case("a chunk of it is damaged", "Copy or write it again")
def _(folder):
    path = blosc(folder, "lz4", 1)
    good = (path / "0.0.0").read_bytes()
    (path / "0.0.0").write_bytes(good[:20])
    yield path
    (path / "0.0.0").write_bytes(good)
    yield None


@case("Check whether it is complete")
def _(folder):
    path = zarr(folder)
    (path / "0.0.0").write_bytes(ARRAY.tobytes()[:100])
    yield path
    yield zarr(folder)


@case("is larger than its samples. Write it again")
def _(folder):
    path = zarr(folder)
    (path / "0.0.0").write_bytes(ARRAY.tobytes() * 9)
    yield path
    yield zarr(folder)


@case("its spacing is no finite number above zero. Correct the spacing in its header")
def _(folder):
    path = folder / "a.mha"
    for spacing in "0", "2":
        path.write_bytes(f"NDims = 3\nDimSize = 20 12 18\nElementType = MET_SHORT\nElementSpacing = 1 {spacing} 1\n"
                         "ElementDataFile = LOCAL\n".encode() + ARRAY.tobytes())
        yield path


@case("it may not have been copied. Copy it, or check the name")
def _(folder):
    path = zarr(folder, "a.zarr/0")
    head = (path / ".zarray").read_bytes()
    (path / ".zarray").unlink()
    scales(folder, "0")
    yield folder / "a.zarr"
    (path / ".zarray").write_bytes(head)
    yield None


def scales(folder, path="0", steps=(), name="multiscales"):
    (folder / "a.zarr" / ".zattrs").write_text(json.dumps({name: [{
        "axes": [{"name": axis} for axis in "zyx"],
        "datasets": [{"path": path, "coordinateTransformations": list(steps)}] if path else []}]}))


@case("Open its array itself, and set spacing and origin")
def _(folder):
    zarr(folder, "a.zarr/0")
    scales(folder, steps=[{"type": "rotation", "rotation": [1, 2, 3]}])
    yield folder / "a.zarr"
    source = vtkHapticRegionSource()
    assert source.OpenFile(str(folder / "a.zarr/0"))
    source.SetSpacing(1.0, 2.0, 3.0)
    source.SetOrigin(4.0, 5.0, 6.0)
    region = vtkImageData()
    assert source.ReadRegion(source.GetWholeExtent(), region)
    assert (region.GetSpacing(), region.GetPoint(0)) == ((1.0, 2.0, 3.0), (4.0, 5.0, 6.0))
    yield folder / "a.zarr/0"


@case("Correct its .zattrs")
def _(folder):
    zarr(folder, "a.zarr/0")
    scales(folder, steps=[{"type": "scale", "scale": [1, 0, 1]}])
    yield folder / "a.zarr"
    scales(folder, steps=[{"type": "scale", "scale": [1, 2, 1]}])
    yield None


@case("Check the datasets of its multiscales")
def _(folder):
    zarr(folder, "a.zarr/0")
    scales(folder, None)
    yield folder / "a.zarr"
    scales(folder)
    yield None


@case("it has neither .zarray, .zattrs nor zarr.json. Check its name")
def _(folder):
    (folder / "b.zarr").mkdir()
    yield folder / "b.zarr"
    yield zarr(folder)


@case("without OME-Zarr's multiscales. Name one of its arrays")
def _(folder):
    zarr(folder, "a.zarr/0")
    scales(folder, name="scales")
    yield folder / "a.zarr"
    yield folder / "a.zarr/0"


@case("not as OME-Zarr wants them. Name one of its arrays")
def _(folder):
    zarr(folder, "a.zarr/0")
    (folder / "a.zarr" / ".zattrs").write_text('{"multiscales": [7]}')
    yield folder / "a.zarr"
    yield folder / "a.zarr/0"


@case("it is no object of JSON.")
def _(folder):
    path = zarr(folder)
    (path / ".zarray").write_text("[]")
    yield path
    yield zarr(folder)


@case("its head ")
def _(folder):
    path = zarr(folder)
    (path / ".zarray").write_text(" " * (1 << 24 | 1))
    yield path
    yield zarr(folder)


# -- TIFF: pages as in TIFF 6.0, section 2, each with one strip --

def tiff_case(words, **wrong):
    @case(words)
    def _(folder):
        path = tiff(folder / "a.tif", **wrong)
        yield path
        yield tiff(path)


tiff_case("samples a pixel, as pictures in colours have. Write it with one grey value a pixel", t277=3)
tiff_case("they are inverted, or numbers of colours. Write it with one grey value a pixel", t262=0)
tiff_case("pages, and has",
          description="ImageJ=1.54\nimages=18\nchannels=2\nslices=18\n")
tiff_case("Write it with 8, 16, 32 or 64 bits", t258=24, t279=3 * 2 * 120)
tiff_case("its pages have no size, or a damaged one. Write it again", t256=2**31 + 5)
tiff_case("Write it uncompressed, or with LZW or Deflate", t259=65000)
tiff_case("it names samples that are not in the file. Check that its copy is complete", t273=1 << 30)
tiff_case("a page that it names is not in the file. Check that its copy is complete", cut=300)
tiff_case("slices, and has", description="ImageJ=1.54\nimages=40\nslices=40\n")
tiff_case("one slice is no volume", pages=ARRAY[:1])
tiff_case("a page of it can't be unpacked", t259=8)


@case("it is not a TIFF file, or its header is damaged")
def _(folder):
    (folder / "a.tif").write_text("a letter")
    yield folder / "a.tif"
    yield tiff(folder / "a.tif")


def headless(path, array, description):
    """Puts all samples behind one page, as ImageJ writes stacks beyond 4 GiB."""
    return tiff(path, array.reshape(1, -1, 20), description=f"ImageJ=1.54\n{description}\n", t257=12, t278=12, t279=480)


def test_a_channel_of_all_that_is_behind_one_page(tmp_path):
    source = vtkHapticRegionSource()
    assert source.OpenFile(str(headless(tmp_path / "a.tif", ARRAY, "images=18\nslices=18")))
    assert np.array_equal(region_of(source, source.GetWholeExtent()), ARRAY)
    both = np.stack([0 * ARRAY, ARRAY], axis=1)
    assert source.OpenFile(str(headless(tmp_path / "b.tif", both, "images=36\nchannels=2\nslices=18")), 2)
    assert np.array_equal(region_of(source, source.GetWholeExtent()), ARRAY)


def test_a_number_that_no_volume_has(tmp_path):
    source = vtkHapticRegionSource()
    two = str(tiff(tmp_path / "a.tif", np.stack([0 * ARRAY, ARRAY]).reshape(-1, 12, 20), description='{"shape": [2, 18, 12, 20]}'))
    for number in (-1, 3):
        with Errors(source) as errors:
            assert not source.OpenFile(two, number)
        assert f"none with the number {number}. Take Series = 1 to Series = 2." in errors[0]
    assert source.OpenFile(two, 2)
    assert [source.GetSeriesName(i) for i in range(source.GetNumberOfSeries())] == ["1 volume 1 of 2", "2 volume 2 of 2"]
    assert source.GetSeriesNumber() == 2 and source.GetSeriesName(2) is None
    assert np.array_equal(region_of(source, source.GetWholeExtent()), ARRAY)
    one = str(tiff(tmp_path / "b.tif"))
    with Errors(source) as errors:
        assert not source.OpenFile(one, 1)
    assert "which needs no number. Leave Series out." in errors[0]
    assert source.OpenFile(one) and source.GetNumberOfSeries() == 0 and source.GetSeriesNumber() == 0
