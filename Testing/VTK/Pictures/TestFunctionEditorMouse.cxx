// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tests that dragging and removing points with the mouse changes the function itself.
#include "EditorMouse.h"
#include "Factories.h"
#include "Rigs/EventCounter.h"

#include "vtkHapticProperty.h"

using namespace editortest;

int TestFunctionEditorMouse(int, char*[])
{
  vtkNew<vtkHapticProperty> property;
  vtkPiecewiseFunction* const stiffness = property->GetStiffness();
  stiffness->AddPoint(0.0, 0.0);
  stiffness->AddPoint(50.0, 400.0);
  stiffness->AddPoint(100.0, 1000.0);
  View view;
  Editor* const editor = view.Shown;
  editor->SetProperty(property);
  view.Window->Render();
  view.Check(editor->Contains(141, 31) && !editor->Contains(139, 31), "what the editor contains");

  const apitest::EventCounter interactions(editor, vtkCommand::InteractionEvent);

  vtkMTimeType before = property->GetMTime();
  view.Check(!view.Drag(Editor::LEFT_BUTTON, { 5, 5 }, { 9, 9 }), "events beside it are not taken");
  view.Check(property->GetMTime() == before, "and change nothing");
  view.Check(view.Drag(Editor::LEFT_BUTTON, view.At(50, 400), view.At(70, 800)), "a drag");
  view.Check(property->GetMTime() > before && interactions.Count > 0, "the property is modified");
  view.Check(
    stiffness->GetSize() == 3 && IsNode(stiffness, 1, 70, 800, 1.0, 20.0), "the point moved");
  before = property->GetMTime();
  const Place somewhere = view.At(20, 500);
  view.Check(editor->MouseMove(somewhere[0], somewhere[1]), "moves over it are taken");
  view.Check(property->GetMTime() == before, "and change nothing without a button");
  view.Window->Render();
  view.Drag(Editor::MIDDLE_BUTTON, view.At(70, 800), view.At(70, 800));
  view.Check(stiffness->GetSize() == 2, "the middle button removes");
  return view.Passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
