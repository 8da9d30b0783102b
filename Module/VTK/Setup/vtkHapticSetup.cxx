// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticSetup.h"

#include "VTK/Base/FileReplacement.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Base/SetupFile.h"
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

constexpr SetupFileKind SetupKind{ "VTK Volume Haptics setup", 1, "setup",
  "that vtkHapticSetup saved", "save the setup again" };
constexpr std::size_t LargestFile = 16 << 20; // bytes; a setup without labels has thousands

/** Passes once over everything that a setup holds. */
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
  constexpr std::size_t leastBytes = 24; // smallest size of a label in the file
  if (labels && leastBytes * static_cast<std::size_t>(labels->GetNumberOfLabels()) > LargestFile)
  {
    vtkErrorMacro(<< DescribeTooLarge(file));
    return false;
  }
  Json::Value root = NewSetupFile(SetupKind);
  SetupPass writing;
  writing.Writing = true;
  PassSetup(this, writing, root);
  // A setup that could not be loaded again must not replace a valid one.
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
  if (!ParseSetupFile(text, SetupKind, root, error))
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
