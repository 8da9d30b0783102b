// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Random sessions of a hand, a device and a wall in closed loop through the safety stage, with
 * honest devices and devices with wrong signs. Unstable loops are in ArmSessions.h.
 *
 * The hand is a mass with a spring and a damper to its goal: a minimum-jerk motion (Flash and Hogan
 * 1985) to a depth and back, taps, strokes along the wall, with or without a tremor of 8 to 12 Hz.
 * A limp device has no hand. The motion is integrated in steps of at most 80 us. The device has
 * encoders with a quantum, and may apply forces one tick late or report every 8 ms. The wall is a
 * half-space with a proxy: a spring, friction, and tissue that yields.
 *
 * A loop is honest if damping outweighs what sampling and delay add: b > 1.3 k (T / 2 + delay).
 */
#ifndef PortSessions_h
#define PortSessions_h

#include "Core/Safety/SafetyStage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <random>

namespace rigs
{
using VolumeHaptics::Cross;
using VolumeHaptics::Dot;
using VolumeHaptics::Norm;
using VolumeHaptics::Vector3;

enum class PortKind : std::uint8_t
{
  Honest,
  WrongSign
};

/** Result of a session. */
struct PortResult
{
  bool IsFound = false;
  double Given = 0.0;   ///< J, energy given to the hand until detection, or its largest value
  double Way = 0.0;     ///< m, way from the first force to detection, or the longest way
  double Rising = 0.0;  ///< J, largest rise of energy in PortObserver
  double RunAway = 0.0; ///< J, largest GetRunAway()
};

class PortSession
{
public:
  PortSession(PortKind kind, bool isHeld, double stiffness, std::uint32_t seed)
    : Engine(seed)
    , Kind(kind)
    , IsHeld(isHeld)
    , Stiffness(stiffness)
  {
    this->ChooseDevice();
    this->ChooseMotion();
  }

  PortResult Run()
  {
    using namespace VolumeHaptics;
    constexpr double Duration = 1.2;
    SafetyLimits limits;
    limits.MaximumForce = this->MaximumForce;
    limits.MovesTip = true;
    limits.RampTime = 0.0;
    ForceGate gate;
    SafetyStage stage;
    // Run a second observer beside the stage's own observer, to read its figures.
    PortObserver watch;
    gate.Arm();
    stage.Reset();
    PortResult result;
    SafetyInput input;
    input.Period = input.Elapsed = this->Period;
    input.Stiffness = this->Stiffness;
    std::deque<Vector3> onTheWay(static_cast<std::size_t>(this->Delay));
    Vector3 touched;
    bool isTouched = false;
    double given = 0.0;
    const int ticks = static_cast<int>(Duration / this->Period);
    for (int i = 0; i < ticks && !result.IsFound; ++i)
    {
      input.Fresh = i % this->Every == 0;
      input.Tip = input.Fresh ? this->Measure() : input.Tip;
      input.MotionTime = input.Fresh ? this->Every * this->Period : 0.0;
      input.Force = this->ComputeWallForce(input.Tip);
      input.Stretch = this->IsInside ? Norm(this->Proxy - input.Tip) : 0.0;
      if (input.Fresh)
      {
        watch.Observe(input.Tip, input.MotionTime);
      }
      const Vector3 sent = stage.Apply(input, limits, gate);
      watch.RecordSent(sent);
      result.Rising = std::max(result.Rising, watch.GetRisingRunAway());
      result.RunAway = std::max(result.RunAway, watch.GetRunAway());
      result.IsFound = gate.GetFault() == GateReason::Active;
      onTheWay.push_back(sent);
      const Vector3 acting = this->Turn(onTheWay.front());
      onTheWay.pop_front();
      if (!isTouched && Norm(acting) > 0.0)
      {
        isTouched = true;
        touched = this->Tip;
      }
      if (!result.IsFound)
      {
        given += this->Move(i * this->Period, acting);
      }
      result.Given = result.IsFound ? given : std::max(result.Given, given);
      const double way = isTouched ? Norm(this->Tip - touched) : 0.0;
      result.Way = result.IsFound ? way : std::max(result.Way, way);
      if (way > 0.1)
      {
        break;
      }
    }
    return result;
  }

private:
  double Pick(double from, double to) { return from + (to - from) * (this->Engine() * 0x1p-32); }
  double PickScale(double from, double to) { return from * std::pow(to / from, this->Pick(0, 1)); }
  bool Chance(double p) { return this->Pick(0.0, 1.0) < p; }
  Vector3 PickDirection()
  {
    Vector3 v;
    do
    {
      v = { this->Pick(-1, 1), this->Pick(-1, 1), this->Pick(-1, 1) };
    } while (Norm(v) > 1.0 || Norm(v) < 0.1);
    return (1.0 / Norm(v)) * v;
  }
  Vector3 Turn(const Vector3& f) const
  {
    return { this->Signs[0] * f.X, this->Signs[1] * f.Y, this->Signs[2] * f.Z };
  }

