// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * volumehaptics-device: lists and tests devices, and lets the user feel a wall with them. See
 * ToolOptions.h for its usage.
 */
#ifndef DeviceTool_h
#define DeviceTool_h

#include <iosfwd>
#include <string>
#include <vector>

/// Runs the whole program. Returns 0, 1 if the device failed, or 2 for wrong usage.
int RunDeviceTool(const std::vector<std::string>& arguments, std::istream& in, std::ostream& out,
  std::ostream& errors);

#endif
