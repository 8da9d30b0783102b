// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/HapticRecordingFile.h"

#include "Core/Platform/FileReplacement.h"
#include "Core/Platform/Files.h"
#include "Core/Platform/HapticFiles.h"
#include "Core/State/ServoStateNumbers.h"
#include "VTK/Device/Recording/HapticJournal.h"
#include "VTK/Device/Recording/JournalReader.h"
#include "VTK/Tools/TissueArrays.h"
#include "VTK/Trace/HapticTraceColumns.h"
#include "VTK/Trace/HapticTraceFiles.h"
#include "VTK/Trace/RecordingNames.h"
#include "VTK/Trace/TraceRow.h"
#include "VTK/Trace/TraceWriter.h"

#include "vtkBase64Utilities.h"
#include "vtkType.h"
#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

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

/**
 * Returns the recorded columns, reordered with time and position first, for people who read the
 * table.
 */
std::vector<TraceColumn> OrderColumns()
{
  std::vector<TraceColumn> columns = GetRecordingColumns();
  std::rotate(columns.begin(), columns.end() - 1, columns.end());
  const auto time = std::find_if(columns.begin(), columns.end(),
    [](const TraceColumn& column) { return column.Name == std::string("Time"); });
  std::rotate(columns.begin(), time, time + 1);
  return columns;
}

/** Writes tuples of numbers as nested JSON lists. */
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

/**
 * Writes the point arrays as a .csv file. Returns false if the journal can't be read to its end.
 */
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
  std::vector<BrickTissue> bricks;
  const bool areSharesRead = journal.ReadTissue(bricks);
  const auto list = [&](const char* name, const auto& getRow)
  {
    key(name);
    file.Write("[");
    NumberList rows(file);
    for (const BrickTissue& brick : bricks)
    {
      const auto row = getRow(brick);
      const std::vector<double> asDoubles(row.begin(), row.end());
      rows.Add(asDoubles.data(), asDoubles.size());
    }
    file.Write("]");
  };
  if (!bricks.empty())
  {
    list(InitialTissueNames.Bricks, PlaceOfBrick);
    list(InitialTissueNames.Fractions, TissueAsBytes);
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

/** Encodes bytes as one continuous piece of base64: three bytes become four characters. */
class Base64
{
public:
  explicit Base64(FileReplacement& file)
    : File(file)
  {
  }

  void Write(const std::string& bytes)
  {
    this->Waiting += bytes;
    const std::size_t whole = this->Waiting.size() / 3 * 3;
    this->File.Write(Encode(this->Waiting.substr(0, whole)));
    this->Waiting.erase(0, whole);
  }
  void End() { this->File.Write(Encode(this->Waiting)); }

  static std::string Encode(const std::string& bytes)
  {
    std::string text((bytes.size() + 2) / 3 * 4, '\0');
    const unsigned long size =
      vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
        static_cast<unsigned long>(bytes.size()), reinterpret_cast<unsigned char*>(&text[0]), 0);
    text.resize(size);
    return text;
  }

private:
  FileReplacement& File;
  std::string Waiting;
};

/**
 * Writes the numbers of an array inline as VTK does: the number of blocks, their size, the size of
 * the last block if it is smaller, and the compressed sizes, all as 32-bit numbers in base64; then
 * the blocks.
 */
class InlineArray
{
public:
  InlineArray(FileReplacement& file, std::uint64_t bytes, std::size_t blockSize)
    : File(file)
    , Blocks(file)
    , Begin(file.GetSize())
  {
    this->Head = { static_cast<std::uint32_t>((bytes + blockSize - 1) / blockSize),
      static_cast<std::uint32_t>(blockSize), static_cast<std::uint32_t>(bytes % blockSize) };
    this->Sizes.reserve(this->Head[0]);
    // Leave room for the sizes, which are known only after the blocks.
    const std::string space(EncodeHead({}).size(), ' ');
    this->File.Write(space);
  }
  void WriteBlock(const std::string& block)
  {
    this->Sizes.push_back(static_cast<std::uint32_t>(block.size()));
    this->Blocks.Write(block);
  }
  /** Ends the array. Returns false if fewer blocks were written than the bytes need. */
  bool End()
  {
    this->Blocks.End();
    const bool isWhole = this->Sizes.size() == this->Head[0];
    this->File.WriteAt(this->Begin, this->EncodeHead(this->Sizes));
    return isWhole;
  }

private:
  std::string EncodeHead(std::vector<std::uint32_t> sizes) const
  {
    sizes.resize(this->Head[0]);
    sizes.insert(sizes.begin(), this->Head.begin(), this->Head.end());
    return Base64::Encode(std::string(
      reinterpret_cast<const char*>(sizes.data()), sizes.size() * sizeof(std::uint32_t)));
  }

