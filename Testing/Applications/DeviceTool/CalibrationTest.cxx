// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests calibration with a hung weight and with a pressed scale, in closed loop with a handle of
 * known strength, in simulated time.
 */

#include "Applications/DeviceTool/HungWeight.h"
#include "Applications/DeviceTool/ScaleFit.h"
#include "Applications/DeviceTool/ScalePress.h"
#include "Emulators/HungHandle.h"

#include <gtest/gtest.h>

using namespace emulated;

namespace
{
constexpr double Most = 4.0;        // N, largest requested force
constexpr double Stiffness = 270.0; // N/m, of the spring
constexpr double Tick = 1e-3;       // s, of simulated time
constexpr int TicksPerLook = 10;
constexpr double LongestTime = 300.0; // s, limit of the simulated time

/// A spring with the ramp and the force limit of the servo's force path.
class Loop
{
public:
  explicit Loop(HungHandle& handle)
    : Handle(handle)
    , Start(handle.GetTip())
  {
  }
  /// Advances the device by some ticks with the spring's end shifted along an axis, and returns the
  /// resulting state.
  HeldSample Look(int axis, double shift, int ticks = TicksPerLook)
  {
    Triple force{};
    for (int i = 0; i < ticks; ++i)
    {
      this->Time += Tick;
      const Triple tip = this->Handle.GetTip();
      double size = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        force[a] = Stiffness * (this->Start[a] + (a == axis ? shift : 0.0) - tip[a]);
        size += force[a] * force[a];
      }
      const double share =
        std::min(1.0, this->Time / 0.5) * std::min(1.0, Most / std::max(std::sqrt(size), 1e-9));
      for (double& f : force)
      {
        f *= share;
      }
      this->Handle.Step(force, Tick);
    }
    HeldSample sample;
    sample.Tip = this->Handle.GetTip();
    sample.Force = force;
    sample.Elapsed = ticks * Tick;
    return sample;
  }
  double GetTime() const { return this->Time; }

private:
  HungHandle& Handle;
  const Triple Start;
  double Time = 0.0;
};

/// A simulated user, who follows each request after one second.
struct User
{
  double Weight = 0.1; ///< kg, of the hung weight
  bool Hangs = true;
  bool TakesOff = true;

  void Follow(const std::string& request, double sinceRequest, HungHandle& handle) const
  {
    const bool isSoon = sinceRequest < 1.0;
    if (request.find("Let the handle go") != std::string::npos)
    {
      handle.IsHeld = isSoon;
    }
    else if (request.find("Hang the weight") != std::string::npos && this->Hangs)
    {
      handle.Weight = isSoon ? 0.0 : this->Weight;
    }
    else if (request.find("take the weight off") != std::string::npos && this->TakesOff)
    {
      handle.Weight = isSoon ? this->Weight : 0.0;
    }
  }
};

HungWeight Weigh(HungHandle& handle, const User& user, int axis = 1, double patience = 20.0,
  int ticksPerLook = TicksPerLook)
{
  HungWeight::Settings settings;
  settings.Weight = user.Weight * HungHandle::Gravity;
  settings.Axis = axis;
  settings.MostForce = Most;
  settings.Patience = patience;
  HungWeight weight(settings);
  Loop loop(handle);
  std::string request;
  double since = 0.0;
  while (!weight.IsOver() && loop.GetTime() < LongestTime)
  {
    since = request == weight.GetRequest() ? since : loop.GetTime();
    request = weight.GetRequest();
    user.Follow(request, loop.GetTime() - since, handle);
    weight.Step(loop.Look(axis, weight.GetShift(), ticksPerLook));
  }
  EXPECT_TRUE(weight.IsOver());
  return weight;
}

void ExpectRefusal(const HungWeight& weight, const char* words)
{
  EXPECT_NE(weight.GetFault().find(words), std::string::npos)
    << "\"" << weight.GetFault() << "\" instead of " << words << ", factor " << weight.GetFactor();
}
} // namespace

