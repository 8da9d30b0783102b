# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes NRRD by pynrrd, MetaImage by SimpleITK, TIFF by tifffile, Zarr by zarr, and files that are refused by their
names."""

import json

import h5py
import nrrd
import numpy as np
import SimpleITK
import tifffile
import zarr
from cases import case
from phantom import CENTRE, Grid, turned

GRID = Grid()


# NRRD


def nrrd_header(grid=GRID, space="left-posterior-superior", turn=(1.0, 1.0, 1.0), per_mm=1.0, **more):
    axes = np.diag(turn) @ grid.affine[:3, :3] * per_mm
    return {"space": space, "space directions": axes.T, "space origin": np.array(turn) * grid.origin * per_mm,
            "kinds": ["domain"] * 3, "encoding": "gzip", **more}


def save_nrrd(folder, header, voxels=None, name="head.nrrd", **options):
    folder.mkdir(parents=True, exist_ok=True)
    nrrd.write(str(folder / name), GRID.sample() if voxels is None else voxels, header, **options)
    return folder / name


def nrrd_case(name, header, voxels=None, file="head.nrrd", options=None, chosen=(), **facts):
    @case(f"nrrd-{name}", options=chosen, **facts)
    def write(folder):
        return save_nrrd(folder, dict(header), voxels() if voxels else None, file, **(options or {}))


nrrd_case("plain", nrrd_header())
nrrd_case("raw", nrrd_header(encoding="raw"))
nrrd_case("detached", nrrd_header(), file="head.nhdr")
nrrd_case("detached-raw", nrrd_header(encoding="raw"), file="head.nhdr")
nrrd_case("big-endian", nrrd_header(endian="big", encoding="raw"), voxels=lambda: GRID.sample(">i2"))
nrrd_case("ras", nrrd_header(space="right-anterior-superior", turn=(-1.0, -1.0, 1.0)))
nrrd_case("las", nrrd_header(space="left-anterior-superior", turn=(1.0, -1.0, 1.0)))
nrrd_case("oblique", nrrd_header(Grid(axes=turned(25.0))), voxels=lambda: Grid(axes=turned(25.0)).sample())
nrrd_case("left-handed", nrrd_header(Grid(axes=np.diag([1.0, 1.0, -1.0]))),
          voxels=lambda: Grid(axes=np.diag([1.0, 1.0, -1.0])).sample())
for unit, per_mm in (("um", 1000.0), ("microns", 1000.0), ("m", 0.001), ("mm", 1.0)):
    nrrd_case(f"space-units-{unit}", nrrd_header(per_mm=per_mm, **{"space units": [unit] * 3}),
              source="Slicer#7631")
for per_mm in (1e-9, 1e6):
    nrrd_case(f"spacing-of-{per_mm:g}", nrrd_header(per_mm=per_mm), source="DATA.md: spacing of 1e-9 or 1e6",
              steps=tuple(GRID.spacing * per_mm), first=tuple(GRID.origin * per_mm))
nrrd_case("bzip2", nrrd_header(encoding="bzip2"), refused="bzip2|--large")
nrrd_case("ascii", nrrd_header(encoding="ascii"), source="teem: encoding ascii")
nrrd_case("float", nrrd_header(), voxels=lambda: GRID.sample(float).astype(np.float32))
nrrd_case("double", nrrd_header(), voxels=lambda: GRID.sample(float))
nrrd_case("int64", nrrd_header(), voxels=lambda: GRID.sample(np.int64), source="NumPy's integers")


def several(first, axis):
    return lambda: np.stack([first(), np.zeros(GRID.size, first().dtype)], axis=axis)


def channel_header(axis, kind):
    header = nrrd_header()
    directions = [list(row) for row in header["space directions"]]
    directions.insert(axis, [np.nan] * 3)
    kinds = ["domain"] * 3
    kinds.insert(axis, kind)
    return {**header, "space directions": np.array(directions), "kinds": kinds}


nrrd_case("vector-first", channel_header(0, "vector"), voxels=several(GRID.sample, 0), source="SimpleITK's vector images",
          told=("component|channel|first",))
nrrd_case("list-first", channel_header(0, "list"), voxels=several(GRID.sample, 0), source="Slicer's sequences",
          told=("component|channel|first|frames|time",))
nrrd_case("list-last", channel_header(3, "list"), voxels=several(GRID.sample, 3),
          told=("component|channel|first|frames|time",))
for name, header, axis in (("vector-first", channel_header(0, "vector"), 0), ("list-last", channel_header(3, "list"), 3)):
    for encoding in ("raw", "gzip"):
        nrrd_case(f"{name}-the-second-{encoding}", {**header, "encoding": encoding}, options={},
                  voxels=lambda axis=axis: np.stack([0 * GRID.sample(), GRID.sample(), 1 + 0 * GRID.sample()], axis=axis),
                  told=("(component|volume) 2 of 3 is used",), chosen=("--series", "2"))
nrrd_case("vector-first-of-which-none-is-chosen", channel_header(0, "vector"), voxels=several(GRID.sample, 0),
          refused="has 2 components, and none with the number 3", chosen=("--series", "3"))


def save_segments(folder, masks, layers):
    """Writes a segmentation as 3D Slicer does: a layer for each segment, or one layer for all."""
    voxels = np.stack(masks) if layers else masks[0] + 2 * masks[1]
    header = {**(channel_header(0, "list") if layers else nrrd_header()), "Segmentation_MasterRepresentation": "Binary labelmap"}
    for number, name in enumerate(("ball", "knob")):
        header.update({f"Segment{number}_ID": name, f"Segment{number}_Name": name,
                       f"Segment{number}_Layer": str(number if layers else 0),
                       f"Segment{number}_LabelValue": "1" if layers else str(number + 1)})
    return save_nrrd(folder, header, voxels.astype(np.uint8), "head.seg.nrrd")


def nrrd_segments(overlapping=False):
    body = GRID.sample(float) > -470.0
    left = GRID.points()[..., 0] > CENTRE[0] + 20.5
    return [body if overlapping else body & ~left, body & left]


@case("nrrd-seg", source="3D Slicer's .seg.nrrd", labels=("ball", "knob"))
def seg(folder):
    return save_segments(folder, nrrd_segments(), layers=False)


@case("nrrd-seg-in-layers", source="3D Slicer's .seg.nrrd of segments that overlap", labels=("ball", "knob"),
      told=("labels in 2 layers: where several are in a voxel, the last one in the file counts",))
def seg_in_layers(folder):
    return save_segments(folder, nrrd_segments(overlapping=True), layers=True)


for chosen, alone in (("1", "body"), ("2", "knob")):

    @case(f"nrrd-seg-in-layers-{alone}", source="3D Slicer's .seg.nrrd of segments that overlap", labels=("ball", "knob"),
          alone=alone, options=("--series", chosen), told=(f"segment {chosen} .* is read alone",))
    def seg_alone(folder):
        return save_segments(folder, nrrd_segments(overlapping=True), layers=True)


@case("nrrd-seg-of-which-none-is-chosen", refused="has 2 segments, and none with the number 3", options=("--series", "3"))
def seg_none(folder):
    return save_segments(folder, nrrd_segments(), layers=False)


@case("nrrd-axis-mins", source="teem: axis mins place the first sample", steps=tuple(GRID.spacing), first=tuple(GRID.origin))
def axis_mins(folder):
    header = {"spacings": list(GRID.spacing), "axis mins": list(GRID.origin), "encoding": "gzip",
              "kinds": ["space"] * 3}
    return save_nrrd(folder, header)


@case("nrrd-cells", source="teem: axis mins of cells is the border of the first one", steps=tuple(GRID.spacing),
      first=tuple(GRID.origin))
def cells(folder):
    header = {"spacings": list(GRID.spacing), "axis mins": list(GRID.origin - 0.5 * GRID.spacing), "encoding": "gzip",
              "centerings": ["cell"] * 3}
    return save_nrrd(folder, header)


def slices_apart(name, line):
    """Writes a raw file for each slice, named as in teem's definition of the format."""

    @case(f"nrrd-{name}", source="teem: data file LIST, or a pattern")
    def write(folder):
        path = save_nrrd(folder, nrrd_header(encoding="raw"), name="head.nhdr")
        (folder / "head.raw").unlink()
        voxels = GRID.sample()
        names = [f"slice{k:03d}.raw" for k in range(GRID.size[2])]
        for k, one in enumerate(names):
            voxels[:, :, k].T.astype("<i2").tofile(folder / one)
        text = path.read_text().strip().replace("data file: head.raw\n", "")
        path.write_text("\n".join([one for one in text.splitlines() if not one.startswith("data file")])
                        + "\n" + line(names) + "\n")
        return path