  FileReplacement& File;
  Base64 Blocks;
  const std::uint64_t Begin;
  std::array<std::uint32_t, 3> Head;
  std::vector<std::uint32_t> Sizes;
};

const char* NameOf(ColumnType type)
{
  switch (type)
  {
    case ColumnType::Int64:
      return "Int64\" IdType=\"1";
    case ColumnType::Int32:
      return "Int32";
    case ColumnType::UInt8:
      return "UInt8";
    case ColumnType::Float64:
      break;
  }
  return "Float64";
}

class PolyDataFile
{
public:
  PolyDataFile(JournalReader& journal, FileReplacement& file)
    : Journal(journal)
    , File(file)
  {
  }

  bool Write()
  {
    const std::uint64_t ticks = this->Journal.GetNumberOfTicks();
    const int lines = ticks > 1 ? 1 : 0;
    this->File.Write(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"" +
      std::string(IsLittleEndian() ? "LittleEndian" : "BigEndian") +
      "\" header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n<FieldData>\n");
    this->WriteFields();
    this->File.Write("</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(ticks) +
      "\" NumberOfVerts=\"0\" NumberOfLines=\"" + std::to_string(lines) +
      "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n");
    const std::vector<TraceColumn>& columns = GetRecordingColumns();
    const std::size_t proxy = columns.size() - 1;
    for (std::size_t i = 0; i < proxy; ++i)
    {
      this->WriteColumn(i, columns[i].Name);
    }
    this->File.Write("</PointData>\n<CellData>\n</CellData>\n<Points>\n");
    this->WriteColumn(proxy, "Points");
    this->File.Write("</Points>\n");
    for (const char* const cells : { "Verts", "Lines", "Strips", "Polys" })
    {
      this->WriteCells(cells, cells == std::string("Lines") && ticks > 1 ? ticks : 0);
    }
    this->File.Write("</Piece>\n</PolyData>\n</VTKFile>\n");
    return this->IsGood;
  }

private:
  static bool IsLittleEndian()
  {
    const std::uint32_t one = 1;
    return *reinterpret_cast<const unsigned char*>(&one) == 1;
  }
  void BeginArray(
    const std::string& type, const std::string& name, int components, std::int64_t tuples)
  {
    this->File.Write("<DataArray type=\"" + type + "\" Name=\"" + name + "\"" +
      (components > 1 ? " NumberOfComponents=\"" + std::to_string(components) + "\"" : "") +
      (tuples >= 0 ? " NumberOfTuples=\"" + std::to_string(tuples) + "\"" : "") +
      " format=\"binary\">\n");
  }
  /** Writes numbers that are all in memory as one compressed block. */
  void WriteBlock(const void* data, std::size_t size)
  {
    InlineArray array(this->File, size, std::max<std::size_t>(size, 1));
    if (size > 0)
    {
      std::string block;
      this->Compressor.Compress(data, size, block);
      array.WriteBlock(block);
    }
    array.End();
  }
  void WriteNumbers(const char* name, const double* numbers, int components)
  {
    // Without ticks there is no first state, so leave the array empty.
    this->BeginArray("Float64", name, components, numbers ? 1 : 0);
    this->WriteBlock(numbers, numbers ? static_cast<std::size_t>(components) * sizeof(double) : 0);
    this->File.Write("\n</DataArray>\n");
  }
  void WriteText(const char* name, const std::string& text)
  {
    this->File.Write(std::string("<Array type=\"String\" Name=\"") + name +
      "\" NumberOfTuples=\"1\" format=\"binary\">\n");
    this->WriteBlock(text.c_str(), text.size() + 1); // includes the zero byte that ends each text
    this->File.Write("\n</Array>\n");
  }
  void WriteFields()
  {
    this->WritePlacements();
    const RecordingBegin* const begin = this->Journal.GetBegin();
    this->WriteNumbers(
      RecordingNames::InitialState, begin ? begin->State.data() : nullptr, ServoStateSize);
    this->WriteContacts();
    this->WriteTissue();
    if (begin && std::isfinite(begin->AirValue))
    {
      this->WriteNumbers(RecordingNames::AirValue, &begin->AirValue, 1);
    }
    this->WriteNumbers(RecordingNames::TickPeriod, begin ? &begin->TickPeriod : nullptr, 1);
    this->WriteCaps();
    const auto lost = static_cast<std::int64_t>(this->Journal.GetLostTicks());
    this->BeginArray(NameOf(ColumnType::Int64), "LostTicks", 1, 1);
    this->WriteBlock(&lost, sizeof(lost));
    this->File.Write("\n</DataArray>\n");
    const RecordingAbout& about = this->Journal.GetAbout();
    this->WriteText("DeviceId", about.DeviceId);
    this->WriteText(RecordingNames::Settings, about.Settings);
    this->WriteText("Units", RecordingUnits);
    this->WriteText("VolumeHash", about.VolumeHash);
  }
  void WriteCaps()
  {
    std::vector<double> caps;
    this->Require(this->Journal.ReadCaps(caps));
    this->BeginArray(
      "Float64", RecordingNames::Caps, 2, static_cast<std::int64_t>(caps.size() / 2));
    this->WriteBlock(caps.data(), caps.size() * sizeof(double));
    this->File.Write("\n</DataArray>\n");
  }
  void WriteContacts()
  {
    if (this->Journal.GetNumberOfContacts() == 0)
    {
      return;
    }
    std::vector<ContactRow> contacts;
    this->Require(this->Journal.ReadContacts(contacts));
    this->BeginArray("Float64", RecordingNames::InitialContacts,
      static_cast<int>(std::tuple_size<ContactRow>::value),
      static_cast<std::int64_t>(contacts.size()));
    this->WriteBlock(contacts.data(), contacts.size() * sizeof(ContactRow));
    this->File.Write("\n</DataArray>\n");
  }
  void WriteTissue()
  {
    if (this->Journal.GetNumberOfBricks() == 0)
    {
      return;
    }
    std::vector<BrickTissue> bricks;
    this->Require(this->Journal.ReadTissue(bricks));
    std::vector<decltype(PlaceOfBrick(bricks[0]))> places;
    std::vector<decltype(TissueAsBytes(bricks[0]))> shares;
    for (const BrickTissue& brick : bricks)
    {
      places.push_back(PlaceOfBrick(brick));
      shares.push_back(TissueAsBytes(brick));
    }
    const auto count = static_cast<std::int64_t>(bricks.size());
    this->BeginArray("Int32", InitialTissueNames.Bricks, 3, count);
    this->WriteBlock(places.data(), places.size() * sizeof(places[0]));
    this->File.Write("\n</DataArray>\n");
    this->BeginArray("UInt8", InitialTissueNames.Fractions, SamplesOfBrick, count);
    this->WriteBlock(shares.data(), shares.size() * sizeof(shares[0]));
    this->File.Write("\n</DataArray>\n");
  }
  void WritePlacements()
  {
    const std::uint64_t count = this->Journal.GetNumberOfPlacements();
    this->BeginArray(
      "Float64", RecordingNames::DeviceToWorld, 16, static_cast<std::int64_t>(count));
    using Matrix = decltype(PlacementRow::Matrix);
    InlineArray array(this->File, count * sizeof(Matrix), GroupSize * sizeof(Matrix));
    std::vector<Matrix> rows;
    std::string block;
    const auto write = [&]
    {
      block.clear();
      this->Compressor.Compress(rows.data(), rows.size() * sizeof(Matrix), block);
      array.WriteBlock(block);
      rows.clear();
    };
    this->Require(this->Journal.ForEachPlacement(
      [&](const PlacementRow& row)
      {
        rows.push_back(row.Matrix);
        rows.size() == GroupSize ? write() : void();
      }));
    rows.empty() ? void() : write();
    this->Require(array.End());
    this->File.Write("\n</DataArray>\n");
  }
  void WriteColumn(std::size_t i, const char* name)
  {
    const TraceColumn& column = GetRecordingColumns()[i];
    this->BeginArray(NameOf(column.Type), name, column.Components, -1);
    InlineArray array(this->File, this->Journal.GetNumberOfTicks() * column.GetWidth(),
      GroupSize * column.GetWidth());
    this->Require(
      this->Journal.ForEachBlock(i, [&](const std::string& block) { array.WriteBlock(block); }));
    this->Require(array.End());
    this->File.Write("\n</DataArray>\n");
  }
  /** Writes either no cell, or one cell through all points. */
  void WriteCells(const std::string& cells, std::uint64_t points)
  {
    this->File.Write("<" + cells + ">\n");
    this->BeginArray("Int64", "connectivity", 1, -1);
    // Each block has the 64-bit numbers of one group of points.
    InlineArray array(this->File, points * sizeof(std::int64_t), GroupSize * sizeof(std::int64_t));
    std::vector<std::int64_t> ids;
    std::string block;
    for (std::uint64_t first = 0; first < points; first += GroupSize)
    {
      ids.resize(std::min<std::uint64_t>(GroupSize, points - first));
      std::iota(ids.begin(), ids.end(), static_cast<std::int64_t>(first));
      block.clear();
      this->Compressor.Compress(ids.data(), ids.size() * sizeof(std::int64_t), block);
      array.WriteBlock(block);
    }
    array.End();
    this->File.Write("\n</DataArray>\n");
    this->BeginArray("Int64", "offsets", 1, -1);
    const auto end = static_cast<std::int64_t>(points);
    this->WriteBlock(&end, points > 0 ? sizeof(end) : 0);
    this->File.Write("\n</DataArray>\n</" + cells + ">\n");
  }
  void Require(bool isGood) { this->IsGood = this->IsGood && isGood; }

