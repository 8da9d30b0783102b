// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/HandleSweep.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Longest time step (s) that is integrated. After a longer pause of the program, the spring must
/// not jump, and the handle must not count as stuck.
constexpr double LongestStep = 0.05;

} // namespace

void HandleSweep::Begin(int axis, double place, double shift, int pairs)
{
  *this = HandleSweep();
  this->Axis = axis;
  this->Place = place;
  this->Shift = shift;
  this->Pairs = static_cast<std::size_t>(pairs);
}

void HandleSweep::EndWay()
{
  std::array<double, 3> mean{};
  for (int i = 0; i < 3 && this->SumTime > 0.0; ++i)
  {
    mean[i] = this->Sum[i] / this->SumTime;
  }
  const bool isUp = this->Direction > 0.0;
  // the first upward sweep only leads to the start of the downward sweep
  if (isUp && this->Ways > 0)
  {
    Reading reading;
    for (int i = 0; i < 3; ++i)
    {
      reading.Force[i] = 0.5 * (mean[i] + this->Down[i]);
    }
    reading.Friction = 0.5 * (mean[this->Axis] - this->Down[this->Axis]);
    this->Readings.push_back(reading);
  }
  this->Down = mean;
  this->Sum = {};
  this->SumTime = 0.0;
  this->WayTime = 0.0;
  this->Direction = -this->Direction;
  ++this->Ways;
}

void HandleSweep::Step(const HeldSample& sample)
{
  if (this->IsDone() || this->IsStuck())
  {
    return;
  }
  const double above = sample.Tip[this->Axis] - this->Place;
  if (std::abs(above) <= Window)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Sum[i] += sample.Elapsed * sample.Force[i];
    }
    this->SumTime += sample.Elapsed;
  }
  const double moved = std::min(sample.Elapsed, LongestStep);
  this->WayTime += moved;
  this->Shift += this->Direction * Speed * moved;
  if (this->Direction * above >= Reach)
  {
    this->EndWay();
  }
}
