// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/XmlLabels.h"

#include "VTK/Material/Labels/LabelText.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace
{

using namespace VolumeHaptics;

/** Collects the elements "Label". */
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

  std::optional<int> Label; ///< label of the open element
  std::string Name;
  std::string Ignored;
};
vtkStandardNewMacro(LabelXmlParser);

} // namespace

namespace VolumeHaptics
{

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

} // namespace VolumeHaptics
