// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a scene with several volumes, each with its own filter. The volumes are balls with a radius
 * of 30 mm, so a contact identifies the ball's centre.
 */

#include "StyleRig.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkMultiVolume.h>
#include <vtkVolume.h>

#include <algorithm>
#include <cmath>

using namespace scenetest;

namespace
{
class StyleSeveral : public StyleTest
{
protected:
  StyleSeveral()
  {
    this->OtherFilter->GetProperty()->DeepCopy(this->Filter->GetProperty());
    this->Show(this->Volume, this->Ball);
    this->Show(this->Other, MakeBall());
    this->Renderer->GetActiveCamera()->SetParallelScale(150.0); // makes a pixel 1 mm wide
    // Disable the attention time, which a busy machine may exceed.
    this->Device->SetAttentionTime(0.0);
    this->Device->Open("virtual");
    this->Device->Start();
    this->Style->TouchVolume(this->Volume);
  }
  void Show(vtkVolume* volume, vtkImageData* image)
  {
    vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
    mapper->SetInputData(image);
    volume->SetMapper(mapper);
    ShowBall(volume);
    this->Renderer->AddVolume(volume);
  }
  /// Places the other volume beside the first one, and touches the other volume with the mouse.
  bool TouchOtherBeside()
  {
    this->Other->SetPosition(70.0, 0.0, 0.0);
    EXPECT_TRUE(this->Style->AddTouchedVolume(this->Other, this->OtherFilter));
    this->Pointer(150 + 70, 150);
    this->Style->TouchModeOn();
    this->Run(20);
    return this->FeelsOther();
  }
  /// Limits the surface strength of the other volume to 0.5 N.
  vtkPiecewiseFunction* WeakenOther()
  {
    vtkPiecewiseFunction* const strength = this->OtherFilter->GetProperty()->GetSurfaceStrength();
    strength->RemoveAllPoints();
    strength->AddPoint(0.0, 0.0);
    strength->AddPoint(0.1, 0.5);
    return strength;
  }
  bool RunUntilOtherIsFelt(bool isOther)
  {
    return Eventually(
      [=]
      {
        this->Style->UpdateHaptics();
        return this->FeelsOther() == isOther;
      });
  }
  bool FeelsOther() { return this->Device->GetVolumeHaptics() == this->OtherFilter; }
  /// Records the force of a state, and the largest step of the force in the 50 states after a
  /// switch to another volume.
  void Watch(vtkTable* states, vtkIdType row)
  {
    constexpr int after = 50; // states after a switch
    if (row == 0 && this->FeltOther != this->FeelsOther())
    {
      this->FeltOther = this->FeelsOther();
      this->Since = 0;
      ++this->Changes;
      this->ContactAtChange = states->GetValueByName(0, "Contact").ToInt();
    }
    double force[3];
    vtkDataArray::SafeDownCast(states->GetColumnByName("Force"))->GetTuple(row, force);
    if (++this->Since <= after)
    {
      const double step = std::sqrt(vtkMath::Distance2BetweenPoints(force, this->Force));
      this->LargestStep = std::max(this->LargestStep, step);
    }
    std::copy(force, force + 3, this->Force);
  }

  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolume> Other;
  vtkNew<vtkVolumeHapticsFilter> OtherFilter;
  double Force[3] = {};
  double LargestStep = 0.0; ///< N, largest change of the force
  bool FeltOther = true;
  int Changes = 0;
  int ContactAtChange = 0;
  int Since = 1000; ///< number of states since the last change
};
} // namespace

TEST_F(StyleSeveral, TheOneUnderThePointerIsTouched)
{
  this->Other->SetPosition(70.0, 0.0, 0.0);
  EXPECT_TRUE(this->Style->AddTouchedVolume(this->Other, this->OtherFilter));
  EXPECT_EQ(this->Style->GetNumberOfTouchedVolumes(), 2);
  this->Pointer(150 + 70, 150);
  this->Style->TouchModeOn();
  this->Run(20);
  EXPECT_TRUE(this->FeelsOther());
  EXPECT_EQ(this->Style->GetTouchedVolume(), this->Other);
  // The ball is visible up to a radius of 30 mm, and the hand starts half a voxel in front of it.
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[0], 70.0, 1.0);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 30.5, 0.3);
  this->Style->TouchModeOff();
  this->Pointer(150, 150);
  this->Style->TouchModeOn();
  this->Run(20);
  EXPECT_FALSE(this->FeelsOther());
  EXPECT_EQ(this->Style->GetTouchedVolume(), this->Volume);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 30.5, 0.3);
  EXPECT_TRUE(this->Log.Warnings.empty());
  this->Style->TouchVolume(this->Volume);
  EXPECT_EQ(this->Style->GetNumberOfTouchedVolumes(), 1) << "ends the others";
}

