// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/HapticPresets.h"

#include "Core/Platform/FileReplacement.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/HapticNoise.h"
#include "VTK/Base/HapticSetupNode.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/OutsideFiller.h"
#include "VTK/Material/HapticPropertySettings.h"
#include "VTK/Material/HapticSetupMaterials.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * A range of values, Low to High, with the material of a tissue. Between tissues, the material
 * changes linearly.
 */
struct Tissue
{
  const char* Name;
  double Low;
  double High;
  double Stiffness; // N/m
  double Friction;
  double Viscosity;       // N
  double SurfaceStrength; // N
  double DragLow = 1e9;   ///< value from which the tissue has its drag, if that is below Low
};

/**
 * Start of the drag of fat: noise reaches 50 HU below its values, and would be felt as grains on a
 * ramp of the drag.
 */
constexpr double FatDragLow = -200.0; // HU

struct Preset
{
  const char* Name;
  std::vector<Tissue> Tissues;
  /**
   * Gradient magnitude (per mm) at which a surface begins to be felt. In a preset that is fitted to
   * an image it is per voxel, because the edges of such images are a certain number of voxels wide,
   * whatever the spacing.
   */
  double DistinctnessStart;
  double DistinctnessFull; ///< gradient magnitude at which a surface is fully felt; 0: derive the
                           ///< distinctness from the noise
  int Side;
  bool IsOfLabels = false;
  bool IsOfImage = false; ///< whether to derive what is solid from the image
  /** Median of the values above the first tissue, for values without a unit; otherwise 0. */
  double Body = 0.0;
};

/** Strength (N) above the largest force of any device. */
constexpr double Impenetrable = 1e6;
/** Strength (N) above the force with which a hand pushes a desktop device. */
constexpr double Solid = 12.0;

/**
 * Stiffness (N/m) of every tissue; most desktop devices can render it. A change of stiffness would
 * be felt as relief, and as a step of the force where V(x_s) moves from one tissue to another. Air
 * has this stiffness, too: on a ramp that begins at 0, noise would combine a stiffness near 0 with
 * a drag, which would leave the proxy far behind.
 */
constexpr double K = 400.0;

/**
 * Multiple of the background's brightness where the background of magnitude images ends. Its noise
 * has Rayleigh's distribution (Gudbjartsson and Patz, Magnetic Resonance in Medicine 34, 1995,
 * 910-914), in which only one value in 3e8 exceeds 5 times the mean. Faint ghosts of the body are
 * below this multiple, too.
 */
constexpr double NoiseEnd = 5.0;

