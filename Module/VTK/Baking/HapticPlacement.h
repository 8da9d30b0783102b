// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the map from a device's space to the world.
 */
#ifndef HapticPlacement_h
#define HapticPlacement_h

#include "Core/Math/Vector3.h"

#include <string>

class vtkMatrix4x4;

namespace VolumeHaptics
{

/**
 * Reads the map from the device (m) to the world. Returns false and reports an error unless the
 * matrix is a rotation, a translation and one uniform, positive scale.
 */
bool ReadSimilarity(vtkMatrix4x4* matrix, Affine3& map, std::string& error);

/**
 * Returns the default map from the device to the world, used if no matrix is set: a uniform scale.
 */
inline Affine3 ScaledPlacement(double metersPerWorldUnit)
{
  Affine3 map;
  map.Linear = (1.0 / metersPerWorldUnit) * Matrix3{};
  return map;
}

} // namespace VolumeHaptics

#endif
