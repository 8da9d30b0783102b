// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/StateGeometry.h"

#include "Core/Math/Vector3.h"
#include "Core/Model/HapticModel.h"
#include "Core/Solvers/Primitives/FollowedShapes.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticState.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include VOLUME_HAPTICS_VECTOR_HEADER
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFunctionSet.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRungeKutta4.h"
#include "vtkStreamTracer.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

void WriteStateGeometry(
  const ShownState& state, double forceScale, bool isCommanded, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> parts;
  parts->SetName("Part");
  vtkNew<vtkDoubleArray> newtons;
  newtons->SetName("Newtons");
  const auto describe = [&](int part, double force)
  {
    parts->InsertNextValue(part);
    newtons->InsertNextValue(force);
  };
  const auto addVertex = [&](int part, const double position[3])
  {
    vertices->InsertNextCell(1);
    vertices->InsertCellPoint(points->InsertNextPoint(position));
    describe(part, 0.0);
  };
  const auto addLine = [&](int part, const vtkVector3d& from, const vtkVector3d& to, double force)
  {
    lines->InsertNextCell(2);
    lines->InsertCellPoint(points->InsertNextPoint(from.GetData()));
    lines->InsertCellPoint(points->InsertNextPoint(to.GetData()));
    describe(part, force);
  };

  const vtkVector3d& tip = state.Tip;
  const vtkVector3d& proxy = state.Proxy;
  const vtkVector3d& computed = state.ComputedForce;
  const vtkVector3d& normal = state.Normal;
  const vtkVector3d& force = isCommanded ? state.Force : computed;
  // vtkPolyData numbers its cells with vertices first, so fill the arrays in this order.
  addVertex(vtkHapticState::TIP, tip.GetData());
  addVertex(vtkHapticState::PROXY, proxy.GetData());
  addVertex(vtkHapticState::SURFACE_POSITION, state.SurfacePosition.GetData());
  addVertex(vtkHapticState::MEDIUM_POSITION, state.MediumPosition.GetData());
  const double unit = 1.0 / forceScale;
  addLine(vtkHapticState::SPRING, tip, proxy, 0.0);
  addLine(vtkHapticState::FORCE, tip, tip + unit * force, force.Norm());
  const double push = state.NormalForce;
  addLine(vtkHapticState::NORMAL_FORCE, proxy, proxy - (unit * push) * normal, push);
  const vtkVector3d tangent = computed - computed.Dot(normal) * normal;
  const double length = tangent.Norm();
  const double grip = state.FrictionForce;
  addLine(vtkHapticState::FRICTION_FORCE, proxy,
    proxy + (length > 0.0 ? unit * grip / length : 0.0) * tangent, grip);

  output->Initialize();
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->SetLines(lines);
  output->GetCellData()->AddArray(parts);
  output->GetCellData()->AddArray(newtons);
  const std::pair<const char*, double> fields[] = { { "Contact", state.Contact },
    { "SurfaceValue", state.SurfaceValue } };
  for (const auto& [name, value] : fields)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    output->GetFieldData()->AddArray(array);
  }
  vtkNew<vtkDoubleArray> orientation;
  orientation->SetName("Orientation");
  orientation->SetNumberOfComponents(4);
  orientation->InsertNextTypedTuple(state.Orientation);
  output->GetFieldData()->AddArray(orientation);
}

//------------------------------------------------------------------------------
namespace
{

constexpr double StepVoxels = 0.5;
/** Largest number of steps of a line; more steps would make no visible difference. */
constexpr int MostSteps = 2000;
/** Smallest number of steps after which a line may close at its first position. */
constexpr int LeastClosed = 5;

/**
 * Returns the direction of a line at a position, given in voxels relative to the first position.
 */
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