slices_apart("files-listed", lambda names: "\n".join(["data file: LIST", *names]))
slices_apart("files-numbered", lambda names: f"data file: slice%03d.raw 0 {len(names) - 1} 1")


@case("nrrd-spacings-only", steps=tuple(GRID.spacing))
def spacings_only(folder):
    return save_nrrd(folder, {"spacings": list(GRID.spacing), "encoding": "raw"})


@case("nrrd-byte-skip-minus-1", source="teem: samples at the end of the file")
def byte_skip(folder):
    save_nrrd(folder, nrrd_header(encoding="raw"), name="head.nhdr")
    data = folder / "head.raw"
    data.write_bytes(b"a header of some other program" + data.read_bytes())
    text = (folder / "head.nhdr").read_text()
    (folder / "head.nhdr").write_text(text.replace("data file:", "byte skip: -1\ndata file:"))
    return folder / "head.nhdr"


@case("nrrd-cut-off", refused="cut off|truncated|announces|damaged|fewer|short|complete|not in the file")
def nrrd_cut(folder):
    path = save_nrrd(folder, nrrd_header(encoding="raw"))
    path.write_bytes(path.read_bytes()[:-9999])
    return path


@case("nrrd-promises-more", refused="cut off|truncated|announces|damaged|fewer|short|complete|not in the file|announces|truncated")
def nrrd_more(folder):
    path = save_nrrd(folder, nrrd_header(encoding="raw"))
    path.write_bytes(path.read_bytes().replace(b"sizes: 44 40 42", b"sizes: 44000 40000 42000"))
    return path


