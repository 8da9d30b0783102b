# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every input of write.py is right at every voxel, or is refused with the cause and a cure: see formats.sh."""

import fnmatch
import itertools
import json
import os
import re
import shutil
import subprocess
import warnings
from pathlib import Path

import numpy as np
import pytest
from phantom import AIR, CENTRE, TISSUE, Grid, distance, values
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkTextActor

try:
    import volumehaptics
    from volumehaptics import _files
    from volumehaptics._touch import Errors
except ImportError:  # without Python wrapping, only the explorer is tested
    volumehaptics = None

FILES = Path(os.environ["VOLUMEHAPTICS_FORMATS"])
EXPLORE = os.environ["VOLUMEHAPTICS_EXPLORE"]
CASES = json.loads((FILES / "cases.json").read_text())
# Known failures. When a fault is fixed, the test fails until the case is removed from this list.
WRONG = set((Path(__file__).parent / "wrong.txt").read_text().split())
BALLS = 4.0 / 3.0 * np.pi * (20.0**3 + 5.0**3 + 7.0**3)  # mm^3, a little more than the phantom's volume


def read(path):
    """Reads the written image: its values (nx, ny, nz), and the affine from index to world."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput(), *measure(reader.GetOutput())


def measure(image):
    """Returns the image's values (nx, ny, nz), and the affine from index to world."""
    direction = np.array([[image.GetDirectionMatrix().GetElement(i, j) for j in range(3)] for i in range(3)])
    affine = np.eye(4)
    affine[:3, :3] = direction * np.array(image.GetSpacing())
    extent = np.array(image.GetExtent())
    affine[:3, 3] = np.array(image.GetOrigin()) + affine[:3, :3] @ extent[::2]
    samples = vtk_to_numpy(image.GetPointData().GetScalars())
    assert samples.ndim == 1, f"{samples.shape[1]} components"
    return samples.reshape(image.GetDimensions()[::-1]).transpose(2, 1, 0).astype(float), affine


def phantom_points(case, affine, size):
    """Returns the positions of the result's voxels in the phantom, and the volume of a voxel there (mm^3)."""
    index = np.moveaxis(np.indices(size, dtype=float), 0, -1)
    points = index @ affine[:3, :3].T + affine[:3, 3]
    volume = abs(np.linalg.det(affine[:3, :3]))
    if case["steps"]:  # the file names no patient: its steps place the voxels in the phantom
        grid = Grid()
        points = ((points - case["first"]) / case["steps"]) @ grid.affine[:3, :3].T + grid.origin
        volume *= np.prod(grid.spacing) / abs(np.prod(case["steps"]))
    return points, volume


def compare_with_python(case, image, said):
    """Python and ParaView, which use this class, read the explorer's result to the bit and report the same, except that
    the class names its settings and the explorer its options."""
    if volumehaptics is None:
        return
    said = re.sub("--series (\\w)", "Series = \\1", said.replace("eave out --series", "eave Series out"))
    reader = volumehaptics.vtkHapticVolumeReader()
    reader.SetFileName(case["path"])
    if "--series" in case["options"]:
        reader.SetSeries(int(case["options"][case["options"].index("--series") + 1]))
    with Errors(reader, reader.GetExecutive()) as errors:
        reader.Update()
    if image is None:
        assert errors[0].strip() == said[said.index(case["path"]):].strip()
        return
    assert not errors
    assert [line for line in said.splitlines() if not line.startswith("Written: ")] == reader.GetNotes().splitlines()
    other = reader.GetOutput()
    np.testing.assert_array_equal(measure(other)[0], measure(image)[0])
    np.testing.assert_array_equal(measure(other)[1], measure(image)[1])
    assert other.GetScalarType() == image.GetScalarType()
    assert other.GetFieldData().HasArray("Label") == image.GetFieldData().HasArray("Label")


