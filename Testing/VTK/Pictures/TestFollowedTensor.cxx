// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders what guides the hand in a tensor mode: the fibre through the proxy, the sheet across the
// smallest eigenvector, and the tensor as an ellipsoid. Fibres are circles around the z axis, and
// sheets are planes across z. The eigenvalues are 1 along the circle, 0.5 along the radius and 0.2
// along z.
#include "FollowedHand.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkHapticMode.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

using scenetest::Fail;

namespace
{
constexpr double Along = 1.0;
constexpr double Radial = 0.5;
constexpr double Upright = 0.2;
constexpr double Reach = 48.0; // number of voxels, each 1 mm wide

vtkSmartPointer<vtkImageData> MakeFibres()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(41, 41, 41);
  image->SetOrigin(-20.0, -20.0, -20.0);
  vtkNew<vtkDoubleArray> tensors;
  tensors->SetName("tensor");
  tensors->SetNumberOfComponents(6);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* const x = image->GetPoint(i);
    const double r = std::max(1.0, std::hypot(x[0], x[1]));
    const double c = x[0] / r;
    const double s = x[1] / r;
    const double six[6] = { Along * s * s + Radial * c * c, Along * c * c + Radial * s * s, Upright,
      (Radial - Along) * s * c, 0.0, 0.0 };
    tensors->InsertNextTuple(six);
  }
  image->GetPointData()->AddArray(tensors);
  return image;
}

/// Expects that the tensor maps a direction to its eigenvalue times this direction.
bool CheckTensor(const double* tensor, const double (&direction)[3], double eigenvalue)
{
  for (int row = 0; row < 3; ++row)
  {
    double product = 0.0;
    for (int column = 0; column < 3; ++column)
    {
      product += tensor[3 * row + column] * direction[column];
    }
    // The tolerance allows for interpolation if the hand is between samples.
    if (std::abs(product - eigenvalue * direction[row]) > 0.02 * Reach / 8.0)
    {
      return Fail("the tensor", product, eigenvalue * direction[row]);
    }
  }
  return true;
}

bool CheckShapes(vtkPolyData* shapes, const double* proxy)
{
  vtkDataArray* const tensors = shapes->GetPointData()->GetTensors();
  if (shapes->GetNumberOfVerts() != 1 || shapes->GetNumberOfLines() != 1 ||
    shapes->GetNumberOfPolys() != 1 || !tensors)
  {
    return Fail("the number of shapes", static_cast<double>(shapes->GetNumberOfCells()), 3);
  }
  const double radius = std::hypot(proxy[0], proxy[1]);
  vtkNew<vtkIdList> ids;
  shapes->GetCellPoints(0, ids); // vertices come first
  const double* const tensor = tensors->GetTuple(ids->GetId(0));
  const double along[3] = { -proxy[1] / radius, proxy[0] / radius, 0.0 };
  const double outwards[3] = { proxy[0] / radius, proxy[1] / radius, 0.0 };
  const double upright[3] = { 0.0, 0.0, 1.0 };
  const double length = Reach / 8.0; // length of the longest axis
  if (!CheckTensor(tensor, along, length) ||
    !CheckTensor(tensor, outwards, length * Radial / Along) ||
    !CheckTensor(tensor, upright, length * Upright / Along))
  {
    return false;
  }
  for (vtkIdType cell = 1; cell < shapes->GetNumberOfCells(); ++cell)
  {
    shapes->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      double x[3];
      shapes->GetPoint(ids->GetId(i), x);
      const double r = std::hypot(x[0], x[1]);
      if (std::abs(x[2] - proxy[2]) > 0.01)
      {
        return Fail("the height", x[2], proxy[2]);
      }
      if (cell == 1 && std::abs(r - radius) > 0.01)
      {
        return Fail("the radius of the fibre", r, radius);
      }
    }
  }
  return true;
}
} // namespace

int TestFollowedTensor(int argc, char* argv[])
{
  vtkNew<vtkHapticMode> mode;
  mode->SetKindToTensorFollow();
  mode->SetArrayName("tensor");
  mode->GetSecondStrength()->AddPoint(0.0, 1.0);
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputData(MakeFibres());
  filter->AddMode(mode);
  filter->SetMethodToPrimitives();
  vtkNew<vtkHapticDevice> device;
  if (!scenetest::FeelAt(filter, 9.0, -6.0, 2.0, device))
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkPolyData> shapes;
  device->GetState()->GetFollowed(shapes, Reach);
  if (!CheckShapes(shapes, device->GetState()->GetProxyPosition()))
  {
    return EXIT_FAILURE;
  }
  return scenetest::CompareFollowed(device, 18.0, -55.0, 40.0, argc, argv);
}
