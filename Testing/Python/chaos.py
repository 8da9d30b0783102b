# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls every public method of every class in a random order, with sensible and senseless arguments.

    python3 chaos.py --seeds 0:1000 --calls 2000 [--jobs 2] [--folder FOLDER]

A seed decides everything but the time that passes, and runs in a process of its own, so that a crash or a hang is
noticed. Each call has to return or report an error: a text of some words, or Python's TypeError and the like. After
each, the force of every device is finite and within its limit. Before it is made, a call is written to a journal,
whose end is printed if something goes wrong; `--seed N` makes the same calls again, here.

Methods and their arguments are read from the documentation of the wrapped classes: a new method is covered once it is
wrapped. chaos_world.py has the rest of a scene: images, paths, functions, a window.
"""

import argparse
import concurrent.futures
import faulthandler
import gc
import math
import os
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SLOWEST = 120.0  # s: the longest time for one call, on a busy machine
MEMORY = 4 << 30  # bytes of address space beyond those at the start; allocations beyond it fail
SHOWN = 25  # number of journal lines to print
NONE = "^$"

# Matches documentation that promises an error whenever a method returns false.
ERROR_WITH_FALSE = re.compile(
    r"false, (with|after) an error|reports? an error[^.]*returns? false|returns? false[^.]*reports? an error", re.IGNORECASE)

# Functions that must not be called, and why.
EXCLUDED = {
    # Methods of vtkTypeMacro: VTK does not check for a null name, and NewInstance() returns an object without an owner.
    "GetNumberOfGenerationsFromBase", "GetNumberOfGenerationsFromBaseType", "IsA", "IsTypeOf", "NewInstance",
    "SafeDownCast",
}

# Methods of superclasses to call: only those that every application calls, because VTK's other methods are out of
# scope.
INHERITED = {
    "vtkAlgorithm": ("Update", "Modified", "UpdateInformation", "GetOutputDataObject", "RemoveAllInputs"),
    "vtkProp": ("SetVisibility", "GetBounds", "GetRedrawMTime", "Modified"),
    "vtkInteractorObserver": ("SetDefaultRenderer", "SetCurrentRenderer", "SetEnabled", "Modified"),
    "vtkObject": ("GetMTime", "Modified"),
}


def overloads(function):
    """Returns the C++ argument types of each overload of a wrapped method."""
    found = []
    for text in re.findall(r"C\+\+: (.*?)(?:\n\n|\n(?=C\+\+: )|\n\w+\(self|\Z)", function.__doc__ or "", re.S):
        inside = re.search(r"\w+\((.*?)\)", " ".join(text.split()))
        if inside:
            arguments = [one.split("=")[0].strip() for one in inside[1].split(",") if one.strip()]
            found.append([re.sub(r"\w+(\[\d*\])?$", r"\1", one).strip() if re.search(r"[ *&]\w+(\[\d*\])?$", one) else one
                          for one in arguments])
    return found


def methods(cls, module, left_out=NONE):
    """Returns the names and overloads of the methods to call: all of the class itself, and a few of VTK's."""
    found = {}
    for base in cls.__mro__:
        is_ours = base.__module__ == module.__name__
        names = vars(base) if is_ours else INHERITED.get(base.__name__, ())
        for name in names:
            function = getattr(cls, name, None)
            is_method = callable(function) and not isinstance(function, type) and not name.startswith("_")
            if is_method and name not in EXCLUDED and not re.search(left_out, f"{cls.__name__}.{name}"):
                found.setdefault(name, overloads(function))
    return found


class Failed(Exception):
    """Raised if something happens that must not happen."""


class Strong:
    """A device with more force than its limit, to test this program itself."""

    tick = 0

    def IsA(self, kind):  # noqa: N802
        return kind == "vtkHapticDevice"

    def IsRunning(self):  # noqa: N802
        return True

    def UpdateState(self):  # noqa: N802
        self.tick += 10

    def GetState(self):  # noqa: N802
        return self

    def GetTick(self):  # noqa: N802
        return self.tick

    def GetMaximumForce(self):  # noqa: N802
        return 4.0

    def GetForce(self):  # noqa: N802
        return 0.0, 3.0, 3.0


