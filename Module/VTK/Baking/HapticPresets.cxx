// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticPresets.h"

#include "vtkHapticProperty.h"
#include "vtkPiecewiseFunction.h"

#include <vector>

namespace VolumeHaptics
{
namespace
{

/** A tissue keeps its material from Low to High; between tissues it changes linearly. */
struct Tissue
{
  double Low;
  double High;
  double Stiffness; // N/m
  double Friction;
  double Viscosity;       // N
  double SurfaceStrength; // N
};

struct Preset
{
  const char* Name;
  std::vector<Tissue> Tissues;
  double DistinctnessStart; // gradient magnitude at which a surface begins to be felt
  double DistinctnessFull;  // gradient magnitude from which on it is felt fully
  int Side;
};

/** More newtons than any device exerts. */
constexpr double Impenetrable = 1e6;

const std::vector<Preset>& Presets()
{
  // If two tissues of the table touch, there is a ramp of 5 or 10 HU between them: partial volumes
  // should not switch a material from one tick to the next. The distinctness of the CT presets
  // starts at 8 HU/mm: beyond 3.4 standard deviations of the gradient for 20 HU of noise, 1 mm
  // voxels and the default kernel, so that noise is not felt as surfaces.
  static const std::vector<Preset> presets = {
    { "CT contrast",
      {
        { -1024, -955, 0, 0.00, 0.00, 0.0 },           // air
        { -950, -500, 80, 0.10, 0.05, 0.3 },           // lung
        { -150, -30, 150, 0.15, 0.20, 0.7 },           // fat
        { -10, 15, 100, 0.05, 0.30, 0.1 },             // fluid
        { 20, 80, 350, 0.25, 0.40, 1.5 },              // muscle, organ
        { 100, 300, 600, 0.20, 0.40, 2.5 },            // contrast medium, cartilage
        { 310, 3071, 1000, 0.30, 0.00, Impenetrable }, // bone
      },
      8, 40, vtkHapticProperty::HIGHER },
    { "CT physical",
      {
        { -1024, -955, 0, 0.00, 0.00, 0.00 },          // air
        { -950, -500, 8, 0.46, 0.01, 0.05 },           // lung
        { -150, -30, 16, 0.46, 0.02, 0.15 },           // fat
        { -10, 15, 4, 0.05, 0.02, 0.01 },              // fluid
        { 20, 80, 28, 0.46, 0.03, 0.30 },              // muscle, organ
        { 100, 300, 200, 0.30, 0.03, 1.50 },           // cartilage
        { 310, 3071, 1000, 0.32, 0.00, Impenetrable }, // bone
      },
      8, 40, vtkHapticProperty::HIGHER },
    // Surfaces are felt from both sides here, so the background can be inside one: it is as stiff
    // as fluid, because the drag of tissue on a soft spring would leave the proxy far behind.
    { "MRI",
      {
        { 0, 15, 100, 0.00, 0.00, 0.0 },    // background
        { 30, 60, 100, 0.05, 0.30, 0.2 },   // fluid
        { 80, 115, 300, 0.20, 0.30, 1.0 },  // grey matter, muscle
        { 130, 165, 450, 0.25, 0.40, 1.5 }, // white matter
        { 190, 255, 200, 0.15, 0.20, 0.8 }, // fat
      },
      3, 15, vtkHapticProperty::BOTH },
  };
  return presets;
}

void Empty(vtkPiecewiseFunction* function)
{
  function->RemoveAllPoints();
  function->ClampingOn();
  function->UseLogScaleOff();
}

void Fill(vtkPiecewiseFunction* function, const Preset& preset, double Tissue::*quantity)
{
  Empty(function);
  for (const Tissue& tissue : preset.Tissues)
  {
    function->AddPoint(tissue.Low, tissue.*quantity);
    function->AddPoint(tissue.High, tissue.*quantity);
  }
}

} // namespace

bool FillFromPreset(const char* name, vtkHapticProperty* property)
{
  for (const Preset& preset : Presets())
  {
    if (name && std::string(name) == preset.Name)
    {
      Fill(property->GetStiffness(), preset, &Tissue::Stiffness);
      Fill(property->GetFriction(), preset, &Tissue::Friction);
      Fill(property->GetViscosity(), preset, &Tissue::Viscosity);
      Fill(property->GetSurfaceStrength(), preset, &Tissue::SurfaceStrength);
      vtkPiecewiseFunction* const distinctness = property->GetDistinctness();
      Empty(distinctness);
      distinctness->AddPoint(preset.DistinctnessStart, 0.0);
      distinctness->AddPoint(preset.DistinctnessFull, 1.0);
      property->SetSurfaceSide(preset.Side);
      return true;
    }
  }
  return false;
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

} // namespace VolumeHaptics