@pytest.mark.parametrize("case", [
    pytest.param(case, id=case["name"], marks=[pytest.mark.xfail(strict=True)] if case["name"] in WRONG else [])
    for case in CASES
])
def test_is_right_or_refused(case, tmp_path):
    written = tmp_path / "out.vti"
    run = subprocess.run([EXPLORE, case["path"], *case["options"], "--write-volume", str(written)], capture_output=True,
                         text=True, timeout=100, check=False)
    said = run.stdout + run.stderr
    if case["refused"]:
        assert run.returncode == 2, said
        # Remove the file's own name, since it is no cause.
        cause = said.replace(case["path"], "").replace(Path(case["path"]).name, "").replace(case["name"], "")
        assert re.search(case["refused"], cause), said
        assert "Cure:" in said
        compare_with_python(case, None, said)
        return
    assert run.returncode == 0, said
    image, found, affine = read(written)
    compare_with_python(case, image, said)
    points, voxel = phantom_points(case, affine, found.shape)
    for told in case["told"]:
        assert re.search(told, said, re.IGNORECASE), said
    if case["labels"]:
        # The label begins in the middle of the phantom's edge, and the values were rounded to 1.
        body, left = values(points), points[..., 0] > CENTRE[0] + 20.5
        one = case["first_label"]
        expected = {"": one + left, "body": one, "knob": (one + 1) * left}[case["alone"]] * (body > -470.0)
        wrong = (found != expected) & (np.abs(body + 470.0) > 1.0)
        assert not wrong.any(), (np.argwhere(wrong)[:5], said)
        assert all(name.encode() in written.read_bytes() for name in case["labels"])
        assert np.unique(found).size == (2 if case["alone"] else 3)
        return
    if case["scale"] == 0.0:
        return
    in_phantom = values(points)
    wrong = np.abs(found - case["offset"] - case["scale"] * in_phantom)
    if case["outside"]:  # not measured there: air, or less
        air = case["offset"] + case["scale"] * values(CENTRE + 1000.0)
        wrong[((found <= air) | ~np.isfinite(found)) & (distance(points) > 2.0)] = 0.0
    assert np.isfinite(wrong).all()
    assert wrong.max() <= case["tolerance"], (wrong.max(), said)
    if re.search("tilted|sheared", case["name"]):  # resampling adds no samples beyond the data
        assert AIR <= found.min() and found.max() <= TISSUE, (found.min(), found.max())
    # The volume must contain the whole phantom.
    body = voxel * np.count_nonzero(in_phantom > -470.0)
    assert 0.9 * BALLS < body < BALLS, (body, said)


ONE_OF_EACH = ("dicom-tilted-20", "dicom-oblique", "dicom-enhanced", "nifti-oblique", "nifti-micron", "nifti-mirrored", "analyze",
               "nrrd-oblique", "nrrd-ras", "nrrd-space-units-um", "meta-oblique", "meta-4d-compressed", "tiff-folder",
               "tiff-imagej-micrometres", "zarr-0.5-micrometres", "vtkhdf-oblique", "mgh-oblique", "minc-oblique")


def corners(image):
    """Returns the first and the last voxel along each axis, in any order: they tell where a volume lies, along whatever
    axes it is stored."""
    found, affine = measure(image)
    index = np.array(list(itertools.product(*[(0, n - 1) for n in found.shape])))
    places = index @ affine[:3, :3].T + affine[:3, 3]
    return places[np.lexsort(np.round(places, 3).T)]


def large_image(path):
    """Returns all samples that open_large() reads; None if the file can only be read into memory."""
    try:
        source = volumehaptics.open_large(path)
    except ValueError:
        return None
    image = vtkImageData()
    assert source.ReadRegion(source.GetWholeExtent(), image)
    return image


