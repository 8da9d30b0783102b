// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What libFuzzer calls for the Falcon's codec.
#include "TouchFalcon.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  TouchFalcon(bytes, size);
  return 0;
}
