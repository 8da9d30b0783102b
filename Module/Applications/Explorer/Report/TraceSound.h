// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TraceSound_h
#define Explore_TraceSound_h

#include "Applications/Explorer/Exploration/Exploration.h"

#include <string>
#include <vector>

namespace Explore
{
/// What would be heard along the trace of an exploration, and what fades after it: see
/// ContactSound.
std::vector<float> MakeSound(const Exploration& exploration);

/// Writes that as a WAV file. Throws InputError if it can't be written.
void WriteSound(const Exploration& exploration, const std::string& file);
} // namespace Explore

#endif
