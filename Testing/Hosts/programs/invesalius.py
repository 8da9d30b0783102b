# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Starts InVesalius with the lines of the page as a user's plug-in, which the menu loads."""

import json
import os
import runpy
import sys
from pathlib import Path

import nibabel
import numpy
import wx

plugin = Path(os.environ["XDG_CONFIG_HOME"]) / "invesalius" / "plugins" / "touch"
plugin.mkdir(parents=True)
(plugin / "plugin.json").write_text(json.dumps({"name": "touch", "description": "Touch the volume"}))
(plugin / "__init__.py").touch()
(plugin / "main.py").write_text(page)
(plugin.parents[1] / "config.json").write_text(json.dumps({
    "session": {"mode": 0, "status": 3, "debug": False, "language": "en", "random_id": 1, "surface_interpolation": 1,
                "rendering": 0, "slice_interpolation": 0, "auto_reload_preview": False},
    "project": {"recent_projects": []}, "paths": {"homedir": str(plugin), "last_dicom_folder": ""}}))
wx.Log.EnableLogging(False)  # hides the window which says that a language's locale is missing
sys.path[:0] = ["/usr/share/invesalius", "/usr/lib/invesalius"]
sys.argv = ["invesalius3"]
os.environ["INVESALIUS_LIBRARY_PATH"] = "/usr/share/invesalius/"
os.chdir("/usr/share/invesalius")

# Write a volume in Hounsfield units: air around a ball of bone, with a surface as sharp as in a scan.
values = numpy.asarray(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1]).T
file = str(plugin / "ball.nii")
hounsfield = values if is_scan else numpy.clip(10.0 * values, -1000.0, 1000.0)
nibabel.save(nibabel.Nifti1Image(hounsfield.astype(numpy.int16), numpy.diag([*image.GetSpacing(), 1.0])), file)


def begin():
    from invesalius import session
    from invesalius.pubsub import pub

    main = wx.GetApp().GetTopWindow()
    if main is None or not main.IsShown():
        return wx.CallLater(200, begin)
    pub.sendMessage("Open other files", filepath=file)
    pub.sendMessage("Load raycasting preset", preset_name="Bone + Skin")
    session.Session().project_status = 1  # counts as saved, so that InVesalius asks nothing at its end
    pub.sendMessage("Load plugin", plugin_name="touch")
    widget = sys.modules["touch.main"].widget
    widget.GetInteractor().AddObserver("CharEvent", lambda caller, _: hear(caller.GetKeyCode()), -1.0)
    main.SetTitle("host")
    probe.watch_widget(widget)


# Switch to one of InVesalius's own tools, which replaces the interactor style.
change_style = """from invesalius import constants
from invesalius.pubsub import pub
pub.sendMessage("Enable style", style=constants.STATE_ZOOM)"""
main_loop = wx.App.MainLoop


def begin_and_loop(app):
    wx.CallLater(2000, begin)
    return main_loop(app)


wx.App.MainLoop = begin_and_loop
runpy.run_path("app.py", run_name="__main__")
