// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Defines how the explorer and ParaView's plugin draw a CT volume: the surface that a hand meets
 * first, in the colours of skin and bone.
 */
#ifndef CTLook_h
#define CTLook_h

#include <array>

namespace VolumeHaptics
{

/** A point of the transfer functions, between which opacity and colour change linearly. */
struct LookStop
{
  double Value;
  double Opacity; ///< opacity of a layer with the thickness LookLayer
  std::array<double, 3> Color;
};

/**
 * Thickness (voxels) of the layer that opacities refer to. With it, half of the picture comes from
 * the first half voxel, and rays that sample once per voxel show no steps.
 */
constexpr double LookLayer = 4.0;
/** Opacity of tissue that is felt. */
constexpr double LookOpaque = 0.998;

/**
 * Hounsfield units between which the opacity rises from zero to full: the edge from air to fat and
 * skin, where a hand meets a body. Invisible tissue is not felt, so neither are foam and blankets
 * around a body, which are hardly visible.
 */
constexpr double CTLookClear = -350.0;
constexpr double CTLookSkin = -300.0;

/** Opacity and colour by Hounsfield units. */
constexpr LookStop CTLook[] = {
  { -1024.0, 0.0, { 0.85, 0.60, 0.47 } },
  { CTLookClear, 0.0, { 0.85, 0.60, 0.47 } },
  { CTLookSkin, LookOpaque, { 0.93, 0.69, 0.56 } },
  { -100.0, LookOpaque, { 0.93, 0.69, 0.56 } },
  { 0.0, LookOpaque, { 0.86, 0.52, 0.44 } },
  { 130.0, LookOpaque, { 0.90, 0.66, 0.56 } },
  { 260.0, LookOpaque, { 0.95, 0.90, 0.80 } },
  { 500.0, LookOpaque, { 0.98, 0.95, 0.88 } },
  { 3000.0, LookOpaque, { 1.00, 1.00, 0.98 } },
};

} // namespace VolumeHaptics

#endif
