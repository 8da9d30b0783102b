// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Hashes a volume, so that a recording can identify the volume that it was made with.
 */
#ifndef HapticHash_h
#define HapticHash_h

#include "Core/Realtime/BackgroundWork.h"
#include "VTK/Base/TouchedArray.h"

#include <functional>
#include <string>

class vtkDataArray;

namespace VolumeHaptics
{

/**
 * Callback with the fraction of the work that is done, every few milliseconds. It returns false to
 * stop the work.
 */
using HashProgress = std::function<bool(double)>;

/**
 * Computes the MD5 of an array's shape and its values, tuple by tuple in any memory layout. Returns
 * an empty text if `progress` stopped the work. Any thread may call it.
 */
std::string HashArray(
  vtkDataArray* array, const int dimensions[3], const HashProgress& progress = nullptr);

/** Estimates the time (s) of HashArray(). */
double EstimateHashTime(vtkDataArray* array);

/** Computes the hash of an array in the background, and caches it until the array is modified. */
class ArrayHash
{
public:
  /**
   * Returns the hash of an array; empty without an array. Computes it in this call if it is not
   * cached.
   */
  std::string Get(const TouchedArray& array);
  /**
   * Waits for the hash of an array, which is computed in the background. Meanwhile calls `goesOn`
   * several times a second with the fraction that is done. If `goesOn` returns false, stops the
   * work and returns an empty text.
   */
  std::string Await(const TouchedArray& array, const std::function<bool(double)>& goesOn);

private:
  KeyedWork<TouchedArray::Key, std::string> Work;
};

} // namespace VolumeHaptics

#endif
