# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
import wx
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderer
from vtkmodules.wx.wxVTKRenderWindowInteractor import wxVTKRenderWindowInteractor

app = wx.App()
frame = wx.Frame(None, title="host", size=(500, 500))
widget = wxVTKRenderWindowInteractor(frame, -1)
renderer = vtkRenderer()
renderer.AddVolume(make_volume(image))
widget.GetRenderWindow().AddRenderer(renderer)
widget.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
widget._Iren.AddObserver("CharEvent", lambda caller, _: hear(caller.GetKeyCode()), -1.0)
# code of Documentation/hosts.md
