// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/ShellPoints.h"

#include "VTK/Baking/HapticSurface.h"
#include "VTK/Tools/ShellSampler.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

///@{
/** Time (s) of spreading points on a desktop computer. */
constexpr double SecondsPerPoint = 1.3e-4;
constexpr double SecondsPerPolygon = 2e-6;
constexpr double ShortSpreading = 40e-3;
///@}

ShellKey KeyOf(vtkPolyData* mesh, int count)
{
  return { mesh, mesh ? mesh->GetMTime() : 0, count };
}

SpreadShell Spread(vtkPolyData* mesh, int count, WorkMonitor* monitor)
{
  SpreadShell made;
  std::vector<ToolTriangle> triangles;
  if (!ReadToolMesh(mesh, triangles, made.Error) || (monitor && monitor->IsCancelled()))
  {
    return made;
  }
  const std::vector<ShellPoint> points =
    SpreadShellPoints(triangles, static_cast<std::size_t>(count), monitor);
  made.Points = points.empty() ? nullptr : std::make_shared<const PointShell>(points);
  return made;
}

/**
 * Caches the points that models use, the last few that were made, and the last mesh that is not a
 * valid tool.
 */
class ShellsInUse
{
public:
  /** Finds the cached points of a mesh. Returns false if they have to be made. */
  bool Find(const ShellKey& key, SpreadShell& found)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto known = this->Shells.find(key);
    found.Points = known == this->Shells.end() ? nullptr : known->second.lock();
    found.Error = this->FailedKey == key ? this->Failure : std::string();
    return found.Points || !found.Error.empty();
  }
  void Add(const ShellKey& key, const SpreadShell& made)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!made.Points)
    {
      this->FailedKey = key;
      this->Failure = made.Error;
      return;
    }
    this->Shells[key] = made.Points;
    this->Last[this->Next] = made.Points;
    this->Next = (this->Next + 1) % this->Last.size();
    for (auto i = this->Shells.begin(); i != this->Shells.end();)
    {
      i = i->second.expired() ? this->Shells.erase(i) : std::next(i);
    }
  }

private:
  std::mutex Mutex;
  std::map<ShellKey, std::weak_ptr<const PointShell>> Shells;
  std::array<std::shared_ptr<const PointShell>, 4> Last;
  std::size_t Next = 0;
  ShellKey FailedKey{ nullptr, 0, 0 };
  std::string Failure;
};

ShellsInUse& GetShellsInUse()
{
  // Never destroyed, because a filter may exist until the process exits.
  static auto* const shells = new ShellsInUse;
  return *shells;
}

/** Copies a mesh for a worker. The copy has its own vtkPoints and cell cursors. */
vtkSmartPointer<vtkPolyData> CopyMesh(vtkPolyData* mesh)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  if (vtkPoints* const from = mesh->GetPoints())
  {
    const vtkNew<vtkPoints> points;
    points->SetDataType(from->GetDataType());
    points->DeepCopy(from);
    copy->SetPoints(points);
  }
  ShareCells(mesh, copy);
  return copy;
}

} // namespace

std::shared_ptr<const PointShell> GetShellPoints(vtkPolyData* mesh, int count, std::string& error)
{
  const ShellKey key = KeyOf(mesh, count);
  SpreadShell shell;
  if (!GetShellsInUse().Find(key, shell))
  {
    shell = Spread(mesh, count, nullptr);
    GetShellsInUse().Add(key, shell);
  }
  error = shell.Error;
  return shell.Points;
}

bool ShellPreparation::Prepare(vtkPolyData* mesh, int count)
{
  const ShellKey key = KeyOf(mesh, count);
  SpreadShell known;
  const bool isGood = mesh && count >= 1 && count <= MostShellPoints;
  if (!isGood || GetShellsInUse().Find(key, known) ||
    SecondsPerPoint * count +
        SecondsPerPolygon *
          static_cast<double>(mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips()) <=
      ShortSpreading)
  {
    this->Spreading.Abandon();
    return true;
  }
  if (const SpreadShell* const made = this->Spreading.Find(key))
  {
    GetShellsInUse().Add(key, *made);
    this->Spreading.Forget();
    return true;
  }
  if (this->Spreading.IsOf(key))
  {
    return !this->Spreading.IsUnderWay(); // GetShellPoints() will report a lack of memory
  }
  if (this->Spreading.IsUnderWay())
  {
    this->Spreading.Abandon();
    return false;
  }
  this->Spreading.Poll(key,
    [copy = CopyMesh(mesh), count](WorkMonitor& monitor) -> std::optional<SpreadShell>
    {
      SpreadShell made = Spread(copy, count, &monitor);
      return monitor.IsCancelled() ? std::nullopt : std::optional<SpreadShell>(std::move(made));
    });
  return false;
}

} // namespace VolumeHaptics