  JournalReader& Journal;
  FileReplacement& File;
  BlockCompressor Compressor;
  bool IsGood = true;
};

/**
 * Writes the .vtp of a recording block by block; vtkXMLPolyDataWriter would need the whole
 * recording in memory. Returns false if the journal can't be read to its end.
 */
bool WriteRecordingPolyData(JournalReader& journal, FileReplacement& file)
{
  return PolyDataFile(journal, file).Write();
}

bool IsThere(const std::string& file)
{
  Files::Status status;
  return Files::GetStatus(file, status);
}

/** Writes the file. On failure, returns false, with the reason and the cure in `error`. */
bool WriteFile(
  JournalReader& reader, const std::string& journal, const std::string& file, std::string& error)
{
  const bool isTable = GetTraceEnding(file) == ".csv";
  bool isRead = true;
  bool isWritten = false;
  FileReplacement main;
  FileReplacement fields;
  if (main.Open(file, error) && (!isTable || fields.Open(file + ".json", error)))
  {
    isRead = isTable ? WriteRecordingTable(reader, main) && WriteRecordingFields(reader, fields)
                     : WriteRecordingPolyData(reader, main);
    // Rename both temporary files only after both are completely on the disk.
    isWritten = isRead && main.Finish(error) && (!isTable || fields.Finish(error)) &&
      main.Commit(error) && (!isTable || fields.Commit(error));
  }
  if (!isRead)
  {
    error = "The unfinished recording " + Printable(journal) +
      " can't be read to its end: check the disk that it is on.";
  }
  else if (!isWritten)
  {
    error = "The recording " + Printable(file) + " can't be written: " + error;
  }
  return isWritten;
}

} // namespace

