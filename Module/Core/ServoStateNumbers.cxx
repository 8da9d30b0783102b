// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ServoTick.h"

#include <limits>

namespace VolumeHaptics
{
namespace
{

template <typename Vector, typename Function>
void VisitVector(Vector& v, Function&& visit)
{
  visit(v.X);
  visit(v.Y);
  visit(v.Z);
}

template <typename Shape, typename Function>
void VisitQuadric(Shape& shape, Function&& visit)
{
  VisitVector(shape.Centre, visit);
  VisitVector(shape.Gradient, visit);
  VisitVector(shape.Curvature.Diagonal, visit);
  VisitVector(shape.Curvature.Mixed, visit);
}

template <typename State, typename Function>
void VisitPrecise(State& precise, Function&& visit)
{
  VisitVector(precise.ReachedTip, visit);
  visit(precise.Level);
  visit(precise.IsHeld);
  visit(precise.Spring.Tissue);
  visit(precise.Spring.Tension);
  visit(precise.Spring.Reserve);
  visit(precise.Gain);
  auto& here = precise.Here;
  VisitVector(here.Normal, visit);
  visit(here.GradientMagnitude);
  visit(here.SurfaceValue);
  visit(here.MediumValue);
  visit(here.Stiffness);
  visit(here.Friction);
  visit(here.Viscosity);
  visit(here.SurfaceStrength);
  visit(here.Value);
  visit(here.Slope);
  visit(precise.Stray);
}

template <typename State, typename Function>
void VisitLocal(State& local, Function&& visit)
{
  visit(local.Surface.IsThere);
  VisitQuadric(local.Surface.Shape, visit);
  VisitVector(local.Place, visit);
  visit(local.IsHeld);
  VisitVector(local.Tip, visit);
  VisitVector(local.Fading, visit);
  visit(local.Fall);
  visit(local.Age);
  visit(local.Number);
  VisitVector(local.Asked.Where, visit);
  VisitVector(local.Asked.Ahead, visit);
  VisitVector(local.Asked.Normal, visit);
}

void Read(double number, double& value)
{
  value = number;
}

void Read(double number, bool& value)
{
  value = number != 0.0;
}

/** A file may hold any number. */
void Read(double number, std::uint32_t& value)
{
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  value = number >= 0.0 && number <= most ? static_cast<std::uint32_t>(number) : 0;
}

/** Every number of a state, in the order of the structs. */
template <typename State, typename Function>
void VisitState(State& state, Function&& visit)
{
  VisitVector(state.Proxy, visit);
  VisitVector(state.PreviousTip, visit);
  visit(state.Enabled);
  VisitPrecise(state.Precise, visit);
  VisitLocal(state.Local, visit);
}

} // namespace

std::array<double, ServoStateSize> ToNumbers(const ServoState& state) noexcept
{
  std::array<double, ServoStateSize> numbers;
  std::size_t i = 0;
  VisitState(state, [&](auto value) { numbers[i++] = static_cast<double>(value); });
  return numbers;
}

ServoState FromNumbers(const std::array<double, ServoStateSize>& numbers) noexcept
{
  ServoState state;
  std::size_t i = 0;
  VisitState(state, [&](auto& value) { Read(numbers[i++], value); });
  return state;
}

} // namespace VolumeHaptics
