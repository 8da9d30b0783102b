# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""With the data on a server of one rank or two, the trace equals that of the VTK build, also with edited functions.

Then runs the script of Documentation/paraview.md that connects to a server, and the script along a path.
"""

import os
import re
import shutil
import socket
import subprocess
import sys
import time

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

PLUGIN, REFERENCE, SOURCE = sys.argv[1:4]
mpiexec, pvserver = shutil.which("mpiexec"), shutil.which("pvserver")
# The client is an MPI program. A server that inherits its MPI variables would wait forever to join its job.
environment = {name: value for name, value in os.environ.items()
               if name.startswith("OMPI_ALLOW") or not name.startswith(("OMPI_", "PMIX_"))}


def start(ranks):
    """Starts a server; returns its process and its port."""
    with socket.socket() as free:
        free.bind(("localhost", 0))
        port = free.getsockname()[1]
    command = [mpiexec, "--oversubscribe", "-np", str(ranks)]
    command += [pvserver, f"--server-port={port}", "--disable-xdisplay-test"]
    # File names in the documentation page are relative to the source folder.
    return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, env=environment,
                            cwd=SOURCE), port


def touch():
    for remote in (True, False):
        simple.LoadPlugin(PLUGIN, remote=remote, ns=globals())
    head = simple.XMLImageDataReader(FileName=[os.path.join(REFERENCE, "Head.vti")])
    path = simple.XMLPolyDataReader(FileName=[os.path.join(REFERENCE, "HeadPath.vtp")])
    haptics = VolumeHaptics(  # noqa: F821, from the plugin
        Input=head, Path=path, Preset="CT contrast", Scalars=["POINTS", "HU"], IsoValue=-300)
    data = servermanager.Fetch(haptics).GetPointData()
    with numpy.load(os.path.join(REFERENCE, "Head-Precise.npz")) as expected:
        for name in set(expected) - {"Proxy"}:
            assert vtk_to_numpy(data.GetArray(name)).tobytes() == expected[name].tobytes(), name
    haptics.InvokeCommand("CopyPreset")
    haptics.StiffnessScale = 1000
    haptics.Stiffness.Points = [0, 0.25, 0.5, 0, 100, 0.25, 0.5, 0]
    haptics.UpdatePipeline()
    assert haptics.PointData["Stiffness"].GetRange(0) == (250.0, 250.0)


def run_documented(port):
    """Runs the documented script as printed, except for the server's port and the plugin's path."""
    with open(os.path.join(SOURCE, "Documentation", "paraview.md"), encoding="utf-8") as file:
        scripts = re.findall("```python\n(.*?)```", file.read(), re.S)
    (connect,) = [script for script in scripts if "Connect(" in script]
    load = "LoadPlugin(plugin, remote=False, ns=globals())\n"
    before, after = scripts[0].split(load)
    felt = []
    names = {"print": lambda *words: felt.append(words[0])}
    exec(before, names)
    names.update(plugin=PLUGIN, Connect=lambda host: simple.Connect(host, port))
    os.chdir(SOURCE)
    exec(connect, names)
    exec(after, names)
    assert felt[0][1] > 1.0, felt  # N


def touch_with(port):
    simple.Connect("localhost", port)  # Connect() tries for a minute
    touch()


for ranks, run in ((1, touch_with), (2, touch_with), (1, run_documented)):
    server, port = start(ranks)
    try:
        time.sleep(1)
        run(port)
        simple.Disconnect()
        print(f"{ranks} rank(s), {run.__name__}: right")
    finally:
        server.terminate()  # mpiexec passes the signal on
        server.wait(30)
