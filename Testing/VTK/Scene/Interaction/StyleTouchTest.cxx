// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests a mouse that presses on a ball, slides and ends the touch. */

#include "StyleRig.h"

#include <vtkHapticFunctionEditor.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkInteractorObserver.h>

#include <functional>

using namespace scenetest;

namespace
{
double Component(vtkTable* states, const char* column, vtkIdType row, int component = 0)
{
  return vtkDataArray::SafeDownCast(states->GetColumnByName(column))->GetComponent(row, component);
}
} // namespace

TEST_F(StyleTest, PressesSlidesAndLetsGoWithTheProxyOnTheSurface)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Pointer(150, 150);
  this->Press("t");
  ASSERT_TRUE(this->Style->GetTouchMode());
  this->Run(50);
  EXPECT_EQ(this->Device->GetState()->GetContact(), 0)
    << "touch mode begins in front of the surface";
  const double start = this->Device->GetState()->GetTipPosition()[2];
  // Touch mode begins up to a kernel radius (2 mm) in front of the surface, because materials are
  // read that far ahead.
  EXPECT_NEAR(start, 32.0, 1.5);

  double first = 0.0;
  double away = 0.0;
  double deepest = 0.0;
  vtkIdType touched = 0;
  const auto watch = [&](vtkTable* states, vtkIdType i)
  {
    if (Component(states, "Contact", i) == 0.0)
    {
      return;
    }
    double proxy[3];
    double tip[3];
    for (int c = 0; c < 3; ++c)
    {
      proxy[c] = Component(states, "Proxy", i, c);
      tip[c] = Component(states, "Tip", i, c);
    }
    first = touched++ == 0 ? Length(proxy) : first;
    away = std::max(away, std::abs(Length(proxy) - first));
    deepest = std::max(deepest, first - Length(tip));
  };
  for (int i = 0; i < 4; ++i)
  {
    this->Pointer(150, 150, vtkCommand::MouseWheelForwardEvent);
    this->Run(10, watch);
  }
  EXPECT_GT(deepest, 2.0) << "the pointer sinks in";
  for (int x = 151; x <= 190; ++x)
  {
    this->Pointer(x, 150);
    this->Run(4, watch);
  }
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[0], 8.0, 1e-6) << "40 pixels of 0.2 mm";
  EXPECT_GT(this->Device->GetState()->GetProxyPosition()[0], 7.0);
  EXPECT_GT(touched, 150);
  EXPECT_LT(away, 0.05) << "voxels of 1 mm";
  for (int i = 0; i < 6; ++i)
  {
    this->Pointer(190, 150, vtkCommand::MouseWheelBackwardEvent);
    this->Run(10, watch);
  }
  EXPECT_EQ(this->Device->GetState()->GetContact(), 0);
  this->Press("Escape");
  this->Run(20);
  EXPECT_FALSE(this->Style->GetTouchMode());
  using S = vtkInteractorStyleHaptic;
  EXPECT_EQ(this->Events,
    (std::vector<unsigned long>{
      S::ArmedEvent, S::ContactBeginEvent, S::ContactEndEvent, S::DisarmedEvent }));
}

TEST_F(StyleTest, MovesFinelyInDepthAndPressesTheButton)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Style->SetDepthStep(0.5);
  this->Pointer(10, 10); // beside the ball, so the tip moves to the focal plane
  this->Style->TouchModeOn();
  this->Run(20);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[0], -28.0, 0.2);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 0.0, 1e-6);
  this->Pointer(10, 10, vtkCommand::MouseWheelBackwardEvent);
  this->Run(20);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 0.5, 1e-6);
  this->Pointer(10, 10, vtkCommand::MouseWheelBackwardEvent, 1);
  this->Pointer(15, 10, vtkCommand::MouseMoveEvent, 1);
  this->Run(20);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 0.6, 1e-6);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[0], -27.8, 0.21);
  this->Pointer(15, 10, vtkCommand::LeftButtonPressEvent);
  this->Run(20);
  EXPECT_EQ(this->Device->GetState()->GetButtons(), 1);
  this->Pointer(15, 10, vtkCommand::LeftButtonReleaseEvent);
  this->Run(20);
  EXPECT_EQ(this->Device->GetState()->GetButtons(), 0);
}

TEST_F(StyleTest, NeedsADeviceThatRuns)
{
  this->Style->TouchModeOn();
  EXPECT_FALSE(this->Style->GetTouchMode());
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("started"), std::string::npos);
  EXPECT_FALSE(this->Style->UpdateHaptics());
}