TEST(Calibration, FindsTheStrengthByAWeight)
{
  double worst = 0.0;
  for (const double strength : { 0.4, 0.7, 1.0, 1.7, 3.0 })
  {
    for (const double friction : { 0.0, 0.05, 0.15, 0.3 })
    {
      for (const double viscosity : { 0.3, 1.0, 5.0 })
      {
        HungHandle handle;
        handle.Strength = strength;
        handle.Friction = friction;
        // The spring's force is constant during a tick, so the handle would oscillate without
        // damping.
        handle.Viscosity = friction > 0.0 ? viscosity : std::max(viscosity, strength);
        User user;
        user.Weight = strength < 0.5 ? 0.1 : 0.15;
        const HungWeight weight = Weigh(handle, user);
        EXPECT_EQ(weight.GetFault(), "") << strength << " " << friction << " " << viscosity;
        worst = std::max(worst, std::abs(weight.GetFactor() / strength - 1.0));
        EXPECT_NEAR(weight.GetFactor() / strength, 1.0, 0.03)
          << strength << " " << friction << " " << viscosity;
        EXPECT_NEAR(weight.GetFriction() * strength, friction, 0.02 + 0.2 * friction);
      }
    }
  }
  std::cout << "largest error by a weight: " << 100.0 * worst << " %\n";
}

TEST(Calibration, FindsItOfHandlesThatAreHeavyLightBalancedOrPulledUp)
{
  for (const double balance : { 0.0, 0.6, 1.0, 1.5 })
  {
    for (const double mass : { 0.05, 0.3 })
    {
      HungHandle handle;
      handle.Strength = 1.3;
      handle.Mass = mass;
      handle.Balance = balance;
      handle.ArmStiffness = 60.0;
      const HungWeight weight = Weigh(handle, {});
      EXPECT_EQ(weight.GetFault(), "") << balance << " " << mass;
      EXPECT_NEAR(weight.GetFactor() / 1.3, 1.0, 0.03) << balance << " " << mass;
    }
  }
}

TEST(Calibration, OfAProgramThatIsHeldUpTakesLonger)
{
  // Sampling the handle only every 0.6 s makes a sweep in one direction take longer than
  // HandleSweep::MostTime. The handle must not count as stuck.
  HungHandle handle;
  handle.Strength = 0.7;
  const HungWeight weight = Weigh(handle, {}, 1, 20.0, 600);
  EXPECT_EQ(weight.GetFault(), "");
  EXPECT_NEAR(weight.GetFactor() / handle.Strength, 1.0, 0.03);
}

TEST(Calibration, NeedsNoSignOfTheVerticalAxis)
{
  HungHandle handle;
  handle.Down = { 0.0, 0.0, 1.0 };
  handle.Strength = 0.8;
  const HungWeight weight = Weigh(handle, {}, 2);
  EXPECT_EQ(weight.GetFault(), "");
  EXPECT_NEAR(weight.GetFactor() / 0.8, 1.0, 0.03);
}

TEST(Calibration, RefusesAWeightThatCanTBeMeasured)
{
  {
    HungHandle handle;
    User user;
    user.Hangs = false;
    ExpectRefusal(Weigh(handle, user), "Nothing has changed");
  }
  {
    HungHandle handle; // the weight is less than the friction
    handle.Friction = 0.5;
    User user;
    user.Weight = 0.03;
    ExpectRefusal(Weigh(handle, user), "Nothing has changed");
  }
  {
    HungHandle handle;
    handle.Friction = 0.01;
    User user;
    user.Weight = 0.012;
    ExpectRefusal(Weigh(handle, user), "too light");
  }
  {
    HungHandle handle;
    User user;
    user.Weight = 0.6;
    ExpectRefusal(Weigh(handle, user), "too heavy");
  }
  {
    HungHandle handle;
    handle.Mass = 0.6;
    handle.Balance = 0.0;
    ExpectRefusal(Weigh(handle, {}), "without a weight");
  }
  {
    HungHandle handle;
    User user;
    user.TakesOff = false;
    ExpectRefusal(Weigh(handle, user), "was not taken off");
  }
  {
    HungHandle handle;
    handle.Tremor = 2e-3;
    ExpectRefusal(Weigh(handle, {}), "does not come to rest");
  }
  {
    HungHandle handle; // the device lies on its side
    handle.Down = { -0.7071, -0.7071, 0.0 };
    ExpectRefusal(Weigh(handle, {}), "along another axis");
  }
}

