// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** A sample of a handle that a spring holds, the input of the measurements. */
#ifndef HeldSample_h
#define HeldSample_h

#include <array>

struct HeldSample
{
  std::array<double, 3> Tip{};   ///< m, along the device's axes
  std::array<double, 3> Force{}; ///< force (N) requested from the device
  double Elapsed = 0.0;          ///< s since the last sample
};

#endif
