// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TraceArrayChoice.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Tools/ToolArrays.h"
#include "VTK/Trace/HapticTraceColumns.h"

#include <cctype>
#include <iterator>

namespace VolumeHaptics
{

std::size_t GetModeForceArray(std::size_t mode)
{
  return GetTraceColumns().size() + 2 + mode;
}

std::size_t GetToolArray(std::size_t column)
{
  return GetModeForceArray(MostModeForces) + column;
}

std::size_t GetNumberOfTraceArrays()
{
  return GetToolArray(std::size(CommonToolArrays) + GetToolArrays().size());
}

const char* GetTraceArrayName(std::size_t array)
{
  // Never destroyed, for the same reason as the list of columns.
  static const auto* const names = []
  {
    auto* const all = new std::vector<std::string>;
    for (const TraceColumn& column : GetTraceColumns())
    {
      all->push_back(column.Name);
    }
    all->insert(all->end(), { LabelColumn, DataTimeColumn });
    for (std::size_t mode = 0; mode < MostModeForces; ++mode)
    {
      all->push_back(ModeForceColumn + std::to_string(mode));
    }
    all->insert(all->end(), std::begin(CommonToolArrays), std::end(CommonToolArrays));
    for (const ToolColumn* const array : GetToolArrays())
    {
      all->push_back(array->Name);
    }
    return all;
  }();
  return (*names)[array].c_str();
}

std::size_t FindTraceArray(const std::string& name)
{
  std::size_t array = 0;
  while (array < GetNumberOfTraceArrays() && name != GetTraceArrayName(array))
  {
    ++array;
  }
  return array;
}

std::vector<std::string> SplitTraceArrays(const std::string& text)
{
  std::vector<std::string> words;
  bool isInWord = false;
  for (const char c : text)
  {
    const bool isOfWord = c != ',' && !std::isspace(static_cast<unsigned char>(c));
    if (isOfWord && !isInWord)
    {
      words.emplace_back();
    }
    if (isOfWord)
    {
      words.back() += c;
    }
    isInWord = isOfWord;
  }
  return words;
}

std::string ReadTraceArrays(const std::vector<std::string>& names, TraceArrayChoice& choice)
{
  const std::size_t count = GetNumberOfTraceArrays();
  const TraceArrayChoice every = (TraceArrayChoice(1) << count) - 1;
  TraceArrayChoice read = 0;
  for (const std::string& name : names)
  {
    const std::size_t array = FindTraceArray(name);
    if (array < count)
    {
      read |= TraceArrayChoice(1) << array;
    }
    else if (names.size() == 1 && name == "all")
    {
      read = every;
    }
    else if (names.size() > 1 || name != "none")
    {
      std::string error =
        "There is no trace array \"" + Printable(name) + "\". Take \"all\", \"none\", or some of ";
      for (std::size_t i = 0; i < count; ++i)
      {
        error += (i > 0 ? ", \"" : "\"") + std::string(GetTraceArrayName(i)) + "\"";
      }
      return error + ".";
    }
  }
  choice = read == every ? AllTraceArrays : read;
  return {};
}

std::vector<std::string> ListTraceArrays(
  TraceArrayChoice choice, const std::string& other, bool isWanted)
{
  const std::size_t count = GetNumberOfTraceArrays();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (other != GetTraceArrayName(i) && IsChosen(choice, i))
    {
      names.emplace_back(GetTraceArrayName(i));
    }
  }
  if (isWanted || FindTraceArray(other) >= count)
  {
    names.push_back(other);
  }
  return names;
}

std::string DescribeTraceArrays(TraceArrayChoice choice)
{
  if (choice == AllTraceArrays)
  {
    return "all";
  }
  std::string names;
  for (std::size_t i = 0; i < GetNumberOfTraceArrays(); ++i)
  {
    if (IsChosen(choice, i))
    {
      names += (names.empty() ? "" : ", ") + std::string(GetTraceArrayName(i));
    }
  }
  return names.empty() ? "none" : names;
}

} // namespace VolumeHaptics