TEST_F(StyleTest, AStrokeGoesOnAroundABall)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Style->TipFollowsSurfaceOn();
  this->Pointer(150, 150);
  this->Style->TouchModeOn();
  this->RunUntilFullyArmed();
  const double start = this->Device->GetState()->GetTipPosition()[2];
  // Touch mode begins half a voxel in front of the first contact, which determines this radius.
  const double radius = start - 0.5;
  for (int i = 0; i < 4; ++i)
  {
    this->Pointer(150, 150, vtkCommand::MouseWheelForwardEvent);
    this->Run(10);
  }
  const double press = start - this->Device->GetState()->GetTipPosition()[2];
  ASSERT_NEAR(press, 4.0, 1e-6) << "voxels of 1 mm";
  const auto heightAt = [&](double x) { return std::sqrt(radius * radius - x * x) + 0.5; };
  const auto strokeTo = [&](int pixel)
  {
    this->Pointer(pixel, 150);
    this->Run(30);
    return 0.2 * (pixel - 150); // mm
  };
  double x = 0.0;
  for (int pixel = 154; pixel <= 294; pixel += 4)
  {
    x = strokeTo(pixel);
    ASSERT_NEAR(this->Device->GetState()->GetTipPosition()[2], heightAt(x) - press, 0.05) << x;
    ASSERT_NE(this->Device->GetState()->GetContact(), 0) << x;
  }
  // A slope above 2 counts as an edge, where the hand leaves the ball and must stay in the plane of
  // the view.
  const double height = this->Device->GetState()->GetTipPosition()[2];
  strokeTo(150 + static_cast<int>(5.0 * radius) - 1);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], height, 1e-6);
  strokeTo(340);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], height, 1e-6)
    << "there is nothing to follow";
  EXPECT_EQ(this->Device->GetState()->GetContact(), 0);
  // The hand returns to the front of the surface. After a backward step of the wheel, it must stay
  // 1 mm higher.
  x = strokeTo(200);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], heightAt(x), 0.05);
  this->Pointer(200, 150, vtkCommand::MouseWheelBackwardEvent);
  x = strokeTo(230);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], heightAt(x) + 1.0, 0.05);
  // With a method that has no surfaces, the hand must move in the plane of the view.
  this->Filter->SetMethodToForceField();
  this->Run(10);
  x = strokeTo(180);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], heightAt(16.0) + 1.0, 0.05);
}

namespace
{
/// Tests a hand beside the middle of the ball, and an editor that can be docked.
class HeldHand : public StyleTest
{
protected:
  HeldHand()
  {
    this->Window->SetSize(600, 300);
    this->Renderer->AddViewProp(this->Editor);
    this->Renderer->AddViewProp(this->Display);
    this->Editor->SetDockEdge(vtkHapticFunctionEditor::RIGHT_EDGE);
    this->Editor->VisibilityOff();
    this->Style->SetFunctionEditor(this->Editor);
    this->Style->SetHeadUpDisplay(this->Display);
  }
  void Touch(int x, int y)
  {
    EXPECT_TRUE(this->Device->Open("virtual"));
    EXPECT_TRUE(this->Device->Start());
    this->Window->Render();
    this->Pointer(x, y);
    this->Style->TouchModeOn();
    this->Rest();
  }
  /// Waits until the hand has reached the mouse's target.
  void Rest()
  {
    double last[3] = { 1e9, 1e9, 1e9 };
    EXPECT_TRUE(Eventually(
      [&]
      {
        this->Run(30);
        double now[3];
        this->Device->GetState()->GetTipPosition(now);
        const double moved[3] = { now[0] - last[0], now[1] - last[1], now[2] - last[2] };
        std::copy_n(now, 3, last);
        return Length(moved) < 1e-9;
      }));
  }
  /// Returns the distance (pixels) from the hand to a position in the window.
  double Distance(int x, int y)
  {
    double display[3];
    const double* const tip = this->Device->GetState()->GetTipPosition();
    vtkInteractorObserver::ComputeWorldToDisplay(this->Renderer, tip[0], tip[1], tip[2], display);
    return std::hypot(display[0] - x, display[1] - y);
  }

  vtkNew<vtkHapticFunctionEditor> Editor;
  vtkNew<vtkHapticHeadUpDisplay> Display;
};
} // namespace

