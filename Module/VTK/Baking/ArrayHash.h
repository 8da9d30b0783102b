// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The hash of an array, made in the background.
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
  /** The hash of an array, empty without one; made here and now if it is not known. */
  std::string Get(const TouchedArray& array);
  /**
   * The same, made in the background. Calls `goesOn` with the share that is done some times
   * a second until it is known; if that returns false, it ends the work and returns an empty text.
   */
  std::string Await(const TouchedArray& array, const std::function<bool(double)>& goesOn);

private:
  KeyedWork<TouchedArray::Key, std::string> Work;
};

} // namespace VolumeHaptics

#endif
