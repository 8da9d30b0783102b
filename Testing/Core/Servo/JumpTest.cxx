// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Publishes a model while the hand feels a force. A force that would jump must grow with the ramp
 * instead, and the proxy must not be carried far.
 *
 * The spring has 1000 N/m and is pressed 1 mm deep, and its surface stays in place on a ramp along
 * z. If the proxy is carried by c, the force is 1000 N/m (1 mm + c).
 */

#include "Rigs/PlayedDevice.h"

#include <vector>

using namespace servotest;

namespace
{
constexpr double Rate = 1000.0;
constexpr double Pressed = 1.0; // N

/// A device whose tip moves towards a goal depth by 0.01 mm per tick.
class LedDevice : public PlayedDevice
{
public:
  DeviceState Read(double period, DeviceSample& sample) noexcept override
  {
    const DeviceState state = PlayedDevice::Read(period, sample);
    this->Depth = std::min(this->Goal.load(), this->Depth + 1e-5);
    sample.Tip = { 0.012, 0.012, 0.012 + this->Depth };
    return state;
  }
  std::atomic<double> Goal{ 0.0 }; ///< m

private:
  double Depth = 0.0;
};

struct Change
{
  double Carry = 0.0; ///< distance (mm) by which the change moves the volume along the press
  double Field = 0.0; ///< force (N) of the method ForceField, which replaces the spring
};

class Jump : public testing::Test
{
protected:
  std::shared_ptr<const HapticModel> MakeModel(const Change& change) const
  {
    HapticModelDescription d = Describe(this->Volume);
    d.Material.Stiffness = ConstantPolyline(1000.0);
    d.Material.SurfaceStrength = ConstantPolyline(1e12);
    d.DeviceToWorld.Offset = { 0.0, 0.0, change.Carry };
    d.Settings.Method = change.Field > 0.0 ? HapticMethod::ForceField : HapticMethod::Proxy;
    d.Settings.ForceFieldGain = change.Field / 100.0; // because the gradient is 100 per mm
    d.Settings.ForceFieldDamping = 0.0;
    return std::make_shared<const HapticModel>(d);
  }

  /// Presses, and publishes the change. Returns the ticks from the first one with the change on.
  std::vector<ServoSnapshot> Publish(const Change& change, std::size_t ticks)
  {
    SafetyLimits limits = QuickLimits();
    limits.RampTime = 0.5;
    LedDevice device;
    RunningLoop loop(device, Rate, limits);
    loop->Publish(this->MakeModel({}));
    loop->Arm();
    const auto isTold = [&](auto condition)
    { return Eventually([&] { return loop->ReadState() && condition(loop->GetState()); }); };
    EXPECT_TRUE(isTold([](const ServoSnapshot& s) { return s.Gate == GateState::Armed; }));
    device.Goal.store(1e-3);
    EXPECT_TRUE(
      isTold([](const ServoSnapshot& s) { return Norm(s.Command) >= Pressed * (1.0 - 1e-6); }));
    loop->SetRecording(true);
    const std::uint64_t generation = loop->Publish(this->MakeModel(change));
    std::vector<ServoSnapshot> taken;
    const auto take = [&]
    {
      ServoSnapshot s;
      while (loop->Drain(s))
      {
        if (s.Generation >= generation)
        {
          taken.push_back(s);
        }
      }
      return taken.size() >= ticks;
    };
    EXPECT_TRUE(Eventually(take));
    return taken;
  }

  const TestVolume Volume = MakeRamp();
};

/// Expects that the force rises no faster than the ramp, and ends at `wanted` (N).
void ExpectRamp(const std::vector<ServoSnapshot>& ticks, double wanted)
{
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    const double share = static_cast<double>(i) / (0.5 * Rate);
    ASSERT_LE(Norm(ticks[i].Command), wanted * share + 1e-6) << "tick " << i;
  }
  EXPECT_NEAR(Norm(ticks.back().Command), wanted, 1e-6);
  EXPECT_EQ(ticks.back().Gate, GateState::Armed);
  EXPECT_EQ(ticks.front().Gate, GateState::Ramping);
}
} // namespace

TEST_F(Jump, AVolumeThatMovesIntoTheHandIsFeltThroughTheRamp)
{
  ExpectRamp(this->Publish({ 2.0 }, 600), 3.0);
}

TEST_F(Jump, AnotherMethodIsFeltThroughTheRamp)
{
  ExpectRamp(this->Publish({ 0.0, 3.0 }, 600), 3.0);
}

TEST_F(Jump, ASmallMoveInterruptsNothing)
{
  for (const ServoSnapshot& s : this->Publish({ 0.2 }, 50))
  {
    ASSERT_GE(Norm(s.Command), Pressed * (1.0 - 1e-6));
    ASSERT_EQ(s.Gate, GateState::Armed);
  }
}

TEST_F(Jump, AProxyIsNotCarriedFar)
{
  for (const double carry : { -5.0, 5.0, 100.0 })
  {
    for (const ServoSnapshot& s : this->Publish({ carry }, 600))
    {
      ASSERT_LT(Norm(s.Command), 1e-6) << carry << " mm";
      ASSERT_LT(Norm(s.Record.Proxy - s.Record.Tip), 1e-6);
    }
  }
}