# MetaImage


def itk_image(grid=GRID, voxels=None, dtype=np.int16):
    made = SimpleITK.GetImageFromArray((grid.sample(dtype) if voxels is None else voxels).transpose(2, 1, 0))
    made.SetSpacing(grid.spacing.tolist())
    made.SetOrigin(grid.origin.tolist())
    made.SetDirection(grid.axes.ravel().tolist())
    return made


def meta_case(name, make, file="head.mha", compressed=False, change=None, **facts):
    @case(f"meta-{name}", **facts)
    def write(folder):
        folder.mkdir(parents=True, exist_ok=True)
        SimpleITK.WriteImage(make(), str(folder / file), compressed)
        if change:
            change(folder / file)
        return folder / file


def replace(*pairs):
    def change(path):
        raw = path.read_bytes()
        for old, new in pairs:
            assert old in raw, old
            raw = raw.replace(old, new, 1)
        path.write_bytes(raw)

    return change


meta_case("plain", itk_image)
meta_case("compressed", itk_image, compressed=True)
meta_case("mhd", itk_image, "head.mhd")
meta_case("mhd-compressed", itk_image, "head.mhd", True)
meta_case("oblique", lambda: itk_image(Grid(axes=turned(40.0))))
meta_case("mirrored", lambda: itk_image(Grid(axes=np.diag([1.0, -1.0, 1.0]))))
meta_case("int64", lambda: itk_image(dtype=np.int64), source="SimpleITK's default from NumPy integers")
meta_case("float64", lambda: itk_image(dtype=np.float64), tolerance=1.0)
meta_case("uint16", lambda: itk_image(voxels=(GRID.sample(np.int32) + 1024).astype(np.uint16)), offset=1024.0)
meta_case("4d", lambda: SimpleITK.JoinSeries([itk_image(), itk_image()]), source="SimpleITK's 4-D",
          told=("frames|time|first",))
meta_case("4d-compressed", lambda: SimpleITK.JoinSeries([itk_image(), itk_image()]), compressed=True,
          source="SimpleITK's 4-D", told=("times|first",))
meta_case("int64-compressed", lambda: itk_image(dtype=np.int64), compressed=True, source="labels of SimpleITK")
for name, make in (("4d", SimpleITK.JoinSeries), ("vector", SimpleITK.Compose)):
    meta_case(f"{name}-as-nrrd", lambda make=make: make([itk_image(), itk_image()]), "head.nrrd", told=("first",),
              source="SimpleITK writes NRRD")
meta_case("vector", lambda: SimpleITK.Compose([itk_image(), itk_image()]), told=("component|channel|first",))
meta_case("vector-of-which-the-second-is-chosen", lambda: SimpleITK.Compose([itk_image() * 0, itk_image()]),
          told=("component 1 used",), options=("--series", "2"), source="DATA.md: a chooser where there are several")
meta_case("vector-of-which-none-is-chosen", lambda: SimpleITK.Compose([itk_image(), itk_image()]),
          refused="has 2 components, and none with the number 3", options=("--series", "3"))
for name, compressed in (("4d", False), ("4d-compressed", True)):
    meta_case(f"{name}-the-second", lambda: SimpleITK.JoinSeries([itk_image() * 0, itk_image(), itk_image() * 0 + 1]),
              compressed=compressed, told=("volume 2 of 3 is used",), options=("--series", "2"), source="SimpleITK's 4-D")