def test_there_is_one_truth_in_every_front_end(tmp_path):
    """Compares --write-volume, --inspect --json, --web, open_large(), and touch() of the file and of the written
    volume. ParaView/TestHapticVolume.py compares ParaView."""
    if volumehaptics is None:
        pytest.skip("the module was not wrapped")
    chosen = [one for one in CASES if one["name"] in ONE_OF_EACH]
    assert len(chosen) == len(ONE_OF_EACH)
    for case in chosen:
        written = tmp_path / f"{case['name']}.vti"
        subprocess.run([EXPLORE, case["path"], "--write-volume", str(written)], capture_output=True, check=True)
        image, found, affine = read(written)
        facts = volumehaptics.inspect(case["path"])
        # volumes that --web and open_large() read
        for other in (_files.read(case["path"])[0], large_image(case["path"])):
            assert other is None or np.allclose(corners(other), corners(image), rtol=1e-9, atol=1e-6), case["name"]
        np.testing.assert_allclose(np.reshape(facts["direction"], (3, 3)) * facts["spacing"], affine[:3, :3], rtol=1e-9)
        np.testing.assert_allclose(facts["origin"], affine[:3, 3], rtol=1e-9)
        assert tuple(facts["size"]) == image.GetDimensions() and facts["unit"] == "mm"
        again = volumehaptics.inspect(written)  # the written file is read back unchanged
        for key in ("size", "spacing", "origin", "direction", "unit", "meters_per_unit", "type", "range"):
            assert facts[key] == again[key], (case["name"], key)
        np.testing.assert_array_equal(measure(_files.read(written)[0])[0], found)
        ends = [np.array(image.GetCenter()) + [x, 0.3, 0.2] for x in (-28.0, -12.0)]
        tip = np.linspace(*ends, 300)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            traces = [volumehaptics.touch(one, tip, "CT contrast") for one in (case["path"], image)]
        assert np.array_equal(*[vtk_to_numpy(one.GetPointData().GetArray("Force")) for one in traces]), case["name"]


def in_the_patient():
    """Returns the cases of ONE_OF_EACH whose files have patient coordinates."""
    return [one for one in CASES if one["name"] in ONE_OF_EACH and not one["steps"]]


@pytest.mark.parametrize("case", in_the_patient(), ids=lambda case: case["name"])
def test_lengths_and_sides_are_the_patients_in_the_scene(touch, case):
    """Forces, the head-up display's lengths and the slices lie where the phantom is; the letters at the sides are the
    patient's."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        traces = [touch(case["path"], along_x(begin, 0.0), "CT contrast") for begin in (35.0, -28.0)]
    touched = []
    for trace in traces:
        force = np.linalg.norm(vtk_to_numpy(trace.GetPointData().GetArray("Force")), axis=1)
        touched.append(np.array(trace.GetPoint(np.flatnonzero(force > 0.0)[0])))
    measured = volumehaptics.vtkHapticMeasurements()
    measured.AddDistance(*touched)
    assert measured.GetUnit(0) == "mm"
    assert abs(measured.GetValue(0) - 47.0) < 2.0  # from the left knob's tip to the right side of the ball
    display = volumehaptics.vtkHapticHeadUpDisplay()
    display.SetMeasurements(measured)
    assert re.search(rf"Distance 1: {measured.GetValue(0):.1f}\d* mm", display.GetText()), display.GetText()

    reader = volumehaptics.vtkHapticVolumeReader()
    reader.SetFileName(case["path"])
    reader.Update()
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetSize(300, 900)
    slices = volumehaptics.vtkHapticSliceView()
    slices.SetImage(reader.GetOutput())
    slices.SetAnatomical(True)
    slices.SetShare(0.9)
    slices.SetColorWindow(1000.0)
    slices.SetColorLevel(-500.0)
    slices.SetRenderWindow(window)
    slices.SetPosition(CENTRE)
    window.Render()
    # The slices must have radiologists' axes (the patient's right on the left; the front or the head at the top). The
    # third slice is a view from the left.
    for number, (right, up, letters) in enumerate((("L", "A", "RLPA"), ("L", "S", "RLIS"), ("P", "S", "APIS"))):
        renderer = slices.GetRenderer(number)
        (x, y), (width, height) = renderer.GetOrigin(), renderer.GetSize()
        pixels = vtkUnsignedCharArray()
        window.GetPixelData(x, y, x + width - 1, y + height - 1, 0, pixels)
        shown = vtk_to_numpy(pixels).reshape(height, width, 3)
        bright = dark = wrong = 0
        at = [0.0, 0.0, 0.0]
        for i in range(width // 6, width * 5 // 6, 5):
            for j in range(height // 6, height * 5 // 6, 5):
                assert slices.FindPosition(number, x + i, y + j, at)
                far = distance(at)
                if abs(far) > 1.5 and np.ptp(shown[j, i]) == 0:  # neither an edge nor a colour of the crosshair
                    bright, dark = bright + (far < 0.0), dark + (far > 0.0)
                    wrong += (shown[j, i, 0] > 128) != (far < 0.0)
        assert bright > 20 and dark > 20 and wrong <= 0.02 * (bright + dark), (number, bright, dark, wrong)
        ends = []
        for i, j in ((width // 4, height // 2), (width * 3 // 4, height // 2), (width // 2, height // 4),
                     (width // 2, height * 3 // 4)):
            slices.FindPosition(number, x + i, y + j, at)
            ends.append(np.array(at))
        ways = {"L": (1, 0, 0), "P": (0, 1, 0), "A": (0, -1, 0), "S": (0, 0, 1)}
        for way, (begin, end) in ((right, ends[:2]), (up, ends[2:])):
            assert (end - begin) @ ways[way] > 0.7 * np.linalg.norm(end - begin), (number, way)
        actors = renderer.GetActors2D()
        texts = {actor.GetInput(): actor.GetPosition() for actor in map(actors.GetItemAsObject, range(
            actors.GetNumberOfItems())) if isinstance(actor, vtkTextActor)}
        left_of, right_of, below, above = (texts[letter] for letter in letters)
        assert left_of[0] < width / 2 < right_of[0] and below[1] < height / 2 < above[1]
    slices.SetRenderWindow(None)


@pytest.fixture
def touch():
    """Returns volumehaptics.touch() if Python is wrapped."""
    return pytest.importorskip("volumehaptics").touch


def first_touch(trace):
    """Returns the distance (mm) from the ball's centre at which a hand that comes along x first feels a force."""
    force = vtk_to_numpy(trace.GetPointData().GetArray("Force"))
    tip = vtk_to_numpy(trace.GetPointData().GetArray("Tip"))
    felt = np.flatnonzero(np.linalg.norm(force, axis=1) > 0.0)
    return np.abs(tip[felt[0], 0] - CENTRE[0]) if felt.size else np.inf


