# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
from PySide6.QtGui import QShortcut
from PySide6.QtWidgets import QApplication, QMainWindow, QSlider, QVBoxLayout, QWidget
from vtkmodules.qt.QVTKRenderWindowInteractor import QVTKRenderWindowInteractor
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderer

app = QApplication([])
frame = QMainWindow()
frame.setWindowTitle("host")
widget = QVTKRenderWindowInteractor(frame)
frame.setCentralWidget(widget)
frame.resize(500, 500)
renderer = vtkRenderer()
renderer.AddVolume(make_volume(image))
widget.GetRenderWindow().AddRenderer(renderer)
widget.GetRenderWindow().GetInteractor().SetInteractorStyle(vtkInteractorStyleTrackballCamera())
widget.GetRenderWindow().GetInteractor().AddObserver(
    "KeyPressEvent", lambda caller, _: hear(caller.GetKeySym()), -1.0)
# the lines of the page
