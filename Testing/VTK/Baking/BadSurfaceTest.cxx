// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests surfaces that SURFACE_PROXY can't touch. Each must cause one error, which names the input
 * and the remedy.
 */

#include "Rigs/ApiRig.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkSignedCharArray.h>
#include <vtkSphereSource.h>

#include <limits>

using namespace apitest;

namespace
{
class BadSurface : public ApiTest
{
protected:
  BadSurface() { this->Filter->SetMethodToSurfaceProxy(); }
};
} // namespace

TEST_F(BadSurface, WithoutAnIsosurfaceThereIsAnErrorThatSaysTheRange)
{
  this->Filter->SetIsoValue(5000.0);
  this->ExpectError({ "IsoValue 5000", "go from 0 to 1500. Set", "SetIsoValue", "port 2" });
}

TEST_F(BadSurface, TheRangeOfALargeVolumeIsThatOfSomeSamples)
{
  // Above 2^26 samples, the range of the values is computed from a subset of the samples.
  constexpr int n = 408;
  vtkNew<vtkSignedCharArray> samples;
  samples->SetNumberOfValues(vtkIdType{ n } * n * n);
  samples->FillValue(7);
  samples->SetValue(1000, 9); // this sample is not in the subset
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  image->GetPointData()->SetScalars(samples);
  this->Filter->SetInputData(0, image);
  this->Filter->SetIsoValue(50.0);
  this->ExpectError({ "IsoValue 50", "from 7 to 7, as far as some samples of them tell" });
}

TEST_F(BadSurface, ASurfaceHasTriangles)
{
  vtkNew<vtkPolyData> nothing;
  this->Filter->SetSurfaceData(nothing);
  this->ExpectError({ "port 2", "no triangles" });
  this->Filter->SetSurfaceData(this->Path);
  this->ExpectError({ "port 2", "no triangles" });
}

TEST_F(BadSurface, ASurfacesPointsAreFinite)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  sphere->GetOutput()->GetPoints()->SetPoint(7, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  this->Filter->SetSurfaceData(sphere->GetOutput());
  this->ExpectError({ "port 2", "NaN", "point 7" });
}

TEST_F(BadSurface, ACellsPointsExist)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkPolyData* const surface = sphere->GetOutput();
  const vtkIdType wrong[] = { 0, 1, surface->GetNumberOfPoints() };
  surface->GetPolys()->InsertNextCell(3, wrong);
  this->Filter->SetSurfaceData(surface);
  this->ExpectError({ "port 2", "point that does not exist" });
}

TEST_F(BadSurface, ASphereIsNoLargerThanATickHasTimeFor)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(10.0);
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  this->Filter->SetSurfaceConnection(sphere->GetOutputPort());
  this->Filter->SetProxyRadius(5.0);
  this->ExpectError({ "ProxyRadius 5", "too large", "Lower ProxyRadius" });
}

TEST_F(BadSurface, TheIsoValueIsANumber)
{
  this->Filter->SetIsoValue(std::numeric_limits<double>::quiet_NaN());
  this->ExpectError({ "IsoValue", "finite" });
}