class Chaos:
    def __init__(self, seed, journal, left_out=NONE, slowest=SLOWEST):
        import volumehaptics.vtkVolumeHaptics as module
        from chaos_world import World
        from vtkmodules.vtkCommonCore import VTK_STRING

        self.random = random.Random(seed)
        self.journal = os.open(journal, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o644)
        self.classes = {name: cls for name, cls in vars(module).items()
                        if name.startswith("vtk") and isinstance(cls, type) and self.is_made(cls)}
        self.methods = {name: methods(cls, module, left_out) for name, cls in self.classes.items()}
        self.errors = []
        self.limits = {}
        self.slowest = slowest

        def note(_caller, event, text):
            if len(re.findall(r"[A-Za-z]{2,}", re.sub(r"^.*?\(0x[0-9a-f]+\):", "", text, flags=re.S))) < 4:
                self.textless = f"a {event} without text: {text!r}"
            self.errors.append(text)

        note.CallDataType = VTK_STRING
        self.note = note
        self.textless = ""
        self.world = World(self.random)
        for name in self.classes:
            for _ in range(2):
                self.make(name)

    @staticmethod
    def is_made(cls):
        try:
            return cls() is not None
        except TypeError:  # abstract
            return False

    def make(self, name):
        thing = self.classes[name]()
        for event in ("ErrorEvent", "WarningEvent"):
            thing.AddObserver(event, self.note)
        self.world.add(thing)
        return thing

    def write(self, text):
        os.write(self.journal, (text + "\n").encode(errors="backslashreplace"))

    def ours(self):
        return [thing for thing in self.world.things if type(thing).__name__ in self.classes]

    def step(self):
        """One call."""
        draw = self.random.random()
        if draw < 0.02:
            self.replace()
        elif draw < 0.35:
            text, act = self.world.draw_act()
            self.write(text)
            self.do(act)
        else:
            thing = self.random.choice(self.ours())
            known = sorted(self.methods[type(thing).__name__].items())
            name, choices = self.random.choice(known)
            if name.startswith("Get") and self.random.random() < 0.7:  # Get methods are half of all, and seldom do harm
                name, choices = self.random.choice(known)
            arguments = [self.world.draw(kind) for kind in self.random.choice(choices)] if choices else []
            self.write(f"{self.world.name(thing)}.{name}({', '.join(map(self.world.name, arguments))})")
            method = getattr(thing, name)
            self.errors.clear()
            result = self.do(lambda: method(*arguments))
            documented = re.sub(r"\s+", " ", method.__doc__ or "")
            if result is False and ERROR_WITH_FALSE.search(documented) and not self.errors:
                raise Failed("False without the error that is documented")
            self.world.take(result)
        self.check_forces()

    def replace(self):
        """Deletes an object, perhaps while others hold it, and makes a new one."""
        old = self.random.choice(self.ours())
        self.write(f"del {self.world.name(old)}")
        self.world.remove(old)
        name = type(old).__name__
        del old
        self.write(f"{self.world.name(self.make(name))} = {name}()")

    def do(self, act):
        faulthandler.dump_traceback_later(self.slowest, exit=True)
        try:
            return act()
        except (TypeError, ValueError, OverflowError) as error:
            if not str(error):
                raise Failed(f"{type(error).__name__} without text") from error
            return None
        finally:
            faulthandler.cancel_dump_traceback_later()
            if self.textless:
                raise Failed(self.textless)

    def check_forces(self):
        """Checks every force against its limit. A lowered limit reaches the states only after a few ticks."""
        for device in self.world.devices():
            if not device.IsRunning():
                self.limits.pop(id(device), None)
                continue
            before = self.limits.get(id(device), (math.inf, -1))
            self.limits[id(device)] = (device.GetMaximumForce(), device.GetState().GetTick())
            device.UpdateState()
            force = math.hypot(*device.GetState().GetForce())
            if not math.isfinite(force):
                raise Failed(f"{self.world.name(device)} sends {device.GetState().GetForce()} N")
            limit = device.GetMaximumForce()
            if limit == before[0] and device.GetState().GetTick() > before[1] + 2 and force > limit * (1 + 1e-9):
                raise Failed(f"{self.world.name(device)} sends {force} N, above its limit of {limit} N")

    def go_wrong(self, fault):
        """Causes a fault that the search must find."""
        self.write(f"going wrong: {fault}")
        if fault == "crash":
            os.kill(os.getpid(), signal.SIGSEGV)
        elif fault == "hang":
            self.do(lambda: time.sleep(1000.0))
        elif fault == "force":
            self.world.things.append(Strong())
            self.check_forces()
            self.check_forces()
        elif fault == "silence":
            self.do(lambda: self.ours()[0].InvokeEvent("ErrorEvent", ""))

    def run(self, calls, fault=""):
        for i in range(calls):
            try:
                self.step()
                if i == calls // 2:
                    self.go_wrong(fault)
            except Failed as error:
                raise SystemExit(f"chaos: call {i}: {error}") from error
        self.write("the end: everything goes")
        faulthandler.dump_traceback_later(self.slowest, exit=True)
        while self.world.things:
            self.world.remove(self.random.choice(self.world.things))
        self.world.clear()
        gc.collect()
        faulthandler.cancel_dump_traceback_later()
        self.write("done")


