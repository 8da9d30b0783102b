// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Random sessions of an arm, a device and a volume in closed loop through the safety stage: honest
 * sessions, and unstable loops.
 *
 * These sessions share nothing with PortSessions.h, with which the bounds of the observers were
 * chosen. The arm is a second mass, led by muscles along a path, that holds the device's mass by a
 * soft grip. The device has viscous friction and friction with a Stribeck curve, so that it sticks
 * and slips:
 *
 *   m x''  = F - b x' - f(x') + c (y' - x') + g (y - x),
 *   M y''  = -c (y' - x') - g (y - x) + C (p' - y') + K (p - y),
 *
 * with x the device, y the arm and p the path, which has a tremor of three sines of 8 to 12 Hz. It
 * is integrated with classical Runge-Kutta steps of at most 125 us. Figures of arm and grip: hands
 * of 0.2 to 1.2 kg on 20 to 400 N/m (Hajian and Howe, "Identification of the mechanical impedance
 * at the human finger tip", 1997), voluntary motion of at most 6 Hz and 10 m/s^2, tremor as in
 * HeldDevice.h.
 *
 * The volume is a plane or a sphere with friction, a rippled surface, tissue that yields, a thick
 * fluid, a wall that is published at a new place 30 or 60 times a second, or the force fields of
 * the method FORCE_FIELD: layers, a well, and a vortex, which gives energy as long as a hand
 * circles with it.
 *
 * The loop of a spring k on a mass with damping b, sampled with period T and with forces late by d,
 * is stable if b > k (d + T / 2), to first order. Honest loops have b > 1.3 k (d + T / 2), counting
 * the device's own friction and half of the grip's. Unstable loops have a fraction of that.
 */
#ifndef ArmSessions_h
#define ArmSessions_h

#include "Core/Safety/SafetyStage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <random>

namespace rigs
{

enum class Matter : std::uint8_t
{
  Plane,
  Sphere,
  Ripples,
  Tissue,
  Fluid,
  Moving,
  Layers,
  Well,
  Vortex
};

enum class Gesture : std::uint8_t
{
  Rest,
  Press,
  Tap,
  Stroke,
  Scrub
};

/** Random parameters of a session. */
struct ArmScene
{
  double Rate = 1000.0;  ///< Hz, of the servo
  int Delay = 0;         ///< ticks until a force acts
  int Every = 1;         ///< ticks from one report to the next
  double Quantum = 1e-5; ///< m, resolution of the encoders
  double Mass = 0.1;     ///< kg, mass of the device
  double Damping = 1.0;  ///< N s/m, damping of the device
  double Static = 0.0;   ///< N, static friction of the device
  double Kinetic = 0.0;  ///< N, kinetic friction of the device
  bool IsHeld = true;    ///< whether a hand holds the device; if not, a weight presses
  double Weight = 0.0;   ///< N, downwards
  double ArmMass = 0.5;  ///< kg, mass of the arm
  double Grip = 500.0;   ///< N/m, stiffness of the grip
  double GripLoss = 5.0; ///< N s/m, damping of the grip
  double Muscle = 100.0; ///< N/m, stiffness of the muscles
  double MuscleLoss = 5.0;
  double Tremor = 0.0; ///< m, amplitude
  Gesture Motion = Gesture::Press;
  double Speed = 0.1;  ///< m/s, speed of strokes
  double Beat = 2.0;   ///< Hz, frequency of taps and scrubs
  double Depth = 0.01; ///< m, depth of the path in the wall
  Matter What = Matter::Plane;
  double Stiffness = 500.0; ///< N/m, of the wall
  double Friction = 0.0;
  double MaximumForce = 4.0;   ///< N, limit of the safety stage
  double MaximumDamping = 0.0; ///< N s/m, limit of the safety stage
  double Seconds = 2.0;
};

struct ArmResult
{
  bool IsDamped = false;
  bool IsCut = false;       ///< whether a fault ended the session
  bool RanAway = false;     ///< whether PortObserver caused the fault
  double GivenDamped = 0.0; ///< J, energy that the device gave until it was damped
  double Given = 0.0;       ///< J, energy that the device gave until the end or a fault
  double WayDamped = 0.0;   ///< m, range of the tip's heights in the second before the damping
  double Way = 0.0;         ///< m, range of the tip's heights until the end or a fault
  double LastSwing = 0.0;   ///< m, range of the tip's heights in the last 0.2 s
};

class ArmSession
{
public:
  ArmSession(const ArmScene& scene, std::uint32_t seed)
    : S(scene)
    , Engine(seed)
  {
    for (Wave& wave : this->Waves)
    {
      wave = { 2.0 * Pi * this->Pick(8.0, 12.0), this->Pick(0.0, 2.0 * Pi), this->Pick(-1.0, 1.0),
        this->Pick(-1.0, 1.0), this->Pick(-1.0, 1.0) };
    }
    this->WaveLength = this->Pick(0.5e-3, 4e-3);
    // Along the surface, the slope of the force is k depth height (2 pi / length)^2. Limit this
    // slope to k.
    const double turn = 2.0 * Pi / this->WaveLength;
    const double deepest = scene.MaximumForce / (RippleFraction * scene.Stiffness);
    this->WaveHeight =
      std::min(this->Pick(0.02, 0.15) * this->WaveLength, 1.0 / (turn * turn * deepest));
    this->Phase = this->Pick(0.0, 1.0);
    this->PublishTime = this->Pick(0.0, 1.0) < 0.5 ? 1.0 / 30.0 : 1.0 / 60.0;
  }

  static ArmScene DrawHonest(std::uint32_t seed)
  {
    std::mt19937 engine(seed ^ 0x5bd1e995u);
    const auto pick = [&engine](double a, double b) { return a + (b - a) * (engine() * 0x1p-32); };
    const auto scale = [&pick](double a, double b) { return a * std::pow(b / a, pick(0.0, 1.0)); };
    ArmScene s;
    s.Rate = pick(0, 1) < 0.4 ? 1000.0 : pick(0, 1) < 0.5 ? 2000.0 : 4000.0;
    s.Delay = static_cast<int>(pick(0.0, 3.999));
    s.Every = pick(0, 1) < 0.2 ? static_cast<int>(8e-3 * s.Rate + 0.5) : 1;
    s.Quantum = pick(0, 1) < 0.1 ? 0.0 : scale(2e-6, 6e-5);
    s.Mass = scale(0.04, 0.25);
    s.Damping = scale(0.2, 6.0);
    s.Static = pick(0, 1) < 0.5 ? 0.0 : pick(0.02, 0.4);
    s.Kinetic = pick(0.5, 1.0) * s.Static;
    s.ArmMass = scale(0.2, 1.2);
    s.Grip = scale(150.0, 2500.0);
    s.GripLoss = pick(0.15, 0.6) * std::sqrt(s.Grip * s.Mass);
    s.Muscle = scale(20.0, 400.0);
    s.MuscleLoss = pick(0.4, 1.2) * 2.0 * std::sqrt(s.Muscle * s.ArmMass);
    s.Tremor = pick(0, 1) < 0.3 ? 0.0 : scale(3e-5, 8e-4);
    s.Motion = static_cast<Gesture>(engine() % 5);
    s.Speed = scale(0.02, 0.4);
    s.Beat = pick(0.7, 6.0);
    s.Depth = scale(1e-3, 4e-2);
    s.What = static_cast<Matter>(engine() % 9);
    s.Friction = pick(0, 1) < 0.5 ? 0.0 : pick(0.1, 0.8);
    s.MaximumForce = (pick(0, 1) < 0.5 ? 4.0 : 10.0) * pick(0.3, 1.0);
    s.MaximumDamping = pick(0, 1) < 0.5 ? 0.0 : scale(2.0, 40.0);
    const double lag = (0.5 * s.Every + s.Delay) / s.Rate;
    s.Stiffness = std::min(scale(100.0, 5000.0), (s.Damping + 0.5 * s.GripLoss) / (1.3 * lag));
    return s;
  }

  ArmResult Run()
  {
    using namespace VolumeHaptics;
    const double period = 1.0 / this->S.Rate;
    SafetyLimits limits;
    limits.MaximumForce = this->S.MaximumForce;
    limits.MaximumDamping = this->S.MaximumDamping;
    limits.MovesTip = true;
    // Only a hand waits for the force. A weight does not wait, so its session has no ramp.
    limits.RampTime = this->S.IsHeld ? limits.RampTime : 0.0;
    ForceGate gate;
    SafetyStage stage;
    gate.Arm();
    stage.Reset();
    ArmResult result;
    SafetyInput input;
    input.Period = input.Elapsed = period;
    std::deque<Vector3> onTheWay(static_cast<std::size_t>(this->S.Delay));
    this->Body[0] = this->Body[2] =
      this->S.IsHeld ? this->ComputePath(0.0) : Vector3{ 0.0, 0.0, 2e-4 };
    double given = 0.0;
    const int ticks = static_cast<int>(this->S.Seconds * this->S.Rate);
    double low = 1.0;
    double high = -1.0;
    for (int i = 0; i < ticks; ++i)
    {
      const double time = i * period;
      input.Fresh = i % this->S.Every == 0;
      const Vector3 before = input.Tip;
      input.Tip = input.Fresh ? this->Measure() : input.Tip;
      input.MotionTime = input.Fresh ? this->S.Every * period : 0.0;
      input.IsNew = this->Publish(time);
      input.Drag = {};
      input.Force = this->ComputeForce(input.Tip);
      if (this->S.What == Matter::Fluid && input.Fresh && i > 0)
      {
        this->Drag = (-0.3 * this->S.Stiffness * period) * (1.0 / (this->S.Every * period)) *
          (input.Tip - before);
      }
      if (this->S.What == Matter::Fluid)
      {
        input.Force = input.Drag = this->Drag;
      }
      const bool isField = this->S.What >= Matter::Fluid;
      input.Stiffness = isField ? 0.0 : this->S.Stiffness;
      input.Stretch = isField ? 0.0 : Norm(input.Force) / this->S.Stiffness;
      gate.ReportData(1.0, period);
      const Vector3 sent = stage.Apply(input, limits, gate);
      onTheWay.push_back(sent);
      const Vector3 acting = onTheWay.front();
      onTheWay.pop_front();
      const bool isCut = gate.GetFault() != GateReason::None;
      if (stage.IsDamping() && !result.IsDamped)
      {
        result.IsDamped = true;
        result.GivenDamped = given;
        result.WayDamped = high - low;
      }
      if (isCut && !result.IsCut)
      {
        result.IsCut = true;
        result.RanAway = !result.IsDamped;
        result.Given = given;
        break;
      }
      given += this->Move(time, acting);
      const double height = this->Body[0].Z;
      if (time > this->S.Seconds - 0.2)
      {
        this->LastLow = std::min(this->LastLow, height);
        this->LastHigh = std::max(this->LastHigh, height);
      }
      low = i == 0 ? height : std::min(low, height);
      high = i == 0 ? height : std::max(high, height);
      if (Norm(this->Body[0]) > 1.0)
      {
        break;
      }
    }
    result.Given = given;
    result.Way = high - low;
    result.LastSwing = std::max(0.0, this->LastHigh - this->LastLow);
    return result;
  }

private:
  using Vector3 = VolumeHaptics::Vector3;
  using State = std::array<Vector3, 4>; ///< position and velocity of the device, and then of the
                                        ///< arm

  static constexpr double Pi = 3.14159265358979323846;
  /**
   * Fraction of the stiffness from which ripples are made, which limits the surface's stiffness in
   * every direction.
   */
  static constexpr double RippleFraction = 0.4;
  double Pick(double from, double to) { return from + (to - from) * (this->Engine() * 0x1p-32); }

  Vector3 Measure() const
  {
    const double quantum = this->S.Quantum;
    const auto count = [quantum](double x)
    { return quantum > 0.0 ? quantum * std::floor(x / quantum + 0.5) : x; };
    return { count(this->Body[0].X), count(this->Body[0].Y), count(this->Body[0].Z) };
  }

  /// Returns the position (m) to which the muscles move the arm. The wall is below z = 0.
  Vector3 ComputePath(double time) const
  {
    Vector3 path;
    const double beat = 2.0 * Pi * this->S.Beat;
    // Limit the acceleration to 10 m/s^2, the maximum of a hand.
    const double most = 10.0 / (beat * beat);
    // Start the motion from rest.
    const double begun = std::clamp((time - 0.1) / 0.5, 0.0, 1.0);
    const double share = begun * begun * (3.0 - 2.0 * begun);
    const double down = share * this->S.Depth;
    switch (this->S.Motion)
    {
      case Gesture::Rest:
        path.Z = 1e-3 - 0.1 * down;
        break;
      case Gesture::Press:
        path.Z = 2e-3 - down * (1.0 + 0.3 * std::sin(3.0 * time));
        break;
      case Gesture::Tap:
        path.Z =
          2e-3 - 0.2 * down + share * std::min(0.5 * this->S.Depth, most) * std::cos(beat * time);
        break;
      case Gesture::Stroke:
        path.Z = 2e-3 - down;
        path.X = this->S.Speed * (std::hypot(time - 0.8, 0.05) + time - 0.8) / 2.0 - 0.02;
        break;
      case Gesture::Scrub:
        path.Z = 2e-3 - down;
        path.X = share * std::min(0.02, most) * std::sin(beat * time);
        path.Y = share * std::min(0.02, most) * std::cos(beat * time);
        break;
    }
    for (const Wave& wave : this->Waves)
    {
      const double swing = 0.4 * share * this->S.Tremor * std::sin(wave.Rate * time + wave.Phase);
      path += Vector3{ swing * wave.X, swing * wave.Y, swing * wave.Z };
    }
    return path;
  }

  bool Publish(double time)
  {
    if (this->S.What != Matter::Moving || time < this->NextPublish)
    {
      return false;
    }
    this->NextPublish += this->PublishTime;
    this->Floor = 2e-3 * std::sin(2.0 * Pi * (0.8 * time + this->Phase));
    return true;
  }

  Vector3 ComputeForce(const Vector3& tip)
  {
    const double k = this->S.Stiffness;
    switch (this->S.What)
    {
      case Matter::Plane:
      case Matter::Moving:
        return this->PushFloor(tip, this->Floor, 1e9);
      case Matter::Tissue:
        return this->PushFloor(tip, 0.0, 0.4 * this->S.MaximumForce / k);
      case Matter::Sphere:
      {
        constexpr double Radius = 0.06;
        constexpr Vector3 Centre{ 0.0, 0.0, -Radius };
        const auto place = [&](const Vector3& p)
        {
          const Vector3 out = p - Centre;
          return Centre + Radius / Norm(out) * out;
        };
        return this->Push(tip, place(tip), Norm(tip - Centre) < Radius, place);
      }
      case Matter::Ripples:
      {
        const double turn = 2.0 * Pi / this->WaveLength;
        const double depth = this->WaveHeight * std::sin(turn * tip.X) - tip.Z;
        const double slope = this->WaveHeight * turn * std::cos(turn * tip.X);
        return depth > 0.0 ? RippleFraction * k * depth * Vector3{ -slope, 0.0, 1.0 } : Vector3{};
      }
      case Matter::Fluid:
        return {};
      case Matter::Layers:
      {
        // The material has layers of 4 mm. The slope of its force is at most k.
        const double turn = 2.0 * Pi / 4e-3;
        return { 0.0, 0.0, k / turn * (1.0 + std::sin(turn * tip.Z)) };
      }
      case Matter::Well:
      {
        constexpr double Size = 6e-3;
        const double share = std::exp(-0.5 * Dot(tip, tip) / (Size * Size));
        return (-k * share) * tip;
      }
      case Matter::Vortex:
      {
        constexpr double Size = 0.02;
        const double share = std::exp(-0.5 * Dot(tip, tip) / (Size * Size));
        return 0.05 * k * share * Vector3{ -tip.Y, tip.X, -0.3 * tip.Z };
      }
    }
    return {};
  }

  /**
   * Computes the force of a wall with a proxy, whose goal is the surface point next to the tip.
   * Friction holds the proxy until it slides along the surface up to the friction cone. `place`
   * projects a point onto the surface.
   */
  template <class Place>
  Vector3 Push(const Vector3& tip, const Vector3& goal, bool isInside, const Place& place)
  {
    if (!isInside)
    {
      this->IsInside = false;
      return {};
    }
    const Vector3 lag = (this->IsInside ? this->Proxy : goal) - goal;
    this->IsInside = true;
    const double held = Norm(lag);
    const double bound = this->S.Friction * Norm(goal - tip);
    if (held > bound || held == 0.0)
    {
      this->Proxy = place(goal + (held > 0.0 ? bound / held : 0.0) * lag);
    }
    return VolumeHaptics::ClampNorm(this->S.Stiffness * (this->Proxy - tip), this->S.MaximumForce);
  }
  /// Computes the force of a floor that sinks where it yields, and remains sunk while the tip is in
  /// it.
  Vector3 PushFloor(const Vector3& tip, double floor, double yield)
  {
    this->Sunk = tip.Z < floor ? std::max(this->Sunk, floor - tip.Z - yield) : 0.0;
    const double level = floor - this->Sunk;
    const auto place = [level](const Vector3& p) { return Vector3{ p.X, p.Y, level }; };
    return this->Push(tip, place(tip), tip.Z < level, place);
  }

  Vector3 ComputeFriction(const Vector3& v) const
  {
    constexpr double Still = 2e-3;
    constexpr double Stribeck = 1e-2;
    const double speed = Norm(v);
    if (this->S.Static == 0.0 || speed == 0.0)
    {
      return {};
    }
    const double level = this->S.Kinetic +
      (this->S.Static - this->S.Kinetic) * std::exp(-speed * speed / (Stribeck * Stribeck));
    return (-level * std::tanh(speed / Still) / speed) * v;
  }

  State ComputeRate(
    const State& b, const Vector3& path, const Vector3& wish, const Vector3& force) const
  {
    Vector3 push = force - this->S.Damping * b[1] + this->ComputeFriction(b[1]);
    if (!this->S.IsHeld)
    {
      push.Z -= this->S.Weight;
      return { b[1], (1.0 / this->S.Mass) * push, Vector3{}, Vector3{} };
    }
    const Vector3 grip = this->S.Grip * (b[2] - b[0]) + this->S.GripLoss * (b[3] - b[1]);
    const Vector3 muscle = this->S.Muscle * (path - b[2]) + this->S.MuscleLoss * (wish - b[3]);
    return { b[1], (1.0 / this->S.Mass) * (push + grip), b[3],
      (1.0 / this->S.ArmMass) * (muscle - grip) };
  }

  static State Add(const State& a, double h, const State& b)
  {
    return { a[0] + h * b[0], a[1] + h * b[1], a[2] + h * b[2], a[3] + h * b[3] };
  }

  /// Moves device and arm for one tick. Returns the energy (J) that the device delivers.
  double Move(double time, const Vector3& force)
  {
    const double period = 1.0 / this->S.Rate;
    const int steps = this->S.Rate < 1500.0 ? 8 : this->S.Rate < 3000.0 ? 4 : 2;
    const double h = period / steps;
    const Vector3 from = this->ComputePath(time);
    const Vector3 wish = this->S.Rate * (this->ComputePath(time + period) - from);
    const Vector3 start = this->Body[0];
    for (int i = 0; i < steps; ++i)
    {
      const auto path = [&](double part) { return from + (h * (i + part)) * wish; };
      const State a = this->ComputeRate(this->Body, path(0.0), wish, force);
      const State b = this->ComputeRate(Add(this->Body, 0.5 * h, a), path(0.5), wish, force);
      const State c = this->ComputeRate(Add(this->Body, 0.5 * h, b), path(0.5), wish, force);
      const State d = this->ComputeRate(Add(this->Body, h, c), path(1.0), wish, force);
      this->Body = Add(Add(Add(Add(this->Body, h / 6.0, a), h / 3.0, b), h / 3.0, c), h / 6.0, d);
    }
    return Dot(force, this->Body[0] - start);
  }

  struct Wave
  {
    double Rate = 0.0; ///< rad/s, angular frequency
    double Phase = 0.0;
    double X = 0.0;
    double Y = 0.0;
    double Z = 0.0;
  };

  ArmScene S;
  std::mt19937 Engine;
  std::array<Wave, 3> Waves;
  double WaveLength = 1e-3; ///< m, of the ripples
  double WaveHeight = 0.0;  ///< m, amplitude of the ripples
  double Phase = 0.0;
  double PublishTime = 0.0; ///< s between models of a moving floor
  double NextPublish = 0.0; ///< s, when the floor moves next
  double Floor = 0.0;       ///< m, height of the moving floor
  double Sunk = 0.0;        ///< m by which the floor has yielded
  bool IsInside = false;
  Vector3 Proxy;
  Vector3 Drag;
  State Body{};
  double LastLow = 1.0;
  double LastHigh = -1.0;
};

} // namespace rigs

#endif
