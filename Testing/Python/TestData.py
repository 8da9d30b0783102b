# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the committed data are as their README.md describes them."""

import math
import random
import subprocess
import sys

import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader

VOLUMES = ("Slab", "Ball", "Cavity", "ThinWall", "HeadPhantom")
PATHS = ("SlabPress", "SlabSlide", "BallCircle", "CavityCircle")


def load(folder):
    data = {}
    for name in [f"{volume}.vti" for volume in VOLUMES] + [f"{path}.vtp" for path in PATHS]:
        reader = vtkXMLGenericDataObjectReader()
        reader.SetFileName(str(folder / name))
        reader.Update()
        data[name[:-4]] = reader.GetOutput()
        assert data[name[:-4]], f"{name} can't be read"
    return data


@pytest.fixture(scope="module")
def committed(data):
    return load(data)


def array_of(data):
    """Returns the scalars of a volume, or the positions of a path."""
    return vtk_to_numpy(data.GetPointData().GetScalars() or data.GetPoints().GetData())


def value(image, position):
    """Computes the trilinear interpolation at a position."""
    cell = [(p - o) / s for p, o, s in zip(position, image.GetOrigin(), image.GetSpacing())]
    low = [min(int(c), n - 2) for c, n in zip(cell, image.GetDimensions())]
    total = 0.0
    for corner in range(8):
        bits = [(corner >> axis) & 1 for axis in range(3)]
        weight = math.prod(abs(c - i - 1 + b) for c, i, b in zip(cell, low, bits))
        total += weight * image.GetScalarComponentAsDouble(*map(sum, zip(low, bits)), 0)
    return total


def check_field(image, kind, formula, at_voxels, between, smooth=lambda *p: True):
    assert array_of(image).dtype == kind
    box = image.GetBounds()
    for _ in range(500):
        voxel = image.GetPoint(random.randrange(image.GetNumberOfPoints()))
        assert abs(value(image, voxel) - formula(*voxel)) <= at_voxels, voxel
        position = [random.uniform(a, b) for a, b in zip(box[::2], box[1::2])]
        if smooth(*position):
            assert abs(value(image, position) - formula(*position)) <= between, position


def wall(x, y, z):
    return 1000.0 * (math.erf((z + 0.5) / math.sqrt(2.0)) - math.erf((z - 0.5) / math.sqrt(2.0)))


def cavity(x, y, z):
    return 100.0 * max(-8.0, min(8.0, math.hypot(x, y, z) - 20.0))


def check_path(points, corners, radius=0.0, ticks=0, turns=0):
    """Checks straight lines of 0.1 mm a tick through the corners, then turns of a circle about z."""
    expected = [corners[0]]
    for a, b in zip(corners, corners[1:]):
        n = round(10 * math.dist(a, b))
        expected += [[s + (e - s) * i / n for s, e in zip(a, b)] for i in range(1, n + 1)]
    angles = [2.0 * math.pi * i / ticks for i in range(1, turns * ticks + 1)]
    expected += [(radius * math.cos(a), radius * math.sin(a), 0.0) for a in angles]
    assert len(points) == len(expected) and abs(points - expected).max() < 1e-8


def test_head(committed):
    image = committed["HeadPhantom"]
    assert image.GetDimensions() == (64, 64, 64) and image.GetSpacing() == (3.75, 3.75, 3.75)
    values = array_of(image).reshape(64, 64, 64)
    assert values.min() == -1000 and 1500 < values.max() < 2300
    assert (values[-2:] == -1000).all() and (values[0] > -1000).any()  # air above the head; the neck is cut
    for low, high, few in ((-150, -30, 4000), (-10, 15, 500), (20, 80, 15000), (300, 3000, 9000)):
        assert ((values >= low) & (values <= high)).sum() > few, (low, high)
    assert value(image, (0, -95, -25)) > -300 > value(image, (0, 105, -25))  # nose, since -y is the front
    assert value(image, (14, -63, 26)) < value(image, (-14, -63, 26)) - 200  # larger sinus on the left (+x)
    for a in (i * math.pi / 8 for i in range(16)):  # going inwards: air, scalp, skull, brain
        ray = [value(image, (r * math.cos(a), 8 + r * math.sin(a), 50)) for r in range(105, 30, -1)]
        bone = next(i for i, hu in enumerate(ray) if hu > 300)
        assert ray[0] < -990 and max(ray) > 600 and 20 < ray[-1] < 50, a
        assert sum(-500 < hu < 300 for hu in ray[:bone]) >= 3, a


