// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticSurface.h"

#include "Core/Field/Estimates/IsoMotion.h"
#include "Core/Math/Vector3.h"
#include "VTK/Base/HapticNoise.h"
#include "VTK/Base/HapticTuples.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/SampleRange.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Largest allowed coordinate, because bounding boxes have single precision. */
constexpr double FarthestPoint = 1e30;
///@{
/** Cost of meshing on a desktop computer of 2023, including the time to build the search tree. */
constexpr double SecondsPerSample = 5e-9;
constexpr double SecondsPerTriangle = 800e-9;
///@}
/** Time (s) that is longer than any meshing, for waiting until it ends. */
constexpr double Forever = 1e9;

/**
 * Function that computes the motions of points in the world; returns none if the mesh does not
 * move.
 */
using MotionsOf = std::function<std::vector<Vector3>(const std::vector<Vector3>&)>;

/** Makes a mesh of a triangulated surface. `map` maps its points, `mapNormals` its normals. */
std::shared_ptr<const SurfaceMesh> MakeMesh(vtkPolyData* surface, const Affine3& map,
  const Matrix3& mapNormals, const MotionsOf& findMotions = {})
{
  const vtkIdType count = surface->GetNumberOfPoints();
  vtkDataArray* const wanted = surface->GetPointData()->GetNormals();
  vtkDataArray* const normals =
    wanted && wanted->GetNumberOfComponents() == 3 && wanted->GetNumberOfTuples() == count
    ? wanted
    : nullptr;
  std::vector<Vector3> points(count);
  std::vector<Vector3> directions(normals ? count : 0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points[i] = map(ReadVector(surface->GetPoints()->GetData(), i));
    if (normals)
    {
      const Vector3 direction = mapNormals * ReadVector(normals, i);
      const double length = Norm(direction);
      directions[i] = length > 0.0 ? (1.0 / length) * direction : Vector3{};
    }
  }
  std::vector<SurfaceMesh::Indices> triangles;
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* corners;
    cells->GetCurrentCell(size, corners);
    if (size == 3)
    {
      triangles.push_back({ static_cast<std::int32_t>(corners[0]),
        static_cast<std::int32_t>(corners[1]), static_cast<std::int32_t>(corners[2]) });
    }
  }
  std::vector<Vector3> motions = findMotions ? findMotions(points) : std::vector<Vector3>();
  return std::make_shared<SurfaceMesh>(
    std::move(points), triangles, std::move(directions), std::move(motions));
}

std::shared_ptr<const SurfaceMesh> MeshOf(vtkPolyData* surface, std::string& error)
{
  return MeshSurface(surface, "The surface on input port 2",
    "Connect a vtkPolyData with polygons or strips, or nothing to touch the isosurface at "
    "IsoValue.",
    error);
}

/** An isosurface with a reference to its scalars, so that a worker can mesh it independently. */
struct IsoInput
{
  IsoInput(const IsoSurface& iso, const Affine3& indexToWorld)
    : Scalars(iso.Scalars)
    , Component(iso.Component)
    , Value(iso.Value)
    , IndexToWorld(indexToWorld)
  {
    // Use the samples' indices in the whole volume, so that the mesh of a region is bit-identical
    // to the mesh of the whole volume.
    for (int a = 0; a < 3; ++a)
    {
      this->Extent[2 * a] = iso.First[a];
      this->Extent[2 * a + 1] = iso.First[a] + iso.Image->GetDimensions()[a] - 1;
    }
  }

  vtkSmartPointer<vtkDataArray> Scalars;
  int Component;
  double Value;
  Affine3 IndexToWorld;
  int Extent[6];

  std::shared_ptr<const SurfaceMesh> MakeMesh() const
  {
    return MeshIsoSurface(
      this->Scalars, this->Extent, this->Component, this->Value, this->IndexToWorld);
  }
};

/**
 * Copies a surface for a worker. The copy shares the points, the normals and the cells' memory. Its
 * cell arrays have their own cursors, so that two threads can traverse the cells. The vtkPoints
 * object is shared, because wrapping its array in a second vtkPoints would modify the array.
 */
