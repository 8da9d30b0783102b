// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Hashes a volume, so that a recording can recognise its volume.
 */
#ifndef HapticHash_h
#define HapticHash_h

#include "VTK/Base/BackgroundWork.h"
#include "VTK/Base/TouchedArray.h"

#include <functional>
#include <string>

class vtkDataArray;

namespace VolumeHaptics
{

/**
 * Called between pieces of some milliseconds with the fraction that is done; false ends the work.
 */
using HashProgress = std::function<bool(double)>;

/**
 * Computes the MD5 of an array's shape and of its values, tuple by tuple in any memory layout;
 * empty if the work was ended. Any thread may call it, not only that of the array's owner.
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
   * Returns the hash of an array, empty without one; computes it in this call if it is not known.
   */
  std::string Get(const TouchedArray& array);
  /**
   * Returns the hash of an array, computed in the background. Until it is known, calls `goesOn`
   * several times a second with the fraction that is done; if that returns false, ends the work and
   * returns an empty text.
   */
  std::string Await(const TouchedArray& array, const std::function<bool(double)>& goesOn);

private:
  KeyedWork<TouchedArray::Key, std::string> Work;
};

} // namespace VolumeHaptics

#endif
