// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TraceSummary_h
#define Explore_TraceSummary_h

#include "Applications/Explorer/Exploration/Exploration.h"

#include <string>

namespace Explore
{
/// A page for a person: the volume, the settings, what was touched and how hard, how fast it went.
std::string Summarise(const Exploration& exploration);
} // namespace Explore

#endif
