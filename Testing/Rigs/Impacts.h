// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A mass without damping that hits a spring, in closed loop through the safety stage.
 *
 * The motion is exact for a constant force in every tick: x += v T + a T^2 / 2, v += a T.
 */
#ifndef Impacts_h
#define Impacts_h

#include "GatedStage.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <limits>
#include <vector>

namespace rigs
{
namespace impacts
{
using namespace VolumeHaptics;

inline constexpr double Period = 1e-3;

/// A function that returns the requested force (N) at a position (m).
using Field = std::function<Vector3(const Vector3&)>;

struct Body
{
  double Mass = 0.15; ///< kg, of the body
  Vector3 Place;      ///< m
  Vector3 Velocity;   ///< m/s

  double Energy() const { return 0.5 * this->Mass * Dot(this->Velocity, this->Velocity); }
  void Move(const Vector3& force, double period = Period)
  {
    const Vector3 a = (1.0 / this->Mass) * force;
    this->Place += period * this->Velocity + 0.5 * period * period * a;
    this->Velocity += period * a;
  }
};

struct Loop
{
  double MaximumForce = 8.0; ///< N
  double ForceRate = 500.0;  ///< N/s, slew limit
  double Tick = Period;      ///< s, duration of a tick
  std::size_t Delay = 0;     ///< ticks until a force of the stage acts
  int Every = 1;             ///< ticks between measured tips
  double Stiffness = 0.0;    ///< N/m, stiffness that is reported to the stage
  double LargestGrowth = 0.0;

  /// Moves the body until it has touched the wall and is free again. Returns the energy (J) with
  /// which the body leaves.
  double Fly(Body body, const Field& field)
  {
    SafetyLimits limits;
    limits.MaximumForce = this->MaximumForce;
    limits.MaximumForceRate = this->ForceRate;
    limits.RampTime = 0.0;
    SafetyInput input;
    input.Stiffness = this->Stiffness;
    input.Elapsed = input.Period = this->Tick;
    input.Fresh = true;
    input.Tip = body.Place;
    GatedStage stage;
    stage.Arm();
    stage.Apply(input, limits); // the ramp ends in free space
    std::deque<Vector3> onTheWay(this->Delay);
    Vector3 last;
    bool touched = false;
    for (int i = 0; i < 20000; ++i)
    {
      input.Fresh = i % this->Every == 0;
      input.Tip = input.Fresh ? body.Place : input.Tip;
      input.Force = field(input.Tip);
      const Vector3 force = stage.Apply(input, limits);
      this->LargestGrowth = std::max(this->LargestGrowth, Norm(force) - Norm(last));
      last = force;
      const bool isFree = Norm(input.Force) == 0.0;
      if (isFree && touched)
      {
        return body.Energy();
      }
      touched = !isFree;
      onTheWay.push_back(force);
      body.Move(onTheWay.front(), this->Tick);
      onTheWay.pop_front();
    }
    return std::numeric_limits<double>::infinity(); // the body never leaves the wall
  }
  /// Like Fly(), without a slew limit. If `most` (N) is larger than all forces, the force is not
  /// limited either.
  double FlyFreely(const Body& body, const Field& field, double most = 0.0) const
  {
    Loop loop = *this;
    loop.ForceRate = 1e9;
    loop.MaximumForce = std::max(most, loop.MaximumForce);
    return loop.Fly(body, field);
  }
};

/// Returns the force of a spring below z = 0.
inline Field MakeWall(double stiffness)
{
  return [stiffness](const Vector3& x) {
    return Vector3{ 0.0, 0.0, stiffness * std::max(0.0, -x.Z) };
  };
}

/// Returns a body that flies towards the wall and reaches it after a fraction `phase` of a tick.
inline Body Throw(double mass, double speed, double phase)
{
  return { mass, { 0.0, 0.0, phase * speed * Period }, { 0.0, 0.0, -speed } };
}

/// A case of the specification: a body of 0.15 kg flies against a wall.
struct Rebound
{
  double Tick = 0.0;         ///< s, duration of a tick
  double Stiffness = 0.0;    ///< N/m, of the wall
  double Speed = 0.0;        ///< m/s, before the impact
  double MaximumForce = 0.0; ///< N
  std::size_t Delay = 0;     ///< ticks
  double Left = 0.0;         ///< J, energy after the impact with the stage
  double Unlimited = 0.0;    ///< J, with a stage that only limits the force
  double Free = 0.0;         ///< J, energy left without a stage
};

/// Computes the energies of a case, averaged over a hundred phases of the ticks, because the phase
/// changes the energy that sampling adds.
inline Rebound Fly(Rebound r)
{
  constexpr int phases = 100;
  for (int phase = 1; phase <= phases; ++phase)
  {
    Loop loop;
    loop.MaximumForce = r.MaximumForce;
    loop.Tick = r.Tick;
    loop.Delay = r.Delay;
    const Body body = Throw(0.15, r.Speed, static_cast<double>(phase) / phases * r.Tick / Period);
    r.Left += loop.Fly(body, MakeWall(r.Stiffness)) / phases;
    r.Unlimited += loop.FlyFreely(body, MakeWall(r.Stiffness)) / phases;
    r.Free += loop.FlyFreely(body, MakeWall(r.Stiffness), 1e6) / phases;
  }
  return r;
}

/// Returns the results of all 144 cases.
inline std::vector<Rebound> FlyAll()
{
  std::vector<Rebound> all;
  for (const double tick : { 1e-3, 0.25e-3 })
  {
    for (const double k : { 1000.0, 3000.0 })
    {
      for (const double speed : { 0.1, 0.2, 0.3, 0.5, 0.7, 1.0 })
      {
        for (const double most : { 2.0, 4.0, 8.0 })
        {
          for (const std::size_t delay : { 0, 1 })
          {
            all.push_back(Fly({ tick, k, speed, most, delay }));
          }
        }
      }
    }
  }
  return all;
}

} // namespace impacts
} // namespace rigs

#endif
