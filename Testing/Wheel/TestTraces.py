# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Expects the same forces of the wheel as of the build with the system's VTK ($VOLUMEHAPTICS_REFERENCE_BUILD)."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
TOLERANCE = 1e-12  # relative to the largest absolute number in the array
HEAD_CT = ROOT / "build/explore/data/Cranium.mhd"


def write_traces(folder, python, path):
    scene = [str(ROOT / "Data/HeadPhantom.vti"), *([str(HEAD_CT)] if HEAD_CT.exists() else [])]
    environment = {**os.environ, "PYTHONPATH": path, "PYTHONDONTWRITEBYTECODE": "1"}
    script = ROOT / "Testing/ParaView/reference.py"
    subprocess.run([python, script, folder, *scene], env=environment, check=True)


@pytest.fixture(scope="module")
def traces(tmp_path_factory):
    """Returns the folders of the reference's traces and of the wheel's traces."""
    reference, ours = tmp_path_factory.mktemp("reference"), tmp_path_factory.mktemp("wheel")
    build = Path(os.environ["VOLUMEHAPTICS_REFERENCE_BUILD"])
    package = next(build.glob("lib/**/volumehaptics/__init__.py"))
    write_traces(reference, "/usr/bin/python3", str(package.parents[1]))
    write_traces(ours, sys.executable, "")
    return reference, ours


def test_traces_are_those_of_the_reference(traces):
    reference, ours = traces
    files = sorted(reference.glob("*.npz"))
    assert len(files) >= 18 and [file.name for file in files] == sorted(file.name for file in ours.glob("*.npz"))
    largest = 0.0
    for file in files:
        with np.load(file) as expected, np.load(ours / file.name) as felt:
            assert set(expected) == set(felt) and len(set(felt)) >= 19
            assert np.abs(expected["Force"]).max() > 0.01, f"{file.name}: nothing is felt"
            for name in expected:
                a, b = expected[name], felt[name]
                assert a.shape == b.shape and a.dtype == b.dtype, (file.name, name)
                assert np.array_equal(np.isnan(a), np.isnan(b)), (file.name, name)
                a, b = np.nan_to_num(a.astype(float)), np.nan_to_num(b.astype(float))
                difference = np.abs(a - b).max() / max(np.abs(a).max(), np.finfo(float).tiny)
                assert difference <= TOLERANCE, (file.name, name, difference)
                largest = max(largest, difference)
    print(f"{len(files)} traces, largest relative difference {largest}")


def test_classes_are_those_of_the_reference(traces):
    said = [json.loads((folder / "classes.json").read_text()) for folder in traces]
    assert said[0] == said[1]
