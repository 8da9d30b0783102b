# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries the cures that error texts name: after the cure, the input that was refused gives the right force.

The volume is V = 100 z over 24 x 17 x 32 voxels [z, y, x: 32, 17, 24], pressed 2 mm from z = 10 on: 500 N/m give 1 N.
"""

import ast
import os
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
from vtkmodules.vtkFiltersCore import vtkResampleToImage
from vtkmodules.vtkImagingCore import vtkImageCast
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
import volumehaptics
from volumehaptics import image, touch
from volumehaptics.__main__ import find_explorer
from volumehaptics.arrays import arrays

SIZE = (32, 17, 24)
RAMP = np.broadcast_to(100.0 * np.arange(32.0).reshape(-1, 1, 1), SIZE).copy()
PRESS = np.linspace((5, 8, 10), (5, 8, 12), 21)


def force(volume, **options):
    return -arrays(touch(volume, PRESS, **options))["Force"][-1][2]


def of_nibabel():
    """Returns an array like get_fdata() of nibabel: axes [x, y, z], in Fortran order (x fastest)."""
    return np.asfortranarray(RAMP.transpose(2, 1, 0))


def rectilinear():
    grid = vtkRectilinearGrid()
    grid.SetDimensions(SIZE[::-1])
    for name, count in zip("XYZ", SIZE[::-1]):
        coordinates = numpy_to_vtk(np.arange(float(count)), deep=True)
        getattr(grid, f"Set{name}Coordinates")(coordinates)
    values = numpy_to_vtk(RAMP.reshape(-1), deep=True)
    values.SetName("V")
    grid.GetPointData().SetScalars(values)
    return grid


def sampled(grid):
    sampler = vtkResampleToImage()
    sampler.SetInputDataObject(grid)
    sampler.SetSamplingDimensions(*SIZE[::-1])
    sampler.Update()
    return sampler.GetOutput()


def updated(algorithm):
    algorithm.Update()
    return algorithm.GetOutput()


def cast():
    """Returns an algorithm instead of its output."""
    algorithm = vtkImageCast()
    algorithm.SetInputData(image(RAMP))
    algorithm.SetOutputScalarTypeToFloat()
    return algorithm


MASKED = np.ma.masked_greater(RAMP, 2900.0)
SHIFTED = np.ndarray(SIZE, np.float64, bytearray(RAMP.nbytes + 1), 1)
SHIFTED[:] = RAMP

# For each case: a function that makes a refused volume, words of the remedy, and a function that applies the remedy.
VOLUMES = {
    "of nibabel": (of_nibabel, "array.T if its axes are [x, y, z]", lambda array: array.T),
    "a part of nibabel's": (lambda: np.asfortranarray(np.pad(of_nibabel(), 1, "edge"))[1:-1, 1:-1, 1:-1],
                            "np.ascontiguousarray(array.T) if its axes are [x, y, z]",
                            lambda array: np.ascontiguousarray(array.T)),
    "in Fortran's order": (lambda: np.asfortranarray(RAMP), "np.ascontiguousarray(array) if they are [z, y, x]",
                           np.ascontiguousarray),
    "every second": (lambda: np.repeat(RAMP, 2, axis=2)[:, :, ::2], "np.ascontiguousarray(array)", np.ascontiguousarray),
    "masked": (lambda: MASKED, "array.filled(VALUE)", lambda array: array.filled(0.0)),
    "not aligned": (lambda: SHIFTED, "array.copy()", np.copy),
    "of another type": (lambda: RAMP.astype(np.float16), "array.astype(np.float32)", lambda a: a.astype(np.float32)),
    "of another byte order": (lambda: RAMP.astype(">f8"), "array.astype(np.float32)", lambda a: a.astype(np.float32)),
    "an algorithm": (cast, "Update() it, and take its GetOutput()", updated),
    "a grid": (rectilinear, "vtkResampleToImage", sampled),
}


@pytest.mark.parametrize("kind", VOLUMES)
def test_volumes(kind):
    make, words, cure = VOLUMES[kind]
    with pytest.raises((TypeError, ValueError)) as caught:
        image(make())
    assert words in str(caught.value)
    assert force(cure(make())) == pytest.approx(1.0, abs=1e-6)


def write_nifti(path):
    """Writes a file as nifti1.h defines it, with a placement that VTK's and PyVista's readers drop: x points left, the
    origin is (40, 30, 20)."""
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *SIZE[::-1], 1, 1, 1, 1)
    struct.pack_into("<hh", header, 70, 64, 64)
    struct.pack_into("<4f", header, 76, 1.0, 1.0, 1.0, 1.0)
    struct.pack_into("<f", header, 108, 352.0)
    struct.pack_into("<hh", header, 252, 0, 1)
    struct.pack_into("<12f", header, 280, -1, 0, 0, 40, 0, 1, 0, 30, 0, 0, 1, 20)
    header[344:348] = b"n+1\0"
    path.write_bytes(bytes(header) + RAMP.astype("<f8").tobytes())


@pytest.mark.skipif(find_explorer() is None and not os.environ.get("VOLUMEHAPTICS_BUILD"), reason="needs the explorer")
def test_a_file_instead_of_a_volume(tmp_path, build):
    """In left-posterior-superior axes, the voxel (5, 8, 10) is at (-35, -38, 30)."""
    write_nifti(tmp_path / "scan.nii")
    with pytest.raises(TypeError, match="Cure: volumehaptics-explore FILE --write-volume volume.vti"):
        image(str(tmp_path / "scan.nii"))
    explorer = find_explorer() or next(iter(build.rglob("volumehaptics-explore")), None)
    if explorer is None:
        pytest.skip("the explorer is not built")
    subprocess.run([explorer, tmp_path / "scan.nii", "--write-volume", tmp_path / "volume.vti"], check=True)
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(tmp_path / "volume.vti"))
    reader.Update()
    press = np.linspace((-35, -38, 30), (-35, -38, 32), 21)
    assert -arrays(touch(reader.GetOutput(), press))["Force"][-1][2] == pytest.approx(1.0, abs=1e-6)
    assert force(reader.GetOutput()) == 0.0
    with pytest.warns(UserWarning, match="turned from right-anterior-superior"):
        assert -arrays(touch(tmp_path / "scan.nii", press))["Force"][-1][2] == pytest.approx(1.0, abs=1e-6)
    with pytest.raises(TypeError, match="Cure: give the file of the labels"):
        touch(tmp_path / "scan.nii", press, labels=np.ones(SIZE, np.uint8))


def test_a_direction_places_a_volume():
    """Takes the direction from nibabel's affine, whose columns are as long as a voxel, as the docstrings describe."""
    affine = np.array([[-1.0, 0, 0, 40], [0, 1, 0, 30], [0, 0, 1, 20], [0, 0, 0, 1]])
    volume = image(of_nibabel().T, spacing=(1, 1, 1), origin=affine[:3, 3], direction=2.0 * affine[:3, :3])
    press = np.linspace((35, 38, 30), (35, 38, 32), 21)
    assert -arrays(touch(volume, press))["Force"][-1][2] == pytest.approx(1.0, abs=1e-6)
    for wrong in ((1, 0, 0), np.zeros((3, 3)), [[1, 0, 0], [2, 0, 0], [0, 0, 1]]):
        with pytest.raises(ValueError, match="direction is nine numbers"):
            image(RAMP, direction=wrong)


