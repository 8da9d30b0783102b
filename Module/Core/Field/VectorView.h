// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A typed view of an array of vectors or tensors: no copy, no ownership.
 */
#ifndef VectorView_h
#define VectorView_h

#include "Core/Field/VolumeView.h"

namespace VolumeHaptics
{

/** The components of a structured point array. */
struct VectorView
{
  static constexpr int MostComponents = 9;

  VolumeView Volume;       ///< view of the first component; its BorderValue is not used
  int Components = 3;      ///< 3: a vector; 6: a symmetric tensor; 9: a tensor
  std::int64_t Stride = 1; ///< elements from one component of a sample to the next
};

} // namespace VolumeHaptics

#endif
