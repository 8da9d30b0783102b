// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TraceSummary_h
#define Explore_TraceSummary_h

#include "Applications/Explorer/Exploration/Exploration.h"

#include <string>

namespace Explore
{
/// Returns a readable summary of the volume, the settings, contacts, forces, and the speed of the
/// computation.
std::string Summarise(const Exploration& exploration);
} // namespace Explore

#endif
