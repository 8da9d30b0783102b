# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""With the data on a server of one rank, and of two, the trace is the one of the VTK build, edited functions included."""

import os
import shutil
import socket
import subprocess
import sys
import time

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

PLUGIN, REFERENCE = sys.argv[1:3]
mpiexec, pvserver = shutil.which("mpiexec"), shutil.which("pvserver")
# The client is an MPI program, too; a server that takes itself for a part of that would wait for ever.
environment = {name: value for name, value in os.environ.items()
               if name.startswith("OMPI_ALLOW") or not name.startswith(("OMPI_", "PMIX_"))}


def start(ranks):
    """A server, and its port."""
    with socket.socket() as free:
        free.bind(("localhost", 0))
        port = free.getsockname()[1]
    command = [mpiexec, "--oversubscribe", "-np", str(ranks)]
    command += [pvserver, f"--server-port={port}", "--disable-xdisplay-test"]
    return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, env=environment), port


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


for ranks in (1, 2):
    server, port = start(ranks)
    try:
        time.sleep(1)
        simple.Connect("localhost", port)  # tries for a minute
        touch()
        simple.Disconnect()
        print(f"{ranks} rank(s): the same")
    finally:
        server.terminate()  # mpiexec passes that on
        server.wait(30)
