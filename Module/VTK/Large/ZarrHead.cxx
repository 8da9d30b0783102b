// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Large/ZarrHead.h"

#include "VTK/Files/HapticFiles.h"
#include "VTK/Files/PlainNumbers.h"

#include "vtk_jsoncpp.h"

#include <cstddef>
#include <exception>
#include <memory>

namespace VolumeHaptics
{

bool ReadZarrHead(const std::string& file, Json::Value& head)
{
  constexpr std::size_t most = std::size_t{ 1 } << 24;
  std::string text;
  std::string error;
  if (!ReadSmallFile(file, most, text, error))
  {
    return false;
  }
  Json::CharReaderBuilder builder;
  builder["allowSpecialFloats"] = true; // Python writes NaN
  const PlainNumbers plain;
  const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
  try
  {
    return reader->parse(text.data(), text.data() + text.size(), &head, &error) && head.isObject();
  }
  catch (const std::exception&) // brackets nested too deeply
  {
    return false;
  }
}

} // namespace VolumeHaptics