const char* const RecordingUnits = "points and Tip: world; DeviceTip: m; Time: s; forces, Command, "
                                   "Viscosity and SurfaceStrength: N; Torque: N m; "
                                   "Stiffness: N/m; Value, SurfaceValue and MediumValue: scalar; "
                                   "GradientMagnitude: scalar per world";

bool WriteRecording(JournalReader& reader, const std::string& journal, const std::string& file,
  const std::string& trouble, std::string& error)
{
  const std::string name = Printable(journal);
  const std::string& damage = reader.GetDamage();
  const std::string problem = trouble + (trouble.empty() || damage.empty() ? "" : " ") +
    (damage.empty() ? "" : "The unfinished recording " + name + " " + damage + ".");
  error.clear();
  bool isWritten = false;
  if (!problem.empty() && IsThere(file))
  {
    error = problem + " The file that is there stays as it is.";
  }
  else
  {
    isWritten = WriteFile(reader, journal, file, error);
    error = !isWritten && !trouble.empty() ? trouble
      : isWritten && !problem.empty()      ? problem + " The file holds these ticks."
                                           : error;
  }
  if (isWritten && damage.empty())
  {
    reader.Remove(journal);
  }
  else
  {
    error += reader.IsAt(journal)
      ? " What was recorded is kept in " + name + ": write it with vtkHapticRecorder::Recover(\"" +
        name + "\", FILE) to a file of your choice."
      : " Another program removed or replaced " + name + ", in which it was kept.";
  }
  return error.empty();
}

bool WriteRecording(const std::string& journal, const std::string& file, std::string& error)
{
  const std::string ending = GetTraceEnding(file);
  if (ending.empty())
  {
    error =
      "The recording \"" + Printable(file) + "\" has an unknown extension: name it .vtp or .csv.";
    return false;
  }
  JournalReader reader;
  if (!reader.Open(journal, error))
  {
    error = "The unfinished recording " + Printable(journal) + " " + error + ".";
    return false;
  }
  if (reader.IsAt(file) || (ending == ".csv" && reader.IsAt(file + ".json")))
  {
    error = "The unfinished recording " + Printable(journal) +
      " can't be written over itself: give the recording another name.";
    return false;
  }
  return WriteRecording(reader, journal, file, "", error);
}

} // namespace VolumeHaptics
