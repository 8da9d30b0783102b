# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python -m volumehaptics finds the explorer, passes the options on, and reports what is missing."""

import os
import shutil
import subprocess
import sys

import pytest
from volumehaptics import __main__ as program
from volumehaptics.examples import phantom_file

# Run the module's own main() with a fake explorer instead of an installed one.
WITH_FAKE = """
import sys
from volumehaptics import __main__ as program
program.find_explorer = lambda: sys.argv[1] or None
sys.exit(program.main(sys.argv[2:]))
"""
pytestmark = pytest.mark.skipif(os.name != "posix", reason="the fake explorer is a shell script")


def run(*command, **environment):
    environment = {**os.environ, **environment}
    return subprocess.run(
        [sys.executable, *command], capture_output=True, text=True, check=False, env=environment, timeout=250)


def make_program(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
    path.chmod(0o755)
    return str(path)


@pytest.fixture
def fake(tmp_path):
    """Returns an explorer that prints a line for each of its arguments."""
    return make_program(tmp_path / "fake", "for word; do echo \"[$word]\"; done; exit 7")


def test_without_arguments_it_says_how(fake):
    for result in (run("-m", "volumehaptics"), run("-c", WITH_FAKE, fake)):
        assert result.returncode == 2 and result.stdout == ""
        assert "python -m volumehaptics VOLUME" in result.stderr and "--demo" in result.stderr


def test_without_explorer_it_says_what_helps():
    result = run("-c", WITH_FAKE, "", "head.vti")
    assert result.returncode == 2 and result.stdout == ""
    assert "Examples/explore.sh" in result.stderr and "CMake/wheel/build.sh" in result.stderr
    assert run("-c", WITH_FAKE, "", "--help").returncode == 0


def test_options_are_passed_on(fake):
    result = run("-c", WITH_FAKE, fake, "my head.vti", "--method", "paper", "--live", DISPLAY=":0")
    assert result.stdout.splitlines() == ["[my head.vti]", "[--method]", "[paper]", "[--live]"]
    assert result.returncode == 7 and result.stderr == ""


def test_help_is_that_of_both(fake):
    result = run("-c", WITH_FAKE, fake, "--help", DISPLAY="")
    assert "--demo" in result.stdout and result.stdout.splitlines()[-1] == "[--help]"


def test_demo_is_the_phantom(fake):
    result = run("-c", WITH_FAKE, fake, "--demo", "--size", "300", DISPLAY=":0")
    assert result.stdout.splitlines() == [f"[{phantom_file()}]", "[--size]", "[300]"]


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="elsewhere there is always a display")
def test_without_display_it_makes_pictures(fake, tmp_path):
    arguments = ["-c", WITH_FAKE, fake, "head.vti"]
    result = run(*arguments, DISPLAY="", PATH=str(tmp_path))
    assert result.stdout.splitlines() == ["[head.vti]", "[--pictures]", "[explore-pictures]"]
    result = run(*arguments, "--pictures=there", DISPLAY="", PATH=str(tmp_path))
    assert result.stdout.splitlines() == ["[head.vti]", "[--pictures=there]"]
    # Without a display, the explorer must run on a virtual screen if xvfb-run exists.
    make_program(tmp_path / "xvfb-run", "echo screen; shift 3; exec \"$@\"")
    result = run(*arguments, "--pictures", "there", DISPLAY="", PATH=str(tmp_path))
    assert result.stdout.splitlines() == ["screen", "[head.vti]", "[--pictures]", "[there]"]


def test_where_the_explorer_is_found(tmp_path, monkeypatch):
    package = tmp_path / "prefix/lib/python3/dist-packages/volumehaptics"
    monkeypatch.setattr(program, "__file__", str(package / "__main__.py"))
    monkeypatch.setenv("PATH", str(tmp_path / "path"))
    assert program.find_explorer() is None
    # Each of these places takes precedence over the earlier ones.
    for place in (tmp_path / "path", tmp_path / "prefix/bin", package / "bin"):
        explorer = make_program(place / program.PROGRAM, "")
        assert program.find_explorer() == explorer


@pytest.mark.skipif(program.find_explorer() is None, reason="volumehaptics-explore is not installed")
@pytest.mark.skipif(
    not (os.environ.get("DISPLAY") or shutil.which("xvfb-run")), reason="pictures need a display, or xvfb-run")
def test_real_explorer_makes_pictures_of_the_phantom(tmp_path):
    result = run("-m", "volumehaptics", "--demo", "--pictures", str(tmp_path), "--size", "400")
    assert result.returncode == 0, result.stdout + result.stderr
    for picture in ("explore.png", "force.png"):
        assert (tmp_path / picture).read_bytes().startswith(b"\x89PNG"), picture
    assert "HeadPhantom" in (tmp_path / "summary.txt").read_text(encoding="utf-8")
    assert (tmp_path / "trace.vtp").stat().st_size > 0 and (tmp_path / "trace.csv").stat().st_size > 0
