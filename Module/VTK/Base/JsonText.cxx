// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/JsonText.h"

#include <exception>
#include <locale>
#include <memory>

namespace VolumeHaptics
{
namespace
{

/**
 * Sets a C++ locale with a decimal point for its lifetime: jsoncpp reads numbers in the
 * application's locale, where 0.5 may be written 0,5. Changes nothing if the locale already has the
 * decimal point.
 */
class PlainNumbers
{
public:
  PlainNumbers()
  {
    const auto& numbers = std::use_facet<std::numpunct<char>>(this->Before);
    this->Changed = numbers.decimal_point() != '.' || !numbers.grouping().empty();
    if (this->Changed)
    {
      // A C++ locale without a name leaves the C locale unchanged.
      std::locale::global(std::locale(this->Before, new std::numpunct<char>));
    }
  }
  ~PlainNumbers()
  {
    if (this->Changed)
    {
      std::locale::global(this->Before);
    }
  }

private:
  std::locale Before;
  bool Changed = false;
};

constexpr int DeepestBrackets = 64; // much more than the eight levels in this library's own files

} // namespace

bool ParseJson(const std::string& text, Json::Value& root, std::string& error)
{
  Json::CharReaderBuilder builder;
  builder["collectComments"] = false;
  builder["failIfExtra"] = true;
  builder["rejectDupKeys"] = true;
  builder["allowSpecialFloats"] = true;
  builder["stackLimit"] = DeepestBrackets;
  const PlainNumbers plain;
  const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
  try
  {
    if (!reader->parse(text.data(), text.data() + text.size(), &root, &error))
    {
      error = "it is not JSON: " + error;
      return false;
    }
  }
  catch (const Json::Exception&)
  {
    error = "it is not JSON that can be read: its brackets are nested more than " +
      std::to_string(DeepestBrackets) + " deep.";
    return false;
  }
  catch (const std::exception& e) // the only exception here: jsoncpp ran out of memory
  {
    error = std::string("it is not JSON: ") + e.what();
    return false;
  }
  return true;
}

std::string WriteJson(const Json::Value& root)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = " ";
  builder["commentStyle"] = "None"; // writes short lists on one line
  builder["precision"] = 17;        // enough digits to restore every double exactly
  return Json::writeString(builder, root) + "\n";
}

} // namespace VolumeHaptics
