// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/SetupFile.h"

#include <cctype>

namespace VolumeHaptics
{
namespace
{

std::string StartSentence(std::string text)
{
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

} // namespace

//------------------------------------------------------------------------------
Json::Value NewSetupFile(const SetupFileKind& kind)
{
  Json::Value root(Json::objectValue);
  root["Format"] = kind.Format;
  root["Version"] = kind.Version;
  return root;
}

//------------------------------------------------------------------------------
bool ParseSetupFile(
  const std::string& text, const SetupFileKind& kind, Json::Value& root, std::string& error)
{
  if (!ParseJson(text, root, error))
  {
    error += std::string(" Correct it there, or ") + kind.Again + ".";
    return false;
  }
  if (!root.isObject() || !root["Format"].isString() || root["Format"].asString() != kind.Format)
  {
    error = std::string("it is not a ") + kind.Noun + ", which has \"Format\": \"" + kind.Format +
      "\". Choose a file " + kind.Cure + ".";
    return false;
  }
  if (!root["Version"].isInt() || root["Version"].asInt() < 1)
  {
    error = "its Version is not a whole number of 1 or more. " + StartSentence(kind.Again);
    return false;
  }
  if (root["Version"].asInt() > kind.Version)
  {
    error = "its Version is " + std::to_string(root["Version"].asInt()) +
      ", which is newer than this software's " + std::to_string(kind.Version) +
      ". Update VTK Volume Haptics.";
    return false;
  }
  return true;
}

} // namespace VolumeHaptics