meta_case("4d-of-which-none-is-chosen", lambda: SimpleITK.JoinSeries([itk_image(), itk_image()]),
          refused="has 2 volumes, and none with the number 3", options=("--series", "3"))
meta_case("no-other-to-choose", itk_image, refused="has one volume only", options=("--series", "2"))
meta_case("met-long", lambda: itk_image(dtype=np.int32), change=replace((b"MET_INT", b"MET_LONG")),
          source="MetaIO: MET_LONG has 4 bytes")
# MetaIO has buffers for 254 letters (char m_Comment[255] of metaObject.h, name[255] of metaUtils.h), and arrays of
# fixed size for NDims.
for name, line in (("comment-of-300-letters", b"Comment = " + 300 * b"c"), ("key-of-300-letters", 300 * b"k" + b" = 1"),
                   ("dimensions-told-again", b"NDims : 100")):
    meta_case(name, itk_image, change=replace((b"NDims = 3\n", b"NDims = 3\n" + line + b"\n")),
              source="MetaIO: strcpy() of metaUtils.cxx and metaObject.cxx")
meta_case("cut-off", itk_image, change=lambda path: path.write_bytes(path.read_bytes()[:-3000]),
          refused="cut off|truncated|announces|damaged|fewer|short|complete|not in the file")
meta_case("promises-more", itk_image, change=replace((b"DimSize = 44 40 42", b"DimSize = 44000 40000 42000")),
          refused="cut off|truncated|announces|damaged|fewer|short|complete|not in the file|announces|truncated")
meta_case("no-samples", itk_image, "head.mhd", change=lambda path: (path.parent / "head.raw").unlink(),
          refused="missing")
meta_case("two-dimensions", lambda: itk_image()[:, :, 20], refused="single slice|two dimensions|2")


# TIFF


def tiff(folder, name="stack.tif", voxels=None, **options):
    folder.mkdir(parents=True, exist_ok=True)
    pages = (GRID.sample() if voxels is None else voxels).transpose(2, 1, 0)
    tifffile.imwrite(folder / name, pages, photometric="minisblack", **options)
    return folder / name


IMAGEJ = {"imagej": True, "resolution": (1.0 / GRID.spacing[0], 1.0 / GRID.spacing[1]),
          "metadata": {"spacing": GRID.spacing[2], "unit": "mm", "axes": "ZYX"}}
UNSIGNED = (GRID.sample(np.int32) + 1000).astype(np.uint16)


def tiff_case(name, voxels=UNSIGNED, scale=1.0, offset=1000.0, file="stack.tif", told=(), refused=None, source="",
              tolerance=1.0, steps=(1.5, 1.6, 1.7), **options):
    @case(f"tiff-{name}", scale=scale, offset=offset, steps=steps, told=told, refused=refused, source=source,
          tolerance=tolerance, options=("--preset", "histogram"))
    def write(folder):
        return tiff(folder, file, voxels, **options)


tiff_case("imagej-16", **IMAGEJ, source="ImageJ's tags")
tiff_case("imagej-8", GRAY8 := np.round(UNSIGNED * 0.2).astype(np.uint8), 0.2, 200.0, **IMAGEJ)
tiff_case("imagej-float", UNSIGNED.astype(np.float32), **IMAGEJ)
tiff_case("imagej-micrometres", imagej=True, resolution=(0.001 / 1.5, 0.001 / 1.6),
          metadata={"spacing": 1700.0, "unit": "um", "axes": "ZYX"})
tiff_case("imagej-spacing-of-1", imagej=True, resolution=(1.0 / 1.5, 1.0 / 1.6), metadata={"unit": "mm", "axes": "ZYX"},
          steps=(1.5, 1.6, 1.0), source="ImageJ's FileSaver leaves out a pixelDepth of 1.0")
tiff_case("imagej-big-endian", byteorder=">", **IMAGEJ)
tiff_case("ome", file="stack.ome.tif", ome=True, source="OME-TIFF's PhysicalSize",
          metadata={"axes": "ZYX", "PhysicalSizeX": 1500.0, "PhysicalSizeXUnit": "µm", "PhysicalSizeY": 1600.0,
                    "PhysicalSizeYUnit": "µm", "PhysicalSizeZ": 1700.0, "PhysicalSizeZUnit": "µm"})
tiff_case("resolution-in-cm", resolution=(10.0 / 1.5, 10.0 / 1.6), resolutionunit="CENTIMETER", metadata=None,
          told=("distance",), steps=(1.5, 1.6, 1.5))
