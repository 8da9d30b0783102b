// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/HapticPresetFile.h"

#include "VTK/Base/FileReplacement.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Base/HapticSetupNode.h"
#include "VTK/Material/HapticPropertySettings.h"
#include "VTK/Material/HapticSetupMaterials.h"

#include "vtkHapticProperty.h"
#include "vtkNew.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr SetupFileKind PresetKind{ "VTK Volume Haptics preset", 1, "preset",
  "that vtkHapticProperty::WritePreset() wrote", "write the preset again" };
constexpr std::size_t LargestPreset = 1 << 20; // bytes; usually thousands

/**
 * Keys that presets omit, because a preset applies to any component, and to data stored in any way.
 */
constexpr const char* DataKeys[] = { "Component", "ScalarShift", "ScalarScale" };

void RemoveDataKeys(Json::Value& root)
{
  for (const char* const key : DataKeys)
  {
    root.removeMember(key);
  }
}

/** Parses a preset. Returns false, with the fault and the cure, if the text is not a preset. */
bool ParsePreset(const std::string& text, Json::Value& root, std::string& error)
{
  if (!ParseSetupFile(text, PresetKind, root, error))
  {
    return false;
  }
  const bool hasFunction = std::any_of(std::begin(PropertyFunctions), std::end(PropertyFunctions),
    [&root](const PropertyFunction& function) { return root.isMember(function.Name); });
  error = hasFunction ? std::string()
                      : "it has none of the functions of a preset, such as Stiffness. Write the "
                        "preset again.";
  return hasFunction;
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
  Json::Value root = NewSetupFile(PresetKind);
  SetupPass writing;
  writing.Writing = true;
  PassMaterials(SetupNode(writing, &root, {}), [property] { return property; });
  RemoveDataKeys(root);
  // Read the preset first: a preset that could not be read again must not replace a valid one.
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
  if (!ParsePreset(text, root, fault))
  {
    error = "The preset " + name + " can't be read: " + Printable(fault);
    return false;
  }
  RemoveDataKeys(root);
  SetupPass pass;
  // A new property has the defaults for whatever the file lacks.
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
  read->SetScalarShift(property->GetScalarShift());
  read->SetScalarScale(property->GetScalarScale());
  read->SetVisibilityFrom(property->GetVisibilityFrom());
  read->NoteProposal(property->GetProposedBoundaries(), property->GetProposedKernelRadius());
  property->DeepCopy(read);
  return true;
}

} // namespace VolumeHaptics