const std::vector<Preset>& Presets()
{
  // Strengths never fall as the value rises. Their ramps are tens of HU wide, because noise and the
  // slope of a blurred edge change V(x_s) by that much. Only friction, which changes the force by a
  // few percent, falls, and rises again for fluid. Soft tissues share one drag, because inside a
  // tissue only the drag is felt, and a few HU of noise on a ramp between two drags would feel like
  // grains. The lung has one drag, too, and no walls of its own: its noise and its emphysema reach
  // the values of air, and a drag above 0.05 N, whose loss can be felt, would come and go with
  // them. Distinctness starts at 16 HU/mm: 3.4 standard deviations of the gradient are 8 HU/mm for
  // 20 HU of white noise, 1 mm voxels and the default kernel, and twice as much where the noise of
  // neighbours is correlated, as in CT. Noise is therefore not felt as surfaces.
  static const std::vector<Preset> presets = {
    { "CT contrast",
      {
        { "air", -1024, -955, K, 0.00, 0.00, 0.0 },
        { "lung", -900, -300, K, 0.10, 0.04, 0.0 },
        { "fat", -150, -80, K, 0.18, 0.30, 1.0, FatDragLow },
        { "fluid", -10, 10, K, 0.12, 0.30, 1.5 },
        { "muscle, organ", 50, 80, K, 0.30, 0.30, 2.2 },
        { "contrast medium, cartilage", 150, 250, K, 0.25, 0.30, 3.2 },
        { "bone", 350, 3071, K, 0.30, 0.00, Solid },
      },
      16, 48, vtkHapticProperty::HIGHER },
    // A hand meets fat only from outside, under skin, so fat has the stiffness of both together.
    // The half-filled voxels of the skin have it, too, and so do voxels of skin, fat and muscle
    // with the values of fluid; their friction is that of skin, for a finger that slides off a
    // slope. Just under the skin of a head CT the values reach 37 HU. The stiffness of organs
    // therefore begins above that, and at 37 HU a finger that slides off a slope still feels 0.1 N.
    // Air and lung, which hold nothing, have the stiffness of an organ, so that springs begin
    // without slack. Skin holds from -400 HU on, with one stiffness along its edge: a blanket, a
    // foam and the thin vessels of a lung have at most -450 HU, and hold nothing.
    { "CT physical",
      {
        { "air", -1024, -955, 28, 0.00, 0.00, 0.00 },
        { "lung", -950, -700, 28, 0.46, 0.01, 0.00 },
        { "cloth, foam", -500, -450, 53, 0.46, 0.02, 0.00 },
        { "edge of skin", -410, -400, 53, 0.46, 0.02, 0.00 },
        { "skin, fat under skin", -200, -30, 53, 0.46, 0.02, 0.30 },
        { "fluid", -10, 15, 53, 0.46, 0.02, 0.30 },
        { "skin, brain", 20, 27, 53, 0.46, 0.02, 0.30 },
        { "muscle, organ", 47, 80, 28, 0.46, 0.03, 0.40 },
        { "cartilage", 100, 300, 200, 0.30, 0.03, 1.50 },
        { "bone", 310, 3071, 1000, 0.32, 0.00, Impenetrable },
      },
      20, 52, vtkHapticProperty::HIGHER }, // higher than elsewhere, because its low drag hides less
                                           // noise
    // Vessels with contrast medium have the values of spongy bone, so bone starts at the values of
    // cortical bone.
    { "CT angiography",
      {
        { "air", -1024, -955, K, 0.00, 0.00, 0.0 },
        { "lung", -900, -300, K, 0.10, 0.04, 0.0 },
        { "fat", -150, -80, K, 0.18, 0.30, 1.0, FatDragLow },
        { "muscle, organ", 30, 100, K, 0.30, 0.30, 2.0 },
        { "vessel, spongy bone", 180, 450, K, 0.05, 0.30, 3.2 },
        { "bone", 650, 3071, K, 0.30, 0.00, Solid },
      },
      16, 48, vtkHapticProperty::HIGHER },
    // The lung has one drag from emphysema to vessels, and no walls. Fluid is left out, because the
    // noise of a chest hides its edges.
    { "CT chest",
      {
        { "air", -1024, -985, K, 0.00, 0.00, 0.0 },
        { "lung", -960, -300, K, 0.10, 0.04, 0.0 },
        { "fat", -150, -80, K, 0.18, 0.30, 1.2, FatDragLow },
        { "muscle, organ, blood", 20, 80, K, 0.30, 0.30, 2.2 },
        { "contrast medium, spongy bone", 140, 220, K, 0.25, 0.30, 3.2 },
        { "bone", 350, 3071, K, 0.30, 0.00, Solid },
      },
      16, 48, vtkHapticProperty::HIGHER },
    // Surfaces are felt from both sides here. Two surfaces of opposite sides (scalp and skull) are
    // often only a few voxels apart. Distinctness therefore rises slowly, so that the change from
    // one surface to the other is gradual.
    { "MRI",
      {
        { "background", 0, 12, K, 0.00, 0.00, 0.0 },
        { "fluid", 30, 50, K, 0.05, 0.30, 0.8 },
        { "grey matter, muscle", 80, 95, K, 0.20, 0.30, 1.4 },
        { "white matter", 115, 135, K, 0.35, 0.30, 2.0 },
        { "fat", 175, 255, K, 0.15, 0.20, 2.6 },
      },
      3, 70, vtkHapticProperty::BOTH, false, false, 90.0 },
    // One hard material for any unit. Its surfaces are where the gradient exceeds the noise and
    // rises towards anything but background.
    { "Micro-CT", { { "solid", 0, 0, K, 0.30, 0.00, Solid } }, 0, 0, vtkHapticProperty::HIGHER,
      false, true },
    // All labels except 0 have one material, because a label's number does not reveal its tissue.
    { "Labels",
      {
        { "no label", 0, 0.25, K, 0.00, 0.00, 0.0 },
        { "any label", 0.75, 1, K, 0.25, 0.20, 3.0 },
      },
      0, 0, vtkHapticProperty::BOTH, true },
  };
  return presets;
}

