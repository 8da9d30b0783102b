// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Drags axes, undoes edits, moves sliders of tissues, and docks the editor beside the scene, with
// and without slices.
#include "EditorMouse.h"
#include "Factories.h"

#include "VTK/Scene/Editor/EditorProbe.h"

#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkHapticSliceView.h"

#include <algorithm>

using namespace editortest;

namespace
{
bool IsNear(double a, double b, double distance)
{
  return std::abs(a - b) <= distance;
}

void TestAxes(View& view, vtkHapticProperty* property)
{
  Editor* const editor = view.Shown;
  vtkPiecewiseFunction* const stiffness = property->GetStiffness();
  const vtkMTimeType before = property->GetMTime();
  const Place low = view.At(0, 0);
  const Place high = view.At(100, 1000);
  const int width = high[0] - low[0];
  // Drag the axis of values by a quarter of its width; the points must move with it.
  view.Drag(
    Editor::LEFT_BUTTON, { low[0] + 40, low[1] - 12 }, { low[0] + 40 + width / 4, low[1] - 12 });
  view.Window->Render();
  view.Check(IsNear(view.At(0, 0)[0], low[0] + width / 4, 2), "the axis of values is dragged");
  view.Check(IsNear(view.At(50, 400)[0], low[0] + width / 4 + width / 2, 2), "with the points");
  // The wheel scales the axis around the value under the mouse, which must stay in place.
  const Place middle = view.At(40, 300);
  view.Check(editor->TurnWheel(2.0, middle[0], middle[1]), "the wheel");
  view.Window->Render();
  view.Check(IsNear(view.At(40, 300)[0], middle[0], 2), "what is under the mouse stays");
  view.Check(IsNear(view.At(50, 0)[0] - view.At(40, 0)[0], 0.1 * width * 1.25 * 1.25, 2),
    "a step stretches by a quarter");
  // A drag of the function's axis moves the value under the mouse, so the function must become
  // twice as high.
  const int up = view.At(40, 200)[1] - low[1];
  view.Drag(
    Editor::LEFT_BUTTON, { low[0] - 15, (low[1] + high[1]) / 2 }, { low[0] - 15, high[1] - 1 });
  view.Window->Render();
  view.Check(IsNear(view.At(40, 200)[1] - low[1], 2.0 * up, 3), "the axis of the function");
  view.Check(property->GetMTime() == before, "all of that edits nothing");
  view.Check(!editor->Undo(), "and is no step to undo");
  // Drag a point from its present display position.
  view.Drag(Editor::LEFT_BUTTON, view.At(50, 400), view.At(55, 300));
  view.Check(IsNode(stiffness, 1, 55, 300, 1.0, 20.0), "a drag in a part of the axes");
  view.Check(editor->Undo() && IsNode(stiffness, 1, 50, 400, 0.0, 0.0), "is undone to the bit");
  // Double clicks on the axes must show all points again.
  for (const Place& axis : { Place{ low[0] + 40, low[1] - 12 }, Place{ low[0] - 15, low[1] + 30 } })
  {
    editor->DoubleClick(Editor::LEFT_BUTTON, axis[0], axis[1]);
    editor->ButtonRelease(Editor::LEFT_BUTTON, axis[0], axis[1]);
    view.Window->Render();
  }
  const Place last = view.At(100, 1000);
  view.Check(IsNear(view.At(0, 0)[0], low[0], 2) && IsNear(last[0], high[0], 2) &&
      IsNear(last[1], high[1], 2),
    "a double click fits an axis again");
}

void TestHistory(View& view, vtkHapticProperty* property)
{
  Editor* const editor = view.Shown;
  vtkPiecewiseFunction* const stiffness = property->GetStiffness();
  view.Drag(Editor::LEFT_BUTTON, view.At(50, 400), view.At(70, 800));
  view.Drag(Editor::MIDDLE_BUTTON, view.At(70, 800), view.At(70, 800));
  view.Check(stiffness->GetSize() == 2, "moved, and removed");
  view.Check(editor->Undo() && IsNode(stiffness, 1, 70, 800, 1.0, 20.0), "the point is back");
  view.Check(editor->Undo() && IsNode(stiffness, 1, 50, 400, 0.0, 0.0), "where it was");
  view.Check(!editor->Undo(), "no more");
  view.Check(editor->Redo() && editor->Redo() && stiffness->GetSize() == 2, "done again");
  view.Check(!editor->Redo(), "no more of that");
  editor->SetFunctionToFriction();
  view.Window->Render();
  const Place at = view.At(0.5, 0.5);
  view.Drag(Editor::LEFT_BUTTON, at, at);
  view.Check(property->GetFriction()->GetSize() > 0, "another function");
  view.Check(editor->Reset() && stiffness->GetSize() == 3 &&
      IsNode(stiffness, 1, 50, 400, 0.0, 0.0) && property->GetFriction()->GetSize() == 0,
    "all functions as before the first edit");
  view.Check(editor->Undo() && stiffness->GetSize() == 2, "and back");
  editor->Reset();
  editor->SetFunctionToStiffness();
  view.Window->Render();
  const Place held = view.At(50, 400);
  editor->ButtonPress(Editor::LEFT_BUTTON, held[0], held[1]);
  view.Check(!editor->Undo() && !editor->Reset(), "not while a point is held");
  editor->ButtonRelease(Editor::LEFT_BUTTON, held[0], held[1]);
  vtkNew<vtkHapticProperty> other;
  editor->SetProperty(other);
  view.Check(!editor->Undo() && !editor->Redo(), "another property has no edits yet");
  editor->SetProperty(property);
}

void TestTissues(View& view, vtkHapticProperty* property)
{
  Editor* const editor = view.Shown;
  property->ApplyPreset("CT contrast");
  editor->SetFunctionToTissues();
  view.Window->Render();
  view.Check(editor->GetTitle() == "Materials of tissues" && !editor->GetPiecewiseFunction(),
    "a page of its own");
  double at[2];
  view.Check(VolumeHaptics::EditorProbe::GetTissuePosition(editor, 3, at), "fluid is listed");
  const Place fluid = { static_cast<int>(at[0]), static_cast<int>(at[1]) };
  const vtkMTimeType before = property->GetMTime();
  view.Drag(Editor::LEFT_BUTTON, fluid, fluid);
  view.Check(
    VolumeHaptics::EditorProbe::GetSelectedTissue(editor) == 3 && property->GetMTime() == before,
    "a click selects and changes nothing");
  view.Window->Render();
  view.Check(VolumeHaptics::EditorProbe::GetSliderPosition(editor, Editor::FRICTION, 0.8, at),
    "with sliders");
  const Place friction = { static_cast<int>(std::lround(at[0])),
    static_cast<int>(std::lround(at[1])) };
  view.Drag(Editor::LEFT_BUTTON, friction, friction);
  view.Check(IsNear(property->GetTissueFriction(3), 0.8, 0.011), "a slider");
  view.Check(property->GetTissueFriction(2) == 0.18 && property->GetTissueFriction(4) == 0.30,
    "and no other tissue");
  editor->TurnWheel(-2.0, friction[0], friction[1]);
  view.Check(IsNear(property->GetTissueFriction(3), 0.79, 0.011), "the wheel on it");
  view.Check(editor->Undo() && editor->Undo() && property->GetTissueFriction(3) == 0.12, "undone");
  view.Check(!VolumeHaptics::EditorProbe::SelectTissue(editor, 7) &&
      !VolumeHaptics::EditorProbe::SelectTissue(editor, -1),
    "tissues that are not there");
  property->RemoveAllTissues();
  view.Window->Render();
  view.Check(!VolumeHaptics::EditorProbe::GetSelectedTissue(editor), "none is left");
  editor->SetFunctionToOpacity();
  editor->NextFunction();
  view.Check(editor->GetFunction() == Editor::STIFFNESS, "no page without tissues");
}

void TestDock(vtkHapticProperty* property)
{
  vtkNew<Editor> editor;
  property->ApplyPreset("CT contrast");
  editor->SetProperty(property);
  vtkNew<vtkRenderer> scene;
  scene->AddViewProp(editor);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(800, 500);
  window->AddRenderer(scene);
  window->Render();
  const auto isAt = [](vtkRenderer* renderer, double left, double bottom, double right, double top)
  {
    double v[4];
    renderer->GetViewport(v);
    return IsNear(v[0], left, 1e-9) && IsNear(v[1], bottom, 1e-9) && IsNear(v[2], right, 1e-9) &&
      IsNear(v[3], top, 1e-9);
  };
  View checks; // reports the messages
  editor->DockedOn();
  for (int i = 0; i < 3; ++i)
  {
    window->Render();
    checks.Check(isAt(scene, 0, 0.35, 1, 1), "below the scene, in every frame");
  }
  double at[2];
  checks.Check(VolumeHaptics::EditorProbe::GetTissuePosition(editor, 2, at) && at[0] > 500,
    "the tissues beside the function");
  // The column of slices occupies the whole edge of the window, so the editor stays in the corner
  // below the scene.
  vtkNew<vtkHapticSliceView> slices;
  slices->SetRenderWindow(window);
  for (int i = 0; i < 3; ++i)
  {
    window->Render();
    checks.Check(isAt(scene, 0, 0.35, 0.7, 1), "with slices");
    checks.Check(isAt(slices->GetRenderer(2), 0.7, 0.35, 1, 0.35 + 0.65 / 3.0), "above the editor");
  }
  editor->SetDockEdgeToLeft();
  editor->SetDockShare(0.5);
  window->Render();
  window->Render();
  checks.Check(isAt(scene, 0.5, 0, 0.7, 1), "left of the scene");
  editor->VisibilityOff();
  window->Render();
  checks.Check(isAt(scene, 0, 0, 0.7, 1), "hidden, it takes no room");
  editor->VisibilityOn();
  window->Render();
  slices->SetRenderWindow(nullptr);
  window->Render();
  checks.Check(isAt(scene, 0.5, 0, 1, 1), "without slices");
  scene->RemoveViewProp(editor);
  window->Render();
  checks.Check(isAt(scene, 0, 0, 1, 1), "taken out of the scene");
  scene->AddViewProp(editor);
  window->Render();
  window->Render();
  checks.Check(isAt(scene, 0.5, 0, 1, 1), "and put back");
  // Drag the border of the editor far beyond the window.
  checks.Check(editor->ButtonPress(Editor::LEFT_BUTTON, 400, 250), "the border is taken");
  editor->MouseMove(5000, 250);
  editor->ButtonRelease(Editor::LEFT_BUTTON, 5000, 250);
  checks.Check(editor->GetDockShare() == 0.9, "the scene is still there");
  window->Render();
  if (!checks.Passed)
  {
    exit(EXIT_FAILURE);
  }
}
} // namespace

int TestFunctionEditorEdits(int, char*[])
{
  vtkNew<vtkHapticProperty> property;
  vtkPiecewiseFunction* const stiffness = property->GetStiffness();
  stiffness->AddPoint(0.0, 0.0);
  stiffness->AddPoint(50.0, 400.0);
  stiffness->AddPoint(100.0, 1000.0);
  property->GetFriction(); // the getter creates the function
  property->GetViscosity();
  property->GetSurfaceStrength();
  property->GetDistinctness();
  View view;
  view.Shown->SetProperty(property);
  view.Window->Render();
  TestAxes(view, property);
  TestHistory(view, property);
  TestTissues(view, property);
  TestDock(property);
  return view.Passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
