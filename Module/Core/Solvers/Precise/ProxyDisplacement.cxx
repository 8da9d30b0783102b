// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/ProxyDisplacement.h"

namespace VolumeHaptics
{

Vector3 ProxyDisplacement::ComputeInParts(const PrecisePoint& here, double k, double longest,
  const Vector3& lagBefore, const Vector3& lag, double parts) noexcept
{
  const double compliance = 1.0 / k;
  const Vector3 step = lag - lagBefore;
  Vector3 displacement;
  for (double part = 1.0; part <= parts; part += 1.0)
  {
    const Vector3 from = lagBefore + ((part - 1.0) / parts) * step - displacement;
    const Vector3 to = lagBefore + (part / parts) * step - displacement;
    const SplitLag split = Law::Split(to, here.Normal);
    displacement += ComputePart(here, compliance, longest, from, Law::Split(from, here.Normal), to,
      split, [&] { return Law::Move(here, k, split, Law::Weigh(here, k, split), Vector3{}); });
  }
  return displacement;
}

} // namespace VolumeHaptics
