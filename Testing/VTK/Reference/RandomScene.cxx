// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RandomScene.h"

#include <vtkDataArray.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>

#include <algorithm>

namespace reference
{
static const int ScalarTypes[] = { VTK_DOUBLE, VTK_FLOAT, VTK_SHORT, VTK_UNSIGNED_CHAR,
  VTK_UNSIGNED_SHORT, VTK_INT };

Field RandomField(Random& random, const Geometry& geometry, double shortest)
{
  struct Wave
  {
    Vec3 direction;
    double phase;
  };
  const double size = std::min({ geometry.spacing[0], geometry.spacing[1], geometry.spacing[2] });
  std::vector<Wave> waves(5);
  for (Wave& wave : waves)
  {
    const double length = size * shortest * random.Uniform(1.0, 5.0);
    wave = { (6.283185307179586 / length) * random.UnitVector(), random.Uniform(0.0, 6.3) };
  }
  return [waves](const Vec3& world)
  {
    double sum = 0.0;
    for (const Wave& wave : waves)
    {
      sum += std::sin(Dot(wave.direction, world) + wave.phase) / waves.size();
    }
    return sum;
  };
}

Geometry RandomGeometry(Random& random, int kernelRadius)
{
  Geometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.extent[2 * axis] = random.Chance(0.5) ? random.Integer(-7, 7) : 0;
    geometry.extent[2 * axis + 1] =
      geometry.extent[2 * axis] + 2 * kernelRadius + random.Integer(6, 14);
    geometry.spacing[axis] = random.Uniform(0.4, 2.5);
    geometry.origin[axis] = random.Uniform(-100.0, 100.0);
  }
  if (random.Chance(0.75))
  {
    geometry.direction = random.Rotation(random.Chance(0.5));
  }
  return geometry;
}

vtkDataArray* FeltScalars(const Scene& scene)
{
  vtkPointData* pointData = scene.image->GetPointData();
  return scene.arrayName.empty() ? pointData->GetScalars()
                                 : pointData->GetArray(scene.arrayName.c_str());
}

void RandomVolume(
  Scene& scene, Random& random, const Geometry& geometry, int scalarType, double shortest)
{
  const Field smooth = RandomField(random, geometry, shortest);
  const double noise = random.Chance(0.5) ? 0.03 : 0.0;
  const bool isUnsigned = scalarType == VTK_UNSIGNED_CHAR || scalarType == VTK_UNSIGNED_SHORT;
  const double amplitude = scalarType == VTK_UNSIGNED_CHAR ? 160.0 : 1000.0;
  const double offset = isUnsigned ? 0.6 * amplitude : random.Uniform(-300.0, 300.0);
  // Clamping the field occasionally makes a uniform region, in which the gradient vanishes.
  const Field field = [&](const Vec3& world)
  {
    return std::max(offset - 0.6 * amplitude, offset + amplitude * smooth(world)) +
      amplitude * noise * random.Normal();
  };
  scene.image = MakeImage(geometry);
  const int components = random.Chance(0.4) ? random.Integer(2, 4) : 1;
  scene.component = random.Integer(0, components - 1);
  scene.image->AllocateScalars(scalarType, components);
  // Keep a reference, because SetScalars() below releases the array that was active.
  const vtkSmartPointer<vtkDataArray> scalars = scene.image->GetPointData()->GetScalars();
  for (int component = 0; component < components; ++component)
  {
    Fill(
      scalars, component, geometry,
      component == scene.component ? field
                                   : [&](const Vec3&) { return random.Uniform(0.0, 99.0); });
  }
  if (random.Chance(0.3))
  {
    scene.arrayName = "Felt";
    scalars->SetName("Felt");
    vtkSmartPointer<vtkDataArray> decoy =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_FLOAT));
    decoy->SetName("Decoy");
    decoy->SetNumberOfTuples(scene.image->GetNumberOfPoints());
    decoy->FillComponent(0, 1.0);
    scene.image->GetPointData()->SetScalars(decoy);
    scene.image->GetPointData()->AddArray(scalars);
  }
}

static void RandomFunction(vtkPiecewiseFunction* function, Random& random, Curves curves,
  double low, double high, double least, double most)
{
  function->RemoveAllPoints();
  const int points = random.Integer(1, 6);
  double x = low;
  for (int i = 0; i < points; ++i)
  {
    const double y = random.Chance(0.1) ? least : random.Uniform(least, most);
    const bool curved = curves == Curves::Curved;
    const double midpoint = curved ? random.Uniform(0.1, 0.9) : 0.5;
    const double sharpness = curved ? (random.Chance(0.15) ? 1.0 : random.Uniform(0.0, 1.0)) : 0.0;
    function->AddPoint(x, y, midpoint, sharpness);
    const bool steep = random.Chance(0.2);
    x += (high - low) * (steep ? 1e-3 : random.Uniform(0.05, 0.5));
  }
}

