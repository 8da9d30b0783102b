// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The public headers, ParaView's XML and the core say the same as the lists of settings.
 */

#include "Rigs/SettingChecks.h"
#include "VTK/Device/HapticDeviceSettings.h"
#include "VTK/Filter/HapticFilterSettings.h"
#include "VTK/Material/HapticPropertySettings.h"
#include "VTK/Modes/HapticModeSettings.h"
#include "VTK/Regions/HapticRegionSettings.h"
#include "VTK/Tools/HapticToolSettings.h"
#include "VTK/Trace/Paths/HapticPathSettings.h"

#include <vtkHapticShearMode.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkVolumeHapticsFilter.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string>

using namespace settingtest;
using namespace VolumeHaptics;

namespace
{
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
  ExpectHeadersBehave<vtkVolumeHapticsFilter>(FilterSettings);
  ExpectHeadersBehave<vtkHapticProperty>(PropertySettings);
  ExpectHeadersBehave<vtkHapticDevice>(DeviceSettings);
  ExpectHeadersBehave<vtkHapticDevice>(HardwareSettings);
  ExpectHeadersBehave<vtkHapticDevice>(HardwareVectors);
  ExpectHeadersBehave<vtkHapticCalibration>(CalibrationSettings);
  ExpectHeadersBehave<vtkHapticStateSource>(StateSourceSettings);
  ExpectHeadersBehave<vtkHapticRegionPlanner>(PlannerSettings);
  ExpectHeadersBehave<vtkHapticRegionPlanner>(PlannerVectors);
  ExpectHeadersBehave<vtkHapticRegionFilter>(RegionFilterVectors);
  ExpectHeadersBehave<vtkHapticRegionSource>(RegionSourceSettings);
  ExpectHeadersBehave<vtkHapticRegionSource>(RegionSourceVectors);
  ExpectHeadersBehave<vtkHapticPathSource>(PathVectors);
  ExpectHeadersBehave<vtkHapticShearMode>(ModeSettings);
  ExpectHeadersBehave<vtkHapticVectorFrontMode>(FrontModeSettings);
  ExpectHeadersBehave<vtkHapticRidgeMode>(RidgeModeSettings);
  ExpectHeadersBehave<vtkHapticGuideMode>(GuideModeSettings);
  ExpectHeadersBehave<vtkHapticNeedle>(NeedleSettings);
  ExpectHeadersBehave<vtkHapticPointShell>(ShapedToolSettings);
  ExpectHeadersBehave<vtkHapticPointShell>(PointShellSettings);
  ShapedToolSetting ofBurr[std::size(ShapedToolSettings)];
  std::copy(std::begin(ShapedToolSettings), std::end(ShapedToolSettings), ofBurr);
  ASSERT_STREQ(ofBurr[0].Name, "ContactArea");
  ofBurr[0].Default = BurrContactArea;
  ExpectHeadersBehave<vtkHapticBurr>(ofBurr);
  ExpectHeadersBehave<vtkHapticBurr>(HapticBurrSettings);
  for (const HardwareVector& setting : HardwareVectors)
  {
    SCOPED_TRACE(setting.Name);
    vtkNew<vtkHapticDevice> device;
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
}

TEST(SettingLists, TextsHaveTheirDefaultsAndAreChecked)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  for (const FilterText& setting : FilterTexts)
  {
    EXPECT_EQ(setting.Get(filter), setting.Default) << setting.Name;
    EXPECT_EQ(setting.Check(setting.Default), "") << setting.Name;
    const bool isAnyName = std::string("DisplacementArrayName") == setting.Name;
    EXPECT_EQ(setting.Check("no such text").empty(), isAnyName) << setting.Name;
  }
}

