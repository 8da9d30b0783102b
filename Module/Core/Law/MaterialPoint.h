// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 */
#ifndef MaterialPoint_h
#define MaterialPoint_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

/** The material at a point of the volume, for the law of MaterialLaw.h. */
struct MaterialPoint
{
  Vector3 Normal;                 ///< unit vector into the structure
  double GradientMagnitude = 0.0; ///< scalar units per world unit
  double SurfaceValue = 0.0;      ///< V(x_s)
  double MediumValue = 0.0;       ///< V(x_v): value where the medium's material is read
  double Stiffness = 0.0;         ///< k, N/m
  double Friction = 0.0;          ///< mu
  double Viscosity = 0.0;         ///< R, N
  double SurfaceStrength = 0.0;   ///< T_N W_d, N
};

} // namespace VolumeHaptics

#endif
