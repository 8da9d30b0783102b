// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the key that compares two settings while the hand touches the ball. The ball is
 * impenetrable, so the force is the stiffness times the distance from tip to proxy.
 */

#include "StyleRig.h"

#include <vtkDataArray.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticLabelTable.h>

using namespace scenetest;

namespace
{
class StyleCompare : public StyleTest
{
protected:
  StyleCompare()
  {
    this->Display->SetDevice(this->Device);
    this->Style->SetHeadUpDisplay(this->Display);
  }
  /// Presses the tip about 2 mm into the ball, and expects a force.
  void Touch()
  {
    ASSERT_NO_FATAL_FAILURE(this->PushIn());
    this->Run(30);
    ASSERT_GT(Length(this->Device->GetState()->GetForce()), 0.5);
  }
  void Settle(vtkIdType ticks = 30)
  {
    this->Device->UpdateState();
    this->Run(ticks);
  }
  /// Moves the tip 8 mm out of the ball, and back to the same position.
  void LiftAndPress()
  {
    constexpr int steps = 8; // steps of 1 mm
    for (const auto event :
      { vtkCommand::MouseWheelBackwardEvent, vtkCommand::MouseWheelForwardEvent })
    {
      for (int i = 0; i < steps; ++i)
      {
        this->Pointer(150, 150, event);
        this->Run(15);
      }
    }
    this->Settle();
  }
  bool Shows(const char* words)
  {
    return this->Display->GetText().find(words) != std::string::npos;
  }
  double Spring(double stiffness)
  {
    const double lag = this->Device->GetState()->GetProxyPosition()[2] -
      this->Device->GetState()->GetTipPosition()[2];
    return stiffness * 1e-3 * lag;
  }

  vtkNew<vtkHapticHeadUpDisplay> Display;
  MessageLog FilterLog{ this->Filter };
};
} // namespace

TEST_F(StyleCompare, TwoStiffnessesAreFeltOnOneSpot)
{
  this->Touch();
  EXPECT_EQ(this->Style->GetComparedSettings(), "");
  EXPECT_FALSE(this->Shows("Settings"));
  this->Press("y");
  EXPECT_EQ(this->Style->GetComparedSettings(), "B");
  EXPECT_TRUE(this->Shows("Settings B")) << this->Display->GetText();
  const double before = Length(this->Device->GetState()->GetComputedForce());
  EXPECT_NEAR(before, this->Spring(500.0), 0.02) << "B begins as A";
  const double surface = this->Device->GetState()->GetProxyPosition()[2];

  vtkPiecewiseFunction* const k = this->Filter->GetProperty()->GetStiffness();
  k->AddPoint(0.0, 200.0);
  this->Style->UpdateHaptics();
  this->Settle();
  EXPECT_NEAR(Length(this->Device->GetState()->GetComputedForce()), this->Spring(200.0), 0.02);
  for (int i = 0; i < 2; ++i)
  {
    for (const auto& [name, stiffness] : { std::pair{ "A", 500.0 }, std::pair{ "B", 200.0 } })
    {
      SCOPED_TRACE(name);
      const double force = Length(this->Device->GetState()->GetComputedForce());
      this->Press("y");
      this->Settle();
      EXPECT_EQ(this->Style->GetComparedSettings(), name);
      EXPECT_TRUE(this->Shows((std::string("Settings ") + name).c_str()));
      EXPECT_EQ(this->Filter->GetProperty()->GetStiffness(), k) << "an editor keeps its function";
      EXPECT_LE(Length(this->Device->GetState()->GetComputedForce()), force + 0.01)
        << "a hand that rests is not pushed out";
      this->LiftAndPress();
      EXPECT_NEAR(
        Length(this->Device->GetState()->GetComputedForce()), this->Spring(stiffness), 0.02);
      EXPECT_NEAR(this->Device->GetState()->GetProxyPosition()[2], surface, 0.1)
        << "where it was held";
    }
  }
  EXPECT_STREQ(this->Display->GetNotice(), "");
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(StyleCompare, MethodsPresetsAndLabelsArePartOfThem)
{
  vtkNew<vtkHapticLabelTable> table;
  table->SetFriction(3, 0.3);
  this->Filter->SetLabelTable(table);
  this->Touch();
  EXPECT_TRUE(this->Style->SwapSettings());
  this->Filter->SetMethodToForceField();
  this->Filter->SetKernelRadius(3);
  this->Filter->SetTraceArrays("Force");
  this->Filter->GetProperty()->SetSurfaceSideToBoth();
  table->SetFriction(3, 0.9);
  this->Style->UpdateHaptics();
  EXPECT_TRUE(this->Style->SwapSettings());
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::PROXY);
  EXPECT_EQ(this->Filter->GetKernelRadius(), 2);
  EXPECT_EQ(this->Filter->GetTraceArrays(), "all");
  EXPECT_EQ(this->Filter->GetProperty()->GetSurfaceSide(), vtkHapticProperty::HIGHER);
  EXPECT_EQ(table->GetFriction(3), 0.3);
  EXPECT_TRUE(this->Style->SwapSettings());
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::FORCE_FIELD);
  EXPECT_EQ(this->Filter->GetKernelRadius(), 3);
  EXPECT_EQ(this->Filter->GetTraceArrays(), "Force");
  EXPECT_EQ(table->GetFriction(3), 0.9);
  this->Style->EndComparison();
  EXPECT_EQ(this->Style->GetComparedSettings(), "");
  EXPECT_FALSE(this->Shows("Settings"));
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::FORCE_FIELD) << "those of now stay";
}

