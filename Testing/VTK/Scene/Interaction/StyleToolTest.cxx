// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that Alt + mouse rotates a shaped tool if the device measures no orientation, and changes
 * nothing else.
 */

#include "StyleRig.h"

#include <vtkCubeSource.h>
#include <vtkHapticPointShell.h>
#include <vtkQuaternion.h>

using namespace scenetest;

namespace
{
class StyleTool : public StyleTest
{
protected:
  StyleTool()
  {
    vtkNew<vtkCubeSource> box;
    box->Update();
    this->Tool->SetMesh(box->GetOutput());
    this->Tool->SetNumberOfPoints(50);
  }
  void Begin()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Device->Start());
    this->Device->GetVirtualHand()->Place(0.0, 0.0, 60.0);
    this->Interactor->SetAltKey(0);
    this->Pointer(150, 150);
    this->Run(5);
  }
  void AltMove(int x, int y)
  {
    this->Interactor->SetAltKey(1);
    this->Pointer(x, y);
  }
  bool IsTurned(double angle, double x, double y, double z)
  {
    vtkQuaterniond wanted;
    wanted.SetRotationAngleAndAxis(angle, x, y, z);
    return Eventually(
      [&]
      {
        this->Style->UpdateHaptics();
        const double* const is = this->Device->GetState()->GetTipOrientation();
        double dot = 0.0;
        for (int c = 0; c < 4; ++c)
        {
          dot += is[c] * wanted.GetData()[c];
        }
        // The tolerance allows for the rounding errors of many small rotations.
        return this->Device->GetState()->HasTipOrientation() && std::abs(dot) > 1.0 - 1e-5;
      });
  }

  vtkNew<vtkHapticPointShell> Tool;
};
} // namespace

TEST_F(StyleTool, TheMouseTurnsItLikeABall)
{
  this->Filter->SetTool(this->Tool);
  this->Begin();
  EXPECT_FALSE(this->Device->GetState()->HasTipOrientation());
  EXPECT_NE(this->Style->GetKeys().find("Alt + mouse\tturn the tool"), std::string::npos);
  // A motion to the right must rotate the front of the tool to the right.
  for (int x = 151; x <= 170; ++x)
  {
    this->AltMove(x, 150);
  }
  EXPECT_TRUE(this->IsTurned(0.2, 0.0, 1.0, 0.0));
  EXPECT_FALSE(this->Device->GetState()->IsTipOrientationMeasured());
  for (int x = 169; x >= 150; --x)
  {
    this->AltMove(x, 150);
  }
  EXPECT_TRUE(this->IsTurned(0.0, 0.0, 1.0, 0.0));
  // A motion upwards rotates the tool about x, and the wheel rotates it about the line of sight.
  // With Shift, rotations are a fifth as large.
  for (int y = 151; y <= 160; ++y)
  {
    this->AltMove(150, y);
  }
  EXPECT_TRUE(this->IsTurned(-0.1, 1.0, 0.0, 0.0));
  for (int y = 159; y >= 150; --y)
  {
    this->AltMove(150, y);
  }
  this->Pointer(150, 150, vtkCommand::MouseWheelForwardEvent);
  EXPECT_TRUE(this->IsTurned(0.1, 0.0, 0.0, 1.0));
  this->Pointer(150, 150, vtkCommand::MouseWheelForwardEvent, 1);
  EXPECT_TRUE(this->IsTurned(0.12, 0.0, 0.0, 1.0));
}

TEST_F(StyleTool, TheTipStaysWhereItIs)
{
  this->Filter->SetTool(this->Tool);
  this->Interactor->SetAltKey(0);
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Pointer(150, 150);
  this->Style->TouchModeOn();
  this->Run(50);
  const double before[3] = { this->Device->GetState()->GetTipPosition()[0],
    this->Device->GetState()->GetTipPosition()[1], this->Device->GetState()->GetTipPosition()[2] };
  this->AltMove(180, 130);
  this->Run(100);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_EQ(this->Device->GetState()->GetTipPosition()[c], before[c]);
  }
  EXPECT_TRUE(this->Device->GetState()->HasTipOrientation());
  this->Interactor->SetAltKey(0);
  this->Pointer(190, 130);
  this->Run(100);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[0], before[0] + 2.0, 1e-6) << "10 pixels";
}

/// Starts with the tool, a box of 1 mm, in front of the ball, and presses it into the ball with the
/// wheel.
TEST_F(StyleTool, ItBeginsInFrontOfWhatIsTouched)
{
  this->Filter->SetTool(this->Tool);
  this->Interactor->SetAltKey(0);
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Pointer(150, 150);
  this->Style->TouchModeOn();
  this->RunUntilFullyArmed();
  // The tip starts half a box in front of the position at which a point would touch the surface.
  // That position is up to a kernel radius (2 mm) above the surface.
  EXPECT_GT(this->Device->GetState()->GetTipPosition()[2], 30.5);
  EXPECT_LT(this->Device->GetState()->GetTipPosition()[2], 33.5);
  EXPECT_EQ(this->Device->GetState()->GetContact(), 0);
  for (int i = 0; i < 8; ++i)
  {
    this->Pointer(150, 150, vtkCommand::MouseWheelForwardEvent);
    this->Run(30);
  }
  EXPECT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return Length(this->Device->GetState()->GetForce()) > 0.1;
    }));
  EXPECT_GT(this->Device->GetState()->GetForce()[2], 0.1);
}

TEST_F(StyleTool, APointAndAMeasuredHandAreNotTurned)
{
  this->Begin();
  this->AltMove(180, 150);
  this->Run(20);
  EXPECT_FALSE(this->Device->GetState()->HasTipOrientation()) << "there is no tool";
  this->Filter->SetTool(this->Tool);
  this->Device->GetVirtualHand()->SetOrientation(0.6, 0.8, 0.0, 0.0);
  this->Run(50);
  ASSERT_TRUE(this->Device->GetState()->IsTipOrientationMeasured());
  this->AltMove(210, 150);
  this->Run(50);
  EXPECT_NEAR(this->Device->GetState()->GetTipOrientation()[1], 0.8, 1e-12)
    << "the device knows it";
  EXPECT_EQ(this->Style->GetKeys().find("Alt + mouse"), std::string::npos);
}
