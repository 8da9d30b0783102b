// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Renders the editor below a view: the surface strength of a preset over the histogram of the head
// phantom, and beside it the materials of the preset's tissues.
#include "Factories.h"

#include "VTK/Scene/Editor/EditorProbe.h"

#include "vtkHapticFunctionEditor.h"
#include "vtkHapticProperty.h"
#include "vtkNew.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTestUtilities.h"
#include "vtkXMLImageDataReader.h"

int TestFunctionEditorDocked(int argc, char* argv[])
{
  vtkNew<vtkXMLImageDataReader> head;
  char* const file = vtkTestUtilities::GetArgOrEnvOrDefault("--volume", argc, argv, "", "");
  head->SetFileName(file);
  head->Update();
  delete[] file;

  vtkNew<vtkHapticProperty> property;
  property->ApplyPreset("CT contrast");
  property->SetTissueSurfaceStrength(5, 5.5);
  vtkNew<vtkHapticFunctionEditor> editor;
  editor->SetProperty(property);
  editor->SetInputData(head->GetOutput());
  editor->SetFunctionToSurfaceStrength();
  VolumeHaptics::EditorProbe::SelectTissue(editor, 5);
  editor->DockedOn();
  editor->SetDockShare(0.75);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.32, 0.34, 0.43);
  renderer->AddViewProp(editor);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(760, 400);
  window->AddRenderer(renderer);
  window->Render(); // lets the editor read the window's size
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}
