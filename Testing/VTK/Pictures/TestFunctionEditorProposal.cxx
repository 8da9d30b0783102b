// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Renders the functions that are proposed for the head phantom: dashed, over its edges, beside
// those of a preset. The test accepts and discards the proposal.
#include "Factories.h"
#include "Rigs/EventCounter.h"

#include "VTK/Scene/Editor/EditorProbe.h"

#include "vtkDataArray.h"
#include "vtkHapticFunctionEditor.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkImageShiftScale.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkTestUtilities.h"
#include "vtkXMLImageDataReader.h"

namespace
{
bool Check(bool holds, const char* what)
{
  if (!holds)
  {
    cerr << "failed: " << what << "\n";
  }
  return holds;
}
} // namespace

int TestFunctionEditorProposal(int argc, char* argv[])
{
  vtkNew<vtkXMLImageDataReader> head;
  char* const file = vtkTestUtilities::GetArgOrEnvOrDefault("--volume", argc, argv, "", "");
  head->SetFileName(file);
  head->Update();
  delete[] file;

  vtkNew<vtkHapticProperty> property;
  property->ApplyPreset("CT contrast");
  vtkPiecewiseFunction* const strength = property->GetSurfaceStrength();
  const int points = strength->GetSize();
  vtkNew<vtkHapticFunctionEditor> editor;
  editor->SetProperty(property);
  editor->SetInputData(head->GetOutput());
  editor->SetFunctionToSurfaceStrength();
  editor->SetRectangle(5, 5, 400, 280);
  const apitest::EventCounter edits(editor, vtkCommand::InteractionEvent);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.32, 0.34, 0.43);
  renderer->AddViewProp(editor);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(410, 290);
  window->AddRenderer(renderer);

  bool passed = Check(!editor->HasProposal() && !editor->TakeProposal() && !editor->DropProposal(),
    "no proposal at first");
  // Discarding a proposal must change nothing.
  passed &= Check(editor->Propose() && editor->HasProposal(), "the phantom proposes functions");
  window->Render();
  passed &= Check(editor->DropProposal() && !editor->HasProposal(), "a proposal is dropped");
  window->Render();
  passed &=
    Check(strength->GetSize() == points && !property->GetProposedBoundaries() && edits.Count == 0,
      "a proposal changes nothing until it is taken");
  passed &= Check(editor->Propose(), "again");
  window->Render();
  const int picture = vtkRegressionTestImage(window);
  passed &=
    Check(editor->TakeProposal() && !editor->HasProposal() && edits.Count == 1, "it is taken");
  passed &= Check(strength == property->GetSurfaceStrength() &&
      strength->GetValue(-1000.0) == 0.0 && strength->GetValue(1500.0) == 12.0 &&
      property->GetProposedBoundaries() && property->GetProposedKernelRadius() >= 2,
    "the property has the proposal");
  window->Render();
  // After a proposal is accepted, its points can be dragged like other points.
  double place[2];
  const double height = strength->GetValue(1500.0);
  VolumeHaptics::EditorProbe::GetPosition(
    editor, property->GetSurfaceStrength()->GetRange()[1], height, place);
  const int x = static_cast<int>(place[0] + 0.5);
  const int y = static_cast<int>(place[1] + 0.5);
  editor->ButtonPress(vtkHapticFunctionEditor::LEFT_BUTTON, x, y);
  editor->MouseMove(x, y - 30);
  editor->ButtonRelease(vtkHapticFunctionEditor::LEFT_BUTTON, x, y - 30);
  passed &= Check(strength->GetValue(3000.0) < height - 0.5, "a point of it is dragged");
  // Accepting a proposal during a drag ends the drag's undo step, and is a separate undo step.
  const double before = strength->GetValue(3000.0);
  passed &= Check(editor->Propose(), "a proposal during a drag");
  window->Render();
  editor->ButtonPress(vtkHapticFunctionEditor::LEFT_BUTTON, x, y - 30);
  editor->MouseMove(x, y - 60);
  const double dragged = strength->GetValue(3000.0);
  passed &= Check(dragged < before - 0.5 && editor->TakeProposal(), "is taken");
  editor->ButtonRelease(vtkHapticFunctionEditor::LEFT_BUTTON, x, y - 60);
  passed &= Check(strength->GetValue(3000.0) != dragged, "and changes what was dragged");
  passed &=
    Check(editor->Undo() && strength->GetValue(3000.0) == dragged, "the proposal is undone");
  passed &= Check(editor->Undo() && strength->GetValue(3000.0) == before, "then the drag");

  // A head whose stored values are higher by 1024 must result in the same image, because the axis
  // is in Hounsfield units.
  vtkNew<vtkImageShiftScale> stored;
  stored->SetInputConnection(head->GetOutputPort());
  stored->SetShift(1024.0);
  stored->SetOutputScalarTypeToUnsignedShort();
  stored->Update();
  stored->GetOutput()->GetPointData()->GetScalars()->SetName(
    head->GetOutput()->GetPointData()->GetScalars()->GetName());
  vtkNew<vtkHapticProperty> shifted;
  shifted->ApplyPreset("CT contrast");
  shifted->SetScalarShift(-1024.0);
  editor->SetProperty(shifted);
  editor->SetInputData(stored->GetOutput());
  passed &= Check(editor->Propose(), "one of a head that is stored higher");
  window->Render();
  // The tolerance allows for a different phase of the dashed lines.
  const int same = vtkRegressionTestImageThreshold(window, 25.0);
  passed &= Check(editor->TakeProposal() && shifted->GetScalarShift() == -1024.0 &&
      shifted->GetSurfaceStrength()->GetValue(-1000.0) == 0.0 &&
      shifted->GetSurfaceStrength()->GetValue(1500.0) == 12.0,
    "is of Hounsfield units, too");
  return passed && picture == vtkTesting::PASSED && same == vtkTesting::PASSED ? EXIT_SUCCESS
                                                                               : EXIT_FAILURE;
}