TEST_F(HeldHand, IsUnderThePointerAfterAnEditorHasTakenPartOfTheWindow)
{
  this->Touch(320, 160);
  ASSERT_LT(this->Distance(320, 160), 1.0);
  this->Press("u");
  this->Window->Render();
  ASSERT_GT(this->Distance(320, 160), 50.0) << "the picture is narrower";
  this->Pointer(322, 160);
  this->Rest();
  EXPECT_LT(this->Distance(322, 160), 1.0);
  this->Press("v");
  this->Window->Render();
  this->Pointer(325, 162);
  this->Rest();
  EXPECT_LT(this->Distance(325, 162), 1.0);
}

TEST_F(HeldHand, IsUnderThePointerThatHasLeftTheWindowAndComesBackElsewhere)
{
  this->Touch(320, 160);
  this->Pointer(599, 160);
  this->Rest();
  // Interactors store the position where the pointer enters, but send no motion for it.
  this->Pointer(280, 299, vtkCommand::EnterEvent);
  this->Pointer(282, 150);
  this->Rest();
  EXPECT_LT(this->Distance(282, 150), 1.0);
}

TEST_F(HeldHand, StaysUnderThePointerWhileTheViewIsZoomed)
{
  for (const int parallel : { 1, 0 })
  {
    this->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    this->Touch(350, 180);
    const double* const tip = this->Device->GetState()->GetTipPosition();
    const double before[3] = { tip[0], tip[1], tip[2] };
    const double pixel = this->Renderer->GetActiveCamera()->GetParallelScale();
    for (int i = 0; i < 5; ++i)
    {
      this->Interactor->SetEventInformation(350, 180, 1, 0);
      this->Interactor->InvokeEvent(vtkCommand::MouseWheelForwardEvent);
    }
    ASSERT_TRUE(parallel == 0 || this->Renderer->GetActiveCamera()->GetParallelScale() < pixel);
    this->Pointer(350, 180);
    this->Rest();
    EXPECT_LT(this->Distance(350, 180), 1.0) << parallel;
    const double moved[3] = { tip[0] - before[0], tip[1] - before[1], tip[2] - before[2] };
    EXPECT_LT(Length(moved), 1e-6) << "the view moves, not the hand";
    this->Style->TouchModeOff();
    this->Device->Close();
  }
}

TEST_F(HeldHand, StaysWhereItIsWhileTheViewIsTurned)
{
  this->Touch(320, 160);
  const double* const tip = this->Device->GetState()->GetTipPosition();
  const double before[3] = { tip[0], tip[1], tip[2] };
  this->Pointer(320, 160, vtkCommand::RightButtonPressEvent);
  this->Pointer(420, 160);
  this->Pointer(420, 160, vtkCommand::RightButtonReleaseEvent);
  this->Pointer(421, 160);
  this->Rest();
  const double moved[3] = { tip[0] - before[0], tip[1] - before[1], tip[2] - before[2] };
  EXPECT_LT(Length(moved), 0.3) << "a motion of one pixel";
}

TEST_F(HeldHand, StaysWhereItIsWhileTheViewIsMoved)
{
  this->Touch(320, 160);
  const double* const tip = this->Device->GetState()->GetTipPosition();
  const double before[3] = { tip[0], tip[1], tip[2] };
  this->Pointer(320, 160, vtkCommand::MiddleButtonPressEvent);
  this->Pointer(420, 130);
  this->Pointer(420, 130, vtkCommand::MiddleButtonReleaseEvent);
  this->Pointer(421, 130);
  this->Rest();
  const double panned[3] = { tip[0] - before[0], tip[1] - before[1], tip[2] - before[2] };
  EXPECT_LT(Length(panned), 0.3) << "a motion of one pixel";
  this->Renderer->GetActiveCamera()->Zoom(0.5);
  this->Pointer(422, 130);
  this->Rest();
  const double moved[3] = { tip[0] - before[0], tip[1] - before[1], tip[2] - before[2] };
  EXPECT_LT(Length(moved), 0.7) << "a motion of one pixel, and one that is twice as large";
}

