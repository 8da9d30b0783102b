# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes FreeSurfer's MGH and MGZ by nibabel, MINC 1 by nibabel's NetCDF writer, and MINC 2 by h5py. All use
right-anterior-superior; the phantom's grids use left-posterior-superior."""

import gzip

import h5py
import nibabel
import numpy as np
from cases import case
from nibabel.externals.netcdf import netcdf_file
from phantom import Grid, turned

GRID = Grid()
TO_RAS = np.diag([-1.0, -1.0, 1.0, 1.0])


def save_mgh(folder, voxels, affine, name):
    nibabel.save(nibabel.MGHImage(voxels, affine), folder / name)
    return folder / name


def mgh_case(name, grid=GRID, dtype=np.int16, file="head.mgz", voxels=None, chosen=(), **facts):
    @case(f"mgh-{name}", options=chosen, **facts)
    def write(folder):
        samples = grid.sample(float) if voxels is None else voxels()
        return save_mgh(folder, samples.astype(dtype), TO_RAS @ grid.affine, file)


mgh_case("plain", source="DATA.md: MGZ is a header of 284 bytes")
mgh_case("unpacked", file="head.mgh")
mgh_case("oblique", Grid(axes=turned(35.0)), dtype=np.float32)
mgh_case("coronal", Grid(axes=np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]])), file="head.mgh",
         source="FreeSurfer conforms to coronal slices")
mgh_case("mirrored", Grid(axes=np.diag([-1.0, 1.0, 1.0])), dtype=np.int32)
mgh_case("bytes", dtype=np.uint8, voxels=lambda: np.round(GRID.sample(float) * 0.2 + 200.0), offset=200.0, scale=0.2,
         chosen=("--preset", "histogram"))


def frames():
    return np.stack([np.zeros(GRID.size), GRID.sample(float), np.zeros(GRID.size)], axis=3)


mgh_case("first-of-frames", voxels=lambda: frames()[..., 1:], told=("of 2 frames the first one is used",))
mgh_case("second-frame", voxels=frames, chosen=("--series", "2"), told=("frame 2 of 3",))
mgh_case("second-frame-unpacked", voxels=frames, chosen=("--series", "2"), file="head.mgh")
mgh_case("no-such-frame", voxels=frames, chosen=("--series", "4"), refused="3 frames, and none with the number 4")


@case("mgh-no-place", source="FreeSurfer's mriio.cpp: without goodRASFlag the slices are coronal",
      told=("no position: coronal slices of 1 mm",), steps=(1.0, 1.0, 1.0), first=(-22.0, -19.0, -20.0))
def no_place(folder):
    """Returns coronal slices that go from right to left, from head to feet, and from back to front."""
    path = save_mgh(folder, GRID.sample().transpose(0, 2, 1)[:, ::-1, ::-1], TO_RAS @ GRID.affine, "head.mgh")
    raw = bytearray(path.read_bytes())
    raw[28:30] = b"\0\0"
    path.write_bytes(raw)
    return path


def damaged_mgh(name, change, refused, file="head.mgh"):
    @case(f"mgh-{name}", refused=refused)
    def write(folder):
        path = save_mgh(folder, GRID.sample(), TO_RAS @ GRID.affine, file)
        path.write_bytes(change(bytearray(path.read_bytes())))
        return path


damaged_mgh("cut-off", lambda raw: raw[:-60000], "announces more voxels than the file has")
damaged_mgh("cut-off-packed", lambda raw: raw[:-5000], "damaged|cut off|truncated|announces", "head.mgz")
damaged_mgh("promises-more", lambda raw: raw[:4] + np.array([30000] * 3, ">i4").tobytes() + raw[16:],
            "announces more voxels than the file has")
damaged_mgh("promises-more-packed", lambda raw: gzip.compress(
    (lambda plain: plain[:4] + np.array([30000] * 3, ">i4").tobytes() + plain[16:])(gzip.decompress(bytes(raw)))),
            "announces more voxels than the file has", "head.mgz")
damaged_mgh("negative-size", lambda raw: raw[:4] + np.array([-4], ">i4").tobytes() + raw[8:], "no whole number above 0")
damaged_mgh("unknown-type", lambda raw: raw[:20] + np.array([7], ">i4").tobytes() + raw[24:], "a type that FreeSurfer")
damaged_mgh("of-text", lambda raw: b"hello", "no file of FreeSurfer")


# MINC