/** Returns whether the values of a preset are in Hounsfield units. */
bool IsOfCT(const std::string& name)
{
  return name.compare(0, 3, "CT ") == 0;
}

void Empty(vtkPiecewiseFunction* function)
{
  function->RemoveAllPoints();
  function->ClampingOn();
  function->UseLogScaleOff();
}

void Fill(
  vtkPiecewiseFunction* function, const Preset& preset, double Tissue::*quantity, double scale)
{
  Empty(function);
  const bool isDrag = quantity == &Tissue::Viscosity;
  for (const Tissue& tissue : preset.Tissues)
  {
    const double low = isDrag ? std::min(tissue.Low, tissue.DragLow) : tissue.Low;
    function->AddPoint(scale * low, tissue.*quantity);
    function->AddPoint(
      scale * tissue.High, tissue.*quantity); // adds the same point twice if Low equals High
  }
}

} // namespace

bool ComputePresetScale(const char* name, vtkImageData* image, vtkHapticProperty* property,
  PresetScale& scale, std::string& error)
{
  scale = {};
  const int component = property->GetComponent();
  const auto preset = std::find_if(Presets().begin(), Presets().end(),
    [&](const Preset& one) { return name && std::string(name) == one.Name; });
  if (preset == Presets().end() || !(preset->Body > 0.0))
  {
    return true;
  }
  vtkDataArray* const scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars)
  {
    error = std::string("The preset \"") + preset->Name +
      "\" can't be fitted to the image, which " +
      (image ? "has no active point scalars: choose an array with "
               "GetPointData()->SetActiveScalars(name), or turn cell data into point data with "
               "vtkCellDataToPointData."
             : "is missing: pass a vtkImageData, or call ApplyPreset(name).");
    return false;
  }
  const vtkSmartPointer<vtkDataArray> filled =
    CopyFilled(DetectOutside(image, scalars, component), scalars, component);
  HapticVolume volume;
  if (!ReadVolume(image, filled, component, 1, volume, error))
  {
    return false;
  }
  const BackgroundLevel level = volume.Whole.IsThere
    ? volume.Whole.Solid
    : EstimateSolid(image, filled, volume.View, component);
  const auto valueOf = [property](double scalar)
  { return (scalar + property->GetScalarShift()) * property->GetScalarScale(); };
  const double brightness = valueOf(level.Bright) / preset->Body;
  if (level.IsThere && brightness > 0.0)
  {
    const double noise = NoiseEnd * valueOf(level.Dark);
    // Ignore the noise of a background that is nearly as bright as the body.
    scale.Values = noise < brightness * preset->Tissues[1].Low
      ? std::max(brightness, noise / preset->Tissues[0].High)
      : brightness;
    const double* const spacing = image->GetSpacing();
    const double voxel = (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0;
    scale.Gradients = brightness / voxel;
    scale.AreGradientsPerUnit = true;
  }
  return true;
}

