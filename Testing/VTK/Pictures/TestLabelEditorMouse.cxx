// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tests that clicks on labels and their sliders change the table itself. The sliders' values must
// equal the table's within a pixel, which is at most a hundredth of the slider.
#include "EditorMouse.h"
#include "Factories.h"
#include "Rigs/EventCounter.h"

#include "VTK/Scene/Editor/EditorProbe.h"

#include "vtkDataArray.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

using namespace editortest;

namespace
{
/// Makes an image with one slice for each label. In each slice, the second half has the label 7.
vtkSmartPointer<vtkImageData> MakeSlices(int type, const std::vector<double>& labels)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(4, 2, static_cast<int>(labels.size()));
  image->AllocateScalars(type, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(
      i, 0, i % 8 < 4 ? labels[static_cast<std::size_t>(i / 8)] : 7.0);
  }
  return image;
}

class LabelView : public View
{
public:
  LabelView()
  {
    this->Shown->SetRectangle(20, 30, 300, 220);
    this->Shown->SetLabelTable(this->Table);
    this->Shown->SetFunctionToLabels();
  }

  Place AtLabel(int label, VolumeHaptics::EditorProbe::LabelPart part)
  {
    double x[2] = { -1.0, -1.0 };
    this->Check(VolumeHaptics::EditorProbe::GetLabelPosition(this->Shown, label, part, x),
      "the label is in the window");
    return { static_cast<int>(std::lround(x[0])), static_cast<int>(std::lround(x[1])) };
  }

  Place AtSlider(int function, double value)
  {
    double x[2] = { -1.0, -1.0 };
    this->Check(VolumeHaptics::EditorProbe::GetSliderPosition(this->Shown, function, value, x),
      "there are sliders");
    return { static_cast<int>(std::lround(x[0])), static_cast<int>(std::lround(x[1])) };
  }

  bool Click(const Place& at)
  {
    const bool taken = this->Drag(Editor::LEFT_BUTTON, at, at);
    this->Window->Render();
    return taken;
  }

  bool Lists(const std::vector<int>& labels)
  {
    return VolumeHaptics::EditorProbe::ListLabels(this->Shown) == labels;
  }

  vtkNew<vtkHapticLabelTable> Table;
};

void TestImages(LabelView& view)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  view.Table->SetLabelName(3, "in the table only");
  view.Check(view.Lists({ 3 }), "labels of the table, without an image");
  view.Shown->SetLabelData(MakeSlices(VTK_SHORT, { 5, -3, 5, 300, 0 }));
  view.Check(view.Lists({ -3, 0, 5, 7, 300 }), "labels of the image, negative ones, too");
  view.Shown->SetLabelData(MakeSlices(VTK_DOUBLE, { 2, nan, inf, 2.5, 3e9, -inf, -2147483648.0 }));
  view.Check(view.Lists({ -2147483647 - 1, 2, 7 }), "whole numbers that a table can have");
  view.Shown->SetLabelData(MakeSlices(VTK_UNSIGNED_LONG_LONG, { 1, 4294967301.0, 2147483647.0 }));
  view.Check(view.Lists({ 1, 7, 2147483647 }), "a number beyond int is not cut off");
  // The names are "heart" in Greek and Chinese, which VTK's font may lack, and a long name with
  // bytes that are not UTF-8.
  view.Table->SetLabelName(1, "\xCE\xBA\xCE\xB1\xCF\x81\xCE\xB4\xCE\xB9\xCE\xAC");
  view.Table->SetLabelName(7, "\xE5\xBF\x83\xE8\x87\x9F");
  view.Table->SetLabelName(2147483647, "\xE9\xFF" + std::string(100000, '\xE9'));
  view.Window->Render();
  const auto image = MakeSlices(VTK_UNSIGNED_CHAR, { 1, 2 });
  view.Shown->SetLabelData(image);
  view.Check(view.Lists({ 1, 2, 7 }), "another image");
  view.Window->Render();
  double at[2];
  view.Check(view.Shown->SelectLabel(2) &&
      VolumeHaptics::EditorProbe::GetLabelPosition(
        view.Shown, 2, VolumeHaptics::EditorProbe::LabelName, at) &&
      VolumeHaptics::EditorProbe::GetSliderPosition(view.Shown, Editor::FRICTION, 0.5, at),
    "positions in the list");
  image->GetPointData()->GetScalars()->SetComponent(0, 0, 9.0);
  image->Modified();
  view.Check(!VolumeHaptics::EditorProbe::GetLabelPosition(
               view.Shown, 2, VolumeHaptics::EditorProbe::LabelName, at) &&
      !VolumeHaptics::EditorProbe::GetSliderPosition(view.Shown, Editor::FRICTION, 0.5, at),
    "no positions in a list that is out of date");
  view.Check(view.Lists({ 1, 2, 7, 9 }), "an image that has changed");
  view.Shown->SetLabelData(vtkSmartPointer<vtkImageData>::New());
  view.Check(view.Lists({}), "an empty image");
  view.Window->Render();
  view.Shown->SetLabelData(nullptr);
}