TEST(SettingLists, EveryMacroOfTheHeadersHasARow)
{
  ExpectRows("vtkVolumeHapticsAlgorithm", Names(FilterSettings));
  ExpectRows("vtkHapticProperty", Names(PropertySettings));
  ExpectRows("vtkHapticHardware", Names(HardwareSettings));
  ExpectRows("vtkHapticCalibration", Names(CalibrationSettings));
  ExpectRows("vtkHapticStateSource", Names(StateSourceSettings));
  ExpectRows("vtkHapticRegionFilter", Names(RegionFilterVectors));
  std::vector<std::string> planner = Names(PlannerSettings, PlannerVectors);
  planner.erase(std::find(planner.begin(), planner.end(), "Direction")); // without macro
  ExpectRows("vtkHapticRegionPlanner", planner);
  std::vector<std::string> source = Names(RegionSourceSettings, RegionSourceVectors);
  source.erase(std::find(source.begin(), source.end(), "Direction")); // without macro
  source.emplace_back("FileName");                                    // a text
  ExpectRows("vtkHapticRegionSource", source);
  std::vector<std::string> path = Names(PathSettings, PathVectors);
  path.emplace_back("FileName"); // a text
  ExpectRows("vtkHapticPathSource", path);
  ExpectRows("vtkHapticMode", Names(ModeSettings));
  ExpectRows("vtkHapticVectorFrontMode", Names(FrontModeSettings));
  ExpectRows("vtkHapticRidgeMode", Names(RidgeModeSettings));
  ExpectRows("vtkHapticGuideMode", Names(GuideModeSettings));
  ExpectRows("vtkHapticNeedle", Names(NeedleSettings));
  ExpectRows("vtkHapticShapedTool", Names(ShapedToolSettings));
  ExpectRows("vtkHapticPointShell", Names(PointShellSettings));
  ExpectRows("vtkHapticBurr", Names(HapticBurrSettings));
}

TEST(SettingLists, CommentsOfTheHeadersBeginWithTheDocumentation)
{
  ExpectComments("vtkVolumeHapticsAlgorithm", FilterSettings);
  ExpectComments("vtkVolumeHapticsAlgorithm", FilterTexts);
  ExpectComments("vtkHapticProperty", PropertySettings);
  ExpectComments("vtkHapticProperty", PropertyFunctions);
  ExpectComments("vtkHapticDevice", DeviceSettings);
  ExpectComments("vtkHapticHardware", HardwareSettings);
  ExpectComments("vtkHapticHardware", HardwareVectors);
  ExpectComments("vtkHapticStateSource", StateSourceSettings);
  ExpectComments("vtkHapticPathSource", PathSettings);
  ExpectComments("vtkHapticPathSource", PathVectors);
  ExpectComments("vtkHapticCalibration", CalibrationSettings);
  ExpectComments("vtkHapticRegionPlanner", PlannerSettings);
  ExpectComments("vtkHapticRegionPlanner", PlannerVectors);
  ExpectComments("vtkHapticRegionFilter", RegionFilterVectors);
  ExpectComments("vtkHapticRegionSource", RegionSourceSettings);
  ExpectComments("vtkHapticRegionSource", RegionSourceVectors);
  ExpectComments("vtkHapticMode", ModeSettings);
  ExpectComments("vtkHapticMode", ModeTexts);
  ExpectComments("vtkHapticVectorFrontMode", FrontModeSettings);
  ExpectComments("vtkHapticRidgeMode", RidgeModeSettings);
  ExpectComments("vtkHapticGuideMode", GuideModeSettings);
  ExpectComments("vtkHapticNeedle", NeedleSettings);
  ExpectComments("vtkHapticShapedTool", ShapedToolSettings);
  ExpectComments("vtkHapticPointShell", PointShellSettings);
  ExpectComments("vtkHapticBurr", HapticBurrSettings);
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
  for (const FilterText& setting : FilterTexts)
  {
    SCOPED_TRACE(setting.Name);
    vtkXMLDataElement* const property = paraview.Find(setting.Name);
    ASSERT_NE(property, nullptr);
    EXPECT_STREQ(property->GetName(), "StringVectorProperty");
    // VTK's parser has no empty attributes.
    const char* const standard = property->GetAttribute("default_values");
    EXPECT_STREQ(standard ? standard : "", setting.Default);
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
      else // ParaView calls the device all the time, and has no tools
      {
        const std::string name = setting.Name;
        EXPECT_TRUE(name == "AttentionTime" || name == "MaximumTorque") << name;
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

TEST(SettingLists, ParaViewHasTheSameMaximumOfVoxels)
{
  const auto row = std::find_if(std::begin(PlannerSettings), std::end(PlannerSettings),
    [](const PlannerSetting& setting) { return setting.Name == std::string("MaximumVoxels"); });
  ASSERT_NE(row, std::end(PlannerSettings));
  const ParaViewProxy paraview("HapticDevice.xml");
  vtkXMLDataElement* const property = paraview.Find("MaximumRegionVoxels");
  ASSERT_NE(property, nullptr);
  EXPECT_EQ(ParaViewProxy::Number(property, "default_values"), row->Default);
  vtkXMLDataElement* const range = property->FindNestedElementWithName("IntRangeDomain");
  ASSERT_NE(range, nullptr);
  EXPECT_EQ(ParaViewProxy::Number(range, "min"), row->Minimum);
  EXPECT_EQ(ParaViewProxy::Number(range, "max"), row->Maximum);
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
