// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Renders the editor over a view: the stiffness of a preset, with a ramp from air, over the
// histogram of the head phantom.
#include "Factories.h"

#include "vtkHapticFunctionEditor.h"
#include "vtkHapticProperty.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTestUtilities.h"
#include "vtkXMLImageDataReader.h"

int TestFunctionEditor(int argc, char* argv[])
{
  vtkNew<vtkXMLImageDataReader> head;
  char* const file = vtkTestUtilities::GetArgOrEnvOrDefault("--volume", argc, argv, "", "");
  head->SetFileName(file);
  head->Update();
  delete[] file;

  vtkNew<vtkHapticProperty> property;
  property->ApplyPreset("CT contrast");
  property->GetStiffness()->AddPoint(-1024.0, 0.0);
  property->GetStiffness()->AddPoint(-955.0, 0.0);
  property->GetViscosity()->RemoveAllPoints(); // a drag on the ramp would cause a warning
  vtkNew<vtkHapticFunctionEditor> editor;
  editor->SetProperty(property);
  editor->SetInputData(head->GetOutput());
  editor->SetRectangle(5, 5, 300, 200);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.32, 0.34, 0.43);
  renderer->AddViewProp(editor);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(310, 210);
  window->AddRenderer(renderer);
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}
