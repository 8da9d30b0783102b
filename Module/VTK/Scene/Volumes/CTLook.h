// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How a CT volume is shown, by the explorer and by ParaView's plugin: the surface that a hand meets
 * first is what is seen, in the colours of skin and bone.
 */
#ifndef CTLook_h
#define CTLook_h

#include <array>

namespace VolumeHaptics
{

/** Between two stops, opacity and colour change linearly. */
struct LookStop
{
  double Value;
  double Opacity; ///< of a layer of LookLayer
  std::array<double, 3> Color;
};

/**
 * The thickness (voxels) of the layer whose opacities these are. Half of the picture is the first
 * half voxel of it, and rays in steps of a voxel do not show the steps.
 */
constexpr double LookLayer = 4.0;
/** The opacity of what is felt. */
constexpr double LookOpaque = 0.998;

/**
 * From nothing to all of the opacity, on the edge from air to fat and skin, where a hand meets it.
 * What the opacity hides is not felt, so that nothing is felt that is hardly seen, such as the foam
 * and the blankets around a body.
 */
constexpr double CTLookClear = -350.0;
constexpr double CTLookSkin = -300.0;

/** By Hounsfield units. */
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
