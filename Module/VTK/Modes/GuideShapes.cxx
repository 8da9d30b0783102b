// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Modes/GuideShapes.h"

#include "Core/Model/BakedMode.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Base/HapticVolume.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkHapticGuideMode.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * Makes a line of the points with these ids. Without ids, makes it of the first `count` points in
 * their order.
 */
GuidePath::Line LineOf(vtkPolyData* path, vtkIdType count, const vtkIdType* ids)
{
  GuidePath::Line line;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* const x = path->GetPoint(ids ? ids[i] : i);
    line.push_back({ x[0], x[1], x[2] });
  }
  return line;
}

bool ReadLines(vtkPolyData* path, std::vector<GuidePath::Line>& lines, std::string& error)
{
  if (path->GetNumberOfLines() == 0)
  {
    lines.push_back(LineOf(path, path->GetNumberOfPoints(), nullptr));
    return true;
  }
  const vtkIdType points = path->GetPoints() ? path->GetNumberOfPoints() : 0;
  vtkCellArray* const cells = path->GetLines();
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, count, ids);
    const auto* const missing =
      std::find_if(ids, ids + count, [points](vtkIdType id) { return id < 0 || id >= points; });
    if (missing != ids + count)
    {
      error = "A line of the path of a vtkHapticGuideMode has the point " +
        std::to_string(*missing) + ", but the path has " + std::to_string(points) +
        " points. Correct it, or give the mode another one with SetPath().";
      return false;
    }
    lines.push_back(LineOf(path, count, ids));
  }
  return true;
}

bool ReadPath(vtkPolyData* path, double rounding, ModeDescription& d, std::string& error)
{
  std::vector<GuidePath::Line> lines;
  if (!ReadLines(path, lines, error))
  {
    return false;
  }
  for (const GuidePath::Line& line : lines)
  {
    if (!std::all_of(line.begin(), line.end(), [](const Vector3& x) { return IsFinite(x); }))
    {
      error = "The path of a vtkHapticGuideMode has a point that is not finite. Correct it, or "
              "give the mode another one with SetPath().";
      return false;
    }
  }
  d.Guide = std::make_shared<const GuidePath>(lines, rounding);
  if (d.Guide->IsEmpty())
  {
    error = "The path of a vtkHapticGuideMode has no line: it needs at least two points that "
            "differ. Give it polylines with SetPath(), or switch it off with SetActive(false).";
    return false;
  }
  return true;
}

/** Finds the meshes that models use, so that unchanged surfaces are not prepared again. */
class MeshesInUse
{
public:
  std::shared_ptr<const GuideMesh> Get(vtkPolyData* surface, double rounding, std::string& error)
  {
    // Modification times are unique, so that new data at an old address get another key.
    const Key key{ surface, surface->GetMTime(), rounding };
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (const auto known = this->Meshes[key].lock())
    {
      return known;
    }
    const auto triangles = MeshSurface(surface, "The surface of a vtkHapticGuideMode",
      "Give the mode a vtkPolyData with polygons or strips with SetSurface(), or switch it off "
      "with SetActive(false).",
      error);
    const auto mesh = triangles ? std::make_shared<const GuideMesh>(triangles, rounding) : nullptr;
    this->Meshes[key] = mesh;
    for (auto i = this->Meshes.begin(); i != this->Meshes.end();)
    {
      i = i->second.expired() ? this->Meshes.erase(i) : std::next(i);
    }
    return mesh;
  }

private:
  using Key = std::tuple<const void*, vtkMTimeType, double>;
  std::mutex Mutex;
  std::map<Key, std::weak_ptr<const GuideMesh>> Meshes;
};

bool ReadSurface(
  vtkPolyData* surface, double rounding, double distance, ModeDescription& d, std::string& error)
{
  // Never destroyed: see MethodChoices().
  static auto* const meshes = new MeshesInUse;
  const auto mesh = meshes->Get(surface, rounding, error);
  d.GuideSurface = mesh ? std::make_shared<const GuideSurface>(mesh, distance) : nullptr;
  return mesh != nullptr;
}

bool ReadDistanceField(vtkImageData* field, double distance, ModeDescription& d, std::string& error)
{
  constexpr int kernelRadius = 1;
  const std::string name = "The distance field of a vtkHapticGuideMode";
  vtkDataArray* const scalars = field->GetPointData()->GetScalars();
  if (!scalars)
  {
    error = name +
      " has no active point scalars. Name them with SetActiveScalars() of its point "
      "data, or give the mode another image with SetDistanceField().";
    return false;
  }
  HapticVolume volume;
  if (!ReadVolume(field, scalars, 0, kernelRadius, volume, error))
  {
    error = name + " can't be read. " + error;
    return false;
  }
  vtkDataArray* const holder = volume.Holder;
  holder->Register(nullptr);
  const std::shared_ptr<const void> samples = { static_cast<const void*>(holder),
    [holder](const void*) { holder->UnRegister(nullptr); } };
  d.GuideSurface =
    std::make_shared<const GuideSurface>(volume.View, samples, volume.IndexToWorld, distance);
  return true;
}

} // namespace

bool DescribeGuide(
  vtkHapticGuideMode* mode, double rounding, ModeDescription& d, std::string& error)
{
  const int shapes =
    (mode->GetPath() ? 1 : 0) + (mode->GetSurface() ? 1 : 0) + (mode->GetDistanceField() ? 1 : 0);
  if (shapes != 1)
  {
    error = std::string("A vtkHapticGuideMode has ") +
      (shapes == 0 ? "no path, surface or distance field" : "more than one shape to follow") +
      ". Give it exactly one with SetPath(), SetSurface() or SetDistanceField(), and nullptr for "
      "the others; or switch it off with SetActive(false).";
    return false;
  }
  const double distance = mode->GetDistance();
  if (!std::isfinite(distance))
  {
    error = "The Distance of a vtkHapticGuideMode is not finite. Set a number of world units with "
            "SetDistance().";
    return false;
  }
  if (mode->GetPath())
  {
    return ReadPath(mode->GetPath(), rounding, d, error);
  }
  constexpr GuideSide sides[] = { GuideSide::Surface, GuideSide::Outside, GuideSide::Inside };
  d.Side = sides[mode->GetSide()];
  return mode->GetSurface() ? ReadSurface(mode->GetSurface(), rounding, distance, d, error)
                            : ReadDistanceField(mode->GetDistanceField(), distance, d, error);
}

} // namespace VolumeHaptics
