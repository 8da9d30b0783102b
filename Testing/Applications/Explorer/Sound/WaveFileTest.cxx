// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Checks the bytes of a sound file against "Multimedia Programming Interface and Data
/// Specifications 1.0" (IBM and Microsoft, 1991), pages 56 to 60.

#include "Applications/Explorer/Sound/WaveFile.h"
#include "Rigs/TemporaryFolder.h"
#include "VTK/Reading/InputError.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

TEST(WaveFile, HasTheBytesOfTheSpecification)
{
  const std::string file = TemporaryPath("sound.wav");
  Explore::WriteWave({ 0.0f, 1.0f, -1.0f, 0.5f, 2.0f }, 48000, file);
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  const unsigned char expected[] = { 'R', 'I', 'F', 'F', 46, 0, 0, 0, 'W', 'A', 'V', 'E', 'f', 'm',
    't', ' ', 16, 0, 0, 0, 1, 0, 1, 0, 0x80, 0xbb, 0, 0, 0x00, 0x77, 0x01, 0, 2, 0, 16, 0, 'd', 'a',
    't', 'a', 10, 0, 0, 0, 0, 0, 0xff, 0x7f, 0x01, 0x80, 0x00, 0x40, 0xff, 0x7f };
  EXPECT_EQ(bytes, std::string(std::begin(expected), std::end(expected)));
}

TEST(WaveFile, TellsIfItCanNotBeWritten)
{
  try
  {
    Explore::WriteWave({ 0.0f }, 48000, TemporaryPath("nowhere/sound.wav"));
    FAIL() << "no error";
  }
  catch (const Explore::InputError& error)
  {
    EXPECT_NE(
      std::string(error.what()).find("nowhere/sound.wav: cannot be written"), std::string::npos);
  }
}