def along_x(begin, end):
    steps = np.linspace(begin, end, 600)[:, None] * [1.0, 0.0, 0.0]
    return CENTRE + steps


@pytest.mark.parametrize(("name", "told"), [("dicom-plain", ""), ("dicom-tilted-20", "sheared by 20 degrees"),
                                            ("dicom-lost-slice", "1 slice is missing"), ("dicom-deflated", ""),
                                            ("dicom-each-file-twice", "42 slices are there twice")])
def test_python_feels_a_folder_where_the_patient_is(touch, name, told):
    folder = next(case["path"] for case in CASES if case["name"] == name)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        trace = touch(folder, along_x(-28.0, -12.0), preset="CT contrast")
    assert told in "".join(str(one.message) for one in caught)
    assert 18.0 < first_touch(trace) < 22.0


def test_without_the_program_that_reads_dicom_it_is_refused_with_the_cure(tmp_path):
    """The explorer and its library lie in a separate folder, without volumehaptics-dicom beside them."""
    place = tmp_path / "away"
    place.mkdir(mode=0o755)
    linked = subprocess.run(["ldd", EXPLORE], capture_output=True, text=True, check=True).stdout
    for file in (EXPLORE, *re.findall(r"=> (\S*libvtkVolumeHaptics\S*)", linked)):
        shutil.copy(file, place)
    folder = next(case["path"] for case in CASES if case["name"] == "dicom-plain")

    def read_dicom():
        return subprocess.run([place / Path(EXPLORE).name, folder, "--write-volume", str(tmp_path / "out.vti")],
                              env={**os.environ, "LD_LIBRARY_PATH": str(place)}, capture_output=True, text=True, check=False)

    said = read_dicom()
    assert said.returncode == 2 and "volumehaptics-dicom that reads it is missing" in said.stderr, said
    assert "Cure: build it with GDCM (package libgdcm-dev)" in said.stderr
    shutil.copy(Path(EXPLORE).parent / "volumehaptics-dicom", place)
    place.chmod(0o777)
    said = read_dicom()
    assert said.returncode == 2 and "another user could have written it" in said.stderr, said
    place.chmod(0o755)
    said = read_dicom()
    assert said.returncode == 0, said


