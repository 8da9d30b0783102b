# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Shows a touchable plotter in a page of trame: sends its pictures to the browser, and the browser's mouse and keys to
its style."""

from __future__ import annotations

import asyncio
import itertools
import math
import time
import weakref
from typing import TYPE_CHECKING, Any

try:
    from trame.ui.vuetify3 import VAppLayout
    from trame.widgets import client, html
    from trame.widgets import vuetify3 as v3
    from trame_rca.protocol import AreaAdapter
    from trame_rca.widgets.rca import RemoteControlledArea
except ImportError as error:
    raise ImportError("a view in a browser or a notebook needs trame. Cure: pip install trame trame-vuetify trame-rca"
                      ) from error
from vtkmodules.vtkIOImage import vtkJPEGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

from ._touch import apply_preset
from ._trame import HIDDEN, on_hidden
from ._webdoor import door_of, page_now
from .vtkVolumeHaptics import vtkHapticProperty, vtkVolumeHapticsFilter

if TYPE_CHECKING:
    from ._plotting import Haptics

SILENCE = 3.0  # s in which the leading page may leave questions unanswered before the touch ends
# number of unanswered questions, sent once a second, after which a page counts as closed; it may reconnect
UNANSWERED = 5
QUALITY = 85  # JPEG quality
MOST_PIXELS = 1.6e6  # largest number of pixels of a picture; the browser enlarges it for a finer display
MOST_WIDE = 8192  # largest accepted width and height of a page (pixels), above those of any display
WAITING = 3  # largest number of pictures in transit before the next one has to wait
# Keys whose browser names differ from the X11 names that vtkInteractorStyleHaptic.SetKey() uses.
KEYS = {" ": "space", "+": "plus", "-": "minus", ",": "comma", ".": "period", "?": "question", "Enter": "Return",
        "Backspace": "BackSpace", "ArrowLeft": "Left", "ArrowRight": "Right", "ArrowUp": "Up", "ArrowDown": "Down"}
QUITTING = ("e", "q")  # keys of vtkInteractorStyle that would end the server's event loop
EVENTS = {f"{button}Button{what}": f"{button}Button{what}Event"
          for button in ("Left", "Middle", "Right") for what in ("Press", "Release")}

_numbers = itertools.count(1)


def _number(words: Any, word: str, otherwise: float) -> float:
    """Returns a number in a page's message. The message may contain anything."""
    value = words.get(word) if isinstance(words, dict) else None
    # False for NaN, too
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e9
    return float(value) if is_number else otherwise


class Area(AreaAdapter):
    """Receives trame-rca's calls (the page's size and mouse events) and passes them to the view."""

    def __init__(self, name: str, view: View) -> None:
        super().__init__(name)
        self._view = weakref.ref(view)

    def update_size(self, _origin: str, size: dict[str, float]) -> None:
        width, height, ratio = (_number(size, word, 0.0) for word in ("w", "h", "p"))
        if (view := self._view()) is not None and min(width, height, ratio) > 0.0:
            view.resize(min(width, MOST_WIDE), min(height, MOST_WIDE), ratio)

    def on_interaction(self, _origin: str, event: dict[str, Any]) -> None:
        if (view := self._view()) is not None and isinstance(event, dict) and isinstance(event.get("type"), str):
            view.handle(event)

    def is_late(self) -> bool:
        """Whether the network still has to send the last pictures."""
        return self.streamer is None or self.streamer.coreServer.network_monitor.pending > WAITING

    def reset(self) -> None:
        """Does nothing, because each picture is complete."""