def test_generator_makes_the_same(data, committed, tmp_path):
    command = [sys.executable, str(data / "generate.py"), str(tmp_path)]
    subprocess.run(command, check=True)
    again = load(tmp_path)
    for name in VOLUMES + PATHS:
        a, b = array_of(committed[name]), array_of(again[name])
        assert a.dtype == b.dtype and a.tobytes() == b.tobytes(), f"{name} is out of date"
    for a, b in ((committed[name], again[name]) for name in VOLUMES):
        for get in ("GetExtent", "GetBounds", "GetOrigin", "GetSpacing"):
            assert getattr(a, get)() == getattr(b, get)()
    subprocess.run([*command, "--noise", "20"], check=True)
    noisy, clean = (array_of(d["HeadPhantom"]) for d in (load(tmp_path), committed))
    assert 19.5 < (noisy - clean)[clean > -500].std() < 20.5


def series(folder, name, frames):
    """Returns the time steps of a series with their displacement arrays, [z, y, x, axis]."""
    images = []
    for frame in range(frames + 1):
        reader = vtkXMLGenericDataObjectReader()
        reader.SetFileName(str(folder / f"{name}{frame:03}.vti"))
        reader.Update()
        images.append(reader.GetOutput())
    text = (folder / f"{name}.pvd").read_text(encoding="utf-8")
    assert text.count("<DataSet ") == frames + 1 and f'timestep="{1 / frames!r}"' in text
    return images


def check_motion(images, most, moves):
    """Checks that each point of a time step has the same value as its displaced position in the next time step."""
    worst = [0.0, 0.0]
    for before, after in zip(images, images[1:]):
        motion = before.GetPointData().GetArray("motion")
        box = after.GetBounds()
        for _ in range(400):
            i = random.randrange(before.GetNumberOfPoints())
            place = before.GetPoint(i)
            there = [p + u for p, u in zip(place, motion.GetTuple3(i))]
            if all(a <= x <= b for a, x, b in zip(box[::2], there, box[1::2])):
                here = value(before, place)
                worst = [max(w, abs(value(after, p) - here)) for w, p in zip(worst, (there, place))]
    assert worst[0] <= most and worst[1] >= moves, worst


def test_series_that_move(data, tmp_path):
    random.seed(2)
    command = [sys.executable, str(data / "generate.py"), str(tmp_path)]
    subprocess.run([*command, "--beating", "6"], check=True)
    beating = series(tmp_path, "Beating", 6)
    # The interpolation error is h^2/8 times the second derivatives along the axes, each of which is at most 195 * 0.242
    # / 1.5^2.
    check_motion(beating, 20.0, 60.0)
    full, small = (array_of(beating[i]).reshape(56, 56, 56) for i in (0, 3))
    inner = lambda v: (v > 0.5 * (250 + 55)).sum() * 1.5**3  # contrast medium: a ball
    assert abs(inner(full) / (4 / 3 * math.pi * 16**3) - 1) < 0.02
    assert abs(inner(small) / (4 / 3 * math.pi * 12**3) - 1) < 0.02
    muscle = [(v > 0.5 * (55 - 100)).sum() * 1.5**3 - inner(v) for v in (full, small)]
    assert abs(muscle[1] / muscle[0] - 1) < 0.02  # constant volume of the muscle
    subprocess.run([*command, "--breathing", str(data / "Slab.vti"), "--frames", "4"], check=True)
    breathing = series(tmp_path, "Breathing", 4)
    check_motion(breathing, 10.0, 100.0)
    bump = lambda x, a, b: math.sin(math.pi * (x - a) / (b - a)) ** 2
    for _ in range(300):  # the slab's value is the height that the material came from
        x, y, z = (random.randint(a, b) for a, b in ((-16, 16), (-16, 16), (-16, 24)))
        before = value(breathing[2], (x, y, z)) / 100.0
        depth = 0.15 * 40 * bump(x, -16, 16) * bump(y, -16, 16) * bump(before, -16, 24)
        assert abs(before - depth - z) < 1e-6, (x, y, z)


def test_fields(committed):
    random.seed(1)
    check_field(committed["Slab"], "f8", lambda x, y, z: 100.0 * z, 0.0, 1e-9)
    # The interpolation error is at most an eighth of the second derivatives' sum, here 200 / |p|.
    inside = lambda *p: 14 < math.hypot(*p) < 26
    check_field(committed["Ball"], "f4", lambda *p: -cavity(*p), 1e-4, 1.8, inside)
    check_field(committed["Cavity"], "f4", cavity, 1e-4, 1.8, inside)
    check_field(committed["ThinWall"], "i2", wall, 0.5, 89.0)


def test_paths(committed):
    assert all(committed[p].GetCell(0).GetNumberOfPoints() == committed[p].GetNumberOfPoints() for p in PATHS)
    press, slide, ball_circle, cavity_circle = (array_of(committed[name]) for name in PATHS)
    check_path(press, [(0, 0, 0), (0, 0, 10), (0, 0, 0)])
    check_path(slide, [(0, 0, 0), (0, 0, 3), (10, 0, 3), (0, 0, 3)])
    check_path(ball_circle, [(20, 0, 0), (18, 0, 0)], 18.0, 1000, 1)
    check_path(cavity_circle, [(20, 0, 0), (22, 0, 0)], 22.0, 1257, 7)