def test_that_grids_are_read_without_limits_is_told(tmp_path):
    """If another user may write volumehaptics-read, which has the limits, a note tells that grids are read without
    limits."""
    place, good = tmp_path / "away", tmp_path / "good.vtk"
    place.mkdir(mode=0o755)
    linked = subprocess.run(["ldd", EXPLORE], capture_output=True, text=True, check=True).stdout
    reader = Path(EXPLORE).parent / "volumehaptics-read"
    for file in (EXPLORE, reader, *re.findall(r"=> (\S*libvtkVolumeHaptics\S*)", linked)):
        shutil.copy(file, place)
    bad = Path(__file__).resolve().parents[1] / "FarPoint.vtk"
    good.write_text(bad.read_text().replace("999999999", "3"))

    def inspect(path):
        return subprocess.run([place / Path(EXPLORE).name, path, "--inspect"], capture_output=True, text=True, check=False,
                              env={**os.environ, "LD_LIBRARY_PATH": str(place)})

    told = "read without limits of memory and time"
    said = inspect(good)
    assert said.returncode == 0 and told not in said.stdout + said.stderr, said
    assert "its reader ended" in inspect(bad).stderr
    place.chmod(0o777)
    said = inspect(good)
    assert said.returncode == 0 and told in said.stdout and "Run: chmod go-w" in said.stdout, said


def test_python_takes_a_segmentation_for_labels_by_their_names(touch):
    folder = next(case["path"] for case in CASES if case["name"] == "dicom-seg-beside-ct")
    labels = os.path.join(folder, "seg.dcm")
    tip = along_x(32.0, 12.0)
    with pytest.warns(UserWarning, match="seg.dcm is a segmentation"):
        assert 25.0 < first_touch(touch(folder, tip, "CT contrast")) < 29.0  # the knob
        there = touch(folder, tip, "CT contrast", labels=labels, materials={"ball": {"felt": False}})
        gone = touch(folder, tip, "CT contrast", labels=labels, materials={"knob": {"felt": False}})
    assert 25.0 < first_touch(there) < 29.0
    one = os.path.join(folder, "IM0003.dcm")
    with pytest.raises(ValueError, match="(?s)not a segmentation .SEG.*Cure: give it as the volume"):
        touch(folder, tip, "CT contrast", labels=one)
    with pytest.warns(UserWarning):
        assert 25.0 < first_touch(touch(one, tip, "CT contrast")) < 29.0
    assert first_touch(gone) < 24.5  # inside the knob


def path_of(name):
    return next(case["path"] for case in CASES if case["name"] == name)


def test_a_number_chooses_of_each_of_several_files(tmp_path):
    def write(*words):
        written = tmp_path / "out.vti"
        run = subprocess.run([EXPLORE, *words, "--write-volume", str(written)], capture_output=True, text=True, check=False)
        return run.stderr if run.returncode else (run.stdout, read(written)[1])

    for name in ("nrrd-list-last-the-second-raw", "meta-vector-of-which-the-second-is-chosen", "nifti-4d-second-channel",
                 "tiff-ome-channels-TCZ"):
        path = path_of(name)
        number = next(case["options"][-1] for case in CASES if case["name"] == name)
        _, alone = write(path, "--series", number)
        said, found = write(path, path, "--series", number)
        assert "2 frames" in said
        np.testing.assert_array_equal(found, alone)
    film = path_of("nifti-4d-times")
    assert "is one of several files, and has 3 volumes along its fourth axis" in write(film, film)
    assert "Cure: open it alone, or use --series 1 to --series 3 of each file" in write(film, film)
    assert "2 frames" in write(film, film, "--series", "1")[0]
    phases = path_of("dicom-phases")
    assert "is one of several files, and is a moving volume itself" in write(phases, phases)
    assert "frames" in write(phases)[0]
    assert "--array NIFTI: is for files with arrays" in write(film, "--array", "NIFTI")


