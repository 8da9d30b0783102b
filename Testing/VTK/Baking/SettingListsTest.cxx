// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The public headers, ParaView's XML and the core say the same as the lists of settings.
 */

#include "VTK/Baking/HapticSettingLists.h"
#include "VTK/Session/HapticDeviceSettings.h"
#include "VTK/Trace/HapticPathSettings.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkVolumeHapticsFilter.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

using namespace VolumeHaptics;

namespace
{
const std::string Root = VolumeHaptics_SOURCE_DIR;

/// A slider goes from one end of a range to the other: of no use for ranges that are larger.
constexpr double LongestSlider = 1000.0;

/// The words of a text, with one space between them.
std::string Words(const std::string& text)
{
  std::istringstream stream(text);
  std::string words;
  for (std::string word; stream >> word;)
  {
    words += (words.empty() ? "" : " ") + word;
  }
  return words;
}

/// The letters of a text, alike for "Local surface", LOCAL_SURFACE and LocalSurface.
std::string Letters(const std::string& text)
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

bool BeginsWith(const std::string& text, const std::string& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

/// The comment before the setter of a setting.
std::string HeaderComment(const std::string& header, const std::string& name)
{
  std::ifstream file(Root + "/Module/VTK/" + header + ".h");
  const std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  std::size_t setter = std::string::npos;
  for (const std::string& start : { "vtkSetMacro(" + name + ",", "vtkSetClampMacro(" + name + ",",
         "vtkSetVector3Macro(" + name + ",", "void Set" + name + "(" })
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

/// The filter or the device as ParaView has it: the first proxy of a file.
class ParaViewProxy
{
public:
  explicit ParaViewProxy(const char* file)
    : Tree(vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(
        (Root + "/Plugin/VolumeHapticsPlugin/" + file).c_str())))
  {
  }

  /// A property of a name; null if there is none.
  vtkXMLDataElement* Find(const std::string& name) const
  {
    vtkXMLDataElement* const proxy = this->Tree->GetNestedElement(0)->GetNestedElement(0);
    for (int i = 0; i < proxy->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* const element = proxy->GetNestedElement(i);
      const char* const attribute = element->GetAttribute("name");
      if (attribute && attribute == name)
      {
        return element;
      }
    }
    return nullptr;
  }

  static std::string Documentation(vtkXMLDataElement* property)
  {
    vtkXMLDataElement* const text = property->FindNestedElementWithName("Documentation");
    return text ? Words(text->GetCharacterData()) : std::string();
  }

  static double Number(vtkXMLDataElement* element, const char* attribute)
  {
    const char* const text = element->GetAttribute(attribute);
    return text ? std::stod(text) : std::nan("");
  }

private:
  vtkSmartPointer<vtkXMLDataElement> Tree;
};

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
  if (setting.Kind != SettingKind::Flag && setting.Minimum > -LargestNumber)
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

void ExpectRange(vtkXMLDataElement* property, const SettingFacts& setting)
{
  vtkXMLDataElement* const integers = property->FindNestedElementWithName("IntRangeDomain");
  vtkXMLDataElement* const numbers = property->FindNestedElementWithName("DoubleRangeDomain");
  vtkXMLDataElement* const range = integers ? integers : numbers;
  if (!range)
  {
    EXPECT_NE(property->FindNestedElementWithName("ArrayRangeDomain"), nullptr);
    return;
  }
  EXPECT_EQ(integers != nullptr, setting.Kind == SettingKind::Integer);
  const double minimum = ParaViewProxy::Number(range, "min");
  const double maximum = ParaViewProxy::Number(range, "max");
  EXPECT_EQ(std::isnan(minimum) ? -LargestNumber : minimum, setting.Minimum);
  if (setting.Maximum <= LongestSlider || !std::isnan(maximum))
  {
    EXPECT_EQ(maximum, setting.Maximum);
  }
}

void ExpectChoices(vtkXMLDataElement* property, const SettingFacts& setting)
{
  vtkXMLDataElement* const list = property->FindNestedElementWithName("EnumerationDomain");
  ASSERT_NE(list, nullptr);
  ASSERT_EQ(list->GetNumberOfNestedElements(), setting.Maximum + 1.0);
  for (int i = 0; i < list->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* const entry = list->GetNestedElement(i);
    EXPECT_EQ(ParaViewProxy::Number(entry, "value"), i);
    EXPECT_STREQ(entry->GetAttribute("text"), setting.Choices[i].Text);
  }
}

void ExpectProperty(vtkXMLDataElement* property, const SettingFacts& setting)
{
  ASSERT_NE(property, nullptr);
  EXPECT_EQ(property->GetName(),
    std::string(
      setting.Kind == SettingKind::Number ? "DoubleVectorProperty" : "IntVectorProperty"));
  EXPECT_EQ(ParaViewProxy::Number(property, "default_values"), setting.Default);
  if (setting.Kind == SettingKind::Choice)
  {
    ExpectChoices(property, setting);
  }
  else if (setting.Kind == SettingKind::Flag)
  {
    EXPECT_NE(property->FindNestedElementWithName("BooleanDomain"), nullptr);
  }
  else
  {
    ExpectRange(property, setting);
  }
}

template <typename Owner>
void ExpectVector(vtkXMLDataElement* property, const HapticVectorSetting<Owner>& setting)
{
  ASSERT_NE(property, nullptr);
  EXPECT_STREQ(property->GetName(), "DoubleVectorProperty");
  EXPECT_EQ(ParaViewProxy::Number(property, "number_of_elements"), setting.Size);
  double numbers[LongestVector] = {};
  ASSERT_EQ(property->GetVectorAttribute("default_values", LongestVector, numbers), setting.Size);
  EXPECT_TRUE(std::equal(numbers, numbers + setting.Size, setting.Default.begin()));
  vtkXMLDataElement* const range = property->FindNestedElementWithName("DoubleRangeDomain");
  ASSERT_NE(range, nullptr);
  const double minimum = ParaViewProxy::Number(range, "min");
  const double maximum = ParaViewProxy::Number(range, "max");
  EXPECT_EQ(std::isnan(minimum) ? -LargestNumber : minimum, setting.Minimum);
  EXPECT_EQ(std::isnan(maximum) ? LargestNumber : maximum, setting.Maximum);
}
} // namespace

TEST(SettingLists, HeadersHaveTheDefaultsAndKeepTheRanges)
{
  for (const FilterSetting& setting : FilterSettings)
  {
    SCOPED_TRACE(setting.Name);
    vtkNew<vtkVolumeHapticsFilter> filter;
    ExpectHeaderBehaves<vtkVolumeHapticsAlgorithm>(filter, setting);
  }
  for (const PropertySetting& setting : PropertySettings)
  {
    SCOPED_TRACE(setting.Name);
    vtkNew<vtkHapticProperty> property;
    ExpectHeaderBehaves<vtkHapticProperty>(property, setting);
  }
  for (const DeviceSetting& setting : DeviceSettings)
  {
    SCOPED_TRACE(setting.Name);
    vtkNew<vtkHapticDevice> device;
    ExpectHeaderBehaves<vtkHapticDevice>(device, setting);
  }
  for (const HardwareSetting& setting : HardwareSettings)
  {
    SCOPED_TRACE(setting.Name);
    vtkNew<vtkHapticDevice> device;
    ExpectHeaderBehaves<vtkHapticHardware>(device, setting);
  }
  for (const StateSourceSetting& setting : StateSourceSettings)
  {
    SCOPED_TRACE(setting.Name);
    vtkNew<vtkHapticStateSource> source;
    ExpectHeaderBehaves<vtkHapticStateSource>(source, setting);
  }
  for (const HardwareVector& setting : HardwareVectors)
  {
    SCOPED_TRACE(setting.Name);
    vtkNew<vtkHapticDevice> device;
    ExpectHeaderBehaves<vtkHapticHardware>(device, setting);
    SettingVector large{};
    std::fill_n(large.begin(), setting.Size, 2.0 * setting.Maximum);
    setting.Set(device, large);
    EXPECT_EQ(setting.Get(device)[0], setting.Maximum);
    EXPECT_EQ(setting.Get(device)[setting.Size - 1], setting.Maximum);
  }
  for (const PathSetting& setting : PathSettings)
  {
    vtkNew<vtkHapticPathSource> source;
    EXPECT_EQ(setting.Get(source), setting.Default) << setting.Name;
  }
  for (const PathVector& setting : PathVectors)
  {
    SCOPED_TRACE(setting.Name);
    vtkNew<vtkHapticPathSource> source;
    ExpectHeaderBehaves<vtkHapticPathSource>(source, setting);
  }
}

TEST(SettingLists, EveryMacroOfTheHeadersHasARow)
{
  const auto names = [](const auto&... lists)
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
  };
  std::vector<std::string> path = names(PathSettings, PathVectors);
  path.emplace_back("FileName"); // which is text
  for (const auto& [header, rows] :
    { std::pair{ "vtkVolumeHapticsAlgorithm", names(FilterSettings) },
      std::pair{ "vtkHapticProperty", names(PropertySettings) },
      std::pair{ "vtkHapticStateSource", names(StateSourceSettings) },
      std::pair{ "vtkHapticPathSource", path } })
  {
    std::ifstream file(Root + "/Module/VTK/" + header + ".h");
    std::vector<std::string> found;
    for (std::string line; std::getline(file, line);)
    {
      const std::size_t start = line.find("  vtkSet");
      const std::size_t open = line.find("Macro(");
      if (start == 0 && open != std::string::npos)
      {
        found.push_back(line.substr(open + 6, line.find(',') - open - 6));
      }
    }
    std::vector<std::string> sorted = rows;
    std::sort(sorted.begin(), sorted.end());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, sorted) << header;
  }
}

