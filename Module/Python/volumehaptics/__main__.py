# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Usage: python -m volumehaptics VOLUME [options]

Opens a window in which VOLUME can be touched with the mouse or a device: point at it and press t. If there is no
display, or with --pictures DIR, feels its way over it and writes pictures, the trace and a summary.

VOLUME     .vti .mhd .mha .nii .nii.gz .nrrd .mgz .mnc .tif .zarr, or a folder of DICOM slices
  --demo   instead of VOLUME: the head phantom that comes with the package
  --web    in a browser instead of a window (needs PyVista and trame); --web --help has its options
  --help   this text, and all options of the explorer, volumehaptics-explore, to which they go
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

PROGRAM = "volumehaptics-explore" + (".exe" if os.name == "nt" else "")
CURE = f"""python -m volumehaptics: there is no {PROGRAM}, neither in the package nor on PATH.
  Cure: the wheel brings it along (CMake/wheel/build.sh); in the sources, Examples/explore.sh builds it, too.
"""


def find_explorer() -> str | None:
    """Returns the path of the package's own program, which wheels have; otherwise the one in the package's prefix, or
    on PATH. Returns None if there is none."""
    package = Path(__file__).resolve().parent
    for program in (package / "bin" / PROGRAM, (package / "../../../../bin").resolve() / PROGRAM):
        if os.access(program, os.X_OK) and program.is_file():
            return str(program)
    return shutil.which(PROGRAM)


def without_display(command: list[str]) -> list[str]:
    """Changes the command for a computer without a display: it writes pictures, on a virtual screen if possible."""
    if not any(word == "--pictures" or word.startswith("--pictures=") for word in command):
        command = [*command, "--pictures", "explore-pictures"]
    own_screen = shutil.which("xvfb-run")
    return [own_screen, "-a", "-s", "-screen 0 1280x1024x24 -noreset", *command] if own_screen else command


def replace_process(command: list[str]) -> int:
    """Replaces this process by the command, if the system can do that."""
    sys.stdout.flush()
    sys.stderr.flush()
    if os.name == "posix":
        os.execv(command[0], command)
    return subprocess.run(command, check=False).returncode


def web(arguments: list[str]) -> int:
    """Shows the volume in a browser, without the explorer."""
    try:
        import pyvista  # noqa: F401

        from . import web as browser
    except ImportError as error:
        cure = "pip install pyvista trame trame-vuetify trame-rca"
        sys.stderr.write(f"python -m volumehaptics --web: {error}\n  Cure: {cure}\n")
        return 2
    return browser.main(arguments)


def main(arguments: list[str]) -> int:
    if not arguments:
        sys.stderr.write(__doc__)
        return 2
    if "--web" in arguments:
        return web([word for word in arguments if word != "--web"])
    explorer = find_explorer()
    if "--help" in arguments or "-h" in arguments:
        print(__doc__)
        return replace_process([explorer, "--help"]) if explorer else 0
    if explorer is None:
        sys.stderr.write(CURE)
        return 2
    if "--demo" in arguments:
        from .examples import phantom_file

        arguments = [phantom_file() if word == "--demo" else word for word in arguments]
    command = [explorer, *arguments]
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
        command = without_display(command)
    return replace_process(command)


def device() -> int:
    """Runs the program volumehaptics-device that a wheel contains."""
    return replace_process([str(Path(__file__).resolve().parent / "bin" / "volumehaptics-device"), *sys.argv[1:]])


def explore() -> int:
    """Runs the program volumehaptics-explore that a wheel contains."""
    return main(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
