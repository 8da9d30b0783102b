// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How soon devices that would hurt a hand are found, and how often honest ones are taken for them.
 */
#ifndef Evaluation_PortSafety_h
#define Evaluation_PortSafety_h

#include "Table.h"

#include <vector>

namespace evaluation
{

/** `alarms` counts the honest devices whose force was cut off. */
struct PortSafety
{
  int Alarms = 0;
  std::vector<Table> Tables;
};

/**
 * False alarms of so many random sessions of honest devices (ArmSessions.h, PortSessions.h, each);
 * and from `trials` sessions a row, loops that swing by themselves, wrong signs with the check at
 * the first arming, and wrong signs with the observer of the port alone.
 */
PortSafety MeasurePortSafety(int sessions, int trials);

} // namespace evaluation

#endif