def run_here(options):
    faulthandler.enable()
    if "VOLUMEHAPTICS_SANITIZED" not in os.environ:  # the sanitizer's shadow memory is beyond any limit
        used = int(re.search(r"VmSize:\s*(\d+)", Path("/proc/self/status").read_text())[1]) << 10
        resource.setrlimit(resource.RLIMIT_AS, (used + MEMORY,) * 2)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (256 << 20,) * 2)
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    Chaos(options.seed, options.journal, options.left_out, options.slowest).run(options.calls, options.fault)


def run_seed(seed, calls, folder, *more):
    """Runs a seed in a process and a folder of its own; returns its faults, or an empty text."""
    place = Path(folder, f"seed-{seed}")
    place.mkdir(parents=True)
    journal = place / "journal.txt"
    command = [sys.executable, str(Path(__file__).resolve()), "--seed", str(seed), "--calls", str(calls), *more]
    ended = subprocess.run(
        [*command, "--journal", str(journal)], cwd=place, check=False, text=True, errors="replace",
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    made = journal.read_text(errors="replace").splitlines() if journal.exists() else []
    if ended.returncode == 0 and made and made[-1] == "done":
        return ""
    how = f"signal {-ended.returncode}" if ended.returncode < 0 else f"exit {ended.returncode}"
    return "\n".join((
        f"seed {seed}: {how} after {len(made)} calls. Again: {' '.join(command)}", "the last calls:",
        *(f"  {line[:300]}" for line in made[-SHOWN:]), ended.stdout[-6000:]))


def run_seeds(seeds, calls, jobs, folder, *more):
    """Yields the faults of each seed that has any."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for trouble in pool.map(lambda seed: run_seed(seed, calls, folder, *more), seeds):
            if trouble:
                yield trouble


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, help="one seed, in this process")
    parser.add_argument("--seeds", default="0:10", help="FIRST:END, each in a process of its own")
    parser.add_argument("--calls", type=int, default=2000)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--left-out", default=NONE, help="methods that are not called: a pattern of Class.Method")
    parser.add_argument("--journal", default=os.devnull, help="where the calls of one seed are written")
    parser.add_argument("--folder", help="where the seeds' folders are made; a temporary one by default")
    parser.add_argument("--slowest", type=float, default=SLOWEST, help="s that one call may take")
    parser.add_argument("--fault", default="", help="goes wrong on purpose: crash, hang, force or silence")
    options = parser.parse_args()
    if options.seed is not None:
        run_here(options)
        return
    first, end = map(int, options.seeds.split(":"))
    failures = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder, more = options.folder or temporary, ("--left-out", options.left_out, "--slowest", str(options.slowest))
        for trouble in run_seeds(range(first, end), options.calls, options.jobs, folder, *more):
            failures += 1
            print(trouble, flush=True)
    print(f"{end - first} seeds of {options.calls} calls, {failures} of them failed")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
