// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeLook.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

namespace
{
using Explore::Analysis;

struct Stop
{
  double Value;
  double Opacity; // of 4 mm of it
  double Colour[3];
};

template <std::size_t N>
void Apply(const Stop (&stops)[N], vtkVolumeProperty* property)
{
  vtkNew<vtkColorTransferFunction> colour;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const Stop& stop : stops)
  {
    colour->AddRGBPoint(stop.Value, stop.Colour[0], stop.Colour[1], stop.Colour[2]);
    opacity->AddPoint(stop.Value, stop.Opacity);
  }
  property->SetColor(colour);
  property->SetScalarOpacity(opacity);
}

void LookLikeCT(vtkVolumeProperty* property)
{
  const Stop stops[] = {
    { -1024, 0.00, { 0.85, 0.60, 0.47 } },
    { -500, 0.00, { 0.85, 0.60, 0.47 } },
    { -300, 0.16, { 0.90, 0.66, 0.53 } },
    { -100, 0.16, { 0.92, 0.68, 0.55 } },
    { 0, 0.05, { 0.86, 0.50, 0.42 } },
    { 130, 0.03, { 0.90, 0.70, 0.60 } },
    { 260, 0.50, { 0.95, 0.90, 0.80 } },
    { 500, 0.98, { 0.98, 0.95, 0.88 } },
    { 3000, 1.00, { 1.00, 1.00, 0.98 } },
  };
  Apply(stops, property);
}

void LookByThresholds(const Analysis& analysis, vtkVolumeProperty* property)
{
  const double edge = 0.15 * (analysis.OuterThreshold - analysis.Low);
  const double outer = analysis.OuterThreshold, deep = analysis.DeepThreshold;
  const Stop stops[] = {
    { analysis.Range[0] < outer - edge ? analysis.Range[0] : outer - 2.0 * edge, 0.0,
      { 0.55, 0.42, 0.38 } },
    { outer - edge, 0.00, { 0.62, 0.48, 0.43 } },
    { outer + edge, 0.10, { 0.80, 0.62, 0.53 } },
    { deep - edge, 0.12, { 0.90, 0.76, 0.66 } },
    { deep + edge, 0.55, { 0.96, 0.90, 0.82 } },
    { analysis.High > deep + edge ? analysis.High + edge : deep + 2.0 * edge, 0.80,
      { 1.00, 0.98, 0.94 } },
  };
  Apply(stops, property);
}
}

namespace Explore
{
void SetVolumeLook(const Analysis& analysis, vtkVolumeProperty* property)
{
  if (analysis.Kind == VolumeKind::CT)
  {
    LookLikeCT(property);
  }
  else
  {
    LookByThresholds(analysis, property);
  }
  property->SetScalarOpacityUnitDistance(0.004 / analysis.MetersPerWorldUnit);
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  property->SetAmbient(0.22);
  property->SetDiffuse(0.75);
  property->SetSpecular(0.25);
  property->SetSpecularPower(18.0);
}
}
