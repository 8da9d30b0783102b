// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Connects a Python function to vtkHapticRegionSource through ctypes.
 */
#include "vtkHapticRegionSource.h"

#include <memory>
#include <stdexcept>

namespace
{
/** Region reader of a Python program, called through ctypes. */
struct ForeignReader
{
  ForeignReader(vtkHapticRegionRead read, vtkHapticRegionRelease release, void* context)
    : Read(read)
    , Release(release)
    , Context(context)
  {
  }
  ~ForeignReader()
  {
    if (this->Release)
    {
      this->Release(this->Context);
    }
  }
  ForeignReader(const ForeignReader&) = delete;
  ForeignReader& operator=(const ForeignReader&) = delete;

  const vtkHapticRegionRead Read;
  const vtkHapticRegionRelease Release;
  void* const Context;
};
} // namespace

void vtkHapticRegionSourceSetReader(
  vtkObjectBase* source, vtkHapticRegionRead read, vtkHapticRegionRelease release, void* context)
{
  auto* const regions = vtkHapticRegionSource::SafeDownCast(source);
  if (!regions)
  {
    return;
  }
  if (!read)
  {
    regions->SetReader({});
    return;
  }
  const auto foreign = std::make_shared<ForeignReader>(read, release, context);
  regions->SetReader(
    [foreign](const int extent[6], void* samples)
    {
      char why[1024] = "";
      if (foreign->Read(foreign->Context, extent, samples, why, static_cast<int>(sizeof(why))) == 0)
      {
        throw std::runtime_error(why);
      }
      return true;
    },
    false);
}
