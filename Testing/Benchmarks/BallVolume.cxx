// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BallVolume.h"

#include <algorithm>

using namespace VolumeHaptics;

namespace benchmarks
{
// Returns materials with seven tissues. They are plateaus with ramps between them, spread over the
// volume's values.
HapticMaterial MakeMaterial(const BallVolume& volume)
{
  // Stiffness k (N/m), friction mu, drag R (N), strength T_N (N). k and T_N are positive
  // everywhere, so that every tick does its full work.
  const double tissues[7][4] = { { 50, 0.05, 0.05, 1.0 }, { 80, 0.10, 0.05, 1.0 },
    { 150, 0.15, 0.2, 1.2 }, { 100, 0.05, 0.3, 1.2 }, { 350, 0.25, 0.4, 1.5 },
    { 600, 0.20, 0.4, 2.5 }, { 1000, 0.30, 0.1, 8.0 } };
  const auto* const samples = static_cast<const std::int16_t*>(volume.View.Data);
  const Vector3 centre = volume.GetCentre();
  const double low = samples[0];
  const double high = samples[static_cast<std::int64_t>(centre.X) * volume.View.Stride[0] +
    static_cast<std::int64_t>(centre.Y) * volume.View.Stride[1] +
    static_cast<std::int64_t>(centre.Z) * volume.View.Stride[2]];
  HapticMaterial material;
  Polyline* const lines[4] = { &material.Stiffness, &material.Friction, &material.Viscosity,
    &material.SurfaceStrength };
  for (int property = 0; property < 4; ++property)
  {
    lines[property]->clear();
    for (int tissue = 0; tissue < 7; ++tissue)
    {
      for (const double end : { 0.1, 0.9 })
      {
        const double x = low + (high - low) * (tissue + end) / 7.0;
        lines[property]->push_back({ x, tissues[tissue][property] });
      }
    }
  }
  material.Distinctness = { { 0.1, 0.0 }, { 1.0, 1.0 } };
  return material;
}

BallVolume::BallVolume(const std::string& name, int nx, int ny, int nz)
  : Name(name)
  , Image(vtkSmartPointer<vtkImageData>::New())
{
  this->Image->SetDimensions(nx, ny, nz);
  this->Image->AllocateScalars(VTK_SHORT, 1);
  this->View.Data = this->Image->GetScalarPointer();
  this->View.Type = ScalarType::Int16;
  const std::int64_t dimensions[3] = { nx, ny, nz };
  const std::int64_t stride[3] = { 1, nx, std::int64_t(nx) * ny };
  std::copy(dimensions, dimensions + 3, this->View.Dimensions);
  std::copy(stride, stride + 3, this->View.Stride);

  const int cx = nx / 2;
  const int cy = ny / 2;
  const int cz = nz / 2;
  auto* to = static_cast<std::int16_t*>(this->Image->GetScalarPointer());
  for (int k = 0; k < nz; ++k)
  {
    for (int j = 0; j < ny; ++j, to += nx)
    {
      const int across = (j - cy) * (j - cy) + (k - cz) * (k - cz);
      for (int i = 0; i < nx; ++i)
      {
        to[i] = static_cast<std::int16_t>(2000 - (across + (i - cx) * (i - cx)) / 20);
      }
    }
  }
}

Vector3 BallVolume::GetCentre() const
{
  const std::int64_t* const n = this->View.Dimensions;
  return { static_cast<double>(n[0] / 2), static_cast<double>(n[1] / 2),
    static_cast<double>(n[2] / 2) };
}

const std::vector<Estimator>& GetEstimators()
{
  static const std::vector<Estimator> estimators = {
    { "CENTRAL_DIFFERENCE", GradientEstimator::CentralDifference, 2, 0 },
    { "GAUSSIAN_r1", GradientEstimator::Gaussian, 1, 4 },
    { "GAUSSIAN_r2", GradientEstimator::Gaussian, 2, 6 },
    { "GAUSSIAN_r3", GradientEstimator::Gaussian, 3, 8 },
    { "CUBIC_BSPLINE", GradientEstimator::CubicBSpline, 2, 4 },
  };
  return estimators;
}

std::unique_ptr<HapticModel> MakeModel(
  const BallVolume& volume, const Estimator& estimator, const ModelChoice& choice)
{
  HapticModelDescription description;
  description.View = volume.View;
  description.DeviceToWorld.Linear = 1000.0 * Matrix3{};
  description.Estimator = estimator.Kind;
  description.KernelRadius = estimator.Radius;
  description.Material = MakeMaterial(volume);
  description.Settings.Method = choice.Method;
  description.Settings.Solver = choice.Solver;
  description.Settings.IsoValue = BallLevel;
  description.Settings.ForceShading = choice.ForceShading;
  description.Settings.LocalShape = choice.LocalShape;
  description.Settings.Geometry = choice.Geometry;
  if (choice.IsPlacedAsThePaper)
  {
    description.Settings.Alignment = ContactAlignment::Distinctness;
    description.Settings.Placement = MaterialPlacement::Kernel;
  }
  description.Mesh = choice.Mesh;
  description.Labels = choice.Labels;
  description.TimeSteps = choice.TimeSteps;
  description.Settings.ForceFieldGain = 0.01;
  description.Settings.ForceFieldDamping = 0.5;
  return std::make_unique<HapticModel>(description);
}

} // namespace benchmarks
