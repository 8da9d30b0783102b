// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_HelpText_h
#define Explore_HelpText_h

#include <string>

namespace Explore
{
/// Returns the text of --help: the usage and all options.
std::string HelpText();
} // namespace Explore

#endif
