# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the gallery's scripts: each writes a picture with visible content, and the numbers that it prints are right."""

import re
import subprocess
import sys

import numpy as np
import pytest
import pyvista as pv
from matplotlib import image

# The expected numbers are not copied from earlier output. They follow from the definitions of friction and drag, the
# materials' limits, and the lengths of the springs. A path 3 mm inside stretches a spring of 0.5 N/mm by 3 mm (local
# surface), by half a voxel of 3.75 mm more (the sphere of the surface proxy), or by 2 voxels more (the look-ahead of
# the paper's proxy). The proxy of PRECISE rests in the middle of the edge, which is at most half a voxel from the
# isosurface. The gyroid is between an edge and a linear ramp, on which the proxy rests 2 voxels of 2/3 mm ahead.
SPRING = r"strongest (\S+) N"
EXPECTED = {
    # A surface at 22 mm pushes a hand at 19 mm with 0.5 N/mm. The tolerance is 0.2 mm (voxels: 1.5 mm), because the
    # program samples the moving surface only occasionally.
    "beating": ([SPRING + r" of (\S+) N"], lambda n: n[1] == 1.5 and abs(n[0] - n[1]) < 0.1),
    # The phantom's edges are less even than a wall, so the tolerance is wider.
    "breathing": (
        [SPRING + r" of (\S+) N, by what goes down by (\S+) mm"],
        lambda n: 1.0 <= n[1] <= 2.0 and abs(n[0] - n[1]) < 0.35 and n[2] > 4.0),
    "force_along_a_path": ([SPRING], lambda n: 1.0 < n[0] < 8.0),
    "force_over_time": ([SPRING + r" after (\S+) s"], lambda n: 1.0 < n[0] < 10.0 and 0.2 < n[1] < 1.4),
    "friction_and_viscosity": (
        [r"friction \S+: (\S+) of (\S+) N"] * 3 + [r"viscosity \S+ N: (\S+) N"] * 3,
        lambda n: np.allclose(n, (0.1, 3, 0.3, 3, 0.6, 3, 0.2, 0.5, 1.0), rtol=0.01)),
    "live_stroke": ([SPRING + ", Active"], lambda n: 0.3 < n[0] <= 10.0),
    "methods": (
        [f"{name}: {SPRING}" for name in ("proxy", "paper", "force-field", "surface-proxy", "local-surface")],
        lambda n: n[2] > 0 and abs(n[0] - 0.5 * 3.0) < 0.5 * 1.875 and
        np.allclose((n[1], *n[3:]), np.multiply(0.5, (10.5, 4.875, 3.0)), rtol=0.08)),
    "numpy_gyroid": ([SPRING], lambda n: 0.5 * 3.5 - 0.15 < n[0] < 0.5 * (3.5 + 4 / 3) + 0.15),
    "penetrability": (
        [r"fat holds (\S+) N", SPRING + r", at (\S+) mm"],
        lambda n: abs(n[0] - 1.0) < 0.03 and n[1] > 1.5 * n[0] and 20 < n[2] <= 26),
    "presets": (
        [rf"{name}: {SPRING}" for name in ("CT contrast", "CT physical", "own functions")],
        lambda n: 1.0 < n[0] < 8.0 and 1.0 < n[1] < 8.0 and abs(n[2] - 0.3 * 12.5) < 0.3 * 0.25 * 3.75),
    "record_and_replay": ([r"(\d+) ticks, largest difference (\S+) N"], lambda n: n[0] > 500 and n[1] == 0.0),
    "region": (
        [r"the same to the bit in (\d+) of (\d+) ticks, with (\d+) % of the volume"],
        lambda n: 0.5 * n[1] < n[0] < n[1] and n[2] < 25),
    "visibility": (
        [rf"{what} is seen, and felt: from (\S+) s on, values from (\S+) HU" for what in ("Skin", "Bone alone")],
        # The opacity begins at 4/7 of the range from -600 to 1000 HU.
        lambda n: n[0] < n[2] and n[1] < 0 and 314 <= n[3] < 330),
}


def test_gallery_is_complete(root):
    folder = root / "Examples" / "PyVista"
    scripts = {script.stem for script in folder.glob("*.py")} - {"gallery", "qt_window", "touch_live"}
    assert scripts == set(EXPECTED)
    listed = re.findall(r"^\| \[(\w+)\.py\]\(\1\.py\) \|", (folder / "README.md").read_text(encoding="utf-8"), re.M)
    assert set(listed) == scripts | {"qt_window", "touch_live"}


@pytest.mark.parametrize("name", EXPECTED)
def test_script(window, root, tmp_path, name):
    picture = tmp_path / "picture.png"
    done = subprocess.run(
        [sys.executable, "-B", str(root / "Examples" / "PyVista" / f"{name}.py"), "--picture", str(picture)],
        capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0 and "DeprecationWarning" not in done.stderr, done.stderr
    patterns, are_right = EXPECTED[name]
    found = [re.search(pattern, line) for pattern, line in zip(patterns, done.stdout.splitlines())]
    assert len(found) == len(patterns) and all(found), done.stdout
    numbers = [float(number) for match in found for number in match.groups()]
    assert are_right(numbers), numbers

    pixels = image.imread(picture)[..., :3]
    height, width = pixels.shape[:2]
    assert height >= 600 and width >= 900
    # The picture shows coloured pixels on a background.
    colourful = np.ptp(pixels, axis=2) > 0.25
    assert 0.001 < colourful.mean() < 0.9 and np.unique((pixels * 15).astype(int).reshape(-1, 3), axis=0).shape[0] > 30


def packets_of(movie):
    """Returns the packets of an Ogg file with one stream (RFC 3533)."""
    data, at, packets = movie.read_bytes(), 0, [b""]
    while at < len(data):
        assert data[at:at + 4] == b"OggS"
        lengths = data[at + 27:at + 27 + data[at + 26]]
        at += 27 + len(lengths)
        for length in lengths:
            packets[-1] += data[at:at + length]
            at += length
            if length < 255:
                packets.append(b"")
    return packets[:-1]


@pytest.mark.parametrize("name", ["beating", "breathing"])
def test_movie(window, root, tmp_path, name):
    movie = tmp_path / "movie.ogv"
    done = subprocess.run(
        [sys.executable, "-B", str(root / "Examples" / "PyVista" / f"{name}.py"), "--movie", str(movie), "--pictures",
         "3"], capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0 and "DeprecationWarning" not in done.stderr, done.stderr
    header, _, _, first, *others = packets_of(movie)  # bytes as in the specification of Theora I
    assert header[:7] == b"\x80theora"
    assert (int.from_bytes(header[14:17], "big"), int.from_bytes(header[17:20], "big")) == (640, 480)
    # A packet that repeats the last frame would have about ten bytes.
    assert len(others) == 2 and len(first) > 10000 and min(map(len, others)) > 1000, list(map(len, others))


def test_own_volume_is_touched(window, root, tmp_path, head):
    # Use a smaller head, because the script's path is above the skin of any head.
    smaller = head.copy()
    smaller.spacing = [0.8 * size for size in head.spacing]
    smaller.origin = [0.8 * start for start in head.origin]
    smaller.save(tmp_path / "head.vti")
    done = subprocess.run(
        [sys.executable, "-B", str(root / "Examples" / "PyVista" / "force_along_a_path.py"), str(tmp_path / "head.vti"),
         "--picture", str(tmp_path / "picture.png")], capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    assert 0.5 < float(re.fullmatch(SPRING + "\n", done.stdout)[1]) < 10.0
    assert isinstance(pv.read(tmp_path / "picture.png"), pv.ImageData)