class View:
    """The page of one touchable plotter.

    Its task calls the style like a window's timer. The style decides what is drawn and when; each of its frames is
    sent. Mouse motions during a frame count as one, as in a window.

    Several pages may show the plotter. The page that began the touch leads until the touch ends. Meanwhile other pages
    can only end the touch. If the leading page closes or does not answer, the touch ends, whatever other pages answer.

    Make this object before its server starts, because it closes the server to clients without the secret. get_address()
    includes the secret.
    """

    def __init__(self, haptics: Haptics, server: Any, page: str | None = None) -> None:
        """page: the page's name in the address; "main" is the page without a name. Default: a unique name."""
        plotter = haptics._plotter()
        if plotter is None or haptics.closed or plotter.render_window is None:
            raise ValueError("the plotter is closed. Cure: make a new one, and show it in the browser before show()")
        self.haptics = haptics
        self.plotter = plotter
        self.server = server
        self.window = plotter.render_window
        self.interactor = plotter.iren.interactor
        self.closed = False
        self.round_trip: float | None = None  # s
        self.rate = haptics.device.GetServoRate()  # Hz, measured once a second; initially the requested rate
        self.name = f"volumehaptics_{next(_numbers)}"
        self.page = page or self.name
        self.area = Area(self.name, self)
        self.leader: str | None = None  # the page that controls the hand
        self._door = door_of(server)
        self._sizes: dict[str | None, tuple[float, float, float]] = {}  # width, height and pixel ratio of each page
        self._heard: dict[str, int] = {}  # number of the last question that each page has answered
        self._move: tuple[dict[str, Any], str | None] | None = None
        self._owed = False
        self._drawing = False
        self._answered = time.monotonic()
        self._asked: dict[int, float] = {}
        self._shown: dict[str, Any] = {}
        self._preset: str | None = None
        self._task: asyncio.Task | None = None

        self.window.SetOffScreenRendering(1)
        self.interactor.EnableRenderOff()  # draw() also draws the frames that the style requests
        self._capture = vtkWindowToImageFilter()
        self._capture.SetInput(self.window)
        self._capture.ReadFrontBufferOff()
        self._capture.ShouldRerenderOff()
        self._writer = vtkJPEGWriter()
        self._writer.SetInputConnection(self._capture.GetOutputPort())
        self._writer.WriteToMemoryOn()
        self._writer.SetQuality(QUALITY)
        self._tag = self.interactor.AddObserver("RenderEvent", self.draw)
        haptics.style.AutoAdjustOffScreenOn()
        # Don't use F1 for help, because browsers open their own help with it.
        haptics.style.SetKey("Help", " ".join(key for key in haptics.style.GetKey("Help").split() if key != "F1"))
        for device in haptics._devices:
            device.SetAttentionTime(SILENCE)  # the force fades if the server hangs
        self.ui = self._make_page()
        controller = server.controller
        self._door.on_leave.append(self._leave_with)
        on_hidden(server, self._hide)
        controller.on_server_ready.add(self._begin)
        if server.running:
            self._begin()

    def get_address(self, host: str = "localhost", *words: str) -> str:
        """Returns the address to open in a browser, once the server runs."""
        return self._door.address(host, "" if self.page == "main" else self.page, *words)

    # -- control of the hand --

    def _may_lead(self, page: str | None) -> bool:
        """Whether a page may lead the hand, because no other page does. `page` None stands for the program, which
        always may."""
        return page is None or self.leader in (None, page)

    def _lead(self, page: str | None) -> None:
        """Makes a page the leader after its action, if the hand touches now and no other page leads."""
        if not self.haptics._holds:
            self.leader = None
        elif self.leader is None and page is not None:
            self.leader = page
            self._answered = time.monotonic()
            self._fit(page)

    def _leave_with(self, page: str) -> None:
        """Forgets a page that has closed. Ends the touch if that page led the hand."""
        self._sizes.pop(page, None)
        self._heard.pop(page, None)
        if page == self.leader:
            self._leave()

    def _hide(self) -> None:
        """Ends the touch if the page that led the hand is hidden."""
        if page_now() == self.leader:
            self._leave()

    # -- the page --

    def _key(self, word: str) -> str:
        """Makes a name in trame's state that is unique among the pages of a server."""
        return f"{self.name}_{word}"

    def _make_page(self) -> VAppLayout:
        state, style, touch = self.server.state, self.haptics.style, self.haptics.filter
        names, presets = (names_of(list_names()) for list_names in
                          (vtkVolumeHapticsFilter.GetMethodNames, vtkHapticProperty.GetPresetNames))
        methods = [name for name in names if name != "primitives" or touch.GetNumberOfModes()]
        self._methods, self._presets = methods, presets
        for word, value in {"touching": False, "method": touch.GetMethodName(), "preset": None, "status": "",
                            "ping": 0}.items():
            state[self._key(word)] = value
        state.change(self._key("method"))(lambda **now: self._set_method(now[self._key("method")]))
        state.change(self._key("preset"))(lambda **now: self._set_preset(now[self._key("preset")]))
        with VAppLayout(self.server, template_name=self.page) as page:
            client.ClientStateChange(value=self._key("ping"), change=(self._answer, f"[{self._key('ping')}]"))
            with v3.VAppBar(density="compact", flat=True, border=True):
                v3.VBtn(f"{{{{ {self._key('touching')} ? 'Let go' : 'Touch' }}}}", click=self.toggle_touch,
                        color=(f"{self._key('touching')} ? 'error' : 'primary'",), variant="flat", classes="mx-2",
                        data_id="touch", __properties=[("data_id", "data-id")])
                for word, label, items, width in (("method", "Method", methods, 190), ("preset", "Preset", presets, 210)):
                    v3.VSelect(v_model=(self._key(word), state[self._key(word)]), label=label, density="compact",
                               items=(self._key(f"{word}s"), items), hide_details=True, variant="outlined",
                               style=f"max-width: {width}px", classes="mx-1", data_id=word,
                               __properties=[("data_id", "data-id")])
                v3.VBtn("Keys", click=self.list_keys, variant="text", data_id="keys",
                        __properties=[("data_id", "data-id")])
                v3.VSpacer()
                html.Span(f"{{{{ {self._key('status')} }}}}", classes="text-caption mx-3 text-right", data_id="status",
                          __properties=[("data_id", "data-id")])
            with v3.VMain(style="height: 100vh"):
                # The focused element receives the keys: focus it when the pointer enters, as in a window.
                focus = "$event.currentTarget.querySelector('[tabindex]')?.focus()"
                with html.Div(style="width: 100%; height: 100%", mouseenter=focus, __events=["mouseenter"]):
                    RemoteControlledArea(name=self.name, send_mouse_move=True, event_throttle_ms=16,
                                         image_style=("{ width: '100%', height: '100%' }",))
        self._style_tag = style.AddObserver("ModifiedEvent", self._follow)
        return page

    def toggle_touch(self) -> None:
        """Begins or ends the touch by the button. The touch begins in the middle, because the pointer is on the button.
        """
        style = self.haptics.style
        if style.GetTouchMode():
            self._leave()
            return
        if self._may_lead(page_now()):
            width, height = self.window.GetSize()
            self.interactor.SetEventInformation(width // 2, height // 2, 0, 0)
            style.SetTouchMode(True)
            self._lead(page_now())

    def _set_method(self, name: str) -> None:
        now = self.haptics.filter.GetMethodName()
        if self.haptics.closed or name == now:
            return
        if not (name in self._methods and self._may_lead(page_now()) and self.haptics.filter.SetMethodByName(name)):
            self.server.state[self._key("method")] = now

    def _set_preset(self, name: str | None) -> None:
        if self.haptics.closed or name == self._preset:
            return
        # Accept only names in the list: ApplyPreset() also accepts files, so a page could otherwise open any file.
        felt = self.haptics.filter
        if (name in self._presets and self._may_lead(page_now())
                and apply_preset(felt.GetProperty(), name, felt.GetInputDataObject(0, 0))):
            self._preset = name
        else:
            self.server.state[self._key("preset")] = self._preset

    def _show(self, word: str, value: Any) -> None:
        """Sends a value to the page if it has changed."""
        if self._shown.get(word) != value:
            self._shown[word] = value
            with self.server.state as state:
                state[self._key(word)] = value

    def _follow(self, *_: object) -> None:
        """Updates the buttons and the text from the style, because keys change it, too."""
        if self.closed:
            return
        self._show("touching", bool(self.haptics.style.GetTouchMode()))
        self._show("method", self.haptics.filter.GetMethodName())
        text = f"The hand feels at {self.rate:.0f} Hz beside the server"
        if self.round_trip is not None:
            text += f"; the browser is {1000.0 * self.round_trip:.0f} ms away, for the eye alone"
        self._show("status", text)

    # -- pages without answers --

    def _leave(self) -> None:
        """Ends the touch."""
        self.leader = self._move = None
        if not self.haptics.closed:
            self.haptics.style.FadeOut()

    def _ask(self, number: int) -> None:
        for page, heard in list(self._heard.items()):
            if number - heard > UNANSWERED:
                self._door.drop(page)
        self._asked = {number: time.monotonic()}
        self._show("ping", number)

    def _answer(self, number: int) -> None:
        page = page_now()
        asked = self._asked.get(number) if isinstance(number, int) else None
        if asked is None:
            return
        if page is not None:
            self._heard[page] = number
        if self._may_lead(page):
            self._answered = time.monotonic()
            self.round_trip = self._answered - asked

    # -- pictures --

    def resize(self, width: float, height: float, ratio: float) -> None:
        """Sets the size of a page. The window gets the size of the leading page, or, if none leads, of the last page.
        """
        page = page_now()
        self._sizes[page] = width, height, ratio
        if self._may_lead(page):
            self._fit(page)

    def _fit(self, page: str | None) -> None:
        if page in self._sizes:
            width, height, ratio = self._sizes[page]
            scale = min(ratio, (MOST_PIXELS / (width * height)) ** 0.5)
            self.interactor.UpdateSize(*(min(max(10, int(scale * side)), MOST_WIDE) for side in (width, height)))
            self.draw()

    def draw(self, *_: object) -> None:
        """Draws a frame and sends it. If the network still has to send the last pictures, does this later."""
        if self.closed or self.haptics.closed or self._drawing:
            return
        self._owed = self.area.is_late()
        if self._owed:
            return
        self._drawing = True
        try:
            self.window.Render()
            self._capture.Modified()
            self._writer.Write()
            width, height = self.window.GetSize()
            meta = {"type": "image/jpeg", "codec": "", "w": width, "h": height, "st": int(1000 * time.time()),
                    "key": "key", "quality": QUALITY}
            self.area.push(bytes(memoryview(self._writer.GetResult())), meta)
        finally:
            self._drawing = False

    # -- mouse and keys --

    def handle(self, event: dict[str, Any]) -> None:
        if self.closed or self.haptics.closed:
            return
        page = page_now()
        if not self._may_lead(page):
            if event["type"].lower() == "keydown" and event.get("key") == "Escape":
                self._leave()
            return
        if event["type"] == "MouseMove":
            self._move = event, page
            return
        self._take_move()
        self._apply(event, page)

    def _take_move(self) -> None:
        move, self._move = self._move, None
        if move is not None and self._may_lead(move[1]):
            self._apply(*move)

    def _apply(self, event: dict[str, Any], page: str | None) -> None:
        kind, interactor = event["type"], self.interactor
        control, shift = (int(bool(event.get(key) or event.get(other)))
                          for key, other in (("ctrlKey", "controlKey"), ("shiftKey", "shiftKey")))
        if "x" in event and "y" in event:
            # The picture fills the page, whatever its own size.
            known = self._sizes.get(page, (0.0, 0.0, 1.0))
            place = []
            for side, (word, whole) in enumerate((("x", "w"), ("y", "h"))):
                pixels = self.window.GetSize()[side]
                share = _number(event, word, math.nan) / max(_number(event, whole, known[side]) or known[side], 1.0)
                if math.isnan(share):
                    return
                place.append(round(min(max(share, -1.0), 2.0) * pixels))  # a drag may leave the page
            interactor.SetEventInformation(*place, control, shift)
        if kind == "MouseMove":
            interactor.MouseMoveEvent()
        elif kind in EVENTS:
            interactor.InvokeEvent(EVENTS[kind])
        elif kind == "MouseWheel" and (turn := _number(event, "spinY", 0.0)):
            interactor.InvokeEvent("MouseWheelBackwardEvent" if turn > 0 else "MouseWheelForwardEvent")
        # the spelling depends on vtk.js's version
        elif kind.lower() in ("keydown", "keyup") and event.get("key") and isinstance(event["key"], str):
            key = event["key"]
            name = KEYS.get(key, key)
            interactor.SetKeyEventInformation(control, shift, key if len(key) == 1 and key.isascii() else "\0", 0, name)
            interactor.InvokeEvent("KeyPressEvent" if kind.lower() == "keydown" else "KeyReleaseEvent")
            if kind.lower() == "keydown" and len(key) == 1 and key not in QUITTING:
                interactor.InvokeEvent("CharEvent")
        self._lead(page)

    def list_keys(self) -> None:
        """Shows or hides the list of keys, by a button of the page. A key would not do, because before the touch the
        keys belong to the plotter."""
        if self._may_lead(page_now()):
            display = self.haptics.head_up_display
            display.SetHelpText(self.haptics.style.GetKeys())
            display.SetHelpVisibility(not display.GetHelpVisibility())
            self.interactor.Render()

    # -- the loop --

    def _begin(self, **_: object) -> None:
        if self._task is None and not self.closed:
            self.server.root_server.controller.rc_area_register(self.area)
            self._task = asyncio.get_running_loop().create_task(self._run())

    async def _run(self) -> None:
        haptics, number, asked, ticks = self.haptics, 0, time.monotonic() - 1.0, None
        while not self.closed and not haptics.closed:
            start = time.monotonic()
            self._take_move()
            haptics.style.DrawHaptics()
            if self._owed and not self.area.is_late():
                self.interactor.Render()
            if start - asked > 1.0:
                now = haptics.device.GetState().GetTick()
                if ticks is not None:
                    self.rate = (now - ticks) / (start - asked)
                ticks, asked, number = now, start, number + 1
                self._ask(number)
                self._follow()
            if not self.haptics._holds:
                self.leader = None
            elif (self.leader or haptics.style.GetTouchMode()) and start - self._answered > SILENCE:
                self._leave()
            await asyncio.sleep(max(0.001, start + 1.0 / haptics.style.GetDisplayRate() - time.monotonic()))

    def close(self) -> None:
        """Removes the plotter from the page. To show it again, call show()."""
        if self.closed:
            return
        self._leave()
        self.closed = True
        self.interactor.RemoveObserver(self._tag)
        self.haptics.style.RemoveObserver(self._style_tag)
        self._door.on_leave.remove(self._leave_with)
        self.server.root_server.controller[HIDDEN].discard(self._hide)
        self.server.controller.on_server_ready.discard(self._begin)
        if self._task is not None:
            self._task.cancel()


def names_of(texts: Any) -> list[str]:
    return [texts.GetValue(i) for i in range(texts.GetNumberOfValues())]
