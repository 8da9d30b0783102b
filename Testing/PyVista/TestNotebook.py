# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plots of a notebook that have nothing to do with touch show the same as in PyVista without this package."""

import sys

import numpy as np
import pytest

pv = pytest.importorskip("pyvista", reason="needs PyVista: pip install pyvista")
if not hasattr(pv, "register_jupyter_backend"):
    pytest.skip("PyVista has back ends of other packages from 0.48 on", allow_module_level=True)
from volumehaptics.pyvista import show_in_notebook  # noqa: E402

pytestmark = pytest.mark.filterwarnings("ignore:Using static image")  # PyVista's advice to install trame


def plot(**settings):
    """Plots as pv.Sphere().plot() does in a cell."""
    plotter = pv.Plotter(notebook=True, window_size=(120, 120))
    plotter.add_mesh(pv.Sphere())
    return plotter.show(return_viewer=True, **settings)


@pytest.fixture
def registry():
    """Restores PyVista's list of back ends after the test."""
    import pyvista.jupyter as jupyter

    pv.registered_jupyter_backends()
    kept = [dict(one) for one in (jupyter._custom_backends, jupyter._custom_backend_sources)]
    yield jupyter
    for one, before in zip((jupyter._custom_backends, jupyter._custom_backend_sources), kept):
        one.clear()
        one.update(before)


def test_it_is_registered_once(registry):
    mine = [one for one in pv.registered_jupyter_backends() if one.name == "haptics"]
    assert [one.handler for one in mine] == [show_in_notebook]


@pytest.mark.parametrize("without_trame", [False, True])
def test_an_ordinary_plot_is_what_it_is_without_this_package(window, registry, monkeypatch, without_trame):
    if without_trame:
        monkeypatch.setitem(sys.modules, "trame", None)
        monkeypatch.delitem(sys.modules, "volumehaptics.web", raising=False)
    shown = plot()
    registry._custom_backends.pop("haptics")
    registry._custom_backend_sources.pop("haptics")
    alone = plot()
    assert type(shown) is type(alone)
    if hasattr(alone, "size"):
        assert np.array_equal(np.asarray(shown), np.asarray(alone))


@pytest.mark.parametrize(("others", "first"), [
    ({"server": "a_package:handler", "trame": "a_package:other"}, "trame"),  # entry points
    ({"server": "a_package:handler"}, "server"),
    ({"trame": "a_package:handler", "mine": "a_module.function"}, "mine"),  # a program's own
])
def test_others_are_asked_in_the_order_of_pyvista(window, registry, others, first):
    asked = []
    for name, source in others.items():
        registry._custom_backends[name] = lambda plotter, name=name, **_: asked.append(name) or name
        registry._custom_backend_sources[name] = source
    plot()
    plot(jupyter_backend="haptics")
    registry._custom_backends.pop("haptics")
    registry._custom_backend_sources.pop("haptics")
    plot()
    assert asked == [first] * 3


def test_a_touchable_plot_is_shown_to_be_touched(window, hands, monkeypatch):
    web = pytest.importorskip("volumehaptics.web", reason="needs trame")
    shown = []
    monkeypatch.setattr(web, "show_plotter", lambda plotter, **_: shown.append(plotter))
    plotter = hands().plotter
    show_in_notebook(plotter, screenshot=None)
    assert shown == [plotter]
