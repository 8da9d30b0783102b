// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Hashes a volume, so that a recording can recognise its volume.
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
 * Called every few milliseconds with the fraction that is done. Returns false to end the work.
 */
using HashProgress = std::function<bool(double)>;

/**
 * Computes the MD5 of an array's shape and of its values, tuple by tuple in any memory layout.
 * Returns an empty text if `progress` ended the work. Any thread may call it, not only the thread
 * of the array's owner.
 */
std::string HashArray(
  vtkDataArray* array, const int dimensions[3], const HashProgress& progress = nullptr);

/** Estimates how long HashArray() takes (s). */
double EstimateHashTime(vtkDataArray* array);

/**
 * Computes the hash of an array in the background, and remembers it until the array is modified.
 */
class ArrayHash
{
public:
  /**
   * Returns the hash of an array; empty if there is no array. Computes it in this call if it is not
   * known.
   */
  std::string Get(const TouchedArray& array);
  /**
   * Returns the hash of an array, computed in the background. Until it is known, calls `goesOn`
   * several times a second with the fraction that is done. If `goesOn` returns false, ends the work
   * and returns an empty text.
   */
  std::string Await(const TouchedArray& array, const std::function<bool(double)>& goesOn);

private:
  KeyedWork<TouchedArray::Key, std::string> Work;
};

} // namespace VolumeHaptics

#endif