TEST(SettingLists, CommentsOfTheHeadersBeginWithTheDocumentation)
{
  const auto expect = [](const std::string& header, const auto& settings)
  {
    for (const auto& setting : settings)
    {
      const std::string comment = HeaderComment(header, setting.Name);
      EXPECT_TRUE(BeginsWith(Letters(comment), Letters(setting.Documentation)))
        << setting.Name << ":" << comment;
    }
  };
  expect("vtkVolumeHapticsAlgorithm", FilterSettings);
  expect("vtkHapticProperty", PropertySettings);
  expect("vtkHapticProperty", PropertyFunctions);
  expect("vtkHapticDevice", DeviceSettings);
  expect("vtkHapticHardware", HardwareSettings);
  expect("vtkHapticHardware", HardwareVectors);
  expect("vtkHapticStateSource", StateSourceSettings);
  expect("vtkHapticPathSource", PathSettings);
  expect("vtkHapticPathSource", PathVectors);
}

TEST(SettingLists, ParaViewHasTheSameSettings)
{
  const ParaViewProxy paraview("VolumeHapticsFilter.xml");
  for (const FilterSetting& setting : FilterSettings)
  {
    SCOPED_TRACE(setting.Name);
    vtkXMLDataElement* const property = paraview.Find(setting.Name);
    ExpectProperty(property, setting);
    EXPECT_EQ(property->GetAttribute("command"), std::string("Set") + setting.Name);
    EXPECT_EQ(ParaViewProxy::Documentation(property), setting.Documentation);
  }
  // A preset and the scales of the functions are ParaView's own: it adds what they mean here.
  for (const PropertySetting& setting : PropertySettings)
  {
    SCOPED_TRACE(setting.Name);
    vtkXMLDataElement* const property = paraview.Find(setting.Name);
    ExpectProperty(property, setting);
    EXPECT_EQ(property->GetAttribute("command"), std::string("Set") + setting.Name);
    EXPECT_PRED2(BeginsWith, ParaViewProxy::Documentation(property), setting.Documentation);
  }
  for (const PropertyFunction& function : PropertyFunctions)
  {
    SCOPED_TRACE(function.Name);
    vtkXMLDataElement* const property = paraview.Find(function.Name);
    ASSERT_NE(property, nullptr);
    EXPECT_PRED2(BeginsWith, ParaViewProxy::Documentation(property), function.Documentation);
    vtkXMLDataElement* const scale = paraview.Find(function.Name + std::string("Scale"));
    vtkXMLDataElement* const domain = property->FindNestedElementWithName("HapticFunctionDomain");
    ASSERT_NE(domain, nullptr);
    EXPECT_EQ(ParaViewProxy::Number(domain, "initial") *
        (scale ? ParaViewProxy::Number(scale, "default_values") : 1.0),
      function.Default);
  }
}

