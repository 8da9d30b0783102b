// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Measure/PaintedPatch.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Base/HapticVolume.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkClipPolyData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkGenericCell.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataConnectivityFilter.h"
#include "vtkStaticPointLocator.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace VolumeHaptics
{
namespace
{

constexpr int BlockSize = 8; ///< voxels along each axis of a block
/** Largest distance (voxels), in addition to the radius, between hand and surface for painting. */
constexpr double Reach = 3.0;

/** Returns the squared distance from a position to the line segment between two other positions. */
double SquaredDistance(const Vector3& position, const Vector3& from, const Vector3& to)
{
  const Vector3 line = to - from;
  const double length = Dot(line, line);
  const double along =
    length > 0.0 ? std::clamp(Dot(position - from, line) / length, 0.0, 1.0) : 0.0;
  const Vector3 away = position - from - along * line;
  return Dot(away, away);
}

} // namespace

PaintedPatch::PaintedPatch(
  vtkImageData* image, vtkDataArray* scalars, int component, double value, double radius)
  : Scalars(scalars)
  , Component(component)
  , Value(value)
  , Radius(radius)
{
  this->Image->CopyStructure(image);
  this->Voxel = SmallestSpacing(image);
}

PaintedPatch::~PaintedPatch() = default;

bool PaintedPatch::IsOf(vtkImageData* image) const
{
  return image && std::equal(image->GetExtent(), image->GetExtent() + 6, this->Image->GetExtent());
}

template <typename F>
void PaintedPatch::Visit(const Vector3& from, const Vector3& to, double distance, F&& visit)
{
  // Compute the bounding box of the balls around both positions, in index coordinates.
  double least[3];
  double most[3];
  std::fill_n(least, 3, std::numeric_limits<double>::max());
  std::fill_n(most, 3, std::numeric_limits<double>::lowest());
  for (const Vector3& centre : { from, to })
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const double world[3] = { centre.X + (corner & 1 ? distance : -distance),
        centre.Y + (corner & 2 ? distance : -distance),
        centre.Z + (corner & 4 ? distance : -distance) };
      double index[3];
      this->Image->TransformPhysicalPointToContinuousIndex(world, index);
      for (int a = 0; a < 3; ++a)
      {
        least[a] = std::min(least[a], index[a]);
        most[a] = std::max(most[a], index[a]);
      }
    }
  }
  const int* const extent = this->Image->GetExtent();
  int first[3];
  int last[3];
  for (int a = 0; a < 3; ++a)
  {
    const double lowest = extent[2 * a];
    const double highest = extent[2 * a + 1] - 1;
    first[a] =
      static_cast<int>(std::floor((std::clamp(least[a], lowest, highest) - lowest) / BlockSize));
    last[a] =
      static_cast<int>(std::floor((std::clamp(most[a], lowest, highest) - lowest) / BlockSize));
  }
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        visit(this->Get({ i, j, k }));
      }
    }
  }
}

PaintedPatch::Part& PaintedPatch::Get(const Block& block)
{
  const auto found = this->Parts.find(block);
  if (found != this->Parts.end())
  {
    return found->second;
  }
  Part& part = this->Parts[block];
  this->Mesh(block, part);
  part.Distances.assign(static_cast<std::size_t>(part.Surface->GetNumberOfPoints()),
    std::numeric_limits<double>::max());
  if (part.Surface->GetNumberOfCells() > 0)
  {
    part.Locator->SetDataSet(part.Surface);
    part.Locator->BuildLocator();
  }
  return part;
}

void PaintedPatch::Mesh(const Block& block, Part& part) const
{
  const int* const whole = this->Image->GetExtent();
  int extent[6];
  for (int a = 0; a < 3; ++a)
  {
    extent[2 * a] = whole[2 * a] + BlockSize * block[static_cast<std::size_t>(a)];
    extent[2 * a + 1] = std::min(extent[2 * a] + BlockSize, whole[2 * a + 1]);
  }
  // Use index coordinates of the whole image, so that neighbouring blocks have bit-identical points
  // on their common border.
  vtkNew<vtkImageData> samples;
  samples->SetExtent(extent);
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfTuples(samples->GetNumberOfPoints());
  vtkIdType next = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        int ijk[3] = { i, j, k };
        values->SetValue(
          next++, this->Scalars->GetComponent(this->Image->ComputePointId(ijk), this->Component));
      }
    }
  }
  samples->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(samples);
  edges->SetValue(0, this->Value);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  vtkPolyData* const made = edges->GetOutput();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(made->GetNumberOfPoints());
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    double world[3];
    this->Image->TransformContinuousIndexToPhysicalPoint(made->GetPoint(i), world);
    points->SetPoint(i, world);
  }
  part.Surface->SetPoints(points);
  part.Surface->SetPolys(made->GetPolys());
}

