// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests two devices with one filter. Each must have exactly the force that it would have alone. A
 * fault, disarming or closing must affect only one hand. One hand has the tool, and the other hand
 * feels the removal.
 */

#include "Rigs/RecordingRig.h"

#include <vtkFloatArray.h>
#include <vtkHapticBurr.h>
#include <vtkHapticNeedle.h>
#include <vtkHapticRegionSource.h>
#include <vtkHapticRemoval.h>
#include <vtkPiecewiseFunction.h>

using namespace devicetest;

namespace
{
class TwoHands : public Recording
{
protected:
  TwoHands() { this->Other->SetVolumeHaptics(this->Filter); }

  /// Starts the other hand's servo with the tip outside the ramp.
  void BeginOther()
  {
    ASSERT_TRUE(this->Other->Open("virtual"));
    this->Other->GetVirtualHand()->SetPosition(4.0, 4.0, 5.0);
    ASSERT_TRUE(this->Other->Start());
    ASSERT_TRUE(this->WaitOther([] { return true; }));
  }
  template <typename F>
  bool WaitOther(F&& holds)
  {
    const vtkIdType end = this->Other->GetState()->GetTick() + 3;
    return Eventually(
      [&]
      {
        this->Device->UpdateState();
        this->Other->UpdateState();
        return this->Other->GetState()->GetTick() >= end && holds();
      });
  }
  /// Arms the other hand with its tip at z = `from` in the ramp, where the proxy starts, and moves
  /// the tip to z = `to` until `holds` is true. Retries, because a pause of the loop moves the
  /// proxy to the tip.
  template <typename F>
  bool PressOther(double from, double to, F&& holds)
  {
    vtkHapticVirtualHand* const hand = this->Other->GetVirtualHand();
    for (int attempt = 0; attempt < 20; ++attempt)
    {
      this->Other->Disarm();
      hand->SetPosition(4.0, 4.0, from);
      const bool isThere = this->WaitOther(
        [&] { return std::abs(this->Other->GetState()->GetTipPosition()[2] - from) < 1e-6; });
      this->Other->Arm();
      if (!isThere || !this->WaitOther([this] { return IsFullyArmed(this->Other); }))
      {
        return false;
      }
      hand->SetPosition(4.0, 4.0, to);
      const vtkIdType end = this->Other->GetState()->GetTick() + 300;
      bool does = false;
      this->WaitOther(
        [&] { return (does = holds()) || this->Other->GetState()->GetTick() >= end; });
      if (does)
      {
        return true;
      }
    }
    return false;
  }
  bool IsPressed() { return Length(this->Other->GetState()->GetForce()) > 0.5; }

  vtkNew<vtkHapticDevice> Other;
  MessageLog OtherLog{ this->Other };
};
} // namespace

TEST_F(TwoHands, EachHasTheForceThatItHasAlone)
{
  const std::string second = this->File("Second.vtp");
  this->Begin();
  this->BeginOther();
  this->StartRecording();
  ASSERT_TRUE(this->Other->GetRecorder()->Start(second.c_str()));
  for (int i = 0; i < 30; ++i)
  {
    const double t = 0.1 * i;
    this->Other->GetVirtualHand()->SetPosition(
      7.0 - 2.0 * std::sin(t), 7.0 + 3.0 * std::cos(t), 9.0 - 2.0 * std::cos(1.7 * t));
    this->Wander(1);
    this->Other->UpdateState();
  }
  ASSERT_TRUE(this->Other->GetRecorder()->Stop());
  this->Other->Stop();
  this->ExpectSame();
  // Let the filter compute the other hand's path without a device.
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(second.c_str());
  reader->Update();
  this->Filter->SetInputData(1, reader->GetOutput());
  this->Filter->Update();
  vtkDataArray* const felt = reader->GetOutput()->GetPointData()->GetArray("Force");
  vtkDataArray* const alone = this->Filter->GetOutput()->GetPointData()->GetArray("Force");
  ASSERT_GT(felt->GetNumberOfTuples(), 20);
  ASSERT_EQ(felt->GetNumberOfTuples(), alone->GetNumberOfTuples());
  double largest = 0.0;
  for (vtkIdType i = 0; i < felt->GetNumberOfTuples(); ++i)
  {
    double a[3];
    double b[3];
    felt->GetTuple(i, a);
    alone->GetTuple(i, b);
    ASSERT_EQ(std::memcmp(a, b, sizeof(a)), 0) << i;
    largest = std::max(largest, Length(a));
  }
  EXPECT_GT(largest, 0.5);
}

