// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Collects errors of VTK objects as text, so that an error that a timer repeats sixty times a
 * second is reported once.
 */
#ifndef HapticErrorCatcher_h
#define HapticErrorCatcher_h

#include "vtkObject.h"
#include "vtkWeakPointer.h"

#include <string>
#include <utility>
#include <vector>

namespace VolumeHapticsLive
{

class HapticErrorCatcher
{
public:
  HapticErrorCatcher() = default;
  ~HapticErrorCatcher();
  HapticErrorCatcher(const HapticErrorCatcher&) = delete;
  void operator=(const HapticErrorCatcher&) = delete;

  /**
   * Collects the errors of this object from now on instead of showing them. Call it once for each
   * object.
   */
  void Catch(vtkObject* object);
  /**
   * Returns the errors since the last call, without file names and addresses; empty if there are
   * none.
   */
  std::string Drain();

private:
  void Record(vtkObject* object, unsigned long event, void* data);

  std::vector<std::pair<vtkWeakPointer<vtkObject>, unsigned long>> Objects;
  std::string Text;
};

} // namespace VolumeHapticsLive

#endif