  void ChooseDevice()
  {
    this->Period = this->Chance(0.5) ? 1e-3 : 0.25e-3;
    this->Delay = this->Chance(0.5) ? 1 : 0;
    const bool isSlow = this->Chance(0.3) && (this->Kind == PortKind::Honest);
    this->Every = isSlow ? static_cast<int>(8e-3 / this->Period + 0.5) : 1;
    this->Quantum = this->Chance(0.5) ? 6e-5 : 1e-5;
    this->Mass = this->IsHeld ? this->PickScale(0.05, 0.5) : 0.15;
    this->HandStiffness = this->IsHeld ? this->PickScale(50.0, 500.0) : 0.0;
    this->HandDamping = this->IsHeld ? this->Pick(2.0, 10.0) : 0.0;
    this->Damping = this->Pick(0.5, 5.0);
    this->MaximumForce = (this->Chance(0.5) ? 4.0 : 8.0) * this->Pick(0.3, 1.0);
    const double report = this->Every * this->Period;
    const double lag = 0.5 * report + this->Delay * this->Period;
    const double damping = this->Damping + this->HandDamping;
    switch (this->Kind)
    {
      case PortKind::Honest:
        this->Stiffness = this->Stiffness > 0.0 ? this->Stiffness : this->PickScale(100.0, 5000.0);
        this->Stiffness =
          std::min({ this->Stiffness, 2.0 * this->Damping / report, damping / (1.3 * lag) });
        break;
      case PortKind::WrongSign:
        this->Damping = this->IsHeld ? this->Damping : this->Pick(0.05, 0.3);
        break;
    }
    this->Normal = this->PickDirection();
    while (this->Kind == PortKind::WrongSign && Dot(this->Normal, this->Turn(this->Normal)) > -0.5)
    {
      // Press along the axes with a wrong sign, because other walls do not reveal it.
      const std::uint32_t wrong = 1 + this->Engine() % 7;
      for (int i = 0; i < 3; ++i)
      {
        this->Signs[i] = (wrong >> i & 1) != 0 ? -1.0 : 1.0;
      }
      this->Normal = this->PickDirection();
    }
    const Vector3 along = Cross(this->Normal, this->PickDirection());
    this->Along = (1.0 / Norm(along)) * along;
  }

  void ChooseMotion()
  {
    const int motion = static_cast<int>(this->Engine() % 5);
    this->IsTapping = this->IsHeld && motion == 2;
    this->Stroke = this->IsHeld && motion >= 3 ? 0.03 : 0.0;
    this->Friction = motion == 3 ? this->Pick(0.1, 0.8)
      : this->Chance(0.5)        ? this->Pick(0, 0.5)
                                 : 0;
    this->Yield = this->IsHeld && motion == 4 ? this->Pick(0.3, 3.0) : 1e9;
    const bool isInContact = this->Kind == PortKind::WrongSign && this->Chance(0.3);
    const double far = this->IsHeld ? 0.02 : 0.001;
    this->Start = (isInContact ? this->Pick(0.0, 0.001) : this->Pick(0.0, far)) * this->Normal;
    this->Tip = this->Start;
    this->Velocity = this->IsHeld ? Vector3{} : -this->Pick(0.05, 0.5) * this->Normal;
    this->Depth = Dot(this->Start, this->Normal) + this->Pick(0.002, 0.05);
    const double speed = this->PickScale(0.03, 1.0);
    const double acceleration = this->Pick(3.0, 10.0);
    // The motion has minimum jerk: its largest speed is 1.875 D / T, and its largest acceleration
    // 5.77 D / T^2.
    this->Time =
      std::max(1.875 * this->Depth / speed, std::sqrt(5.7735 * this->Depth / acceleration));
    this->Tremor = this->Chance(0.5) ? 0.0 : this->PickScale(5e-5, 5e-4);
    this->TremorRate = 2.0 * Pi * this->Pick(8.0, 12.0);
    this->TremorAxis = this->PickDirection();
    this->TapRate = 2.0 * Pi * this->Pick(1.0, 6.0);
    this->TapSize = std::min(0.5 * this->Depth, acceleration / (this->TapRate * this->TapRate));
  }

  Vector3 Measure() const
  {
    const auto q = [this](double x) { return this->Quantum * std::round(x / this->Quantum); };
    return { q(this->Tip.X), q(this->Tip.Y), q(this->Tip.Z) };
  }

