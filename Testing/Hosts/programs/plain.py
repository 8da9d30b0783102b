# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkInteractionWidgets import vtkSliderRepresentation2D, vtkSliderWidget
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor

renderer = vtkRenderer()
renderer.AddVolume(make_volume(image))
window = vtkRenderWindow()
window.SetSize(500, 500)
window.SetWindowName("host")
window.AddRenderer(renderer)
interactor = vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
interactor.AddObserver("KeyPressEvent", lambda *_: hear(interactor.GetKeySym()), -1.0)
bar = vtkSliderRepresentation2D()
bar.GetPoint1Coordinate().SetCoordinateSystemToNormalizedDisplay()
bar.GetPoint1Coordinate().SetValue(0.3, 0.1)
bar.GetPoint2Coordinate().SetCoordinateSystemToNormalizedDisplay()
bar.GetPoint2Coordinate().SetValue(0.7, 0.1)
slider = vtkSliderWidget()
slider.SetInteractor(interactor)
slider.SetRepresentation(bar)
slider.On()
said = []
slider.AddObserver("InteractionEvent", lambda *_: said.append(bar.GetValue()))
drag = ((0.32, 0.1), (0.5, 0.1))
# code of Documentation/hosts.md
