// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests sessions with gamepads: sticks move the tip, and the motors turn when the force changes.
 */

#include "DeviceBench.h"
#include "Devices/Pad/EvdevRumble.h"
#include "Emulators/EmulatedEvdev.h"
#include "Emulators/ModelClock.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

using namespace emulated;

namespace
{
constexpr double FullSpeed = 65535.0;

class Pads : public testing::TestWithParam<PadModel::Kind>
{
protected:
  void Begin() { this->Bench.Begin("vibration:pad", this->Ground.Model); }

  PadModel Model{ GetParam() };
  EmulatedEvdev Evdev{ this->Model };
  ModelClock Clock{ [this] { this->Model.Step(); } };
  Floor Ground{ -0.02 };
  DeviceBench Bench;
};
} // namespace

TEST_P(Pads, AreListedForWhatTheyAre)
{
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].Id, "vibration:pad:0");
  EXPECT_EQ(
    all[0].Name, this->Model.GetName() + " (" + this->Evdev.GetNode() + "): vibration, not force");
  EXPECT_EQ(all[0].State, "available");
  EXPECT_EQ(all[0].Identity, "") << "there are no signs to confirm and no newtons to calibrate";
  ASSERT_TRUE(this->Bench.Open("vibration:pad:0")) << this->Bench.Error;
  EXPECT_TRUE(Has(this->Bench.Device->GetName(), "vibration, not force"));
  const DeviceLimits limits = this->Bench.Device->GetLimits();
  EXPECT_TRUE(limits.Vibrates);
  EXPECT_FALSE(limits.MovesTip);
  EXPECT_TRUE(Has(ListDevices()[0].State, "in use: another program"));
  EXPECT_TRUE(Has(ErrorOf("vibration:pad"), "in use: another program"));
}

TEST_P(Pads, SticksAndTriggersLeadTheTip)
{
  this->Begin();
  const auto goes = [&](unsigned axis, double share, auto&& holds)
  {
    this->Model.Move(axis, share);
    EXPECT_TRUE(Eventually([&] { return holds(this->Bench.State().Record.Tip); })) << axis;
    this->Model.Move(axis, 0.0);
  };
  goes(ABS_X, 1.0, [](const Vector3& tip) { return tip.X > 0.02; });
  goes(ABS_Y, -1.0, [](const Vector3& tip) { return tip.Y > 0.02; });
  goes(ABS_RY, 1.0, [](const Vector3& tip) { return tip.Z > 0.02; });
  goes(ABS_RZ, 1.0, [](const Vector3& tip) { return tip.Z < 0.01; });
  goes(ABS_Z, 1.0, [](const Vector3& tip) { return tip.Z > 0.02; });
  this->Model.MoveUnheard(ABS_X, -1.0);
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Record.Tip.X < 0.0; })) << "lost events";
  this->Model.Press(BTN_TR, true);
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Buttons == 1U << 5; }));
  EXPECT_TRUE(this->Bench.WaitForTicks(5));
  const Vector3 held = this->Bench.State().Record.Tip;
  EXPECT_TRUE(this->Bench.WaitForTicks(200));
  EXPECT_EQ(Norm(this->Bench.State().Record.Tip - held), 0.0) << "the clutch";
  this->Model.Press(BTN_TR, false);
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Record.Tip.X < held.X - 0.01; }));
  this->Model.Move(ABS_X, 0.0);
  this->Model.Move(ABS_RX, -1.0);
  EXPECT_TRUE(Eventually([&] { return std::abs(this->Bench.State().Turn.Y + 1.0) < 1e-9; }));
  this->Bench.Device->Home();
  EXPECT_TRUE(Eventually([&] { return Norm(this->Bench.State().Record.Tip) < 1e-9; }));
}

TEST_P(Pads, ContactIsFeltAndRestIsSilent)
{
  this->Begin();
  // Move in free space. The force does not change, so the pad does not vibrate.
  this->Model.Move(ABS_X, 1.0);
  EXPECT_TRUE(Eventually([&] { return this->Bench.State().Record.Tip.X > 0.02; }));
  this->Model.Move(ABS_X, 0.0);
  EXPECT_TRUE(this->Model.GetHistory().empty());
  // Move into the floor, so that the force rises by up to 50 N/s.
  this->Model.Move(ABS_RY, -1.0);
  EXPECT_TRUE(Eventually([&] { return !this->Model.IsStill(); }));
  EXPECT_TRUE(Eventually([&] { return Norm(this->Bench.State().Command) > 1.5; }));
  this->Model.Move(ABS_RY, 0.0);
  EXPECT_TRUE(Eventually([&] { return this->Model.IsStill(); })) << "it rests";
  int weak = 0;
  for (const PadModel::Change& change : this->Model.GetHistory())
  {
    weak = std::max(weak, change.Weak);
  }
  EXPECT_GT(weak, 0.3 * FullSpeed);
  EXPECT_TRUE(this->Bench.WaitForTicks(200));
  EXPECT_GT(Norm(this->Bench.State().Command), 1.0) << "the force is still there";
  EXPECT_TRUE(this->Model.IsStill());
  EXPECT_EQ(this->Bench.State().GetFault(), GateReason::None);
  EXPECT_LE(this->Model.GetLongestReplay(), 200);
  EXPECT_GT(this->Model.GetLongestReplay(), 0) << "an effect without an end would go on for ever";
}