CUBES = {"metadata": None, "steps": (1.0, 1.0, 1.0), "told": ("voxel",)}
tiff_case("no-resolution", **CUBES)
for compression in ("zlib", "lzw", "packbits"):
    tiff_case(compression, compression=compression, **CUBES)
tiff_case("tiled", tile=(16, 16), **CUBES)
tiff_case("bigtiff", bigtiff=True, **CUBES)
tiff_case("int16", GRID.sample(), 1.0, 0.0, **CUBES)
tiff_case("float64", GRID.sample(float), 1.0, 0.0, **CUBES)
tiff_case("uint32", UNSIGNED.astype(np.uint32), **CUBES)


@case("tiff-imagej-calibrated", steps=(1.5, 1.6, 1.7), told=("values are -1010 plus 0.5 times",), tolerance=0.51,
      source="ij.measure.Calibration: the function cf = 0 is c0 + c1 x")
def tiff_calibrated(folder):
    options = dict(IMAGEJ, metadata={**IMAGEJ["metadata"], "cf": 0, "c0": -1010.0, "c1": 0.5, "vunit": "HU"})
    return tiff(folder, "stack.tif", (2 * (GRID.sample(np.int32) + 1010)).astype(np.uint16), **options)


@case("tiff-imagej-signed", steps=(1.5, 1.6, 1.7), told=("values are -32768 plus 1 times",),
      source="ImageJ stores signed 16 bits as others, with c0 = -32768")
def tiff_signed(folder):
    options = dict(IMAGEJ, metadata={**IMAGEJ["metadata"], "cf": 0, "c0": -32768.0, "c1": 1.0})
    return tiff(folder, "stack.tif", (GRID.sample(np.int32) + 32768).astype(np.uint16), **options)


def hyperstack(other):
    """Writes two times of three channels; the second channel of the second time is the phantom."""
    voxels = np.full((2, GRID.size[2], 3, GRID.size[1], GRID.size[0]), other, np.uint16)
    voxels[1, :, 1] = UNSIGNED.transpose(2, 1, 0)
    return voxels  # TZCYX


CHANNELS = {"offset": 1000.0, "steps": (1.5, 1.6, 1.7), "options": ("--preset", "histogram", "--series", "5")}


@case("tiff-imagej-the-fifth", source="ImageJ's hyperstacks", told=("channel 2 of 3, time 2 of 2 is used",), **CHANNELS)
def tiff_hyperstack(folder):
    folder.mkdir(parents=True, exist_ok=True)
    options = dict(IMAGEJ, metadata={**IMAGEJ["metadata"], "axes": "TZCYX"})
    tifffile.imwrite(folder / "stack.tif", hyperstack(7), **options)
    return folder / "stack.tif"


@case("tiff-imagej-behind-one-page", source="ImageJ's stacks of more than 4 GiB: one directory, all images behind it",
      told=("channel 2 of 3, time 2 of 2 is used",), **CHANNELS)
def tiff_behind(folder):
    folder.mkdir(parents=True, exist_ok=True)
    voxels = hyperstack(7).reshape(-1, GRID.size[1], GRID.size[0])
    text = (f"ImageJ=1.54f\nimages={len(voxels)}\nchannels=3\nslices={GRID.size[2]}\nframes=2\nhyperstack=true\n"
            f"unit=mm\nspacing={GRID.spacing[2]}\n")
    with tifffile.TiffWriter(folder / "stack.tif", bigtiff=False) as writer:
        writer.write(voxels[0], description=text, metadata=None, resolution=IMAGEJ["resolution"], photometric="minisblack")
    with open(folder / "stack.tif", "r+b") as file:
        with tifffile.TiffFile(folder / "stack.tif") as first:
            file.seek(first.pages[0].dataoffsets[0])
        file.write(voxels.astype("<u2").tobytes())
    return folder / "stack.tif"


def ome_channels(order):
    axes = {"T": 0, "Z": 1, "C": 2}
    voxels = np.moveaxis(hyperstack(7), [axes[axis] for axis in order], range(3))

    def write(folder):
        folder.mkdir(parents=True, exist_ok=True)
        tifffile.imwrite(folder / "stack.ome.tif", voxels, ome=True, photometric="minisblack", metadata={
            "axes": order + "YX", "PhysicalSizeX": 1.5, "PhysicalSizeXUnit": "mm", "PhysicalSizeY": 1.6,
            "PhysicalSizeYUnit": "mm", "PhysicalSizeZ": 1.7, "PhysicalSizeZUnit": "mm",
            "Channel": {"Name": ["Actin", "DAPI", "Mitochondria"]}})
        return folder / "stack.ome.tif"

    return write


