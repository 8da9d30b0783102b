// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Scene.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkVolumeHapticsFilter.h>

#include <stdexcept>

namespace reference
{
static void Configure(vtkVolumeHapticsFilter* filter, Scene& scene)
{
  scene.property->SetComponent(scene.component);
  switch (scene.side)
  {
    case Side::Higher:
      scene.property->SetSurfaceSideToHigher();
      break;
    case Side::Lower:
      scene.property->SetSurfaceSideToLower();
      break;
    case Side::Both:
      scene.property->SetSurfaceSideToBoth();
      break;
  }
  switch (scene.estimator)
  {
    case Estimator::CentralDifference:
      filter->SetGradientEstimatorToCentralDifference();
      break;
    case Estimator::Gaussian:
      filter->SetGradientEstimatorToGaussian();
      break;
    case Estimator::CubicBSpline:
      filter->SetGradientEstimatorToCubicBSpline();
      break;
  }
  if (scene.method == Method::Proxy)
  {
    filter->SetMethodToProxy();
  }
  else
  {
    filter->SetMethodToForceField();
  }
  filter->SetSolver(scene.solver == Solver::Paper ? vtkVolumeHapticsFilter::PAPER
                                                  : vtkVolumeHapticsFilter::PRECISE);
  if (scene.placesAsThePaper)
  {
    filter->SetContactAlignmentToDistinctness();
    filter->SetMaterialPlacementToKernel();
  }
  filter->SetProperty(scene.property);
  filter->SetKernelRadius(scene.kernelRadius);
  filter->SetServoRate(scene.servoRate);
  filter->SetMetersPerWorldUnit(scene.metersPerWorldUnit);
  filter->SetForceFieldGain(scene.forceFieldGain);
  filter->SetForceFieldDamping(scene.forceFieldDamping);
  filter->SetMaximumForce(0.0);
  filter->SetReleaseTime(0.0); // disables the release, to test only the law
}

static vtkSmartPointer<vtkPolyData> MakePath(const std::vector<Vec3>& path)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(int(path.size()));
  for (const Vec3& point : path)
  {
    lines->InsertCellPoint(points->InsertNextPoint(point.c));
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(points);
  polyData->SetLines(lines);
  return polyData;
}

static vtkDataArray* RequireArray(vtkPolyData* output, const char* name, int components)
{
  vtkDataArray* array = output->GetPointData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != components ||
    array->GetNumberOfTuples() != output->GetNumberOfPoints())
  {
    throw std::runtime_error(std::string("no proper point array ") + name);
  }
  return array;
}

Trace RunFilter(Scene& scene)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  Configure(filter, scene);
  filter->SetInputDataObject(0, scene.image);
  filter->SetInputDataObject(1, MakePath(scene.path));
  if (!scene.arrayName.empty())
  {
    filter->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, scene.arrayName.c_str());
  }
  filter->Update();
  vtkPolyData* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  if (!output || std::size_t(output->GetNumberOfPoints()) != scene.path.size())
  {
    throw std::runtime_error("the output does not have one point a tick");
  }
  Trace trace(scene.path.size());
  vtkDataArray* contact = RequireArray(output, "Contact", 1);
  for (std::size_t tick = 0; tick < trace.size(); ++tick)
  {
    output->GetPoint(tick, trace[tick].proxy.c);
    trace[tick].contact = int(contact->GetComponent(tick, 0));
  }
  for (const VectorArray& entry : VectorArrays)
  {
    vtkDataArray* array = RequireArray(output, entry.name, 3);
    for (std::size_t tick = 0; tick < trace.size(); ++tick)
    {
      array->GetTuple(tick, (trace[tick].*entry.member).c);
    }
  }
  for (const ScalarArray& entry : ScalarArrays)
  {
    vtkDataArray* array = RequireArray(output, entry.name, 1);
    for (std::size_t tick = 0; tick < trace.size(); ++tick)
    {
      trace[tick].*entry.member = array->GetComponent(tick, 0);
    }
  }
  return trace;
}
} // namespace reference
