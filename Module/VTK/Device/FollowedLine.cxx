// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/FollowedLine.h"

#include "Core/Solvers/Primitives/FollowedShapes.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFunctionSet.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRungeKutta4.h"
#include "vtkStreamTracer.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr double StepVoxels = 0.5;
/** Limit on the steps of a line: nobody could see the difference that more steps make. */
constexpr int MostSteps = 2000;
/** Smallest number of steps after which a line may return to its first position. */
constexpr int LeastClosed = 5;

/** Computes the direction of a line at a position in voxels from the first position. */
class LineFunction : public vtkFunctionSet
{
public:
  static LineFunction* New();
  vtkTypeMacro(LineFunction, vtkFunctionSet);

  using Superclass::FunctionValues;
  int FunctionValues(double* x, double* f) override
  {
    const bool isThere = this->Shapes->Turn(this->Mode, this->ToPlace(x), this->Direction);
    Write(this->Direction, f);
    return isThere;
  }

  /** Moves a position onto the line. Returns false if the line ends there. */
  bool Return(double* x)
  {
    Vector3 place = this->ToPlace(x);
    const bool goesOn = this->Shapes->Return(this->Mode, place);
    const Vector3 away = (1.0 / this->Voxel) * (place - this->Start);
    this->IsClosed = ++this->Steps >= LeastClosed && Norm(away) < 0.6 * StepVoxels;
    Write(this->IsClosed ? Vector3{} : away, x);
    return goesOn && !this->IsClosed;
  }

  Vector3 ToPlace(const double* x) const
  {
    return this->Start + this->Voxel * Vector3{ x[0], x[1], x[2] };
  }

  FollowedShapes* Shapes = nullptr;
  int Mode = 0;
  Vector3 Start;      ///< first position (m)
  double Voxel = 1.0; ///< edge of a voxel (m)
  Vector3 Direction;  ///< last direction read; fixes the sign of an eigenvector
  int Steps = 0;
  bool IsClosed = false;
  bool IsAtEnd = false;

protected:
  LineFunction()
  {
    this->NumFuncs = 3;
    this->NumIndepVars = 4; // includes the time
  }

private:
  static void Write(const Vector3& v, double* x)
  {
    x[0] = v.X;
    x[1] = v.Y;
    x[2] = v.Z;
  }
};
vtkStandardNewMacro(LineFunction);

/** Integrates LineFunction instead of the vectors that the tracer interpolates. */
class LineIntegrator : public vtkRungeKutta4
{
public:
  static LineIntegrator* New();

  void SetFunctionSet(vtkFunctionSet*) override { this->Superclass::SetFunctionSet(this->Line); }

  using Superclass::ComputeNextStep;
  int ComputeNextStep(double* from, double* derivatives, double* to, double t, double& step,
    double& taken, double least, double most, double allowed, double& error, void* data) override
  {
    // The step that reaches the end still belongs to the line.
    const int failure = this->Line->IsAtEnd
      ? static_cast<int>(OUT_OF_DOMAIN)
      : this->Superclass::ComputeNextStep(
          from, derivatives, to, t, step, taken, least, most, allowed, error, data);
    this->Line->IsAtEnd = failure || !this->Line->Return(to);
    return failure;
  }

  LineFunction* Line = nullptr;

protected:
  LineIntegrator() = default;
  /** Sets the line of the instance that vtkStreamTracer makes and integrates with. */
  vtkObjectBase* NewInstanceInternal() const override
  {
    LineIntegrator* const copy = LineIntegrator::New();
    copy->Line = this->Line;
    return copy;
  }

private:
  using Superclass = vtkRungeKutta4;
};
vtkStandardNewMacro(LineIntegrator);

/** Makes a single cell around the origin, with a vector of length 1. */
void MakeCell(double half, vtkImageData* cell)
{
  cell->SetDimensions(2, 2, 2);
  cell->SetOrigin(-half, -half, -half);
  cell->SetSpacing(2.0 * half, 2.0 * half, 2.0 * half);
  vtkNew<vtkDoubleArray> vector;
  vector->SetName("Line");
  vector->SetNumberOfComponents(3);
  vector->InsertNextTuple3(1.0, 0.0, 0.0);
  cell->GetCellData()->SetVectors(vector);
}

} // namespace

std::vector<Vector3> TraceFollowedLine(
  FollowedShapes& shapes, const FollowedShape& line, double voxel, double reach)
{
  std::vector<Vector3> places = { line.Centre };
  if (!(reach > 0.0))
  {
    return places;
  }
  const double most = std::min(reach, MostSteps * StepVoxels);
  vtkNew<LineFunction> function;
  function->Shapes = &shapes;
  function->Mode = line.Mode;
  function->Start = line.Centre;
  function->Voxel = voxel;
  vtkNew<LineIntegrator> integrator;
  integrator->Line = function;
  vtkNew<vtkImageData> cell;
  MakeCell(most + 1.0, cell);
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInputData(cell);
  tracer->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataSetAttributes::VECTORS);
  tracer->SetIntegrator(integrator);
  tracer->SetIntegrationStepUnit(vtkStreamTracer::LENGTH_UNIT);
  tracer->SetInitialIntegrationStep(StepVoxels);
  tracer->SetMaximumPropagation(most);
  tracer->SetMaximumNumberOfSteps(MostSteps);
  tracer->SetComputeVorticity(false);
  for (const double sign : { 1.0, -1.0 })
  {
    function->Direction = sign * line.Direction;
    function->Steps = 0;
    function->IsAtEnd = false;
    tracer->Modified();
    tracer->Update();
    vtkPolyData* const traced = tracer->GetOutput();
    for (vtkIdType i = 1; i < traced->GetNumberOfPoints(); ++i)
    {
      places.push_back(function->ToPlace(traced->GetPoint(i)));
    }
    if (function->IsClosed)
    {
      break;
    }
    std::reverse(places.begin(), places.end());
  }
  return places;
}

} // namespace VolumeHaptics