TEST_P(Pads, AFaultIsOnePulseThenSilence)
{
  this->Begin();
  this->Model.Move(ABS_RY, -1.0);
  EXPECT_TRUE(Eventually([&] { return Norm(this->Bench.State().Command) > 1.5; }));
  this->Model.Move(ABS_RY, 0.0);
  EXPECT_TRUE(Eventually([&] { return this->Model.IsStill(); }));
  this->Model.ForgetHistory();
  // Set a limit that any motion exceeds.
  SafetyLimits limits = QuickLimits();
  limits.MaximumSpeed = 1e-3;
  this->Bench->SetLimits(limits);
  this->Model.Move(ABS_X, 1.0);
  EXPECT_TRUE(this->Bench.WaitForFault(GateReason::OverSpeed));
  EXPECT_TRUE(Eventually([&] { return !this->Model.GetHistory().empty(); })) << "it is felt";
  EXPECT_TRUE(Eventually([&] { return this->Model.IsStill(); }));
  this->Model.ForgetHistory();
  EXPECT_TRUE(this->Bench.WaitForTicks(300));
  EXPECT_TRUE(this->Model.GetHistory().empty()) << "and then there is silence";
}

TEST_P(Pads, ClosingItErasesTheEffects)
{
  this->Begin();
  this->Model.Move(ABS_RY, -1.0);
  EXPECT_TRUE(Eventually([&] { return !this->Model.IsStill(); }));
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_TRUE(this->Model.IsStill());
  EXPECT_EQ(this->Model.CountEffects(), 0);
  this->Model.Move(ABS_RY, 0.0);
  ASSERT_TRUE(this->Bench.Reopen()) << this->Bench.Error;
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
}

TEST_P(Pads, APadThatIsGoneIsLostWithATextAndWaitsOnceItIsBack)
{
  this->Begin();
  this->Model.Move(ABS_RY, -1.0);
  EXPECT_TRUE(Eventually([&] { return !this->Model.IsStill(); }));
  this->Evdev.Unplug();
  this->Bench.ExpectLost("is gone: unplugged, switched off or out of reach. Bring it back");
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitForText("was unplugged"));
  EXPECT_TRUE(Eventually([&] { return this->Model.IsStill(); }));
  this->Model.CloseFiles();
  const EmulatedEvdev again(this->Model);
  this->Bench.ExpectBack();
  EXPECT_TRUE(this->Model.IsStill());
}

