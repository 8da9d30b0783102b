// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Checks that public headers agree with the lists of settings. Needs VolumeHaptics_SOURCE_DIR. */
#ifndef SettingChecks_h
#define SettingChecks_h

#include "VTK/Base/HapticSetting.h"

#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace settingtest
{
using namespace VolumeHaptics;

inline const std::string Root = VolumeHaptics_SOURCE_DIR;

/// Returns the letters of a text in a common form, so that "Local surface", LOCAL_SURFACE and
/// LocalSurface are equal.
inline std::string Letters(const std::string& text)
{
  std::string letters;
  for (const char c : text)
  {
    if (!std::isspace(static_cast<unsigned char>(c)) && c != '_' && c != '-')
    {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters;
}

inline bool BeginsWith(const std::string& text, const std::string& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

/// Returns the path of a public header. Searches all folders of Module/VTK.
inline std::filesystem::path PublicHeader(const std::string& header)
{
  for (const std::filesystem::directory_entry& entry :
    std::filesystem::recursive_directory_iterator(Root + "/Module/VTK"))
  {
    if (entry.path().filename() == header + ".h")
    {
      return entry.path();
    }
  }
  return {};
}

/// Returns the comment before the setter of a setting.
inline std::string HeaderComment(const std::string& header, const std::string& name)
{
  std::ifstream file(PublicHeader(header));
  const std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  std::size_t setter = std::string::npos;
  for (const std::string& start : { "vtkSetMacro(" + name + ",", "vtkSetClampMacro(" + name + ",",
         "vtkSetVector3Macro(" + name + ",", "vtkSetVector6Macro(" + name + ",",
         "void Set" + name + "(", "bool Set" + name + "(" })
  {
    setter = std::min(setter, text.find(start));
  }
  const std::size_t end = setter == std::string::npos ? setter : text.rfind("*/", setter);
  const std::size_t start = end == std::string::npos ? end : text.rfind("/**", end);
  if (start == std::string::npos)
  {
    return {};
  }
  std::string comment = text.substr(start + 3, end - start - 3);
  std::replace(comment.begin(), comment.end(), '*', ' ');
  return comment;
}

template <typename Owner>
void ExpectHeaderBehaves(Owner* object, const HapticSetting<Owner>& setting)
{
  EXPECT_EQ(setting.Get(object), setting.Default);
  for (const double bound : { setting.Minimum, setting.Maximum })
  {
    setting.Set(object, bound);
    EXPECT_EQ(setting.Get(object), bound);
  }
  if (setting.Kind != SettingKind::Flag && setting.Maximum < LargestInteger)
  {
    setting.Set(object, 2.0 * setting.Maximum + 1.0);
    EXPECT_EQ(setting.Get(object), setting.Maximum);
  }
  const double lowest = setting.Kind == SettingKind::Integer ? -LargestInteger : -LargestNumber;
  if (setting.Kind != SettingKind::Flag && setting.Minimum > lowest)
  {
    setting.Set(object, setting.Minimum - 1.0);
    EXPECT_EQ(setting.Get(object), setting.Minimum);
  }
}

template <typename Owner>
void ExpectHeaderBehaves(Owner* object, const HapticVectorSetting<Owner>& setting)
{
  const SettingVector none{};
  EXPECT_EQ(setting.Get(object), setting.Default);
  for (const double bound : { setting.Minimum, setting.Maximum })
  {
    SettingVector wanted = none;
    for (int i = 0; i < setting.Size; ++i)
    {
      wanted[i] = i % 2 ? bound : 1.0;
    }
    setting.Set(object, wanted);
    EXPECT_EQ(setting.Get(object), wanted);
  }
}

/// Tests all settings of a list, each on a new object.
template <typename Class, template <typename> class Setting, typename Owner, std::size_t Size>
void ExpectHeadersBehave(const Setting<Owner> (&settings)[Size])
{
  for (const Setting<Owner>& setting : settings)
  {
    SCOPED_TRACE(setting.Name);
    vtkNew<Class> object;
    ExpectHeaderBehaves<Owner>(object, setting);
  }
}

template <typename... Lists>
std::vector<std::string> Names(const Lists&... lists)
{
  std::vector<std::string> all;
  const auto append = [&all](const auto& settings)
  {
    for (const auto& setting : settings)
    {
      all.emplace_back(setting.Name);
    }
  };
  (append(lists), ...);
  return all;
}

/// Expects one row for each setting macro of a header, and no other rows.
inline void ExpectRows(const std::string& header, std::vector<std::string> rows)
{
  std::ifstream file(PublicHeader(header));
  std::vector<std::string> found;
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t start = line.find("  vtkSet");
    const std::size_t open = line.find("Macro(");
    if (start == 0 && open != std::string::npos)
    {
      found.push_back(line.substr(open + 6, line.find_first_of(",)", open) - open - 6));
    }
  }
  std::sort(rows.begin(), rows.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, rows) << header;
}

/// Expects the comments of a header to begin with the documentation in the rows.
template <typename List>
void ExpectComments(const std::string& header, const List& settings)
{
  for (const auto& setting : settings)
  {
    const std::string comment = HeaderComment(header, setting.Name);
    EXPECT_TRUE(BeginsWith(Letters(comment), Letters(setting.Documentation)))
      << setting.Name << ":" << comment;
  }
}
} // namespace settingtest

#endif
