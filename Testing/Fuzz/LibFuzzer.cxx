// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Defines the function that libFuzzer calls. It calls the target that fuzz.sh names.
#include <cstddef>
#include <cstdint>

void VOLUME_HAPTICS_FUZZ_TARGET(const std::uint8_t* bytes, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  VOLUME_HAPTICS_FUZZ_TARGET(bytes, size);
  return 0;
}