TEST_F(TwoHands, AFaultOrAnEndIsOneHands)
{
  this->BeginPressed();
  ASSERT_TRUE(this->Other->Open("virtual"));
  // A light tip with a distant target becomes faster than a hand can be, which is a fault.
  this->Other->GetVirtualHand()->SetDynamics(0.01, 4.0, 2000.0, 0.0, 0);
  this->Other->GetVirtualHand()->SetPosition(4.0, 4.0, 5.0);
  ASSERT_TRUE(this->Other->Start());
  this->Other->Arm();
  ASSERT_TRUE(this->WaitOther([this] { return IsFullyArmed(this->Other); }));
  this->Other->GetVirtualHand()->SetPosition(4.0, 600.0, 5.0);
  ASSERT_TRUE(
    this->WaitOther([this] { return this->Other->GetStatus() == vtkHapticDevice::FAULT; }));
  EXPECT_EQ(Length(this->Other->GetState()->GetForce()), 0.0);
  EXPECT_TRUE(this->WaitPressed());
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  this->Other->Close();
  EXPECT_TRUE(this->WaitPressed());
}

TEST_F(TwoHands, OneHoldsANeedleAndTheOtherAPoint)
{
  vtkNew<vtkHapticNeedle> needle;
  SetConstant(needle->GetShaftFriction(), 30.0);
  this->Filter->SetTool(needle);
  this->Other->UseToolOff();
  EXPECT_FALSE(this->Other->GetUseTool());
  this->Begin();
  this->BeginOther();
  // The expected force is that of the point at the end of a path to the hand.
  vtkNew<vtkVolumeHapticsFilter> plain;
  plain->SetInputData(0, this->Image);
  plain->GetProperty()->DeepCopy(this->Filter->GetProperty());
  std::vector<Point> path;
  for (int i = 0; i <= 300; ++i)
  {
    path.push_back({ 4.0, 4.0, std::min(5.0 + 0.1 * i, 8.0) });
  }
  plain->SetInputData(1, MakePath(path));
  plain->Update();
  const double expected =
    plain->GetOutput()->GetPointData()->GetArray("Force")->GetComponent(300, 2);
  EXPECT_LT(expected, -0.5);
  EXPECT_TRUE(this->PressOther(5.0, 8.0,
    [&] { return std::abs(this->Other->GetState()->GetComputedForce()[2] - expected) < 0.01; }))
    << this->Other->GetState()->GetComputedForce()[2] << " N, not " << expected;
  EXPECT_EQ(this->Other->GetState()->GetNeedleDepth(), 0.0);
  EXPECT_FALSE(this->Other->GetRecorder()->Start(this->File("No.vtp").c_str()));
  ASSERT_EQ(this->OtherLog.Errors.size(), 1U);
  EXPECT_NE(this->OtherLog.Errors[0].find("SetTool(nullptr)"), std::string::npos);
  this->OtherLog.Errors.clear();
  this->Filter->SetTool(nullptr); // the remedy
  ASSERT_TRUE(this->Other->Publish());
  ASSERT_TRUE(this->Other->GetRecorder()->Start(this->File("Point.vtp").c_str()));
  this->Filter->SetTool(needle);
  EXPECT_FALSE(this->Other->Publish()) << "the tool can't come into the recording";
  ASSERT_EQ(this->OtherLog.Errors.size(), 1U);
  EXPECT_NE(this->OtherLog.Errors[0].find("Stop() the recorder first"), std::string::npos);
  this->OtherLog.Errors.clear();
  EXPECT_TRUE(this->Other->GetRecorder()->Stop());
  EXPECT_TRUE(this->Other->Publish());
}

