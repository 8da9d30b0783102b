// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Clamp and slew limit add no energy: a hand that is led through a conservative force field, in and
 * out again, gets no more out of the stage than it put in.
 *
 * The device holds the force of a tick until the next one, so that a tick gives the hand the energy
 * F . dx. Around a closed path a spring k gives k |dx|^2 / 2 a tick even without the stage: W held
 * over dx is W . dx, and the integral of W along dx is that minus k |dx|^2 / 2. That leak of
 * sampling is what the tests allow, for all motions with force.
 */

#include "GatedStage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

using namespace VolumeHaptics;

namespace
{
constexpr double Period = 1e-3;

/// The rules at work. None of them: only the clamp, at a force that nothing reaches.
struct Rules
{
  const char* Name;
  bool Clamp = false;
  bool Slew = false;
};

/// Random presses into a spring wall below z = 0, or the inside of a sphere.
class Presses
{
public:
  Presses(const Rules& rules, unsigned seed)
    : Engine(seed)
  {
    this->Limits.MaximumForce = rules.Clamp ? this->Draw(1.0, 6.0) : 1e6;
    this->Limits.MaximumForceRate = rules.Slew ? std::pow(10.0, this->Draw(1.0, 3.0)) : 1e9;
    this->Limits.RampTime = 0.0;
    this->Stiffness = std::pow(10.0, this->Draw(2.0, 3.5));
    this->IsSphere = this->Draw(0.0, 1.0) < 0.5;
    this->Input.Elapsed = this->Input.Period = Period;
    this->Input.Fresh = true;
    this->Input.Tip = this->Home();
    this->Input.Stiffness = this->Draw(0.0, 1.0) < 0.5 ? 0.0 : this->Stiffness;
    this->Stage.Arm();
  }

  /// Presses once. The energy (J) that the hand got above the leak of sampling.
  double Press()
  {
    this->Given = this->Leak = 0.0;
    const double inward = this->Draw(0.005, 0.05);
    const double speed = std::pow(10.0, this->Draw(-1.5, 0.0));
    this->MoveBy({ this->Draw(-0.005, 0.005), this->Draw(-0.005, 0.005), -inward }, speed);
    const int pokes = static_cast<int>(this->Draw(0.0, 4.0));
    for (int i = 0; i < pokes; ++i)
    {
      const double way = this->Draw(-0.4, 0.4) * inward;
      this->MoveBy({ this->Draw(-0.01, 0.01), this->Draw(-0.01, 0.01), way }, speed);
      this->Rest(static_cast<int>(this->Draw(0.0, 200.0)));
    }
    this->MoveBy(this->Home() - this->Input.Tip, std::pow(10.0, this->Draw(-1.5, 0.0)));
    this->Rest(5);
    return this->Given - this->Leak;
  }

private:
  double Draw(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Engine);
  }

  Vector3 Home() const { return { 0.0, 0.0, this->IsSphere ? 0.0 : 0.005 }; }
  Vector3 Field(const Vector3& x) const
  {
    if (!this->IsSphere)
    {
      return { 0.0, 0.0, this->Stiffness * std::max(0.0, -x.Z) };
    }
    constexpr double radius = 0.008;
    const double r = Norm(x);
    return r > radius ? (-this->Stiffness * (r - radius) / r) * x : Vector3{};
  }

  void MoveBy(const Vector3& way, double speed)
  {
    const int ticks = std::max(1, static_cast<int>(Norm(way) / (speed * Period)));
    for (int i = 0; i < ticks; ++i)
    {
      this->Step((1.0 / ticks) * way);
    }
  }
  void Rest(int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      this->Step({});
    }
  }

  /// A tick: the force for where the tip is, held while the hand moves on.
  void Step(const Vector3& way)
  {
    this->Input.Force = this->Field(this->Input.Tip);
    this->Input.Stretch = Norm(this->Input.Force) / this->Stiffness;
    const Vector3 force = this->Stage.Apply(this->Input, this->Limits);
    this->Given += Dot(force, way);
    this->Input.Tip += way;
    const bool isFelt = Norm(this->Input.Force) + Norm(this->Field(this->Input.Tip)) > 0.0;
    // Exact for a plane; in a sphere, for steps much shorter than its radius.
    this->Leak += isFelt ? 0.505 * this->Stiffness * Dot(way, way) : 0.0;
  }

  std::mt19937 Engine;
  servotest::GatedStage Stage;
  SafetyLimits Limits;
  SafetyInput Input;
  double Stiffness = 0.0;
  bool IsSphere = false;
  double Given = 0.0;
  double Leak = 0.0;
};

class PassiveStage : public testing::TestWithParam<Rules>
{
};
} // namespace

TEST_P(PassiveStage, GivesNoMoreThanTheHandPutIn)
{
  double most = 0.0;
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    Presses hand(GetParam(), seed);
    for (int i = 0; i < 5; ++i)
    {
      const double gained = hand.Press();
      EXPECT_LE(gained, 1e-9) << "J, seed " << seed << ", press " << i;
      most = std::max(most, gained);
    }
  }
  this->RecordProperty("most", std::to_string(most));
}

INSTANTIATE_TEST_SUITE_P(Rules, PassiveStage,
  testing::Values(Rules{ "None" }, Rules{ "Clamp", true }, Rules{ "Slew", false, true },
    Rules{ "Both", true, true }),
  [](const testing::TestParamInfo<Rules>& info) { return std::string(info.param.Name); });
