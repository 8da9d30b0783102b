// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How a CT volume is shown: clear air, half-transparent skin, and bone.
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
  double Opacity; ///< of a layer of a given thickness
  std::array<double, 3> Color;
};

/** The thickness (mm) of the layer whose opacities CTLook has. */
constexpr double CTLookThickness = 4.0;

/** By Hounsfield units. */
constexpr LookStop CTLook[] = {
  { -1024.0, 0.00, { 0.85, 0.60, 0.47 } },
  { -600.0, 0.00, { 0.85, 0.60, 0.47 } },
  { -400.0, 0.35, { 0.93, 0.69, 0.56 } },
  { -100.0, 0.35, { 0.93, 0.69, 0.56 } },
  { 0.0, 0.16, { 0.86, 0.52, 0.44 } },
  { 130.0, 0.14, { 0.90, 0.66, 0.56 } },
  { 260.0, 0.50, { 0.95, 0.90, 0.80 } },
  { 500.0, 0.98, { 0.98, 0.95, 0.88 } },
  { 3000.0, 1.00, { 1.00, 1.00, 0.98 } },
};

} // namespace VolumeHaptics

#endif
