// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects events in a table of states, in their order.
 */
#ifndef HapticStateWatch_h
#define HapticStateWatch_h

#include <vector>

class vtkTable;

namespace VolumeHaptics
{

/** Stores the last state between tables. */
class HapticStateWatch
{
public:
  /** The events (vtkInteractorStyleHaptic::HapticEvents) of the table's rows, oldest first. */
  std::vector<unsigned long> Watch(vtkTable* states);
  void Reset() { *this = HapticStateWatch(); }

private:
  bool IsTouching = false;
  bool IsArmed = false;
  bool HasFault = false;
};

} // namespace VolumeHaptics

#endif
