# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks inspect() on files whose properties follow from how they were made."""

import json
import struct
import subprocess

import numpy as np
import pytest
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from volumehaptics import image, inspect, touch
from volumehaptics.__main__ import find_explorer
from volumehaptics.arrays import arrays

pytestmark = pytest.mark.skipif(find_explorer() is None, reason="the explorer was not built")
SPACING, ORIGIN = (1.0, 1.25, 2.0), (-30.0, 5.0, 7.5)
SIZE = (48, 52, 60)  # z, y, x


def write(path, values, spacing=SPACING):
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image(values, spacing, ORIGIN))
    writer.Write()
    return path


def ball(noise=0.0, seed=5):
    """Returns a ball of 60 HU in air of -1000 HU, with a core of 760 HU, edges that rise linearly over 4 mm, and white
    noise."""
    z, y, x = (step * (np.arange(count) - 0.5 * (count - 1)) for step, count in zip(SPACING[::-1], SIZE))
    r = np.sqrt(z[:, None, None] ** 2 + y[None, :, None] ** 2 + x[None, None, :] ** 2)
    values = -1000.0 + sum(step * np.clip(0.5 - (r - at) / 4.0, 0.0, 1.0) for step, at in ((1060.0, 22.0), (700.0, 8.0)))
    return values + noise * np.random.default_rng(seed).standard_normal(SIZE)


def test_a_ct_with_noise(tmp_path):
    values = np.round(ball(25.0)).astype(np.int16)
    found = inspect(write(tmp_path / "ball.vti", values))
    assert (found["name"], found["format"], found["type"]) == ("ball.vti", "VTK image", "short")
    assert (found["size"], found["spacing"], found["origin"]) == (list(SIZE[::-1]), list(SPACING), list(ORIGIN))
    assert found["direction"] == np.eye(3).ravel().tolist() and found["unit"] == "mm" and found["meters_per_unit"] == 0.001
    assert found["range"] == [values.min(), values.max()]
    assert found["usual_range"] == pytest.approx(np.percentile(values, (0.5, 99.5)), abs=2.0)
    assert (found["modality"], found["preset"], found["padding"]) == ("CT", "CT contrast", None)
    assert found["noise"] == pytest.approx(25.0, rel=0.15)
    least, most = found["local_noise"]
    assert 18.0 < least <= most < 32.0
    assert found["smallest_sheet"] == 2.0 and found["smallest_step"] < found["smallest_sheet_step"]


def test_noise_that_differs_from_place_to_place(tmp_path):
    values = ball()
    rng = np.random.default_rng(3)
    values[:16] += 10.0 * rng.standard_normal(values[:16].shape)
    values[16:] += 40.0 * rng.standard_normal(values[16:].shape)
    least, most = inspect(write(tmp_path / "ball.vti", values))["local_noise"]
    assert least == pytest.approx(10.0, rel=0.25) and most == pytest.approx(40.0, rel=0.25)


def test_values_without_noise(tmp_path):
    ramp = np.broadcast_to(10.0 * np.arange(SIZE[0])[:, None, None], SIZE)
    found = inspect(write(tmp_path / "ramp.vti", np.ascontiguousarray(ramp)))
    assert found["noise"] < 1e-6 and found["smallest_step"] < 1e-5


def test_padding_is_told(tmp_path):
    values = np.round(ball(20.0)).astype(np.int16)
    y, x = np.indices(SIZE[1:])
    values[:, (y - 25.5) ** 2 + (x - 29.5) ** 2 > 25.0**2] = -32768
    found = inspect(write(tmp_path / "ball.vti", values))
    assert "-32768" in found["padding"] and found["padding"] in found["notes"]
    assert found["range"][0] > -1200


def test_the_smallest_step_is_felt_and_a_third_of_it_is_not(tmp_path):
    """Makes two half-spaces with white noise, and takes the forces on a hand from touch()."""
    rng = np.random.default_rng(7)
    noise = 20.0 * rng.standard_normal((40, 40, 40))
    step = np.where(np.arange(40)[:, None, None] >= 20, 1.0, 0.0)
    smallest = inspect(write(tmp_path / "noise.vti", 3000.0 + noise, (1.0, 1.0, 1.0)))["smallest_step"]
    assert 5.0 < smallest < 100.0
    forces = {}
    for factor in (0.33, 2.0):
        volume = image(3000.0 + noise + factor * smallest * step)
        paths = [np.linspace((x, y, 15.0), (x, y, 21.5), 200) for x in range(8, 33, 6) for y in range(8, 33, 6)]
        forces[factor] = np.median([np.linalg.norm(arrays(one)["Force"][-1]) for one in touch(volume, paths)])
    assert forces[0.33] < 0.1 and forces[2.0] > 0.5, forces


def test_labels_are_offered(tmp_path):
    labels = np.zeros(SIZE, np.uint8)
    labels[10:30, 10:40, 10:30], labels[30:40, 20:40, 20:50] = 3, 17
    path = write(tmp_path / "labels.vti", labels)
    assert any("--as-labels" in note for note in inspect(path)["notes"])
    found = inspect(path, "--as-labels")
    assert (found["modality"], found["preset"], found["noise"]) == ("labels", "Labels", 0.0)


def test_labels_that_a_header_scales_a_little_are_rounded(tmp_path):
    """Labels are scaled by scl_slope of nifti1.h as in nibabel's issue 1069."""
    labels = np.zeros(SIZE, "<i2")
    labels[10:30, 10:40, 10:30], labels[30:40, 20:40, 20:50] = 3, 17
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *SIZE[::-1], 1, 1, 1, 1)
    struct.pack_into("<hh", header, 70, 4, 16)  # int16
    struct.pack_into("<5f", header, 76, 1.0, *SPACING, 1.0)
    header[344:348] = b"n+1\0"
    path = tmp_path / "labels.nii"
    for slope, is_good in ((1.00002, True), (0.3, False)):
        struct.pack_into("<2f", header, 108, 352.0, slope)
        path.write_bytes(bytes(header) + labels.tobytes())
        if is_good:
            found = inspect(path, "--as-labels")
            assert found["range"] == [0.0, 17.0] and any("rounded" in note for note in found["notes"])
            continue
        with pytest.raises(ValueError, match="not label numbers"):
            inspect(path, "--as-labels")


def test_sentences_tell_the_same_as_json(tmp_path):
    path = write(tmp_path / "ball.vti", np.round(ball(25.0)).astype(np.int16))
    run = subprocess.run([find_explorer(), path, "--inspect"], capture_output=True, text=True, check=True)
    found = inspect(path)
    assert "60 x 52 x 48 voxels of 1 x 1.25 x 2 mm" in run.stdout
    assert f"{found['noise']:.3g} HU" in run.stdout and f"differ by {found['smallest_step']:.3g} HU" in run.stdout
    for words in (found["modality_reason"], f"{found['preset']}, because {found['preset_reason']}", *found["notes"]):
        assert words in run.stdout


def test_what_can_not_be_read_is_told_with_the_cure(tmp_path):
    with pytest.raises(ValueError, match="Cure: "):
        inspect(tmp_path / "absent.nii.gz")
    path = write(tmp_path / "ball.vti", ball())
    run = subprocess.run([find_explorer(), path, "--json"], capture_output=True, text=True, check=False)
    assert run.returncode == 2 and "add --inspect" in run.stderr
    json.dumps(inspect(path, "--inspect"))