for order in ("TCZ", "TZC", "CTZ"):
    case(f"tiff-ome-channels-{order}", source="OME-TIFF's DimensionOrder",
         told=(r"channel 2 of 3 \(DAPI\), time 2 of 2 is used",), **CHANNELS)(ome_channels(order))


@case("tiff-ome-of-which-none-is-chosen", refused="has 3 channels and 2 times, and none with the number 7",
      options=("--series", "7"))
def tiff_no_channel(folder):
    return ome_channels("TCZ")(folder)


@case("tiff-ome-a-file-for-each-channel", told=("channel 2 of 2 is used", "slices are in 1 file,"), offset=1000.0,
      steps=(1.5, 1.6, 1.7), options=("--preset", "histogram", "--series", "2"),
      source="the OME-TIFF specification: channels in files of their own")
def tiff_channel_files(folder):
    folder.mkdir(parents=True, exist_ok=True)
    size, step = GRID.size, GRID.spacing
    planes = "".join(f'<TiffData FirstC="{c}" FirstT="0" FirstZ="0" IFD="0" PlaneCount="{size[2]}">'
                     f'<UUID FileName="channel{c}.ome.tif">urn:uuid:{c}</UUID></TiffData>' for c in range(2))
    xml = ('<?xml version="1.0" encoding="UTF-8"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06">'
           '<Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="XYZCT" Type="uint16" SizeC="2" SizeT="1" '
           f'SizeX="{size[0]}" SizeY="{size[1]}" SizeZ="{size[2]}" PhysicalSizeX="{step[0]}" PhysicalSizeXUnit="mm" '
           f'PhysicalSizeY="{step[1]}" PhysicalSizeYUnit="mm" PhysicalSizeZ="{step[2]}" PhysicalSizeZUnit="mm">'
           f"{planes}</Pixels></Image></OME>")
    for c in range(2):
        pages = (UNSIGNED if c else 0 * UNSIGNED + 7).transpose(2, 1, 0)
        tifffile.imwrite(folder / f"channel{c}.ome.tif", pages, photometric="minisblack", description=xml, metadata=None)
    return folder / "channel0.ome.tif"


def ome_files(folder, lost=False, is_odd=False, is_short=False):
    """Writes a stack as Bio-Formats does: files of two slices each, and OME-XML that names all files, also by their
    slices."""
    folder.mkdir(parents=True, exist_ok=True)
    size, step = GRID.size, GRID.spacing
    names = [f"part{k}.ome.tif" for k in range(0, size[2], 2)]
    planes = "".join(f'<TiffData FirstC="0" FirstT="0" FirstZ="{2 * i + j}" IFD="{j}" PlaneCount="1">'
                     f'<UUID FileName="{name}">urn:uuid:{i}</UUID></TiffData>' for i, name in enumerate(names) for j in range(2))
    xml = ('<?xml version="1.0" encoding="UTF-8"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06">'
           '<Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="XYZCT" Type="uint16" SizeC="1" SizeT="1" '
           f'SizeX="{size[0]}" SizeY="{size[1]}" SizeZ="{size[2]}" PhysicalSizeX="{step[0]}" PhysicalSizeXUnit="mm" '
           f'PhysicalSizeY="{step[1]}" PhysicalSizeYUnit="mm" PhysicalSizeZ="{step[2]}" PhysicalSizeZUnit="mm">'
           f"<Channel ID=\"Channel:0:0\" SamplesPerPixel=\"1\"/>{planes}</Pixels></Image></OME>")
    for i, name in enumerate(names):
        pages = (GRAY8 if is_odd and i == 4 else UNSIGNED)[:, :, 2 * i:2 * i + (1 if is_short and i == 4 else 2)].transpose(2, 1, 0)
        tifffile.imwrite(folder / name, pages, photometric="minisblack",
                         description=xml, metadata=None)
    if lost:
        (folder / names[3]).unlink()
    return folder / names[1]


@case("tiff-ome-in-files", offset=1000.0, steps=(1.5, 1.6, 1.7), told=("slices are in 21 files",), options=("--preset", "histogram"),
      source="the OME-TIFF specification: TiffData names a file by its UUID")
def tiff_ome_files(folder):
    return ome_files(folder)


@case("tiff-ome-in-files-one-lost", refused="part6.ome.tif.*is missing")
def tiff_ome_lost(folder):
    return ome_files(folder, lost=True)


@case("tiff-ome-in-files-of-two-types", refused="pages of several sizes or types")
def tiff_ome_odd(folder):
    return ome_files(folder, is_odd=True)


@case("tiff-ome-in-files-one-short", refused="names page 1 of part8.ome.tif, which has 1")
def tiff_ome_short(folder):
    return ome_files(folder, is_short=True)


