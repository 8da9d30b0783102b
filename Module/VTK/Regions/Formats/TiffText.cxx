// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/TiffText.h"

#include "VTK/Base/JsonText.h"
#include "VTK/Base/LengthUnit.h"

#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"
#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

std::size_t CountOr(const char* text, std::size_t other)
{
  const double number = ReadNumberOr(text, 0.0);
  return number >= 1.0 && number < 1e9 ? static_cast<std::size_t>(number) : other;
}

/** Parses ImageJ's description, which consists of lines `key=value`. */
TiffText ReadImageJ(const std::string& description)
{
  TiffText text;
  text.IsImageJ = true;
  text.Spacing[2] = 1.0; // the default, which ImageJ omits
  std::istringstream lines(description);
  std::size_t images = 1;
  std::string order = "CZT";
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t sign = std::min(line.find('='), line.size());
    const std::string key = line.substr(0, sign);
    const std::string value = line.substr(std::min(sign + 1, line.size()));
    if (key == "images")
    {
      images = CountOr(value.c_str(), 1);
    }
    else if (key == "slices")
    {
      text.Slices = CountOr(value.c_str(), 0);
    }
    else if (key == "channels")
    {
      text.Channels = CountOr(value.c_str(), 1);
    }
    else if (key == "frames")
    {
      text.Times = CountOr(value.c_str(), 1);
    }
    else if (key == "spacing")
    {
      const double spacing = std::abs(ReadNumberOr(value.c_str(), 0.0));
      text.Spacing[2] = spacing > 0.0 ? spacing : 1.0;
    }
    else if (key == "order" && value == "zct")
    {
      order = "ZCT";
    }
    else if (key == "cf")
    {
      text.IsCurved = ReadNumberOr(value.c_str(), 0.0) != 0.0; // 0: linear
    }
    else if (key == "c0" || key == "c1")
    {
      double& number = text.Line[key == "c1" ? 1 : 0];
      number = ReadNumberOr(value.c_str(), number);
    }
    else if (key == "unit")
    {
      text.PerUnit = MillimetresPerUnit(value);
    }
  }
  text.Spacing[2] *= text.PerUnit;
  text.Whole = images;
  if (text.Slices == 0)
  {
    text.Slices = std::max<std::size_t>(1, images / (text.Channels * text.Times));
  }
  text.SetOrder(order);
  return text;
}

/**
 * Reads the locations of the pages if OME-XML names other files than its own. The pages of an entry
 * are in the order of the axes.
 */
void ReadPlanes(vtkXMLDataElement* pixels, const std::string& file, TiffText& text)
{
  std::vector<std::pair<std::string, std::size_t>> planes(text.Slices * text.Channels * text.Times);
  bool areElsewhere = false;
  for (int i = 0; i < pixels->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* const data = pixels->GetNestedElement(i);
    vtkXMLDataElement* const id = data->FindNestedElementWithName("UUID");
    const char* const name = id ? id->GetAttribute("FileName") : nullptr;
    const auto numberOf = [data](const char* what, std::size_t other)
    { return data->GetAttribute(what) ? CountOr(data->GetAttribute(what), 0) : other; };
    if (std::string(data->GetName()) != "TiffData")
    {
      continue;
    }
    const std::size_t page = numberOf("IFD", 0);
    const std::size_t first = numberOf("FirstZ", 0) * text.SliceStep +
      numberOf("FirstC", 0) * text.ChannelStep + numberOf("FirstT", 0) * text.TimeStep;
    const std::size_t count = numberOf("PlaneCount", data->GetAttribute("IFD") ? 1 : planes.size());
    for (std::size_t k = 0; k < count && first + k < planes.size(); ++k)
    {
      planes[first + k] = { name ? name : file, page + k };
      areElsewhere = areElsewhere || planes[first + k].first != file;
    }
  }
  text.Planes = areElsewhere ? planes : text.Planes;
}