TEST_P(Pads, AStepOfTheForceHasItsAmplitude)
{
  ASSERT_TRUE(this->Bench.Open("vibration:pad")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
  DeviceBackend& device = *this->Bench.Device;
  DeviceSample sample;
  // The expected values follow from the closed form of the two filters: a step of 0.5 N causes at
  // most 0.32 of the slow motor's full speed, after 46 ms, and 0.41 of the fast motor's, after 4
  // ms. Pads receive a new speed every 10 ms.
  bool isRight = false;
  int strong = 0;
  int weak = 0;
  for (int attempt = 0; attempt < 20 && !isRight; ++attempt)
  {
    const auto hold = [&](double force, int milliseconds)
    {
      for (int i = 0; i < milliseconds; ++i)
      {
        device.Read(1e-3, sample);
        device.Write({ 0.0, force, 0.0 });
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    };
    hold(0.0, 1200);
    this->Model.ForgetHistory();
    hold(0.5, 300);
    strong = weak = 0;
    for (const PadModel::Change& change : this->Model.GetHistory())
    {
      strong = std::max(strong, change.Strong);
      weak = std::max(weak, change.Weak);
    }
    // Repeat the step until the force was written without a pause, which a busy machine may cause.
    isRight = std::abs(strong / FullSpeed - 0.318) < 0.02 && weak > 0.25 * FullSpeed &&
      weak < 0.46 * FullSpeed;
  }
  EXPECT_TRUE(isRight) << strong / FullSpeed << " " << weak / FullSpeed;
}

INSTANTIATE_TEST_SUITE_P(
  Kinds, Pads, testing::Values(PadModel::Kind::Xbox, PadModel::Kind::PlayStation));

namespace
{
/** A program that writes motor speeds to the device's node through its own open file. */
class Rumbling : public testing::Test
{
protected:
  Rumbling()
  {
    this->Node = open(this->Evdev.GetNode().c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    this->HasBegun = this->Rumble.Begin(this->Node);
  }
  ~Rumbling() override { close(this->Node); }
  bool Turns()
  {
    return Eventually([&] { return !this->Model.IsStill(); });
  }
  bool Stops()
  {
    return Eventually([&] { return this->Model.IsStill(); });
  }

  PadModel Model{ PadModel::Kind::Xbox };
  EmulatedEvdev Evdev{ this->Model };
  ModelClock Clock{ [this] { this->Model.Step(); } };
  EvdevRumble Rumble;
  int Node = -1;
  bool HasBegun = false;
};
} // namespace

TEST_F(Rumbling, FallsSilentIfTheProgramStandsStill)
{
  ASSERT_TRUE(this->HasBegun);
  ASSERT_TRUE(this->Rumble.Show({ 1.0, 0.5 }));
  EXPECT_TRUE(this->Turns());
  EXPECT_EQ(this->Model.GetMotors().Strong, 65535);
  EXPECT_TRUE(this->Stops()) << "nothing is said any more";
  const std::vector<PadModel::Change> history = this->Model.GetHistory();
  ASSERT_EQ(history.size(), 2U);
  EXPECT_GT(history[1].Time - history[0].Time, 0.14) << "the length of the effect";
  // The motors can be started again after the effect has ended.
  ASSERT_TRUE(this->Rumble.Show({ 1.0, 0.5 }));
  EXPECT_TRUE(this->Turns());
}

TEST_F(Rumbling, StopsWithTheProgramAlsoAfterAChange)
{
  // The kernel closes a program's files however the program ends.
  for (int i = 0; i < 40; ++i)
  {
    ASSERT_TRUE(this->Rumble.Begin(this->Node));
    ASSERT_TRUE(this->Rumble.Show({ 0.3, 0.7 }));
    std::this_thread::sleep_for(std::chrono::milliseconds(11));
    ASSERT_TRUE(this->Rumble.Show({ 0.2, 0.1 + 0.01 * i }));
    EXPECT_FALSE(this->Model.IsStill());
    this->Model.CloseFiles();
    ASSERT_TRUE(this->Model.IsStill()) << i;
    ASSERT_EQ(this->Model.CountEffects(), 0);
  }
}

TEST_F(Rumbling, GoesOnWithoutGapsIfItIsRenewed)
{
  ASSERT_TRUE(this->HasBegun);
  bool isWhole = false;
  for (int attempt = 0; attempt < 20 && !isWhole; ++attempt)
  {
    this->Model.ForgetHistory();
    const double end = this->Model.GetTime() + 0.6;
    double longest = 0.0;
    for (double last = this->Model.GetTime(); last < end;)
    {
      ASSERT_TRUE(this->Rumble.Show({ 0.5, 0.5 }));
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      longest = std::max(longest, this->Model.GetTime() - last);
      last = this->Model.GetTime();
    }
    // Evaluate only an attempt without a pause, which a busy machine may cause.
    isWhole = longest < 0.05;
    for (const PadModel::Change& change : this->Model.GetHistory())
    {
      EXPECT_TRUE(!isWhole || change.Strong > 0) << change.Time - end;
    }
  }
  EXPECT_TRUE(isWhole);
}

TEST_F(Rumbling, SilenceIsAtOnceAlsoAfterAChange)
{
  ASSERT_TRUE(this->HasBegun);
  // The kernel's timer may process a change and its end in the same tick.
  for (int i = 0; i < 40; ++i)
  {
    ASSERT_TRUE(this->Rumble.Show({ 0.2, 0.4 }));
    std::this_thread::sleep_for(std::chrono::milliseconds(11));
    ASSERT_TRUE(this->Rumble.Show({ 0.8, 0.1 + 0.01 * i }));
    ASSERT_TRUE(this->Rumble.Silence());
    ASSERT_TRUE(this->Model.IsStill()) << i;
  }
  EXPECT_EQ(this->Model.CountEffects(), 1);
}

TEST_F(Rumbling, TheFullGainIsAskedForAndErasedEffectsAreMadeAnew)
{
  ASSERT_TRUE(this->HasBegun);
  ASSERT_TRUE(this->Rumble.Show({ 1.0, 1.0 }));
  EXPECT_TRUE(this->Turns());
  this->Rumble.End();
  EXPECT_EQ(this->Model.CountEffects(), 0);
  EXPECT_TRUE(this->Model.IsStill());
  // Erase all effects, as a kernel before Linux 5.7 does when a child of this program ends.
  ASSERT_TRUE(this->Rumble.Show({ 0.5, 0.5 }));
  for (int id = 0; id < 16; ++id)
  {
    ioctl(this->Node, EVIOCRMFF, id);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(15));
  ASSERT_TRUE(this->Rumble.Show({ 1.0, 1.0 }));
  std::this_thread::sleep_for(std::chrono::milliseconds(15));
  ASSERT_TRUE(this->Rumble.Show({ 0.9, 1.0 }));
  EXPECT_EQ(this->Model.GetMotors().Weak, 65535);
}