void RandomMaterial(Scene& scene, Random& random, Curves curves)
{
  double range[2];
  FeltScalars(scene)->GetRange(range, scene.component);
  const double* s = scene.image->GetSpacing();
  const double steepest = 0.2 * (range[1] - range[0]) / std::min({ s[0], s[1], s[2] });
  vtkHapticProperty* p = scene.property;
  // The error of a table is relative to the height of a function's piece. So curves don't start at
  // zero, where this error would be a large part of the stiffness, and don't reach a million
  // newtons either.
  const double floor = curves == Curves::Linear && random.Chance(0.2) ? 0.0 : 50.0;
  const bool huge = curves == Curves::Linear && random.Chance(0.1);
  RandomFunction(p->GetStiffness(), random, curves, range[0], range[1], floor, 1500.0);
  RandomFunction(p->GetFriction(), random, curves, range[0], range[1], 0.0, 0.8);
  RandomFunction(p->GetViscosity(), random, curves, range[0], range[1], 0.0, 0.5);
  RandomFunction(
    p->GetSurfaceStrength(), random, curves, range[0], range[1], 0.0, huge ? 1e6 : 3.0);
  vtkPiecewiseFunction* distinctness = p->GetDistinctness();
  RandomFunction(distinctness, random, curves, 0.0, steepest, 0.0, 1.0);
}

static void Ramp(vtkPiecewiseFunction* function, double x0, double y0, double x1, double y1)
{
  function->RemoveAllPoints();
  function->AddPoint(x0, y0);
  function->AddPoint(x1, y1);
}

void GentleMaterial(Scene& scene, double low, double high)
{
  Ramp(scene.property->GetStiffness(), low, 500.0, high, 700.0);
  Ramp(scene.property->GetFriction(), low, 0.4, high, 0.2);
  Ramp(scene.property->GetViscosity(), low, 0.1, high, 0.15);
  Ramp(scene.property->GetSurfaceStrength(), low, 0.3, high, 0.5);
  const double* s = scene.image->GetSpacing();
  const double slope = 0.1 * (high - low) / std::max({ s[0], s[1], s[2] });
  Ramp(scene.property->GetDistinctness(), 0.1 * slope, 0.1, slope, 1.0);
}

void RandomWalk(Scene& scene, Random& random, const Geometry& geometry, int ticks)
{
  const Vec3 centre = geometry.Centre();
  const double size = std::min({ geometry.spacing[0], geometry.spacing[1], geometry.spacing[2] });
  Vec3 edge;
  for (int axis = 0; axis < 3; ++axis)
  {
    edge[axis] = geometry.extent[2 * axis];
  }
  const double leash = 1.0 * Norm(geometry.World(edge) - centre);
  const double speed = size * random.Uniform(0.03, 0.4);
  Vec3 tip = centre + random.Uniform(0.0, 0.5) * leash * random.UnitVector();
  Vec3 velocity = speed * random.UnitVector();
  scene.path.clear();
  for (int tick = 0; tick < ticks; ++tick)
  {
    scene.path.push_back(tip);
    const Vec3 home = (1.0 / leash) * (centre - tip);
    velocity = 0.95 * velocity + 0.3 * speed * random.UnitVector() +
      (Norm(home) > 0.7 ? 0.2 * speed : 0.0) * home;
    tip = tip + velocity + (random.Chance(0.02) ? 3.0 * size : 0.0) * random.UnitVector();
  }
}

std::vector<Vec3> WithStops(const std::vector<Vec3>& path)
{
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    result.insert(result.end(), i % 30 == 29 ? 20 : 1, path[i]);
  }
  return result;
}

void ConstantStiffness(Scene& scene, Random& random)
{
  vtkPiecewiseFunction* const stiffness = scene.property->GetStiffness();
  stiffness->RemoveAllPoints();
  stiffness->AddPoint(0.0, random.Uniform(50.0, 2000.0));
}

void RandomScene(Scene& scene, Random& random, Curves curves, int ticks)
{
  scene.kernelRadius = random.Integer(1, 4);
  scene.estimator = AllEstimators[random.Integer(0, 2)];
  scene.side = Side(random.Integer(0, 2));
  const Geometry geometry = RandomGeometry(random, scene.kernelRadius);
  RandomVolume(scene, random, geometry, ScalarTypes[random.Integer(0, 5)]);
  RandomMaterial(scene, random, curves);
  scene.metersPerWorldUnit = random.Chance(0.5) ? 0.001 : random.Uniform(0.0003, 0.005);
  scene.servoRate = random.Chance(0.5) ? 1000.0 : random.Uniform(500.0, 4000.0);
  RandomWalk(scene, random, geometry, ticks);
}

Geometry GentleScene(Scene& scene, Random& random, int ticks)
{
  const Geometry geometry = RandomGeometry(random, scene.kernelRadius);
  scene.image = Sample(geometry, RandomField(random, geometry, 30.0));
  GentleMaterial(scene, -1.0, 1.0);
  RandomWalk(scene, random, geometry, ticks);
  return geometry;
}

void MoveScene(
  Scene& scene, const Geometry& geometry, const Mat3& rotation, const Vec3& translation)
{
  const vtkSmartPointer<vtkImageData> moved = MakeImage(Moved(geometry, rotation, translation));
  moved->GetPointData()->ShallowCopy(scene.image->GetPointData());
  scene.image = moved;
  for (Vec3& point : scene.path)
  {
    point = rotation * point + translation;
  }
}
} // namespace reference
