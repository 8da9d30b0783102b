// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tests special cases of each function: values beyond the axis, no points, or no function.
#include "EditorMouse.h"
#include "Factories.h"

#include "vtkHapticProperty.h"
#include "vtkVolumeProperty.h"

using namespace editortest;

int TestFunctionEditorFunctions(int, char*[])
{
  vtkNew<vtkHapticProperty> property;
  vtkPiecewiseFunction* const strength = property->GetSurfaceStrength();
  strength->AddPoint(0.0, 0.0);
  strength->AddPoint(50.0, 1e6);
  strength->AddPoint(100.0, 10.0);
  vtkNew<vtkVolumeProperty> visible;
  visible->GetScalarOpacity()->RemoveAllPoints();
  visible->GetScalarOpacity()->AddPoint(0.0, 0.0);
  visible->GetScalarOpacity()->AddPoint(100.0, 1.0);
  View view;
  Editor* const editor = view.Shown;
  view.Window->Render(); // draws without a function to edit
  editor->SetProperty(property);

  // An impenetrable surface must keep its value unless the user drags its point down.
  editor->SetFunctionToSurfaceStrength();
  view.Window->Render();
  const Place top = view.At(60, 1e6);
  view.Drag(Editor::LEFT_BUTTON, view.At(50, 12), { top[0], 229 });
  view.Check(IsNode(strength, 1, 60, 1e6, 1.0, 0.0), "a value beyond the axis stays");

  // Displaying an empty function must not add a point; only the first click does.
  vtkPiecewiseFunction* const friction = property->GetFriction();
  editor->SetFunctionToFriction();
  view.Window->Render();
  view.Check(friction->GetSize() == 0, "looking changes nothing");
  view.Drag(Editor::LEFT_BUTTON, view.At(0.5, 0.5), view.At(0.5, 0.5));
  view.Check(friction->GetSize() == 3 && IsNode(friction, 0, 0, 0, 1e-9, 1e-9) &&
      IsNode(friction, 1, 0.5, 0.5, 0.02, 0.02),
    "the first point brings the default along");

  // A stiffness that increases from 0 near a drag must cause a warning, because noise mixes both
  // values.
  editor->SetFunctionToStiffness();
  view.Check(editor->GetWarning().empty(), "500 N/m and no drag");
  property->GetViscosity()->AddPoint(0.0, 0.0);
  property->GetViscosity()->AddPoint(100.0, 0.5);
  view.Check(editor->GetWarning().empty(), "500 N/m and a drag of 0.5 N: 1 mm");
  property->GetStiffness()->AddPoint(20.0, 0.0);
  property->GetStiffness()->AddPoint(30.0, 400.0);
  view.Check(editor->GetWarning() == "too soft for its drag at 20", "a drag on 0 N/m");
  editor->SetFunctionToViscosity();
  view.Check(
    editor->GetWarning() == "too soft for its drag at 20", "the drag's page tells it, too");
  editor->SetFunctionToFriction();
  view.Check(editor->GetWarning().empty(), "friction has nothing to do with it");
  property->GetStiffness()->AddPoint(20.0, 30.0);
  editor->SetFunctionToStiffness();
  view.Check(editor->GetWarning().empty(), "0.15 N on 30 N/m: 5 mm");
  for (const char* const preset :
    { "CT contrast", "CT physical", "CT angiography", "CT chest", "MRI", "Micro-CT", "Labels" })
  {
    property->ApplyPreset(preset);
    view.Check(editor->GetWarning().empty(), preset);
  }
  property->RemoveAllTissues();
  friction->RemoveAllPoints();

  // At first, the opacity has no function to edit.
  editor->SetFunctionToOpacity();
  view.Window->Render();
  view.Check(editor->ButtonPress(Editor::LEFT_BUTTON, 200, 100) &&
      editor->ButtonRelease(Editor::LEFT_BUTTON, 200, 100),
    "an editor without a function");
  editor->SetVolumeProperty(visible);
  view.Window->Render();
  const vtkMTimeType before = visible->GetMTime();
  view.Drag(Editor::LEFT_BUTTON, view.At(0, 0), view.At(0, 0.5));
  view.Check(
    visible->GetMTime() > before && IsNode(visible->GetScalarOpacity(), 0, 0, 0.5, 0.0, 0.02),
    "the opacity changes");
  editor->NextFunction();
  view.Check(
    editor->GetPiecewiseFunction() == property->GetStiffness(), "after the last comes the first");
  return view.Passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
