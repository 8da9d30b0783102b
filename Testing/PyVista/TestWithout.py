# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Without PyVista, the package works, and the module that needs PyVista says how to install it."""

import subprocess
import sys


def run(code):
    # Run code as if PyVista were not installed.
    hidden = "import sys\nsys.modules['pyvista'] = None\n"
    return subprocess.run(
        [sys.executable, "-c", hidden + code], capture_output=True, text=True, timeout=120, check=False)


def test_package_works():
    done = run("from volumehaptics import examples\nexamples.first_touch()\n")
    assert done.returncode == 0 and done.stdout.endswith(" N\n"), done.stderr


def test_module_says_the_cure():
    done = run("import volumehaptics.pyvista\n")
    assert done.returncode == 1
    assert done.stderr.strip().splitlines()[-1] == (
        "ImportError: volumehaptics.pyvista needs PyVista. Cure: pip install pyvista")


def test_package_does_not_import_it():
    code = "import sys\nfrom volumehaptics import arrays, examples, touch\nprint('pyvista' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=False)
    assert done.stdout == "False\n", done.stderr


def test_module_is_there_by_name():
    code = "import sys, volumehaptics\nvolumehaptics.pyvista.touch\nprint('pyvista' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=False)
    assert done.stdout == "True\n", done.stderr