  static double MinimumJerk(double s)
  {
    const double c = std::clamp(s, 0.0, 1.0);
    return c * c * c * (10.0 - 15.0 * c + 6.0 * c * c);
  }

  Vector3 ComputeTarget(double time) const
  {
    const Vector3 tremor = this->Tremor * std::sin(this->TremorRate * time) * this->TremorAxis;
    const double s = std::max(0.0, time - 0.1);
    if (this->IsTapping)
    {
      const double lead = Dot(this->Start, this->Normal) - 0.001 - 0.5 * this->TapSize;
      const double way =
        this->TapSize * (1.0 - std::cos(this->TapRate * s)) + MinimumJerk(s / 0.5) * lead;
      return this->Start - way * this->Normal + tremor;
    }
    const double turn = this->Time + 0.3;
    const double there =
      s < turn ? MinimumJerk(s / this->Time) : 1.0 - MinimumJerk((s - turn) / this->Time);
    const double along = this->Stroke *
      (MinimumJerk((s - 0.5 * this->Time) / 0.4) - 1.7 * MinimumJerk((s - 0.8) / 0.35));
    return this->Start - there * this->Depth * this->Normal + along * this->Along + tremor;
  }

  /**
   * Returns the force of a half-space with a proxy. Friction holds the proxy, which sinks where the
   * tissue yields.
   */
  Vector3 ComputeWallForce(const Vector3& tip)
  {
    const double depth = -Dot(tip, this->Normal);
    if (depth <= 0.0)
    {
      this->IsInside = false;
      return {};
    }
    if (!this->IsInside)
    {
      this->IsInside = true;
      this->Proxy = tip + depth * this->Normal;
    }
    const Vector3 lag = this->Proxy - tip;
    const Vector3 slide = lag - Dot(lag, this->Normal) * this->Normal;
    const bool yields = this->Yield < 1e8;
    const double press =
      yields ? std::clamp(Dot(lag, this->Normal), 0.0, this->Yield / this->Stiffness) : depth;
    const double most = this->Friction * press;
    const double held = Norm(slide);
    this->Proxy = tip + press * this->Normal + (held > most ? most / held : 1.0) * slide;
    return VolumeHaptics::ClampNorm(this->Stiffness * (this->Proxy - tip), this->MaximumForce);
  }

  /**
   * Moves the hand for one tick under a force, in small semi-implicit steps. Returns the energy (J)
   * that the force delivers.
   */
  double Move(double time, const Vector3& force)
  {
    const int steps = this->Period > 0.5e-3 ? 12 : 4;
    const double h = this->Period / steps;
    double given = 0.0;
    for (int i = 0; i < steps; ++i)
    {
      const double t = time + i * h;
      Vector3 push = force - this->Damping * this->Velocity;
      if (this->IsHeld)
      {
        constexpr double Small = 1e-4;
        const Vector3 target = this->ComputeTarget(t);
        const Vector3 speed = (1.0 / Small) * (this->ComputeTarget(t + Small) - target);
        push +=
          this->HandStiffness * (target - this->Tip) + this->HandDamping * (speed - this->Velocity);
      }
      this->Velocity += (h / this->Mass) * push;
      this->Tip += h * this->Velocity;
      given += h * Dot(force, this->Velocity);
    }
    return given;
  }

  static constexpr double Pi = 3.14159265358979323846;
  std::mt19937 Engine;
  PortKind Kind;
  bool IsHeld;
  double Stiffness; ///< N/m, stiffness of the wall; 0: random

  double Period = 1e-3;
  int Delay = 0;
  int Every = 1;
  double Quantum = 0.0;
  double Mass = 0.0;
  double Damping = 0.0;
  double HandStiffness = 0.0;
  double HandDamping = 0.0;
  double MaximumForce = 0.0;
  double Signs[3] = { 1.0, 1.0, 1.0 };

  Vector3 Normal;
  Vector3 Along;
  double Friction = 0.0;
  double Yield = 0.0; ///< N at which the tissue yields
  bool IsInside = false;
  Vector3 Proxy;

  Vector3 Start;
  Vector3 Tip;
  Vector3 Velocity;
  bool IsTapping = false;
  double Stroke = 0.0; ///< m, length of a stroke along the wall
  double Depth = 0.0;  ///< m from the start to the goal
  double Time = 0.0;   ///< s, duration of the motion to the goal
  double Tremor = 0.0; ///< m, amplitude
  double TremorRate = 0.0;
  Vector3 TremorAxis;
  double TapRate = 0.0;
  double TapSize = 0.0;
};
} // namespace rigs

#endif
