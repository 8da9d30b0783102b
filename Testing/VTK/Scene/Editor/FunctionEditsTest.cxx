// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests editing a function with the mouse. A point must follow the mouse to the pixel, and undo
 * must restore a function bitwise. Expected values come from the linear axes and from copies of the
 * functions.
 */

#include "VTK/Scene/Editor/EditorProbe.h"

#include <vtkCallbackCommand.h>
#include <vtkHapticFunctionEditor.h>
#include <vtkHapticProperty.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using Place = std::array<int, 2>;
using Nodes = std::vector<std::array<double, 4>>;

constexpr int Left = vtkHapticFunctionEditor::LEFT_BUTTON;
constexpr int Middle = vtkHapticFunctionEditor::MIDDLE_BUTTON;
constexpr int Right = vtkHapticFunctionEditor::RIGHT_BUTTON;

Nodes CopyNodes(vtkPiecewiseFunction* function)
{
  Nodes nodes(static_cast<std::size_t>(function->GetSize()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    function->GetNodeValue(static_cast<int>(i), nodes[i].data());
  }
  return nodes;
}

class FunctionEdits : public testing::Test
{
protected:
  FunctionEdits()
  {
    this->Fill();
    this->Editor->SetProperty(this->Property);
    this->Editor->SetRectangle(40, 20, 360, 240);
    this->Renderer->AddViewProp(this->Editor);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(440, 300);
    this->Window->AddRenderer(this->Renderer);
    this->Window->Render();
    vtkNew<vtkCallbackCommand> observer;
    observer->SetClientData(&this->Events);
    observer->SetCallback(
      [](vtkObject*, unsigned long, void* events, void*) { ++*static_cast<int*>(events); });
    this->Editor->AddObserver(vtkCommand::InteractionEvent, observer);
  }
  void Fill()
  {
    vtkPiecewiseFunction* const function = this->Get();
    function->RemoveAllPoints();
    function->AddPoint(-1000.0, 0.0);
    function->AddPoint(-200.0, 300.0);
    function->AddPoint(400.0, 700.0);
    function->AddPoint(1000.0, 900.0);
  }
  vtkPiecewiseFunction* Get() { return this->Property->GetStiffness(); }
  /// Returns the pixel of a value and a stiffness. Renders first, because the editor uses the
  /// layout of the last frame.
  Place At(double value, double stiffness)
  {
    this->Window->Render();
    double at[2];
    VolumeHaptics::EditorProbe::GetPosition(this->Editor, value, stiffness, at);
    return { static_cast<int>(std::lround(at[0])), static_cast<int>(std::lround(at[1])) };
  }
  /// Returns the differences of value and stiffness between neighbouring pixels.
  std::array<double, 2> GetPixel()
  {
    double low[2];
    double high[2];
    VolumeHaptics::EditorProbe::GetPosition(this->Editor, -1000.0, 0.0, low);
    VolumeHaptics::EditorProbe::GetPosition(this->Editor, 1000.0, 900.0, high);
    return { 2000.0 / (high[0] - low[0]), 900.0 / (high[1] - low[1]) };
  }
  void Drag(const Place& from, const Place& to, int button = Left)
  {
    EXPECT_TRUE(this->Editor->ButtonPress(button, from[0], from[1]));
    EXPECT_TRUE(this->Editor->MouseMove((from[0] + to[0]) / 2, (from[1] + to[1]) / 2));
    EXPECT_TRUE(this->Editor->MouseMove(to[0], to[1]));
    EXPECT_TRUE(this->Editor->ButtonRelease(button, to[0], to[1]));
  }
  void Click(const Place& at, int button = Left)
  {
    EXPECT_TRUE(this->Editor->ButtonPress(button, at[0], at[1]));
    EXPECT_TRUE(this->Editor->ButtonRelease(button, at[0], at[1]));
  }

  vtkNew<vtkHapticProperty> Property;
  vtkNew<vtkHapticFunctionEditor> Editor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  int Events = 0;
};

} // namespace