void TestMaterials(LabelView& view)
{
  Editor* const editor = view.Shown;
  vtkHapticLabelTable* const table = view.Table;
  editor->SetLabelData(MakeSlices(VTK_SHORT, { 5, -3, 6 }));
  const apitest::EventCounter interactions(editor, vtkCommand::InteractionEvent);
  view.Window->Render();
  double nowhere[2];
  view.Check(!VolumeHaptics::EditorProbe::GetSliderPosition(editor, Editor::FRICTION, 0.5, nowhere),
    "no sliders at first");

  vtkMTimeType before = table->GetMTime();
  view.Check(
    view.Click(view.AtLabel(-3, VolumeHaptics::EditorProbe::LabelName)), "a click is taken");
  view.Check(VolumeHaptics::EditorProbe::GetSelectedLabel(editor) == -3, "it selects");
  view.Check(table->GetMTime() == before && interactions.Count == 0, "and changes nothing");

  view.Click(view.AtLabel(5, VolumeHaptics::EditorProbe::LabelFelt));
  view.Click(view.AtLabel(6, VolumeHaptics::EditorProbe::LabelForbidden));
  view.Check(!table->GetFelt(5) && table->GetFelt(6) && table->GetForbidden(6) &&
      !table->GetForbidden(5) && interactions.Count == 2,
    "boxes of two labels");
  view.Click(view.AtLabel(5, VolumeHaptics::EditorProbe::LabelFelt));
  view.Check(table->GetFelt(5) && VolumeHaptics::EditorProbe::GetSelectedLabel(editor) == 5,
    "felt again, and selected");

  const auto near = [](double a, double b, double end) { return std::abs(a - b) <= 0.011 * end; };
  view.Click(view.AtSlider(Editor::STIFFNESS, 400.0));
  view.Check(near(table->GetStiffness(5), 400.0, 1000.0), "a click on the slider of stiffness");
  view.Check(table->GetFriction(5) == -1.0 && table->GetStiffness(-3) == -1.0, "and on no other");
  view.Drag(Editor::LEFT_BUTTON, view.AtSlider(Editor::FRICTION, 0.1),
    view.AtSlider(Editor::FRICTION, 0.8));
  view.Drag(Editor::LEFT_BUTTON, view.AtSlider(Editor::VISCOSITY, 0.7),
    view.AtSlider(Editor::VISCOSITY, 0.3));
  view.Check(near(table->GetFriction(5), 0.8, 1.0) && near(table->GetViscosity(5), 0.3, 1.0),
    "drags to both sides");

  // Drag beyond the end of the slider three times. Each time, its range must grow when the slider
  // is released.
  for (const double end : { 5.0, 6.0, 8.0 })
  {
    const Place last = view.AtSlider(Editor::SURFACE_STRENGTH, end);
    view.Drag(Editor::LEFT_BUTTON, view.AtSlider(Editor::SURFACE_STRENGTH, 0.0),
      { last[0] + 50, last[1] + 500 });
    view.Check(table->GetSurfaceStrength(5) == end, "the end of a slider, which has grown");
    view.Window->Render();
  }
  const Place strength = view.AtSlider(Editor::SURFACE_STRENGTH, 1.0);
  view.Check(editor->TurnWheel(-2.0, strength[0], strength[1]), "the wheel on a slider");
  view.Check(table->GetSurfaceStrength(5) == 8.0 - 2.0 * 10.0 / 200.0, "moves it by two steps");
  // Set a value beyond the largest end of a slider, which is 100.
  table->SetSurfaceStrength(5, 500.0);
  editor->TurnWheel(-2.0, strength[0], strength[1]);
  view.Check(table->GetSurfaceStrength(5) == 500.0 - 2.0 * 100.0 / 200.0,
    "a value beyond the end goes on from where it is");

  before = table->GetMTime();
  const Place slider = view.AtSlider(Editor::STIFFNESS, 900.0);
  view.Drag(Editor::RIGHT_BUTTON, slider, slider);
  view.Drag(Editor::MIDDLE_BUTTON, slider, slider);
  editor->MouseMove(slider[0], slider[1]);
  view.Check(table->GetMTime() == before, "other buttons, and moves without one, change nothing");
  view.Check(!editor->TurnWheel(1.0, 5, 5) && !editor->MouseMove(5, 5), "nor is it beside");

  // The button is right of the selected label's name, above the sliders.
  const Place end = view.AtSlider(Editor::STIFFNESS, 1000.0);
  view.Click({ end[0] - 10, end[1] + (end[1] - view.AtSlider(Editor::FRICTION, 0.0)[1]) });
  view.Check(!table->HasMaterial(5), "by the functions again");
}

