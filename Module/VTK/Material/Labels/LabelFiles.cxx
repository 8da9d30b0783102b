// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/LabelFiles.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Material/Labels/ColorTables.h"
#include "VTK/Material/Labels/CsvLabels.h"
#include "VTK/Material/Labels/LabelEntry.h"
#include "VTK/Material/Labels/LabelText.h"
#include "VTK/Material/Labels/NiftiLabels.h"
#include "VTK/Material/Labels/NrrdLabels.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace
{

using namespace VolumeHaptics;

/** Collects the elements "Label" of an XML text. */
class LabelXmlParser : public vtkXMLParser
{
public:
  static LabelXmlParser* New();
  vtkTypeMacro(LabelXmlParser, vtkXMLParser);
  LabelXmlParser(const LabelXmlParser&) = delete;
  void operator=(const LabelXmlParser&) = delete;

  LabelEntries Entries;
  std::string Error;

protected:
  LabelXmlParser() = default;

  void StartElement(const char* name, const char** attributes) override
  {
    this->Label.reset();
    if (std::string_view(name) != "Label")
    {
      return;
    }
    std::string key;
    std::string color[3];
    for (; attributes[0] && attributes[1]; attributes += 2)
    {
      const std::string_view attribute = attributes[0];
      std::string& value = attribute == "Key" ? key
        : attribute == "Red"                  ? color[0]
        : attribute == "Green"                ? color[1]
        : attribute == "Blue"                 ? color[2]
                                              : this->Ignored;
      value = attributes[1];
    }
    this->Name.clear();
    std::string error;
    this->Label = ReadLabel(key, error);
    if (!this->Label)
    {
      this->Fail(error);
      return;
    }
    LabelEntry& entry = this->Entries[*this->Label];
    entry = {};
    entry.Color = MakeColor(ReadNumber(color[0]).value_or(-1.0),
      ReadNumber(color[1]).value_or(-1.0), ReadNumber(color[2]).value_or(-1.0));
  }

  void CharacterDataHandler(const char* data, int length) override
  {
    if (this->Label)
    {
      this->Name.append(data, static_cast<std::size_t>(length));
    }
  }

  void EndElement(const char*) override
  {
    if (this->Label)
    {
      this->Entries[*this->Label].Name = MakeLabelName(Trim(this->Name));
      this->Label.reset();
    }
  }

  void ReportXmlParseError() override { this->Fail("its XML is not well-formed"); }

private:
  void Fail(const std::string& reason) { this->Error = this->Error.empty() ? reason : this->Error; }

  std::optional<int> Label; ///< label of the currently open element
  std::string Name;
  std::string Ignored;
};
vtkStandardNewMacro(LabelXmlParser);

} // namespace

