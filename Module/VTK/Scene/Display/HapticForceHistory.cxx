// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/HapticForceHistory.h"

#include "vtkFloatArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

HapticForceHistory::HapticForceHistory()
{
  for (int c = 0; c < Curves; ++c)
  {
    this->Table.GetForce(c)->Allocate(2 * (Intervals + 2));
  }
  this->Table.GetTime()->Allocate(2 * (Intervals + 2));
}

HapticForceHistory::~HapticForceHistory() = default;

void HapticForceHistory::Add(const State& state, double span)
{
  if (!this->States.empty() && state.Time < this->States.back().Time)
  {
    this->States.clear();
  }
  this->States.push_back(state);
  for (double& force : this->States.back().Forces)
  {
    force = HapticForceTable::MakeDrawable(force);
  }
  while (this->States.front().Time < state.Time - span)
  {
    this->States.pop_front();
  }
  this->IsPlotted = false;
}

void HapticForceHistory::Clear()
{
  this->States.clear();
  this->IsPlotted = false;
}

void HapticForceHistory::SetModes(const std::vector<std::string>& names)
{
  if (this->Table.SetModes(names))
  {
    this->IsPlotted = false;
  }
}

vtkTable* HapticForceHistory::Plot(double span)
{
  if (this->IsPlotted)
  {
    return this->Table.Get();
  }
  this->IsPlotted = true;
  this->Table.Clear();
  const int curves = this->Table.GetCurves();
  const double end = this->States.empty() ? 0.0 : this->States.back().Time;
  const double width = span / Intervals;
  // Count intervals from time 0, not from the present: a peak then stays in its interval.
  const auto intervalOf = [&](const State& s) { return std::floor(s.Time / width); };
  for (auto from = this->States.begin(); from != this->States.end();)
  {
    const double interval = intervalOf(*from);
    std::array<double, Curves> low = from->Forces;
    std::array<double, Curves> high = from->Forces;
    std::array<bool, Curves> isFalling = {}; // the smallest comes after the largest
    auto to = from;
    do
    {
      for (int c = 0; c < curves; ++c)
      {
        const double force = to->Forces[c];
        isFalling[c] = force < low[c] || (isFalling[c] && force <= high[c]);
        low[c] = std::min(low[c], force);
        high[c] = std::max(high[c], force);
      }
      ++to;
    } while (to != this->States.end() && intervalOf(*to) == interval);
    const double times[2] = { from->Time, (to - 1)->Time };
    for (int i = 0; i < 2; ++i)
    {
      this->Table.GetTime()->InsertNextValue(static_cast<float>(times[i] - end));
      for (int c = 0; c < curves; ++c)
      {
        const bool isLow = (i == 1) == isFalling[c];
        this->Table.GetForce(c)->InsertNextValue(static_cast<float>(isLow ? low[c] : high[c]));
      }
    }
    from = to;
  }
  this->Table.Get()->Modified();
  return this->Table.Get();
}

double HapticForceHistory::GetRange() const
{
  double largest = 0.0;
  for (const State& state : this->States)
  {
    largest = std::max(largest, *std::max_element(state.Forces.begin(), state.Forces.end()));
  }
  // Leave room above the curve; at least half a newton, so that noise does not fill the plot.
  const double wanted = std::max(0.5, 1.05 * largest);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (wanted <= factor * power * (1.0 + 1e-9))
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

} // namespace VolumeHaptics