  /** Projects a position onto the line. Returns false if the line ends there. */
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
  double Voxel = 1.0; ///< edge length of a voxel (m)
  Vector3 Direction;  ///< last direction read, which fixes the sign of an eigenvector
  int Steps = 0;
  bool IsClosed = false;
  bool IsAtEnd = false;

protected:
  LineFunction()
  {
    this->NumFuncs = 3;
    this->NumIndepVars = 4; // x, y, z and time
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

/** Integrates LineFunction instead of the vectors that the tracer would interpolate. */
class LineIntegrator : public vtkRungeKutta4
{
public:
  static LineIntegrator* New();

  void SetFunctionSet(vtkFunctionSet*) override { this->Superclass::SetFunctionSet(this->Line); }

  using Superclass::ComputeNextStep;
  int ComputeNextStep(double* from, double* derivatives, double* to, double t, double& step,
    double& taken, double least, double most, double allowed, double& error, void* data) override
  {
    // Keep the step that reaches the end, because it still belongs to the line.
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
  /** Copies the line to the instance that vtkStreamTracer creates for the integration. */
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

/**
 * Makes a single cell around the origin, with a unit vector at each point, as the tracer's data
 * set.
 */
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

/**
 * Computes the points (m) of a line, up to `reach` voxels of length `voxel` (m) to either side of
 * where it was found; only one point if the line is too short. A closed line ends where it begins.
 * Call this on the GUI thread.
 *
 * The tracer's integrator, vtkRungeKutta4, calls a function that returns the directions that the
 * servo reads, in steps of half a voxel. It does not interpolate an array of the volume, for two
 * reasons. First, the servo does not interpolate trilinearly: after 24 voxels along a flow with
 * waves of 12 voxels, a line traced that way is up to 0.36 voxel off, and this line 0.003 voxel.
 * Second, tensors have no vectors, and ridges and guides have no array. The tracer's data set is
 * therefore a single cell around the position, in voxels relative to it. It is as large as lines
 * may become, whatever the volume's size. vtkHyperStreamline is not used, because it accepts no
 * function and makes tubes.
 */
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

constexpr int FrontCorners = 48;
/** Radius of a front's patch, as a fraction of the reach along lines. */
constexpr double FrontFraction = 0.25;
/** Length of a tensor glyph, as a fraction of the reach along lines. */
constexpr double TensorFraction = 0.125;

class ShapeWriter
{
public:
  explicit ShapeWriter(const HapticModel& model)
    : Model(model)
  {
    this->Points->SetDataTypeToDouble();
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Modes->SetName("Mode");
    this->Tensors->SetName("Tensors");
    this->Tensors->SetNumberOfComponents(9);
  }

  /** Adds a tensor, scaled so that its first eigenvalue equals a length (m). */
  void AddTensor(const FollowedShape& shape, double length)
  {
    this->Places->InsertNextCell(1);
    this->Places->InsertCellPoint(this->AddPoint(shape.Centre, {}));
    const double world = length * std::cbrt(Determinant(this->Model.DeviceToWorld.Linear));
    const Matrix3 tensor = world * shape.Tensor;
    const double nine[9] = { tensor.Row[0].X, tensor.Row[0].Y, tensor.Row[0].Z, tensor.Row[1].X,
      tensor.Row[1].Y, tensor.Row[1].Z, tensor.Row[2].X, tensor.Row[2].Y, tensor.Row[2].Z };
    this->Tensors->SetTuple(this->Tensors->GetNumberOfTuples() - 1, nine);
    this->Modes->InsertNextValue(shape.Mode);
  }

  void AddLine(int mode, const std::vector<Vector3>& line)
  {
    this->Lines->InsertNextCell(static_cast<vtkIdType>(line.size()));
    for (const Vector3& place : line)
    {
      this->Lines->InsertCellPoint(this->AddPoint(place, {}));
    }
    this->Modes->InsertNextValue(mode);
  }

  void AddFront(const FollowedShape& shape, double radius)
  {
    const Vector3& n = shape.Direction;
    const Vector3 a = UnitAcross(n);
    const Vector3 b = Cross(n, a);
    constexpr double turn = 6.283185307179586 / FrontCorners;
    this->Fronts->InsertNextCell(FrontCorners);
    for (int i = 0; i < FrontCorners; ++i)
    {
      const Vector3 corner = std::cos(turn * i) * a + std::sin(turn * i) * b;
      this->Fronts->InsertCellPoint(this->AddPoint(shape.Centre + radius * corner, n));
    }
    this->Modes->InsertNextValue(shape.Mode);
  }

  void WriteTo(vtkPolyData* shapes)
  {
    shapes->Initialize();
    shapes->SetPoints(this->Points);
    shapes->SetVerts(this->Places);
    shapes->SetLines(this->Lines);
    shapes->SetPolys(this->Fronts);
    shapes->GetPointData()->SetNormals(this->Normals);
    if (this->Places->GetNumberOfCells() > 0)
    {
      shapes->GetPointData()->SetTensors(this->Tensors);
    }
    shapes->GetCellData()->AddArray(this->Modes);
  }

private:
  vtkIdType AddPoint(const Vector3& place, const Vector3& normal)
  {
    const Vector3 world = this->Model.DeviceToWorld(place);
    const Vector3 turned = this->Model.DeviceToWorldRotation * normal;
    constexpr double none[9] = {};
    this->Normals->InsertNextTuple3(turned.X, turned.Y, turned.Z);
    this->Tensors->InsertNextTuple(none);
    return this->Points->InsertNextPoint(world.X, world.Y, world.Z);
  }

  const HapticModel& Model;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Normals;
  vtkNew<vtkIntArray> Modes;
  vtkNew<vtkDoubleArray> Tensors;
  vtkNew<vtkCellArray> Places; ///< vertices at the tensors' positions
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Fronts;
};

} // namespace

void WriteFollowed(
  const HapticModel& model, const Vector3& proxy, double reach, vtkPolyData* shapes)
{
  FollowedShapes modes(model);
  const std::vector<FollowedShape> found = modes.Collect(proxy);
  ShapeWriter writer(model);
  // vtkPolyData numbers its cells with vertices first, then lines, then polygons; fill the array in
  // this order.
  const double voxel = 1.0 / model.MostVoxelsPerMeter;
  for (const FollowedShape& shape : found)
  {
    if (shape.Form == FollowedForm::Tensor)
    {
      writer.AddTensor(shape, TensorFraction * reach * voxel);
    }
  }
  for (const FollowedShape& shape : found)
  {
    if (shape.Form == FollowedForm::Line)
    {
      const std::vector<Vector3> line = TraceFollowedLine(modes, shape, voxel, reach);
      if (line.size() > 1)
      {
        writer.AddLine(shape.Mode, line);
      }
    }
  }
  for (const FollowedShape& shape : found)
  {
    if (shape.Form == FollowedForm::Front)
    {
      writer.AddFront(shape, FrontFraction * reach * voxel);
    }
  }
  writer.WriteTo(shapes);
}

} // namespace VolumeHaptics