TEST_F(HeldHand, GoesTheWayOfThePointerOnceWhateverIsBetween)
{
  this->Touch(320, 160);
  const double* const tip = this->Device->GetState()->GetTipPosition();
  const auto expectWay = [&](const char* between, const std::function<void()>& act)
  {
    this->Pointer(320, 160);
    this->Rest();
    const double before = tip[0];
    act();
    this->Pointer(310, 160, vtkCommand::LeftButtonPressEvent);
    this->Pointer(310, 160, vtkCommand::LeftButtonReleaseEvent);
    this->Pointer(330, 160);
    this->Rest();
    constexpr double pixel = 0.2; // mm, width of a pixel
    EXPECT_NEAR(tip[0] - before, 10.0 * pixel, 1e-3) << between;
  };
  expectWay("nothing", [] {});
  expectWay("a hand that the wheel has led",
    [this] { this->Pointer(320, 160, vtkCommand::MouseWheelBackwardEvent); });
  expectWay("a camera that was rolled by half a turn and back",
    [this]
    {
      this->Renderer->GetActiveCamera()->Roll(30.0);
      this->Pointer(320, 160);
      this->Renderer->GetActiveCamera()->Roll(-30.0);
    });
  // This observer represents another part of the window, which consumes motions.
  vtkNew<vtkCallbackCommand> other;
  other->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  other->AbortFlagOnExecuteOn();
  const double before = tip[0];
  this->Interactor->AddObserver(vtkCommand::MouseMoveEvent, other, 20.0f);
  this->Pointer(400, 160);
  this->Interactor->RemoveObserver(other);
  this->Pointer(401, 160);
  this->Rest();
  EXPECT_LT(std::abs(tip[0] - before), 0.3) << "a motion of one pixel";
}

TEST_F(HeldHand, StaysUntilAClick)
{
  this->Touch(320, 160);
  const double* const tip = this->Device->GetState()->GetTipPosition();
  const double start[3] = { tip[0], tip[1], tip[2] };
  const auto expectMotion = [&](double wanted, const char* what)
  {
    this->Rest();
    const double moved[3] = { tip[0] - start[0], tip[1] - start[1], tip[2] - start[2] };
    EXPECT_NEAR(Length(moved), wanted, 1e-3) << what;
  };
  const auto click = [this]
  {
    this->Pointer(400, 160, vtkCommand::LeftButtonPressEvent);
    this->Run(5);
    EXPECT_EQ(this->Device->GetState()->GetButtons(), 0);
    this->Pointer(400, 160, vtkCommand::LeftButtonReleaseEvent);
  };
  this->Style->SetHoldClicks(2);
  this->Pointer(325, 160);
  expectMotion(1.0, "it is not held yet");
  click();
  this->Pointer(400, 160);
  this->Pointer(400, 160, vtkCommand::MouseWheelForwardEvent);
  expectMotion(1.0, "it is held");
  click();
  EXPECT_EQ(this->Style->GetHoldClicks(), 0);
  this->Pointer(405, 160);
  expectMotion(2.0, "it goes on from where it was");
  this->Style->SetHoldClicks(1);
  this->Style->TouchModeOff();
  EXPECT_EQ(this->Style->GetHoldClicks(), 0) << "the end of a touch frees it";
}

TEST_F(HeldHand, GoesOnFromWhereItIsIfThePictureHasChangedMeanwhile)
{
  this->Touch(320, 160);
  const double* const tip = this->Device->GetState()->GetTipPosition();
  const double start[3] = { tip[0], tip[1], tip[2] };
  this->Style->SetHoldClicks(1);
  this->Press("u");
  this->Window->Render();
  ASSERT_GT(this->Distance(320, 160), 50.0) << "the picture is narrower";
  this->Style->SetHoldClicks(0);
  this->Pointer(321, 160);
  this->Rest();
  const double moved[3] = { tip[0] - start[0], tip[1] - start[1], tip[2] - start[2] };
  EXPECT_NEAR(Length(moved), 0.2, 0.1) << "a pixel's way";
}

TEST_F(HeldHand, IsSaidToBeOutsideTheView)
{
  this->Touch(320, 160);
  const auto isHinted = [this]
  { return std::string(this->Display->GetHint()).find("outside the view") != std::string::npos; };
  this->Run(2);
  EXPECT_FALSE(isHinted()) << this->Display->GetHint();
  this->Renderer->GetActiveCamera()->SetFocalPoint(100.0, 0.0, 0.0);
  this->Renderer->GetActiveCamera()->SetPosition(100.0, 0.0, 200.0);
  this->Run(2);
  EXPECT_TRUE(isHinted()) << this->Display->GetHint();
  EXPECT_NE(std::string(this->Display->GetHint()).find("Escape lets go"), std::string::npos);
}
