// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Provides the kernel that umockdev simulates: one for each program. */
#ifndef Testbed_h
#define Testbed_h

#include <umockdev.h>

#include <string>

namespace emulated
{
UMockdevTestbed* Testbed();
/**
 * Writes a device as confirmed into the user's file of devices, for tests of other things.
 */
void RememberConfirmed(const std::string& identity);
} // namespace emulated

#endif
