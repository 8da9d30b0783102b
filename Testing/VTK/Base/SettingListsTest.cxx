// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the public headers, ParaView's XML and the core have the same settings as
 * Module/VTK/Settings.json.
 */

#include "Rigs/SettingChecks.h"
#include "VTK/Device/HapticDeviceSettings.h"
#include "VTK/Filter/HapticFilterSettings.h"
#include "VTK/Material/HapticPropertySettings.h"
#include "VTK/Modes/HapticModeSettings.h"
#include "VTK/Regions/HapticRegionSettings.h"
#include "VTK/Regions/RegionPlanner.h"
#include "VTK/Tools/HapticToolSettings.h"
#include "VTK/Trace/Paths/HapticPathSettings.h"

#include <vtkHapticMode.h>
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
#include <vector>

using namespace settingtest;
using namespace VolumeHaptics;

namespace
{
/// Returns the words of a text with single spaces between them.
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

/// The first proxy in an XML file that CMake has generated: the filter, the device or the path in
/// ParaView.
class ParaViewProxy
{
public:
  explicit ParaViewProxy(const char* file)
    : Tree(vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(
        (std::string(VolumeHaptics_SETTINGS_XML "/") + file).c_str())))
  {
  }

  /// Returns the property with this name, or null if there is none.
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

  /// Expects that ParaView offers all settings of a list, except the `needless` ones.
  template <typename Settings>
  void ExpectAll(const Settings& settings, const std::vector<std::string>& needless = {}) const
  {
    for (const auto& setting : settings)
    {
      SCOPED_TRACE(setting.Name);
      vtkXMLDataElement* const property = this->Find(setting.Name);
      const auto name = std::find(needless.begin(), needless.end(), setting.Name);
      ASSERT_EQ(property == nullptr, name != needless.end());
      if (property)
      {
        EXPECT_PRED2(BeginsWith, Documentation(property), setting.Documentation);
      }
    }
  }

private:
  vtkSmartPointer<vtkXMLDataElement> Tree;
};
} // namespace

TEST(SettingLists, HeadersHaveTheDefaultsAndKeepTheRanges)
{
  ExpectHeadersBehave<vtkVolumeHapticsFilter>(FilterSettings);
  ExpectHeadersBehave<vtkHapticProperty>(PropertySettings);
  ExpectHeadersBehave<vtkHapticDevice>(DeviceSettings);
  ExpectHeadersBehave<vtkHapticDevice>(DeviceVectors);
  ExpectHeadersBehave<vtkHapticRegionFilter>(RegionFilterVectors);
  ExpectHeadersBehave<vtkHapticRegionSource>(RegionSourceSettings);
  ExpectHeadersBehave<vtkHapticRegionSource>(RegionSourceVectors);
  ExpectHeadersBehave<vtkHapticPathSource>(PathVectors);
  ExpectHeadersBehave<vtkHapticMode>(ModeSettings);
  ExpectHeadersBehave<vtkHapticGuideMode>(GuideModeSettings);
  ExpectHeadersBehave<vtkHapticNeedle>(NeedleSettings);
  ExpectHeadersBehave<vtkHapticPointShell>(ShapedToolSettings);
  ExpectHeadersBehave<vtkHapticPointShell>(PointShellSettings);
  ShapedToolSetting ofBurr[std::size(ShapedToolSettings)];
  std::copy(std::begin(ShapedToolSettings), std::end(ShapedToolSettings), ofBurr);
  ASSERT_STREQ(ofBurr[0].Name, "ContactArea");
  ofBurr[0].Default = 0.1;
  ExpectHeadersBehave<vtkHapticBurr>(ofBurr);
  ExpectHeadersBehave<vtkHapticBurr>(HapticBurrSettings);
  for (const DeviceVector& setting : DeviceVectors)
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
  ExpectRows("vtkVolumeHapticsFilter", Names(FilterSettings));
  ExpectRows("vtkHapticProperty", Names(PropertySettings));
  std::vector<std::string> device = Names(DeviceSettings);
  for (const char* const sent : // settings without a macro, since they are sent to the servo
    { "ServoRate", "MaximumForce", "MaximumForceRate", "StiffnessGain", "TransientGain",
      "MaximumTorque", "AttentionTime", "UseTool" })
  {
    device.erase(std::find(device.begin(), device.end(), sent));
  }
  ExpectRows("vtkHapticDevice", device);
  ExpectRows("vtkHapticRegionFilter", Names(RegionFilterVectors));
  std::vector<std::string> source = Names(RegionSourceSettings, RegionSourceVectors);
  source.erase(std::find(source.begin(), source.end(), "Direction")); // has no macro
  source.emplace_back("FileName");                                    // a text
  ExpectRows("vtkHapticRegionSource", source);
  std::vector<std::string> path = Names(PathSettings, PathVectors);
  path.emplace_back("FileName"); // a text
  ExpectRows("vtkHapticPathSource", path);
  std::vector<std::string> mode = Names(ModeSettings);
  mode.erase(std::find(mode.begin(), mode.end(), "Kind")); // has no macro
  ExpectRows("vtkHapticMode", mode);
  ExpectRows("vtkHapticGuideMode", Names(GuideModeSettings));
  ExpectRows("vtkHapticNeedle", Names(NeedleSettings));
  ExpectRows("vtkHapticShapedTool", Names(ShapedToolSettings));
  ExpectRows("vtkHapticPointShell", Names(PointShellSettings));
  ExpectRows("vtkHapticBurr", Names(HapticBurrSettings));
}

