// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the key that selects the next method while the hand touches the ball. */

#include "StyleRig.h"
#include "VTK/Scene/Display/DisplayProbe.h"

#include <vtkDataArray.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticMode.h>
#include <vtkStringArray.h>

using namespace scenetest;

namespace
{
class StyleMethod : public StyleTest
{
protected:
  StyleMethod()
  {
    this->Filter->SetForceFieldGain(0.01); // 1 N at the ball's gradient of 100 per mm
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
  /// Waits until the servo uses the published model.
  void Settle()
  {
    this->Device->UpdateState();
    this->Run(10);
  }
  /// Expects this force (N) in the servo's newest state.
  void ExpectForce(double x, double y, double z)
  {
    const double* const force = this->Device->GetState()->GetComputedForce();
    EXPECT_NEAR(force[0], x, 0.02);
    EXPECT_NEAR(force[1], y, 0.02);
    EXPECT_NEAR(force[2], z, 0.02);
  }

  vtkNew<vtkHapticHeadUpDisplay> Display;
  MessageLog FilterLog{ this->Filter };
};
} // namespace

TEST_F(StyleMethod, GoesThroughAllMethodsAndBack)
{
  vtkNew<vtkHapticMode> surfaces;
  surfaces->SetKindToSurface();
  this->Filter->AddMode(surfaces);
  this->Touch();
  vtkStringArray* const names = vtkVolumeHapticsFilter::GetMethodNames();
  std::vector<std::string> shown;
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    EXPECT_EQ(this->Filter->GetMethodName(), names->GetValue(i));
    shown.push_back(VolumeHaptics::DisplayProbe::GetPlotTitle(this->Display));
    this->Press("m");
    EXPECT_STREQ(this->Display->GetNotice(), "");
  }
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::PROXY);
  EXPECT_EQ(this->Filter->GetSolver(), vtkVolumeHapticsFilter::PRECISE);
  shown.resize(4); // discards the methods after these four
  EXPECT_EQ(shown,
    (std::vector<std::string>{ "Proxy, PRECISE", "Proxy, PAPER", "Force field", "Surface proxy" }));
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(StyleMethod, TheServoFeelsWithTheMethodAtOnce)
{
  this->Touch();
  const double depth = 30.0 - this->Device->GetState()->GetTipPosition()[2];
  this->Filter->SetMethodToForceField();
  this->Style->UpdateHaptics();
  EXPECT_EQ(VolumeHaptics::DisplayProbe::GetPlotTitle(this->Display), "Force field")
    << "also when it was not the key";
  this->Settle();
  this->ExpectForce(0.0, 0.0, 1.0);
  this->Press("m");
  this->Settle();
  EXPECT_NEAR(this->Device->GetState()->GetProxyPosition()[2], 30.5, 0.02)
    << "a sphere of half a voxel";
  this->ExpectForce(0.0, 0.0, 0.5 * (depth + 0.5)); // the spring has 500 N/m
}

TEST_F(StyleMethod, TheForceGoesOverWithoutAJolt)
{
  this->Touch();
  std::vector<double> last;
  double jolt = 0.0;
  double fall = 0.0;
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
    fall = std::max(fall, last.empty() ? 0.0 : Length(last.data()) - norm);
    last.assign(now, now + 3);
  };
  this->Filter->SetForceFieldGain(0.08); // results in 8 N; the other methods have about 1 N
  for (vtkIdType i = vtkVolumeHapticsFilter::GetMethodNames()->GetNumberOfValues(); i > 0; --i)
  {
    EXPECT_TRUE(this->Style->NextMethod());
    this->Run(30, watch);
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  }
  EXPECT_GT(fall, 0.4) << "there was something to go over";
  EXPECT_LE(jolt, 1e-3 * this->Device->GetMaximumForceRate() + 1e-9);
}

TEST_F(StyleMethod, AKeyFeelsOneModeAfterAnotherAndThenAll)
{
  const auto shown = [this]
  {
    std::string modes;
    for (int i = 0; i < this->Filter->GetNumberOfModes(); ++i)
    {
      modes += this->Filter->GetMode(i)->GetActive() ? '+' : '-';
    }
    return modes;
  };
  vtkNew<vtkHapticMode> surfaces;
  surfaces->SetKindToSurface();
  this->Filter->AddMode(surfaces);
  vtkNew<vtkHapticMode> ridge;
  ridge->SetKindToRidge();
  // without strength, so that only the surface exerts a force
  ridge->GetStrength()->AddPoint(0.0, 0.0);
  this->Filter->AddMode(ridge);
  this->Touch();
  this->Press("j");
  EXPECT_EQ(shown(), "++") << "not the method";
  this->Filter->SetMethodToPrimitives();
  this->Style->UpdateHaptics();
  this->Settle();
  EXPECT_GT(Length(this->Device->GetState()->GetModeForce(0)), 0.5);
  EXPECT_EQ(Length(this->Device->GetState()->GetModeForce(1)), 0.0);
  EXPECT_EQ(Length(this->Device->GetState()->GetModeForce(-1)) +
      Length(this->Device->GetState()->GetModeForce(8)),
    0.0);
  EXPECT_NEAR(Length(this->Device->GetState()->GetModeForce(0)),
    Length(this->Device->GetState()->GetComputedForce()), 1e-12);
  const vtkSmartPointer<vtkTable> plot = VolumeHaptics::DisplayProbe::CopyPlot(this->Display);
  auto* const curve = vtkDataArray::SafeDownCast(plot->GetColumnByName("1 surface"));
  ASSERT_TRUE(curve);
  const vtkIdType last = curve->GetNumberOfTuples() - 1;
  EXPECT_NEAR(curve->GetComponent(last, 0), Length(this->Device->GetState()->GetModeForce(0)), 0.1);
  for (const char* const wanted : { "+-", "-+", "++" })
  {
    this->Press("j");
    EXPECT_EQ(shown(), wanted);
    this->Settle();
    // The tip is inside the ball, so a reactivated surface exerts a force only after the hand
    // moves.
    EXPECT_EQ(Length(this->Device->GetState()->GetModeForce(0)) > 0.5, wanted[1] == '-') << wanted;
  }
  // Switching to modes that can't be used must fail, and leave the modes unchanged.
  vtkNew<vtkHapticMode> follow;
  follow->ActiveOff();
  this->Filter->AddMode(follow);
  this->Style->UpdateHaptics();
  // press the key, which selects only the second of three modes, then only the first
  this->Press("j");
  this->Press("j");
  EXPECT_EQ(shown(), "-+-");
  EXPECT_STREQ(this->Display->GetNotice(), "");
  this->Press("j");
  EXPECT_EQ(shown(), "-+-");
  EXPECT_NE(std::string(this->Display->GetNotice()).find("can't be felt"), std::string::npos);
  EXPECT_EQ(this->FilterLog.Errors.size(), 1U);
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  // Three surfaces together exceed the eight primitives of a tick, so the key selects only the
  // first surface.
  this->Filter->RemoveAllModes();
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkHapticMode> surface;
    surface->SetKindToSurface();
    surface->SetActive(i == 0);
    this->Filter->AddMode(surface);
  }
  this->Style->UpdateHaptics();
  for (const char* const wanted : { "-+-", "--+", "+--" })
  {
    this->Press("j");
    EXPECT_EQ(shown(), wanted);
    EXPECT_STREQ(this->Display->GetNotice(), "");
  }
  EXPECT_EQ(this->FilterLog.Errors.size(), 1U);
}
