// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects that objects around a body in a CT, such as foam (-700 HU), a blanket (-550 HU) and
// clothes (-450 HU), are neither seen nor felt in the window: the first surface for the hand and
// for the eye is the skin, at the position that the formula gives. The eye sees a surface where
// half of the opacity, 1 - exp(-sum) by the definition of vtkVolumeProperty, lies in front. Grey
// values behave alike: a sheet in front of the body whose peak only reaches the value at which the
// picture begins is hardly seen, and not felt. Where the body is dark, the picture shows the dark.
#include "Applications/Explorer/Analysis/BodyIsolation.h"
#include "Applications/Explorer/Analysis/VolumeAnalysis.h"
#include "Applications/Explorer/Scene/VolumeLook.h"
#include "Expectations.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>

namespace
{
constexpr int ROW = 60;          // voxels of 1 mm along x
constexpr double SKIN_AT = 30.0; // mm, position of the skin

/// Returns the HU value along x: air, 10 mm of surrounding material (`around`), and tissue with a
/// bone inside. Edges are 2 mm wide.
double HounsfieldAt(double x, double around)
{
  const auto step = [x](double at) { return 0.5 + 0.5 * std::tanh(x - at); };
  return -1000.0 + (around + 1000.0) * step(SKIN_AT - 10.0) + (50.0 - around) * step(SKIN_AT) +
    950.0 * step(SKIN_AT + 20.0);
}

/// Returns the grey value along x: 20, a sheet of 2 mm with the value `peak`, and a body of 180.
double GreyAt(double x, double peak)
{
  const double off = (x - SKIN_AT + 12.0) / 0.85;
  return 20.0 + 80.0 * (1.0 + std::tanh(x - SKIN_AT)) + (peak - 20.0) * std::exp(-0.5 * off * off);
}

using Row = std::function<double(double)>;

vtkSmartPointer<vtkImageData> MakeImage(const Row& valueAt)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(ROW, 20, 20);
  image->AllocateScalars(VTK_SHORT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(
      i, 0, std::round(valueAt(image->GetPoint(i)[0])));
  }
  return image;
}

/// Assigns a surface strength to every edge, so that the edge's position depends on the opacity
/// alone.
void HoldEverywhere(vtkHapticProperty* property)
{
  property->GetStiffness()->AddPoint(0.0, 400.0);
  property->GetSurfaceStrength()->AddPoint(0.0, 12.0);
  property->GetDistinctness()->AddPoint(0.0, 1.0);
}

/// Computes the proxy's position when the hand first feels 0.1 N, and the position where the ray
/// reaches half of the opacity. Without a preset, all edges have a surface strength.
void FeelAndLook(
  const Row& valueAt, const char* preset, double& felt, double& seen, bool isDark = false)
{
  const vtkSmartPointer<vtkImageData> image = MakeImage(valueAt);
  Explore::Analysis values = Explore::AnalyseVolume(image, false, false);
  values.IsDark = isDark;
  vtkNew<vtkVolumeProperty> look;
  Explore::SetVolumeLook(values, look);
  vtkNew<vtkVolumeHapticsFilter> filter;
  preset ? static_cast<void>(filter->GetProperty()->ApplyPreset(preset))
         : HoldEverywhere(filter->GetProperty());
  filter->GetProperty()->SetVisibilityFrom(look);
  if (isDark)
  {
    filter->GetProperty()->SetSurfaceSideToLower();
  }
  vtkNew<vtkPolyData> path;
  vtkNew<vtkPoints> tips;
  for (double x = 3.0; x < SKIN_AT + 5.0; x += 0.1)
  {
    tips->InsertNextPoint(x, 9.7, 9.7);
  }
  path->SetPoints(tips);
  filter->SetInputData(image);
  filter->SetPathData(path);
  filter->Update();
  vtkPolyData* const trace = filter->GetOutput();
  vtkDataArray* const force = trace->GetPointData()->GetArray("Force");
  vtkIdType tick = 0;
  while (tick + 1 < trace->GetNumberOfPoints() && std::abs(force->GetComponent(tick, 0)) < 0.1)
  {
    ++tick;
  }
  felt = trace->GetPoint(tick)[0];

  constexpr double step = 0.01; // mm, of the search
  double depth = 0.0;
  seen = 0.0;
  for (double x = 0.0; x < ROW - 1.0 && depth < std::log(2.0); x += step)
  {
    const double opacity = look->GetScalarOpacity()->GetValue(valueAt(x));
    depth -= std::log(1.0 - opacity) * step / look->GetScalarOpacityUnitDistance();
    seen = x;
  }
}

/// Expects that voxels below a threshold between two grey levels join nothing to the body.
void ExpectBodyAlone()
{
  const auto image =
    MakeImage([](double x) { return x < 30.0           ? 6.0
                               : x < 40.0 || x >= 50.0 ? 2.0
                                                       : 4.0; });
  const auto body = Explore::IsolateBody(image, 2.8, 0.0);
  Expect(body->GetScalarComponentAsDouble(10, 5, 5, 0) == 6.0, "the body is not in the picture");
  Expect(body->GetScalarComponentAsDouble(45, 5, 5, 0) == 0.0,
    "a part that only darker voxels join to the body is in the picture");
}
} // namespace

int TestExploreLook(int, char*[])
{
  ExpectBodyAlone();
  for (const char* const preset : { "CT contrast", "CT chest", "CT angiography" })
  {
    for (const double around : { -1000.0, -700.0, -550.0, -450.0 })
    {
      double felt = 0.0, seen = 0.0;
      FeelAndLook([=](double x) { return HounsfieldAt(x, around); }, preset, felt, seen);
      std::cout << preset << ", " << around << " HU around: felt at " << felt << " mm, seen at "
                << seen << " mm\n";
      Expect(std::abs(felt - SKIN_AT) < 1.0 && std::abs(seen - felt) < 1.0,
        std::string(preset) + ": the skin is not what is felt and seen first");
    }
  }
  const double begins =
    Explore::AnalyseVolume(MakeImage([](double x) { return GreyAt(x, 20.0); }), false, false)
      .OuterThreshold;
  for (const double peak : { 20.0, begins - 2.0, begins - 0.5, begins, begins + 20.0 })
  {
    double felt = 0.0, seen = 0.0;
    FeelAndLook([=](double x) { return GreyAt(x, peak); }, nullptr, felt, seen);
    std::cout << "a sheet of " << peak << " where " << begins << " is the threshold: felt at "
              << felt << " mm, seen at " << seen << " mm\n";
    const double first = peak > begins ? SKIN_AT - 12.0 : SKIN_AT;
    Expect(std::abs(felt - first) < 1.2 && std::abs(seen - felt) < 1.0,
      "grey values: what is seen first is not what is felt first");
  }
  double felt = 0.0, seen = 0.0;
  FeelAndLook([](double x) { return 200.0 - GreyAt(x, 20.0); }, nullptr, felt, seen, true);
  std::cout << "a dark body: felt at " << felt << " mm, seen at " << seen << " mm\n";
  Expect(std::abs(felt - SKIN_AT) < 1.5 && std::abs(seen - felt) < 1.0,
    "a dark body is not what is felt and seen first");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
