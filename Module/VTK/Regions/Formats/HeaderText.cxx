// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/HeaderText.h"

#include "Core/Math/NumberText.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/LengthUnit.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

/** Largest number of lines that are searched for fields, because samples may follow. */
constexpr int LongestHeader = 200; // lines
/**
 * Largest number of characters in a key or value for which MetaIO has memory (metaUtils.h,
 * metaObject.h).
 */
constexpr std::size_t LongestText = 254;

std::string TrimBlanks(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r");
  const std::size_t end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

/** Returns whether a key has no character that MetaIO would skip or treat as the key's end. */
bool IsPlainKey(const std::string& key)
{
  return std::all_of(
    key.begin(), key.end(), [](char c) { return c >= ' ' && c <= '~' && c != ':'; });
}

} // namespace

HeaderText::HeaderText(const std::string& path)
{
  std::ifstream file = OpenStream(path);
  std::string line;
  std::size_t size = 0;
  for (int count = 0; count < LongestHeader && std::getline(file, line); ++count)
  {
    size += line.size() + 1;
    const std::size_t middle = line.find('=');
    const std::string key = TrimBlanks(line.substr(0, middle));
    if (key.empty())
    {
      break;
    }
    const std::string value =
      middle == std::string::npos ? std::string() : TrimBlanks(line.substr(middle + 1));
    const bool isNew = middle != std::string::npos && this->Fields.emplace(key, value).second;
    this->HasPlainLines = this->HasPlainLines && isNew && key.size() <= LongestText &&
      value.size() <= LongestText && IsPlainKey(key);
    if (key == "ElementDataFile")
    {
      this->Size = size;
      break;
    }
  }
}

std::string HeaderText::Value(const std::vector<std::string>& keys) const
{
  for (const std::string& key : keys)
  {
    const auto field = this->Fields.find(key);
    if (field != this->Fields.end())
    {
      return field->second;
    }
  }
  return {};
}

bool HeaderText::IsTrue(const std::vector<std::string>& keys, bool otherwise) const
{
  const std::string value = this->Value(keys);
  return value.empty() ? otherwise : std::string("Tt1").find(value[0]) != std::string::npos;
}

double HeaderText::GetMetaUnit() const
{
  const double unit = MillimetresPerUnit(this->Value({ "DistanceUnits" }));
  return unit > 0.0 ? unit : 1.0;
}

std::vector<std::string> HeaderText::DescribeMeta() const
{
  std::vector<std::string> notes;
  if (this->GetMetaUnit() != 1.0)
  {
    notes.push_back("lengths turned from the unit " + Printable(this->Value({ "DistanceUnits" })) +
      " into millimetres");
  }
  if (this->Numbers({ "ElementSpacing", "ElementSize" }).empty())
  {
    notes.emplace_back("the header gives no ElementSpacing: voxels of 1 mm are assumed");
  }
  const std::vector<double> slope = this->Numbers({ "ElementToIntensityFunctionSlope" });
  const std::vector<double> offset = this->Numbers({ "ElementToIntensityFunctionOffset" });
  if ((!slope.empty() && slope.front() != 1.0) || (!offset.empty() && offset.front() != 0.0))
  {
    notes.emplace_back(
      "the header's scale of values (ElementToIntensityFunction) is not used, as in "
      "ITK: the stored values are felt");
  }
  return notes;
}

std::vector<double> HeaderText::Numbers(const std::vector<std::string>& keys) const
{
  std::vector<double> numbers;
  std::istringstream words(this->Value(keys));
  std::string word;
  while (words >> word)
  {
    if (const std::optional<double> number = ParseNumber(word))
    {
      numbers.push_back(*number);
    }
  }
  return numbers;
}

} // namespace VolumeHaptics
