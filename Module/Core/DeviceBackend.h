// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The narrow interface between the servo and a haptic device.
 *
 * A back end knows nothing of volumes, solvers or VTK: it says where the tip is and takes a force.
 * Positions and forces are in the device's space: metres, newtons, a right-handed frame of the
 * device's own. Vendor libraries are added by deriving from this class.
 */
#ifndef DeviceBackend_h
#define DeviceBackend_h

#include "ForceCaps.h"
#include "Vector3.h"

#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/** What a device can stand. */
struct DeviceLimits
{
  double MaximumForce = 0.0;     ///< N
  double MaximumStiffness = 0.0; ///< N/m; 0 where the device does not limit it
  double MaximumDamping = 0.0;   ///< N s/m; 0 where the device does not limit it
  double MaximumSpeed = 0.0;     ///< m/s, above which the hand has lost the stylus; 0 for no limit
  double Damping = 0.0;          ///< N s/m, the device's own friction b; 0 where it is not known
  double WorkspaceRadius = 0.0;  ///< m
};

/**
 * What a device can hold at a tick period (s): its own limits, and a stiffness of 2 b / period, above
 * which a sampled spring feeds energy in.
 */
inline ForceCaps CapsOf(const DeviceLimits& limits, double period) noexcept
{
  const double sampled = 2.0 * limits.Damping / period;
  return { TighterCap(limits.MaximumStiffness, sampled), limits.MaximumDamping };
}

/** What a device reports in a tick. */
struct DeviceSample
{
  Vector3 Tip;               ///< m
  std::uint32_t Buttons = 0; ///< bit 0 is the main one
  bool Fresh = false;        ///< measured since the last Read
  bool Begins = false;       ///< the stylus is taken up here; where it was before means nothing
};

enum class DeviceState : std::uint8_t
{
  Running,  ///< reads and writes go through
  Finished, ///< there is nothing more to come, such as at the end of a replay
  Lost      ///< unplugged or broken; the back end has to be opened again
};

class DeviceBackend
{
public:
  DeviceBackend() = default;
  virtual ~DeviceBackend() = default;
  DeviceBackend(const DeviceBackend&) = delete;
  DeviceBackend& operator=(const DeviceBackend&) = delete;

  ///@{
  /**
   * Outside the servo loop. Open returns false, with the reason and the cure, where the device
   * can't be had; Close sends zero force first.
   */
  virtual bool Open(std::string& error) = 0;
  virtual void Close() = 0;
  virtual std::string GetName() const = 0;
  virtual DeviceLimits GetLimits() const = 0;
  ///@}

  ///@{
  /**
   * Once a tick each, in the servo loop: no lock, no allocation, no exception, and no wait beyond a
   * fraction of the period. Read comes first.
   */
  virtual DeviceState Read(double period, DeviceSample& sample) noexcept = 0;
  virtual DeviceState Write(const Vector3& force) noexcept = 0;
  ///@}

  /**
   * From any thread, when the servo thread does not answer: no force from now on until Write is
   * called again.
   */
  virtual void Quench() noexcept = 0;
};

} // namespace VolumeHaptics

#endif
