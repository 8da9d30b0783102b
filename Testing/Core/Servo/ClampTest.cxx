// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Throws an undamped mass against a spring in the whole loop, while the model limits the force.
 * With the slew limit, the mass must return with at most the energy that it would have without it.
 *
 * Limiting the force takes no energy. A mass m with a speed v that hits a spring k limited to F
 * stops at a depth x with F x - F^2 / 2k = m v^2 / 2. It gets all of this energy back, plus the
 * energy that sampling adds (ImpactTest.cxx).
 */

#include "Rigs/PlayedDevice.h"

using namespace servotest;

namespace
{
constexpr double Mass = 0.15;
constexpr double Step = 1e-3; // tick (s), independent of the real clock
constexpr double Speed = 0.6;
constexpr int Free = 100; // number of ticks at rest, in which the ramp ends

/// A body that rests on the proxy until it is thrown, and then records the energy (J) with which it
/// returns.
class ThrownBody : public DeviceBackend
{
public:
  bool Open(std::string&) override { return true; }
  void Close() override {}
  std::string GetName() const override { return "thrown"; }
  DeviceLimits GetLimits() const override { return {}; }
  DeviceState Read(double, DeviceSample& sample) noexcept override
  {
    this->Rest += this->IsThrown.load();
    if (this->Rest == Free)
    {
      this->Velocity = Speed;
    }
    if (this->Rest >= Free && this->Energy.load() < 0.0)
    {
      const double a = this->Force / Mass;
      this->Depth += Step * this->Velocity + 0.5 * Step * Step * a;
      this->Velocity += Step * a;
      if (this->Depth <= 0.0)
      {
        this->Energy.store(0.5 * Mass * this->Velocity * this->Velocity);
      }
    }
    sample.Tip = Vector3{ 0.012, 0.012, 0.012 + std::max(this->Depth, 0.0) };
    sample.Fresh = true;
    return DeviceState::Running;
  }
  DeviceState Write(const Vector3& force) noexcept override
  {
    this->Force = force.Z;
    return DeviceState::Running;
  }
  void Quench() noexcept override {}

  std::atomic<bool> IsThrown{ false };
  std::atomic<double> Energy{ -1.0 }; ///< energy (J), set when the body has returned; -1 before

private:
  int Rest = 0;
  double Force = 0.0;
  double Depth = 0.0; ///< m
  double Velocity = 0.0;
};

double Throw(double rate, HapticSolver solver)
{
  const TestVolume volume = MakeRamp(48);
  HapticModelDescription description = Describe(volume);
  description.Material.Stiffness = ConstantPolyline(3000.0);
  description.Material.SurfaceStrength = ConstantPolyline(1e12); // the proxy never slips
  description.Settings.Solver = solver;
  description.Settings.MaximumForce = 2.0;
  ThrownBody body;
  SafetyLimits limits = QuickLimits();
  limits.MaximumForce = 8.0;
  limits.MaximumForceRate = rate;
  RunningLoop loop(body, 1.0 / Step, limits);
  loop->Publish(std::make_shared<HapticModel>(description));
  loop->Arm();
  EXPECT_TRUE(Eventually([&] { return loop->ReadState() && loop->GetState().IsArmed(); }));
  body.IsThrown.store(true);
  EXPECT_TRUE(Eventually([&] { return body.Energy.load() >= 0.0; }));
  return body.Energy.load();
}
} // namespace

TEST(Clamp, OfTheModelDoesNotMakeAWallActive)
{
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    const double free = Throw(1e9, solver);
    EXPECT_GT(free, 0.99 * 0.5 * Mass * Speed * Speed) << "the spring is there";
    for (const double rate : { 100.0, 500.0 })
    {
      EXPECT_LE(Throw(rate, solver), 1.02 * free) << rate << " N/s";
    }
  }
}

TEST(Clamp, OfTheModelLeavesItsPartOfADrag)
{
  // Force field (eq. 1) with the damping C2 = 5 N s/m, at 0.1 m/s along x. The gradient is 100 per
  // mm along z, and the gain is C1 = 0.01.
  const TestVolume volume = MakeRamp();
  HapticModelDescription description = Describe(volume);
  description.Settings.Method = HapticMethod::ForceField;
  description.Settings.ForceFieldGain = 0.01;
  description.Settings.ForceFieldDamping = 5.0;
  const Vector3 drag{ -0.5, 0.0, 0.0 };
  for (const double most : { 0.0, 0.5 * std::hypot(1.0, 0.5) })
  {
    description.Settings.MaximumForce = most;
    const HapticModel model(description);
    ServoState state;
    TickRecord record;
    Tick(model, state, { 0.012, 0.012, 0.012 }, record);
    EXPECT_EQ(Norm(ComputeDrag(model, state, record)), 0.0);
    const ServoState before = state;
    Tick(model, state, { 0.0121, 0.012, 0.012 }, record);
    const Vector3 expected = most > 0.0 ? 0.5 * drag : drag;
    EXPECT_LT(Norm(ComputeDrag(model, before, record) - expected), 1e-6);
    EXPECT_NEAR(record.Force.X, expected.X, 1e-6);
  }
}
