// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The kernel that umockdev plays: one for a whole program.
 */
#ifndef Testbed_h
#define Testbed_h

#include <umockdev.h>

namespace emulated
{
UMockdevTestbed* Testbed();
} // namespace emulated

#endif
