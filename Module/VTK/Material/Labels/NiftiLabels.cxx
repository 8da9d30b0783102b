// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/NiftiLabels.h"

#include "VTK/Material/Labels/ColorTables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace VolumeHaptics
{
namespace
{

/** Sizes and offsets (bytes) in a header that depend on the version of NIfTI. */
struct Version
{
  std::size_t HeaderSize;
  std::size_t Magic;
  const char* Single; ///< magic of a file with header and samples
  const char* Pair;   ///< magic of a file with the header alone
};
constexpr Version Versions[] = { { 348, 344, "n+1", "ni1" }, { 540, 4, "n+2", "ni2" } };
constexpr std::size_t ExtenderSize = 4;
constexpr std::size_t ExtensionHeadSize = 8;

/**
 * Reads a number from the file. `isSwapped`: the file's byte order differs from this computer's.
 */
template <typename Number>
Number Load(std::string_view bytes, std::size_t offset, bool isSwapped)
{
  Number number{};
  if (offset + sizeof(Number) <= bytes.size())
  {
    char raw[sizeof(Number)];
    std::copy_n(bytes.data() + offset, sizeof(Number), raw);
    if (isSwapped)
    {
      std::reverse(raw, raw + sizeof(Number));
    }
    std::memcpy(&number, raw, sizeof(Number));
  }
  return number;
}

/**
 * Returns the version of a NIfTI file, and whether its bytes are swapped. Returns null for other
 * files.
 */
const Version* ReadVersion(std::string_view bytes, bool& isSwapped)
{
  for (const Version& version : Versions)
  {
    const std::string_view magic = bytes.substr(std::min(version.Magic, bytes.size()), 3);
    const auto size = static_cast<std::int32_t>(version.HeaderSize);
    isSwapped = Load<std::int32_t>(bytes, 0, false) != size;
    if (Load<std::int32_t>(bytes, 0, isSwapped) == size &&
      (magic == version.Single || magic == version.Pair))
    {
      return &version;
    }
  }
  return nullptr;
}

/** Returns the XML text with labels from the header extensions; empty if there is none. */
std::string_view FindXml(std::string_view extensions, bool isSwapped)
{
  while (extensions.size() > ExtensionHeadSize)
  {
    const auto size = Load<std::int32_t>(extensions, 0, isSwapped);
    if (size <= static_cast<std::int32_t>(ExtensionHeadSize))
    {
      return {};
    }
    std::string_view data = extensions.substr(0, static_cast<std::size_t>(size));
    extensions.remove_prefix(data.size());
    data.remove_prefix(ExtensionHeadSize);
    if (data.find("<LabelTable") != std::string_view::npos)
    {
      // Cut off the zeros that pad an extension.
      return data.substr(0, data.find('\0'));
    }
  }
  return {};
}

} // namespace

bool IsNifti(std::string_view bytes)
{
  bool isSwapped = false;
  return ReadVersion(bytes, isSwapped) != nullptr;
}

std::size_t GetNiftiHeadSize(std::string_view bytes, std::size_t most)
{
  bool isSwapped = false;
  const Version* const version = ReadVersion(bytes, isSwapped);
  if (!version)
  {
    return 0;
  }
  // Read the whole file if it contains only a header.
  double size = static_cast<double>(most);
  if (version == &Versions[0] && bytes.substr(version->Magic, 3) == version->Single)
  {
    size = Load<float>(bytes, 108, isSwapped);
  }
  else if (bytes.substr(version->Magic, 3) == version->Single)
  {
    size = static_cast<double>(Load<std::int64_t>(bytes, 168, isSwapped));
  }
  const auto least = static_cast<double>(version->HeaderSize);
  return std::isfinite(size)
    ? static_cast<std::size_t>(std::clamp(size, least, std::max(least, static_cast<double>(most))))
    : version->HeaderSize;
}

NiftiTable FindNiftiTable(std::string_view bytes, std::string_view& table)
{
  table = {};
  bool isSwapped = false;
  const Version* const version = ReadVersion(bytes, isSwapped);
  bytes = bytes.substr(0, GetNiftiHeadSize(bytes, bytes.size()));
  if (!version || bytes.size() <= version->HeaderSize + ExtenderSize)
  {
    return NiftiTable::None;
  }
  const bool hasExtension = bytes[version->HeaderSize] != 0;
  bytes.remove_prefix(version->HeaderSize + ExtenderSize);
  if (hasExtension)
  {
    table = FindXml(bytes, isSwapped);
    return table.empty() ? NiftiTable::None : NiftiTable::Xml;
  }
  const std::string_view names = bytes.substr(0, bytes.find('\0'));
  if (IsNameList(names))
  {
    table = names;
    return NiftiTable::Names;
  }
  return NiftiTable::None;
}

} // namespace VolumeHaptics
