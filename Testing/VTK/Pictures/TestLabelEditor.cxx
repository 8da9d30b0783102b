// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Renders the editor's list of 89 labels with colours and names, scrolled to the label whose
// material is edited; the label overrides two quantities.
#include "Factories.h"

#include "vtkHapticFunctionEditor.h"
#include "vtkHapticLabelTable.h"
#include "vtkNew.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <cmath>
#include <string>

int TestLabelEditor(int argc, char* argv[])
{
  vtkNew<vtkHapticLabelTable> table;
  for (int label = 1; label <= 89; ++label)
  {
    table->SetLabelName(label, "structure " + std::to_string(label));
    table->SetColor(label, 0.5 + 0.5 * std::sin(label), 0.5 + 0.5 * std::sin(1.7 * label + 1.0),
      0.5 + 0.5 * std::sin(2.3 * label + 2.0));
  }
  table->SetLabelName(40,
    "pr\xC3\xA9"
    "cord \xC3\xA0 droite, derri\xC3\xA8re le foie"); // is shortened
  table->SetLabelName(41, "Kr\xC3\xB6pfchen");
  table->SetStiffness(42, 300.0);
  // an unusually high value, which extends the slider's range
  table->SetSurfaceStrength(42, 7.5);
  table->SetFelt(41, false);
  table->SetForbidden(43, true);

  vtkNew<vtkHapticFunctionEditor> editor;
  editor->SetLabelTable(table);
  editor->SetFunctionToLabels();
  editor->SetRectangle(5, 5, 260, 300);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.32, 0.34, 0.43);
  renderer->AddViewProp(editor);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(270, 310);
  window->AddRenderer(renderer);
  window->Render();
  if (!editor->SelectLabel(42))
  {
    cerr << "failed: label 42 is not listed\n";
    return EXIT_FAILURE;
  }
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}