def test_labels_of_another_shape():
    """Applies the error text's cure: volumehaptics.image(labels, spacing, origin)."""
    labels = np.ones((32, 17, 12), np.uint8)
    with pytest.raises(ValueError, match=r"Cure: volumehaptics.image\(labels, spacing, origin\)"):
        force(RAMP, labels=labels)
    assert force(RAMP, labels=image(labels, (1, 1, 1), (0, 0, 0)), materials={1: dict(stiffness=200)}) == pytest.approx(0.4)


def test_names_of_labels():
    labels = np.ones(SIZE, np.uint8)
    with pytest.raises(ValueError, match="Cure: its number, or names first"):
        force(RAMP, labels=labels, materials={"liver": dict(stiffness=200)})
    for materials in ({1: dict(stiffness=200)}, [{1: dict(name="liver")}, {"liver": dict(stiffness=200)}]):
        assert force(RAMP, labels=labels, materials=materials) == pytest.approx(0.4)


def test_paths_with_masked_points():
    points = np.ma.masked_array(PRESS, np.zeros(PRESS.shape, bool))
    points[-1] = np.ma.masked
    with pytest.raises(ValueError, match="Cure: leave those out"):
        touch(RAMP, points)
    left = points[~points.mask.any(axis=1)].data
    assert -arrays(touch(RAMP, left))["Force"][-1][2] == pytest.approx(0.95, abs=1e-6)


