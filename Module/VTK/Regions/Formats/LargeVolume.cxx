// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/LargeVolume.h"

#include <algorithm>
#include <exception>
#include <new>
#include <sstream>

#if defined(__GLIBCXX__)
#include <cxxabi.h>
#endif

namespace VolumeHaptics
{
namespace
{

/**
 * Calls the reader. Returns the reason for a failure; empty if there is none. The exception that
 * ends a thread is not caught by reference: it is not an object, so sanitizers would report an
 * error.
 */
#if defined(__GNUC__)
__attribute__((no_sanitize("null")))
#endif
std::string
CallReader(const LargeVolume& volume, const BoxExtent& box, void* samples)
{
  try
  {
    return volume.Read(box.data(), samples) ? std::string() : "it gives no samples.";
  }
  catch (const std::bad_alloc&)
  {
    return "there is not enough memory.";
  }
  catch (const std::exception& failure)
  {
    return failure.what();
  }
#if defined(__GLIBCXX__)
  catch (const abi::__forced_unwind&)
  {
    throw; // pthread_exit() ends the thread with this exception, which must not be swallowed
  }
#endif
  catch (...)
  {
    return "it throws an exception that is no std::exception.";
  }
}

} // namespace

double CountSamples(const BoxExtent& extent)
{
  double count = 1.0;
  for (int a = 0; a < 6; a += 2)
  {
    count *= static_cast<double>(extent[a + 1]) - extent[a] + 1.0;
  }
  return count;
}

BoxExtent ComputeMiddle(const BoxExtent& whole, int width)
{
  BoxExtent box;
  for (int a = 0; a < 6; a += 2)
  {
    const vtkTypeInt64 spare = vtkTypeInt64{ whole[a + 1] } - whole[a] + 1 - width;
    box[a] = whole[a] + static_cast<int>(std::max<vtkTypeInt64>(spare / 2, 0));
    box[a + 1] =
      static_cast<int>(std::min<vtkTypeInt64>(vtkTypeInt64{ box[a] } + width - 1, whole[a + 1]));
  }
  return box;
}

bool ReadSamples(const LargeVolume& volume, const BoxExtent& box, void* samples, std::string& error)
{
  const std::string why = CallReader(volume, box, samples);
  if (why.empty())
  {
    return true;
  }
  std::ostringstream message;
  message << "The samples (" << box[0] << " to " << box[1] << ", " << box[2] << " to " << box[3]
          << ", " << box[4] << " to " << box[5] << ") can't be read from " << volume.Name << ": "
          << why;
  error = message.str();
  return false;
}

} // namespace VolumeHaptics
