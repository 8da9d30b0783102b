# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of a live device in ParaView."""
import csv
import os
import shutil
import subprocess
import sys
import threading
import time

from paraview import simple

PLUGIN, FOLDER = sys.argv[1], sys.argv[2]
os.makedirs(FOLDER, exist_ok=True)
PATIENCE = 60.0  # s; the limit only ends a hang


def check(condition, *what):
    if not condition:
        print("FAILED:", *what, flush=True)
        sys.stdout.flush()
        os._exit(1)  # exit at once, whatever state ParaView is in
    print("ok:", *what[:1], flush=True)


def load_plugin(remote=False):
    if remote:
        simple.LoadPlugin(PLUGIN, remote=True, ns=globals())
    simple.LoadPlugin(PLUGIN, remote=False, ns=vars(simple))


def poll(device, condition, patience=PATIENCE, period=0.005):
    """Does the work of a user interface's timer until the condition is true."""
    end = time.time() + patience
    while time.time() < end:
        device.UpdatePipeline()
        if condition():
            return True
        time.sleep(period)
    return False


def poll_for(device, seconds, period=0.005):
    end = time.time() + seconds
    while time.time() < end:
        device.UpdatePipeline()
        time.sleep(period)


def norm(vector):
    return sum(x * x for x in vector) ** 0.5


def distance(a, b):
    return norm([x - y for x, y in zip(a, b)])


def growth(before, after):
    """Returns how much longer (N) a force is than the earlier force's part in its direction, which the slew limit
    limits."""
    length = norm(after)
    return length - max(0.0, sum(x * y for x, y in zip(before, after)) / length) if length else 0.0


def wait_ramp(device):
    """Waits until a wall can have full force: a wall that is pressed earlier stays soft until the tip leaves it."""
    check(poll(device, lambda: "100 % of the force" in device.StatusText), "the ramp is over", device.StatusText)


def press(device, start, end, armed=True):
    """Starts the device at one place, and moves the tip to another place."""
    device.VirtualTip = start
    device.Running = 1
    check(poll(device, lambda: device.TickRate > 0), "the servo ticks", device.StatusText)
    check(poll(device, lambda: distance(device.TipPosition, start) < 1e-9), "the tip is at its start")
    check(poll(device, lambda: device.Residency == 1.0), "what is around the tip is here", device.StatusText)
    device.Armed = 1 if armed else 0
    if armed:
        wait_ramp(device)
    device.VirtualTip = end
    check(poll(device, lambda: distance(device.TipPosition, end) < 1e-9), "the tip is led")


def read_log(path):
    """Reads the columns of a .csv of numbers."""
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    return {name: [float(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}


class Server:
    """A pvserver on a free port, which ends with the test in every case."""

    def __init__(self, ranks=1, relay=None):
        command = [shutil.which("pvserver"), "--disable-xdisplay-test", "--server-port=0"]
        if ranks > 1:
            command = [shutil.which("mpiexec"), "--oversubscribe", "-np", str(ranks)] + command
        # Remove this process's MPI variables, so that the server does not try to join its MPI job.
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(("OMPI_", "OPAL_", "PMIX_")) or name.startswith("OMPI_ALLOW")}
        self.process = subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, start_new_session=True)
        self.port = None
        self.lines = threading.Thread(target=self._read, daemon=True)
        self.lines.start()
        end = time.time() + PATIENCE
        while self.port is None and self.process.poll() is None and time.time() < end:
            time.sleep(0.02)
        check(self.port is not None, "the server listens")
        port = relay(self.port) if relay else self.port
        simple.Connect("127.0.0.1", port)

    def _read(self):
        for line in self.process.stdout:
            if line.startswith("Accepting connection"):
                self.port = int(line.strip().rsplit(":", 1)[1])

    def kill(self):
        """Kills the server without a goodbye, as a crash does."""
        try:
            os.killpg(self.process.pid, 9)
        except ProcessLookupError:
            pass
        self.process.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.kill()
