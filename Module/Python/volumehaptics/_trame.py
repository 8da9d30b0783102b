# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Drives the hand in a view of trame, whose server has no VTK timers, and ends the touch when a browser leaves or hides
the page."""

from __future__ import annotations

import asyncio
import importlib
import time
import weakref
from typing import Any, Callable
from urllib.parse import quote

PICTURES = 20.0  # largest number of pictures per second that are sent to the browser
HIDDEN = "volumehaptics_hidden"
_TELL = f"document.addEventListener('visibilitychange',()=>document.hidden&&window.trame.trigger('{HIDDEN}'))"
_PAGE = {"scripts": [f"data:text/javascript,{quote(_TELL)}"]}  # trame loads this once per server


def is_view(target: Any) -> bool:
    """Whether an object is a view of trame, such as VtkRemoteView, by its attributes."""
    server = getattr(target, "server", None)
    return hasattr(server, "add_protocol_to_configure") and callable(getattr(target, "update", None))


def window_of(view: Any) -> Any:
    """Returns the window that a view was made for. trame's classes store it in a private attribute."""
    return next((value for name, value in vars(view).items() if name.endswith("__view")), None)


def on_hidden(server: Any, call: Callable[[], None]) -> None:
    """Calls a function when a browser hides a page that was opened after this call, behind another tab or in a
    minimised window."""
    server = server.root_server
    server.enable_module(_PAGE)
    if not server.controller[HIDDEN].exists():
        server.trigger(HIDDEN)(server.controller[HIDDEN])
    server.controller[HIDDEN].add(call)


def drive(view: Any, haptics: Any) -> None:
    """Updates the haptics and the browser's picture once the server is ready. Removes the keys from the hint, because
    no keys arrive."""
    style, server = haptics.style, view.server
    actions = style.GetKeyActions()
    for action in map(actions.GetValue, range(actions.GetNumberOfValues())):
        style.SetKey(action, "")
    itself = weakref.ref(haptics)

    async def run() -> None:
        drawn = 0.0
        while (haptics := itself()) is not None and not haptics.closed:
            is_new = haptics.update()
            if is_new and haptics._holds and time.monotonic() - drawn > 1.0 / PICTURES:
                view.update()
                drawn = time.monotonic()
            pause = 1.0 / haptics.style.GetDisplayRate()
            del haptics  # so that the task does not keep the object alive
            await asyncio.sleep(pause)

    def let_go() -> None:
        haptics = itself()
        if haptics is not None and not haptics.closed:
            haptics.style.FadeOut()

    on_hidden(server, let_go)
    tasks = []  # asyncio itself keeps only weak references to tasks

    def start(**_: Any) -> None:
        tasks.append(asyncio.get_running_loop().create_task(run()))

    class Door(importlib.import_module("wslink.websocket").LinkProtocol):  # type: ignore[misc]
        """Detects that a browser is closed, or that its heartbeat has stopped."""

        def onClose(self, _client: str) -> None:  # noqa: N802 (wslink's name)
            let_go()

    if server.protocol is not None:
        server.protocol.registerLinkProtocol(Door())
        start()
    else:
        server.add_protocol_to_configure(lambda protocol: protocol.registerLinkProtocol(Door()))
        server.controller.on_server_ready.add(start)
