# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the package's examples, those in its documentation and those in Documentation."""

import doctest
import math
import re

import pytest
import volumehaptics
from volumehaptics import _identify, _large, _touch, arrays, examples

MODULES = (_identify, _large, _touch, arrays, examples)


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_documentation(module):
    tried = doctest.testmod(module)
    assert tried.attempted > 0 and tried.failed == 0
    for name in getattr(module, "__all__", ("touch",)):
        assert ">>>" in getattr(module, name).__doc__, name


def test_first_touch_is_the_force_of_the_stroke(capsys):
    examples.first_touch()
    newtons = float(re.fullmatch(r"(\d\.\d+) N\n", capsys.readouterr().out)[1])
    trace = volumehaptics.touch(examples.phantom(), examples.stroke(), "CT contrast")
    assert abs(newtons - max(math.hypot(*force) for force in arrays.arrays(trace)["Force"])) < 1e-3
    # The stroke must begin and end in air.
    contact = arrays.arrays(trace)["Contact"]
    assert contact[0] == contact[-1] == 0 and contact.any()


def test_stroke_is_where_it_says():
    tip = examples.stroke(depth=2.0, length=30.0, speed=50.0, clearance=4.0)
    way = arrays.arrays(tip)
    points, time = way["Proxy"], way["Time"]
    assert abs(points[:, 0].min() + 15.0) < 1e-9 and abs(points[:, 0].max() - 15.0) < 1e-9
    assert not points[:, 1].any() and abs(points[:, 2].max() - points[:, 2].min() - 6.0) < 1e-9
    assert abs(time[-1] - (30.0 + 2 * 6.0) / 50.0) < 2e-3
    deeper = examples.stroke(depth=3.0)
    assert abs(tip.GetBounds()[4] - deeper.GetBounds()[4] - 1.0) < 1e-9


@pytest.mark.parametrize("setting, value", (("speed", 0.0), ("depth", math.nan)))
def test_stroke_that_is_none(setting, value):
    with pytest.raises(ValueError):
        examples.stroke(**{setting: value})


def test_phantom_is_the_repositorys(data):
    with open(examples.phantom_file(), "rb") as ours:
        assert ours.read() == (data / "HeadPhantom.vti").read_bytes()


def test_document_python(document, capsys):
    section = document("python.md").split("\n## VTK and NumPy\n")[1].split("\n## ")[0]
    code = "\n".join(re.findall(r"```python\n(.*?)```", section, re.DOTALL))
    exec(compile(code, "python.md", "exec"), {})
    assert re.fullmatch(r"\d+\.\d+ N\n", capsys.readouterr().out)


def test_document_measuring(document, tmp_path, capsys):
    (code,) = re.findall(r"```python\n(.*?)```", document("measuring.md"), re.DOTALL)
    names = {}
    exec(compile(code.replace("/tmp/", f"{tmp_path}/"), "measuring.md", "exec"), names)
    assert "width: 120 mm" in capsys.readouterr().out
    assert (tmp_path / "head.mrk.json").exists()
    # The touched area consists of a strip of 40 mm and two half discs; the curved forehead makes it slightly larger.
    flat = 2 * 10.0 * 40.0 + math.pi * 10.0**2
    assert 0.97 * flat < names["measured"].GetValue(2) < 1.15 * flat


def test_document_live_device(document):
    """Runs the script of "A live device" alone, as printed: it feels the head and leaves it again."""
    section = document("devices.md").split("\n## A live device\n")[1].split("\n## ")[0]
    (code,) = re.findall(r"```python\n(.*?)```", section, re.DOTALL)
    printed = []
    names = {"print": lambda *words: printed.append(words)}
    exec(compile(code, "devices.md", "exec"), names)
    assert len(printed) == 101 and printed[-1][0].startswith(("Active", "Armed"))
    assert max(math.hypot(*force) for _, force, _ in printed[:-1]) > 0.5
    assert any(contact for _, _, contact in printed[:-1])
    assert not names["device"].IsRunning()
