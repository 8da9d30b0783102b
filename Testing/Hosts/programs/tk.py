# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
import tkinter

from vtkmodules.tk.vtkTkRenderWindowInteractor import vtkTkRenderWindowInteractor
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderer

root = tkinter.Tk()
root.title("host")
widget = vtkTkRenderWindowInteractor(root, width=500, height=500)
widget.pack(fill="both", expand=True)
renderer = vtkRenderer()
renderer.AddVolume(make_volume(image))
widget.GetRenderWindow().AddRenderer(renderer)
widget.GetRenderWindow().GetInteractor().SetInteractorStyle(vtkInteractorStyleTrackballCamera())
widget.GetRenderWindow().GetInteractor().AddObserver(
    "KeyPressEvent", lambda caller, _: hear(caller.GetKeySym()), -1.0)
# code of Documentation/hosts.md
