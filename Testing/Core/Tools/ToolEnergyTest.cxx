// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a needle and a tool with a shape in a closed loop with a hand. The energy observer must
 * find no unstable loop.
 */

#include "Core/Safety/EnergyObserver.h"
#include "Core/Servo/ServoTick.h"
#include "Core/State/ToolMemory.h"
#include "Core/Tools/Needle/NeedleScene.h"
#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

using namespace coretest;

namespace
{
/// A simulated hand that holds the device and moves along z. The force acts `Late` ticks late.
struct HandOnDevice
{
  double Mass = 0.1;    ///< kg
  double Damping = 5.0; ///< N s/m
  std::size_t Late = 0; ///< delay (ticks)
};

struct Observed
{
  int Alarms = 0;
  double Energy = 0.0;   ///< energy (J) that the observer counted
  double Held = 0.0;     ///< largest energy (J) that is added by holding a force for a tick
  double Farthest = 0.0; ///< deepest position (mm)
  double Most = 0.0;     ///< largest force (N)
  int Free = 0;          ///< number of ticks without force after the first contact
};

/// Runs three seconds with the hand's push (N) as a function of time. Processes each sample as the
/// servo does.
template <typename F>
Observed Hold(
  const HapticModelDescription& scene, const Vector3& from, const HandOnDevice& hand, F&& push)
{
  const HapticModel model(scene);
  const auto memory = ToolMemory::Provide(*model.Baked, nullptr);
  EnergyObserver observer;
  ServoState state;
  TickRecord record;
  Observed result;
  std::deque<double> forces(hand.Late, 0.0);
  double z = 0.001 * from.Z;
  double speed = 0.0;
  for (int i = 0; i < 3000; ++i)
  {
    const Vector3 tip{ 0.001 * from.X, 0.001 * from.Y, z };
    result.Alarms += observer.Observe(tip, 1e-3) ? 1 : 0;
    Tick(model, state, tip, record, LocalSurfaceResult::Simulated(), nullptr, memory.get());
    forces.push_back(record.Force.Z);
    observer.RecordSent({ 0.0, 0.0, forces.front() });
    const double before = z;
    for (int part = 0; part < 10; ++part)
    {
      speed += 1e-4 * (push(1e-3 * i) + forces.front() - hand.Damping * speed) / hand.Mass;
      z += 1e-4 * speed;
    }
    forces.pop_front();
    result.Held += 0.5 * 500.0 * (z - before) * (z - before);
    result.Farthest = std::max(result.Farthest, 1000.0 * z);
    result.Most = std::max(result.Most, Norm(record.Force));
    result.Free += result.Most > 0.0 && Norm(record.Force) == 0.0 ? 1 : 0;
  }
  result.Energy = observer.GetEnergy();
  return result;
}

/// Returns a push (N) that rises from 0 to 3 N and falls again in each second.
double PushAndRest(double t)
{
  return 1.5 - 1.5 * std::cos(2.0 * Pi * t);
}

/// A ball of 4 mm radius over a half-space of bone, whose surface is at z = 11.5 mm.
class ShellInLoop : public testing::Test
{
protected:
  ShellInLoop()
    : Volume(ScalarType::UInt8, { 40, 40, 40 })
  {
    this->Volume.Fill<std::uint8_t>([](std::int64_t, std::int64_t, std::int64_t k)
      { return static_cast<std::uint8_t>(k >= 12 ? 200 : 0); });
    this->Scene = Describe(this->Volume);
    ShellDescription tool;
    tool.Points = std::make_shared<const PointShell>(MakeSphere(4000.0, 1000));
    tool.Touch.Level = 100.0;
    tool.Touch.ContactArea = 0.1;
    this->Scene.Tool = std::make_shared<const BakedShell>(tool);
  }

  TestVolume Volume;
  HapticModelDescription Scene;
  const Vector3 Above{ 19.7, 19.4, 7.0 };
};
} // namespace

/// The hand pushes the needle through the layers of N1, with a puncture at each layer, and draws it
/// out again.
TEST(NeedleInLoop, DoesNotSwing)
{
  std::vector<Layer> layers = LayersOfN1();
  for (Layer& layer : layers)
  {
    layer.Puncture = 0.6;
  }
  const NeedleScene scene(layers);
  const auto push = [](double t) { return 1.4 * std::sin(2.0 * Pi * t); };
  const Observed held = Hold(scene.Description, Along(2.0), {}, push);
  EXPECT_EQ(held.Alarms, 0);
  EXPECT_LE(held.Energy, 0.0) << "J: the hand has put energy in";
  EXPECT_GE(held.Farthest, NeedleScene::Skin + 15.0) << "it has passed two layers";
  EXPECT_GT(held.Free, 100) << "and was drawn out";
}

TEST_F(ShellInLoop, DoesNotSwing)
{
  const Observed held = Hold(this->Scene, this->Above, {}, PushAndRest);
  EXPECT_EQ(held.Alarms, 0);
  EXPECT_LE(held.Energy, held.Held) << "J: the hand has got none";
  EXPECT_GT(held.Most, 1.0);
}

/// The same loop is unstable if the force comes late and the damping is low: b < k (d + T/2).
TEST_F(ShellInLoop, WhoseForceComesLateIsFound)
{
  const Observed held =
    Hold(this->Scene, this->Above, { 0.02, 0.6, 2 }, [](double) { return 2.0; });
  EXPECT_GE(held.Alarms, 1);
}