TEST(SettingLists, CommentsOfTheHeadersBeginWithTheDocumentation)
{
  ExpectComments("vtkVolumeHapticsFilter", FilterSettings);
  ExpectComments("vtkVolumeHapticsFilter", FilterTexts);
  ExpectComments("vtkHapticProperty", PropertySettings);
  ExpectComments("vtkHapticProperty", PropertyFunctions);
  ExpectComments("vtkHapticDevice", DeviceSettings);
  ExpectComments("vtkHapticDevice", DeviceVectors);
  ExpectComments("vtkHapticPathSource", PathSettings);
  ExpectComments("vtkHapticPathSource", PathVectors);
  ExpectComments("vtkHapticRegionFilter", RegionFilterVectors);
  ExpectComments("vtkHapticRegionSource", RegionSourceSettings);
  ExpectComments("vtkHapticRegionSource", RegionSourceVectors);
  ExpectComments("vtkHapticMode", ModeSettings);
  ExpectComments("vtkHapticMode", ModeTexts);
  ExpectComments("vtkHapticGuideMode", GuideModeSettings);
  ExpectComments("vtkHapticNeedle", NeedleSettings);
  ExpectComments("vtkHapticShapedTool", ShapedToolSettings);
  ExpectComments("vtkHapticPointShell", PointShellSettings);
  ExpectComments("vtkHapticBurr", HapticBurrSettings);
}

TEST(SettingLists, ParaViewHasAllSettings)
{
  const ParaViewProxy filter("VolumeHapticsFilter.xml");
  filter.ExpectAll(FilterSettings);
  filter.ExpectAll(FilterTexts);
  filter.ExpectAll(PropertySettings);
  filter.ExpectAll(PropertyFunctions);
  for (const PropertyFunction& function : PropertyFunctions)
  {
    SCOPED_TRACE(function.Name);
    vtkXMLDataElement* const property = filter.Find(function.Name);
    vtkXMLDataElement* const scale = filter.Find(function.Name + std::string("Scale"));
    vtkXMLDataElement* const domain = property->FindNestedElementWithName("HapticFunctionDomain");
    ASSERT_NE(domain, nullptr);
    EXPECT_EQ(ParaViewProxy::Number(domain, "initial") *
        (scale ? ParaViewProxy::Number(scale, "default_values") : 1.0),
      function.Default);
  }
  const ParaViewProxy device("HapticDevice.xml");
  // ParaView does not offer MaximumTorque.
  device.ExpectAll(DeviceSettings, { "MaximumTorque" });
  device.ExpectAll(DeviceVectors);
  const ParaViewProxy path("HapticPath.xml");
  path.ExpectAll(PathSettings);
  path.ExpectAll(PathVectors);
}

