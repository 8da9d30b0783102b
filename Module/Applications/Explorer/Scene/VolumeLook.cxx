// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Scene/VolumeLook.h"

#include "VTK/Scene/Volumes/CTLook.h"

#include "vtkColorTransferFunction.h"
#include "vtkHapticLabelTable.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>

namespace
{
using Explore::Analysis;
using VolumeHaptics::LookStop;

using Colour = std::array<double, 3>;

template <std::size_t N>
void Apply(const LookStop (&stops)[N], vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> colour;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const LookStop& stop : stops)
  {
    colour->AddRGBPoint(stop.Value, stop.Color[0], stop.Color[1], stop.Color[2]);
    opacity->AddPoint(stop.Value, stop.Opacity);
  }
  property->SetColor(colour);
  property->SetScalarOpacity(opacity);
}

constexpr double OPAQUE = VolumeHaptics::LookOpaque;
/// Thickness (m) of a layer of a field at which the functions' opacities apply.
constexpr double FIELD_LAYER = 0.004;

/// The first row contains the colours of tissues, the second row those of a field from low to high
/// values.
const Colour COLOURS[2][5] = {
  { { 0.70, 0.48, 0.40 }, { 0.86, 0.62, 0.51 }, { 0.88, 0.66, 0.56 }, { 0.92, 0.76, 0.67 },
    { 0.98, 0.90, 0.82 } },
  { { 0.23, 0.32, 0.62 }, { 0.20, 0.50, 0.68 }, { 0.18, 0.62, 0.63 }, { 0.45, 0.77, 0.50 },
    { 0.98, 0.91, 0.36 } },
};

/// Sets the opacities of the body's outer part and of its dense parts. For a dark body, all values
/// are negated.
void LookByThresholds(
  const Analysis& analysis, double body, double dense, double most, vtkVolumeProperty* property)
{
  const bool isDark = analysis.IsDark;
  const double sign = isDark ? -1.0 : 1.0;
  const double low = isDark ? -analysis.High : analysis.Low;
  const double high = isDark ? -analysis.Low : analysis.High;
  const double least = isDark ? -analysis.Range[1] : analysis.Range[0];
  const double outer = sign * analysis.OuterThreshold;
  const double deep = isDark ? 0.5 * (outer + high) : analysis.DeepThreshold;
  const double edge = 0.15 * (outer - low);
  const double step = 0.3 * edge;
  const auto& of = COLOURS[analysis.Kind == Explore::VolumeKind::Field];
  LookStop stops[] = {
    { std::min(least, outer - 2.0 * edge), 0.00, of[0] },
    // Keep the ramp short, because everything visible must be felt: thin parts whose values reach
    // only the ramp's lower half must be nearly invisible.
    { outer + 0.6 * step, 0.00, of[0] },
    { outer + step, body, of[1] },
    { deep, body, of[2] },
    { deep + edge, dense, of[3] },
    { std::max(high, deep + 2.0 * edge), most, of[4] },
  };
  for (LookStop& stop : stops)
  {
    stop.Value *= sign;
  }
  Apply(stops, property);
}

/// Sets the colours of CTLook, and an opacity that rises from 0 to 1 between two values.
void LookAtCT(double from, double to, vtkVolumeProperty* property)
{
  Apply(VolumeHaptics::CTLook, property);
  vtkPiecewiseFunction* const opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(from, 0.0);
  opacity->AddPoint(to, OPAQUE);
}

/// Sets the gradient opacity for a cut: tissue is transparent where the gradient is smaller than at
/// the outer surface. Otherwise a cut face would show only shaded noise.
void LookThroughNoise(const Analysis& analysis, vtkVolumeProperty* property)
{
  const double air = analysis.Kind == Explore::VolumeKind::CT ? -1000.0 : analysis.Low;
  // rise per voxel at a surface that is two voxels wide
  const double edge =
    analysis.IsDark ? analysis.High - analysis.OuterThreshold : analysis.OuterThreshold - air;
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.1 * edge, 0.05);
  opacity->AddPoint(0.3 * edge, 1.0);
  property->SetGradientOpacity(opacity);
  property->DisableGradientOpacityOn();
}
} // namespace

namespace Explore
{
void SetLabelLook(vtkHapticLabelTable* table, vtkVolumeProperty* property)
{
  constexpr double half = 0.499, opacity = OPAQUE;
  vtkNew<vtkColorTransferFunction> colour;
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(half, 0.0);
  for (vtkIdType i = 0; i < table->GetNumberOfLabels(); ++i)
  {
    const int label = table->GetLabel(i);
    if (label <= 0)
    {
      continue;
    }
    double seen[3];
    table->GetColor(label, seen);
    for (const double end : { label - half, label + half })
    {
      colour->AddRGBPoint(end, seen[0], seen[1], seen[2]);
      opacities->AddPoint(end, table->GetFelt(label) ? opacity : 0.1 * opacity);
    }
  }
  property->SetColor(colour);
  property->SetScalarOpacity(opacities);
  property->SetInterpolationTypeToNearest(); // values between two label numbers have no meaning
}

void SetVolumeLook(const Analysis& analysis, vtkVolumeProperty* property)
{
  if (analysis.Kind == VolumeKind::CT)
  {
    LookAtCT(VolumeHaptics::CTLookClear, VolumeHaptics::CTLookSkin, property);
  }
  else if (analysis.Kind == VolumeKind::Field)
  {
    LookByThresholds(analysis, 0.30, 0.55, 0.80, property);
  }
  else
  {
    LookByThresholds(analysis, OPAQUE, OPAQUE, OPAQUE, property);
  }
  if (HasInside(analysis))
  {
    LookThroughNoise(analysis, property);
  }
  property->SetScalarOpacityUnitDistance(analysis.Kind == VolumeKind::Field
      ? FIELD_LAYER / analysis.MetersPerWorldUnit
      : VolumeHaptics::LookLayer * analysis.Voxel);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetAmbient(0.2);
  property->SetDiffuse(0.85);
  property->SetSpecular(0.2);
  property->SetSpecularPower(18.0);
}

bool HasInside(const Analysis& analysis)
{
  return analysis.Kind != VolumeKind::Field && analysis.Kind != VolumeKind::Labels;
}

void SetInsideLook(const Analysis& analysis, vtkVolumeProperty* property)
{
  if (analysis.Kind == VolumeKind::CT)
  {
    LookAtCT(200.0, 350.0, property);
  }
  else
  {
    LookByThresholds(analysis, 0.0, OPAQUE, OPAQUE, property);
  }
}
} // namespace Explore
