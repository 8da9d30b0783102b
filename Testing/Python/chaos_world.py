# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments for chaos.py: good, bad and missing images, paths, functions, matrices, and a window."""

import math
import os
import time

import vtkmodules.vtkInteractionStyle  # noqa: F401 - which key and mouse events reach
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401 - draws charts
import vtkmodules.vtkRenderingFreeType  # noqa: F401 - draws text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - draws
from vtkmodules.vtkCommonCore import (
    vtkDataArray,
    vtkFloatArray,
    vtkLogger,
    vtkLookupTable,
    vtkPoints,
)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPiecewiseFunction, vtkPolyData, vtkTable
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkCamera,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkVolumeProperty,
)
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor

WILD = (0.0, -0.0, 1.0, -1.0, 5e-324, 1e-300, 1e-9, 1e9, 1e30, -1e30, 1e38, 4e38, 1e300, -1e300, 1.7e308, -1.7e308,
        math.inf, -math.inf, math.nan)
SENSIBLE = (0.0, 0.001, 0.05, 0.3, 0.5, 1.0, 2.0, 5.0, 8.0, 10.0, 16.0, 50.0, 100.0, 500.0, 1000.0, 3000.0)
WHOLE = (0, 1, 2, 3, 4, 5, 7, 8, 15, 16, 100, 1000, -1, -2, -100, 2**31 - 1, -(2**31))
# No hardware device, since the machine may have one.
STRINGS = ("virtual", "virtual", "virtual", "", "chaos.vtp", "chaos.csv", "chaos.json", "replay:chaos.vtp", "replay:chaos.csv",
           "replay:missing.vtp", "falcon:999", "pid:0000:0000", "nonsense", "no/such/folder/chaos.vtp", "/", "CT contrast",
           "CT physical", "MRI", "proxy", "local-surface", "surface-proxy", "Scalars", "Force", "mm", "%s%n", "\u00fc\u6587", "x" * 5000)
KEYS = "tThHgGcCmMrRvVnNeEpPsSwW3fFjaq "


def make_image(kind):
    """Returns a ramp along z, or something that is not a ramp."""
    image = vtkImageData()
    sizes = {"empty": (0, 0, 0), "flat": (16, 16, 1), "small": (3, 3, 3), "thin": (2, 40, 2)}
    image.SetDimensions(*sizes.get(kind, (16, 16, 16)))
    if kind in ("bare", "empty"):
        return image
    scalars = vtkDataArray.CreateDataArray({"bytes": 3, "short": 4, "double": 11}.get(kind, 10))
    scalars.SetName("Scalars")
    scalars.SetNumberOfComponents(2 if kind == "two" else 1)
    count = image.GetNumberOfPoints() - (5 if kind == "cut" else 0)
    scalars.SetNumberOfTuples(count)
    for i in range(count):
        z = i // 256
        value = {"nan": math.nan, "huge": 1e300 * (z - 8), "flatness": 7.0}.get(kind, 10.0 * z)
        for component in range(scalars.GetNumberOfComponents()):
            scalars.SetComponent(i, component, value if kind != "holes" or i % 97 else math.inf)
    image.GetPointData().SetScalars(scalars)
    return image


def make_path(kind):
    """Returns a path down into the ramp and up again, or something that is no path."""
    path, points, line = vtkPolyData(), vtkPoints(), vtkCellArray()
    count = 0 if kind == "empty" else 60
    for i in range(count):
        points.InsertNextPoint(8.0, 8.0, math.nan if kind == "nan" and i == 30 else 4.0 + 0.1 * min(i, 60 - i))
    path.SetPoints(points)
    for first in range(0, count, 30 if kind == "two" else 60):
        line.InsertNextCell(30 if kind == "two" else 60)
        for i in range(first, first + (30 if kind == "two" else 60)):
            line.InsertCellPoint(i)
    path.SetLines(line)
    if kind in ("times", "backwards", "tips"):
        times = vtkFloatArray()
        times.SetName("DeviceTip" if kind == "tips" else "Time")
        for i in range(count):
            times.InsertNextValue((i if kind == "times" else -i) * 0.0007)
        path.GetPointData().AddArray(times)
    return path