namespace
{
ScalePress PressOnce(HungHandle& handle, double level, double& grams)
{
  ScalePress::Settings settings;
  settings.Level = level;
  settings.MostForce = Most;
  ScalePress press(settings);
  Loop loop(handle);
  while (!press.IsOver() && loop.GetTime() < LongestTime)
  {
    handle.IsHeld = loop.GetTime() < 0.5;
    press.Step(loop.Look(1, press.GetShift()));
    const bool isRead = press.GetRequest().find("Read the scale") != std::string::npos;
    grams = isRead ? handle.GetShown() : grams;
  }
  EXPECT_TRUE(press.IsOver());
  return press;
}
} // namespace

TEST(Calibration, FindsTheStrengthByAScale)
{
  double worst = 0.0;
  for (const double strength : { 0.4, 1.0, 1.7, 3.0 })
  {
    for (const double friction : { 0.0, 0.1, 0.3 })
    {
      for (const double below : { -0.001, 0.005 })
      {
        std::vector<ScaleReading> readings;
        for (const double level : { 1.2, 1.8, 2.4, 3.0 })
        {
          HungHandle handle;
          handle.Strength = strength;
          handle.Friction = std::min(friction, 0.5 * strength); // at most half of the strength
          handle.HasScale = true;
          handle.PlateBelow = below;
          double grams = 0.0;
          const ScalePress press = PressOnce(handle, level, grams);
          ASSERT_EQ(press.GetFault(), "") << strength << " " << friction << " " << below;
          readings.push_back({ press.GetForce(), 1e-3 * grams * HungHandle::Gravity });
        }
        ScaleFit fit;
        std::string error;
        ASSERT_TRUE(FitScale(readings, fit, error))
          << error << strength << " " << friction << " " << below;
        EXPECT_NEAR(fit.Factor / strength, 1.0, 0.03)
          << strength << " " << friction << " " << below;
        worst = std::max(worst, std::abs(fit.Factor / strength - 1.0));
      }
    }
  }
  std::cout << "largest error by a scale: " << 100.0 * worst << " %\n";
}

TEST(Calibration, RefusesAScaleThatIsNotThere)
{
  HungHandle handle;
  double grams = 0.0;
  const ScalePress press = PressOnce(handle, 1.0, grams);
  EXPECT_NE(press.GetFault().find("meets nothing"), std::string::npos) << press.GetFault();
}

TEST(Calibration, RefusesReadingsThatAreNotOnALine)
{
  ScaleFit fit;
  std::string error;
  // Expected by hand: the points lie on the line 0.5 + 2 x.
  ASSERT_TRUE(FitScale({ { 1.0, 2.5 }, { 2.0, 4.5 }, { 3.0, 6.5 } }, fit, error));
  EXPECT_NEAR(fit.Factor, 2.0, 1e-12);
  EXPECT_NEAR(fit.Offset, 0.5, 1e-12);
  EXPECT_NEAR(fit.Residual, 0.0, 1e-12);
  // Expected by hand: factor 1, residuals of 0.1, -0.2 and 0.1, so that the sum of squares is 0.06.
  ASSERT_FALSE(FitScale({ { 1.0, 1.1 }, { 2.0, 1.8 }, { 3.0, 3.1 } }, fit, error));
  EXPECT_NEAR(fit.Factor, 1.0, 1e-12);
  EXPECT_NEAR(fit.Residual, std::sqrt(0.06), 1e-12);
  EXPECT_NE(error.find("not on a straight line"), std::string::npos) << error;
  ASSERT_FALSE(FitScale({ { 1.0, 3.0 }, { 2.0, 2.0 }, { 3.0, 1.0 } }, fit, error));
  EXPECT_NE(error.find("did not show more"), std::string::npos) << error;
  ASSERT_FALSE(FitScale({ { 1.0, 1.5 }, { 2.0, 1.5 }, { 3.0, 1.5 } }, fit, error));
}
