// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes every tick as text while a region of a volume is touched, because vtkHapticDevice can't
 * record a region.
 */
#ifndef HapticStateLog_h
#define HapticStateLog_h

#include <fstream>
#include <string>

class vtkHapticDevice;

namespace VolumeHapticsLive
{

/**
 * A .csv file with the columns of vtkHapticState::Drain, in the format of all traces
 * (TraceWriter.h). The log is not sufficient for a bit-exact replay, but its tips can be used as a
 * path for Volume Haptics.
 */
class HapticStateLog
{
public:
  /** Starts the file. Returns false, with the reason in `error`, if the file can't be written. */
  bool Start(const std::string& file, vtkHapticDevice* device, std::string& error);
  /** Write the ticks since the last call to the file. */
  void Continue(vtkHapticDevice* device);
  /**
   * Completes the file, if one is open. Returns false, with the reason in `error`, if the file is
   * incomplete.
   */
  bool Stop(vtkHapticDevice* device, std::string& error);
  bool IsOpen() const { return this->File.is_open(); }

private:
  std::ofstream File;
  std::string Name;
  bool HasTitles = false;
};

} // namespace VolumeHapticsLive

#endif
