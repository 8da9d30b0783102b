// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests keys that control the function editor: undo, redo, reset, and its position in the window.
 */

#include "StyleRig.h"
#include "VTK/Scene/Editor/EditorProbe.h"

#include <vtkHapticFunctionEditor.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticMeasurements.h>

using namespace scenetest;

namespace
{
class StyleEditor : public StyleTest
{
protected:
  StyleEditor()
  {
    this->Display->SetDevice(this->Device);
    this->Style->SetHeadUpDisplay(this->Display);
    this->Property->ApplyPreset("CT contrast");
    this->Editor->SetProperty(this->Property);
    this->Editor->SetRectangle(10, 10, 280, 200);
    this->Editor->SetFunctionToTissues();
    this->Renderer->AddViewProp(this->Editor);
    this->Style->SetFunctionEditor(this->Editor);
    this->Window->Render();
  }
  /// Clicks on the slider of a tissue's stiffness at this value (N/m).
  void Slide(double stiffness)
  {
    double at[2];
    ASSERT_TRUE(VolumeHaptics::EditorProbe::SelectTissue(this->Editor, 2));
    this->Window->Render();
    ASSERT_TRUE(VolumeHaptics::EditorProbe::GetSliderPosition(
      this->Editor, vtkHapticFunctionEditor::STIFFNESS, stiffness, at));
    const int x = static_cast<int>(std::lround(at[0]));
    const int y = static_cast<int>(std::lround(at[1]));
    this->Pointer(x, y, vtkCommand::LeftButtonPressEvent);
    this->Pointer(x, y, vtkCommand::LeftButtonReleaseEvent);
  }
  double Stiffness() { return this->Property->GetTissueStiffness(2); }
  bool Notices(const char* words)
  {
    return std::string(this->Display->GetNotice()).find(words) != std::string::npos;
  }

  vtkNew<vtkHapticProperty> Property;
  vtkNew<vtkHapticFunctionEditor> Editor;
  vtkNew<vtkHapticHeadUpDisplay> Display;
};
} // namespace

TEST_F(StyleEditor, KeysTakeEditsBackAndDoThemAgain)
{
  this->Slide(200.0);
  EXPECT_NEAR(this->Stiffness(), 200.0, 8.0);
  const double first = this->Stiffness();
  this->Slide(700.0);
  const double second = this->Stiffness();
  EXPECT_NEAR(second, 700.0, 8.0);
  this->Press("Ctrl+z");
  EXPECT_EQ(this->Stiffness(), first);
  this->Press("Ctrl+z");
  EXPECT_EQ(this->Stiffness(), 400.0);
  this->Press("Ctrl+z");
  EXPECT_EQ(this->Stiffness(), 400.0);
  EXPECT_TRUE(this->Notices("There is no edit to undo"));
  this->Press("Ctrl+y");
  this->Press("Ctrl+y");
  EXPECT_EQ(this->Stiffness(), second);
  this->Press("Ctrl+y");
  EXPECT_TRUE(this->Notices("There is no edit to redo"));
  this->Press("Ctrl+BackSpace");
  EXPECT_EQ(this->Stiffness(), 400.0);
  this->Press("Ctrl+z");
  EXPECT_EQ(this->Stiffness(), second) << "a reset is an edit, too";
}

TEST_F(StyleEditor, UndoBelongsToMeasurementsBesideTheEditor)
{
  vtkNew<vtkHapticMeasurements> list;
  const double point[3] = { 1.0, 2.0, 3.0 };
  list->AddPoint(point);
  this->Style->SetMeasurements(list);
  this->Slide(200.0);
  this->Press("Ctrl+z");
  EXPECT_EQ(this->Stiffness(), 400.0) << "the pointer is over the editor";
  EXPECT_EQ(list->GetNumberOfMeasurements(), 1);
  EXPECT_TRUE(this->Style->PerformAction("Undo"));
  EXPECT_EQ(list->GetNumberOfMeasurements(), 0) << "a menu lies where it lies";
  EXPECT_TRUE(this->Style->PerformAction("Redo"));
  this->Press("Ctrl+y");
  this->Pointer(295, 295);
  this->Press("Ctrl+z");
  EXPECT_EQ(list->GetNumberOfMeasurements(), 0);
  EXPECT_NE(this->Stiffness(), 400.0);
}

TEST_F(StyleEditor, AKeyPutsItBesideTheScene)
{
  double viewport[4];
  this->Editor->VisibilityOff();
  this->Press("u");
  EXPECT_TRUE(this->Editor->GetVisibility());
  EXPECT_TRUE(this->Editor->GetDocked());
  this->Window->Render();
  this->Window->Render();
  this->Renderer->GetViewport(viewport);
  EXPECT_NEAR(viewport[1], 0.35, 1e-12);
  EXPECT_TRUE(this->Editor->Contains(150, 20));
  EXPECT_FALSE(this->Editor->Contains(150, 200)) << "in its rectangle over the scene";

  // The mouse must drag the border of the editor without moving the camera.
  double before[3];
  this->Renderer->GetActiveCamera()->GetPosition(before);
  this->Pointer(150, 105);
  this->Pointer(150, 105, vtkCommand::LeftButtonPressEvent);
  this->Pointer(150, 180);
  this->Pointer(150, 180, vtkCommand::LeftButtonReleaseEvent);
  this->Window->Render();
  EXPECT_NEAR(this->Editor->GetDockShare(), 0.6, 0.01);
  this->Renderer->GetViewport(viewport);
  EXPECT_NEAR(viewport[1], 0.6, 0.01);
  double after[3];
  this->Renderer->GetActiveCamera()->GetPosition(after);
  EXPECT_TRUE(std::equal(before, before + 3, after));
  this->Pointer(150, 200);
  EXPECT_NEAR(this->Editor->GetDockShare(), 0.6, 0.01) << "it was let go";

  this->Press("u");
  EXPECT_FALSE(this->Editor->GetDocked());
  this->Window->Render();
  this->Renderer->GetViewport(viewport);
  EXPECT_EQ(viewport[1], 0.0);
  EXPECT_EQ(viewport[3], 1.0);
}
