// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/CsvLabels.h"

#include "VTK/Material/Labels/CsvRows.h"
#include "VTK/Material/Labels/LabelText.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

enum class Column
{
  Other,
  Label,
  Name,
  Stiffness,
  Friction,
  Viscosity,
  SurfaceStrength,
  ShaftFriction,
  SpecificEnergy,
  Felt,
  Forbidden,
  Color,
  Red,
  Green,
  Blue
};

struct ColumnName
{
  const char* Key;
  Column Meaning;
};

constexpr ColumnName ColumnNames[] = { { "label", Column::Label }, { "labelvalue", Column::Label },
  { "index", Column::Label }, { "id", Column::Label }, { "value", Column::Label },
  { "name", Column::Name }, { "labelname", Column::Name }, { "structure", Column::Name },
  { "stiffness", Column::Stiffness }, { "friction", Column::Friction },
  { "viscosity", Column::Viscosity }, { "strength", Column::SurfaceStrength },
  { "surfacestrength", Column::SurfaceStrength }, { "shaft", Column::ShaftFriction },
  { "shaftfriction", Column::ShaftFriction }, { "energy", Column::SpecificEnergy },
  { "specificenergy", Column::SpecificEnergy }, { "felt", Column::Felt },
  { "forbidden", Column::Forbidden }, { "color", Column::Color }, { "colour", Column::Color },
  { "red", Column::Red }, { "r", Column::Red }, { "green", Column::Green }, { "g", Column::Green },
  { "blue", Column::Blue }, { "b", Column::Blue } };

Column FindColumn(std::string_view title)
{
  const std::string key = MakeKey(title);
  const auto* const found = std::find_if(std::begin(ColumnNames), std::end(ColumnNames),
    [&key](const ColumnName& name) { return key == name.Key; });
  return found == std::end(ColumnNames) ? Column::Other : found->Meaning;
}

std::optional<bool> ReadFlag(std::string_view text)
{
  const std::string key = MakeKey(text);
  for (const char* const yes : { "1", "1.0", "true", "yes" })
  {
    if (key == yes)
    {
      return true;
    }
  }
  for (const char* const no : { "0", "0.0", "false", "no" })
  {
    if (key == no)
    {
      return false;
    }
  }
  return {};
}

/**
 * Converts three numbers to a colour. They range from 0 to 1 if none is above 1, otherwise from 0
 * to 255.
 */
std::optional<std::array<double, 3>> ReadColorNumbers(
  const std::optional<double>& r, const std::optional<double>& g, const std::optional<double>& b)
{
  if (!r || !g || !b)
  {
    return {};
  }
  const double scale = std::max({ *r, *g, *b }) > 1.0 ? 255.0 : 1.0;
  return MakeColor(*r / scale, *g / scale, *b / scale);
}

std::optional<std::array<double, 3>> ReadColor(std::string_view text)
{
  if (text.substr(0, 1) != "#")
  {
    const std::vector<std::string_view> words = SplitWords(text);
    return words.size() == 3
      ? ReadColorNumbers(ReadNumber(words[0]), ReadNumber(words[1]), ReadNumber(words[2]))
      : std::nullopt;
  }
  if (text.size() != 7 ||
    text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string_view::npos)
  {
    return {};
  }
  const auto part = [text](std::size_t from)
  { return std::stoi(std::string(text.substr(from, 2)), nullptr, 16) / 255.0; };
  return MakeColor(part(1), part(3), part(5));
}

/** Reads the rows below the titles of a CSV. */
class CsvReader
{
public:
  CsvReader(std::vector<std::string> titles, bool allowsCommas)
    : Titles(std::move(titles))
    , AllowsCommas(allowsCommas)
  {
    bool hasLabel = false;
    for (const std::string& title : this->Titles)
    {
      Column meaning = FindColumn(title);
      // If several columns have labels, use only the first.
      meaning = meaning == Column::Label && hasLabel ? Column::Other : meaning;
      hasLabel = hasLabel || meaning == Column::Label;
      this->Columns.push_back(meaning);
    }
  }

