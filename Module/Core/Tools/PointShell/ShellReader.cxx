// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/PointShell/ShellReader.h"

#include "Core/Field/WholeData.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

ShellFunctions SelectBaselineShellFunctions(ScalarType type);
#ifdef VOLUME_HAPTICS_HAS_AVX2
ShellFunctions SelectAVX2ShellFunctions(ScalarType type);
#endif

ShellReader::ShellReader(
  const VolumeView& view, double level, bool isBelow, InstructionSet instructions) noexcept
{
  this->Reading.View.Volume = view;
  this->Reading.View.Volume.Data = WholeData(view);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Reading.View.First[axis] = static_cast<double>(view.First[axis]);
    this->Reading.View.Last[axis] = static_cast<double>(view.Last(axis));
    this->Reading.Border[axis] = static_cast<double>(view.Border(axis));
  }
  this->Reading.Level = level;
  this->Reading.Sign = isBelow ? -1.0 : 1.0;
#ifdef VOLUME_HAPTICS_HAS_AVX2
  if (instructions == InstructionSet::AVX2)
  {
    this->Functions = SelectAVX2ShellFunctions(view.Type);
    return;
  }
#else
  static_cast<void>(instructions);
#endif
  this->Functions = SelectBaselineShellFunctions(view.Type);
}

bool ShellReader::MayBeSolid(const Vector3& centre, const Vector3& half) const noexcept
{
  constexpr double mostSamples = 4096.0;
  const double middle[3] = { centre.X, centre.Y, centre.Z };
  const double sizes[3] = { half.X, half.Y, half.Z };
  std::int64_t low[3];
  std::int64_t high[3];
  double samples = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double first = this->Reading.View.First[axis];
    const double last = this->Reading.View.Last[axis];
    // Beyond the samples that are here, values are those of the nearest ones.
    const double from = std::floor(middle[axis] - sizes[axis]);
    const double to = std::floor(middle[axis] + sizes[axis]) + 1.0;
    // Also false for NaN.
    if (!(to - from < mostSamples))
    {
      return true;
    }
    low[axis] = static_cast<std::int64_t>(std::min(std::max(from, first), last));
    high[axis] = static_cast<std::int64_t>(std::min(std::max(to, first), last));
    samples *= static_cast<double>(high[axis] - low[axis] + 1);
  }
  return samples > mostSamples || this->Functions.Box(this->Reading, low, high);
}

} // namespace VolumeHaptics
