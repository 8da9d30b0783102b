// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the hash of an array in the background.
 */
#ifndef ArrayHash_h
#define ArrayHash_h

#include "VTK/Base/BackgroundWork.h"
#include "VTK/Base/TouchedArray.h"

#include <functional>
#include <string>

namespace VolumeHaptics
{

/** Remembers the hash of one array until the array is modified. */
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