def test_a_volume_larger_than_memory_is_chosen_by_the_same_number():
    if volumehaptics is None:
        pytest.skip("the module was not wrapped")
    for name in ("tiff-ome-channels-TCZ", "nrrd-list-last-the-second-raw", "meta-4d-the-second"):
        case = next(one for one in CASES if one["name"] == name)
        number = int(case["options"][-1])
        source = volumehaptics.open_large(case["path"], series=number)
        region, reader = volumehaptics.vtkHapticRegionSource(), volumehaptics.vtkHapticVolumeReader()
        assert region.OpenFile(case["path"], number) and region.GetSeriesNumber() == source.GetSeriesNumber() == number
        reader.SetFileName(case["path"])
        reader.SetSeries(number)
        reader.Update()
        assert [region.GetSeriesName(i) for i in range(region.GetNumberOfSeries())] == [
            reader.GetSeriesName(i) for i in range(reader.GetNumberOfSeries())]
        image = vtkImageData()
        assert source.ReadRegion(source.GetWholeExtent(), image)
        np.testing.assert_array_equal(measure(image)[0], measure(reader.GetOutput())[0])
        with pytest.raises(ValueError, match=r"(?s)none with the number 99.*series=1 to series="):
            volumehaptics.open_large(case["path"], series=99)
        with pytest.raises(ValueError, match=r"(?s)none with the number 99.*series=1 to series="):
            volumehaptics.touch(case["path"], along_x(-28.0, -12.0), "CT contrast", series=99)
        run = subprocess.run([EXPLORE, case["path"], "--large", "--inspect", "--json", *case["options"]],
                             capture_output=True, text=True, check=True)
        assert np.allclose(json.loads(run.stdout)["range"], image.GetPointData().GetScalars().GetRange(), atol=30.0)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
def test_a_volume_larger_than_memory_and_labels_lie_where_the_file_says(case):
    """Compares open_large() and the labels of every input: the phantom at every voxel, or a refusal with the cause and
    a cure."""
    if volumehaptics is None:
        pytest.skip("the module was not wrapped")
    number = int(case["options"][case["options"].index("--series") + 1]) if "--series" in case["options"] else 0
    name = Path(case["path"]).name
    compared = []
    try:
        source, image = volumehaptics.open_large(case["path"], series=number), vtkImageData()
        assert source.ReadRegion(source.GetWholeExtent(), image)
        compared.append(measure(image))
    except ValueError as error:
        assert name in str(error) and re.search(r"Cure: |\. [A-Z][a-z]+ ", str(error)), error
    reader = volumehaptics.vtkHapticVolumeReader()
    reader.SetFileName(case["path"])
    reader.SetSeries(number)
    reader.AsLabelsOn()
    with Errors(reader, reader.GetExecutive()) as errors:
        reader.Update()
    if errors:
        assert name in errors[0] and "Cure: " in errors[0]
    elif reader.GetOutput().GetDimensions()[2] > 1:
        compared.append(measure(reader.GetOutput()))
    if case["labels"] or case["scale"] == 0.0:
        return  # test_is_right_or_refused() has them
    for found, affine in compared:
        points, _ = phantom_points(case, affine, found.shape)
        wrong = np.abs(found - case["offset"] - case["scale"] * values(points))
        if case["outside"]:
            wrong[distance(points) > 2.0] = 0.0
        assert np.nanmax(wrong) <= case["tolerance"], case["name"]


def test_the_masks_of_a_folder_are_labels_of_their_scan(touch):
    """Reads masks as TotalSegmentator writes them, in Python like the explorer's --labels."""
    tip, scan = along_x(32.0, 12.0), path_of("nifti-plain")
    with pytest.warns(UserWarning, match="1 of 3 labels of the table are in no voxel, such as 1 .aorta."):
        gone = touch(scan, tip, "CT contrast", labels=path_of("nifti-masks"), materials={"knob": {"felt": False}})
    assert first_touch(gone) < 25.0  # inside the knob
    with pytest.raises(ValueError, match="(?s)has several volumes, and labels need one.*Cure: write the volume that you mean"):
        touch(scan, tip, "CT contrast", labels=path_of("mgh-first-of-frames"))