  bool ReadRow(const std::vector<std::string>& cells, LabelEntries& entries, std::string& error)
  {
    std::optional<int> label;
    LabelEntry entry;
    std::optional<double> parts[3];
    for (std::size_t i = 0; i < std::min(cells.size(), this->Columns.size()); ++i)
    {
      const std::string& cell = cells[i];
      if (cell.empty() || this->Columns[i] == Column::Other)
      {
        continue;
      }
      if (this->Columns[i] == Column::Label)
      {
        label = ReadLabel(cell, error);
        if (!label)
        {
          return false;
        }
      }
      else if (const char* const wanted = this->ReadCell(this->Columns[i], cell, entry, parts))
      {
        error = "column " + Quote(this->Titles[i]) + " has " + Quote(cell) + ". Write " + wanted +
          ", or leave the cell empty";
        return false;
      }
    }
    if (!label)
    {
      error = "the label is missing. Write a whole number in its column";
      return false;
    }
    if (parts[0] || parts[1] || parts[2])
    {
      entry.Color = ReadColorNumbers(parts[0], parts[1], parts[2]);
      if (!entry.Color)
      {
        error = "red, green and blue make no colour. Write three numbers from 0 to 1, or from 0 to "
                "255, or leave the cells empty";
        return false;
      }
    }
    entries[*label] = std::move(entry);
    return true;
  }

private:
  /**
   * Reads a cell into an entry. Returns nullptr, or, for an invalid cell, a description of what is
   * allowed.
   */
  const char* ReadCell(
    Column column, const std::string& cell, LabelEntry& entry, std::optional<double> (&parts)[3])
  {
    switch (column)
    {
      case Column::Name:
        entry.Name = MakeLabelName(cell);
        return nullptr;
      case Column::Color:
        entry.Color = ReadColor(cell);
        return entry.Color ? nullptr : "a colour, such as #dd8265 or 0.87 0.51 0.4";
      case Column::Felt:
        entry.Felt = ReadFlag(cell);
        return entry.Felt ? nullptr : "1 or 0";
      case Column::Forbidden:
        entry.Forbidden = ReadFlag(cell);
        return entry.Forbidden ? nullptr : "1 or 0";
      default:
        break;
    }
    const std::optional<double> number = this->ReadNumberIn(cell);
    if (!number || *number < 0.0)
    {
      return "a number, 0 or more";
    }
    switch (column)
    {
      case Column::Stiffness:
        entry.Stiffness = number;
        break;
      case Column::Friction:
        entry.Friction = number;
        break;
      case Column::Viscosity:
        entry.Viscosity = number;
        break;
      case Column::SurfaceStrength:
        entry.SurfaceStrength = number;
        break;
      case Column::ShaftFriction:
        entry.ShaftFriction = number;
        break;
      case Column::SpecificEnergy:
        entry.SpecificEnergy = number;
        break;
      default:
        parts[static_cast<int>(column) - static_cast<int>(Column::Red)] = number;
    }
    return nullptr;
  }

  std::optional<double> ReadNumberIn(std::string cell) const
  {
    if (this->AllowsCommas)
    {
      std::replace(cell.begin(), cell.end(), ',', '.');
    }
    return ReadNumber(cell);
  }

  std::vector<std::string> Titles;
  std::vector<Column> Columns;
  bool AllowsCommas;
};

/** Returns a colour as #rrggbb if that is exact, otherwise as three numbers. */
std::string WriteColor(const std::array<double, 3>& color)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  if (std::all_of(color.begin(), color.end(),
        [](double part) { return std::round(part * 255.0) / 255.0 == part; }))
  {
    text << "#" << std::hex << std::setfill('0');
    for (const double part : color)
    {
      text << std::setw(2) << static_cast<int>(std::round(part * 255.0));
    }
  }
  else
  {
    text << color[0] << " " << color[1] << " " << color[2];
  }
  return text.str();
}

} // namespace

bool IsCsv(std::string_view text)
{
  const std::string_view line = FirstLine(text);
  CsvRows rows(line, DetectSeparator(line));
  std::vector<std::string> titles;
  return rows.Next(titles) && titles.size() > 1 &&
    std::any_of(titles.begin(), titles.end(),
      [](const std::string& title) { return FindColumn(title) == Column::Label; });
}

bool ReadCsv(std::string_view text, LabelEntries& entries, std::string& error)
{
  const char separator = DetectSeparator(text);
  CsvRows rows(text, separator);
  std::vector<std::string> cells;
  while (rows.Next(cells) && IsEmptyRow(cells))
  {
  }
  CsvReader reader(cells, separator == ';');
  LabelEntries found;
  while (rows.Next(cells))
  {
    if (!IsEmptyRow(cells) && !reader.ReadRow(cells, found, error))
    {
      error = InLine(rows.GetLine()) + error + ".";
      return false;
    }
  }
  if (rows.IsCutOff())
  {
    error = InLine(rows.GetLine()) +
      "a quote is opened and never closed. Close it, or check that the file is complete.";
    return false;
  }
  entries = std::move(found);
  return true;
}

std::string WriteCsv(const LabelEntries& entries)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  const auto number = [&text](const std::optional<double>& value)
  {
    text << ",";
    if (value)
    {
      text << *value;
    }
  };
  const auto flag = [&text](const std::optional<bool>& value)
  { text << "," << (value ? (*value ? "1" : "0") : ""); };
  // Write the columns for needles and burrs only if an entry uses them.
  const auto isUsed = [&entries](std::optional<double> LabelEntry::*member)
  {
    return std::any_of(entries.begin(), entries.end(),
      [member](const auto& entry) { return (entry.second.*member).has_value(); });
  };
  const bool hasShaft = isUsed(&LabelEntry::ShaftFriction);
  const bool hasEnergy = isUsed(&LabelEntry::SpecificEnergy);
  text << "label,name,stiffness,friction,viscosity,strength," << (hasShaft ? "shaft," : "")
       << (hasEnergy ? "energy," : "") << "felt,forbidden,color\n";
  for (const auto& [label, entry] : entries)
  {
    text << label << "," << WriteCell(entry.Name.value_or(""));
    number(entry.Stiffness);
    number(entry.Friction);
    number(entry.Viscosity);
    number(entry.SurfaceStrength);
    if (hasShaft)
    {
      number(entry.ShaftFriction);
    }
    if (hasEnergy)
    {
      number(entry.SpecificEnergy);
    }
    flag(entry.Felt);
    flag(entry.Forbidden);
    text << "," << (entry.Color ? WriteColor(*entry.Color) : "") << "\n";
  }
  return text.str();
}

} // namespace VolumeHaptics
