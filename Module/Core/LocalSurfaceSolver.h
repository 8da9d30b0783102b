// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The servo's side of HapticMethod::LocalSurface: a surface that a slow loop renews.
 *
 * After Mark et al., "Adding Force Feedback to Graphics Systems", 1996. The proxy x is the point of the surface
 * depth(x) = 0 (LocalSurface.h) that is nearest to the tip, as far as friction lets it: no farther from it than
 * mu |x_tip - x|. The force is k (x - x_tip), with the material at HapticSettings::IsoValue; the surface holds without
 * limit, and there is no drag.
 *
 * Every 1 / LocalSurfaceRate a question goes out, and the answer to the last one comes in. Until RecoveryTime
 * later what is felt is the blend of both surfaces, depth = (1 - s) depth_old + s depth_new with s growing
 * from 0 to 1: the force is continuous. A surface that appears, or of which the slow loop finds nothing any more,
 * comes and goes with a share of k that grows to 1 or falls to 0 in that time. A RecoveryTime longer than the
 * period of the slow loop makes the surface lag behind.
 */
#ifndef LocalSurfaceSolver_h
#define LocalSurfaceSolver_h

#include "LocalSurface.h"

#include <cstdint>

namespace VolumeHaptics
{
struct ServoState;
struct TickRecord;

/** What LOCAL_SURFACE keeps from tick to tick; in the world. */
struct LocalState
{
  Quadric Old; ///< what was felt when New came; around New's centre
  Quadric New;
  double Share = 0.0;       ///< of the stiffness; 0 where there is no surface
  bool IsComing = false;    ///< whether Share grows to 1; else it falls to 0
  std::uint32_t Ticks = 0;  ///< since New came
  std::uint32_t Age = 0;    ///< ticks since Asked
  std::uint32_t Number = 0; ///< of Asked
  bool IsHeld = false;      ///< whether the proxy is on the surface
  LocalQuestion Asked;
};

/** Where surfaces come from. */
struct LocalAnswer
{
  /** The tick finds the surface itself, as late as a slow loop of LocalSurfaceRate would. */
  static LocalAnswer Simulated() noexcept { return { true, nullptr }; }

  bool IsSimulated = false;
  const LocalSurface* Surface = nullptr; ///< to state.Local.Asked; null where it is still to come
};

/** One tick from record.Tip; writes all of the record. */
void StepLocalSurface(const HapticModel& model, ServoState& state, TickRecord& record,
  const LocalAnswer& answer) noexcept;

/** Forgets all surfaces, and asks for one near a place in the world. */
void StartLocalSurface(const Vector3& where, LocalState& local) noexcept;

} // namespace VolumeHaptics

#endif
