// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture with a noisy ball in an image with a rotated placement, and regions of this image. */
#ifndef RegionRig_h
#define RegionRig_h

#include "Rigs/ApiRig.h"

#include <vtkDataArray.h>
#include <vtkHapticRegionFilter.h>
#include <vtkPointData.h>

#include <cmath>
#include <random>

namespace apitest
{
/// Makes a ball with a radius of 20 voxels and noise in 60 x 56 x 52 voxels, whose indices do not
/// begin at 0.
inline vtkSmartPointer<vtkImageData> MakeBall(int scalarType = VTK_SHORT, double sigma = 10.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-5, 54, 3, 58, 10, 61);
  image->SetSpacing(0.8, 1.0, 1.2);
  image->SetOrigin(-20.0, 7.0, 3.0);
  image->SetDirectionMatrix(0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1);
  image->AllocateScalars(scalarType, 1);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  scalars->SetName("Density");
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, sigma);
  double centre[3];
  image->GetCenter(centre);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double r = std::hypot(x[0] - centre[0], x[1] - centre[1], x[2] - centre[2]);
    scalars->SetComponent(i, 0, std::round(1000.0 / (1.0 + std::exp(r - 20.0)) + noise(random)));
  }
  return image;
}

/// Makes a path that presses the top of the ball, slides over the ball, and moves in and out of its
/// surface.
inline std::vector<Point> SlideOver(vtkImageData* image, int ticks)
{
  double centre[3];
  image->GetCenter(centre);
  std::vector<Point> path;
  for (int i = 0; i < ticks; ++i)
  {
    const double angle = 0.2 * std::sin(0.004 * i);
    const double r = 21.5 - 3.0 * std::min(1.0, 0.005 * i) - 1.2 * std::sin(0.02 * i);
    path.push_back({ centre[0] + r * std::sin(angle), centre[1] + 0.3 * r * std::sin(angle),
      centre[2] + r * std::cos(angle) });
  }
  return path;
}

/// Returns the largest difference between two outputs in a point array.
inline double FarthestApart(vtkPolyData* a, vtkPolyData* b, const char* name)
{
  double most = a->GetNumberOfPoints() == b->GetNumberOfPoints() ? 0.0 : HUGE_VAL;
  vtkDataArray* const x = a->GetPointData()->GetArray(name);
  vtkDataArray* const y = b->GetPointData()->GetArray(name);
  for (vtkIdType i = 0; i < a->GetNumberOfPoints() && most < HUGE_VAL; ++i)
  {
    for (int c = 0; c < x->GetNumberOfComponents(); ++c)
    {
      most = std::max(most, std::abs(x->GetComponent(i, c) - y->GetComponent(i, c)));
    }
  }
  return most;
}
} // namespace apitest

#endif