TEST_F(StyleSeveral, EachPortOfAMultiVolumeIsTouched)
{
  this->Renderer->RemoveVolume(this->Volume);
  this->Renderer->RemoveVolume(this->Other);
  vtkNew<vtkMultiVolume> multi;
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  vtkNew<vtkVolume> ports[3];
  const auto add = [&](int port)
  {
    mapper->SetInputDataObject(port, port == 0 ? this->Ball.Get() : MakeBall().Get());
    multi->SetVolume(ports[port], port);
    ShowBall(ports[port]);
    ports[port]->SetPosition(70.0 * port, 0.0, 0.0);
  };
  EXPECT_FALSE(this->Style->TouchVolume(multi)) << "it shows nothing";
  EXPECT_EQ(this->Log.Errors.size(), 1U);
  this->Log.Errors.clear();
  multi->SetMapper(mapper);
  add(0);
  add(1);
  this->Renderer->AddVolume(multi);
  EXPECT_TRUE(this->Style->TouchVolume(multi));
  EXPECT_EQ(this->Style->GetNumberOfTouchedVolumes(), 2);
  // Later changes of settings must apply to every port.
  this->Filter->SetKernelRadius(3);
  for (const int port : { 1, 0 })
  {
    this->Pointer(150 + 70 * port, 150);
    this->Style->TouchModeOn();
    this->Run(20);
    EXPECT_EQ(this->Style->GetTouchedVolume(), ports[port]);
    EXPECT_EQ(this->Device->GetVolumeHaptics() == this->Filter, port == 0);
    EXPECT_EQ(this->Device->GetVolumeHaptics()->GetKernelRadius(), 3);
    EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[0], 70.0 * port, 1.0);
    EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 30.5, 0.3);
    this->Style->TouchModeOff();
  }
  // Each port must have its own opacity and position, even after changes.
  ports[0]->SetPosition(0.0, 0.0, 10.0);
  this->Style->TouchModeOn();
  this->Run(20);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 40.5, 0.3);
  this->Style->TouchModeOff();
  add(2);
  this->Style->UpdateHaptics();
  EXPECT_EQ(this->Style->GetNumberOfTouchedVolumes(), 3);
  this->Pointer(150 + 140, 150);
  this->Style->TouchModeOn();
  this->Run(20);
  EXPECT_EQ(this->Style->GetTouchedVolume(), ports[2]);
  EXPECT_TRUE(this->Style->GetTouchMode());
  EXPECT_TRUE(this->Log.Warnings.empty());
  multi->VisibilityOff();
  this->Style->UpdateHaptics();
  EXPECT_FALSE(this->Style->GetTouchMode());
  ASSERT_EQ(this->Log.Warnings.size(), 1U);
  EXPECT_NE(this->Log.Warnings[0].find("Cure: VisibilityOn()"), std::string::npos);
}

TEST_F(StyleSeveral, AHandGoesFromOneToTheNextWithoutAStepOfForce)
{
  // The other volume is in front of the first one, with 10 mm of air between them. Its surface
  // yields at 0.5 N.
  this->Other->SetPosition(0.0, 0.0, 70.0);
  this->WeakenOther();
  EXPECT_TRUE(this->Style->AddTouchedVolume(this->Other, this->OtherFilter));
  this->Pointer(150, 150);
  this->Style->TouchModeOn();
  this->RunUntilFullyArmed();
  EXPECT_TRUE(this->FeelsOther());
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 100.5, 0.3);
  const auto see = [this](vtkTable* states, vtkIdType row) { this->Watch(states, row); };
  bool hasFeltOther = false;
  for (int i = 0; i < 120 && this->Device->GetState()->GetTipPosition()[2] > 28.0; ++i)
  {
    this->Pointer(150, 150, vtkCommand::MouseWheelForwardEvent);
    this->Run(20, see);
    hasFeltOther =
      hasFeltOther || (this->FeelsOther() && this->Device->GetState()->GetContact() != 0);
  }
  EXPECT_TRUE(hasFeltOther);
  EXPECT_FALSE(this->FeelsOther());
  EXPECT_EQ(this->Changes, 1);
  EXPECT_EQ(this->ContactAtChange, 0);
  EXPECT_LT(this->LargestStep, 0.02) << "N";
  EXPECT_NE(this->Device->GetState()->GetContact(), 0) << "the ball behind is touched";
  EXPECT_GT(vtkMath::Norm(this->Force), 1.0) << "500 N/m times 2 mm or more";
  EXPECT_TRUE(this->Style->GetTouchMode()) << "no fault";
}

