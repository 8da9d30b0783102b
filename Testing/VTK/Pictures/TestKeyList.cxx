// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders the list of keys over the head-up display, in two columns, with keys of the application.
#include "Factories.h"

#include "vtkHapticDevice.h"
#include "vtkHapticFunctionEditor.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkInteractorStyleHaptic.h"

#include "vtkNew.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

int TestKeyList(int argc, char* argv[])
{
  vtkNew<vtkHapticDevice> device;
  device->Open("virtual");
  vtkNew<vtkHapticHeadUpDisplay> display;
  display->SetDevice(device);
  vtkNew<vtkHapticFunctionEditor> editor;
  vtkNew<vtkInteractorStyleHaptic> style;
  style->SetDevice(device);
  style->SetHeadUpDisplay(display);
  style->SetFunctionEditor(editor);
  style->SetApplicationKeys("Window\n3\tstereo\nq\tclose\n");
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.24, 0.29, 0.36);
  renderer->AddViewProp(display);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(520, 360);
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(style);
  interactor->SetKeySym("question");
  interactor->InvokeEvent(vtkCommand::KeyPressEvent);
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}