std::optional<Vector3> PaintedPatch::FindNearest(const Vector3& position)
{
  const double reach = this->Radius + Reach * this->Voxel;
  const double at[3] = { position.X, position.Y, position.Z };
  double least = reach * reach;
  std::optional<Vector3> nearest;
  vtkNew<vtkGenericCell> cell;
  this->Visit(position, position, reach,
    [&](Part& part)
    {
      if (part.Surface->GetNumberOfCells() == 0)
      {
        return;
      }
      double closest[3];
      vtkIdType id = -1;
      int sub = 0;
      double squared = 0.0;
      int inside = 0;
      if (part.Locator->FindClosestPointWithinRadius(
            const_cast<double*>(at), std::sqrt(least), closest, cell, id, sub, squared, inside) &&
        squared < least)
      {
        least = squared;
        nearest = FromArray(closest);
      }
    });
  return nearest;
}

bool PaintedPatch::LeadTo(const Vector3& position)
{
  const std::optional<Vector3> nearest = this->FindNearest(position);
  if (!nearest)
  {
    this->Last.reset();
    return false;
  }
  const Vector3 to = *nearest;
  const Vector3 from = this->Last.value_or(to);
  // Visit the line in short pieces, so that blocks far from it are not meshed.
  const int pieces =
    1 + static_cast<int>(std::min(1e5, Norm(to - from) / (BlockSize * this->Voxel)));
  for (int piece = 0; piece < pieces; ++piece)
  {
    const Vector3 begin = from + (static_cast<double>(piece) / pieces) * (to - from);
    const Vector3 end = from + (static_cast<double>(piece + 1) / pieces) * (to - from);
    // Include one more voxel, for the triangles that the border crosses.
    this->Visit(begin, end, this->Radius + this->Voxel,
      [&](Part& part)
      {
        for (std::size_t i = 0; i < part.Distances.size(); ++i)
        {
          double point[3];
          part.Surface->GetPoint(static_cast<vtkIdType>(i), point);
          part.Distances[i] =
            std::min(part.Distances[i], SquaredDistance(FromArray(point), begin, end));
        }
      });
  }
  this->Last = to;
  this->Visited.push_back(to);
  return true;
}

vtkSmartPointer<vtkPolyData> PaintedPatch::Cut() const
{
  vtkNew<vtkAppendPolyData> all;
  bool isEmpty = true;
  for (const auto& [block, part] : this->Parts)
  {
    if (part.Surface->GetNumberOfCells() == 0 ||
      *std::min_element(part.Distances.begin(), part.Distances.end()) > this->Radius * this->Radius)
    {
      continue;
    }
    vtkNew<vtkDoubleArray> distances;
    distances->SetName("Distance");
    for (const double squared : part.Distances)
    {
      // Limit the value, which does not matter far beyond the border.
      distances->InsertNextValue(std::min(std::sqrt(squared), 1e3 * this->Radius));
    }
    vtkNew<vtkPolyData> shared;
    shared->ShallowCopy(part.Surface);
    shared->GetPointData()->SetScalars(distances);
    all->AddInputData(shared);
    isEmpty = false;
  }
  auto cut = vtkSmartPointer<vtkPolyData>::New();
  if (isEmpty)
  {
    return cut;
  }
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputConnection(all->GetOutputPort());
  merged->SetTolerance(0.0);
  merged->ConvertPolysToLinesOff();
  merged->ConvertLinesToPointsOff();
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputConnection(merged->GetOutputPort());
  clip->SetValue(this->Radius);
  clip->InsideOutOn();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(clip->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  if (triangles->GetOutput()->GetNumberOfPolys() == 0)
  {
    return cut;
  }
  // Remove parts that are not connected to the brush's line along the surface.
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(triangles->GetOutput());
  locator->BuildLocator();
  vtkNew<vtkPolyDataConnectivityFilter> connected;
  connected->SetInputConnection(triangles->GetOutputPort());
  connected->SetExtractionModeToPointSeededRegions();
  for (const Vector3& place : this->Visited)
  {
    const double at[3] = { place.X, place.Y, place.Z };
    connected->AddSeed(locator->FindClosestPoint(at));
  }
  vtkNew<vtkCleanPolyData> used; // removes points that belong to no triangle
  used->SetInputConnection(connected->GetOutputPort());
  used->PointMergingOff();
  used->Update();
  cut->SetPoints(used->GetOutput()->GetPoints());
  cut->SetPolys(used->GetOutput()->GetPolys());
  return cut;
}

} // namespace VolumeHaptics