TEST_F(StyleSeveral, TheStrongestOneIsFeltThroughAnother)
{
  // The other ball surrounds the first one, with a radius 5 mm larger, as in fused volumes. Its
  // surface yields at 0.5 N. A press of 4 mm at 500 N/m loads the first ball with 2 N.
  this->Other->SetScale(35.0 / 30.0);
  vtkPiecewiseFunction* const strength = this->WeakenOther();
  EXPECT_TRUE(this->Style->AddTouchedVolume(this->Other, this->OtherFilter));
  this->Style->SetFeltVolumeToStrongest();
  this->Pointer(150, 150);
  this->Style->TouchModeOn();
  this->Run(20);
  EXPECT_FALSE(this->FeelsOther());
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 30.5, 0.3)
    << "in front of the first one";
  this->Style->TouchModeOff();
  this->Style->SetFeltVolumeToNearest();
  this->Style->TouchModeOn();
  this->Run(20);
  EXPECT_TRUE(this->FeelsOther());
  EXPECT_GT(this->Device->GetState()->GetTipPosition()[2], 35.0);
  // The style must choose among the volumes in front of a hand in air.
  this->Style->TouchModeOff();
  this->Device->GetVirtualHand()->Place(0.0, 0.0, 60.0);
  this->Style->SetFeltVolumeToStrongest();
  ASSERT_TRUE(this->RunUntilOtherIsFelt(false));
  // If both volumes have equal strengths, the style must choose the one in front, which is the
  // other volume.
  strength->AddPoint(0.1, 8.0);
  this->Device->GetVirtualHand()->Place(0.0, 0.0, 55.0);
  ASSERT_TRUE(this->RunUntilOtherIsFelt(true));
}

TEST_F(StyleSeveral, OneThatIsNotSeenIsNotChosen)
{
  this->Other->SetPosition(0.0, 0.0, 70.0); // in front of the first volume
  EXPECT_TRUE(this->Style->AddTouchedVolume(this->Other, this->OtherFilter));
  this->Other->VisibilityOff();
  this->Pointer(150, 150);
  this->Style->TouchModeOn();
  this->Run(20);
  EXPECT_FALSE(this->FeelsOther());
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 30.5, 0.3);
}

TEST_F(StyleSeveral, InsteadOfOneThatIsHiddenTheOtherOneIsFelt)
{
  ASSERT_TRUE(this->TouchOtherBeside());
  this->Other->VisibilityOff();
  this->Style->UpdateHaptics();
  EXPECT_FALSE(this->Style->GetTouchMode());
  ASSERT_TRUE(this->RunUntilOtherIsFelt(false));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY)
    << "no other one comes under a hand that presses";
  ASSERT_EQ(this->Log.Warnings.size(), 1U);
  EXPECT_NE(this->Log.Warnings[0].find("hidden"), std::string::npos);
  this->Log.Warnings.clear();
  this->Pointer(150, 150);
  this->Style->TouchModeOn();
  EXPECT_TRUE(this->Style->GetTouchMode());
  EXPECT_TRUE(this->Log.Warnings.empty());
}

TEST_F(StyleSeveral, AnotherOneForAllIsFeltByTheFirstFilter)
{
  ASSERT_TRUE(this->TouchOtherBeside());
  this->Style->TouchModeOff();
  vtkImageData* const others = this->OtherFilter->GetTouchedImage();
  this->Style->TouchVolume(this->Volume);
  EXPECT_EQ(this->Device->GetVolumeHaptics(), this->Filter);
  EXPECT_EQ(this->OtherFilter->GetTouchedImage(), others) << "is left as it was";
}

TEST_F(StyleSeveral, WhatIsMissingIsTold)
{
  EXPECT_FALSE(this->Style->AddTouchedVolume(this->Other, nullptr));
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors.back().find("of its own"), std::string::npos);
  EXPECT_FALSE(this->Style->AddTouchedVolume(this->Other, this->Filter));
  ASSERT_EQ(this->Log.Errors.size(), 2U);
  EXPECT_NE(this->Log.Errors.back().find("feels another volume"), std::string::npos);
  vtkNew<vtkVolume> empty;
  EXPECT_FALSE(this->Style->AddTouchedVolume(empty, this->OtherFilter));
  ASSERT_EQ(this->Log.Errors.size(), 3U);
  EXPECT_EQ(this->Style->GetNumberOfTouchedVolumes(), 1);
  this->Log.Errors.clear();
}
