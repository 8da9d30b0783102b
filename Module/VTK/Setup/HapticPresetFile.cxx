// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Setup/HapticPresetFile.h"

#include "VTK/Baking/HapticSettingLists.h"
#include "VTK/Files/FileReplacement.h"
#include "VTK/Files/HapticFiles.h"
#include "VTK/Files/JsonText.h"
#include "VTK/Setup/HapticSetupMaterials.h"

#include "vtkHapticProperty.h"
#include "vtkNew.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr const char* PresetFormat = "VTK Volume Haptics preset";
constexpr int PresetVersion = 1;               // written; this and earlier ones are read
constexpr std::size_t LargestPreset = 1 << 20; // bytes; usually thousands

/** A preset is for any component. */
constexpr const char* ComponentKey = "Component";

/** Empty, or why a text is no preset, and the cure. */
std::string FindFault(const Json::Value& root)
{
  if (!root.isObject() || !root["Format"].isString() || root["Format"].asString() != PresetFormat)
  {
    return std::string("it is not a preset, which has \"Format\": \"") + PresetFormat +
      "\". Choose a file that vtkHapticProperty::WritePreset() wrote.";
  }
  if (!root["Version"].isInt() || root["Version"].asInt() < 1)
  {
    return "its Version is not a whole number of 1 or more. Write the preset again.";
  }
  if (root["Version"].asInt() > PresetVersion)
  {
    return "its Version is " + std::to_string(root["Version"].asInt()) +
      ", which is newer than this software's " + std::to_string(PresetVersion) +
      ". Update VTK Volume Haptics.";
  }
  const bool hasFunction = std::any_of(std::begin(PropertyFunctions), std::end(PropertyFunctions),
    [&root](const PropertyFunction& function) { return root.isMember(function.Name); });
  return hasFunction ? std::string()
                     : "it has none of the functions of a preset, such as Stiffness. Write the "
                       "preset again.";
}

} // namespace

//------------------------------------------------------------------------------
bool IsPresetFile(const char* name)
{
  return name &&
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name)) == ".json";
}

//------------------------------------------------------------------------------
bool WritePresetFile(const std::string& file, vtkHapticProperty* property, std::string& error)
{
  if (file.empty())
  {
    error = "There is no file to write the preset to. Give WritePreset() the name of one.";
    return false;
  }
  const std::string name = Printable(file);
  Json::Value root(Json::objectValue);
  root["Format"] = PresetFormat;
  root["Version"] = PresetVersion;
  SetupPass writing;
  writing.Writing = true;
  PassMaterials(SetupNode(writing, &root, {}), [property] { return property; });
  root.removeMember(ComponentKey);
  // A preset that could not be read again must not replace one that can.
  SetupPass reading;
  PassMaterials(SetupNode(reading, &root, {}), [property] { return property; });
  if (!reading.Error.empty())
  {
    error = "The preset is not written to " + name + ": " + Printable(reading.Error) +
      " Correct this function first.";
    return false;
  }
  FileReplacement written;
  const bool isOpen = written.Open(file, error);
  if (isOpen)
  {
    written.Write(WriteJson(root));
  }
  if (!isOpen || !written.Commit(error))
  {
    error = "The preset can't be written to " + name + ": " + error;
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool ReadPresetFile(const std::string& file, vtkHapticProperty* property, std::string& error)
{
  if (file.empty())
  {
    error = "There is no file to read a preset from. Give ReadPreset() the name of one.";
    return false;
  }
  const std::string name = Printable(file);
  std::string text;
  if (!ReadSmallFile(file, LargestPreset, text, error))
  {
    error = "The preset " + name + " can't be read: it " + error +
      ". Choose a file that exists, was written by vtkHapticProperty::WritePreset() and may be "
      "read by you.";
    return false;
  }
  Json::Value root;
  std::string fault;
  if (ParseJson(text, root, fault))
  {
    fault = FindFault(root);
  }
  else
  {
    fault += " Correct it there, or write the preset again.";
  }
  if (!fault.empty())
  {
    error = "The preset " + name + " can't be read: " + Printable(fault);
    return false;
  }
  root.removeMember(ComponentKey);
  SetupPass pass;
  // A new property, so that what the file lacks gets its default.
  const vtkNew<vtkHapticProperty> read;
  PassMaterials(SetupNode(pass, &root, {}), [&read] { return read.Get(); });
  if (!pass.Error.empty())
  {
    error = "The preset " + name + " can't be read: " + Printable(pass.Error) +
      " Correct it, or write the preset again.";
    return false;
  }
  for (const auto& change : pass.Changes)
  {
    change();
  }
  read->SetComponent(property->GetComponent());
  read->SetVisibilityFrom(property->GetVisibilityFrom());
  read->NoteProposal(property->GetProposedBoundaries(), property->GetProposedKernelRadius());
  property->DeepCopy(read);
  return true;
}

} // namespace VolumeHaptics
