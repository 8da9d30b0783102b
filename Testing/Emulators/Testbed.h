// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The kernel that umockdev plays: one for a whole program.
 */
#ifndef Testbed_h
#define Testbed_h

#include <umockdev.h>

#include <string>

namespace emulated
{
UMockdevTestbed* Testbed();
/**
 * From now on the signs of a device with this identity count as confirmed, as in the user's file of
 * devices: tests that are about something else begin with devices that were armed before.
 */
void RememberConfirmed(const std::string& identity);
} // namespace emulated

#endif