bool FillFromPreset(const char* name, vtkHapticProperty* property, const PresetScale& scale)
{
  for (const Preset& preset : Presets())
  {
    if (name && std::string(name) == preset.Name)
    {
      Fill(property->GetStiffness(), preset, &Tissue::Stiffness, scale.Values);
      Fill(property->GetFriction(), preset, &Tissue::Friction, scale.Values);
      Fill(property->GetViscosity(), preset, &Tissue::Viscosity, scale.Values);
      Fill(property->GetSurfaceStrength(), preset, &Tissue::SurfaceStrength, scale.Values);
      vtkPiecewiseFunction* const distinctness = property->GetDistinctness();
      Empty(distinctness);
      if (preset.DistinctnessFull > 0.0)
      {
        distinctness->AddPoint(scale.Gradients * preset.DistinctnessStart, 0.0);
        distinctness->AddPoint(scale.Gradients * preset.DistinctnessFull, 1.0);
      }
      else
      {
        property->DistinctnessFromNoiseOn();
      }
      property->SetDistinctnessPerMillimeter(
        preset.DistinctnessFull > 0.0 && !scale.AreGradientsPerUnit);
      property->RemoveAllTissues();
      for (const Tissue& tissue : preset.Tissues)
      {
        property->AddTissue(tissue.Name, scale.Values * tissue.Low, scale.Values * tissue.High);
      }
      property->SetSurfaceSide(preset.Side);
      property->SetScalarsAreLabels(preset.IsOfLabels);
      property->SetSolidFromImage(preset.IsOfImage);
      property->SetShiftFromImage(IsOfCT(preset.Name));
      return true;
    }
  }
  return false;
}

bool FillCuttingForce(const char* name, vtkPiecewiseFunction* force)
{
  const std::string wanted = name ? name : "";
  const bool isKnown = std::any_of(Presets().begin(), Presets().end(),
    [&](const Preset& preset) { return wanted == preset.Name; });
  if (!isKnown || !IsOfCT(wanted))
  {
    return false;
  }
  // Forces of a lumbar puncture: see Documentation/method.md#the-needle. The force does not dip at
  // the values of fluid, because these also occur between fat and muscle, where a dip would feel
  // like a loss of resistance.
  constexpr double cutting[][2] = { { -955.0, 0.0 }, { -900.0, 0.04 }, { -300.0, 0.04 },
    { -150.0, 0.1 }, { -80.0, 0.1 }, { 20.0, 0.3 } }; // HU, N
  Empty(force);
  for (const auto& [value, newtons] : cutting)
  {
    force->AddPoint(value, newtons);
  }
  return true;
}

vtkSmartPointer<vtkStringArray> MakePresetNames()
{
  auto names = vtkSmartPointer<vtkStringArray>::New();
  for (const Preset& preset : Presets())
  {
    names->InsertNextValue(preset.Name);
  }
  return names;
}

std::string ListPresets()
{
  std::string list;
  for (const Preset& preset : Presets())
  {
    list += (list.empty() ? "\"" : ", \"") + std::string(preset.Name) + "\"";
  }
  return list;
}

//------------------------------------------------------------------------------
namespace
{

constexpr SetupFileKind PresetKind{ "VTK Volume Haptics preset", 1, "preset",
  "that vtkHapticProperty::WritePreset() wrote", "write the preset again" };
constexpr std::size_t LargestPreset = 1 << 20; // bytes; a preset usually has a few thousand

/**
 * Keys that preset files omit, so that a preset applies to any component and to data stored in any
 * way.
 */
constexpr const char* DataKeys[] = { "Component", "ScalarShift", "ScalarScale" };

void RemoveDataKeys(Json::Value& root)
{
  for (const char* const key : DataKeys)
  {
    root.removeMember(key);
  }
}

/**
 * Parses a preset. Returns false, with the fault and the cure in `error`, if the text is not a
 * preset.
 */
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
  // Check that the preset can be read again, before it replaces a valid file.
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
  // Read into a new property, whose defaults replace whatever the file lacks.
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
