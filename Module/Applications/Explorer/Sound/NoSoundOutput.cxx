// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Replaces PulseOutput.cxx in builds without PulseAudio's library.
#include "Applications/Explorer/Sound/SoundOutput.h"

namespace Explore
{
bool SoundOutput::IsAvailable()
{
  return false;
}

std::unique_ptr<SoundOutput> SoundOutput::Open(SoundStream&)
{
  return nullptr;
}
} // namespace Explore
