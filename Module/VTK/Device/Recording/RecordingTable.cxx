// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/RecordingTable.h"

#include "Core/State/ServoStateNumbers.h"
#include "VTK/Base/FileReplacement.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Device/Recording/HapticRecordingFile.h"
#include "VTK/Device/Recording/JournalReader.h"
#include "VTK/Tools/ShareArrays.h"
#include "VTK/Trace/HapticTraceColumns.h"
#include "VTK/Trace/RecordingNames.h"
#include "VTK/Trace/TraceRow.h"
#include "VTK/Trace/TraceWriter.h"

#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cstring>

namespace VolumeHaptics
{
namespace
{

template <typename T>
double NumberAt(const unsigned char* bytes, int component)
{
  T number;
  std::memcpy(&number, bytes + static_cast<std::size_t>(component) * sizeof(T), sizeof(T));
  return static_cast<double>(number);
}

double NumberAt(const RecordingRow& row, const TraceColumn& column, int component)
{
  const auto* const bytes = reinterpret_cast<const unsigned char*>(&row) + column.Offset;
  switch (column.Type)
  {
    case ColumnType::Int64:
      return NumberAt<std::int64_t>(bytes, component);
    case ColumnType::Int32:
      return NumberAt<std::int32_t>(bytes, component);
    case ColumnType::UInt8:
      return NumberAt<unsigned char>(bytes, component);
    case ColumnType::Float64:
      break;
  }
  return NumberAt<double>(bytes, component);
}

/** Orders the columns with time and position first, for human readers. */
std::vector<TraceColumn> OrderColumns()
{
  std::vector<TraceColumn> columns = GetRecordingColumns();
  std::rotate(columns.begin(), columns.end() - 1, columns.end());
  const auto time = std::find_if(columns.begin(), columns.end(),
    [](const TraceColumn& column) { return column.Name == std::string("Time"); });
  std::rotate(columns.begin(), time, time + 1);
  return columns;
}

/** Writes tuples of numbers as lists of lists. */
class NumberList
{
public:
  explicit NumberList(FileReplacement& file)
    : File(file)
  {
  }
  void Add(const double* numbers, std::size_t count)
  {
    std::string text = this->IsEmpty ? "[" : ",\n  [";
    for (std::size_t i = 0; i < count; ++i)
    {
      text += (i > 0 ? ", " : "") + Json::valueToString(numbers[i]);
    }
    this->File.Write(text + "]");
    this->IsEmpty = false;
  }

private:
  FileReplacement& File;
  bool IsEmpty = true;
};

} // namespace

bool WriteRecordingTable(JournalReader& journal, FileReplacement& file)
{
  const std::vector<TraceColumn> columns = OrderColumns();
  TraceTable table;
  for (const TraceColumn& column : columns)
  {
    table.AddTitle(column.Name, column.Components);
  }
  file.Write(table.EndLine());
  return journal.ForEachRow(
    [&](const RecordingRow& row)
    {
      for (const TraceColumn& column : columns)
      {
        for (int c = 0; c < column.Components; ++c)
        {
          table.AddNumber(NumberAt(row, column, c));
        }
      }
      file.Write(table.EndLine());
    });
}

bool WriteRecordingFields(JournalReader& journal, FileReplacement& file)
{
  const auto key = [&file](const char* name, bool isFirst = false)
  { file.Write(std::string(isFirst ? "{\n" : ",\n") + " \"" + name + "\" : "); };
  const auto numbers =
    [&](const char* name, const double* values, std::size_t count, bool isFirst = false)
  {
    key(name, isFirst);
    file.Write("[");
    if (values)
    {
      NumberList(file).Add(values, count);
    }
    file.Write("]");
  };
  const auto words = [&](const char* name, const std::string& text)
  {
    key(name);
    file.Write(Json::valueToQuotedString(Printable(text).c_str()));
  };
  const RecordingBegin* const begin = journal.GetBegin();
  std::vector<double> caps;
  const bool areCapsRead = journal.ReadCaps(caps);
  numbers(RecordingNames::Caps, caps.data(), caps.size(), true);
  if (begin && std::isfinite(begin->AirValue))
  {
    numbers(RecordingNames::AirValue, &begin->AirValue, 1);
  }
  words("DeviceId", journal.GetAbout().DeviceId);
  key(RecordingNames::DeviceToWorld);
  file.Write("[");
  NumberList placements(file);
  const bool isRead = journal.ForEachPlacement(
    [&](const PlacementRow& row) { placements.Add(row.Matrix.data(), row.Matrix.size()); });
  file.Write("]");
  numbers(RecordingNames::InitialState, begin ? begin->State.data() : nullptr, ServoStateSize);
  std::vector<ContactRow> contacts;
  const bool areContactsRead = journal.ReadContacts(contacts);
  if (!contacts.empty())
  {
    key(RecordingNames::InitialContacts);
    file.Write("[");
    NumberList rows(file);
    for (const ContactRow& row : contacts)
    {
      rows.Add(row.data(), row.size());
    }
    file.Write("]");
  }
  std::vector<BrickShares> bricks;
  const bool areSharesRead = journal.ReadShares(bricks);
  const auto list = [&](const char* name, const auto& getRow)
  {
    key(name);
    file.Write("[");
    NumberList rows(file);
    for (const BrickShares& brick : bricks)
    {
      const auto row = getRow(brick);
      const std::vector<double> asDoubles(row.begin(), row.end());
      rows.Add(asDoubles.data(), asDoubles.size());
    }
    file.Write("]");
  };
  if (!bricks.empty())
  {
    list(InitialShareNames.Bricks, PlaceOfBrick);
    list(InitialShareNames.Shares, SharesAsBytes);
  }
  const auto lost = static_cast<double>(journal.GetLostTicks());
  numbers("LostTicks", &lost, 1);
  words("Settings", journal.GetAbout().Settings);
  numbers(RecordingNames::TickPeriod, begin ? &begin->TickPeriod : nullptr, 1);
  words("Units", RecordingUnits);
  words("VolumeHash", journal.GetAbout().VolumeHash);
  file.Write("\n}\n");
  return isRead && areCapsRead && areContactsRead && areSharesRead;
}

} // namespace VolumeHaptics
