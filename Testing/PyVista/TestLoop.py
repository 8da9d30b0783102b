# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A large volume that Python reads is felt in VTK's own event loop, which holds Python's lock: in plotter.show(), and
in a window of VTK alone. In that loop, only the package's own Python code runs: xdotool ends the loop, and the
result is printed after it. The expected force is that of touch() with the same array in memory."""

import os
import selectors
import shutil
import subprocess
import sys
import time

import pytest

PATIENCE = 60.0  # s; no test depends on how long it takes
PROGRAM = '''
import os, sys, time
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from volumehaptics import image, open_large, touch, vtkHapticDevice, vtkInteractorStyleHaptic, vtkVolumeHapticsFilter
from volumehaptics.arrays import arrays

kind, loop, folder = sys.argv[1:]
z, y, x = np.meshgrid(*3 * [np.arange(64)], indexing="ij", sparse=True)
whole = (1000 - (x - 32) ** 2 - (y - 30) ** 2 - (z - 28) ** 2).astype(np.int16)
volume = whole
if kind == "memmap":
    np.save(folder + "/volume.npy", whole)
    volume = np.load(folder + "/volume.npy", mmap_mode="r")
elif kind == "zarr":
    import zarr
    zarr.save(folder + "/volume.zarr", whole)
    volume = zarr.open(folder + "/volume.zarr", mode="r")
elif kind == "h5py":
    import h5py
    with h5py.File(folder + "/volume.h5", "w") as file:
        file["volume"] = whole
    volume = h5py.File(folder + "/volume.h5")["volume"]

class Told:
    """Tells when the thread has read."""
    shape, dtype = volume.shape, volume.dtype

    def __getitem__(self, box):
        part = volume[box]
        if kind == "network":
            time.sleep(0.001)  # without the lock, as what waits for a disk or a network
        os.write(1, b"read\\n")
        return part

tip = (32.0, 30.0, 12.0)
large = open_large(Told())
if loop == "show":
    import pyvista as pv
    from volumehaptics.pyvista import add_haptics
    plotter = pv.Plotter(window_size=(200, 200), title="loop")
    plotter.add_mesh(pv.Cube(center=(32, 32, 32), x_length=60, y_length=60, z_length=60))
    haptics = add_haptics(plotter, large)
    device, felt, style = haptics.device, haptics.filter, haptics.style
    start = lambda: plotter.show(auto_close=False)
else:
    import vtkmodules.vtkRenderingOpenGL2
    from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor
    felt, device, style = vtkVolumeHapticsFilter(), vtkHapticDevice(), vtkInteractorStyleHaptic()
    felt.SetInputConnection(large.GetOutputPort())
    device.SetVolumeHaptics(felt)
    device.Open("virtual")
    window, renderer, interactor = vtkRenderWindow(), vtkRenderer(), vtkRenderWindowInteractor()
    window.SetWindowName("loop")
    window.SetSize(200, 200)
    window.AddRenderer(renderer)
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(style)
    style.SetDevice(device)
    device.Start()
    window.Render()
    start = interactor.Start
felt.SetMethodToForceField()  # is felt where the tip is, even if that does not move
device.GetVirtualHand().SetPosition(*tip)
device.Arm()
os.write(1, b"begins\\n")
start()
expected = arrays(touch(image(whole), np.tile(tip, (3000, 1)), method_by_name="force-field"))["Force"][-1]
# The end of the loop has disarmed: those of the last frame.
forces = vtk_to_numpy(style.GetStates().GetColumnByName("Force")).reshape(-1, 3)
strongest = forces[np.linalg.norm(forces, axis=1).argmax()]
print("felt", *strongest, *expected, device.GetStatusText().replace(" ", "_"), flush=True)
os._exit(0)
'''


@pytest.mark.skipif(not (sys.platform.startswith("linux") and shutil.which("xdotool")), reason="needs X11 and xdotool")
@pytest.mark.parametrize(("kind", "loop"), [("memmap", "show"), ("memmap", "start"), ("zarr", "show"), ("h5py", "show"),
                                            ("network", "show")])
def test_it_is_felt_in_the_loop_of_vtk(window, tmp_path, kind, loop):
    if kind in ("zarr", "h5py"):
        pytest.importorskip(kind, reason=f"pip install {kind}")
    if loop == "show":
        pytest.importorskip("pyvista")
    program = subprocess.Popen([sys.executable, "-c", PROGRAM, kind, loop, str(tmp_path)], stdout=subprocess.PIPE)
    try:
        told, end, quiet_from = b"", time.monotonic() + PATIENCE, None
        with selectors.DefaultSelector() as ready:
            ready.register(program.stdout, selectors.EVENT_READ)
            while quiet_from is None or time.monotonic() < quiet_from + 1.5:  # by then, the force has arrived, too
                assert time.monotonic() < end, f"nothing is read: {told[-200:]}"
                if ready.select(0.1):
                    part = os.read(program.stdout.fileno(), 65536)
                    assert part, "the program has ended"
                    told += part
                    if b"read" in told.partition(b"begins")[2]:
                        quiet_from = time.monotonic()
        found = subprocess.run(["xdotool", "search", "--name", "^loop$"], capture_output=True, text=True, check=True).stdout
        subprocess.run(["xdotool", "mousemove", "--window", found.split()[-1], "100", "100", "key", "--window",
                        found.split()[-1], "q"], check=True)
        told += program.communicate(timeout=PATIENCE)[0]
        words = told.decode().partition("felt ")[2].split()
        force, expected = [float(word) for word in words[:3]], [float(word) for word in words[3:6]]
        assert max(map(abs, expected)) > 0.1
        assert force == pytest.approx(expected, rel=0.02, abs=0.01), words[6:]
    finally:
        program.kill()
        program.communicate()
