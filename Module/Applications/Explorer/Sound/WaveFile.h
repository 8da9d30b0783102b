// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_WaveFile_h
#define Explore_WaveFile_h

#include <string>
#include <vector>

namespace Explore
{
/// Writes samples from -1 to 1 as 16-bit PCM, mono. Throws InputError on failure.
///
/// The format follows "Multimedia Programming Interface and Data Specifications 1.0" (IBM and
/// Microsoft, 1991): a header of 44 bytes, followed by the samples. A library would be one more
/// dependency of the build.
void WriteWave(const std::vector<float>& samples, int samplesPerSecond, const std::string& file);
} // namespace Explore

#endif
