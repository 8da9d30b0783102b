// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects volumes without a suitable preset to get materials from their own edges: the head phantom
// in 8 bits, and as numbers from 0 to 1. Without edges, the histogram decides, but never within the
// noise of the air.
#include "Applications/Explorer/Exploration/TissueTable.h"
#include "Applications/Explorer/Scene/VolumeLook.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "VTK/Reading/InputError.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageShiftScale.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace
{
/// Returns the head with its range of -1000 to 1500 HU scaled to 0 to `most`.
Explore::Volume Scaled(const Explore::Volume& head, double most, int type)
{
  vtkNew<vtkImageShiftScale> scale;
  scale->SetInputData(head.Image);
  scale->SetShift(1000.0);
  scale->SetScale(most / 2500.0);
  scale->SetOutputScalarType(type);
  scale->ClampOverflowOn();
  scale->Update();
  Explore::Volume volume = head;
  volume.Image = scale->GetOutput();
  return volume;
}

void ExpectProposal(const std::string& what, const Explore::Volume& volume, double most)
{
  const Explore::Exploration e = Explore::ExploreVolume(volume, Explore::Settings());
  Expect(e.Materials == "propose", what + " proposes its materials, not " + e.Materials);
  vtkHapticProperty* const feel = e.Filter->GetProperty();
  Expect(e.KernelRadius == feel->GetProposedKernelRadius(), what + ": its kernel is used");
  const auto strength = [&](double hounsfield)
  { return feel->GetSurfaceStrength()->GetValue((hounsfield + 1000.0) * most / 2500.0); };
  Expect(strength(-1000.0) == 0.0, what + ": air is not felt");
  Expect(strength(40.0) > 0.5 && strength(40.0) < 3.5, what + ": soft tissue can be penetrated");
  Expect(strength(1000.0) == 12.0, what + ": bone is the strongest");
  vtkDataArray* const force = e.Trace->GetPointData()->GetArray("Force");
  double largest = 0.0;
  for (vtkIdType i = 0; i < force->GetNumberOfTuples(); ++i)
  {
    const double* const f = force->GetTuple(i);
    largest = std::max(largest, std::hypot(f[0], f[1], f[2]));
  }
  Expect(largest > 0.5 && largest < 20.0, what + ": the path feels it");
}
/// Returns the largest force (N) on the outer surface along the path.
double LargestOutside(const Explore::Exploration& e)
{
  vtkDataArray* const force = e.Trace->GetPointData()->GetArray("NormalForce");
  double largest = 0.0;
  for (const Explore::Phase& phase : e.Tip.Phases)
  {
    for (vtkIdType i = phase.First; phase.Name == "slide outside" && i < phase.Last; ++i)
    {
      largest = std::max(largest, force->GetComponent(i, 0));
    }
  }
  return largest;
}

/// Returns a volume of 40^3 voxels of 3 mm whose values depend on the distance (mm) from its
/// middle.
Explore::Volume MakeSoftBall(const std::function<double(double)>& valueAt)
{
  constexpr int size = 40;
  constexpr double spacing = 3.0;
  Explore::Volume ball;
  ball.Name = "ball";
  ball.Image = vtkSmartPointer<vtkImageData>::New();
  ball.Image->SetDimensions(size, size, size);
  ball.Image->SetSpacing(spacing, spacing, spacing);
  ball.Image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < ball.Image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    ball.Image->GetPoint(i, point);
    const double middle = 0.5 * spacing * (size - 1);
    const double r = std::hypot(point[0] - middle, point[1] - middle, point[2] - middle);
    ball.Image->GetPointData()->GetScalars()->SetComponent(i, 0, valueAt(r));
  }
  return ball;
}

/// Returns a ball with the value 20 in air of 0, with correlated noise, clipped at 0 and rounded to
/// 32 levels. `radius` is in mm.
Explore::Volume MakeNoisyBall(double radius, double deviation)
{
  constexpr int size = 40;
  std::mt19937_64 engine(7);
  std::normal_distribution<double> random;
  std::vector<double> white(std::size_t{ 2 } * size * size * size);
  for (double& value : white)
  {
    value = random(engine);
  }
  std::size_t number = 0;
  return MakeSoftBall(
    [&](double r)
    {
      double noise = 0.0; // sum of 4 samples along x; standard deviation 1
      for (std::size_t i = 0; i < 4; ++i)
      {
        noise += 0.5 * white[number + i];
      }
      ++number;
      const double value = 20.0 * 0.5 * std::erfc((r - radius) / (3.0 * std::sqrt(2.0)));
      return std::round(std::clamp(value + deviation * noise, 0.0, 31.0));
    });
}

