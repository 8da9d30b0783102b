# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the blocks of Documentation/python.md on PyVista, and those of notebook.md, as printed, one after the other."""

import asyncio
import re

import numpy as np
import pytest
import pyvista as pv


def blocks(root, page, heading=""):
    text = (root / "Documentation" / page).read_text(encoding="utf-8")
    section = text.split(f"\n## {heading}\n")[1].split("\n## ")[0] if heading else text
    return [compile(code, page, "exec") for code in re.findall(r"```python\n(.*?)```", section, re.DOTALL)]


@pytest.fixture(scope="module")
def names(root):
    """Returns the variables that the first block leaves: a head in a plotter that can be touched. Windows are off
    screen and stay open."""
    show, made = pv.Plotter.show, {}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(pv, "OFF_SCREEN", True)
        patch.setattr(pv.global_theme, "window_size", [300, 240])  # small windows are drawn quickly
        patch.setattr(pv.Plotter, "show", lambda plotter, **settings: show(plotter, **{"auto_close": False, **settings}))
        exec(blocks(root, "python.md", "PyVista")[0], made)
        yield made
        made["haptics"].close()
        made["plotter"].close()


def test_a_path_is_felt_and_drawn(window, root, names, monkeypatch):
    first, path, _ = blocks(root, "python.md", "PyVista")
    drawn = []
    monkeypatch.setattr(pv.PolyData, "plot", lambda trace, **settings: drawn.append((trace, settings)))
    exec(path, names)
    trace = names["trace"]
    assert isinstance(trace, pv.PolyData) and trace.n_points == 501
    assert 0.5 < np.linalg.norm(trace["Force"], axis=1).max() < 10.0
    assert drawn == [(trace, {"scalars": "Force", "line_width": 5})]
    monkeypatch.undo()
    trace.plot(**drawn[0][1], off_screen=True)  # PyVista takes these


def test_two_volumes_are_felt(window, root, names):
    *_, two = blocks(root, "python.md", "PyVista")
    names["haptics"].close()  # the block makes a new one
    scan = names["head"].copy()
    scan.origin = [start + 250.0 * (axis == 0) for axis, start in enumerate(scan.origin)]
    names["ct_actor"], names["mri_actor"] = names["skin"], names["plotter"].add_volume(scan, show_scalar_bar=False)
    exec(two, names)
    style = names["haptics"].style
    assert style.GetNumberOfTouchedVolumes() == 2
    assert names["mri_filter"].GetProperty().GetSurfaceStrength().GetSize() > 0


def test_a_notebook_shows_a_frame(window, root, names, monkeypatch):
    pytest.importorskip("trame", reason="pip install trame trame-vuetify trame-rca")
    pytest.importorskip("nest_asyncio2", reason="pip install nest_asyncio2")
    if not hasattr(pv, "registered_jupyter_backends"):
        pytest.skip("PyVista has backends of others for notebooks from 0.48 on")
    from volumehaptics import web

    (code,) = blocks(root, "notebook.md")
    frames = []
    show_plotter = web.show_plotter
    monkeypatch.setattr(web, "show_plotter", lambda *words, **settings: frames.append(show_plotter(*words, **settings)))
    names["haptics"].close()
    names["plotter"].notebook = True  # the value that PyVista sets in a notebook

    async def cell():
        exec(code, names)
        assert re.search(r'src="http://localhost:\d+/index.html', frames[0]._repr_html_())
        frames[0].view.close()
        await frames[0].view.server.stop()

    asyncio.run(cell())