/** Parses OME-XML: the element Pixels of the first image. The default unit is the micrometre. */
TiffText ReadOme(const std::string& description, const std::string& file)
{
  TiffText text;
  const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
    vtkXMLUtilities::ReadElementFromString(description.c_str()));
  vtkXMLDataElement* const image = root ? root->FindNestedElementWithName("Image") : nullptr;
  vtkXMLDataElement* const pixels = image ? image->FindNestedElementWithName("Pixels") : nullptr;
  if (!pixels)
  {
    return text;
  }
  const char* const names[] = { "PhysicalSizeX", "PhysicalSizeY", "PhysicalSizeZ" };
  for (int a = 0; a < 3; ++a)
  {
    const char* const unit = pixels->GetAttribute((std::string(names[a]) + "Unit").c_str());
    text.Spacing[a] =
      ReadNumberOr(pixels->GetAttribute(names[a]), 0.0) * MillimetresPerUnit(unit ? unit : "um");
  }
  text.Slices = CountOr(pixels->GetAttribute("SizeZ"), 0);
  text.Channels = CountOr(pixels->GetAttribute("SizeC"), 1);
  text.Times = CountOr(pixels->GetAttribute("SizeT"), 1);
  const char* const order = pixels->GetAttribute("DimensionOrder");
  const std::string axes = order ? std::string(order).substr(0, 5) : std::string();
  text.SetOrder(axes.size() == 5 ? axes.substr(2) : "ZCT");
  for (int i = 0; i < pixels->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* const channel = pixels->GetNestedElement(i);
    if (std::string(channel->GetName()) == "Channel")
    {
      const char* const name = channel->GetAttribute("Name");
      text.ChannelNames.emplace_back(name ? name : "");
    }
  }
  constexpr double most = 1 << 20; // planes
  if (static_cast<double>(text.Slices) * static_cast<double>(text.Channels) *
      static_cast<double>(text.Times) <=
    most)
  {
    ReadPlanes(pixels, file, text);
  }
  return text;
}

/**
 * Parses the description of tifffile, which napari and scikit-image use: {"shape": [2, 40, 30, 20],
 * "axes": "TZYX"}. The axes may be missing.
 */
TiffText ReadShape(const std::string& description)
{
  TiffText text;
  Json::Value root;
  std::string error;
  if (!ParseJson(description, root, error) || !root.isObject() || !root["shape"].isArray())
  {
    return text;
  }
  std::vector<std::size_t> shape;
  for (const Json::Value& count : root["shape"])
  {
    constexpr unsigned most = 1U << 30;
    if (!count.isUInt() || count.asUInt() == 0 || count.asUInt() > most)
    {
      return text;
    }
    shape.push_back(count.asUInt());
  }
  constexpr std::size_t page = 2; // number of axes within a page
  if (shape.size() <= page)
  {
    return text; // a single page, which may be one of many files
  }
  shape.resize(shape.size() - page);
  std::string axes = root["axes"].isString() ? root["axes"].asString() : std::string();
  const bool areKnown = axes.size() == shape.size() + page && axes.find('Z') < shape.size() &&
    axes.substr(0, shape.size()).find_first_not_of("TCZ") == std::string::npos;
  if (!areKnown)
  {
    // Treat the last axis before the axes of a page as that of the slices.
    text.TimeName = "volume";
    axes = std::string(shape.size() - 1, 'T') + "Z";
  }
  double pages = 1.0;
  for (std::size_t a = 0; a < shape.size(); ++a)
  {
    (axes[a] == 'Z'      ? text.Slices
        : axes[a] == 'C' ? text.Channels
                         : text.Times) = axes[a] == 'T' ? text.Times * shape[a] : shape[a];
    pages *= static_cast<double>(shape[a]);
  }
  constexpr double mostPages = 1U << 30;
  if (pages > mostPages)
  {
    return {};
  }
  text.Whole = static_cast<std::size_t>(pages);
  const std::string leading = axes.substr(0, shape.size());
  text.SetOrder(areKnown ? std::string(leading.rbegin(), leading.rend()) : "ZT");
  return text;
}

} // namespace

double ReadNumberOr(const char* text, double other)
{
  double number = other;
  std::istringstream stream(text ? text : "");
  stream.imbue(std::locale::classic());
  return stream >> number ? number : other;
}

void TiffText::SetOrder(const std::string& order)
{
  std::size_t step = 1;
  for (const char axis : order)
  {
    (axis == 'C' ? this->ChannelStep : axis == 'T' ? this->TimeStep : this->SliceStep) = step;
    step *= axis == 'C' ? this->Channels : axis == 'T' ? this->Times : this->Slices;
  }
}

TiffText ReadTiffText(const std::string& description, const std::string& file)
{
  return description.rfind("ImageJ=", 0) == 0 ? ReadImageJ(description)
    : description.rfind("{\"shape\"", 0) == 0 ? ReadShape(description)
    : description.find("<OME") != std::string::npos
    ? ReadOme(description.substr(description.find('<')), file)
    : TiffText();
}

} // namespace VolumeHaptics
