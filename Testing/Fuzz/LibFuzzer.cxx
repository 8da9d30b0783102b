// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Defines libFuzzer's entry point, which calls the target that fuzz.sh selects.
#include <cstddef>
#include <cstdint>

void VOLUME_HAPTICS_FUZZ_TARGET(const std::uint8_t* bytes, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  VOLUME_HAPTICS_FUZZ_TARGET(bytes, size);
  return 0;
}
