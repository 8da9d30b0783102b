# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes data like those in further public threads, by the libraries of the other writers. `source` names each thread.
Where the thread complains of a wrong volume, the case here is right at every voxel; where no volume can be right,
the case is refused."""

import shutil

import nibabel
import nrrd
import numpy as np
import tifffile
import zarr
from cases import case
from phantom import CENTRE, Grid, turned, values
from pydicom.dataset import Dataset
from pydicom.sequence import Sequence
from pydicom.uid import MRImageStorage, RTDoseStorage
from write_dicom import GRID, enhanced, header, put_pixels, save, save_all, segmentation, slices, uid
from write_images import ngff


@case("dicom-names-in-reverse", source="Slicer/Slicer#7730: a file of a series named, whose names don't follow the slices")
def names_in_reverse(folder):
    for data in slices(GRID):
        save(folder, data, f"a{99 - data.InstanceNumber}.dcm")
    return folder / "a60.dcm"


@case("dicom-enhanced-in-stacks", source="rordenlab/dcm2niix#839: three interleaved stacks are one volume")
def in_stacks(folder):
    order = [k for stack in range(3) for k in range(stack, GRID.size[2], 3)]
    data = enhanced(GRID, order)
    for frame, (item, k) in enumerate(zip(data.PerFrameFunctionalGroupsSequence, order)):
        content = Dataset()
        content.StackID, content.InStackPositionNumber = str(k % 3 + 1), k // 3 + 1
        content.DimensionIndexValues = [k % 3 + 1, k // 3 + 1]
        content.FrameAcquisitionNumber = frame + 1
        item.FrameContentSequence = Sequence([content])
    return save(folder, data, "stacks.dcm")


@case("dicom-bits-differ", source="dgobbi/vtk-dicom#211: the outer slices have 8 bits, those in the middle 16",
      scale=0.1, offset=100.0, tolerance=0.2, options=("--preset", "histogram"))
def bits_differ(folder):
    voxels = 100.0 + 0.1 * GRID.sample(float)
    sets = slices(GRID, sampled=voxels, intercept=0.0, slope=0.01)
    for k in (0, 1, -2, -1):
        put_pixels(sets[k], voxels[:, :, k].T, intercept=0.0, slope=0.5, bits=8)
    return save_all(folder, sets)


@case("dicom-16-bits-8-stored", source="InsightSoftwareConsortium/ITK#851", scale=0.1, offset=100.0, tolerance=0.6,
      options=("--preset", "histogram"))
def eight_stored(folder):
    sets = slices(GRID, sampled=100.0 + 0.1 * GRID.sample(float), intercept=0.0)
    for data in sets:
        data.BitsStored, data.HighBit = 8, 7
    return save_all(folder, sets)


@case("dicom-perfusion", source="cornerstonejs/cornerstone3D#555: times of a CT perfusion, told by AcquisitionTime alone",
      told=("3 phases", "times 0 to 3 s"))
def perfusion(folder):
    for phase in range(3):
        sets = slices(GRID)
        for k, data in enumerate(sets):
            data.AcquisitionTime = f"1059{58 + phase}.{10 * k:06}" if phase < 2 else f"110001.{10 * k:06}"
            data.InstanceNumber = phase * len(sets) + k + 1
            data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid("perfusion", phase, k)
            put_pixels(data, GRID.sample(float)[:, :, k].T + 10.0 * phase)
        save_all(folder, sets)
    return folder


@case("dicom-two-orientations", source="ivmartel/dwv#462, Slicer/Slicer#1007: axial and coronal slices in one series",
      told=("12 slices of 44 x 40",))
def two_orientations(folder):
    axial = slices(GRID)
    coronal = slices(Grid(size=(44, 40, 12), axes=np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])))
    for k, data in enumerate(coronal):
        data.InstanceNumber = len(axial) + k + 1
        data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid("coronal", k)
    return save_all(folder, [*axial, *coronal])


def frames(spacing_between):
    """Writes all slices into one file of CT Image Storage, which may have a single slice only, without the positions of
    frames."""
    data = slices(GRID)[0]
    put_pixels(data, np.moveaxis(GRID.sample(float), 2, 0).transpose(0, 2, 1))
    data.NumberOfFrames = GRID.size[2]
    if spacing_between:
        data.SpacingBetweenSlices = f"{GRID.spacing[2]:.6f}"
    return data


@case("dicom-frames-with-a-spacing", source="Slicer/Slicer#6773: the third spacing was 1 instead")
def frames_with_spacing(folder):
    return save(folder, frames(True), "frames.dcm")


@case("dicom-frames-with-a-thickness", source="Slicer/Slicer#7496: thickness is no distance", refused="positions are not given")
def frames_with_thickness(folder):
    return save(folder, frames(False), "frames.dcm")


def complex_parts(name, parts, **facts):
    @case(f"dicom-{name}", **facts)
    def write(folder):
        for number, (kind, offset) in enumerate(parts):
            sets = slices(GRID, "complex", MRImageStorage, "MR", GRID.sample(float) + offset, intercept=-5000.0)
            for k, data in enumerate(sets):
                data.ImageType = ["ORIGINAL", "PRIMARY", kind, "ND"]
                data.InstanceNumber = number * len(sets) + k + 1
                data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = uid(kind, k)
            save_all(folder, sets)
        return folder


MAGNITUDE_AND_PHASE = (("M", 0.0), ("P", 2000.0))
complex_parts("magnitude-and-phase", MAGNITUDE_AND_PHASE, source="rordenlab/dcm2niix#219", told=("ImageType ORIGINAL.PRIMARY.P",))
complex_parts("the-phase-chosen", MAGNITUDE_AND_PHASE, source="rordenlab/dcm2niix#219", offset=2000.0, options=("--series", "2"))


@case("dicom-enhanced-slope-per-frame", source="pydicom/pydicom#2353: slope and intercept of each frame", scale=10.0,
      offset=10000.0, tolerance=8.0, options=("--preset", "histogram"))
def slope_per_frame(folder):
    data = enhanced(GRID, range(GRID.size[2]))
    del data.SharedFunctionalGroupsSequence[0].PixelValueTransformationSequence
    voxels, stored = 10000.0 + 10.0 * GRID.sample(float), []
    for k, item in enumerate(data.PerFrameFunctionalGroupsSequence):
        rescale = Dataset()
        rescale.RescaleIntercept, rescale.RescaleSlope, rescale.RescaleType = -k, f"{1.0 + 0.05 * k:.4g}", "US"
        item.PixelValueTransformationSequence = Sequence([rescale])
        stored.append(np.round((voxels[:, :, k].T + k) / (1.0 + 0.05 * k)))
    data.PixelData = np.array(stored).astype("<u2").tobytes()
    return save(folder, data, "slopes.dcm")


@case("dicom-padded-numbers", source="fo-dicom/fo-dicom#1078, Enet4/dicom-rs#618: numbers that end in a zero byte or blanks")
def padded_numbers(folder):
    save_all(folder, slices(GRID))
    for path in folder.iterdir():
        data = path.read_bytes()
        for number, padded in ((b"1.600000\\1.500000 ", b"1.600000\\1.500000\0"), (b"-1024 ", b"-1024\0")):
            assert number in data
            data = data.replace(number, padded)
        path.write_bytes(data)
    return folder


@case("dicom-seg-of-odd-frames", labels=("ball", "knob"),
      source="InsightSoftwareConsortium/ITK#6639, razorx89/pydicom-seg#53: frames of one bit begin anywhere in a byte, empty ones "
             "are left out")
def odd_frames(folder):
    return save(folder, segmentation(Grid(size=(43, 41, 42))), "seg.dcm")


@case("dicom-one-of-two-series-named", source="pyushkevich/itksnap#132: another series of the folder was opened")
def one_of_two_named(folder):
    for data in slices(Grid(size=(60, 60, 60)), "larger"):
        save(folder, data, f"a{data.InstanceNumber}.dcm")
    for data in slices(GRID, "meant"):
        save(folder, data, f"b{data.InstanceNumber}.dcm")
    return folder / "b7.dcm"


@case("dicom-one-number-for-two", source="pydicom/pydicom#173, InsightSoftwareConsortium/ITK#6639: a PixelSpacing of one number",
      refused="PixelSpacing")
def one_number(folder):
    sets = slices(GRID)
    for data in sets:
        data.PixelSpacing = None
        data.add_new(0x00280030, "LO", "1.6,1.5")  # a comma instead of the backslash
    return save_all(folder, sets)


@case("dicom-flipped-normal-of-a-dose", source="PS3.3 C.8.8.3.2: offsets are z in the patient, whatever the normal", scale=0.05,
      offset=50.0, tolerance=1e-3, told=("doses in Gy",), options=("--preset", "histogram"))
def flipped_dose(folder):

    grid = Grid(axes=np.diag([1.0, -1.0, 1.0]))  # rows to the left, columns to the front: the normal points to the feet
    data = header(RTDoseStorage, "RTDOSE", "dose")
    data.DoseUnits, data.DoseType, data.DoseSummationType = "GY", "PHYSICAL", "PLAN"
    data.ImageOrientationPatient = [1, 0, 0, 0, -1, 0]
    data.ImagePositionPatient = [f"{number:.6f}" for number in grid.origin]
    data.PixelSpacing = [grid.spacing[1], grid.spacing[0]]
    data.NumberOfFrames = grid.size[2]
    data.GridFrameOffsetVector = [f"{grid.origin[2] + grid.spacing[2] * k:.6f}" for k in range(grid.size[2])]
    doses = 50.0 + 0.05 * values(grid.points())
    put_pixels(data, np.moveaxis(doses, 2, 0).transpose(0, 2, 1), intercept=0.0, slope=2.5e-8, bits=32)
    del data.RescaleIntercept, data.RescaleSlope
    data.DoseGridScaling = "2.5e-08"
    return save(folder, data, "dose.dcm")


def real_world(slope, intercept, unit, table=None, last=65535):
    """Returns an item of RealWorldValueMappingSequence: PS3.3 C.7.6.16.2.11."""
    mapping, code = Dataset(), Dataset()
    mapping.LUTExplanation, mapping.LUTLabel = "map", "map"
    mapping.RealWorldValueFirstValueMapped, mapping.RealWorldValueLastValueMapped = 0, last
    if table is None:
        mapping.RealWorldValueIntercept, mapping.RealWorldValueSlope = float(intercept), float(slope)
    else:
        mapping.RealWorldValueLUTData = table
    code.CodeValue, code.CodingSchemeDesignator, code.CodeMeaning = unit, "UCUM", unit
    mapping.MeasurementUnitsCodeSequence = Sequence([code])
    return mapping


def mapped(folder, mappings, rescale=False):
    """Writes values from 500 to 1030, which the file stores times 2."""
    sets = slices(GRID, "mapped", MRImageStorage, "MR", 2.0 * (1000.0 + 0.5 * GRID.sample(float)), intercept=0.0)
    for data in sets:
        if rescale:
            data.RescaleSlope, data.RescaleIntercept, data.RescaleType = 0.5, 0, "US"
        else:
            del data.RescaleSlope, data.RescaleIntercept
        data.RealWorldValueMappingSequence = Sequence(mappings)
    return save_all(folder, sets)


MAPPED = {"scale": 0.5, "offset": 1000.0, "options": ("--preset", "histogram")}


@case("dicom-real-world-values", source="nipy/nibabel#143: no rescale, but RealWorldValueMappingSequence",
      told=("real-world values.*in um2/s",), **MAPPED)
def real_world_values(folder):
    return mapped(folder, [real_world(0.5, 0.0, "um2/s")])


@case("dicom-real-world-values-of-some", source="PS3.3 C.7.6.16.2.11: a map is for a range of stored values",
      told=("is for stored values from 0 to 1500: others are mapped by it, too",), **MAPPED)
def real_world_of_some(folder):
    return mapped(folder, [real_world(0.5, 0.0, "um2/s", last=1500)])


@case("dicom-real-world-values-of-two", source="dgobbi/vtk-dicom#26: several maps", told=("of 2 such maps, it is the first",),
      **MAPPED)
def real_world_of_two(folder):
    return mapped(folder, [real_world(0.5, 0.0, "um2/s"), real_world(7.0, 100.0, "1")])


@case("dicom-real-world-beside-a-rescale", source="rordenlab/dcm2niix#493: a rescale and a map that differ",
      told=("map to real-world values in ms is not used, because it has a rescale",), **MAPPED)
def real_world_beside(folder):
    return mapped(folder, [real_world(3.0, 20.0, "ms")], rescale=True)


@case("dicom-real-world-table", source="dgobbi/vtk-dicom#26: a map that is a table", scale=1.0, offset=2000.0,
      options=("--preset", "histogram"), told=("map to real-world values is a table, which is not used",))
def real_world_table(folder):
    return mapped(folder, [real_world(0.0, 0.0, "ms", [float(number) for number in range(16)])])


@case("dicom-enhanced-real-world-values", source="rordenlab/dcm2niix#189: a map for each frame", tolerance=2.0,
      told=("real-world values.*in um2/s",), **MAPPED)
def real_world_frames(folder):
    data = enhanced(GRID, range(GRID.size[2]))
    del data.SharedFunctionalGroupsSequence[0].PixelValueTransformationSequence
    voxels, stored = 1000.0 + 0.5 * GRID.sample(float), []
    for k, item in enumerate(data.PerFrameFunctionalGroupsSequence):
        item.RealWorldValueMappingSequence = Sequence([real_world(0.5 + 0.01 * k, -k, "um2/s")])
        stored.append(np.round((voxels[:, :, k].T + k) / (0.5 + 0.01 * k)))
    data.PixelData = np.array(stored).astype("<u2").tobytes()
    return save(folder, data, "maps.dcm")


@case("dicom-no-instance-number", source="rordenlab/dcm2niix#341: files without InstanceNumber")
def no_instance_number(folder):
    sets = slices(GRID)
    for k, data in enumerate(sets):
        del data.InstanceNumber
        save(folder, data, f"{k}.dcm")
    return folder


@case("dicom-a-block-lost", source="rordenlab/dcm2niix#248: 182 mm without slices between two blocks",
      refused="has slices 1.7 to 37.4 mm apart")
def block_lost(folder):
    return save_all(folder, [data for k, data in enumerate(slices(GRID)) if not 10 <= k < 31])


@case("dicom-first-place-twice", source="rordenlab/dcm2niix#539: another slice at the place of the first one",
      refused="two slices at the same position|several volumes")
def first_twice(folder):
    sets = slices(GRID)
    other = slices(GRID)[0]
    other.InstanceNumber = len(sets) + 1
    other.SOPInstanceUID = other.file_meta.MediaStorageSOPInstanceUID = uid("again")
    put_pixels(other, GRID.sample(float)[:, :, 20].T)
    return save_all(folder, [*sets, other])


@case("dicom-pixels-not-square", source="Kitware/VolView#626: pixels of 0.8 x 2.4 mm")
def not_square(folder):
    return save_all(folder, slices(Grid(size=(80, 27, 42), spacing=(0.8, 2.4, 1.7))))


@case("dicom-seg-from-the-feet-in-reverse", source="Kitware/VolView#639: frames in another order than the CT's slices",
      labels=("ball", "knob"))
def seg_in_reverse(folder):
    data = segmentation(GRID)
    size = GRID.size[0] * GRID.size[1]
    bits = np.unpackbits(np.frombuffer(data.PixelData, np.uint8), bitorder="little")[:size * data.NumberOfFrames]
    data.PixelData = np.packbits(bits.reshape(-1, size)[::-1].ravel(), bitorder="little").tobytes()
    if len(data.PixelData) % 2:
        data.PixelData += b"\0"
    data.PerFrameFunctionalGroupsSequence = Sequence(list(data.PerFrameFunctionalGroupsSequence)[::-1])
    return save(folder, data, "seg.dcm")


@case("nifti-axes-that-share-a-direction", source="pyushkevich/itksnap#69, #246: strongly oblique, 'invalid orientation (IRI)'")
def share_direction(folder):
    folder.mkdir(parents=True, exist_ok=True)
    ras = np.array([[-0.656692, -0.676962, 0.332383], [0.360389, -0.668844, -0.650205], [0.662477, -0.307197, 0.683194]])
    u, _, v = np.linalg.svd(np.diag([-1.0, -1.0, 1.0]) @ ras)
    grid = Grid(axes=u @ v)
    affine = np.diag([-1.0, -1.0, 1.0, 1.0]) @ grid.affine
    nibabel.save(nibabel.Nifti1Image(grid.sample(), affine), folder / "head.nii.gz")
    return folder / "head.nii.gz"


@case("nifti-nearly-orthonormal", tolerance=20.0, told=("resampled on straight axes",),
      source="wasserth/TotalSegmentator#461, pyushkevich/itksnap#102: 'ITK only supports orthonormal direction cosines'")
def nearly_orthonormal(folder):
    folder.mkdir(parents=True, exist_ok=True)
    grid = Grid(axes=turned(20.0))
    grid.affine[:3, :3] += 1e-3 * np.array([[0.0, 1.0, -1.0], [1.0, 0.0, 1.0], [-1.0, 1.0, 0.0]])
    affine = np.diag([-1.0, -1.0, 1.0, 1.0]) @ grid.affine
    made = nibabel.Nifti1Image(grid.sample(), None)
    made.set_qform(None, 0)
    made.set_sform(affine, 1)
    nibabel.save(made, folder / "head.nii.gz")
    return folder / "head.nii.gz"


@case("nrrd-las-sagittal", source="Slicer/Slicer#8694: left-handed, and sagittal slices")
def las_sagittal(folder):
    grid = Grid(axes=np.array([[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]))
    folder.mkdir(parents=True, exist_ok=True)
    turn = np.diag([1.0, -1.0, 1.0])  # left-anterior-superior
    header = {"space": "left-anterior-superior", "space directions": (turn @ grid.affine[:3, :3]).T,
              "space origin": turn @ grid.origin, "kinds": ["domain"] * 3, "encoding": "gzip"}
    nrrd.write(str(folder / "head.nhdr"), grid.sample(), header)
    return folder / "head.nhdr"


TIMES = {"offset": 1000.0, "steps": (1.0, 1.0, 1.0), "options": ("--preset", "histogram", "--series", "2")}


def as_napari_writes(name, axes, told, **facts):
    @case(f"tiff-napari-{name}", told=told, **facts)
    def write(folder):
        folder.mkdir(parents=True, exist_ok=True)
        voxels = (GRID.sample(np.int32) + 1000).astype(np.uint16).transpose(2, 1, 0)
        voxels = np.stack([0 * voxels, voxels], axis=1 if axes.startswith("ZC") else 0)
        options = {"metadata": {"axes": axes}} if axes else {}
        tifffile.imwrite(folder / "layer.tif", voxels, photometric="minisblack", **options)
        return folder / "layer.tif"


as_napari_writes("four-axes", "", ("volume 2 of 2 is used", "cubes of 1 mm"), **TIMES,
                 source="napari/napari#5162: the scale is lost; four axes in pages, told by tifffile's shape alone")
as_napari_writes("times", "TZYX", ("time 2 of 2 is used",), **TIMES, source="ome/bioformats#3920: a TIFF of napari, t for z")
as_napari_writes("channels-inside", "ZCYX", ("channel 2 of 2 is used",), **TIMES, source="cgohlke/tifffile#50")


@case("tiff-imagej-slices-before-channels", source="micro-manager/micro-manager#894: order=zct", offset=1000.0,
      steps=(1.5, 1.6, 1.7), told=("channel 2 of 2 is used",), options=("--preset", "histogram", "--series", "2"))
def slices_before_channels(folder):
    folder.mkdir(parents=True, exist_ok=True)
    voxels = (GRID.sample(np.int32) + 1000).astype(np.uint16).transpose(2, 1, 0)
    text = f"ImageJ=1.53f\nimages={2 * len(voxels)}\nchannels=2\nslices={len(voxels)}\norder=zct\nunit=mm\nspacing=1.7\n"
    tifffile.imwrite(folder / "stack.tif", np.concatenate([0 * voxels, voxels]), photometric="minisblack", metadata=None,
                     resolution=(1.0 / 1.5, 1.0 / 1.6), description=text)
    return folder / "stack.tif"


def collection(folder, images):
    """Writes a collection as bioformats2raw does: the images in the folders 0, 1, ..., and the folder OME beside
    them."""
    folder.mkdir(parents=True, exist_ok=True)
    group = zarr.open_group(str(folder / "head.zarr"), mode="w", zarr_format=2)
    group.attrs["bioformats2raw.layout"] = 3
    (folder / "head.zarr" / "OME").mkdir()
    for number in range(images):
        shutil.move(ngff(folder / f"made{number}", "0.4"), folder / "head.zarr" / str(number))
    return folder / "head.zarr"


@case("zarr-bioformats2raw", source="ome/napari-ome-zarr#21, napari/napari#8355: the image is in the folder 0")
def one_image(folder):
    return collection(folder, 1)


@case("zarr-bioformats2raw-of-two-images", source="ome/napari-ome-zarr#71: a collection", refused="collection of 2 images")
def two_images(folder):
    return collection(folder, 2)


@case("zarr-scale-of-all-levels", source="fractal-analytics-platform/fractal-client#112: napari ignored the scale of all levels")
def scale_of_all(folder):
    path = ngff(folder, "0.4", translation=False)
    group = zarr.open_group(str(path), mode="r+")
    scales = group.attrs["multiscales"]
    scales[0]["datasets"][0]["coordinateTransformations"] = [{"type": "scale", "scale": [2.0, 2.0, 2.0]}]
    scales[0]["coordinateTransformations"] = [
        {"type": "scale", "scale": [float(step) / 2.0 for step in GRID.spacing[::-1]]},
        {"type": "translation", "translation": [float(number) for number in GRID.origin[::-1]]}]
    group.attrs["multiscales"] = scales
    return path


def organs(folder, other=None):
    """Writes organs as TotalSegmentator does by default: a mask of 0 and 1 for each organ, also for missing organs."""
    folder.mkdir(parents=True, exist_ok=True)
    body = GRID.sample(float) > -470.0
    left = GRID.points()[..., 0] > CENTRE[0] + 20.5
    affine = np.diag([-1.0, -1.0, 1.0, 1.0]) @ GRID.affine
    masks = {"aorta": 0 * body, "ball": body & ~left, "knob": body & left}
    for name, mask in masks.items():
        nibabel.save(nibabel.Nifti1Image(mask.astype(np.uint8), affine), folder / f"{name}.nii.gz")
    if other is not None:
        nibabel.save(nibabel.Nifti1Image(other, affine), folder / "liver.nii.gz")
    return folder


ORGANS = {"labels": ("ball", "knob"), "first_label": 2, "source": "wasserth/TotalSegmentator's folder of masks"}


@case("nifti-masks", told=("3 masks are used as labels",), **ORGANS)
def masks(folder):
    return organs(folder)


@case("nifti-masks-of-which-one-is-chosen", alone="knob", options=("--series", "3"), told=("segment 3 knob is read alone",), **ORGANS)
def mask_chosen(folder):
    return organs(folder)


@case("nifti-masks-of-which-none-is-chosen", refused="has 3 masks, and none with the number 4", options=("--series", "4"))
def mask_not_chosen(folder):
    return organs(folder)


@case("nifti-masks-of-two-sizes", refused="has a different grid from the mask")
def masks_of_two_sizes(folder):
    return organs(folder, np.ones((5, 6, 7), np.uint8))


@case("nifti-masks-beside-a-scan", refused="is not a mask, unlike the others in its folder")
def masks_beside_scan(folder):
    return organs(folder, GRID.sample())
