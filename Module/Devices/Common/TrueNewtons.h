// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts true newtons to a driver's newtons: the last step before a device.
 */
#ifndef TrueNewtons_h
#define TrueNewtons_h

#include "Core/Safety/DeviceBackend.h"

#include <algorithm>
#include <atomic>

namespace VolumeHaptics
{

/** See DeviceBackend::SetForceScale. Any thread. */
class TrueNewtons
{
public:
  /** `most` (N) is the largest force that the driver may be asked for. */
  void Set(double scale, double most) noexcept
  {
    this->MostAsked.store(most);
    this->Scale.store(scale);
  }
  /** The limits of a device in true newtons, within what the driver allows. */
  DeviceLimits LimitsOf(DeviceLimits limits) const noexcept
  {
    limits.MaximumForce *= std::min(1.0, this->Scale.load());
    return limits;
  }
  /** The force to ask the driver for (N). */
  Vector3 Ask(const Vector3& force) const noexcept
  {
    const double scale = this->Scale.load(std::memory_order_relaxed);
    return scale == 1.0
      ? force
      : ClampNorm((1.0 / scale) * force, this->MostAsked.load(std::memory_order_relaxed));
  }

private:
  std::atomic<double> Scale{ 1.0 };
  std::atomic<double> MostAsked{ 0.0 };
};

} // namespace VolumeHaptics

#endif
