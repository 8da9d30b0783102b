# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Options of the tests: the folder from which the package must be imported, and its version.

The tests run against a CMake build (ctest sets everything) and against an installed package:

    VOLUMEHAPTICS_BUILD=FOLDER VOLUMEHAPTICS_VERSION=0.3.0 python3 -m pytest Testing/Python

FOLDER is the build folder, or the site-packages that the package is installed in.
"""

import os
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
os.environ["ZARR_DEFAULT_ZARR_FORMAT"] = "2"  # zarr 3 would write version 3 by default


def pytest_addoption(parser):
    parser.addoption(
        "--write-baselines", action="store_true",
        help="write Testing/Data/Baseline anew from what is felt now, instead of comparing with it")


def from_environment(name, meaning):
    value = os.environ.get(name)
    if not value:
        pytest.fail(f"${name} is not set. Cure: set it to {meaning}.", pytrace=False)
    return value


@pytest.fixture(scope="session")
def build():
    """Folder from which the package must be imported."""
    folder = Path(from_environment("VOLUMEHAPTICS_BUILD", "the folder that the package has to come from"))
    if not folder.is_dir():
        pytest.fail(f"$VOLUMEHAPTICS_BUILD is {folder}, which is no folder.", pytrace=False)
    return folder.resolve()


@pytest.fixture(scope="session")
def version():
    """Version that the package must have."""
    return from_environment("VOLUMEHAPTICS_VERSION", "the version that the package has to have, such as 0.3.0")


@pytest.fixture(scope="session")
def data():
    """Folder of the repository with small volumes and paths."""
    return ROOT / "Data"


@pytest.fixture(scope="session")
def baselines():
    return ROOT / "Testing" / "Data" / "Baseline"


@pytest.fixture(scope="session")
def document():
    """Returns the text of a file in Documentation, by its name."""
    return lambda name: (ROOT / "Documentation" / name).read_text(encoding="utf-8")
