// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The key that goes on to the next method, while the ball is being touched.
 */

#include "StyleRig.h"

#include <vtkDataArray.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticSurfaceMode.h>
#include <vtkStringArray.h>

using namespace scenetest;

namespace
{
class StyleMethod : public StyleTest
{
protected:
  StyleMethod()
  {
    this->Filter->SetForceFieldGain(0.01); // 1 N at the ball's 100 a millimetre
    this->Display->SetDevice(this->Device);
    this->Style->SetHeadUpDisplay(this->Display);
  }
  /// The tip is 2 mm or so deep in the ball, and feels it.
  void Touch()
  {
    ASSERT_NO_FATAL_FAILURE(this->PushIn());
    this->Run(30);
    ASSERT_GT(Length(this->Device->GetForce()), 0.5);
  }
  /// Until what was published is felt.
  void Settle()
  {
    this->Device->UpdateState();
    this->Run(10);
  }
  /// The force that the servo computes by now.
  void ExpectForce(double x, double y, double z)
  {
    const double* const force = this->Device->GetComputedForce();
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
  this->Filter->AddMode(vtkNew<vtkHapticSurfaceMode>());
  this->Touch();
  vtkStringArray* const names = vtkVolumeHapticsFilter::GetMethodNames();
  std::vector<std::string> shown;
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    EXPECT_EQ(this->Filter->GetMethodName(), names->GetValue(i));
    shown.push_back(this->Display->GetPlotTitle());
    this->Press("m");
    EXPECT_STREQ(this->Display->GetNotice(), "");
  }
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::PROXY);
  EXPECT_EQ(this->Filter->GetSolver(), vtkVolumeHapticsFilter::PRECISE);
  shown.resize(4); // whatever comes after these
  EXPECT_EQ(shown,
    (std::vector<std::string>{ "Proxy, PRECISE", "Proxy, PAPER", "Force field", "Surface proxy" }));
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(StyleMethod, TheServoFeelsWithTheMethodAtOnce)
{
  this->Touch();
  const double depth = 30.0 - this->Device->GetTipPosition()[2];
  this->Filter->SetMethodToForceField();
  this->Style->UpdateHaptics();
  EXPECT_EQ(this->Display->GetPlotTitle(), "Force field") << "also when it was not the key";
  this->Settle();
  this->ExpectForce(0.0, 0.0, 1.0);
  this->Press("m");
  this->Settle();
  EXPECT_NEAR(this->Device->GetProxyPosition()[2], 30.5, 0.02) << "a sphere of half a voxel";
  this->ExpectForce(0.0, 0.0, 0.5 * (depth + 0.5)); // 500 N/m
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
    // Only growth along its own direction is limited: what falls or turns does so at once.
    const double norm = Length(now);
    if (!last.empty() && norm > 0.0)
    {
      const double along = (now[0] * last[0] + now[1] * last[1] + now[2] * last[2]) / norm;
      jolt = std::max(jolt, norm - std::max(0.0, along));
    }
    fall = std::max(fall, last.empty() ? 0.0 : Length(last.data()) - norm);
    last.assign(now, now + 3);
  };
  this->Filter->SetForceFieldGain(0.08); // against 1 N or so of the others
  for (vtkIdType i = vtkVolumeHapticsFilter::GetMethodNames()->GetNumberOfValues(); i > 0; --i)
  {
    EXPECT_TRUE(this->Style->NextMethod());
    this->Run(30, watch);
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  }
  EXPECT_GT(fall, 0.4) << "there was something to go over";
  EXPECT_LE(jolt, 1e-3 * this->Device->GetMaximumForceRate() + 1e-9);
}