TEST_F(StyleCompare, TheForceGoesOverWithoutAJolt)
{
  this->Touch();
  std::vector<double> last;
  double jolt = 0.0;
  double most = 0.0;
  double least = 1e9;
  const auto watch = [&](vtkTable* states, vtkIdType i)
  {
    double now[3];
    vtkDataArray::SafeDownCast(states->GetColumnByName("Command"))->GetTuple(i, now);
    // The slew limit applies to growth along the force's own direction. A force may decrease or
    // change its direction at once.
    const double norm = Length(now);
    if (!last.empty() && norm > 0.0)
    {
      const double along = (now[0] * last[0] + now[1] * last[1] + now[2] * last[2]) / norm;
      jolt = std::max(jolt, norm - std::max(0.0, along));
    }
    most = std::max(most, norm);
    least = std::min(least, norm);
    last.assign(now, now + 3);
  };
  this->Press("y");
  this->Filter->GetProperty()->GetStiffness()->AddPoint(0.0, 150.0);
  this->Style->UpdateHaptics();
  for (int i = 0; i < 6; ++i)
  {
    this->Press("y");
    this->Run(60, watch);
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  }
  EXPECT_GT(most - least, 0.3) << "there was something to go over";
  EXPECT_LE(jolt, 1e-3 * this->Device->GetMaximumForceRate() + 1e-9);
}

TEST_F(StyleCompare, SettingsThatCantBeFeltStayAway)
{
  this->Touch();
  this->Press("y");
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(1e9); // no sample has this value, so no surface exists
  this->Style->UpdateHaptics();   // the servo keeps the previous model
  this->Press("y");
  EXPECT_EQ(this->Style->GetComparedSettings(), "A");
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::PROXY);
  this->Settle();
  this->Log.Errors.clear();
  EXPECT_FALSE(this->Style->SwapSettings());
  EXPECT_EQ(this->Style->GetComparedSettings(), "A");
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::PROXY);
  EXPECT_EQ(this->Filter->GetIsoValue(), 0.0);
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("Settings B can't be felt here"), std::string::npos);
  EXPECT_NE(std::string(this->Display->GetNotice()).find("can't be felt"), std::string::npos);
  this->Settle();
  EXPECT_NEAR(Length(this->Device->GetState()->GetComputedForce()), this->Spring(500.0), 0.02);
}

TEST_F(StyleCompare, AnotherFilterOrDeviceBeginsAnew)
{
  EXPECT_TRUE(this->Style->SwapSettings()) << "also without a servo";
  EXPECT_EQ(this->Style->GetComparedSettings(), "B");
  vtkNew<vtkVolumeHapticsFilter> other;
  this->Device->SetVolumeHaptics(other);
  EXPECT_EQ(this->Style->GetComparedSettings(), "");
  EXPECT_TRUE(this->Style->SwapSettings());
  EXPECT_EQ(this->Style->GetComparedSettings(), "B");
  this->Style->SetDevice(nullptr);
  EXPECT_EQ(this->Style->GetComparedSettings(), "");
  this->Log.Errors.clear();
  EXPECT_FALSE(this->Style->SwapSettings());
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("SetVolumeHaptics()"), std::string::npos);
  this->Press("y"); // has no effect
  EXPECT_EQ(this->Log.Errors.size(), 1U);
}