namespace VolumeHaptics
{

GzipFile OpenGzipFile(const std::string& name, std::size_t offset, std::string& error)
{
  const int descriptor = Files::Open(name, Files::For::Reading);
  const bool isThere =
    descriptor >= 0 && Files::Seek(descriptor, static_cast<std::int64_t>(offset));
  GzipFile file(isThere ? gzdopen(descriptor, "rb") : nullptr, gzclose);
  if (!file)
  {
    error = "can't be read (" + DescribeError(errno) + "). Check its permissions.";
    if (descriptor >= 0)
    {
      Files::Close(descriptor);
    }
  }
  return file;
}

namespace
{

/**
 * Reads labels from XML. On failure, returns false, with the reason and the cure in `error`, and
 * leaves the entries unchanged.
 */
bool ReadXmlLabels(std::string_view xml, LabelEntries& entries, std::string& error)
{
  xml = Trim(xml);
  vtkNew<LabelXmlParser> parser;
  const bool isShort = xml.size() <= std::numeric_limits<unsigned int>::max();
  const bool isParsed =
    isShort && parser->Parse(xml.data(), static_cast<unsigned int>(xml.size())) != 0;
  if (!isParsed || !parser->Error.empty())
  {
    error = "the table of labels in its header can't be used: " +
      (parser->Error.empty() ? "its XML is not well-formed" : parser->Error) +
      ". Save the file again, or give the names in a table of their own.";
    return false;
  }
  entries = std::move(parser->Entries);
  return true;
}

constexpr std::size_t LargestTable = 256 << 20; // bytes; a million labels take some 50 MiB
constexpr std::size_t LargestHead = 64 << 20;
constexpr std::size_t ChunkOfLabels = 1 << 16;

constexpr const char* KnownTables =
  "Give a .seg.nrrd of 3D Slicer, a NIfTI file of TotalSegmentator, label descriptions of "
  "ITK-SNAP, a colour table of FreeSurfer, a .vti with a table, or a CSV file whose first line "
  "names the columns, such as label,name,stiffness";

/** Computes how many bytes of the file are needed, from the bytes read so far. */
std::size_t CountNeeded(std::string_view bytes)
{
  if (IsNrrd(bytes))
  {
    for (const char* const end : { "\n\n", "\n\r\n" })
    {
      if (bytes.find(end) != std::string_view::npos)
      {
        return 0;
      }
    }
    return LargestHead;
  }
  if (IsNifti(bytes))
  {
    return GetNiftiHeadSize(bytes, LargestHead);
  }
  return IsVtkFile(bytes) ? 0 : LargestTable + 1;
}

} // namespace

bool ReadLabelBytes(const std::string& file, std::string& bytes, std::string& error)
{
  bytes.clear();
  if (!CheckRegular(file, error))
  {
    error += ". Check its name.";
    return false;
  }
  const GzipFile opened = OpenGzipFile(file, 0, error);
  if (!opened)
  {
    return false;
  }
  const auto chunk = std::make_unique<char[]>(ChunkOfLabels);
  bool hasEnded = false;
  do
  {
    const int got = gzread(opened.get(), chunk.get(), static_cast<unsigned>(ChunkOfLabels));
    int number = Z_OK;
    const std::string why = got <= 0 ? gzerror(opened.get(), &number) : "";
    // Detect a truncated file by this error number: otherwise zlib reports its end like that of a
    // complete file.
    if (got < 0 || number == Z_BUF_ERROR)
    {
      error = "can't be read (" + (number == Z_ERRNO ? DescribeError(errno) : Printable(why)) +
        "). Check that the file is complete.";
      return false;
    }
    bytes.append(chunk.get(), static_cast<std::size_t>(got));
    hasEnded = got == 0;
  } while (!hasEnded && bytes.size() < CountNeeded(bytes));
  if (bytes.size() > LargestTable)
  {
    error = "is larger than " + std::to_string(LargestTable >> 20) + " MiB. " + KnownTables + ".";
    return false;
  }
  return true;
}

bool IsVtkFile(std::string_view bytes)
{
  return bytes.substr(0, 512).find("<VTKFile") != std::string_view::npos;
}

bool ReadLabels(std::string_view bytes, LabelEntries& entries, std::string& error)
{
  if (IsNrrd(bytes))
  {
    return ReadNrrdLabels(bytes, entries, error);
  }
  if (IsNifti(bytes))
  {
    std::string_view table;
    switch (FindNiftiTable(bytes, table))
    {
      case NiftiTable::Xml:
        return ReadXmlLabels(table, entries, error);
      case NiftiTable::Names:
        return ReadNameList(table, entries, error);
      default:
        error = "its NIfTI header has no table of labels. Let TotalSegmentator write it with --ml, "
                "or give the names in a table of their own.";
        return false;
    }
  }
  if (IsPalette(bytes))
  {
    ReadPalette(bytes, entries);
    return true;
  }
  if (bytes.substr(0, 2) == "\xFF\xFE" || bytes.substr(0, 2) == "\xFE\xFF")
  {
    error = "it is a text in UTF-16. Save it as UTF-8.";
    return false;
  }
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF")
  {
    bytes.remove_prefix(3);
  }
  const bool isText = bytes.find('\0') == std::string_view::npos;
  if (isText && IsCsv(bytes))
  {
    return ReadCsv(bytes, entries, error);
  }
  if (isText && IsItkSnapTable(bytes))
  {
    return ReadItkSnapTable(bytes, entries, error);
  }
  if (isText && IsFreeSurferTable(bytes))
  {
    return ReadFreeSurferTable(bytes, entries, error);
  }
  if (isText && IsNameList(bytes))
  {
    return ReadNameList(bytes, entries, error);
  }
  error = std::string(Trim(bytes).empty() ? "it is empty. " : "it is no known table of labels. ") +
    KnownTables + ".";
  return false;
}

} // namespace VolumeHaptics
