#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Uses another project's program as its user does, with real keys and a real mouse, while a volume is touched in it.

usage: drive.py PYTHON PROGRAM FOLDER [VOLUME PICTURE]

Runs program.py with PYTHON, which writes to FOLDER what is felt. Expects a spring of 500 N/m (the default of a filter)
on a ball whose radius is known. Expects that the program gets the same events as without the touch, except for the keys
and wheel turns that the touch has used.

With the file VOLUME, takes a PICTURE of the program's window instead, while the volume is touched.

Needs a screen and a window manager, which host.sh provides.
"""

import json
import math
import os
import re
import signal
import struct
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
STIFFNESS = 0.5  # N/mm
RADIUS = 30.0  # mm, of program.py
# With the default kernel, the hand touches a surface up to two voxels in front of it.
AHEAD = 2.5  # mm
STEP = 1.0  # mm: a voxel, which one step of the wheel presses
PATIENCE = 60.0  # s, limit of waits; no result depends on it
START = 90.0  # s, limit of a program's start, with many imports on a busy machine


def norm(vector):
    return math.sqrt(sum(one * one for one in vector))


def xdotool(*words):
    return subprocess.run(["xdotool", *map(str, words)], stdout=subprocess.PIPE, text=True, check=False).stdout


def write_ball(file):
    """Writes the ball of program.py for f3d. Its opacity rises from 0 at the least value, 0.25 mm outside of the ball."""
    count, spacing = 97, 1.0
    axis = [spacing * (i - count // 2) for i in range(count)]
    values = [max(0.0, min(1.0, 2.0 * (RADIUS + 0.25 - math.hypot(x, y, z)))) for z in axis for y in axis for x in axis]
    extent, corner = " ".join([f"0 {count - 1}"] * 3), " ".join([str(axis[0])] * 3)
    head = f"""<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="{extent}" Origin="{corner}" Spacing="{spacing} {spacing} {spacing}"><Piece Extent="{extent}">
<PointData Scalars="V"><DataArray type="Float32" Name="V" format="appended" offset="0"/></PointData></Piece></ImageData>
<AppendedData encoding="raw">_"""
    data = struct.pack(f"<Q{len(values)}f", 4 * len(values), *values)
    Path(file).write_bytes(head.encode() + data + b"</AppendedData></VTKFile>")


def f3d_command(libraries, folder, volume=None):
    """Returns the page's command line for f3d, with the libraries and the volume of this test."""
    page = (HERE.parents[1] / "Documentation" / "hosts.md").read_text(encoding="utf-8")
    line = re.search(r"^## f3d\n.*?```sh\n(.*?)\n```", page, re.DOTALL | re.MULTILINE)[1]
    command = re.fullmatch(r"VTK_AUTOLOAD_PATH=\S+ (f3d .*) head\.vti", line)[1].split()
    os.environ.update(VTK_AUTOLOAD_PATH=libraries, HOST_PROBE=folder)
    if volume is not None:  # shows the volume from the left and the front, with the colours of a CT
        return [*command, "--resolution=640,560", "--up=+Z", "--camera-azimuth-angle=140", "--range=-300,1500", "--bg-color=0,0,0",
                "--colormap=0,0.3,0.2,0.15,0.2,0.9,0.65,0.55,0.4,0.95,0.8,0.7,1,1,1,0.95", volume]
    write_ball(f"{folder}/ball.vti")
    return [*command, "--resolution=500,500", f"{folder}/ball.vti"]


