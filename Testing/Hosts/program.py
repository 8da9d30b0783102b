# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program of programs/ with the lines of Documentation/hosts.md, and tells drive.py what is felt in it.

usage: program.py PROGRAM FOLDER [VOLUME]

Replaces the program's comment "code of Documentation/hosts.md" by the page's block of the same name. The block and the
program use these names:

image       image of a ball of RADIUS around (0, 0, 0), whose values are 0 at its surface; or of the file VOLUME
opacity     points (value, opacity), which show the ball; the head, if there is a file
colors      points (value, (red, green, blue))
is_scan     whether there is a file VOLUME
hear(key)   function that the program calls from its own handler of keys
make_volume function that makes a vtkVolume of an image
page        the code of Documentation/hosts.md, for a program that lacks the comment
change_style  statement that sets another style, as the program does it
lets_go     key that ends the touch, if the program keeps Escape to itself (optional)
again       statement that opens another window, which stays open when the first window is closed (optional)
probe       has watch_widget(), for lines that have no add_haptics()
server      trame's server, which shows the window in a page (optional); it ends by SIGINT

While the program runs, FOLDER/state.json says what is felt. The program runs the statements in FOLDER/command one after
another in its GUI thread, between two events, like its own code.
"""

import asyncio
import json
import os
import re
import sys
import traceback
import types
from pathlib import Path

import numpy
import volumehaptics
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper

import vtkmodules.vtkInteractionWidgets  # noqa: F401  isort: skip
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  isort: skip

HERE = Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "Documentation" / "hosts.md"
RADIUS = 30.0  # mm
CHANGE_STYLE = """from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballActor
style = vtkInteractorStyleTrackballActor()
probe.interactor.SetInteractorStyle(style)"""
PERIOD = 50  # ms between two looks at the hand


def make_ball(radius=RADIUS, center=(0.0, 0.0, 0.0)):
    axis = numpy.arange(-48.0, 49.0)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    values = 100.0 * (radius - numpy.sqrt(x * x + y * y + z * z))
    return volumehaptics.image(values.astype(numpy.float32), origin=numpy.subtract(center, 48.0))


def make_volume(image):
    mapper = vtkSmartVolumeMapper()
    mapper.SetInputData(image)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    function = vtkPiecewiseFunction()
    for point in opacity:
        function.AddPoint(*point)
    color = vtkColorTransferFunction()
    for value, rgb in colors:
        color.AddRGBPoint(value, *rgb)
    volume.GetProperty().SetScalarOpacity(function)
    volume.GetProperty().SetColor(color)
    volume.GetProperty().SetInterpolationTypeToLinear()
    volume.GetProperty().ShadeOn()
    return volume


class Probe:
    """Writes what is felt, and runs commands, in the thread of the GUI."""

    def __init__(self, folder, names):
        self.folder, self.names, self.keys = folder, names, []
        self.haptics, self.answer, self.runs, self.looks, self.center = None, None, 0, 0, (0.0, 0.0, 0.0)
        self.corner = (0, 0)  # corner of a page's scene on the screen, which drive.py finds

    def hear(self, key):
        self.keys.append(key)

    def watch(self, haptics, target):
        self.haptics = haptics
        self.interactor = haptics.style.GetInteractor()
        self.names.update(interactor=self.interactor, haptics=haptics)
        self.begin(target)

    def watch_widget(self, widget):
        self.watch(types.SimpleNamespace(widget=widget, device=widget.GetDevice(), style=widget.GetStyle()), None)

    def begin(self, target):
        """Starts a timer of the program's toolkit if it has one, or else a timer of VTK."""
        self.target = getattr(target, "plotter", target)
        if "server" in self.names:
            return self.names["server"].controller.on_server_ready.add(self.repeat_in_loop)
        bindings = [name for name in ("PySide6", "PyQt6", "PyQt5") if f"{name}.QtWidgets" in sys.modules]
        if bindings:
            self.timer = sys.modules[f"{bindings[0]}.QtCore"].QTimer()
            self.timer.timeout.connect(self.look)
            return self.timer.start(PERIOD)
        if "tkinter" in sys.modules and hasattr(target, "after"):
            return self.repeat_in_tk(target)
        if "wx" in sys.modules:
            self.timer = sys.modules["wx"].Timer()
            self.timer.Notify = self.look
            return self.timer.Start(PERIOD)
        self.timer = self.interactor.CreateRepeatingTimer(PERIOD)
        self.interactor.AddObserver("TimerEvent", lambda *_: self.look(), 2.0)

    def repeat_in_tk(self, widget):
        self.look()
        widget.after(PERIOD, lambda: self.repeat_in_tk(widget))

    def repeat_in_loop(self, **_):
        self.look()
        asyncio.get_running_loop().call_later(PERIOD / 1000.0, self.repeat_in_loop)

    def volume(self):
        """Returns the volume that the window shows."""
        window = self.interactor.GetRenderWindow()
        if window is None:  # it was closed
            return None, None
        renderers = window.GetRenderers()
        for i in range(renderers.GetNumberOfItems()):
            for j in range(renderers.GetItemAsObject(i).GetVolumes().GetNumberOfItems()):
                return renderers.GetItemAsObject(i), renderers.GetItemAsObject(i).GetVolumes().GetItemAsObject(j)
        return None, None

    def on_screen(self, x, y):
        """Returns X11's id of the window, and the pixels from the top of a place, which is given in fractions of the
        window's width and height from the bottom. Without an id, the pixels are those of the screen."""
        window = self.interactor.GetRenderWindow()
        if window is None:
            return 0, 0, 0
        width, height = window.GetSize()
        x, y = int(x * width), int((1.0 - y) * height)
        if "server" in self.names:
            return 0, self.corner[0] + x, self.corner[1] + y
        if hasattr(self.target, "mapToGlobal"):
            try:
                corner = self.target.mapToGlobal(self.target.rect().topLeft())
            except RuntimeError:  # Qt has deleted the widget
                return 0, x, y
            return 0, corner.x() + x, corner.y() + y
        words = str(window.GetGenericWindowId()).split("_")  # such as _000000000040000a_p_void; none once it is closed
        return int(words[1], 16) if len(words) > 1 else 0, x, y

    def pointer(self):
        """Returns the place where the program has last seen the pointer."""
        window = self.interactor.GetRenderWindow()
        width, height = window.GetSize() if window else (0, 0)
        x, y = self.interactor.GetEventPosition()
        return self.on_screen(x / max(width, 1), y / max(height, 1))

    def middle(self):
        """Returns the middle of the volume on the screen."""
        renderer, volume = self.volume()
        if renderer is None:
            return self.on_screen(0.5, 0.5)
        self.center = volume.GetCenter()
        renderer.SetWorldPoint(*self.center, 1.0)
        renderer.WorldToDisplay()
        width, height = self.interactor.GetRenderWindow().GetSize()
        x, y, _ = renderer.GetDisplayPoint()
        return self.on_screen(x / width, y / height)

    def turn(self):
        """Turns the camera, so that a head is seen from the left and the front."""
        renderer, volume = self.volume()
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(volume.GetCenter())
        camera.SetPosition(*numpy.add(volume.GetCenter(), (0.75, 1.0, 0.2)))
        camera.SetViewUp(0.0, 0.0, 1.0)
        renderer.ResetCamera(volume.GetBounds())
        camera.Zoom(1.3)
        renderer.ResetCameraClippingRange()
        self.draw()

    def draw(self):
        self.interactor.GetRenderWindow().Render()

    def look(self):
        command = self.folder / "command"
        if command.exists():
            text = command.read_text()
            command.unlink()
            try:
                exec(text, self.names)
                self.answer = "done"
            except Exception:
                self.answer = traceback.format_exc()
            self.runs += 1
        device = self.haptics.device
        self.looks += 1
        state = {
            "touch": bool(self.haptics.style.GetTouchMode()), "force": list(device.GetState().GetForce()),
            "tip": list(device.GetState().GetTipPosition()), "proxy": list(device.GetState().GetProxyPosition()), "keys": self.keys,
            "status": device.GetStatusText(), "answer": self.answer, "runs": self.runs,
            "looks": self.looks,
            "said": self.names.get("said", []), "middle": self.middle(), "pointer": self.pointer(),
            "center": self.center, "again": "again" in self.names, "lets_go": self.names.get("lets_go", "Escape"),
            "serves": "server" in self.names, "listed": self.haptics.style.GetKeys(),
            "help": bool(self.haptics.style.GetHeadUpDisplay().GetHelpVisibility()),
        }
        if "drag" in self.names:
            state["drag"] = [self.on_screen(*place) for place in self.names["drag"]]
        new = self.folder / "state.new"
        new.write_text(json.dumps(state))
        os.replace(new, self.folder / "state.json")