vtkSmartPointer<vtkPolyData> ShareSurface(vtkPolyData* surface)
{
  auto shared = vtkSmartPointer<vtkPolyData>::New();
  shared->SetPoints(surface->GetPoints());
  ShareCells(surface, shared);
  shared->GetPointData()->SetNormals(surface->GetPointData()->GetNormals());
  return shared;
}

bool MayBeShared(vtkPolyData* surface)
{
  vtkDataArray* const normals = surface->GetPointData()->GetNormals();
  return surface->GetPoints() && surface->GetPoints()->GetData()->HasStandardMemoryLayout() &&
    (!normals || normals->HasStandardMemoryLayout());
}

/**
 * Computes the range of the scalars. Returns whether it is exact; in a large volume, only the
 * samples of the noise estimate are read.
 */
bool ComputeScalarRange(const IsoSurface& iso, double range[2])
{
  VolumeView view;
  vtkSmartPointer<vtkDataArray> holder;
  if (!LocateSamples(iso.Scalars, iso.Component, iso.Image->GetDimensions(), view, holder) ||
    !IsLargeVolume(view.Dimensions))
  {
    ComputeFiniteRange(iso.Scalars, iso.Component, range);
    return true;
  }
  std::copy_n(EstimateImageNoise(iso.Image, iso.Scalars, view, iso.Component).Range, 2, range);
  return false;
}

/**
 * Returns the mesh of an isosurface if it can be touched. Returns an empty mesh if there is none
 * and none is required. Otherwise returns null and sets `error`.
 */
std::shared_ptr<const SurfaceMesh> CheckMesh(
  const std::shared_ptr<const SurfaceMesh>& mesh, const IsoSurface& iso, std::string& error)
{
  if (iso.MayBeEmpty && !mesh)
  {
    return std::make_shared<SurfaceMesh>(
      std::vector<Vector3>(), std::vector<SurfaceMesh::Indices>(), std::vector<Vector3>());
  }
  if (!mesh || mesh->GetNumberOfTriangles() == 0)
  {
    double range[2];
    const bool isExact = ComputeScalarRange(iso, range);
    std::ostringstream message;
    message << "There is no isosurface at the IsoValue " << iso.Value
            << " of vtkVolumeHapticsFilter: the scalars of the input image go from " << range[0]
            << " to " << range[1] << (isExact ? "" : ", as far as some samples of them tell")
            << ". SetIsoValue() to a value between them, or connect a surface to input port 2.";
    error = message.str();
    return nullptr;
  }
  return mesh;
}

/** Estimates the number of triangles of an isosurface: two in each voxel that it crosses. */
double EstimateTriangles(const IsoSurface& iso)
{
  constexpr int looks = 20000; // number of samples; reading them takes a few milliseconds
  // Steps of a low-discrepancy sequence, which covers any image evenly: powers of 1 / 1.2207...,
  // where 1.2207... is the root of x^4 = x + 1.
  constexpr double steps[3] = { 0.8191725133961645, 0.6710436067037893, 0.5497004779019703 };
  const int* const n = iso.Image->GetDimensions();
  const vtkIdType rows[3] = { 1, n[0], vtkIdType{ n[0] } * n[1] };
  if (std::min({ n[0], n[1], n[2] }) < 2 ||
    iso.Scalars->GetNumberOfTuples() < iso.Image->GetNumberOfPoints() ||
    iso.Component >= iso.Scalars->GetNumberOfComponents())
  {
    return 0.0; // the meshing reports the error
  }
  int passed = 0;
  double at[3] = { 0.0, 0.0, 0.0 };
  for (int look = 0; look < looks; ++look)
  {
    vtkIdType first = 0;
    for (int a = 0; a < 3; ++a)
    {
      at[a] += steps[a];
      at[a] -= std::floor(at[a]);
      first += rows[a] * static_cast<vtkIdType>(at[a] * (n[a] - 1));
    }
    int inside = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const vtkIdType place = first + (corner & 1 ? rows[0] : 0) + (corner & 2 ? rows[1] : 0) +
        (corner & 4 ? rows[2] : 0);
      inside += iso.Scalars->GetComponent(place, iso.Component) >= iso.Value;
    }
    passed += inside != 0 && inside != 8;
  }
  return 2.0 * passed / looks * static_cast<double>(iso.Image->GetNumberOfPoints());
}