def test_labels_of_a_file_with_several_are_chosen():
    if volumehaptics is None:
        pytest.skip("the module was not wrapped")
    for name in ("nrrd-list-last-the-second-gzip", "meta-4d-the-second", "zarr-0.5-the-second-channel", "nifti-4d-second-channel",
                 "meta-vector-of-which-the-second-is-chosen"):
        labels, values = (volumehaptics.vtkHapticVolumeReader() for _ in range(2))
        for reader in (labels, values):
            reader.SetFileName(path_of(name))
        labels.AsLabelsOn()
        if not name.startswith("nrrd"):  # the last of the layers counts
            with Errors(labels, labels.GetExecutive()) as errors:
                labels.Update()
            assert "has several volumes, and labels need one" in errors[0] and "use Series = 1 to Series = " in errors[0]
        else:
            labels.Update()
            assert "labels in 3 layers: where several are in a voxel, the last one in the file counts" in labels.GetNotes()
        for reader in (labels, values):
            reader.SetSeries(2)
            reader.Update()
        np.testing.assert_array_equal(measure(labels.GetOutput())[0], measure(values.GetOutput())[0])


@pytest.mark.parametrize("name", ["dicom-phases-stored-higher", "nifti-4d-stored-higher", "nifti-files-stored-higher"])
def test_all_times_have_the_shift_of_the_first(name):
    """The later time, alone, does not show that it is stored higher."""
    if volumehaptics is None:
        pytest.skip("the module was not wrapped")
    reader = volumehaptics.vtkHapticVolumeReader()
    reader.SetFileName(path_of(name))
    reader.UpdateInformation()
    times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    assert len(times) == 2
    for time in times:
        reader.UpdateTimeStep(time)
        found, affine = measure(reader.GetOutput())
        points, _ = phantom_points(next(one for one in CASES if one["name"] == name), affine, found.shape)
        assert np.abs(found - values(points)).max() <= 95.0, time


def test_labels_of_a_table_that_are_in_no_voxel_are_told(tmp_path):
    """The folder of masks contains one without a voxel, the aorta; the user's table also has such a label."""
    def notes(*words):
        run = subprocess.run([EXPLORE, *words, "--inspect", "--json"], capture_output=True, text=True, check=True)
        return "\n".join(json.loads(run.stdout)["notes"])

    assert "1 of 3 labels of the table are in no voxel, such as 1 (aorta)" in notes(path_of("nifti-masks"))
    table = tmp_path / "table.csv"
    table.write_text("label,name\n77,liver\n")
    assert "2 of 4 labels of the table are in no voxel" in notes(path_of("nifti-masks"), "--as-labels", "--materials", str(table))


LIBRARIES = json.loads((FILES / "libraries" / "libraries.json").read_text())

# Maps the kind of file that pydicom or nibabel reports to words that the reader's error must contain. Both are regular
# expressions.
TRUE_NAMES = {"RT Ion Plan Storage": "RT ion plan", "RT Plan Storage": "RT plan", "RT Structure Set Storage": "structure set",
              ".*SR Storage|Comprehensive SR.*": "structured report", ".*ECG.*": "waveform", "Media Storage Directory.*":
              "directory of a medium|no single DICOM slice|damaged or truncated", "RT Beams Treatment Record.*": "RT record",
              "AFNIImage": "AFNI|packed file", "PARRECImage": "PAR/REC", "EcatImage": "ECAT", "Minc2Image": "MINC 2"}
# Faults of a slice that prevent a volume.
NO_VOLUME = ("is a single slice|too thin|no pixel spacing|no slice positions|is it a film|several volumes|mosaic|"
             "without pixel data|damaged or truncated|without an image|palette colours|turned against each other")