/// Expects that noise is not mistaken for a body, as in a CT with contrast medium, whose histogram
/// begins in the noise. The threshold lies between air and ball, and the noise has no surface
/// strength.
void ExpectNoiseIsNoBody()
{
  const Explore::Volume ball = MakeNoisyBall(40.0, 1.0);
  Explore::Settings settings;
  settings.Preset = "histogram";
  const Explore::Exploration felt = Explore::ExploreVolume(ball, settings);
  const double threshold = felt.Values.OuterThreshold;
  Expect(threshold > 5.0 && threshold < 15.0,
    "the body begins between air and ball, not at " + std::to_string(threshold));
  vtkHapticProperty* const property = felt.Filter->GetProperty();
  for (const double value : { 0.0, 1.0, 2.0, 3.0, 4.0 })
  {
    Expect(property->GetSurfaceStrength()->GetValue(value) == 0.0 &&
        property->GetViscosity()->GetValue(value) == 0.0,
      "nothing holds in noise of " + std::to_string(value));
  }
  Expect(LargestOutside(felt) > 0.5, "the ball is felt");
}

/// Expects that noise without a wall is transparent in "Micro-CT", although the histogram begins in
/// the noise.
void ExpectNoiseIsHidden()
{
  Explore::Settings settings;
  settings.Preset = "Micro-CT";
  vtkNew<vtkVolumeProperty> look;
  Explore::SetVolumeLook(Explore::ExploreVolume(MakeNoisyBall(30.0, 2.0), settings).Values, look);
  for (const double value : { 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 })
  {
    Expect(look->GetScalarOpacity()->GetValue(value) == 0.0,
      "nothing is seen in noise of " + std::to_string(value));
  }
  Expect(look->GetScalarOpacity()->GetValue(15.0) > 0.5, "the ball is seen");
}

/// Expects the force that the pressed depth implies, also if edges are several voxels wide, merge,
/// or are missing. The hand presses 2.5 mm deep. 500 N/m allow at most 1.25 N. The force is
/// smaller, because a kernel of scale s locates the edge of a ball of radius R about s^2/R (1.4 mm)
/// further inside.
void ExpectSoftSurfaces()
{
  const auto edge = [](double r, double radius, double width)
  { return 0.5 * std::erfc((r - radius) / (std::sqrt(2.0) * width)); };
  const Explore::Exploration soft =
    Explore::ExploreVolume(MakeSoftBall([&](double r) { return 100.0 * edge(r, 40.0, 9.0); }), {});
  Expect(soft.Materials == "propose", "a soft ball has an edge");
  Expect(std::abs(soft.Values.OuterThreshold - 50.0) < 2.0, "its surface is where it is steepest");
  const double felt = LargestOutside(soft);
  Expect(felt > 0.4 && felt < 1.25, "a soft ball is felt where it is pressed");
  const Explore::Exploration shells = Explore::ExploreVolume(
    MakeSoftBall([&](double r) { return 40.0 * edge(r, 45.0, 4.5) + 100.0 * edge(r, 33.0, 4.5); }),
    {});
  Expect(LargestOutside(shells) > 0.5, "shells whose edges run into each other are felt");
  const Explore::Exploration ramp = Explore::ExploreVolume(
    MakeSoftBall([](double r) { return std::max(0.0, 1.0 - r * r / 2025.0); }), {});
  Expect(ramp.Materials == "histogram", "a ramp has no edge");
  Expect(LargestOutside(ramp) > 0.5, "a body without an edge is felt where it begins");
}
} // namespace

int TestExploreProposal(int argc, char* argv[])
{
  const Explore::Volume head = Explore::LoadVolume(Argument(argc, argv, "--volume"));
  ExpectProposal("8 bits", Scaled(head, 255.0, VTK_UNSIGNED_CHAR), 255.0);
  ExpectProposal("0 to 1", Scaled(head, 1.0, VTK_FLOAT), 1.0);

  const Explore::Exploration ct = Explore::ExploreVolume(head, Explore::Settings());
  Expect(ct.Materials == "CT contrast", "Hounsfield units have a preset");

  ExpectSoftSurfaces();
  ExpectNoiseIsNoBody();
  ExpectNoiseIsHidden();

  // A ramp has no edges, so there is no surface to find.
  vtkNew<vtkImageData> ramp;
  ramp->SetDimensions(24, 24, 24);
  ramp->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < ramp->GetNumberOfPoints(); ++i)
  {
    ramp->GetPointData()->GetScalars()->SetComponent(i, 0, 0.04 * (i % 24));
  }
  Explore::Analysis analysis = Explore::AnalyseVolume(ramp);
  vtkNew<vtkVolumeHapticsFilter> filter;
  Expect(Explore::ApplyMaterials("auto", analysis, ramp, filter) == "histogram",
    "without edges the histogram decides");
  std::string message;
  try
  {
    Explore::ApplyMaterials("propose", analysis, ramp, filter);
  }
  catch (const Explore::InputError& error)
  {
    message = error.what();
  }
  Expect(message.find("--preset propose: No edge") == 0 &&
      message.find("Cure: use another preset.") != std::string::npos,
    "a wish that can't be met is an error, not: " + message);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
