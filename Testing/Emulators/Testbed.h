// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** The kernel that umockdev plays, one for each program. */
#ifndef Testbed_h
#define Testbed_h

#include <umockdev.h>

#include <string>

namespace emulated
{
UMockdevTestbed* Testbed();
/**
 * Enters a device as confirmed into the user's file of devices, for tests of other subjects.
 */
void RememberConfirmed(const std::string& identity);
} // namespace emulated

#endif
