# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ends the touch when a widget of Qt is hidden, minimised or closed; VTK sends no event for this."""

from __future__ import annotations

import importlib
import weakref
from collections.abc import Callable
from typing import Any

# These packages provide the same classes.
_BINDINGS = ("PySide6", "PyQt6", "PyQt5", "PySide2")


def _binding_of(widget: Any) -> str | None:
    """Returns the name of the Qt package of a widget; None for other objects."""
    for kind in type(widget).__mro__:
        binding = kind.__module__.split(".")[0]
        if kind.__name__ == "QWidget" and binding in _BINDINGS:
            return binding
    return None


def watch_widget(widget: Any, let_go: Callable[[], None]) -> Callable[[], bool] | None:
    """Calls let_go whenever a widget of Qt or its window is no longer seen.

    Returns a function that ends the watch; None for other objects. The function keeps the watch alive, but not the
    widget, and returns False if Qt has deleted the widget.
    """
    binding = _binding_of(widget)
    if binding is None:
        return None
    core = importlib.import_module(f"{binding}.QtCore")
    kinds = getattr(core.QEvent, "Type", core.QEvent)
    hide, show, state, moved = kinds.Hide, kinds.Show, kinds.WindowStateChange, kinds.ParentChange

    class Watch(core.QObject):
        """Watches the widget and its window, because only the window itself gets an event when it is minimised."""

        def __init__(self) -> None:
            super().__init__()
            self.window: Callable[[], Any] = lambda: None

        def follow(self) -> None:
            window = widget_of().window()
            if window is not self.window():
                self.leave_window()
                self.window = weakref.ref(window)
                window.installEventFilter(self)

        def leave_window(self) -> None:
            window = self.window()
            if window is not None and window is not widget_of():
                _try(window.removeEventFilter, self)

        def eventFilter(self, watched: Any, event: Any) -> bool:  # noqa: N802 (Qt's name)
            kind = event.type()
            if kind == hide or (kind == state and watched.isWindow() and watched.isMinimized()):
                let_go()
            elif kind in (show, moved) and watched is widget_of():
                self.follow()
            return False

    widget_of = weakref.ref(widget)
    watch = Watch()
    widget.installEventFilter(watch)
    watch.follow()

    def end() -> bool:
        watched = widget_of()
        if watched is None:
            return False
        watch.leave_window()
        return _try(watched.removeEventFilter, watch)

    return end


def _try(function: Callable[[Any], None], argument: Any) -> bool:
    """Calls a function of an object. Returns False if Qt has already deleted the object."""
    try:
        function(argument)
    except RuntimeError:
        return False
    return True
