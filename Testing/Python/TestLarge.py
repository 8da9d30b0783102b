# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes that are larger than memory, from any object with shape, dtype and slicing [z, y, x], give the forces of the
whole array."""

import gc
import re
import subprocess
import sys
import threading
import time
import warnings

import numpy as np
import pytest
import volumehaptics
from vtkmodules.vtkCommonDataModel import vtkImageData
from volumehaptics import _large, image, open_large, touch, vtkHapticDevice, vtkVolumeHapticsFilter
from volumehaptics.arrays import arrays


def make_bed(dtype=np.int16, shape=(80, 60, 300)):
    """Returns a bed under a wavy surface, with noise, longer along x than a region."""
    z, y, x = np.meshgrid(*map(np.arange, shape), indexing="ij", sparse=True)
    above = z - 40 - 4 * np.sin(0.05 * x) - 3 * np.sin(0.07 * y)
    noise = np.random.default_rng(7).normal(0, 2, shape)
    return np.round(60 - 40 * above / (1 + abs(above)) + noise).clip(0, 127).astype(dtype)


def make_tip(count=800):
    x = np.linspace(10, 290, count)
    return np.column_stack([x, 30 + 0 * x, 42 + 3 * np.sin(0.1 * x)])


@pytest.mark.parametrize("missing", [np.nan, -9999.0, 1e37])
def test_what_was_not_measured_is_felt_as_the_least_value(missing):
    bed = make_bed(np.float32)
    z, y, _x = np.meshgrid(*map(np.arange, bed.shape), indexing="ij", sparse=True)
    outside = np.broadcast_to((abs(y - 30) > 3) | (z > 60), bed.shape)
    masked = np.where(outside, np.float32(missing), bed)
    filled = np.where(outside, bed[~outside].min(), bed)
    expected = touch(image(filled), make_tip(), "MRI")
    with pytest.warns(UserWarning, match="all such samples are outside"):
        felt = touch(image(masked), make_tip(), "MRI")
    expect_same(felt, expected)
    expect_same(touch(open_large(Sliced(masked)), make_tip(), "MRI"), expected)


@pytest.mark.parametrize("shift", [0, 1024])
@pytest.mark.parametrize("bad", [np.inf, -np.inf, 1e38, -1e38])
def test_one_voxel_does_not_hide_hounsfield_units(bad, shift):
    """NumPy makes the CT, as it was before: the force must be that without the voxel, which no kernel on the path reads."""
    z, y, x = np.meshgrid(*map(np.arange, (80, 60, 300)), indexing="ij", sparse=True)
    body = (z + 3 * np.sin(0.05 * x) + 0 * y < 42).astype(np.float32)
    head = 1040 * body - 1000 + shift + np.random.default_rng(3).normal(0, 12, body.shape).astype(np.float32)
    expected = touch(image(head), make_tip(), "CT contrast")
    assert arrays(expected)["NormalForce"].max() > 0.5
    head[5, 7, 9] = bad
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        felt = touch(image(head), make_tip(), "CT contrast")
    expect_same(felt, expected)
    expect_same(touch(open_large(Sliced(head)), make_tip(), "CT contrast"), expected)


class Sliced:
    """An object with only those parts of a NumPy array that open_large() needs; it records what is requested."""

    def __init__(self, array):
        self._array, self.shape, self.dtype, self.most, self.threads = array, array.shape, array.dtype, 0, set()

    def __getitem__(self, box):
        part = self._array[box]
        self.most = max(self.most, part.size)
        self.threads.add(threading.get_ident())
        return part


class Broken(Sliced):
    def __init__(self, array):
        super().__init__(array)
        self.error = OSError("the server is gone")

    def __getitem__(self, box):
        if self.error is not None:
            raise self.error
        return super().__getitem__(box)


def expect_same(a, b):
    a, b = arrays(a), arrays(b)
    assert abs(a["Force"]).max() > 0.1
    for name in a:
        assert np.array_equal(a[name], b[name], equal_nan=True), name


@pytest.mark.parametrize("dtype", ["int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32",
                                   "float64", ">i2", ">f4"])
def test_it_is_felt_as_the_array_is(dtype):
    bed = make_bed(dtype)
    sliced = Sliced(bed)
    whole = image(bed.astype(np.dtype(dtype).newbyteorder("=")), spacing=(0.5, 1.0, 1.5), origin=(-3, 4, 5))
    tip = make_tip() * (0.5, 1.0, 1.5) + (-3, 4, 5)
    large = open_large(sliced, spacing=(0.5, 1.0, 1.5), origin=(-3, 4, 5))
    expect_same(touch(whole, tip, "CT contrast"), touch(large, tip, "CT contrast"))
    assert sliced.most <= 1 << 20


def test_labels_and_several_paths_are_felt_as_with_the_array():
    bed = make_bed()
    labels = np.zeros(bed.shape, np.uint8)
    labels[:, :, 100:200] = 3
    tips = [make_tip()[::-1], make_tip(300)]
    several = [touch(volume, tips, labels=labels, materials={3: dict(stiffness=200)}) for volume in (image(bed),
                                                                                                     open_large(bed))]
    for a, b in zip(*several):
        expect_same(a, b)


def test_files(tmp_path):
    bed = make_bed()
    np.save(tmp_path / "bed.npy", bed)
    bed.tofile(tmp_path / "bed.raw")
    expected = touch(image(bed), make_tip())
    expect_same(expected, touch(open_large(tmp_path / "bed.npy"), make_tip()))
    expect_same(expected, touch(open_large(np.memmap(tmp_path / "bed.raw", np.int16, "r", shape=bed.shape)),
                                make_tip()))


@pytest.mark.parametrize("view", [slice(None), slice(None, None, -1)])
def test_a_mapped_file_that_is_cut_off_is_told(tmp_path, view):
    """The file is shorter than its map; NumPy would read beyond its end, which kills the program."""
    path = tmp_path / "bed.raw"
    bed = make_bed()
    bed.tofile(path)
    volume = open_large(np.memmap(path, np.int16, "r", shape=bed.shape)[view], spacing=(1, 1, 1))
    with open(path, "r+b") as file:
        file.truncate(4096)
    with pytest.raises(ValueError, match="bed.raw ends at byte 4096"):
        touch(volume, make_tip())
    bed.tofile(path)
    expect_same(touch(image(np.ascontiguousarray(bed[view])), make_tip()), touch(volume, make_tip()))
    path.unlink()  # mapped memory can still be read
    expect_same(touch(image(np.ascontiguousarray(bed[view])), make_tip()), touch(volume, make_tip()))


class Group(dict):
    """A Zarr group, as open_large() uses one."""

    def __init__(self, arrays_of_levels, attrs):
        super().__init__(arrays_of_levels)
        self.attrs = attrs


def make_ome(axes="tczyx", **more):
    """Returns two levels as in OME-Zarr 0.4: scale and translation of each level, in the order of its axes, then those
    for all levels."""
    before = len(axes) - 3
    fine = make_bed()[(None,) * before]
    scales = {
        "axes": [{"name": name} for name in axes],
        "datasets": [
            {"path": "0", "coordinateTransformations": [{"type": "scale", "scale": [1] * before + [3.0, 2.0, 0.5]}]},
            {"path": "1", "coordinateTransformations": [
                {"type": "scale", "scale": [1] * before + [6.0, 4.0, 1.0]},
                {"type": "translation", "translation": [0] * before + [1.5, 1.0, 0.25]}]},
        ],
        **more,
    }
    return Group({"0": fine, "1": fine[..., ::2, ::2, ::2]}, {"multiscales": [scales]})


@pytest.fixture
def zarr(monkeypatch):
    """Replaces the module zarr by one that opens what the test assigns to `opened`."""
    module = type(sys)("zarr")
    module.open = lambda path, mode: module.opened
    monkeypatch.setitem(sys.modules, "zarr", module)
    return module


def test_ome_zarr_has_scale_and_translation(zarr):
    zarr.opened = make_ome()
    large = open_large("bed.zarr")
    assert large.GetWholeExtent() == (0, 299, 0, 59, 0, 79)
    assert (large.GetSpacing(), large.GetOrigin()) == ((0.5, 2.0, 3.0), (0.0, 0.0, 0.0))
    whole = image(make_bed(), spacing=(0.5, 2.0, 3.0))
    tip = make_tip() * (0.5, 2.0, 3.0)
    expect_same(touch(whole, tip), touch(large, tip))
    for level in (1, -1):
        coarse = open_large("bed.zarr", level=level)
        assert coarse.GetWholeExtent() == (0, 149, 0, 29, 0, 39)
        assert (coarse.GetSpacing(), coarse.GetOrigin()) == ((1.0, 4.0, 6.0), (0.25, 1.0, 1.5))
    own = open_large("bed.zarr", spacing=(1, 1, 1), origin=(7, 8, 9))
    assert (own.GetSpacing(), own.GetOrigin()) == ((1.0, 1.0, 1.0), (7.0, 8.0, 9.0))


def test_ome_zarr_of_other_shapes(zarr):
    every = [{"type": "scale", "scale": [10.0, 10.0, 10.0]}, {"type": "translation", "translation": [1.0, 2.0, 3.0]}]
    zarr.opened = make_ome("zyx", coordinateTransformations=every)
    coarse = open_large("bed.zarr", level=1)
    assert (coarse.GetSpacing(), coarse.GetOrigin()) == ((10.0, 40.0, 60.0), (5.5, 12.0, 16.0))
    # 1000 micrometres are one millimetre
    named = [{"name": name, "type": "space", "unit": "micrometer"} for name in "zyx"]
    plain = dict(zarr.opened.attrs)
    zarr.opened.attrs = {"multiscales": [{**plain["multiscales"][0], "axes": named}]}
    micro = open_large("bed.zarr", level=1)
    assert micro.GetSpacing() == pytest.approx((0.01, 0.04, 0.06), rel=1e-12)
    assert micro.GetOrigin() == pytest.approx((0.0055, 0.012, 0.016), rel=1e-12)
    zarr.opened.attrs = {"ome": plain}  # layout of version 0.5
    assert open_large("bed.zarr", level=1).GetSpacing() == (10.0, 40.0, 60.0)
    zarr.opened = make_bed()
    assert open_large("bed.zarr").GetSpacing() == (1.0, 1.0, 1.0)
    for opened, words in (
        (Group({}, {}), "multiscales"),
        (make_ome("zyxc"), "axes"),
        (make_ome("zyx", coordinateTransformations=[{"type": "rotation"}]), "neither a scale nor a translation"),
    ):
        zarr.opened = opened
        with pytest.raises(ValueError, match=words):
            open_large("bed.zarr")
    zarr.opened = make_ome()
    with pytest.raises(ValueError, match="2 levels"):
        open_large("bed.zarr", level=2)


def test_sizes_and_units_that_are_assumed_are_told(zarr):
    """Of what is in a file; an array in memory has none by itself."""
    stored = type("Array", (np.ndarray,), {"attrs": {}})  # as Zarr's and HDF5's arrays have attributes
    with pytest.warns(UserWarning, match="no size of a voxel: cubes of 1 mm are assumed"):
        open_large(make_bed().view(stored))
    zarr.opened = make_bed()
    with pytest.warns(UserWarning, match="no size of a voxel: cubes of 1 mm are assumed"):
        open_large("bed.zarr")
    zarr.opened = make_ome()
    with pytest.warns(UserWarning, match="no unit of length: millimetres are assumed"):
        open_large("bed.zarr")
    axes = [{"name": name, "unit": "millimeter"} for name in "zyx"]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        open_large("bed.zarr", spacing=(1, 1, 1))
        open_large(make_bed().view(stored), spacing=(1, 1, 1))
        open_large(make_bed())
        zarr.opened = make_ome("zyx")
        zarr.opened.attrs["multiscales"][0]["axes"] = axes
        open_large("bed.zarr")


def test_a_time_and_a_channel_are_chosen_by_a_number(zarr):
    opened = make_ome()
    for level in opened:
        opened[level] = np.stack([np.concatenate([opened[level][0] * 0 + 10 * t + c for c in range(3)]) for t in range(2)])
    for group in (opened, Group({"0": opened}, {"bioformats2raw.layout": 3})):
        zarr.opened = group
        for number, value in ((0, 0), (1, 0), (3, 2), (5, 11)):
            source = open_large("bed.zarr", series=number)
            part = vtkImageData()
            assert source.ReadRegion((0, 1, 0, 1, 0, 1), part)
            assert part.GetPointData().GetScalars().GetRange() == (value, value)
            assert source.GetCoarseImage().GetScalarRange() == (value, value)
    for number in (-1, 7):
        with pytest.raises(ValueError, match=f"6 volumes, and none with the number {number}. Cure: use series=1 to series=6"):
            open_large("bed.zarr", series=number)
    zarr.opened = make_ome()
    with pytest.raises(ValueError, match="Cure: leave series out"):
        open_large("bed.zarr", series=1)
    zarr.opened = np.stack([0 * make_bed(), make_bed()])
    assert open_large("bed.zarr", series=2).GetWholeExtent() == (0, 299, 0, 59, 0, 79)
    with pytest.raises(TypeError, match="series is of a file or a folder"):
        open_large(make_bed(), series=1)


def test_a_real_zarr_is_felt(tmp_path):
    zarr = pytest.importorskip("zarr")
    group = zarr.open(str(tmp_path / "bed.zarr"), mode="w")
    made = make_ome()
    for path, array in made.items():
        group[path] = array
    group.attrs.update(made.attrs)
    tip = make_tip() * (0.5, 2.0, 3.0)
    expect_same(touch(image(make_bed(), spacing=(0.5, 2.0, 3.0)), tip), touch(open_large(tmp_path / "bed.zarr"), tip))


@pytest.mark.parametrize("codec", [("Zstd", 3), ("Blosc", "zstd", 5, 2), ("BZ2", 5)])
def test_a_zarr_may_have_any_codec_of_zarr(tmp_path, codec):
    """Tries codecs that C++ does not unpack, too."""
    zarr = pytest.importorskip("zarr")
    numcodecs = pytest.importorskip("numcodecs")
    bed = make_bed()
    stored = zarr.open(str(tmp_path / "bed.zarr"), mode="w", shape=bed.shape, chunks=(16, 32, 64), dtype=bed.dtype,
                       compressor=getattr(numcodecs, codec[0])(*codec[1:]))
    stored[:] = bed
    expect_same(touch(image(bed), make_tip()), touch(open_large(tmp_path / "bed.zarr"), make_tip()))


def test_without_zarr_the_error_names_the_cure(monkeypatch):
    monkeypatch.setitem(sys.modules, "zarr", None)
    with pytest.raises(ImportError, match="pip install zarr"):
        open_large("bed.zarr")


@pytest.mark.parametrize("wrong, error, words", [
    (7, TypeError, "shape, dtype"),
    (np.zeros((4, 4)), ValueError, "three dimensions"),
    (np.zeros((4, 0, 4)), ValueError, "and voxels"),
    (np.zeros((4, 4, 4), complex), TypeError, "complex128"),
    (np.zeros((4, 4, 4), np.float16), TypeError, "astype"),
])
def test_what_is_no_volume_is_refused(wrong, error, words):
    with pytest.raises(error, match=words):
        open_large(wrong)


@pytest.mark.parametrize("name", ["spacing", "origin"])
def test_places_that_are_no_three_numbers_are_refused(name):
    with pytest.raises(ValueError, match=name):
        open_large(np.zeros((9, 9, 9)), **{name: (1, 2)})


def test_errors_of_the_array_are_those_of_touch():
    broken = Broken(make_bed())
    large = open_large(broken)
    with pytest.raises(ValueError, match="samples .* can't be read .* OSError: the server is gone"):
        touch(large, make_tip())
    broken.error = None
    expect_same(touch(image(make_bed()), make_tip()), touch(large, make_tip()))
    short = Sliced(make_bed())
    short.shape = (200, 60, 300)
    with pytest.raises(ValueError, match="its part is of shape"):
        touch(open_large(short), make_tip())
    with pytest.raises(ValueError, match="proposed"):
        touch(large, make_tip(), "propose")


def test_the_array_goes_with_the_source():
    gc.collect()
    before = set(_large._arrays)
    large = open_large(make_bed())
    assert set(_large._arrays) != before
    touch(large, make_tip(20))
    del large
    gc.collect()
    assert not set(_large._arrays) - before


def test_document(document, tmp_path, capsys):
    text = document("python.md").split("\n## Volumes larger than memory\n")[1].split("\n## ")[0]
    (code,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    code = code.replace("/tmp/", f"{tmp_path}/")
    exec(compile(code, "python.md", "exec"), {"np": np, "volumehaptics": volumehaptics, "arrays": arrays})
    assert re.fullmatch(r"\d+\.\d+ N\n", capsys.readouterr().out)


def feel_live(array, seconds=20.0, memory=67108864):
    """Runs a device on a large volume, whose thread needs Python's lock to read, until the samples around the tip are
    there."""
    large = open_large(array)
    large.SetMemoryLimit(memory)
    haptics = vtkVolumeHapticsFilter()
    haptics.SetInputConnection(large.GetOutputPort())
    device = vtkHapticDevice()
    device.SetVolumeHaptics(haptics)
    assert device.Open("virtual")
    device.GetVirtualHand().SetPosition(150, 30, 45)
    assert device.Start()
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        device.UpdateState()
        if device.GetState().GetTick() > 100 and device.GetState().GetResidency() == 1.0 and not large.IsWaiting():
            break
        time.sleep(0.005)
    return large, haptics, device


def test_live_another_thread_reads():
    sliced = Sliced(make_bed())
    large, haptics, device = feel_live(sliced)
    assert device.GetState().GetResidency() == 1.0 and large.GetStatusText() == ""
    assert len(sliced.threads) == 1 and threading.get_ident() not in sliced.threads
    assert haptics.GetInputDataObject(0, 0).GetNumberOfPoints() > 10000
    device.Stop()


def test_an_array_that_shrinks_while_it_is_felt_is_told_and_comes_back():
    whole = make_bed()
    sliced = Sliced(whole)
    large, haptics, device = feel_live(sliced, memory=4194304)  # a region holds a third of the array
    assert device.GetState().GetResidency() == 1.0
    errors = []
    large.AddObserver("ErrorEvent", lambda *_: errors.append(large.GetStatusText()))

    def lead(x, until):
        device.GetVirtualHand().SetPosition(x, 30, 45)
        end = time.monotonic() + 60
        while not until() and time.monotonic() < end:
            device.UpdateState()
            time.sleep(0.005)
        return until()

    sliced._array = whole[:, :, :160]  # as if another program had rewritten the store
    assert lead(290, lambda: "its part is of shape" in large.GetStatusText()), large.GetStatusText()
    assert errors and device.GetState().GetResidency() < 1.0
    sliced._array = whole
    assert lead(290, lambda: device.GetState().GetResidency() == 1.0 and not large.IsWaiting()), large.GetStatusText()
    assert large.GetStatusText() == ""
    device.Stop()


def test_a_source_can_go_while_python_reads_it():
    """Deleting a source, which happens with Python's lock held, must not wait for a thread that waits for that lock."""
    entered, leave = threading.Event(), threading.Event()

    class Slow(Sliced):
        def __getitem__(self, box):
            entered.set()
            assert leave.wait(60)
            return super().__getitem__(box)

    gc.collect()
    before = set(_large._arrays)
    large, haptics, device = feel_live(Slow(make_bed()), 0.3)
    assert entered.wait(60)
    device.Stop()
    del large, haptics, device
    gc.collect()
    assert set(_large._arrays) - before  # a thread is still reading
    leave.set()
    end = time.monotonic() + 60
    while set(_large._arrays) - before and time.monotonic() < end:
        time.sleep(0.005)
    assert not set(_large._arrays) - before


