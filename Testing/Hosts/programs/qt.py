# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
from PySide6.QtWidgets import QApplication, QMainWindow
from vtkmodules.qt.QVTKRenderWindowInteractor import QVTKRenderWindowInteractor
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderer

app = QApplication([])


def open_window():
    frame = QMainWindow()
    frame.setWindowTitle("host")
    widget = QVTKRenderWindowInteractor(frame)
    frame.setCentralWidget(widget)
    frame.resize(500, 500)
    renderer = vtkRenderer()
    renderer.AddVolume(make_volume(image))
    widget.GetRenderWindow().AddRenderer(renderer)
    interactor = widget.GetRenderWindow().GetInteractor()
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    interactor.AddObserver("KeyPressEvent", lambda caller, _: hear(caller.GetKeySym()), -1.0)
    return frame, widget


frame, widget = open_window()
app.setQuitOnLastWindowClosed(False)
again = "frame, widget = open_window()\n" + page.replace("app.exec()", "app.setQuitOnLastWindowClosed(True)")
# code of Documentation/hosts.md
