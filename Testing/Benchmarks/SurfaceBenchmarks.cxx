// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"
#include "Core/Model/SurfaceMesh.h"
#include "Motion.h"

#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <benchmark/benchmark.h>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

/** Returns a mesh by vtkFlyingEdges3D of the level along which the tip slides. */
std::shared_ptr<const SurfaceMesh> MakeMesh(const BallVolume& volume)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(volume.Image);
  contour->SetValue(0, BallLevel);
  contour->ComputeNormalsOn();
  contour->Update();
  vtkPolyData* const surface = contour->GetOutput();
  vtkDataArray* const normals = surface->GetPointData()->GetNormals();
  std::vector<Vector3> points;
  std::vector<Vector3> directions;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    surface->GetPoint(i, x);
    points.push_back({ x[0], x[1], x[2] });
    normals->GetTuple(i, x);
    directions.push_back({ x[0], x[1], x[2] });
  }
  std::vector<SurfaceMesh::Indices> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    surface->GetCellPoints(i, ids);
    triangles.push_back({ static_cast<std::int32_t>(ids->GetId(0)),
      static_cast<std::int32_t>(ids->GetId(1)), static_cast<std::int32_t>(ids->GetId(2)) });
  }
  return std::make_shared<const SurfaceMesh>(points, triangles, directions);
}

/** Measures ticks in contact for several rounds. */
void MeasureRounds(benchmark::State& bench, const BallVolume& volume, const ModelChoice& choice)
{
  const auto model = MakeModel(volume, GetEstimators()[2], choice);
  const Positions tips = Slide(volume).Tips;
  ServoState state;
  TickRecord record;
  // Move from outside to the beginning of the slide.
  const Vector3 centre = 0.001 * volume.GetCentre();
  constexpr int approach = 200;
  for (int i = 0; i <= approach; ++i)
  {
    const double share = 1.0 + 0.05 * (1.0 - static_cast<double>(i) / approach);
    Tick(*model, state, centre + share * (tips.front() - centre), record);
  }
  Cycle tip(tips);
  for (auto _ : bench)
  {
    Tick(*model, state, tip.Next(), record);
    benchmark::DoNotOptimize(record);
  }
  // Run one more round, and count the sliding ticks: the proxy may stick to the edges of flat
  // triangles in single ticks.
  std::size_t sliding = 0;
  for (std::size_t i = 0; i < tips.size(); ++i)
  {
    Tick(*model, state, tip.Next(), record);
    sliding += record.Contact == ContactState::Sliding ? 1 : 0;
  }
  if (10 * sliding < 9 * tips.size())
  {
    bench.SkipWithError("the proxy does not slide");
  }
  bench.counters["triangles"] =
    choice.Mesh ? static_cast<double>(choice.Mesh->GetNumberOfTriangles()) : 0.0;
}

} // namespace

void RegisterSurfaceBenchmarks(const BallVolume& volume)
{
  ModelChoice choice;
  choice.Method = HapticMethod::SurfaceProxy;
  choice.Mesh = MakeMesh(volume);
  for (const bool isShaded : { true, false })
  {
    choice.ForceShading = isShaded;
    benchmark::RegisterBenchmark(
      NameOf("surface_tick", isShaded ? "shaded" : "flat", "slide", volume.Name).c_str(),
      MeasureRounds, volume, choice);
  }
  choice.Method = HapticMethod::LocalSurface;
  choice.Mesh = nullptr;
  for (const bool isQuadric : { false, true })
  {
    choice.LocalShape = isQuadric ? LocalSurfaceShape::Quadric : LocalSurfaceShape::Plane;
    benchmark::RegisterBenchmark(
      NameOf("local_surface_tick", isQuadric ? "quadric" : "plane", "slide", volume.Name).c_str(),
      MeasureRounds, volume, choice);
  }
}

} // namespace benchmarks
