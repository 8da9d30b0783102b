// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A view of an array of vectors or tensors of any scalar type. It copies and owns nothing.
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

  VolumeView Volume;       ///< the first component; its BorderValue is not used
  int Components = 3;      ///< 3 for vectors, 6 for symmetric tensors, 9 for tensors
  std::int64_t Stride = 1; ///< number of elements from one component of a sample to the next
};

} // namespace VolumeHaptics

#endif