TEST(SettingLists, ParaViewsPropertiesAreOfTheirTypes)
{
  const auto expect = [](const char* file, const std::string& name, const std::string& attributes,
                        const std::string& domain)
  {
    SCOPED_TRACE(name);
    const ParaViewProxy proxy(file);
    vtkXMLDataElement* const property = proxy.Find(name);
    ASSERT_NE(property, nullptr);
    std::ostringstream found;
    found << property->GetName();
    for (const char* const attribute : { "command", "number_of_elements", "default_values" })
    {
      const char* const text = property->GetAttribute(attribute);
      found << " " << (text ? text : "none");
    }
    EXPECT_EQ(found.str(), attributes);
    std::ostringstream inside;
    property->GetNestedElement(0)->PrintXML(inside, vtkIndent());
    EXPECT_EQ(Words(inside.str()), domain);
  };
  expect("VolumeHapticsFilter.xml", "KernelRadius", "IntVectorProperty SetKernelRadius 1 2",
    "<IntRangeDomain name=\"range\" min=\"1\" max=\"16\"/>");
  expect("VolumeHapticsFilter.xml", "ReleaseTime", "DoubleVectorProperty SetReleaseTime 1 0.005",
    "<DoubleRangeDomain name=\"range\" min=\"0\" max=\"1\"/>");
  expect("VolumeHapticsFilter.xml", "ServoRate", "DoubleVectorProperty SetServoRate 1 1000",
    "<DoubleRangeDomain name=\"range\" min=\"1\"/>"); // without a maximum, ParaView shows no slider
  expect("VolumeHapticsFilter.xml", "SameShape", "IntVectorProperty SetSameShape 1 0",
    "<BooleanDomain name=\"bool\"/>");
  expect("VolumeHapticsFilter.xml", "Solver", "IntVectorProperty SetSolver 1 1",
    "<EnumerationDomain name=\"enum\"> <Entry value=\"0\" text=\"Paper\"/> "
    "<Entry value=\"1\" text=\"Precise\"/> </EnumerationDomain>");
  expect("HapticPath.xml", "Normal", "DoubleVectorProperty SetNormal 3 0 0 1",
    "<DoubleRangeDomain name=\"range\"/>");
  expect("HapticDevice.xml", "ForceScale", "DoubleVectorProperty SetForceScale 1 0.1",
    "<DoubleRangeDomain name=\"range\" min=\"1e-9\"/>");
  expect("HapticDevice.xml", "ShowCommandedForce", "IntVectorProperty SetShowCommandedForce 1 0",
    "<BooleanDomain name=\"bool\"/>");
  expect("HapticDevice.xml", "HomingTime", "DoubleVectorProperty none 1 120",
    "<DoubleRangeDomain name=\"range\" min=\"1\"/>");
}

TEST(SettingLists, ParaViewHasTheSameMaximumOfVoxels)
{
  RegionPlanner planner;
  const ParaViewProxy paraview("HapticDevice.xml");
  vtkXMLDataElement* const property = paraview.Find("MaximumRegionVoxels");
  ASSERT_NE(property, nullptr);
  EXPECT_EQ(ParaViewProxy::Number(property, "default_values"), planner.GetMaximumVoxels());
  vtkXMLDataElement* const range = property->FindNestedElementWithName("IntRangeDomain");
  ASSERT_NE(range, nullptr);
  planner.SetMaximumVoxels(0);
  EXPECT_EQ(ParaViewProxy::Number(range, "min"), planner.GetMaximumVoxels());
  planner.SetMaximumVoxels(VTK_ID_MAX);
  EXPECT_EQ(ParaViewProxy::Number(range, "max"), planner.GetMaximumVoxels());
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
    // Two defaults of the core differ: its gain is 0, which results in no force, and its proxy
    // radius is positive. In the filter, a radius of 0 stands for half a voxel.
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