void TestMany(LabelView& view)
{
  Editor* const editor = view.Shown;
  constexpr int side = 100;
  constexpr int labels = side * side * side;
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, side);
  image->AllocateScalars(VTK_INT, 1);
  for (int i = 0; i < labels; ++i)
  {
    // The labels are in no order, and without duplicates, because the factor is odd and no multiple
    // of 5.
    image->GetPointData()->GetScalars()->SetComponent(
      i, 0, (i * std::int64_t{ 777777 }) % labels - labels / 2);
  }
  editor->SetLabelData(image);
  view.Window->Render();
  std::vector<int> all(labels);
  std::iota(all.begin(), all.end(), -labels / 2);
  view.Check(view.Lists(all), "a million labels, in order");
  view.Check(editor->SelectLabel(123456) && !editor->SelectLabel(labels), "selected by number");
  view.Window->Render();
  view.Click(view.AtLabel(123457, VolumeHaptics::EditorProbe::LabelName));
  view.Check(
    VolumeHaptics::EditorProbe::GetSelectedLabel(editor) == 123457, "its neighbour is clicked on");

  const Place list = view.AtLabel(123457, VolumeHaptics::EditorProbe::LabelName);
  double at[2];
  editor->TurnWheel(-1000.0, list[0], list[1]); // a step scrolls by three rows
  view.Check(!VolumeHaptics::EditorProbe::GetLabelPosition(
               editor, 123457, VolumeHaptics::EditorProbe::LabelName, at) &&
      VolumeHaptics::EditorProbe::GetLabelPosition(
        editor, 126457, VolumeHaptics::EditorProbe::LabelName, at),
    "the wheel scrolls towards the user");
  // The scroll bar is at the right edge. Its ends show the first and the last label.
  const Place right = { 120 + 20 + 300 - 9, list[1] };
  view.Drag(Editor::LEFT_BUTTON, right, { right[0], 1000 });
  view.Check(VolumeHaptics::EditorProbe::GetLabelPosition(
               editor, -labels / 2, VolumeHaptics::EditorProbe::LabelFelt, at),
    "the bar, upwards");
  view.Drag(Editor::LEFT_BUTTON, right, { right[0], 0 });
  view.Check(VolumeHaptics::EditorProbe::GetLabelPosition(
               editor, labels / 2 - 1, VolumeHaptics::EditorProbe::LabelFelt, at),
    "and downwards");
  view.Window->Render();
  editor->SetLabelData(nullptr);
}
} // namespace

int TestLabelEditorMouse(int, char*[])
{
  LabelView view;
  view.Window->Render();
  view.Check(view.Shown->GetTitle() == "Materials of labels", "the title");
  view.Check(!view.Shown->GetPiecewiseFunction(), "there is no function");
  TestImages(view);
  TestMaterials(view);
  TestMany(view);

  // If there is a table, the page of labels follows the last function.
  vtkNew<vtkHapticProperty> property;
  view.Shown->SetProperty(property);
  view.Shown->SetFunctionToSurfaceStrength();
  view.Shown->NextFunction();
  view.Check(view.Shown->GetFunction() == Editor::LABELS, "after the last function");
  view.Shown->NextFunction();
  view.Check(view.Shown->GetFunction() == Editor::STIFFNESS, "and before the first one");
  view.Shown->SetFunctionToLabels();
  view.Shown->SetLabelTable(nullptr);
  view.Window->Render();
  const Place middle = { 250, 150 };
  view.Check(view.Click(middle) && view.Shown->TurnWheel(1.0, 250, 150), "without a table");
  view.Shown->SetFunctionToSurfaceStrength();
  view.Shown->NextFunction();
  view.Check(view.Shown->GetFunction() == Editor::STIFFNESS, "no page without a table");
  return view.Passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