def blocks():
    """Returns the first Python block of each section of the page, by the first word of its heading."""
    if not PAGE.exists():
        return {}
    sections = re.split(r"^## ", PAGE.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]
    found = {}
    for section in sections:
        block = re.search(r"```python\n(.*?)```", section, re.DOTALL)
        if block:
            found[section.split()[0].lower()] = block[1]
    return found


def main(name, folder, file=None):
    global opacity, colors
    code = (HERE / "programs" / f"{name}.py").read_text(encoding="utf-8")
    lines = blocks()[name]
    assert len(lines.strip().splitlines()) <= 5, "the page promises five lines at most"
    mark = r"^( *)# code of Documentation/hosts.md\n"
    code, marks = re.subn(mark, lambda found: re.sub(r"^", found[1], lines, flags=re.M), code, flags=re.M)
    assert marks == 1 or "page" in code, "the program has a place for the page's code"
    if file:
        from vtkmodules.vtkIOImage import vtkMetaImageReader

        reader = vtkMetaImageReader()
        reader.SetFileName(file)
        reader.Update()
        image = reader.GetOutput()
        opacity = [(-600, 0.0), (-200, 0.0), (-100, 0.35), (150, 0.35), (250, 0.6), (1200, 0.95)]
        colors = [(-600, (0.8, 0.55, 0.45)), (100, (0.9, 0.7, 0.6)), (250, (0.95, 0.9, 0.8)), (1200, (1, 1, 0.95))]
    else:
        image = make_ball()
        opacity = [(-6000, 0.0), (-10, 0.0), (10, 1.0), (3000, 1.0)]
        colors = [(-6000, (0.9, 0.6, 0.5)), (3000, (0.9, 0.6, 0.5))]
    names = {"__name__": "__main__", "__file__": str(HERE / "programs" / f"{name}.py"), "image": image, "opacity": opacity, "colors": colors,
             "make_volume": make_volume, "change_style": CHANGE_STYLE, "make_ball": make_ball, "volumehaptics": volumehaptics}
    probe = Probe(Path(folder), names)
    names.update(hear=probe.hear, probe=probe, page=lines, is_scan=file is not None)
    add_haptics = volumehaptics.add_haptics

    def add_and_watch(target, *words, **settings):
        haptics = add_haptics(target, *words, **settings)
        probe.watch(haptics, target)
        return haptics

    volumehaptics.add_haptics = add_and_watch
    sys.argv = sys.argv[:1]
    exec(compile(code, f"{name}.py", "exec"), names)


if __name__ == "__main__":
    main(*sys.argv[1:])
