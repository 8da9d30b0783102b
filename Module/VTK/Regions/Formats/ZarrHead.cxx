// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/ZarrHead.h"

#include "VTK/Base/HapticFiles.h"
#include "VTK/Base/JsonText.h"

#include "vtksys/SystemTools.hxx"

#include <cstddef>
#include <stdexcept>

namespace VolumeHaptics
{

bool ReadZarrHead(const std::string& file, Json::Value& head)
{
  constexpr std::size_t most = std::size_t{ 1 } << 24;
  std::string text;
  std::string error;
  if (!vtksys::SystemTools::FileExists(file))
  {
    return false;
  }
  if (!ReadSmallFile(file, most, text, error))
  {
    throw std::runtime_error("its head " + Printable(file) + " " + error + ". Write it again.");
  }
  if (!ParseJson(text, head, error) || !head.isObject())
  {
    throw std::runtime_error("its head " + Printable(file) + " can't be read: " +
      (error.empty() ? "it is no object of JSON." : Printable(error)) + " Write it again.");
  }
  return true;
}

} // namespace VolumeHaptics
