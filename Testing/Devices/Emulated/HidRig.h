// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A bench for emulated devices of hidapi.
 */
#ifndef HidRig_h
#define HidRig_h

#include "DeviceBench.h"
#include "Emulators/EmulatedHid.h"

namespace emulated
{
using HidBench = DeviceBench;
} // namespace emulated

#endif