@pytest.mark.parametrize("file", LIBRARIES, ids=lambda file: file["name"])
def test_a_file_of_another_library_is_right_or_refused_by_its_true_name(file):
    if volumehaptics is None:
        pytest.skip("the module was not wrapped")
    reader = volumehaptics.vtkHapticVolumeReader()
    reader.SetFileName(file["path"])
    with Errors(reader, reader.GetExecutive()) as errors:
        reader.Update()
    names = [text for kind, text in TRUE_NAMES.items() if re.fullmatch(kind, file["kind"])]
    voxels = np.load(file["voxels"]) if "voxels" in file else None
    is_labels = file["kind"] == "Segmentation Storage"
    if errors:
        assert voxels is None or names or min(voxels.shape) < 5, errors
        assert "Cure: " in errors[0]
        cause = errors[0].replace(file["path"], "").replace(Path(file["path"]).name, "")
        if names:
            assert re.search(names[0], cause), (file["kind"], errors)
        elif file.get("pixels") or (voxels is not None and not is_labels):
            assert re.search(NO_VOLUME, cause), errors
        return
    assert voxels is not None, f"{file} was read: {reader.GetNotes()}"
    found, affine = measure(reader.GetOutput())
    index = np.moveaxis(np.indices(found.shape, dtype=float), 0, -1)
    at = (index @ affine[:3, :3].T + affine[:3, 3] - np.array(file["affine"])[:3, 3]) @ np.linalg.inv(
        np.array(file["affine"])[:3, :3]).T
    whole = np.round(at).astype(int)
    assert np.abs(at - whole).max() < 2e-3, reader.GetNotes()
    inside = np.all((whole >= 0) & (whole < voxels.shape), axis=-1)
    expected = np.zeros(found.shape)
    expected[inside] = voxels[tuple(whole[inside].T)]
    # The reader adds empty slices to a segmentation of one slice.
    assert np.count_nonzero(inside) == voxels.size and (inside.all() or is_labels)
    np.testing.assert_allclose(found, expected, rtol=2e-6, atol=1e-6 * np.ptp(voxels))


def test_the_trail_is_as_smooth_at_a_place_of_utm(tmp_path):
    """The free parts of the trail, which are blue, cover the same pixels as near the origin."""
    trails = []
    for place in ((0, 0, 0), (500000, 5400000, 100)):
        header = Path(path_of("meta-mhd")).read_text()
        samples = Path(path_of("meta-mhd")).parent / re.search("ElementDataFile = (.*)", header)[1]
        folder = tmp_path / str(place[0])
        folder.mkdir()
        (folder / "head.mhd").write_text(re.sub("(?m)^Offset = .*", "Offset = {} {} {}".format(*place), header).replace(
            samples.name, str(samples)))
        subprocess.run([EXPLORE, str(folder / "head.mhd"), "--pictures", str(folder), "--size", "500"], capture_output=True,
                       check=True)
        reader = vtkPNGReader()
        reader.SetFileName(str(folder / "explore.png"))
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
        red, green, blue = (pixels[:, :width * 4 // 5, i] for i in range(3))  # without the colour scale
        trails.append((red < 70) & (green < 90) & (blue > 150))
    assert trails[0].sum() > 1000
    assert (trails[0] ^ trails[1]).sum() < 0.02 * trails[0].sum()


def test_the_table_of_rows_names_each_case_and_what_there_is():
    here = Path(__file__).parent
    names = {case["name"] for case in CASES}
    left = set(names)
    rows = [line for line in (here / "rows.md").read_text().splitlines() if line.startswith("| ")]
    for row in rows:
        if row.startswith(("| data ", "| --- ")):
            continue
        proofs = re.findall("`([^`]+)`", row.split("|")[-2])
        assert proofs, row
        for proof in proofs:
            file, _, test = proof.partition(": ")
            if test:
                path = here.parents[2] / file if "/" in file else here / file
                assert re.search(rf"\b{test}\(", path.read_text()), proof
                continue
            found = set(fnmatch.filter(names, proof))
            assert found, proof
            left -= found
    assert not left, "cases that are in no row"


def test_there_are_enough():
    assert len(CASES) - len(WRONG) >= 120
    assert WRONG <= {case["name"] for case in CASES}