class World:
    """All objects of a run, and its random numbers."""

    def __init__(self, chance):
        self.random = chance
        self.things = []
        self.names = {}
        self.made = {}
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        self.fixed = [make_image(kind) for kind in (
            "good", "bytes", "short", "double", "two", "empty", "flat", "small", "thin", "bare", "cut", "nan", "huge",
            "flatness", "holes")]
        self.fixed += [make_path(kind) for kind in ("good", "empty", "nan", "two", "times", "backwards", "tips")]
        self.fixed += [vtkTable(), vtkTable(), vtkPiecewiseFunction(), vtkPiecewiseFunction(), vtkVolumeProperty(),
                       vtkVolumeProperty(), vtkMatrix4x4(), vtkMatrix4x4(), vtkCamera(), vtkLookupTable(), vtkVolume(),
                       vtkLineSource(), vtkSphereSource(), vtkRenderer(), vtkRenderer(), vtkGenericRenderWindowInteractor()]
        self.fixed += [one.GetOutputPort() for one in self.fixed if one.IsA("vtkAlgorithm")]
        self.window = None
        if os.environ.get("DISPLAY"):
            self.window = vtkRenderWindow()
            self.window.SetSize(96, 64)
            self.window.AddRenderer(self.renderers()[0])
            interactor = vtkGenericRenderWindowInteractor()
            interactor.SetRenderWindow(self.window)
            self.window.Render()
            self.fixed += [self.window, interactor]
        for thing in self.fixed:
            self.call(thing)

    def renderers(self):
        return [one for one in self.fixed if one.IsA("vtkRenderer")]

    def call(self, thing):
        kind = type(thing).__name__
        self.made[kind] = self.made.get(kind, 0) + 1
        self.names[thing.__this__] = f"{kind}_{self.made[kind]}"

    def name(self, thing):
        return self.names.get(getattr(thing, "__this__", None)) or repr(thing)[:200]

    def add(self, thing):
        self.things.append(thing)
        self.call(thing)

    def remove(self, thing):
        self.things = [one for one in self.things if one is not thing]

    def clear(self):
        self.fixed.clear()
        self.window = None

    def take(self, thing):
        """Keeps the result of a method, to use it as an argument and to change it."""
        if hasattr(thing, "IsA") and not any(one is thing for one in self.things + self.fixed) and len(self.fixed) < 120:
            self.fixed.append(thing)
            self.call(thing)

    def devices(self):
        return [one for one in self.things if one.IsA("vtkHapticDevice")]

    def of(self, kind):
        return [one for one in self.things + self.fixed if one.IsA(kind)]

    def number(self):
        draw = self.random.random()
        if draw < 0.6:
            return self.random.choice(SENSIBLE)
        return self.random.choice(WILD) if draw < 0.9 else self.random.uniform(-20.0, 20.0)

    def draw(self, kind):
        """Returns a random argument of a C++ type."""
        chance = self.random
        if chance.random() < 0.01:
            return chance.choice((None, "two", (), [1.0], {}, 3))  # of another type
        array = chance.random() < 0.97 and kind.endswith("]")
        if array:
            size = int(kind[kind.index("[") + 1 : -1] or 9)
            one = self.number if "double" in kind or "float" in kind else lambda: chance.choice(WHOLE)
            return [one() for _ in range(size if chance.random() < 0.97 else chance.randrange(12))]
        if kind.endswith("*") and "char" not in kind:
            known = self.of(kind.replace("const", "").strip(" *"))
            return chance.choice(known) if known and chance.random() < 0.9 else None
        if "char" in kind or "string" in kind:
            return chance.choice(STRINGS) if chance.random() < 0.95 else None
        if "double" in kind or "float" in kind:
            return self.number()
        if kind in ("bool", "vtkTypeBool"):
            return chance.choice((True, False))
        return chance.choice(WHOLE)

    def draw_act(self):
        """Returns another action of an application: its text and its call."""
        acts = [getattr(self, name) for name in sorted(dir(self)) if name.startswith("act_")]
        return self.random.choice(acts + 3 * [self.act_event, self.act_touch] + 2 * [self.act_style, self.act_trace])()

    def pick(self, kind):
        return self.random.choice(self.of(kind))

    def spell(self, thing, method, *arguments):
        return (f"{self.name(thing)}.{method}({', '.join(map(self.name, arguments))})",
                lambda: getattr(thing, method)(*arguments))

    def act_touch(self):
        """A correct live session."""
        device, haptics = self.pick("vtkHapticDevice"), self.pick("vtkVolumeHapticsFilter")
        image = self.fixed[0]

        def act():
            haptics.SetInputData(0, image)
            haptics.SetMethodToProxy()
            device.SetVolumeHaptics(haptics)
            device.SetDeviceToWorld(None)
            if device.GetDeviceId() != "virtual":
                device.Open("virtual")
            device.GetVirtualHand().Place(8.0, 8.0, 2.0)
            device.Start()
            device.Publish()
            device.Arm()
            device.GetVirtualHand().SetPosition(8.0, 8.0, 9.0)
            device.UpdateState()

        return f"{self.name(device)} touches {self.name(image)} with {self.name(haptics)}", act

    def act_trace(self):
        """Touches an image along a path; often both are good, with whatever settings the filter has."""
        haptics = self.pick("vtkVolumeHapticsFilter")
        good = self.random.random() < 0.6
        image = self.fixed[0] if good else self.random.choice([*self.of("vtkImageData"), None])
        paths = [one for one in self.of("vtkPolyData")]
        path = self.random.choice([*paths, *paths, None])

        def act():
            haptics.SetInputData(0, image)
            haptics.SetPathData(path)
            haptics.Update()

        return f"{self.name(haptics)} feels {self.name(path)} through {self.name(image)}", act

    def act_record(self):
        device = self.pick("vtkHapticDevice")
        file = self.random.choice(("chaos.vtp", "chaos.csv", "chaos.csv", "no/such/folder/chaos.vtp", "/proc/chaos.vtp"))

        def act():
            if device.GetRecorder().Start(file):
                device.UpdateState()
                time.sleep(0.01)
                device.GetRecorder().Stop()

        return f"{self.name(device)} records {file}", act

    def act_update(self):
        return self.spell(self.random.choice([one for one in self.things if one.IsA("vtkAlgorithm")]), "Update")

    def act_save(self):
        return self.spell(self.pick("vtkHapticSetup"), self.random.choice(("Save", "Load")), "chaos.json")

    def act_lead(self):
        hand = self.pick("vtkHapticDevice").GetVirtualHand()
        return self.spell(hand, "SetPosition", *(self.random.uniform(1, 14) for _ in range(3)))

    def act_function(self):
        function = self.pick("vtkPiecewiseFunction")
        if self.random.random() < 0.3:
            return self.spell(function, "RemoveAllPoints")
        more = (self.number(), self.number()) if self.random.random() < 0.3 else ()
        if more and not all(0.0 <= one <= 1.0 for one in more):
            more = ()  # which VTK refuses
        return self.spell(function, "AddPoint", self.number(), self.number(), *more)

    def act_matrix(self):
        matrix = self.pick("vtkMatrix4x4")
        if self.random.random() < 0.5:
            return self.spell(matrix, "Identity")
        return self.spell(matrix, "SetElement", self.random.randrange(4), self.random.randrange(4), self.number())

    def act_image(self):
        image = self.pick("vtkImageData")
        draw = self.random.random()
        if draw < 0.4:
            return self.spell(image, self.random.choice(("SetSpacing", "SetOrigin")), self.number(), self.number(), self.number())
        if draw < 0.7:
            return self.spell(image, "SetSpacing", 1.0, 1.0, 1.0)
        return self.spell(image, "SetOrigin", 0.0, 0.0, 0.0)

    def act_input(self):
        algorithm = self.random.choice([one for one in self.things if one.IsA("vtkAlgorithm")])
        data = self.random.choice([*self.of("vtkImageData"), *self.of("vtkPolyData"), None])
        ports = algorithm.GetNumberOfInputPorts()
        return self.spell(algorithm, "SetInputDataObject", self.random.randrange(ports) if ports else 0, data)

    def act_connect(self):
        to = self.random.choice([one for one in self.things if one.IsA("vtkVolumeHapticsFilter")])
        source = self.random.choice([one for one in self.of("vtkAlgorithm") if not one.IsA("vtkVolumeHapticsFilter")])
        port = 0 if source.IsA("vtkHapticRegionFilter") else 1
        return (f"{self.name(to)}.SetInputConnection({port}, {self.name(source)}.GetOutputPort())",
                lambda: source.GetNumberOfOutputPorts() and to.SetInputConnection(port, source.GetOutputPort()))

    def act_array(self):
        haptics = self.pick("vtkVolumeHapticsFilter")
        name = self.random.choice(("Scalars", "Scalars", "nothing", ""))
        return self.spell(haptics, "SetInputArrayToProcess", 0, 0, 0, self.random.choice((0, 0, 1, 2)), name)

    def act_camera(self):
        method = self.random.choice(("SetPosition", "SetFocalPoint", "SetViewUp"))
        return self.spell(self.pick("vtkCamera"), method, *(self.random.choice(SENSIBLE) for _ in range(3)))

    def act_print(self):
        thing = self.random.choice(self.things)
        return f"str({self.name(thing)})", lambda: str(thing)

    def act_prop(self):
        prop = self.random.choice(self.of("vtkProp"))
        renderer = self.random.choice(self.renderers())
        return self.spell(renderer, self.random.choice(("AddViewProp", "AddViewProp", "RemoveViewProp")), prop)

    def act_style(self):
        """Gives a style the window, and perhaps all other objects that it can have."""
        style, interactor = self.pick("vtkInteractorStyleHaptic"), self.random.choice(self.of("vtkRenderWindowInteractor"))
        device, renderer = self.pick("vtkHapticDevice"), self.random.choice(self.renderers())
        props = [self.pick(name) for name in ("vtkHapticHeadUpDisplay", "vtkHapticFunctionEditor", "vtkHapticRepresentation")]
        is_whole = self.random.random() < 0.5

        def act():
            interactor.SetInteractorStyle(style)
            if is_whole:
                style.SetDevice(device)
                style.SetHeadUpDisplay(props[0])
                style.SetFunctionEditor(props[1])
                style.SetDefaultRenderer(renderer)
                for prop in props:
                    prop.SetVisibility(True)
                    renderer.AddViewProp(prop)
                props[0].SetDevice(device)
                props[2].SetDevice(device)
                renderer.GetActiveCamera().SetFocalPoint(8.0, 8.0, 8.0)
                style.TouchModeOn()

        return f"{self.name(interactor)} has {self.name(style)}{', whole' if is_whole else ''}", act

    def act_render(self):
        if not self.window:
            return "no window to render", lambda: None
        return self.spell(self.window, "Render")

    def act_event(self):
        """Sends mouse and key events, as an interactor passes them to its style."""
        chance = self.random
        interactor = chance.choice(self.of("vtkRenderWindowInteractor"))
        event = chance.choice(("MouseMoveEvent", "LeftButtonPressEvent", "LeftButtonReleaseEvent", "MouseWheelForwardEvent",
                               "MouseWheelBackwardEvent", "RightButtonPressEvent", "RightButtonReleaseEvent", "TimerEvent",
                               "KeyPressEvent", "KeyReleaseEvent", "CharEvent", "LeftButtonDoubleClickEvent"))
        x, y, key = chance.randrange(-5, 100), chance.randrange(-5, 70), chance.choice(KEYS)

        def act():
            style = interactor.GetInteractorStyle()
            if not style or not style.IsA("vtkInteractorStyleHaptic"):
                return  # skip VTK's own styles
            interactor.SetEventInformation(x, y, chance.choice((0, 1)), chance.choice((0, 1)), key, 0, key)
            interactor.InvokeEvent(event)

        return f"{self.name(interactor)}.InvokeEvent({event!r}) at {x}, {y} with key {key!r}", act
