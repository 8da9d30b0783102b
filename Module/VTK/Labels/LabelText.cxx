// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Labels/LabelText.h"

#include "VTK/Files/HapticFiles.h"

namespace VolumeHaptics
{

std::string MakeLabelName(const std::string& text)
{
  // Printable changes a text if and only if it is not UTF-8.
  const bool isLatin = Printable(text) != text;
  std::string name;
  for (const char character : text)
  {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 0x20 || byte == 0x7F)
    {
      name += ' ';
    }
    else if (isLatin && byte >= 0x80)
    {
      name += static_cast<char>(0xC0 | (byte >> 6));
      name += static_cast<char>(0x80 | (byte & 0x3F));
    }
    else
    {
      name += character;
    }
  }
  return name;
}

} // namespace VolumeHaptics
