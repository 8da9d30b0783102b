// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Provides umockdev's simulated kernel: one per program. */
#ifndef Testbed_h
#define Testbed_h

#include <umockdev.h>

#include <string>

namespace emulated
{
UMockdevTestbed* Testbed();
/** Writes a device as confirmed to the user's device file, for tests of other subjects. */
void RememberConfirmed(const std::string& identity);
} // namespace emulated

#endif