TEST(SettingLists, ParaViewHasTheSameDevice)
{
  const ParaViewProxy paraview("HapticDevice.xml");
  const auto expect = [&](const auto& settings)
  {
    for (const auto& setting : settings)
    {
      SCOPED_TRACE(setting.Name);
      if (vtkXMLDataElement* const property = paraview.Find(setting.Name))
      {
        ExpectProperty(property, setting);
        EXPECT_PRED2(BeginsWith, ParaViewProxy::Documentation(property), setting.Documentation);
      }
      else // ParaView calls the device all the time
      {
        EXPECT_STREQ(setting.Name, "AttentionTime");
      }
    }
  };
  expect(DeviceSettings);
  expect(HardwareSettings);
  expect(StateSourceSettings);
  for (const HardwareVector& setting : HardwareVectors)
  {
    SCOPED_TRACE(setting.Name);
    vtkXMLDataElement* const property = paraview.Find(setting.Name);
    ExpectVector(property, setting);
    EXPECT_PRED2(BeginsWith, ParaViewProxy::Documentation(property), setting.Documentation);
  }
}

TEST(SettingLists, ParaViewHasTheSamePath)
{
  const ParaViewProxy paraview("HapticPath.xml");
  for (const PathSetting& setting : PathSettings)
  {
    SCOPED_TRACE(setting.Name);
    vtkXMLDataElement* const property = paraview.Find(setting.Name);
    ExpectProperty(property, setting);
    EXPECT_EQ(property->GetAttribute("command"), std::string("Set") + setting.Name);
    EXPECT_EQ(ParaViewProxy::Documentation(property), setting.Documentation);
  }
  for (const PathVector& setting : PathVectors)
  {
    SCOPED_TRACE(setting.Name);
    vtkXMLDataElement* const property = paraview.Find(setting.Name);
    ExpectVector(property, setting);
    EXPECT_EQ(property->GetAttribute("command"), std::string("Set") + setting.Name);
    EXPECT_EQ(ParaViewProxy::Documentation(property), setting.Documentation);
  }
}

