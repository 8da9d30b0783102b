# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the script of the figures of Documentation/method.md, which prints how far the traces are from the closed forms.

Needs Matplotlib, which comes with PyVista; otherwise the test is skipped."""

import re
import subprocess
import sys

import pytest

pytest.importorskip("matplotlib", reason="the figures need Matplotlib: pip install matplotlib")
from matplotlib import image  # noqa: E402

NUMBER = r"(-?[0-9.]+)"
# The closed forms are exact for values that rise linearly. For curved values, the bounds of Documentation/evaluation.md
# apply. The proxy on the edge of a ball is pressed with up to 2 N, so it rests 1.5 mm atanh(2/22) = 0.14 mm inside
# (Documentation/method.md: T'), and the kernel blurs the ball. At 1 N, the proxy is beyond the middle of the edge by
# 1/21 of half its height; with the other alignment, it is in front of the edge.
EXPECTED = {
    "surfaces": (f"the proxy is within {NUMBER} mm", lambda mm: mm < 0.2),
    "press, PAPER": (f"within {NUMBER} N", lambda newtons: newtons < 1e-5),
    "press, PRECISE": (f"within {NUMBER} N", lambda newtons: newtons < 1e-5),
    "ball, PAPER": (f"within {NUMBER} N", lambda newtons: newtons < 0.002),
    "ball, PRECISE": (f"within {NUMBER} N", lambda newtons: newtons < 0.002),
    "cavity, PAPER": (f"within {NUMBER} N", lambda newtons: newtons < 0.002),
    "cavity, PRECISE": (f"within {NUMBER} N", lambda newtons: newtons < 0.002),
    "edge, Distinctness": (f", {NUMBER} %$", lambda share: share < 5.0),
    "edge, Edge": (f", {NUMBER} %$", lambda share: abs(share - 50.0 * (1 + 1 / 21)) < 0.1),
}


def test_figures_of_the_method(root, tmp_path):
    pictures = root / "Documentation" / "pictures"
    done = subprocess.run(
        [sys.executable, "-B", str(pictures / "method.py"), str(tmp_path)], capture_output=True, text=True, timeout=300,
        check=False)
    assert done.returncode == 0, done.stderr
    said = dict(line.split(": ", 1) for line in done.stdout.splitlines())
    assert set(said) == set(EXPECTED)
    for name, (pattern, is_right) in EXPECTED.items():
        found = re.search(pattern, said[name])
        assert found and is_right(float(found[1])), f"{name}: {said[name]}"

    drawn = {picture.name for picture in tmp_path.glob("*.png")}
    assert drawn == {picture.name for picture in pictures.glob("method-*.png")}
    page = (root / "Documentation" / "method.md").read_text(encoding="utf-8")
    for name in drawn:
        assert f"](pictures/{name})" in page, name
        pixels = image.imread(tmp_path / name)[..., :3]
        assert pixels.shape == image.imread(pictures / name)[..., :3].shape, name
        assert 0.005 < (pixels.std(axis=2) > 0.1).mean() < 0.5, name  # curves in colours
