// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TraceSound_h
#define Explore_TraceSound_h

#include "Applications/Explorer/Exploration/Exploration.h"

#include <string>
#include <vector>

namespace Explore
{
/// Makes the sound along an exploration's trace, including its decay after the end: see
/// ContactSound.
std::vector<float> MakeSound(const Exploration& exploration);

/// Writes the sound of MakeSound() as a WAV file. Throws InputError if it can't be written.
void WriteSound(const Exploration& exploration, const std::string& file);
} // namespace Explore

#endif