/** Meshes an isosurface, and computes the motion of its points if `findMotions` is set. */
std::shared_ptr<const SurfaceMesh> MeshMovingSurface(vtkDataArray* scalars, const int extent[6],
  int component, double value, const Affine3& indexToWorld, const MotionsOf& findMotions)
{
  // Mesh in index coordinates; the geometry of the whole image maps the points to the world
  // afterwards.
  vtkNew<vtkImageData> samples;
  samples->SetExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
  samples->GetPointData()->SetScalars(scalars);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(samples);
  edges->SetArrayComponent(component);
  edges->SetValue(0, value);
  edges->ComputeNormalsOn();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfPoints() > 0
    ? MakeMesh(
        edges->GetOutput(), indexToWorld, Transpose(Inverse(indexToWorld.Linear)), findMotions)
    : nullptr;
}

} // namespace

std::shared_ptr<const SurfaceMesh> MeshSurface(
  vtkPolyData* surface, const std::string& name, const std::string& cure, std::string& error)
{
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const Vector3 point = ReadVector(surface->GetPoints()->GetData(), i);
    if (!(Norm(point) < FarthestPoint))
    {
      error = name + " has a coordinate that is NaN, infinite or beyond 1e30 at point " +
        std::to_string(i) + ". Replace or remove that point.";
      return nullptr;
    }
  }
  for (vtkCellArray* cells : { surface->GetPolys(), surface->GetStrips() })
  {
    // Compute the range without GetRange(), which would cache it in the array while another thread
    // may read it.
    vtkDataArray* const ids = cells->GetConnectivityArray();
    const vtkIdType count = cells->GetNumberOfConnectivityIds();
    double least = 0.0;
    double most = 0.0;
    for (vtkIdType i = 0; i < count; ++i)
    {
      least = std::min(least, ids->GetComponent(i, 0));
      most = std::max(most, ids->GetComponent(i, 0));
    }
    if (least < 0.0 || (most > 0.0 && most >= static_cast<double>(surface->GetNumberOfPoints())))
    {
      error =
        name + " has a cell with a point that does not exist. Correct its polygons and strips.";
      return nullptr;
    }
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->SetInputData(surface);
  triangles->Update();
  const auto mesh = surface->GetNumberOfPoints() > 0
    ? MakeMesh(triangles->GetOutput(), Affine3{}, Matrix3{})
    : nullptr;
  if (!mesh || mesh->GetNumberOfTriangles() == 0)
  {
    error = name + " has no triangles to touch. " + cure;
    return nullptr;
  }
  return mesh;
}

void ShareCells(vtkPolyData* from, vtkPolyData* to)
{
  const vtkNew<vtkCellArray> polygons;
  polygons->ShallowCopy(from->GetPolys());
  to->SetPolys(polygons);
  const vtkNew<vtkCellArray> strips;
  strips->ShallowCopy(from->GetStrips());
  to->SetStrips(strips);
}

double EstimateMeshTime(const IsoSurface& iso)
{
  return SecondsPerSample * static_cast<double>(iso.Image->GetNumberOfPoints()) +
    SecondsPerTriangle * EstimateTriangles(iso);
}

std::shared_ptr<const SurfaceMesh> MeshIsoSurface(vtkDataArray* scalars, const int extent[6],
  int component, double value, const Affine3& indexToWorld)
{
  return MeshMovingSurface(scalars, extent, component, value, indexToWorld, {});
}

std::shared_ptr<const SurfaceMesh> MeshTimeStep(const VolumeTimeStep& timeStep,
  const VolumeTimeStep& next, int component, double value, const Affine3& indexToWorld)
{
  int extent[6];
  for (int a = 0; a < 3; ++a)
  {
    extent[2 * a] = static_cast<int>(timeStep.View.First[a]);
    extent[2 * a + 1] = static_cast<int>(timeStep.View.Last(a));
  }
  // Samples owns its vtkDataArray: see ShareArray() of the model's builder.
  auto* const scalars = static_cast<vtkDataArray*>(const_cast<void*>(timeStep.Samples.get()));
  // A series has no displacements from its last time step back to its first.
  const DisplacementView known =
    timeStep.Time < next.Time ? timeStep.Displacements : DisplacementView{};
  auto mesh = MeshMovingSurface(scalars, extent, component, value, indexToWorld,
    [&](const std::vector<Vector3>& points) {
      return MeasureIsoMotions(points, value, { timeStep.View, next.View, known, indexToWorld });
    });
  return mesh ? mesh
              : std::make_shared<const SurfaceMesh>(std::vector<Vector3>(),
                  std::vector<SurfaceMesh::Indices>(), std::vector<Vector3>());
}