TEST(SettingLists, TheCoreHasTheSameDefaults)
{
  const HapticModelDescription standard;
  for (const PropertyFunction& function : PropertyFunctions)
  {
    EXPECT_EQ((standard.Material.*function.Baked).front().Y, function.Default) << function.Name;
  }
  vtkNew<vtkVolumeHapticsFilter> filter;
  for (const FilterSetting& setting : FilterSettings)
  {
    const std::string name = setting.Name;
    // The core's own 0 pushes nowhere; its radius is more than 0, which stands for half a voxel.
    if (setting.Bake && name != "ForceFieldGain" && name != "ProxyRadius")
    {
      HapticModelDescription baked;
      setting.Bake(filter, baked);
      EXPECT_TRUE(setting.IsSame(standard, baked)) << name;
    }
  }
}

TEST(SettingLists, AModelOfAnotherSettingIsAnother)
{
  for (const FilterSetting& setting : FilterSettings)
  {
    if (setting.Bake)
    {
      vtkNew<vtkVolumeHapticsFilter> filter;
      HapticModelDescription before;
      HapticModelDescription after;
      setting.Bake(filter, before);
      setting.Set(filter, setting.Default == setting.Minimum ? 1.0 : setting.Minimum);
      setting.Bake(filter, after);
      EXPECT_FALSE(setting.IsSame(before, after)) << setting.Name;
    }
  }
}