TEST_F(TwoHands, WhatOneRemovesTheOtherNoLongerFeels)
{
  vtkNew<vtkHapticBurr> burr;
  burr->SetRadius(2.5);
  burr->SetSolidToAbove();
  burr->SetContactValue(800.0);
  SetConstant(burr->GetSpecificEnergy(), 1.0);
  this->Filter->SetTool(burr);
  this->Begin();
  EXPECT_FALSE(this->Other->Open("virtual") && this->Other->Start()) << "two burrs";
  ASSERT_EQ(this->OtherLog.Errors.size(), 1U);
  EXPECT_NE(this->OtherLog.Errors[0].find("UseToolOff()"), std::string::npos);
  this->OtherLog.Errors.clear();
  this->Other->UseToolOff();
  this->BeginOther();
  ASSERT_TRUE(this->PressOther(8.0, 9.5, [this] { return this->IsPressed(); }));
  this->Device->Arm();
  this->Device->GetVirtualHand()->SpinningOn();
  this->Device->GetVirtualHand()->SetPosition(4.0, 4.0, 9.0);
  ASSERT_TRUE(this->WaitOther(
    [this]
    {
      return this->Filter->GetRemoval()->GetRemovedVolume() > 1.0 &&
        Length(this->Other->GetState()->GetForce()) < 0.1;
    }))
    << "what it pressed on is gone";
  this->Device->GetVirtualHand()->SpinningOff();
  this->Device->GetVirtualHand()->SetPosition(4.0, 4.0, 4.0);
  ASSERT_TRUE(this->WaitOther([this] { return !this->Device->GetState()->IsSpinning(); }));
  // Undo returns tissue around the other hand. The proxy then starts at the tip, so the tissue does
  // not push this hand.
  const std::string before = this->Other->GetStatusText();
  while (this->Filter->GetRemoval()->GetNumberOfUndos() > 0 && this->Filter->GetRemoval()->Undo())
  {
    ASSERT_TRUE(
      this->WaitOther([this] { return this->Filter->GetRemoval()->GetNumberOfRequests() == 0; }));
  }
  EXPECT_TRUE(this->Filter->GetRemoval()->IsEmpty());
  ASSERT_TRUE(this->WaitOther([] { return true; }));
  EXPECT_LT(Length(this->Other->GetState()->GetForce()), 0.1) << before;
  ASSERT_TRUE(this->PressOther(8.0, 9.5, [this] { return this->IsPressed(); }))
    << "it is there again";
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
}

TEST_F(TwoHands, OneLeadsTheRegionsOfALargeVolume)
{
  vtkNew<vtkHapticRegionSource> source;
  source->SetWholeExtent(0, 1999, 0, 1999, 0, 1999);
  source->SetScalarType(VTK_FLOAT);
  source->SetMemoryLimit(4194304);
  source->SetReader(
    [](const int box[6], void* samples)
    {
      auto* sample = static_cast<float*>(samples);
      for (int k = box[4]; k <= box[5]; ++k)
      {
        for (int n = (box[1] - box[0] + 1) * (box[3] - box[2] + 1); n > 0; --n)
        {
          *sample++ = 100.0F * static_cast<float>(k);
        }
      }
      return true;
    });
  this->Filter->SetInputConnection(0, source->GetOutputPort());
  this->Begin();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->GetResidency() == 1.0; }));
  this->BeginOther();
  ASSERT_TRUE(this->WaitOther([this] { return this->Other->GetState()->GetResidency() == 1.0; }))
    << "near the first hand";
  ASSERT_TRUE(this->Other->GetVirtualHand());
  this->Other->GetVirtualHand()->SetPosition(1500.0, 1500.0, 5.0);
  ASSERT_TRUE(this->WaitOther([this] { return this->Other->GetState()->GetResidency() == 0.0; }));
  EXPECT_NE(this->Other->GetStatusText().find("around the other hand"), std::string::npos);
  EXPECT_EQ(this->Device->GetState()->GetResidency(), 1.0);
  this->Device->Stop();
  ASSERT_TRUE(this->WaitOther([this] { return this->Other->GetState()->GetResidency() == 1.0; }))
    << "the regions follow the hand that is left";
  this->Other->Stop();
  ASSERT_TRUE(this->Device->Start());
  ASSERT_TRUE(this->Other->Start());
  this->Other->UpdateState();
  EXPECT_NE(this->Other->GetStatusText().find("around the other hand"), std::string::npos)
    << "whichever is looked at first";
}
