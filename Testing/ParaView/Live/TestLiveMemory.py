# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A region is too large for the memory of a server, of its processes, or of this computer: the server survives, the
cures that the errors name are tried, and the volume is felt again."""
import contextlib
import glob
import os
import resource

from paraview import simple

import live

SIDE = 221
WHOLE = 4 * SIDE**3  # bytes of the volume
SMALL = 72**3
NONE = "The server has no memory for the region around the tip. Lower MaximumRegionVoxels."


def limit_memory(process, free):
    """Gives a process only `free` bytes more than it uses now. Returns the limits before that."""
    with open(f"/proc/{process}/statm", encoding="ascii") as file:
        used = int(file.read().split()[0]) * resource.getpagesize()
    return resource.prlimit(process, resource.RLIMIT_AS, (used + int(free), resource.getrlimit(resource.RLIMIT_AS)[1]))


def servers(server):
    """Returns the processes of a server, which mpiexec may have started."""
    found = []
    for stat in glob.glob("/proc/[0-9]*/stat"):
        with contextlib.suppress(OSError), open(stat, encoding="latin-1") as file:
            number, _, rest = file.read().partition(" (")
            name, _, rest = rest.rpartition(") ")  # followed by the state, the parent, the group and the session
            if name.startswith("pvserver") and int(rest.split()[3]) == server.process.pid:
                found.append(int(number))
    return found


def check(processes, free, *words):
    live.check(processes, "there are processes")
    fine = simple.ResampleToImage(Input=simple.Wavelet(), SamplingDimensions=[SIDE] * 3)
    fine.UpdatePipeline()
    device = simple.HapticDevice(Touch=simple.VolumeHaptics(Input=fine), MaximumRegionVoxels=SMALL)
    live.press(device, [-6.5, 0, 0], [-6.5, 0, 0], armed=False)
    before = [limit_memory(process, free) for process in processes]
    device.MaximumRegionVoxels = 2**40
    live.check(live.poll(device, lambda: all(word in device.StatusText for word in words)), words, device.StatusText)
    device.MaximumRegionVoxels = SMALL
    live.press(device, [-6.5, 0, 0], [-4.5, 0, 0])
    live.check(live.poll(device, lambda: live.norm(device.Force) > 0.3), "felt, with less", device.Force, device.StatusText)
    device.Running = 0
    for process, limits in zip(processes, before):
        resource.prlimit(process, resource.RLIMIT_AS, limits)


with live.Server() as server:
    live.load_plugin(remote=True)
    # With memory for 1.5 images, the server can cut out the whole image, but can't store its message. With memory for
    # half an image, it can't cut out the image.
    check(servers(server), 1.5 * WHOLE, "The server could not cut out what is around the tip (", "). Lower MaximumRegionVoxels.")
    check(servers(server), 0.5 * WHOLE, NONE)
    check([os.getpid()], 0.5 * WHOLE, "This computer has no memory for the region around the tip. Lower MaximumRegionVoxels")
    simple.Disconnect()
with live.Server(2) as server:
    live.load_plugin(remote=True)
    check(servers(server), 0.25 * WHOLE, NONE)
    simple.Disconnect()