@case("tiff-folder", offset=1000.0, steps=(1.0, 1.0, 1.0), options=("--preset", "histogram"), told=("voxel",))
def tiff_folder(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for k in range(GRID.size[2]):  # numbers without leading zeros
        tifffile.imwrite(folder / f"slice{k + 1}.tif", UNSIGNED[:, :, k].T)
    return folder


@case("tiff-single-page", refused="single|one slice|page")
def tiff_single(folder):
    folder.mkdir(parents=True, exist_ok=True)
    tifffile.imwrite(folder / "page.tif", UNSIGNED[:, :, 20].T)
    return folder / "page.tif"


@case("tiff-cut-off", refused="cut off|truncated|announces|damaged|fewer|short|complete")
def tiff_cut(folder):
    path = tiff(folder, "stack.tif", UNSIGNED, metadata=None)
    path.write_bytes(path.read_bytes()[:60000])
    return path


# Zarr


def ngff(folder, version, unit="millimeter", per_mm=1.0, translation=True, channel=False, chosen=False, **options):
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "head.zarr"
    voxels = GRID.sample().transpose(2, 1, 0)
    names = ["z", "y", "x"]
    scale, origin = [*(GRID.spacing[::-1] * per_mm)], [*(GRID.origin[::-1] * per_mm)]
    axes = [{"name": name, "type": "space", "unit": unit} for name in names]
    if channel:
        voxels = np.stack([voxels, np.zeros_like(voxels)])
        if chosen:
            voxels = np.stack([np.zeros_like(voxels[0]), voxels[0], 1 + np.zeros_like(voxels[0])])
        scale, origin = [1.0, *scale], [0.0, *origin]
        axes = [{"name": "c", "type": "channel"}, *axes]
    group = zarr.open_group(str(path), mode="w", zarr_format=2 if version == "0.4" else 3)
    options.setdefault("chunks", voxels.shape[:-3] + (16, 16, 16))
    made = group.create_array("0", shape=voxels.shape, dtype=voxels.dtype, **options)
    made[...] = voxels
    transformations = [{"type": "scale", "scale": [float(x) for x in scale]}]
    if translation:
        transformations.append({"type": "translation", "translation": [float(x) for x in origin]})
    scales = [{"version": version, "name": "head", "axes": axes,
               "datasets": [{"path": "0", "coordinateTransformations": transformations}]}]
    omero = {"omero": {"channels": [{"label": label} for label in ("Actin", "DAPI", "Mitochondria")]}} if chosen else {}
    if version == "0.4":
        group.attrs.update({"multiscales": scales, **omero})
    else:
        group.attrs["ome"] = {"version": version, "multiscales": scales, **omero}
    return path


def zarr_case(name, version, source="OME-NGFF", told=(), series="", refused=None, **options):
    @case(f"zarr-{name}", source=source, told=told, refused=refused, options=("--series", series) if series else ())
    def write(folder):
        return ngff(folder, version, chosen=bool(series), **options)


# VTKHDF


def vtkhdf_case(name, grid=GRID, **options):
    @case(f"vtkhdf-{name}", source="the VTKHDF file format, version 1")
    def write(folder):
        folder.mkdir(parents=True, exist_ok=True)
        with h5py.File(folder / "head.vtkhdf", "w") as file:
            root = file.create_group("VTKHDF")
            root.attrs["Version"] = [1, 0]
            root.attrs["Type"] = np.bytes_("ImageData")
            root.attrs["WholeExtent"] = [end for size in grid.size for end in (0, size - 1)]
            root.attrs["Origin"], root.attrs["Spacing"] = grid.origin, grid.spacing
            root.attrs["Direction"] = grid.axes.ravel()
            points = root.create_group("PointData")
            points.create_dataset("CT", data=grid.sample().transpose(2, 1, 0), **options)
            points.attrs["Scalars"] = np.bytes_("CT")
        return folder / "head.vtkhdf"


vtkhdf_case("plain")
vtkhdf_case("oblique", Grid(axes=turned(20.0)))
vtkhdf_case("chunks", chunks=(16, 16, 16), compression="gzip")


zarr_case("0.4", "0.4")
zarr_case("0.5", "0.5")
zarr_case("0.5-sharded", "0.5", shards=(32, 32, 32))
zarr_case("0.5-large-shards", "0.5", shards=(64, 64, 64), chunks=(32, 16, 8))
zarr_case("0.5-sharded-channels", "0.5", channel=True, chunks=(1, 16, 16, 16), shards=(2, 32, 32, 32), told=("channel|first",))
zarr_case("0.5-plain", "0.5", compressors=None)
for codec in (zarr.codecs.GzipCodec(), zarr.codecs.BloscCodec(), zarr.codecs.Crc32cCodec()):
    zarr_case(f"0.5-{type(codec).__name__.lower()[:-5]}", "0.5", compressors=[codec])
zarr_case("0.5-zstd-and-sum", "0.5", compressors=[zarr.codecs.ZstdCodec(), zarr.codecs.Crc32cCodec()])
zarr_case("0.5-micrometres", "0.5", unit="micrometer", per_mm=1000.0)
zarr_case("0.4-micrometres", "0.4", unit="micrometer", per_mm=1000.0)
zarr_case("0.4-angstrom", "0.4", unit="angstrom", per_mm=1e7, source="OME-NGFF 0.4 names angstrom")
zarr_case("0.4-metres", "0.4", unit="meter", per_mm=0.001)
zarr_case("0.5-channels", "0.5", channel=True, told=("channel|first",))
zarr_case("0.4-channels", "0.4", channel=True, told=("channel|first",))
DAPI = {"channel": True, "series": "2", "told": (r"channel 2 of 3 \(DAPI\) is used",)}
for version in ("0.4", "0.5"):
    zarr_case(f"{version}-the-second-channel", version, **DAPI)
    zarr_case(f"{version}-the-second-channel-in-chunks-of-all", version, chunks=(3, 16, 16, 16), **DAPI)
zarr_case("0.5-the-second-channel-in-shards", "0.5", chunks=(1, 16, 16, 16), shards=(2, 32, 32, 32), **DAPI)
zarr_case("0.5-of-which-none-is-chosen", "0.5", channel=True, series="4", refused="has 3 channels, and none with the number 4")


@case("zarr-3-plain-array-the-second", source="the default of python-zarr 3: zstd", steps=(1.0, 1.0, 1.0),
      told=("voxel|spacing", "volume 2 of 2 is used"), options=("--series", "2"))
def zarr3_second(folder):
    folder.mkdir(parents=True, exist_ok=True)
    made = zarr.create_array(str(folder / "head.zarr"), shape=(2, *GRID.size[::-1]), dtype="i2", chunks=(1, 16, 16, 16))
    made[1] = GRID.sample().transpose(2, 1, 0)
    return folder / "head.zarr"


@case("zarr-3-plain-array", source="the default of python-zarr 3: zstd", steps=(1.0, 1.0, 1.0),
      told=("voxel|spacing",))
def zarr3(folder):
    folder.mkdir(parents=True, exist_ok=True)
    made = zarr.create_array(str(folder / "head.zarr"), shape=GRID.size[::-1], dtype="i2", chunks=(16, 16, 16))
    made[...] = GRID.sample().transpose(2, 1, 0)
    return folder / "head.zarr"


# Files that the reader refuses because of their names.


def refused_case(name, file, content, refused):
    @case(f"refused-{name}", refused=refused)
    def write(folder):
        folder.mkdir(parents=True, exist_ok=True)
        (folder / file).write_bytes(content)
        return folder / file


refused_case("afni", "head+orig.HEAD", b"type = string-attribute\n", "AFNI|3dAFNItoNIFTI")
refused_case("par-rec", "head.par", b"# === DATA DESCRIPTION FILE ===\n", "PAR|dcm2niix")
refused_case("zip", "head.zip", b"PK\3\4" + bytes(100), "zip|ZIP|unpack")
refused_case("jpeg", "head.jpg", b"\xff\xd8\xff\xe0" + bytes(100), "jpg|JPEG|picture")
refused_case("stl", "head.stl", b"solid head\nendsolid head\n", "surface|volume")
refused_case("ecat", "head.v", b"MATRIX72v" + bytes(600), "ECAT")
refused_case("tracts", "head.trk", b"TRACK" + bytes(995), "has tracts")
refused_case("packed", "head.dcm.gz", b"\x1f\x8b" + bytes(100), "packed file")
refused_case("json", "head.json", json.dumps({"a": 1}).encode(), "unknown extension")
refused_case("empty-mha", "head.mha", b"", "empty|damaged|cut off|truncated|announces|header")
refused_case("empty-nrrd", "head.nrrd", b"", "empty|damaged|cut off|truncated|announces|header|NRRD")
refused_case("empty-nii", "head.nii", b"", "empty|damaged|cut off|truncated|announces|header|NIfTI")


@case("refused-absent", refused="no such|not there|does not exist|not found|no file")
def absent(folder):
    folder.mkdir(parents=True, exist_ok=True)
    return folder / "absent.nii.gz"
