// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Makes the volume of a viewer with its own interactor style touchable, by the four lines for a
// vtkHapticWidget. Press t with the pointer on the volume.
#include <vtkColorTransferFunction.h>
#include <vtkHapticProperty.h>
#include <vtkHapticWidget.h>
#include <vtkInteractorStyleJoystickCamera.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLImageDataReader.h>

int main(int, char* argv[])
{
  vtkNew<vtkXMLImageDataReader> head;
  head->SetFileName(argv[1]); // Data/HeadPhantom.vti
  vtkNew<vtkVolume> volume;
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputConnection(head->GetOutputPort());
  volume->SetMapper(mapper);
  volume->GetProperty()->GetScalarOpacity()->AddSegment(-500.0, 0.0, 1000.0, 0.6);
  volume->GetProperty()->GetRGBTransferFunction()->AddRGBSegment(
    -500.0, 0.9, 0.6, 0.5, 1000.0, 1.0, 1.0, 0.9);
  volume->GetProperty()->ShadeOn();
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<vtkInteractorStyleJoystickCamera> own;
  interactor->SetInteractorStyle(own);

  vtkNew<vtkHapticWidget> widget;
  widget->SetInteractor(interactor);
  widget->GetProperty()->ApplyPreset("CT contrast");
  widget->On();

  renderer->ResetCamera();
  window->Render();
  interactor->Initialize();
  interactor->Start();
}
