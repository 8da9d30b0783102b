// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Measures how soon dangerous devices are detected, and how often honest devices raise a
 * false alarm.
 */
#ifndef Evaluation_PortSafety_h
#define Evaluation_PortSafety_h

#include "Table.h"

#include <vector>

namespace evaluation
{

/** `Alarms` counts the honest devices whose force was cut off. */
struct PortSafety
{
  int Alarms = 0;
  std::vector<Table> Tables;
};

/**
 * Measures false alarms in random sessions of honest devices (`sessions` each of ArmSessions.h and
 * PortSessions.h). With `trials` sessions per row, measures loops that become unstable, and wrong
 * signs of the force with the check at the first arming, and with the observer of the port alone.
 */
PortSafety MeasurePortSafety(int sessions, int trials);

} // namespace evaluation

#endif