TEST_F(FunctionEdits, ADraggedPointIsWhereTheMouseIs)
{
  for (const auto& [value, stiffness] :
    { std::pair{ -600.0, 500.0 }, std::pair{ 350.0, 100.0 }, std::pair{ -999.0, 850.0 } })
  {
    this->Fill();
    this->Drag(this->At(-200.0, 300.0), this->At(value, stiffness));
    const Nodes nodes = CopyNodes(this->Get());
    ASSERT_EQ(nodes.size(), 4u);
    EXPECT_NEAR(nodes[1][0], value, 1.01 * this->GetPixel()[0]);
    EXPECT_NEAR(nodes[1][1], stiffness, 1.01 * this->GetPixel()[1]);
    EXPECT_EQ(nodes[0][1], 0.0) << "another point";
    EXPECT_EQ(nodes[2][0], 400.0) << "another point";
  }
}

/// Points must preserve their order, and the end points their values, so that the function stays
/// single-valued.
TEST_F(FunctionEdits, APointPassesNoOtherOneAndEndsMoveUpAndDown)
{
  this->Drag(this->At(-200.0, 300.0), this->At(900.0, 300.0));
  Nodes nodes = CopyNodes(this->Get());
  ASSERT_EQ(nodes.size(), 4u);
  EXPECT_LE(nodes[1][0], 400.0);
  EXPECT_EQ(nodes[2][0], 400.0);
  this->Fill();
  this->Drag(this->At(-1000.0, 0.0), this->At(-500.0, 450.0));
  nodes = CopyNodes(this->Get());
  EXPECT_EQ(nodes[0][0], -1000.0);
  EXPECT_NEAR(nodes[0][1], 450.0, 1.01 * this->GetPixel()[1]);
}

TEST_F(FunctionEdits, AClickAddsAPointAndTheMiddleButtonRemovesIt)
{
  this->Click(this->At(100.0, 800.0));
  Nodes nodes = CopyNodes(this->Get());
  ASSERT_EQ(nodes.size(), 5u);
  EXPECT_NEAR(nodes[2][0], 100.0, 1.01 * this->GetPixel()[0]);
  EXPECT_NEAR(nodes[2][1], 800.0, 1.01 * this->GetPixel()[1]);
  this->Click(this->At(nodes[2][0], nodes[2][1]), Middle);
  nodes = CopyNodes(this->Get());
  ASSERT_EQ(nodes.size(), 4u);
  EXPECT_EQ(nodes[1][0], -200.0);
  EXPECT_EQ(nodes[2][0], 400.0);
}

/// Right clicks select points. A drag beside the points then moves the selected points together.
TEST_F(FunctionEdits, SelectedPointsMoveTogether)
{
  this->Click(this->At(-200.0, 300.0), Right);
  this->Click(this->At(400.0, 700.0), Right);
  EXPECT_EQ(CopyNodes(this->Get())[1][1], 300.0) << "a selection changes nothing";
  this->Drag(this->At(0.0, 100.0), this->At(100.0, 200.0));
  const Nodes nodes = CopyNodes(this->Get());
  ASSERT_EQ(nodes.size(), 4u);
  EXPECT_NEAR(nodes[1][0], -100.0, 1.01 * this->GetPixel()[0]);
  EXPECT_NEAR(nodes[1][1], 400.0, 1.01 * this->GetPixel()[1]);
  constexpr double rounding = 2e-4; // charts store positions in single precision
  EXPECT_NEAR(nodes[2][0] - 400.0, nodes[1][0] + 200.0, rounding);
  EXPECT_NEAR(nodes[2][1] - 700.0, nodes[1][1] - 300.0, rounding);
  EXPECT_EQ(nodes[3][1], 900.0) << "not selected";
}

