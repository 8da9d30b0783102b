// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Announces long work to a device for the duration of a C++ scope, because the device may have to
 * turn its force off meanwhile.
 */
#ifndef HapticLongWork_h
#define HapticLongWork_h

#include "vtkHapticDevice.h"
#include "vtkSmartPointer.h"

namespace VolumeHaptics
{

/** Calls vtkHapticDevice::BeginLongWork in its constructor and EndLongWork in its destructor. */
class LongWork
{
public:
  LongWork(vtkHapticDevice* device, const char* what, double expectedSeconds)
    : Device(device)
  {
    device->BeginLongWork(what, expectedSeconds);
  }
  ~LongWork() { this->Device->EndLongWork(); }
  LongWork(const LongWork&) = delete;
  LongWork& operator=(const LongWork&) = delete;

private:
  const vtkSmartPointer<vtkHapticDevice> Device;
};

} // namespace VolumeHaptics

#endif
