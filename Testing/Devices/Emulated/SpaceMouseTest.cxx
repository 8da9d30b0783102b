// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests sessions with six-axis mice: the cap moves a virtual tip and rotates the view, and no force
 * is exerted.
 */

#include "DeviceBench.h"
#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/SpaceMouseModel.h"

#include <gtest/gtest.h>

using namespace emulated;

namespace
{
constexpr double Edge = 0.1; ///< m, radius of the ball in which the tip stays

class SpaceMice : public testing::TestWithParam<bool>
{
protected:
  bool Reaches(const Vector3& tip)
  {
    return Eventually([&] { return Norm(this->Bench.State().Record.Tip - tip) < 1e-6; });
  }
  bool Turns(const Vector3& turn)
  {
    return Eventually([&] { return Norm(this->Bench.State().Turn - turn) < 1e-9; });
  }
  /// Pushes the cap, then releases it. Returns the path (m) of the tip.
  Vector3 Go(const SpaceMouseModel::Counts& counts)
  {
    const Vector3 from = this->Bench.State().Record.Tip;
    this->Model.Push(counts);
    EXPECT_TRUE(Eventually([&] { return Norm(this->Bench.State().Record.Tip - from) > 0.01; }));
    this->Model.Push({});
    Vector3 last = from;
    EXPECT_TRUE(Eventually(
      [&]
      {
        const bool rests = Norm(this->Bench.State().Record.Tip - last) == 0.0;
        last = this->Bench.State().Record.Tip;
        return this->Bench.WaitForTicks(20) && rests;
      }));
    return last - from;
  }

  SpaceMouseModel Model{ GetParam() };
  EmulatedHid Hid{ this->Model };
  ModelClock Clock{ [this] { this->Model.Step(); } };
  Floor Ground{ 0.0 };
  DeviceBench Bench;
};
} // namespace

TEST_P(SpaceMice, PushesMoveTheTipAndTurnsTurn)
{
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].Id, "spacemouse:0");
  EXPECT_EQ(all[0].State, "available");
  ASSERT_TRUE(this->Bench.Open("spacemouse")) << this->Bench.Error;
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumForce, 0.0);
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
  EXPECT_TRUE(Eventually([&] { return this->Model.Light == 1; }));
  this->Bench.Start(this->Ground.Model);
  SafetyLimits limits = QuickLimits();
  limits.MaximumForce = this->Bench.Device->GetLimits().MaximumForce;
  this->Bench->SetLimits(limits);
  ASSERT_TRUE(this->Bench.WaitForTicks(20));
  this->Bench->Arm();

  // The device's x, y and z point to the right, towards the hand and down. The ratio of the rates
  // stays the same.
  const double half = (175.0 / 350.0 - 0.03) / 0.97;
  const Vector3 way = this->Go({ 350, 175, 0, 0, 0, 0 });
  EXPECT_NEAR(way.Z / way.X, half, 1e-9);
  EXPECT_EQ(way.Y, 0.0);
  this->Model.Push({ 0, 0, 350, 0, 0, 0 });
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Record.Tip.Y < -0.03; }));
  // Push away from the hand, into the floor: the servo computes a force, but sends none.
  this->Model.Push({ 0, -350, 0, 0, 0, 0 });
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Record.Force.Z > 1.0; }));
  EXPECT_TRUE(this->Bench.State().IsArmed());
  EXPECT_EQ(Norm(this->Bench.State().Command), 0.0);
  this->Model.Push({ 0, 0, -350, 0, 0, 0 });
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Record.Tip.Y > 0.95 * Edge; }));
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Reaches({ 0.0, Edge, 0.0 })) << "from the middle straight up";
  EXPECT_FALSE(this->Bench.State().IsArmed());
  this->Bench->Arm();

  this->Model.Push({ 0, 0, 0, 350, 0, 0 });
  EXPECT_TRUE(this->Turns({ 1.0, 0.0, 0.0 }));
  this->Model.Push({ 0, 0, 0, 0, -350, 175 });
  EXPECT_TRUE(this->Turns({ 0.0, -half, -1.0 }));
  this->Model.Push({});
  EXPECT_TRUE(this->Turns({}));
  this->Model.Press(2);
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Buttons == 2; }));
  EXPECT_TRUE(this->Bench.WaitForTicks(5000));
  EXPECT_EQ(this->Bench.State().GetFault(), GateReason::None);
  this->Bench.Device->SetLights(0);
  EXPECT_TRUE(Eventually([&] { return this->Model.Light == 0; }));
  this->Bench.Device->SetLights(1);
  EXPECT_TRUE(Eventually([&] { return this->Model.Light == 1; }));

  this->Hid.Unplug();
  EXPECT_TRUE(this->Bench.WaitForFault(GateReason::DeviceLost));
  EXPECT_TRUE(this->Bench.WaitForText("was unplugged."));
  this->Model.Push({});
  this->Hid.PlugIn();
  this->Bench.ExpectBack();
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  ASSERT_TRUE(this->Bench.WaitForTicks(20));
  this->Bench->Arm();
  ASSERT_TRUE(Eventually([&] { return this->Bench.State().IsArmed(); }));
  this->Model.Push({ -350, 0, 0, 0, 0, 0 });
  EXPECT_TRUE(this->Reaches({ -Edge, 0.0, 0.0 }))
    << this->Bench.State().Record.Tip.X << " " << this->Bench.State().Record.Tip.Y << " "
    << this->Bench.State().Record.Tip.Z << " " << this->Bench.Text();
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_EQ(this->Model.Light, 0);
}

INSTANTIATE_TEST_SUITE_P(OldAndNew, SpaceMice, testing::Bool());

TEST(SpaceMouseModels, AnOlderOnesUpIsUpAndTheEnterprisesKeysAreHeld)
{
  using Kind = SpaceMouseModel::Kind;
  for (const Kind kind : { Kind::Navigator, Kind::PlusXt, Kind::Compact, Kind::Enterprise })
  {
    SpaceMouseModel model(kind);
    const EmulatedHid hid(model);
    const ModelClock clock([&model] { model.Step(); });
    DeviceBench bench;
    ASSERT_TRUE(bench.Open("spacemouse")) << model.GetName() << ": " << bench.Error;
    ASSERT_TRUE(bench.WaitFor(DeviceStage::Ready));
    const auto sampleWhere = [&bench](auto&& holds)
    {
      return Eventually(
        [&]
        {
          DeviceSample sample;
          bench.Device->Read(0.001, sample);
          return holds(sample);
        });
    };
    // Push upwards, then towards the hand.
    const bool isUp = kind == Kind::PlusXt;
    const std::int16_t less = -350;
    model.Push(isUp ? SpaceMouseModel::Counts{ 0, 350, 0, 0, 0, 0 }
                    : SpaceMouseModel::Counts{ 0, 0, less, 0, 0, 0 });
    EXPECT_TRUE(sampleWhere([](const DeviceSample& s) { return s.Tip.Y > 0.02; }));
    model.Push(isUp ? SpaceMouseModel::Counts{ 0, 0, less, 0, 0, 0 }
                    : SpaceMouseModel::Counts{ 0, 350, 0, 0, 0, 0 });
    EXPECT_TRUE(sampleWhere([](const DeviceSample& s) { return s.Tip.Z > 0.02; }));
    if (kind == Kind::Enterprise)
    {
      model.PressKey(176); // Space
      EXPECT_TRUE(sampleWhere([](const DeviceSample& s) { return s.Buttons == 1U << 30; }));
      model.PressKey(0);
      EXPECT_TRUE(sampleWhere([](const DeviceSample& s) { return s.Buttons == 0; }));
    }
  }
}
