// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticSetup.h"

#include "Core/Model/HapticModel.h"
#include "Core/Platform/FileReplacement.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Baking/HapticPlacement.h"
#include "VTK/Base/HapticSetupNode.h"
#include "VTK/Filter/HapticFilterSettings.h"
#include "VTK/Material/HapticSetupMaterials.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Modes/HapticModeSettings.h"
#include "VTK/Tools/ToolKind.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkHapticGuideMode.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticMode.h"
#include "vtkHapticProperty.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <vector>

// Saves or loads a setting of an object, with VTK's name for it as the key.
#define PassNumberMacro(node, object, name, range)       \
  (node).Number(                                         \
    #name, range, [=] { return (object)->Get##name(); }, \
    [=](double number) { (object)->Set##name(number); })
// Saves or loads a setting of an object's component, with VTK's name for it as the key.
#define PassComponentMacro(node, object, component, name, range)  \
  (node).Number(                                                  \
    #name, range, [=] { return (object)->Get##name(component); }, \
    [=](double number) { (object)->Set##name(component, number); })

namespace VolumeHaptics
{
namespace
{

struct LabelNumber
{
  const char* Name;
  void (vtkHapticLabelTable::*Set)(int, double);
  double (vtkHapticLabelTable::*Get)(int); ///< getter; -1: not set
};

const LabelNumber LabelNumbers[] = {
  { "Stiffness", &vtkHapticLabelTable::SetStiffness, &vtkHapticLabelTable::GetStiffness },
  { "Friction", &vtkHapticLabelTable::SetFriction, &vtkHapticLabelTable::GetFriction },
  { "Viscosity", &vtkHapticLabelTable::SetViscosity, &vtkHapticLabelTable::GetViscosity },
  { "SurfaceStrength", &vtkHapticLabelTable::SetSurfaceStrength,
    &vtkHapticLabelTable::GetSurfaceStrength },
  { "ShaftFriction", &vtkHapticLabelTable::SetShaftFriction,
    &vtkHapticLabelTable::GetShaftFriction },
  { "SpecificEnergy", &vtkHapticLabelTable::SetSpecificEnergy,
    &vtkHapticLabelTable::GetSpecificEnergy },
};

/** Parses a label. Returns false unless the text equals std::to_string of the label. */
bool ReadLabel(const std::string& text, int& label)
{
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, label);
  return error == std::errc() && stop == end && std::to_string(label) == text;
}

/** Saves or loads the settings of a label. Settings without a value are not saved. */
void PassLabel(
  SetupNode row, int label, vtkHapticLabelTable* table, bool hasFelt, bool hasForbidden)
{
  row.Text(
    "Name", [=] { return table->GetLabelName(label); },
    [=](const std::string& name) { table->SetLabelName(label, name); });
  if (!row.IsWriting() || table->HasColor(label))
  {
    const NumberRow color = row.Row(
      "Color", 3,
      [=]
      {
        const double* const c = table->GetColor(label);
        return NumberRow(c, c + 3);
      },
      [=](const NumberRow& c) { table->SetColor(label, c.data()); });
    row.Require("Color",
      std::all_of(color.begin(), color.end(), [](double c) { return c >= 0.0 && c <= 1.0; }),
      "red, green and blue from 0 to 1");
  }
  for (const LabelNumber& number : LabelNumbers)
  {
    if (!row.IsWriting() || (table->*number.Get)(label) >= 0.0)
    {
      row.Number(
        number.Name, NotNegative(), [=, get = number.Get] { return (table->*get)(label); },
        [=, set = number.Set](double value) { (table->*set)(label, value); });
    }
  }
  if (!row.IsWriting() || hasFelt)
  {
    row.Flag(
      "Felt", [=] { return table->GetFelt(label); },
      [=](bool felt) { table->SetFelt(label, felt); });
  }
  if (!row.IsWriting() || hasForbidden)
  {
    row.Flag(
      "Forbidden", [=] { return table->GetForbidden(label); },
      [=](bool forbidden) { table->SetForbidden(label, forbidden); });
  }
}

void WriteTable(SetupNode node, vtkHapticLabelTable* table)
{
  // Read the flags from the field data, because only there -1 marks a flag that is not set.
  vtkNew<vtkFieldData> data;
  table->WriteFieldData(data);
  vtkDataArray* const felt = data->GetArray("LabelFelt");
  vtkDataArray* const forbidden = data->GetArray("LabelForbidden");
  for (vtkIdType i = 0; i < table->GetNumberOfLabels(); ++i)
  {
    const int label = table->GetLabel(i);
    PassLabel(node.Child(std::to_string(label)), label, table, felt && felt->GetTuple1(i) >= 0.0,
      forbidden && forbidden->GetTuple1(i) >= 0.0);
  }
}

void ReadTable(SetupNode node, vtkHapticLabelTable* table)
{
  for (const std::string& key : node.GetKeys())
  {
    int label = 0;
    node.Require(key.c_str(), ReadLabel(key, label),
      "called by its label, a whole number from " +
        std::to_string(std::numeric_limits<int>::min()) + " to " +
        std::to_string(std::numeric_limits<int>::max()));
    // Set the name to itself, which creates the entry if the table lacks it.
    node.Then([=] { table->SetLabelName(label, table->GetLabelName(label)); });
    PassLabel(node.Child(key), label, table, false, false);
  }
}

//------------------------------------------------------------------------------
/**
 * Saves or loads the entry Labels of the section Haptics: stand-off and labels of the filter's
 * table. Without a table, saves no entry. If the file has the entry, a filter without a table gets
 * one.
 */
void PassLabels(SetupNode& haptics, vtkVolumeHapticsFilter* filter)
{
  if (haptics.IsWriting() ? !filter->GetLabelTable() : !haptics.Has("Labels"))
  {
    return;
  }
  SetupNode node = haptics.Child("Labels");
  const vtkSmartPointer<vtkHapticLabelTable> table = haptics.IsWriting()
    ? vtkSmartPointer<vtkHapticLabelTable>(filter->GetLabelTable())
    : vtkSmartPointer<vtkHapticLabelTable>::New();
  node.Then([=] { table->DeepCopy(filter->GetLabelTable()); });
  node.Number(
    "StandOff", NotNegative(), [=] { return table->GetStandOff(); },
    [=](double distance) { table->SetStandOff(distance); });
  if (haptics.IsWriting())
  {
    WriteTable(node.Child("Table"), table);
  }
  else if (node.Has("Table"))
  {
    node.Then([=] { table->RemoveAllLabels(); });
    ReadTable(node.Child("Table"), table);
  }
  // Copy the whole table at once, because DeepCopy() does not modify a table that is already equal.
  node.Then(
    [=]
    {
      if (!filter->GetLabelTable())
      {
        filter->SetLabelTable(vtkNew<vtkHapticLabelTable>());
      }
      filter->GetLabelTable()->DeepCopy(table);
    });
}

using ModeRow = std::vector<vtkSmartPointer<vtkHapticMode>>;

/**
 * Saves the kind of a mode, as returned by `get`, or loads it. Returns the kind; -1 if the file has
 * none.
 */
int PassKind(SetupNode& node, const std::function<int()>& get)
{
  std::vector<const char*> names;
  for (const SettingChoice& kind : ModeSettingRows::KindNames)
  {
    names.push_back(kind.Name);
  }
  return node.Choice("Kind", names, get, [](int) {});
}

/** Returns whether a mode's kind uses a setting of vtkHapticMode. */
bool HasSetting(vtkHapticMode* mode, const std::string& name)
{
  const auto& own = GetModeKind(mode).Settings;
  return name == "Active" || name == "Axes" ||
    std::any_of(std::begin(own), std::end(own),
      [&name](const char* other) { return other && name == other; });
}

void PassMode(SetupNode& node, vtkHapticMode* mode)
{
  PassSettings(node, mode, ModeTexts);
  for (const ModeSetting& setting : ModeSettings)
  {
    if (HasSetting(mode, setting.Name))
    {
      PassSetting(node, mode, setting);
    }
  }
  if (auto* const guide = vtkHapticGuideMode::SafeDownCast(mode))
  {
    PassSettings(node, guide, GuideModeSettings);
  }
  const vtkSmartPointer<vtkHapticMode> kept = mode;
  for (const ModeFunction& function : GetModeFunctions(mode))
  {
    PassFunction(node.Child(function.Name), NotNegative(),
      [kept, strength = function.Function] { return strength; });
  }
}

void WriteModes(SetupNode& modes, vtkVolumeHapticsFilter* filter)
{
  for (int i = 0; i < filter->GetNumberOfModes(); ++i)
  {
    vtkHapticMode* const mode = filter->GetMode(i);
    SetupNode node = modes.Child(std::to_string(i));
    PassKind(node, [mode] { return mode->GetKind(); });
    PassMode(node, mode);
  }
}

/**
 * Saves or loads the entry Modes of the section Haptics. Without modes, saves no entry. An entry in
 * a file replaces the filter's modes. Paths, surfaces and distance fields of guides are data, which
 * setups do not contain; a guide keeps them if it stays at its place in the list.
 */
void PassModes(SetupNode& haptics, vtkVolumeHapticsFilter* filter)
{
  if (haptics.IsWriting() ? filter->GetNumberOfModes() == 0 : !haptics.Has("Modes"))
  {
    return;
  }
  SetupNode modes = haptics.Child("Modes");
  if (haptics.IsWriting())
  {
    WriteModes(modes, filter);
    return;
  }
  const auto read = std::make_shared<ModeRow>();
  for (const std::string& key : modes.GetKeys())
  {
    modes.Require(key.c_str(), key == std::to_string(read->size()),
      "called by its number, from 0 on without gaps");
    SetupNode node = modes.Child(key);
    const int kind = PassKind(node, [] { return 0; });
    modes.Require(key.c_str(), kind >= 0, "an object with the Kind of a mode");
    if (kind < 0)
    {
      return;
    }
    if (kind == vtkHapticMode::GUIDE)
    {
      read->push_back(vtkSmartPointer<vtkHapticGuideMode>::New());
    }
    else
    {
      read->push_back(vtkSmartPointer<vtkHapticMode>::New());
      read->back()->SetKind(kind);
    }
    auto* const before =
      vtkHapticGuideMode::SafeDownCast(filter->GetMode(static_cast<int>(read->size()) - 1));
    auto* const guide = vtkHapticGuideMode::SafeDownCast(read->back());
    if (before && guide)
    {
      guide->SetPath(before->GetPath());
      guide->SetSurface(before->GetSurface());
      guide->SetDistanceField(before->GetDistanceField());
    }
    PassMode(node, read->back());
  }
  haptics.Then(
    [=]
    {
      filter->RemoveAllModes();
      for (vtkHapticMode* const mode : *read)
      {
        filter->AddMode(mode);
      }
    });
}

/**
 * Saves or loads the entry Tool of the section Haptics: Kind, settings and functions. Without a
 * tool, saves no entry. An entry in a file replaces the filter's tool.
 */
void PassTool(SetupNode& haptics, vtkVolumeHapticsFilter* filter)
{
  if (haptics.IsWriting() ? !filter->GetTool() : !haptics.Has("Tool"))
  {
    return;
  }
  SetupNode node = haptics.Child("Tool");
  const std::vector<const ToolKind*>& kinds = GetToolKinds();
  std::vector<const char*> names;
  for (const ToolKind* const kind : kinds)
  {
    names.push_back(kind->Name);
  }
  vtkSmartPointer<vtkHapticTool> tool = filter->GetTool();
  const auto place = [&kinds, &tool]
  {
    const auto found = std::find(kinds.begin(), kinds.end(), FindToolKind(tool));
    return static_cast<int>(found - kinds.begin());
  };
  const int read = node.Choice("Kind", names, place, [](int) {});
  if (!haptics.IsWriting())
  {
    haptics.Require("Tool", read >= 0, "an object with the Kind of a tool");
    if (read < 0)
    {
      return;
    }
    const ToolKind& kind = *kinds[static_cast<std::size_t>(read)];
    tool = kind.Make();
    kind.TakeOver(tool, filter->GetTool());
  }
  const ToolKind& kind = *FindToolKind(tool);
  kind.Pass(node, tool);
  for (const ToolFunction& function : kind.GetFunctions())
  {
    PassFunction(
      node.Child(function.Name), NotNegative(), [tool, get = function.Get] { return get(tool); });
  }
  haptics.Then([=] { filter->SetTool(tool); });
}

void PassProperty(SetupNode& node, vtkVolumeHapticsFilter* filter, vtkVolumeProperty* visible)
{
  PassMaterials(node, [filter] { return filter->GetProperty(); });
  // Do not save a visibility from another volume property, which this setup could not restore.
  if (!node.IsWriting() || !filter->GetProperty()->GetVisibilityFrom() ||
    filter->GetProperty()->GetVisibilityFrom() == visible)
  {
    node.Flag(
      "HideInvisible", [=] { return filter->GetProperty()->GetVisibilityFrom() != nullptr; },
      [=](bool hide)
      {
        vtkHapticProperty* const property = filter->GetProperty();
        vtkVolumeProperty* const now = property->GetVisibilityFrom();
        if (visible && (hide || now == visible))
        {
          property->SetVisibilityFrom(hide ? visible : nullptr);
        }
      });
  }
}

/**
 * Sets a camera's view up vector to exactly the numbers in a file. These are already normalised,
 * but vtkCamera would normalise them again, which changes the last digit of most unit vectors.
 */
struct CameraAccess : vtkCamera
{
  static void SetViewUp(vtkCamera* camera, const NumberRow& wanted)
  {
    constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
    camera->SetViewUp(wanted.data());
    double(vtkCamera::*const up)[3] = &CameraAccess::ViewUp;
    if (std::equal(wanted.begin(), wanted.end(), camera->*up,
          [](double a, double b) { return std::abs(a - b) <= rounding; }))
    {
      std::copy(wanted.begin(), wanted.end(), camera->*up);
      camera->Modified();
      (camera->*(&CameraAccess::ComputeViewTransform))();
    }
  }
};

NumberRow ToRow(const double x[3])
{
  return { x[0], x[1], x[2] };
}

//------------------------------------------------------------------------------
/**
 * Saves or loads the section Haptics. `visible` is the volume property that the visibility may come
 * from; may be null.
 */
void PassHaptics(SetupNode node, vtkVolumeHapticsFilter* filter, vtkVolumeProperty* visible)
{
  if (!node.IsWriting() && node.Has("ContactAlignment") && !node.Has("MaterialPlacement"))
  {
    // A complete setup without the key MaterialPlacement is older than that setting.
    node.Then([=] { filter->SetMaterialPlacementToKernel(); });
  }
  PassSettings(node, filter, FilterSettings);
  PassSettings(node, filter, FilterTexts);
  PassProperty(node, filter, visible);
  PassModes(node, filter);
  PassTool(node, filter);
  PassLabels(node, filter);
}

//------------------------------------------------------------------------------
void PassVolume(SetupNode node, vtkVolumeProperty* property)
{
  node.Choice(
    "InterpolationType", { "Nearest", "Linear" }, [=] { return property->GetInterpolationType(); },
    [=](int type) { property->SetInterpolationType(type); });
  node.Flag(
    "IndependentComponents", [=] { return property->GetIndependentComponents() != 0; },
    [=](bool on) { property->SetIndependentComponents(on); });
  for (int c = 0; c < VTK_MAX_VRCOMP; ++c)
  {
    SetupNode part = node.Child("Component" + std::to_string(c));
    PassFunction(
      part.Child("ScalarOpacity"), AnyNumber(), [=] { return property->GetScalarOpacity(c); });
    part.Flag(
      "DisableGradientOpacity", [=] { return property->GetDisableGradientOpacity(c) != 0; },
      [=](bool on) { property->SetDisableGradientOpacity(c, on); });
    // Use the stored function: while gradient opacity is disabled, the normal getter returns
    // another one.
    PassFunction(part.Child("GradientOpacity"), AnyNumber(),
      [=]
      {
        if (!property->GetStoredGradientOpacity(c))
        {
          const int disabled = property->GetDisableGradientOpacity(c);
          property->SetDisableGradientOpacity(c, 0);
          property->GetGradientOpacity(c); // creates the function if it is missing
          property->SetDisableGradientOpacity(c, disabled);
        }
        return property->GetStoredGradientOpacity(c);
      });
    if (part.IsWriting() ? property->GetColorChannels(c) == 1 : part.Has("Gray"))
    {
      PassFunction(
        part.Child("Gray"), AnyNumber(), [=] { return property->GetGrayTransferFunction(c); });
      part.Then([=] { property->SetColor(c, property->GetGrayTransferFunction(c)); });
    }
    else if (part.IsWriting() || part.Has("Color"))
    {
      PassColors(part.Child("Color"), [=] { return property->GetRGBTransferFunction(c); });
      part.Then([=] { property->SetColor(c, property->GetRGBTransferFunction(c)); });
    }
    PassComponentMacro(
      part, property, c, ScalarOpacityUnitDistance, (NumberRange{ 1e-300, 1e300 }));
    part.Flag(
      "Shade", [=] { return property->GetShade(c) != 0; },
      [=](bool on) { property->SetShade(c, on); });
    PassComponentMacro(part, property, c, Ambient, AnyNumber());
    PassComponentMacro(part, property, c, Diffuse, AnyNumber());
    PassComponentMacro(part, property, c, Specular, AnyNumber());
    PassComponentMacro(part, property, c, SpecularPower, AnyNumber());
  }
}

//------------------------------------------------------------------------------
void PassCamera(SetupNode node, vtkCamera* camera)
{
  NumberRow position = node.Row(
    "Position", 3, [=] { return ToRow(camera->GetPosition()); },
    [=](const NumberRow& x) { camera->SetPosition(x.data()); });
  NumberRow focus = node.Row(
    "FocalPoint", 3, [=] { return ToRow(camera->GetFocalPoint()); },
    [=](const NumberRow& x) { camera->SetFocalPoint(x.data()); });
  position = position.empty() ? ToRow(camera->GetPosition()) : position;
  focus = focus.empty() ? ToRow(camera->GetFocalPoint()) : focus;
  node.Require("Position", position != focus, "another place than FocalPoint");
  node.Require("FocalPoint", position != focus, "another place than Position");
  const NumberRow up = node.Row(
    "ViewUp", 3, [=] { return ToRow(camera->GetViewUp()); },
    [=](const NumberRow& x) { CameraAccess::SetViewUp(camera, x); });
  node.Require("ViewUp", up != NumberRow(3, 0.0), "a direction, with a number other than 0");
  PassNumberMacro(node, camera, ViewAngle, (NumberRange{ 1e-8, 179.9 }));
  node.Flag(
    "ParallelProjection", [=] { return camera->GetParallelProjection() != 0; },
    [=](bool on) { camera->SetParallelProjection(on); });
  PassNumberMacro(node, camera, ParallelScale, (NumberRange{ 1e-300, 1e300 }));
}

//------------------------------------------------------------------------------
/** Saves or loads the entry DeviceToWorld in the root. */
void PassDeviceToWorld(SetupNode& root, vtkMatrix4x4* matrix)
{
  constexpr std::size_t size = 16;
  const NumberRow read = root.Row(
    "DeviceToWorld", size, [=] { return NumberRow(matrix->GetData(), matrix->GetData() + size); },
    [=](const NumberRow& elements) { matrix->DeepCopy(elements.data()); });
  if (!read.empty())
  {
    vtkNew<vtkMatrix4x4> checked;
    checked->DeepCopy(read.data());
    Affine3 map;
    std::string error;
    root.Require("DeviceToWorld", ReadSimilarity(checked, map, error),
      "a rotation, a translation and one uniform, positive scale, row by row");
  }
}

} // namespace
} // namespace VolumeHaptics

vtkStandardNewMacro(vtkHapticSetup);

namespace
{

using namespace VolumeHaptics;

constexpr SetupFileKind SetupKind{ "VTK Volume Haptics setup", 1, "setup",
  "that vtkHapticSetup saved", "save the setup again" };
constexpr std::size_t LargestSetup = 16 << 20; // bytes; without labels, a setup has a few thousand

/** Saves or loads the contents of a setup in one pass. */
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
  constexpr std::size_t leastBytes = 24; // smallest number of bytes per label in the file
  if (labels && leastBytes * static_cast<std::size_t>(labels->GetNumberOfLabels()) > LargestSetup)
  {
    vtkErrorMacro(<< DescribeTooLarge(file));
    return false;
  }
  Json::Value root = NewSetupFile(SetupKind);
  SetupPass writing;
  writing.Writing = true;
  PassSetup(this, writing, root);
  // Check that the setup can be loaded again, before it replaces a valid file.
  SetupPass reading;
  PassSetup(this, reading, root);
  if (!reading.Error.empty())
  {
    vtkErrorMacro("The setup is not saved to "
      << Printable(file) << ": " << Printable(reading.Error) << " Correct this setting first.");
    return false;
  }
  const std::string text = WriteJson(root);
  if (text.size() > LargestSetup)
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
  if (!ReadSmallFile(file, LargestSetup, text, error))
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
