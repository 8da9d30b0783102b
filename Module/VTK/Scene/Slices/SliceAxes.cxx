// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Slices/SliceAxes.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** The index axis nearest to each axis of the world; each index axis is used once. */
std::array<SignedAxis, 3> MatchWorldAxes(vtkMatrix3x3* direction)
{
  std::array<int, 3> order{ 0, 1, 2 };
  std::array<int, 3> best = order;
  double most = -1.0;
  do
  {
    double sum = 0.0;
    for (int world = 0; world < 3; ++world)
    {
      sum += std::abs(direction->GetElement(world, order[world]));
    }
    if (sum > most)
    {
      most = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  std::array<SignedAxis, 3> axes;
  for (int world = 0; world < 3; ++world)
  {
    axes[world] = { best[world], direction->GetElement(world, best[world]) < 0.0 ? -1 : 1 };
  }
  return axes;
}

SignedAxis Backwards(SignedAxis axis)
{
  return { axis.Axis, -axis.Sign };
}

} // namespace

std::array<SliceAxes, 3> FindSliceAxes(vtkImageData* image, bool anatomical)
{
  if (!anatomical)
  {
    const SignedAxis i{ 0, 1 };
    const SignedAxis j{ 1, 1 };
    const SignedAxis k{ 2, 1 };
    return { SliceAxes{ k, i, j, "k" }, SliceAxes{ j, i, k, "j" }, SliceAxes{ i, j, k, "i" } };
  }
  const auto [left, back, head] = MatchWorldAxes(image->GetDirectionMatrix());
  return { SliceAxes{ head, left, Backwards(back), "Axial", { "R", "L", "P", "A" } },
    SliceAxes{ back, left, head, "Coronal", { "R", "L", "I", "S" } },
    SliceAxes{ left, back, head, "Sagittal", { "A", "P", "I", "S" } } };
}

} // namespace VolumeHaptics
