// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticSetup.h"

#include "VTK/Files/FileReplacement.h"
#include "VTK/Files/HapticFiles.h"
#include "VTK/Files/JsonText.h"
#include "VTK/Setup/HapticSetupSettings.h"

#include "vtkCamera.h"
#include "vtkHapticLabelTable.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeProperty.h"

#include <string>

vtkStandardNewMacro(vtkHapticSetup);

namespace
{

using namespace VolumeHaptics;

constexpr const char* Format = "VTK Volume Haptics setup";
constexpr std::size_t LargestFile = 16 << 20; // bytes; without labels, thousands
constexpr int Version = 1;                    // written by Save; Load reads this and earlier ones

/** One pass over everything that a setup has. */
void PassSetup(vtkHapticSetup* setup, SetupPass& pass, Json::Value& root)
{
  SetupNode node(pass, &root, {});
  if (setup->GetVolumeHaptics())
  {
    PassHaptics(node.Child("Haptics"), setup->GetVolumeHaptics(), setup->GetVolumeProperty());
  }
  if (setup->GetVolumeProperty())
  {
    PassVolume(node.Child("Volume"), setup->GetVolumeProperty());
  }
  if (setup->GetCamera())
  {
    PassCamera(node.Child("Camera"), setup->GetCamera());
  }
  if (setup->GetDeviceToWorld())
  {
    PassDeviceToWorld(node, setup->GetDeviceToWorld());
  }
}

std::string DescribeTooLarge(const char* file)
{
  return "The setup is not saved to " + Printable(file) +
    ": it would be larger than 16 MiB, and could not be loaded again. Save the many labels with "
    "vtkHapticLabelTable::WriteFile(), and the setup without them in the filter.";
}

/** Parses the text as JSON; false, with an error, if it is not. */
bool Parse(const std::string& text, Json::Value& root, std::string& error)
{
  if (!ParseJson(text, root, error))
  {
    error += " Correct it there, or save the setup again.";
    return false;
  }
  if (!root.isObject() || !root["Format"].isString() || root["Format"].asString() != Format)
  {
    error = std::string("it is not a setup, which has \"Format\": \"") + Format +
      "\". Choose a file that vtkHapticSetup saved.";
    return false;
  }
  if (!root["Version"].isInt() || root["Version"].asInt() < 1)
  {
    error = "its Version is not a whole number of 1 or more. Save the setup again.";
    return false;
  }
  if (root["Version"].asInt() > Version)
  {
    error = "its Version is " + std::to_string(root["Version"].asInt()) +
      ", which is newer than this software's " + std::to_string(Version) +
      ". Update VTK Volume Haptics.";
    return false;
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
#define vtkHapticSetupObjectMacro(name, type)  \
  void vtkHapticSetup::Set##name(type* object) \
  {                                            \
    if (this->name != object)                  \
    {                                          \
      this->name = object;                     \
      this->Modified();                        \
    }                                          \
  }                                            \
  type* vtkHapticSetup::Get##name()            \
  {                                            \
    return this->name;                         \
  }

vtkHapticSetupObjectMacro(VolumeHaptics, vtkVolumeHapticsFilter);
vtkHapticSetupObjectMacro(VolumeProperty, vtkVolumeProperty);
vtkHapticSetupObjectMacro(Camera, vtkCamera);
vtkHapticSetupObjectMacro(DeviceToWorld, vtkMatrix4x4);

//------------------------------------------------------------------------------
vtkHapticSetup::vtkHapticSetup() = default;
vtkHapticSetup::~vtkHapticSetup() = default;

//------------------------------------------------------------------------------
bool vtkHapticSetup::Save(const char* file)
{
  if (!file || !*file)
  {
    vtkErrorMacro("There is no file to save the setup to. Give Save the name of one.");
    return false;
  }
  vtkHapticLabelTable* const labels =
    this->VolumeHaptics ? this->VolumeHaptics->GetLabelTable() : nullptr;
  constexpr std::size_t leastBytes = 24; // of a label in the file
  if (labels && leastBytes * static_cast<std::size_t>(labels->GetNumberOfLabels()) > LargestFile)
  {
    vtkErrorMacro(<< DescribeTooLarge(file));
    return false;
  }
  Json::Value root(Json::objectValue);
  root["Format"] = Format;
  root["Version"] = Version;
  SetupPass writing;
  writing.Writing = true;
  PassSetup(this, writing, root);
  // A setup that could not be loaded again must not replace one that can.
  SetupPass reading;
  PassSetup(this, reading, root);
  if (!reading.Error.empty())
  {
    vtkErrorMacro("The setup is not saved to "
      << Printable(file) << ": " << Printable(reading.Error) << " Correct this setting first.");
    return false;
  }
  const std::string text = WriteJson(root);
  if (text.size() > LargestFile)
  {
    vtkErrorMacro(<< DescribeTooLarge(file));
    return false;
  }
  std::string error;
  FileReplacement written;
  const bool isOpen = written.Open(file, error);
  if (isOpen)
  {
    written.Write(text);
  }
  if (!isOpen || !written.Commit(error))
  {
    vtkErrorMacro("The setup can't be written to " << Printable(file) << ": " << error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticSetup::Load(const char* file)
{
  if (!file || !*file)
  {
    vtkErrorMacro("There is no file to load a setup from. Give Load the name of one.");
    return false;
  }
  const std::string name = Printable(file);
  std::string text;
  std::string error;
  if (!ReadSmallFile(file, LargestFile, text, error))
  {
    vtkErrorMacro("The setup "
      << name << " can't be read: it " << error
      << ". Choose a file that exists, was saved by vtkHapticSetup and may be read by you.");
    return false;
  }
  Json::Value root;
  if (!Parse(text, root, error))
  {
    vtkErrorMacro("The setup " << name << " can't be loaded: " << Printable(error));
    return false;
  }
  SetupPass pass;
  PassSetup(this, pass, root);
  if (!pass.Error.empty())
  {
    vtkErrorMacro("The setup " << name << " can't be loaded: " << Printable(pass.Error)
                               << " Correct it, or remove this key to leave the setting as it is.");
    return false;
  }
  for (const auto& change : pass.Changes)
  {
    change();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticSetup::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VolumeHaptics: " << this->VolumeHaptics.Get() << "\n";
  os << indent << "VolumeProperty: " << this->VolumeProperty.Get() << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "DeviceToWorld: " << this->DeviceToWorld.Get() << "\n";
}
