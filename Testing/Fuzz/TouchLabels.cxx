// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchLabels.h"

#include "Core/Platform/HapticFiles.h"
#include "Dealer.h"
#include "VTK/Material/Labels/ColorTables.h"
#include "VTK/Material/Labels/CsvLabels.h"
#include "VTK/Material/Labels/NiftiLabels.h"
#include "VTK/Material/Labels/NrrdLabels.h"

#include <cmath>
#include <string_view>
#include <vector>

using namespace VolumeHaptics;

namespace
{
void CheckMaterial(const std::optional<double>& value)
{
  Check(!value || (std::isfinite(*value) && *value >= 0.0), "materials are 0 or more");
}

void CheckEntries(const LabelEntries& entries)
{
  for (const auto& [label, entry] : entries)
  {
    const std::string name = entry.Name.value_or("");
    Check(IsUtf8(name), "names are UTF-8");
    for (const double part : entry.Color.value_or(std::array<double, 3>{}))
    {
      Check(part >= 0.0 && part <= 1.0, "colours are from 0 to 1");
    }
    CheckMaterial(entry.Stiffness);
    CheckMaterial(entry.Friction);
    CheckMaterial(entry.Viscosity);
    CheckMaterial(entry.SurfaceStrength);
  }
}

void CheckRoundTrip(LabelEntries entries)
{
  LabelEntries back;
  std::string error;
  // A table cell can't distinguish a missing name from an empty name.
  for (auto& [label, entry] : entries)
  {
    if (entry.Name && entry.Name->empty())
    {
      entry.Name.reset();
    }
  }
  Check(ReadCsv(WriteCsv(entries), back, error), "what is written can be read");
  Check(back == entries, "what is written is read");
}

using Reader = bool (*)(std::string_view, LabelEntries&, std::string&);

void TouchReader(Reader read, std::string_view bytes)
{
  LabelEntries before;
  before[7].Name = "before";
  LabelEntries entries = before;
  std::string error;
  if (!read(bytes, entries, error))
  {
    Check(entries == before, "a refusal changes nothing");
    Check(
      !error.empty() && error.back() == '.' && Printable(error) == error, "a refusal has a reason");
    return;
  }
  CheckEntries(entries);
  CheckRoundTrip(entries);
}

void TouchSegmentation(std::string_view bytes)
{
  SegmentationHeader header;
  NrrdImage image;
  std::string error;
  if (!ReadSegmentationHeader(bytes, header, error) || !ReadNrrdImage(header, image, error))
  {
    Check(!error.empty() && error.back() == '.', "a refusal has a reason");
    return;
  }
  constexpr std::size_t most = 100000;
  if (image.CountBytes() > most)
  {
    return;
  }
  std::string_view rest = bytes.substr(header.Size);
  const auto read = [&rest](char* to, std::size_t size)
  {
    const std::size_t had = rest.copy(to, size);
    rest.remove_prefix(had);
    return had;
  };
  std::vector<int> labels(image.CountVoxels());
  Check(ReadNrrdSamples(header, image, read, labels.data(), error) || !error.empty(),
    "a refusal has a reason");
}
} // namespace

void TouchLabels(const std::uint8_t* bytes, std::size_t size)
{
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  for (const Reader read :
    { ReadCsv, ReadItkSnapTable, ReadFreeSurferTable, ReadNameList, ReadNrrdLabels })
  {
    TouchReader(read, text);
  }
  TouchSegmentation(text);
  IsCsv(text);
  IsItkSnapTable(text);
  IsFreeSurferTable(text);
  IsNameList(text);
  if (IsPalette(text))
  {
    LabelEntries entries;
    ReadPalette(text, entries);
    CheckEntries(entries);
    CheckRoundTrip(entries);
  }
  std::string_view table;
  const NiftiTable found = FindNiftiTable(text, table);
  Check((found == NiftiTable::None) == table.empty(), "a table that is found is there");
  Check(table.empty() ||
      (table.data() >= text.data() && table.data() + table.size() <= text.data() + size),
    "a table is in its file");
  Check(GetNiftiHeadSize(text, 1 << 20) <= 1 << 20, "heads have their limit");
}