/// Displaying an empty function must not add points, which would change the force.
TEST_F(FunctionEdits, AnEmptyFunctionStaysEmptyUntilAPointIsAdded)
{
  this->Get()->RemoveAllPoints();
  this->Window->Render();
  this->Editor->Update();
  EXPECT_EQ(this->Get()->GetSize(), 0);
  double at[2];
  VolumeHaptics::EditorProbe::GetPosition(this->Editor, 0.0, 0.0, at);
  this->Click({ static_cast<int>(at[0]) + 90, static_cast<int>(at[1]) + 60 });
  const Nodes nodes = CopyNodes(this->Get());
  ASSERT_EQ(nodes.size(), 3u) << "the constant at both ends, and the point";
  EXPECT_EQ(nodes[0][1], nodes[2][1]);
  EXPECT_NE(nodes[1][1], nodes[0][1]);
  ASSERT_TRUE(this->Editor->Undo());
  EXPECT_EQ(this->Get()->GetSize(), 0);
}

/// Makes 130 edits, of which the editor stores the last 100. Undo and redo must restore each state
/// bitwise.
TEST_F(FunctionEdits, AreTakenBackAndDoneAgainToTheBit)
{
  std::mt19937 random(3);
  std::vector<Nodes> states = { CopyNodes(this->Get()) };
  while (states.size() <= 130)
  {
    const Nodes& now = states.back();
    const auto one = 1 + random() % (now.size() - 2);
    const Place point = this->At(now[one][0], now[one][1]);
    const double between = 0.5 * (now[one][0] + now[one - 1][0]);
    if (now.size() > 6)
    {
      this->Click(point, Middle);
    }
    else if (random() % 3 == 0 && now[one][0] - now[one - 1][0] > 100.0)
    {
      this->Click(this->At(between, 20.0 + random() % 800));
    }
    else
    {
      this->Drag(point, this->At(now[one][0], 20.0 + random() % 800));
    }
    if (CopyNodes(this->Get()) != now)
    {
      states.push_back(CopyNodes(this->Get()));
    }
  }
  for (std::size_t i = 1; i <= 100; ++i)
  {
    ASSERT_TRUE(this->Editor->Undo()) << i;
    ASSERT_EQ(CopyNodes(this->Get()), states[130 - i]) << i;
  }
  EXPECT_FALSE(this->Editor->Undo()) << "older ones are forgotten";
  for (std::size_t i = 31; i <= 130; ++i)
  {
    ASSERT_TRUE(this->Editor->Redo()) << i;
    ASSERT_EQ(CopyNodes(this->Get()), states[i]) << i;
  }
  EXPECT_FALSE(this->Editor->Redo());
  ASSERT_TRUE(this->Editor->Reset());
  EXPECT_EQ(CopyNodes(this->Get()), states[0]) << "as before the first edit, however many follow";
  ASSERT_TRUE(this->Editor->Undo()) << "a reset is an edit";
  EXPECT_EQ(CopyNodes(this->Get()), states[130]);
}

/// The editor must send one event for each change, so that a device publishes it, and no event
/// without a change.
TEST_F(FunctionEdits, TellOfChangesOnly)
{
  const Place point = this->At(-200.0, 300.0);
  EXPECT_TRUE(this->Editor->MouseMove(point[0], point[1]));
  this->Editor->Contains(point[0], point[1]);
  EXPECT_FALSE(this->Editor->MouseMove(5, 290)) << "outside";
  EXPECT_FALSE(this->Editor->ButtonPress(Left, 5, 290));
  EXPECT_EQ(CopyNodes(this->Get())[1][1], 300.0);
  const Nodes nodes = CopyNodes(this->Get());
  this->Click(point);
  EXPECT_EQ(CopyNodes(this->Get()), nodes) << "a click on a point moves nothing";
  const vtkMTimeType before = this->Property->GetMTime();
  this->Events = 0;
  this->Drag(point, { point[0], point[1] + 20 });
  EXPECT_GT(this->Property->GetMTime(), before);
  EXPECT_GE(this->Events, 2);
  this->Events = 0;
  EXPECT_TRUE(this->Editor->Undo());
  EXPECT_EQ(this->Events, 1);
  EXPECT_FALSE(this->Editor->Undo());
  EXPECT_EQ(this->Events, 1) << "nothing to take back";
}