def save_minc(folder, grid=GRID, dtype=np.int16, signtype="signed__", per_slice=True, order="zyx", units="mm",  # noqa: PLR0913
              extra=None, second=False, valid=None, limits=True, **facts):
    """Names the image dimensions in `order`, slowest first; `extra` is the name of another dimension, which is still
    slower."""
    path = folder / "head.mnc"
    file = netcdf_file(str(path), "w")
    affine = TO_RAS @ grid.affine
    names = [f"{letter}space" for letter in order]
    values = grid.sample(float).transpose(["xyz".index(letter) for letter in order])
    sizes = dict(zip(names, values.shape))
    if extra:
        names.insert(0, extra)
        values = np.stack([values * 0.0 + 7.0, values][:: 1 if second else -1])
        sizes[extra] = 2
    for name in names:
        file.createDimension(name, sizes[name])
        along = file.createVariable(name, "d", ())
        along.spacing = b"regular__"
        if name.endswith("space"):
            axis = "xyz".index(name[0])
            step = np.linalg.norm(affine[:3, axis])
            cosines = affine[:3, axis] / step
            if cosines[axis] < 0.0:  # as MINC's tools write the axis
                step, cosines = -step, -cosines
            along.units = units.encode()
            along.step = step
            along.direction_cosines = cosines
    inverse = np.linalg.inv(np.stack([file.variables[f"{letter}space"].direction_cosines for letter in "xyz"], axis=1))
    for letter, start in zip("xyz", inverse @ affine[:3, 3]):
        file.variables[f"{letter}space"].start = start
    for name, value in facts.items():
        setattr(file.variables["zspace"], name, value)
    image = file.createVariable("image", np.dtype(dtype).newbyteorder(">"), tuple(names))
    stored = values
    axes = tuple(range(1, values.ndim)) if per_slice else None
    low, high = values.min(axes), values.max(axes) + 1.0
    if np.issubdtype(dtype, np.integer):
        bits = 8 * np.dtype(dtype).itemsize
        first = -(2.0 ** (bits - 1)) if signtype == "signed__" else 0.0
        valid = valid or (first, first + 2.0**bits - 1.0)
        image.signtype = signtype.encode()
        image.valid_range = np.array(valid)
        wide = (Ellipsis,) + (None,) * (values.ndim - 1) if per_slice else ()
        part = (values - np.asarray(low)[wide]) / (np.asarray(high) - np.asarray(low))[wide]
        stored = np.round(valid[0] + part * (valid[1] - valid[0])).astype(np.int64)
    image[:] = stored.astype(image.data.dtype)
    if limits:
        for name, limit in (("image-min", low), ("image-max", high)):
            variable = file.createVariable(name, "d", tuple(names[:1]) if per_slice else ())
            if per_slice:
                variable[:] = limit
            else:
                variable.data[...] = limit
    file.close()
    return path


def minc_case(name, options=(), refused=None, told=(), source="", tolerance=1.0, **how):
    @case(f"minc-{name}", options=options, refused=refused, told=told, source=source, tolerance=tolerance)
    def write(folder):
        return save_minc(folder, **how)


minc_case("plain", source="DATA.md: VTK reads MINC; MINC programmer's guide")
minc_case("one-scale", per_slice=False)
minc_case("unsigned", dtype=np.int16, signtype="unsigned")
minc_case("bytes", dtype=np.int8, signtype="unsigned", tolerance=3.0)
minc_case("int32", dtype=np.int32)
minc_case("float", dtype=np.float32)
minc_case("double", dtype=np.float64)
minc_case("valid-range", valid=(0.0, 4095.0))
minc_case("sagittal", order="xzy")
minc_case("mirrored", grid=Grid(axes=np.diag([1.0, -1.0, 1.0])))
minc_case("oblique", grid=Grid(axes=turned(20.0)))
minc_case("times", extra="time", told=("of 2 times the first one is used",))
minc_case("the-second-time", extra="time", second=True, options=("--series", "2"), told=("time 2 of 2",))
minc_case("irregular", refused="unevenly spaced", spacing=b"irregular")
minc_case("no-limits", refused="no image-min", limits=False)


@case("minc-cut-off", refused="announces more voxels than the file has")
def minc_cut_off(folder):
    path = save_minc(folder, per_slice=False)
    path.write_bytes(path.read_bytes()[:-60000])
    return path


def changed_minc(name, change, refused):
    @case(f"minc-{name}", refused=refused)
    def write(folder):
        path = save_minc(folder)
        path.write_bytes(change(path.read_bytes()))
        return path


changed_minc("of-text", lambda raw: b"hello" + raw, "it is no MINC file")
changed_minc("no-image", lambda raw: raw.replace(b"image\0\0\0", b"imagf\0\0\0"), "it has no image")
changed_minc("no-space", lambda raw: raw.replace(b"xspace", b"wspace"), "does not have the dimensions xspace")


@case("minc-header-cut-off", refused="header is damaged or cut off")
def minc_header_cut_off(folder):
    path = save_minc(folder)
    path.write_bytes(path.read_bytes()[:300])
    return path


@case("minc-2", refused="MINC 2, in HDF5, which is not supported", source="nibabel/tests/data/small.mnc")
def minc2(folder):
    with h5py.File(folder / "head.mnc", "w") as file:
        file["minc-2.0/image/0/image"] = GRID.sample().transpose()
    return folder / "head.mnc"