def test_python_ends_while_a_thread_reads():
    program = """
import sys, time
import numpy as np
from volumehaptics import open_large, vtkHapticDevice, vtkVolumeHapticsFilter

class Slow:
    shape, dtype = (90, 90, 90), np.dtype(np.int16)
    def __getitem__(self, box):
        time.sleep(0.2)
        return np.zeros((90, 90, 90), np.int16)[box]

haptics = vtkVolumeHapticsFilter()
large = open_large(Slow())
haptics.SetInputConnection(large.GetOutputPort())
device = vtkHapticDevice()
device.SetVolumeHaptics(haptics)
device.Open("virtual")
device.Start()
while device.GetState().GetTick() < 10:
    device.UpdateState()
    time.sleep(0.01)
print("ended")
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stdout, done.stderr) == (0, "ended\n", "")


def test_ome_zarr_has_a_coarser_level_that_stands_in(zarr):
    zarr.opened = make_ome()
    coarse = open_large("bed.zarr").GetCoarseImage()
    assert coarse.GetDimensions() == (150, 30, 40)
    assert (coarse.GetSpacing(), coarse.GetOrigin()) == ((1.0, 4.0, 6.0), (0.25, 1.0, 1.5))
    own = open_large("bed.zarr", spacing=(1, 1, 1), origin=(7, 8, 9)).GetCoarseImage()
    assert (own.GetSpacing(), own.GetOrigin()) == ((2.0, 2.0, 2.0), (7.5, 8.5, 9.5))
    assert open_large("bed.zarr", level=-1).GetCoarseImage() is None
    assert open_large("bed.zarr", coarse=False).GetCoarseImage() is None
    del zarr.opened["1"]  # only the finest level was copied
    assert open_large("bed.zarr").GetCoarseImage() is None
    with pytest.raises(ValueError, match="has no array 1"):
        open_large("bed.zarr", level=1)


def test_a_coarse_array_lies_on_the_fine_one():
    bed = make_bed()
    large = open_large(bed, (0.5, 1, 2), (1, 2, 3), coarse=bed[::4, ::4, ::4])
    coarse = large.GetCoarseImage()
    assert coarse.GetDimensions() == (75, 15, 20)
    assert (coarse.GetSpacing(), coarse.GetOrigin()) == ((2.0, 4.0, 8.0), (1.75, 3.5, 6.0))
    assert coarse.GetPointData().GetScalars().GetTuple1(1) == bed[0, 0, 4]
    expect_same(touch(image(bed, (0.5, 1, 2), (1, 2, 3)), make_tip() * (0.5, 1, 2) + (1, 2, 3)),
                touch(large, make_tip() * (0.5, 1, 2) + (1, 2, 3)))
    with pytest.raises(TypeError, match="coarse is an array"):
        open_large(bed, coarse=bed[0])


def test_a_filter_keeps_a_source_that_nothing_else_holds():
    haptics = vtkVolumeHapticsFilter()
    haptics.SetInputConnection(open_large(make_bed()).GetOutputPort())
    gc.collect()
    haptics.SetPathData(volumehaptics.path(make_tip()))
    haptics.Update()
    expect_same(touch(image(make_bed()), make_tip()), haptics.GetOutput())
