# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Functions that Gui.xml calls, step by step, in the Python of a running paraview."""

import json
import os
import re
import shutil
import subprocess
import time
import traceback

from paraview import simple, smtrace

with open("/proc/self/maps", encoding="utf-8") as maps: # ParaView's own Qt; the bindings must use the same
    if "libQt6Core." in maps.read():
        from PyQt6 import QtCore, QtGui, QtWidgets
    else:
        from PyQt5 import QtCore, QtGui, QtWidgets

OUTPUT = os.environ["GUI_OUTPUT"]
AT_REST = 1e-9  # N


class Session:
    """The scene and the checks. Every step is logged, so that a failing step is not lost in a console."""

    def __init__(self):
        self.style = None

    def step(self, name):
        try:
            getattr(self, name)()
            line = "passed " + name
        except Exception:  # noqa: BLE001, into the log
            line = "failed " + name + "\n" + traceback.format_exc()
        with open(os.path.join(OUTPUT, "steps.txt"), "a", encoding="utf-8") as file:
            file.write(line + "\n")

    def device(self):
        found = [proxy for proxy in simple.GetSources().values() if proxy.GetXMLName() == "HapticDevice"]
        assert len(found) == 1, f"{len(found)} haptic devices"
        return found[0]

    def force(self, device):
        device.UpdatePropertyInformation()
        return sum(x * x for x in device.GetPropertyValue("Force")) ** 0.5

    def current_style(self):
        return simple.GetActiveView().GetInteractor().GetInteractorStyle()

    def hands(self):
        """Returns the class names of this plugin's props in the view."""
        renderer = simple.GetActiveView().SMProxy.GetClientSideObject().GetNonCompositedRenderer()
        names = [prop.GetClassName() for prop in renderer.GetViewProps()]
        return sorted(name for name in names if name.startswith("vtkHaptic"))

    def stop_trace(self):
        """Stops the tool's Python trace: it contains the device's setup, but nothing that the device does and shows."""
        trace = smtrace.stop_trace()
        found = re.findall(r"\b(Running|Armed|Recording|State|StatusText|TipPosition)\s*=", trace)
        assert not found, f"the trace sets {found}:\n{trace}"
        return trace

    def setup(self):
        smtrace.start_trace()
        head = simple.XMLImageDataReader(registrationName="HeadPhantom.vti", FileName=[os.environ["GUI_VOLUME"]])
        head.UpdatePipeline()
        view = simple.GetActiveViewOrCreate("RenderView")
        shown = simple.Show(head, view, "UniformGridRepresentation")
        colours = simple.GetColorTransferFunction("HU")
        colours.RGBPoints = [-1000, 0.8, 0.6, 0.5, 0, 0.9, 0.7, 0.6, 300, 0.95, 0.85, 0.75, 1500, 1, 1, 0.95]
        opacity = simple.GetOpacityTransferFunction("HU")
        opacity.Points = [-1000, 0, 0.5, 0, -600, 0, 0.5, 0, -200, 0.35, 0.5, 0, 2000, 0.9, 0.5, 0]
        simple.ColorBy(shown, ("POINTS", "HU"))
        shown.SetRepresentationType("Volume")
        shown.ScalarOpacityUnitDistance = 4
        shown.Shade = 1
        shown.SetScalarBarVisibility(view, False)
        self.look_at_head(view)
        simple.SetActiveSource(head)
        simple.Render()
        self.style = self.current_style()

    def look_at_head(self, view):
        view.CameraPosition = [-315, -400, 60]
        view.CameraFocalPoint = [0, 0, -22]
        view.CameraViewUp = [0, 0, 1]

    def attached(self):
        device = self.device()
        assert device.Running == 1, "Attach has not started the device"
        assert device.Touch.Input.GetXMLName() == "XMLImageDataReader", "the active volume is not what is touched"
        assert self.current_style() is not self.style, "the view has no haptic style"
        assert self.hands() == ["vtkHapticHeadUpDisplay", "vtkHapticRepresentation"], "the hand is not shown"

    def touch(self):
        found = [proxy for proxy in simple.GetSources().values() if proxy.GetXMLName() == "VolumeHaptics"]
        assert len(found) == 1, f"{len(found)} filters"
        return found[0]

    def chosen(self):
        touch = self.touch()
        assert touch.Preset == "CT contrast" and touch.Method == "Force field", (touch.Preset, touch.Method)
        self.device().UpdatePipeline()

    def saved(self):
        """Reads the preset that the plugin has saved as JSON, which any program can read."""
        with open(os.path.join(OUTPUT, "saved.json"), encoding="utf-8") as file:
            preset = json.load(file)
        assert preset["Tissues"]["fat"] == [-150, -80], preset["Tissues"]
        # Bone is as in the table of Documentation/materials.md: its strength begins at 350 HU.
        assert [350, 12] in [node[:2] for node in preset["SurfaceStrength"]["Nodes"]]
        preset["SurfaceStrength"]["Nodes"][-1][1] = 10  # at 3071 HU
        with open(os.path.join(OUTPUT, "saved.json"), "w", encoding="utf-8") as file:
            json.dump(preset, file)

    def loaded(self):
        touch = self.touch()
        assert touch.Preset == "Custom" and touch.Method == "Proxy"
        strongest = touch.SurfaceStrength.Points[-3] * touch.SurfaceStrengthScale
        assert touch.SurfaceStrength.Points[-4] == 3071 and abs(strongest - 10) < 1e-9, touch.SurfaceStrength.Points
        # Show only the outline. The next step presses the button that shows the volume again.
        shown = simple.GetDisplayProperties(simple.FindSource("HeadPhantom.vti"), simple.GetActiveView())
        shown.SetRepresentationType("Outline")
        simple.Render()

    def picture_of_dock(self, name="dock.png"):
        if shutil.which("import"):
            subprocess.run(["import", "-window", "root", os.path.join(OUTPUT, name)], check=True, timeout=60)

    def shown_as_ct(self):
        head = simple.FindSource("HeadPhantom.vti")
        shown = simple.GetDisplayProperties(head, simple.GetActiveView())
        assert shown.Representation == "Volume" and shown.ColorArrayName[:] == ["POINTS", "HU"], shown.Representation
        opacity = simple.GetOpacityTransferFunction("HU").Points
        assert opacity[0] == -1024 and opacity[1] == 0, "air is clear"
        assert opacity[-4] == 3000 and opacity[-3] == 0.998, "bone is not"
        # As in the explorer, four voxels of the first tissue that the hand meets transmit the fraction 1 - 0.998 of the
        # light.
        skin = [opacity[i + 1] for i in range(0, len(opacity), 4) if opacity[i] == -300]
        bounds, extent = head.GetDataInformation().GetBounds(), head.GetDataInformation().GetExtent()
        voxel = min((bounds[2 * a + 1] - bounds[2 * a]) / (extent[2 * a + 1] - extent[2 * a]) for a in range(3))
        assert skin == [0.998] and abs(shown.ScalarOpacityUnitDistance - 4 * voxel) < 1e-9, (skin, voxel)
        assert shown.Shade == 1

    def opened(self):
        reader = [proxy for proxy in simple.GetSources().values() if proxy.GetXMLName() == "XMLPolyDataReader"]
        assert len(reader) == 1, f"{len(reader)} recordings are open"
        assert reader[0].PointData["Force"].GetRange(-1)[1] > 0.5
        assert simple.GetDisplayProperties(reader[0], simple.GetActiveView()).Visibility == 1
        simple.Delete(reader[0])

    def opened_while_touched(self):
        assert simple.GetActiveSource().GetXMLName() == "XMLImageDataReader", "the hand goes on with what it touches"
        assert self.hands(), "and is attached"
        self.opened()

    def tip(self):
        device = self.device()
        device.UpdatePropertyInformation()
        return list(device.GetPropertyValue("TipPosition"))

    def touch_mode(self):
        assert self.device().Armed == 1, "the touch mode has not armed the device"
        with open(os.path.join(OUTPUT, "trace.py"), "w", encoding="utf-8") as file:
            file.write(self.stop_trace())
        self.start = self.tip()
        assert any(self.start), "the tip is not in front of what is seen"

    def lead(self, device, tip):
        """Moves the tip by the property, as a hand would; arming first forgets a fault."""
        device.Armed = 1
        start = self.tip()
        for i in range(1, 51):
            device.VirtualTip = [a + (b - a) * i / 50 for a, b in zip(start, tip)]
            device.UpdatePipeline()
            time.sleep(0.02)

    def contact(self):
        device = self.device()
        tip = self.tip()
        way = sum((a - b) ** 2 for a, b in zip(tip, self.start)) ** 0.5
        assert way > 5, f"the mouse led the tip by {way} mm only"
        # After a stall of the machine, the force is cut off, as required. Then approach again from outside.
        for _ in range(5):
            if self.force(device) > 0.5:
                return
            self.lead(device, self.start)
            self.lead(device, tip)
        raise AssertionError(f"only {self.force(device)} N are felt in the skin: {device.GetPropertyValue('StatusText')}")

    def turn_wheel(self, steps):
        interactor = simple.GetActiveView().GetInteractor()
        for _ in range(abs(steps)):
            interactor.MouseWheelForwardEvent() if steps > 0 else interactor.MouseWheelBackwardEvent()
            self.device().UpdatePipeline()
            time.sleep(0.02)

    def arm(self, device):
        device.Armed = 1
        for _ in range(100):
            device.UpdatePipeline()
            time.sleep(0.02)
            device.UpdatePropertyInformation()
            if "100 % of the force" in "".join(device.GetPropertyValue("StatusText")):
                break

    def feel(self):
        """Moves the tip into the forehead from the front; after a stall of the machine, tries again."""
        device = self.device()
        for _ in range(5):
            device.Armed = 0
            device.VirtualTip = [-25, -110, 45]
            for _ in range(20):
                device.UpdatePipeline()
                time.sleep(0.02)
            self.arm(device)
            self.lead(device, [-25, -70, 45])
            if self.force(device) > 0.5:
                return
        raise AssertionError(f"only {self.force(device)} N are felt: {device.GetPropertyValue('StatusText')}")

    def press(self):
        """Presses by the wheel, a voxel a step. If the machine stalled, the force was cut off, as it must be: tries
        again."""
        device = self.device()
        for _ in range(5):
            self.arm(device)
            for steps in range(1, 21):
                self.turn_wheel(1)
                if self.force(device) > 0.5:
                    return
            self.turn_wheel(-steps - 5)
        raise AssertionError(f"only {self.force(device)} N are felt: {device.GetPropertyValue('StatusText')}")

    def armed(self):
        """Checks the dock's Arm. If the machine has stalled since, the force was cut off, as it must be when the device
        is armed."""
        device = self.device()
        device.UpdatePropertyInformation()
        status = "".join(device.GetPropertyValue("StatusText"))
        assert device.Armed == 1 or "did not call the device" in status, f"Arm has not armed the device: {status}"
        self.stop_trace()

    def keys(self):
        """No key of the view is a key of the main window's actions and shortcuts, enabled or not."""
        window = self.main_window()
        # Qt 6 moved QAction and QShortcut from QtWidgets to QtGui.
        actions, shortcuts = (getattr(QtGui, name, None) or getattr(QtWidgets, name) for name in ("QAction", "QShortcut"))
        theirs = {key.toString() for action in window.findChildren(actions) for key in action.shortcuts()}
        theirs |= {shortcut.key().toString() for shortcut in window.findChildren(shortcuts)}
        # Keys that ParaView 5.11 to 6.1 uses: pqStandardViewFrameActionsImplementation.cxx.
        assert {"S", "D", "F", "G", "B", "+", "-", "Esc", "F1"} <= theirs, theirs
        # Qt writes letters in upper case, even without Shift; X11 has other names for some keys. Escape always ends the
        # touch, even if ParaView uses this key.
        names = {"plus": "+", "minus": "-", "KP_Add": "+", "KP_Subtract": "-", "question": "?", "space": "Space",
                 "comma": ",", "period": ".", "Delete": "Del", "BackSpace": "Backspace", "greater": ">", "less": "<"}
        theirs = {key.lower() if len(key) == 1 else key for key in theirs}
        theirs |= {key[6:] for key in theirs if re.fullmatch("Shift\\+.", key)}
        ours = self.keys_of_view()
        assert ours["LetGo"] == "Escape End" and ours["Touch"] == "t" and len(ours) > 12, ours
        both = {action: key for action, keys in ours.items() for key in keys.split()
                if key != "Escape" and names.get(key, key) in theirs}
        assert not both, both

    def keys_of_view(self):
        from paraview import servermanager

        proxy = servermanager.ProxyManager().NewProxy("misc", "HapticView")
        link = servermanager._getPyProxy(proxy)
        link.View, link.Device = simple.GetActiveView(), self.device()
        link.Attached = 1
        lines = "".join(link.GetPropertyValue("Keys")).splitlines()
        link.Attached = 0
        return dict(line.split("\t") for line in lines)

    def main_window(self):
        return [window for window in QtWidgets.QApplication.topLevelWidgets() if window.objectName() == "pqClientMainWindow"][0]

    def focused(self):
        focus = self.main_window().focusWidget()
        names = []
        while focus is not None:
            names.append(focus.objectName())
            focus = focus.parent()
        assert "CentralWidgetFrame" in names, f"the keyboard is at {names}"

    def escaped(self):
        device = self.device()
        device.UpdatePipeline()
        assert device.Armed == 0 and self.force(device) < AT_REST, f"Escape has left {self.force(device)} N"
        assert "HapticHeadUpDisplay" in "".join(self.hands()), "and the device attached"

    def at_rest(self):
        """Turns off rendering on interaction, since the next frame of the hand would be drawn quickly."""
        view = simple.GetActiveView()
        view.EnableRenderOnInteraction = 0
        simple.Render(view)

    def picture(self):
        if shutil.which("import"):
            subprocess.run(["import", "-window", "root", os.path.join(OUTPUT, "window.png")], check=True, timeout=60)
        simple.SaveScreenshot(os.path.join(OUTPUT, "view.png"), simple.GetActiveView())
        simple.GetActiveView().EnableRenderOnInteraction = 1

    def recorded(self):
        assert self.device().Recording == 0
        trace = simple.XMLPolyDataReader(FileName=[os.path.join(OUTPUT, "touch.vtp")])
        trace.UpdatePipeline()
        strongest = trace.PointData["Force"].GetRange(-1)[1]
        simple.Delete(trace)
        simple.SetActiveSource(simple.FindSource("HeadPhantom.vti"))
        assert strongest > 0.5, f"the recording knows of {strongest} N only"

    def detached(self):
        device = self.device()
        assert self.current_style() is self.style, "the view has not got its own style back"
        assert not self.hands(), "something is left in the view"
        assert device.Armed == 0 and self.force(device) < AT_REST, "a detached device has force"

    def armed_elsewhere(self):
        """A script arms the device on another volume; then the dock's Attach takes the device over."""
        device = self.device()
        self.other = simple.Wavelet(registrationName="Other")
        self.other_touch = simple.VolumeHaptics(Input=self.other)
        device.Touch = self.other_touch
        device.Running = 1
        device.Armed = 1
        device.UpdatePipeline()
        simple.SetActiveSource(simple.FindSource("HeadPhantom.vti"))
        smtrace.start_trace()

    def taken_over(self):
        device = self.device()
        assert device.Touch.Input.GetXMLName() == "XMLImageDataReader", "the active volume is not what is touched"
        assert device.Running == 1 and device.Armed == 0, "what was armed feels another volume all of a sudden"
        self.stop_trace()
        for proxy in (self.other_touch, self.other):
            simple.Delete(proxy)
        self.other = self.other_touch = None
        simple.SetActiveSource(simple.FindSource("HeadPhantom.vti"))
        smtrace.start_trace()

    def go_2d(self):
        simple.GetActiveView().InteractionMode = "2D"
        self.style_2d = self.current_style()

    def other_style(self):
        assert self.style_2d is not self.style and self.current_style() is self.style_2d, "ParaView's style was overwritten"
        assert not self.hands(), "something is left in the view"
        device = self.device()
        assert device.Armed == 0 and self.force(device) < AT_REST, "force, and no hand in the view"
        simple.GetActiveView().InteractionMode = "3D"
        assert self.current_style() is self.style

    def close_view(self):
        self.kept = self.device()
        self.press()
        simple.Delete(simple.GetActiveView())

    def view_closed(self):
        assert self.kept.Armed == 0 and self.force(self.kept) < AT_REST, "the view is closed, and force is left"
        view = simple.CreateView("RenderView")
        simple.GetLayoutByName("Layout #1").AssignView(0, view)
        head = simple.FindSource("HeadPhantom.vti")
        simple.Show(head, view)
        simple.SetActiveView(view)
        self.look_at_head(view)
        simple.SetActiveSource(head)
        simple.Render()
        self.style = self.current_style()

    def delete_device(self):
        self.kept = self.device()
        self.press()
        simple.Delete(self.kept)

    def device_deleted(self):
        assert self.force(self.kept) < AT_REST, "the device is deleted, and force is left"
        assert self.current_style() is self.style, "the view has not got its own style back"
        self.kept = None

    def told(self):
        """Returns the dock's text, after its next look at the device."""
        label, = self.main_window().findChildren(QtWidgets.QLabel, "HapticStatus")
        QtWidgets.QApplication.processEvents()
        end = time.monotonic() + 0.5
        while time.monotonic() < end:
            QtWidgets.QApplication.processEvents()
            time.sleep(0.01)
        return label.text()

    def call(self, slot, *arguments):
        """Calls the slot of a dock's button that is pressed before the dock has seen the last change; returns the
        dock's text."""
        dock, = self.main_window().findChildren(QtCore.QObject, "HapticDock")
        controller, = [child for child in dock.children() if child.metaObject().className() == "HapticController"]
        QtCore.QMetaObject.invokeMethod(controller, slot, *(QtCore.Q_ARG(str, one) for one in arguments))
        return self.told()

    def press_button(self, name):
        button, = self.main_window().findChildren(QtWidgets.QPushButton, name)
        button.click()
        return self.told()

    def cures(self):
        """Follows the instructions that the dock gives to the user."""
        head, file, sphere = simple.FindSource("HeadPhantom.vti"), os.path.join(OUTPUT, "cure.json"), simple.Sphere()
        sphere.UpdatePipeline()
        simple.SetActiveSource(sphere)
        for told, words in ((self.call("loadPreset", file), "Nothing can be felt yet: attach a device first."),
                            (self.call("savePreset", file), "There is nothing to save yet: attach a device first."),
                            (self.call("showAsCT"), "Select a volume in the pipeline browser, and click on a render view."),
                            (self.press_button("HapticAttach"), "can't be felt. Select a volume in the pipeline browser")):
            assert words in told, (told, words)
        simple.SetActiveSource(head)
        simple.Delete(sphere)
        shown = simple.GetDisplayProperties(head, simple.GetActiveView())
        shown.SetRepresentationType("Outline")
        self.press_button("HapticAttach")
        self.feel()
        felt, = self.main_window().findChildren(QtWidgets.QLabel, "HapticFelt")
        words = "press Show as CT volume, or choose the representation Volume."
        assert self.told() and words in felt.text(), felt.text()
        self.press_button("HapticShowAsCT")
        assert shown.Representation == "Volume" and words not in felt.text(), felt.text()
        shown.SetRepresentationType("Outline")
        assert self.told() and words in felt.text(), felt.text()
        shown.SetRepresentationType("Volume")
        assert self.told() and words not in felt.text(), felt.text()
        told = self.call("savePreset", file)
        assert told.endswith("Saved: " + file) and os.path.getsize(file) > 0, told
        self.call("loadPreset", file)
        assert self.touch().Preset == "Custom", self.touch().Preset
        self.feel()
        self.press_button("HapticAttach")

    def second_hand(self):
        """The dock's second list: another hand in the same view, which Arm and Stop lead with the first one."""
        simple.SetActiveSource(simple.FindSource("HeadPhantom.vti"))
        self.press_button("HapticAttach")
        first = self.device()
        list_of_second, = self.main_window().findChildren(QtWidgets.QComboBox, "HapticSecondDevice")
        list_of_second.setCurrentIndex(list_of_second.findData("virtual"))
        told = self.told()
        devices = [proxy for proxy in simple.GetSources().values() if proxy.GetXMLName() == "HapticDevice"]
        second, = [proxy for proxy in devices if proxy.SMProxy is not first.SMProxy]
        assert second.Running == 1 and second.Armed == 0 and second.Touch == first.Touch and second.UseTool == 0, told
        assert len(self.hands()) == 3, self.hands()
        for armed in 1, 0:
            self.press_button("HapticArm")
            assert (first.Armed, second.Armed) == (armed, armed), (armed, first.Armed, second.Armed)
        force, = self.main_window().findChildren(QtWidgets.QLabel, "HapticForce")
        assert force.text() == "0.00 N, 0.00 N", force.text()
        self.picture_of_dock("hands.png")
        list_of_second.setCurrentIndex(0)
        self.told()
        assert second.Running == 0 and first.Running == 1 and len(self.hands()) == 2, self.hands()
        simple.Delete(second)
        self.press_button("HapticAttach")

    def words(self):
        """One sentence in the panel's words, and the rest behind Why; a message hides no fault; the help."""
        simple.SetActiveSource(simple.FindSource("HeadPhantom.vti"))
        self.press_button("HapticAttach")
        device = self.device()
        why, = self.main_window().findChildren(QtWidgets.QToolButton, "HapticWhy")
        assert self.told() == "Running: virtual: Arm lets force through.", self.told()
        why.click()
        assert "Real-time priority" in self.told() and "()" not in self.told(), self.told()
        why.click()
        device.AttentionTime = 0.2
        self.press_button("HapticArm")
        time.sleep(1.0)  # the window stands still
        told = self.call("savePreset", os.path.join(OUTPUT, "fault.json"))
        assert told.startswith("Force faded out") and told.endswith("Saved: " + os.path.join(OUTPUT, "fault.json")), told
        assert "()" not in told and device.Armed == 0, told
        device.AttentionTime = 2.0
        help_button, = self.main_window().findChildren(QtWidgets.QToolButton, "HapticHelp")
        help_button.click()
        page, = self.main_window().findChildren(QtWidgets.QTextBrowser, "HapticHelpPage")
        for words in "This window", "Touch with the mouse", "Burr Radius", "Attention Time", "Virtual Tip":
            assert words in page.toPlainText(), words
        self.told()
        self.picture_of_dock("help.png")
        page.parent().close()
        self.press_button("HapticAttach")

    def proposed(self):
        """A volume of Hounsfield units begins with a preset for CT, another one with Custom; the dock takes grids, too."""
        head = simple.FindSource("HeadPhantom.vti")
        list_of_presets, = self.main_window().findChildren(QtWidgets.QComboBox, "HapticPreset")
        wavelet = simple.Wavelet(registrationName="Wavelet")
        for source, preset in ((simple.Transform(Input=head), "CT contrast"), (simple.Tetrahedralize(Input=wavelet), "Custom")):
            source.UpdatePipeline()
            simple.SetActiveSource(source)
            list_of_presets.setCurrentIndex(0)
            told = self.press_button("HapticAttach")
            touch = self.device().Touch
            assert touch.Input == source and touch.Preset == preset, (told, touch.Preset)
            self.press_button("HapticAttach")
            self.device().Touch = None
            for proxy in touch, source:
                simple.Delete(proxy)
        simple.Delete(wavelet)
        simple.SetActiveSource(head)

    def on_a_server(self):
        """Opens a recording that lies on this computer: a server does not read it, and this computer does."""
        file = os.path.join(OUTPUT, "touch.vtp")
        server = subprocess.Popen([os.environ["GUI_SERVER"], "--disable-xdisplay-test", "--server-port=0"],
                                  stdout=subprocess.PIPE, text=True)
        try:
            port = next(line for line in server.stdout if line.startswith("Accepting connection")).strip().rsplit(":", 1)[1]
            simple.Connect("127.0.0.1", int(port))
            told = self.call("openRecorded")
            assert told == file + " is on this computer, where the server can't read it: open it on the server.", told
            simple.Connect()
        finally:
            server.kill()
            server.wait()
        self.setup()
        smtrace.stop_trace()
        self.call("openRecorded")
        self.opened()
        simple.SetActiveSource(simple.FindSource("HeadPhantom.vti"))

    def armed_at_exit(self):
        self.press()


session = Session()