HapticSurface::Made HapticSurface::Make(vtkPolyData* surface)
{
  Made made;
  made.Mesh = MeshOf(surface, made.Error);
  return made;
}

HapticSurface::Key HapticSurface::MakeKey(vtkPolyData* surface, const IsoSurface& iso)
{
  return surface
    ? Key{ surface, nullptr, surface->GetMTime(), 0.0, 0 }
    : Key{ iso.Image, iso.Scalars, std::max(iso.Image->GetMTime(), iso.Scalars->GetMTime()),
        iso.Value, iso.Component };
}

double HapticSurface::EstimateTime(vtkPolyData* surface, const IsoSurface& iso) const
{
  const Key key = MakeKey(surface, iso);
  if (this->IsMadeOf(key) || (this->Meshing.IsOf(key) && !this->Meshing.IsUnderWay()))
  {
    return 0.0;
  }
  return surface ? SecondsPerTriangle * static_cast<double>(surface->GetNumberOfCells())
                 : EstimateMeshTime(iso);
}

bool HapticSurface::Prepare(
  vtkPolyData* surface, const IsoSurface& iso, const Affine3& indexToWorld)
{
  const Key key = MakeKey(surface, iso);
  if (this->Meshing.IsOf(key))
  {
    return !this->Meshing.IsUnderWay();
  }
  // Skip even the few samples of the estimate if the image is large.
  const double reading =
    surface ? 0.0 : SecondsPerSample * static_cast<double>(iso.Image->GetNumberOfPoints());
  // For other memory layouts, VTK keeps one copy of the values that all reading threads share.
  const bool isShared =
    surface ? MayBeShared(surface) : iso.Scalars->HasStandardMemoryLayout() != 0;
  if (this->IsMadeOf(key) || !isShared ||
    (reading <= ShortMeshing && this->EstimateTime(surface, iso) <= ShortMeshing))
  {
    this->Meshing.Abandon();
    return true;
  }
  if (this->Meshing.IsUnderWay())
  {
    this->Meshing.Abandon();
    return false;
  }
  std::function<Made()> make;
  if (surface)
  {
    make = [shared = ShareSurface(surface)] { return Make(shared); };
  }
  else
  {
    make = [input = IsoInput(iso, indexToWorld)] { return Made{ input.MakeMesh(), {} }; };
  }
  this->Meshing.Poll(key,
    [make = std::move(make)](WorkMonitor& monitor) -> std::optional<Made>
    {
      Made made = make();
      return monitor.IsCancelled() ? std::nullopt : std::optional<Made>(std::move(made));
    });
  return false;
}

void HapticSurface::Give(const IsoSurface& iso, MeshPointer mesh)
{
  this->Given = std::move(mesh);
  this->GivenOf = MakeKey(nullptr, iso);
}

std::shared_ptr<const SurfaceMesh> HapticSurface::Get(
  vtkPolyData* surface, const IsoSurface& iso, const Affine3& indexToWorld, std::string& error)
{
  const Key key = MakeKey(surface, iso);
  if (this->IsMadeOf(key))
  {
    return this->Mesh;
  }
  if (key == this->GivenOf)
  {
    return CheckMesh(this->Given, iso, error);
  }
  if (this->Meshing.IsOf(key))
  {
    this->Meshing.WaitFor(Forever);
  }
  const Made* const known = this->Meshing.Find(key);
  const Made made = known ? *known
    : surface             ? Make(surface)
                          : Made{ IsoInput(iso, indexToWorld).MakeMesh(), {} };
  error = made.Error;
  this->Mesh = surface ? made.Mesh : CheckMesh(made.Mesh, iso, error);
  if (this->Meshing.IsOf(key))
  {
    this->Meshing.Forget();
  }
  this->MadeOf = key;
  return this->Mesh;
}

} // namespace VolumeHaptics
