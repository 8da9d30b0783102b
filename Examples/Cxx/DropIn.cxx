// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// An ordinary VTK volume viewer, and the ten lines that make its volume touchable.
#include <vtkColorTransferFunction.h>
#include <vtkHapticDevice.h>
#include <vtkHapticProperty.h>
#include <vtkHapticRepresentation.h>
#include <vtkInteractorStyleHaptic.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeHapticsFilter.h>
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

  vtkNew<vtkVolumeHapticsFilter> touch;
  touch->SetInputConnection(head->GetOutputPort());
  touch->GetProperty()->ApplyPreset("CT contrast");
  vtkNew<vtkHapticDevice> device;
  device->SetVolumeHaptics(touch);
  device->Open("virtual"); // the mouse
  device->Start();
  vtkNew<vtkHapticRepresentation> hand;
  hand->SetDevice(device);
  renderer->AddViewProp(hand);
  vtkNew<vtkInteractorStyleHaptic> style; // press t with the pointer on the volume
  style->SetDevice(device);
  interactor->SetInteractorStyle(style);

  window->Render();
  interactor->Start();
}