class Program:
    """A running program of programs/, or f3d."""

    def __init__(self, python, name, folder, *volume):
        self.folder = Path(folder)
        self.log = open(self.folder / "program.log", "w+", encoding="utf-8")
        self.runs_code = name != "f3d"
        self.title = "^host" if self.runs_code else "^F3D"
        command = [python, "-B", str(HERE / "program.py"), name, folder, *volume]
        self.process = subprocess.Popen(
            command if self.runs_code else f3d_command(python, folder, *volume), stdout=self.log, stderr=subprocess.STDOUT)
        self.find()

    def find(self):
        self.window = self.wait(
            "a window", lambda: xdotool("search", "--onlyvisible", "--name", self.title).split()[:1], START)[0]

        def is_looked_at():
            for x in (20, 30) if not self.runs_code else ():  # f3d removes all observers of timers until the mouse
                                                              # moves
                xdotool("mousemove", "--window", self.window, x, x)
            return (self.folder / "state.json").exists()

        self.wait("a first look", is_looked_at, START)

        if self.runs_code and self.state()["serves"]:
            self.find_scene()
        self.wait_until_steady("a window at its place", lambda state: state["middle"], 10, START)
        self.place = self.state()["middle"]

    def find_scene(self):
        """Finds the corner of a scene in a page by the pointer: the scene reports the pointer, whose place on the screen is known."""
        self.run("probe.corner = (0, 0)")
        place = {}

        def follows():
            seen = []
            for x in (250, 270):
                xdotool("mousemove", "--window", self.window, x, x + 50)
                self.let_run()
                screen = [int(word[2:]) for word in xdotool("getmouselocation", "--shell").split()[:2]]
                seen.append([a - b for a, b in zip(screen, self.state()["pointer"][1:])])
            place["corner"] = seen[0]
            return math.dist(*seen) < 1.5  # whole pixels

        self.wait("a scene that follows the pointer", follows, START)
        self.run(f"probe.corner = {place['corner']}")

    def state(self):
        return json.loads((self.folder / "state.json").read_text())

    def wait(self, what, condition, patience=PATIENCE):
        end = time.monotonic() + patience
        while time.monotonic() < end:
            if self.process.poll() is not None:
                break
            if found := condition():
                return found
            time.sleep(0.05)
        self.fail(f"waited in vain for {what}")

    def wait_state(self, what, condition, patience=PATIENCE):
        self.wait(what, lambda: condition(self.state()), patience)

    def wait_until_steady(self, what, value, looks=4, patience=PATIENCE):
        """Waits until the program's last looks, made in its event loop, have seen the same value."""
        known = {}

        def is_steady():
            state = self.state()
            if known.get("value") != value(state):
                known.update(value=value(state), looks=state["looks"])
            return state["looks"] >= known["looks"] + looks

        self.wait(what, is_steady, patience)

    def let_run(self, looks=6):
        """Lets the program handle all events that have arrived."""
        begin = self.state()["looks"]
        self.wait_state("its loop of events", lambda state: state["looks"] >= begin + looks)

    def fail(self, why):
        subprocess.run(["import", "-window", "root", str(self.folder / "failed.png")], check=False)
        self.log.flush()
        print((self.folder / "program.log").read_text()[-4000:])
        if (self.folder / "state.json").exists():
            print(self.state())
        sys.exit(f"FAILED: {why}; ended: {self.process.poll()}")

    def check(self, what, holds):
        if not holds:
            self.fail(what)

    def run(self, statement):
        """Runs a statement in the program, between two events."""
        before = self.state()["runs"]
        new = self.folder / "command.new"
        new.write_text(statement)
        new.rename(self.folder / "command")
        self.wait_state(f"the end of {statement}", lambda state: state["runs"] > before)
        self.check(f"{statement}: {self.state()['answer']}", self.state()["answer"] == "done")

    def point(self, place=None):
        window, x, y = place or self.place
        looks = None

        def has_arrived():
            nonlocal looks
            state = self.state()
            if all(abs(a - b) <= 2 for a, b in zip(state["pointer"], (window, x, y))):
                return True
            if looks is None or state["looks"] > looks + 10:  # the first motion may only enter the window
                looks = state["looks"]
                for aside in (3, 0):
                    xdotool("mousemove", *(["--window", window] if window else []), x + aside, y)
            return False

        self.wait(f"the pointer at {x}, {y}", has_arrived)

    def focus(self):
        def is_active():
            subprocess.run(["wmctrl", "-i", "-a", self.window], check=False)
            return xdotool("getactivewindow").split() == [self.window]

        self.wait("the window's focus", is_active)
        # While the window manager moves a restored window, the pointer's position in the window changes, so point
        # twice.
        window, x, y = self.place
        self.point((window, x + 20, y))
        self.point()

    def touch(self, radius=RADIUS):
        """Presses the ball until the force is that of a spring. The hand is held at the radius of the ball."""
        self.point()
        keys = self.state()["keys"]
        xdotool("key", "t")
        self.wait_state("the touch mode", lambda state: state["touch"])
        # If the wheel turned before the full force is active, the ball would feel soft.
        self.wait_state("all of the force", lambda state: "100 % of the force" in state["status"])
        for _ in range(12):
            if norm(self.state()["force"]) > 0.8:
                break
            self.press()
        self.is_felt()
        state = self.state()
        out = [proxy - center for proxy, center in zip(state["proxy"], state["center"])]
        self.check(f"the proxy is at the ball: {norm(out)} mm", radius - 0.5 < norm(out) < radius + AHEAD)
        self.check("the force points outwards", sum(a * b for a, b in zip(state["force"], out)) > 0.0)
        self.check("the program did not get t", self.state()["keys"] == keys)

    def lists_keys_that_arrive(self):
        """Expects that the listed keys work which show the list or let go."""
        if not self.runs_code:
            return
        lines = dict(line.split("\t")[::-1] for line in self.state()["listed"].splitlines() if "\t" in line)
        theirs = len(self.state()["keys"])
        for key in lines["these keys"].split():
            was_shown = self.state()["help"]
            xdotool("key", {"?": "question"}.get(key, key))
            self.wait_state(f"the list of keys by {key}", lambda state: state["help"] != was_shown)
        got = set(self.state()["keys"][theirs:])
        self.check("the program got no more than Shift", got <= {"Shift_L", ""})  # vedo gives it no name
        for key in lines["let go, force off"].split():
            self.let_go(key)
            self.touch()

    def press(self):
        """Presses by a step of the wheel, after the earlier steps: the wall of a ball breaks at 2 N, 4 mm deep."""
        before = self.state()["tip"]
        xdotool("click", 4)
        self.wait_state("a step of the wheel", lambda state: math.dist(state["tip"], before) > 0.9 * STEP)
        self.wait_until_steady("the hand at rest", lambda state: state["tip"])

    def is_felt(self):
        def is_spring(state):
            lag = [proxy - tip for proxy, tip in zip(state["proxy"], state["tip"])]
            return norm(lag) > 0.5 and all(
                abs(force - STIFFNESS * part) < 0.02 * norm(state["force"]) for force, part in zip(state["force"], lag))

        self.wait_state("the force of a spring", is_spring)

    def drag(self, back=False):
        """Drags the program's slider, if there is one, to another place and back."""
        if "drag" not in self.state():
            return
        said = len(self.state()["said"])
        (window, x0, y0), (_, x1, y1) = reversed(self.state()["drag"]) if back else self.state()["drag"]
        self.point((window, x0, y0))
        xdotool("mousedown", 1)
        for i in range(1, 6):
            self.point((window, x0 + (x1 - x0) * i // 5, y0 + (y1 - y0) * i // 5))
        xdotool("mouseup", 1)
        self.wait_state("its slider", lambda state: len(state["said"]) > said)

    def feels_nothing(self, why):
        self.wait_state(f"no force: {why}", lambda state: norm(state["force"]) == 0.0)

    def let_go(self, key=None):
        keys = self.state()["keys"]
        xdotool("key", key or self.state()["lets_go"])
        self.wait_state("the end of the touch mode", lambda state: not state["touch"] and norm(state["force"]) == 0.0)
        self.let_run()
        self.check("the program goes on after Escape", self.process.poll() is None)
        self.check("the program did not get Escape", self.state()["keys"] == keys)

    def hears(self, key):
        """Expects that the program's own key still works."""
        before = len(self.state()["keys"])
        xdotool("key", key)
        self.wait_state(f"the program's key {key}", lambda state: state["keys"][before:] == [key])

    def close_window(self):
        subprocess.run(["wmctrl", "-i", "-c", self.window], check=True)

    def close(self):
        self.close_window()
        serves = self.runs_code and self.state()["serves"]
        if serves:  # this is one page; others may come
            self.feels_nothing("closed")
            self.process.send_signal(signal.SIGINT)
        end = time.monotonic() + PATIENCE
        while self.process.poll() is None and time.monotonic() < end:
            time.sleep(0.1)
        self.check("the program ended by itself", self.process.poll() in ((0, -signal.SIGINT) if serves else (0,)))
        text = (self.folder / "program.log").read_text()
        self.check("nothing complains", "Traceback" not in text and not re.search(r"Haptic.*ERR", text))


def step(text, since=[time.monotonic()]):
    print(f"{time.monotonic() - since[0]:5.1f} s  {text}", flush=True)


def take_picture(python, name, folder, volume, picture):
    program = Program(python, name, folder, volume)
    program.focus()
    xdotool("click", 1)
    if name != "invesalius":
        xdotool("windowsize", program.window, 640, 560)
    # Draw frames at the quality of a graphics card, even if software rendering takes long.
    if program.runs_code:
        program.run("haptics.style.AutoAdjustVolumeQualityOff(); haptics.device.SetAttentionTime(600.0); probe.turn()")
    time.sleep(5.0)
    program.place = program.state()["middle"]
    program.point()
    xdotool("key", "t")
    program.wait_state("the touch mode", lambda state: state["touch"])
    time.sleep(2.0)
    for _ in range(5):
        xdotool("click", 4)
        time.sleep(1.0)

    def is_drawn():
        views = []
        for _ in range(2):
            views.append(subprocess.run(["import", "-window", program.window, "ppm:-"], stdout=subprocess.PIPE, check=True).stdout)
            time.sleep(4.0)
        return views[0] == views[1]

    program.wait("a frame at rest", is_drawn)
    print(program.state())
    subprocess.run(["import", "-window", program.window, picture], check=True)
    program.close()


def minimise(program, radius=RADIUS):
    if not program.state()["touch"]:
        program.touch(radius)
    xdotool("windowminimize", program.window)
    program.feels_nothing("minimised")
    program.wait_state("the end of the touch mode", lambda state: not state["touch"])
    program.focus()  # the window manager shows the window again
    if program.runs_code and program.state()["serves"]:
        xdotool("click", 1)  # without this click, Chromium sends no keys to the page
    program.touch(radius)
    step("minimised, nothing is felt; then it is touched again")


def main(python, name, folder):
    program = Program(python, name, folder)
    program.focus()
    xdotool("click", 1)
    step("its window is there")
    program.hears("u")
    step("it has its keys")
    program.touch()
    step("a ball is felt with 500 N/m where it is")
    program.hears("u")
    program.drag()
    step("it has its keys and its slider while that is touched")
    program.lists_keys_that_arrive()
    step("the display lists keys that arrive")
    program.let_go()
    program.hears("u")
    program.drag(back=True)
    step("Escape lets go, and the program has all of them again")

    if not program.runs_code:
        minimise(program)
        program.close()
        step("closed while it is touched, the program ends")
        return print("1 passed, 0 failed")
    program.touch()
    program.run("exec(change_style)")
    program.let_run()
    program.is_felt()
    step("the touch goes on with another style of the program")
    program.run("renderer, volume = probe.volume(); volume.VisibilityOff(); probe.draw()")
    program.feels_nothing("hidden")
    program.run("volume.VisibilityOn(); probe.draw()")
    program.let_run()
    program.feels_nothing("shown again, but not yet touched")
    if program.state()["touch"]:
        program.let_go()
    program.touch()
    step("hidden, nothing is felt; shown, it is touched again")
    program.run("renderer.RemoveVolume(volume); probe.draw()")
    program.feels_nothing("removed")
    radius = 20.0
    program.run("volume = make_volume(make_ball(20.0, probe.center))")
    program.run("renderer.AddVolume(volume); probe.draw()")
    if program.state()["touch"]:
        program.let_go()
    program.touch(radius)
    step("removed, nothing is felt; what is put in its place is touched")

    minimise(program, radius)
    if program.state()["again"]:
        program.close_window()
        program.feels_nothing("closed")
        program.wait_state("the end of the touch mode", lambda state: not state["touch"])
        program.run("exec(again)")
        program.find()
        xdotool("mousemove", 5, 5)
        program.focus()
        xdotool("click", 1)
        program.hears("u")
        ball = radius if program.state()["serves"] else RADIUS
        program.touch(ball)
        program.let_go()
        program.touch(ball)
        step("closed while it is touched, nothing is felt; another window of the program is touched")
    program.close()
    step("closed while it is touched, the program ends")
    print("1 passed, 0 failed")


if __name__ == "__main__":
    (take_picture if len(sys.argv) > 4 else main)(*sys.argv[1:])