# Remedies that install something, or that another test applies: words of the text, and the place where the remedy is
# tested.
ELSEWHERE = {
    "pip install": "installation", "built with VolumeHaptics": "installation", "install the package again": "installation",
    "check that the copy is complete": "TestLabels.py has the whole files", "place the volume": "TestLabels.py",
    "read the labels yourself": "TestLabels.py, an image", "write it again": "TestLarge.py",
    "leave series out": "TestLarge.py", "use series=1 to series=": "TestLarge.py", "open_large(": "TestLarge.py", "dask's": "TestLarge.py", "copy it, or open another level": "TestLarge.py",
    "its array with zarr": "TestLarge.py", "open one of its arrays": "TestLarge.py",
    "grids of three-dimensional cells": "TestErrors.py", "give that volume, or none": "TestHosts.py",
    "give one, or ": "TestHosts.py", 'device=["virtual", the real one]': "TestHosts.py",
    "give the vtkRenderWindowInteractor": "TestHosts.py", "volume.slicer[..., 0]": "TestTouch.py", "add_haptics() after the volume": "TestHosts.py", "what touch() or a filter": "TestIdentify.py", "the wheel": "installation",
    "the volume that you mean into its own file": "TestLabels.py", "with the slope 1": "TestLabels.py",
    "give it as the volume": "Testing/Data/Formats/TestFormats.py",
    "give it to touch(), which reads it": "Testing/Data/Formats/TestFormats.py",
    "check that its copy is complete": "TestLargeCures.py, by the reader",
}
# Remedies for plotters and pages: words of the text, and the test of Testing/PyVista that applies the remedy, or the
# package to install.
WINDOWS = {
    "plotter.add_actor(volume) before it": "TestPlotterShown.py", "VisibilityOn() of the actor": "TestPlotterShown.py",
    "open the address that the program printed": "TestWebDoor.py", 'host="localhost"': "TestWebDoor.py",
    "volumehaptics.web.serve(haptics)": "TestWeb.py", "add_haptics(plotter) before": "TestWeb.py",
    "make a new one, and show it in the browser before show()": "TestWeb.py",
    'server.start(backend="aiohttp"), without --reverse-url': "TestWebDoor.py",
    "in the sources, Examples/explore.sh builds it": "installation", "pip install": "installation", "the wheel": "installation",
}
HERE = ("array.T", "np.ascontiguousarray", "array.filled(VALUE)", "array.copy()", "array.astype(np.float32)", "Update() it",
        "vtkResampleToImage", "--write-volume", "volumehaptics.image(labels", "its number, or")


def texts_of(node):
    """Returns the string constants and f-strings of a module as texts, joined as Python joins them."""
    for one in ast.walk(node):
        if isinstance(one, ast.Constant) and isinstance(one.value, str):
            yield one.value
        elif isinstance(one, ast.JoinedStr):
            yield "".join(part.value if isinstance(part, ast.Constant) else "..." for part in one.values)


def test_each_cure_is_tried():
    plotters = Path(__file__).resolve().parents[1] / "PyVista"
    shown = (plotters / "TestPlotterCures.py").read_text(encoding="utf-8")
    assert all(where == "installation" or (plotters / where).exists() for where in WINDOWS.values())
    tried = (*HERE, *ELSEWHERE, *WINDOWS)
    untried = []
    for file in sorted(Path(volumehaptics.__file__).parent.glob("*.py")):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        for text in texts_of(tree):
            cure = text.partition("Cure: ")[2]
            if cure.strip() not in ("", "...") and cure not in shown and not any(known in cure for known in tried):
                untried.append(f"{file.name}: {cure}")
    assert not untried
