// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs the fuzzer's target for firmware and the file of devices on random bytes, and on a valid
 * file of devices with some bytes changed.
 */

#include "TouchUserFile.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace
{
void Touch(const std::string& bytes)
{
  TouchUserFile(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}
} // namespace

TEST(Fuzz, RandomUserFilesAreTouched)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::string bytes(random() % 1500, '\0');
    for (char& byte : bytes)
    {
      // Half of the files consist of characters that occur in a file of devices.
      byte = static_cast<char>(
        seed % 2 == 0 ? random() : "falcon confirmed=scale20-\n\r\0.%"[random() % 32]);
    }
    Touch(bytes);
  }
  for (const std::size_t size : { 0, 1023, 1024, 131072, 131073 })
  {
    Touch(std::string(size, 'x'));
  }
}

TEST(Fuzz, SpoiltUserFilesAreTouched)
{
  const std::string good = "# mine\nfalcon confirmed=2026-11-22 scale=0.83 calibrated=2026-11-22\n"
                           "wooden:1234:0006:A%20%231%25%20B confirmed=2026-11-01\n";
  for (unsigned seed = 0; seed < 500; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::string file = good.substr(seed % 2 == 0 ? 0 : 7);
    for (unsigned changes = random() % 6; changes > 0; --changes)
    {
      file[random() % file.size()] =
        static_cast<char>(random() % 3 == 0 ? random() : "0= \n\r-.19e"[random() % 10]);
    }
    file.resize(random() % 4 == 0 ? random() % file.size() : file.size());
    Touch(file);
  }
}
