// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Scene/VolumeLook.h"

#include "VTK/Scene/CTLook.h"

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

void LookByThresholds(const Analysis& analysis, vtkVolumeProperty* property)
{
  const double edge = 0.15 * (analysis.OuterThreshold - analysis.Low);
  const double outer = analysis.OuterThreshold, deep = analysis.DeepThreshold;
  // Tissues, or from slow to fast.
  const Colour colours[2][5] = {
    { { 0.70, 0.48, 0.40 }, { 0.86, 0.62, 0.51 }, { 0.88, 0.66, 0.56 }, { 0.92, 0.76, 0.67 },
      { 0.98, 0.90, 0.82 } },
    { { 0.23, 0.32, 0.62 }, { 0.20, 0.50, 0.68 }, { 0.18, 0.62, 0.63 }, { 0.45, 0.77, 0.50 },
      { 0.98, 0.91, 0.36 } },
  };
  const auto& of = colours[analysis.Kind == Explore::VolumeKind::Field];
  const LookStop stops[] = {
    { std::min(analysis.Range[0], outer - 2.0 * edge), 0.00, of[0] },
    { outer - edge, 0.00, of[0] },
    { outer + edge, 0.30, of[1] },
    { deep, 0.30, of[2] },
    { deep + edge, 0.55, of[3] },
    { std::max(analysis.High, deep + 2.0 * edge), 0.80, of[4] },
  };
  Apply(stops, property);
}
} // namespace

namespace Explore
{
void SetLabelLook(vtkHapticLabelTable* table, vtkVolumeProperty* property)
{
  constexpr double half = 0.499, opacity = 0.9;
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
  property->SetInterpolationTypeToNearest(); // between two numbers there is no label
}

void SetVolumeLook(const Analysis& analysis, vtkVolumeProperty* property)
{
  if (analysis.Kind == VolumeKind::CT)
  {
    Apply(VolumeHaptics::CTLook, property);
  }
  else
  {
    LookByThresholds(analysis, property);
  }
  property->SetScalarOpacityUnitDistance(
    1e-3 * VolumeHaptics::CTLookThickness / analysis.MetersPerWorldUnit);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetAmbient(0.2);
  property->SetDiffuse(0.85);
  property->SetSpecular(0.2);
  property->SetSpecularPower(18.0);
}
} // namespace Explore
