// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/ShellSampler.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <queue>
#include <utility>

namespace VolumeHaptics
{

namespace
{

bool Refuse(std::string& error, const std::string& text)
{
  error = "The mesh of the tool " + text;
  return false;
}

/** Returns the triangles of a mesh, with coinciding corners merged. */
vtkSmartPointer<vtkPolyData> MergeCorners(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  clean->SetTolerance(0.0);
  clean->ConvertPolysToLinesOff();
  clean->ConvertLinesToPointsOff();
  clean->Update();
  return clean->GetOutput();
}

template <typename Function>
void ForEachTriangle(vtkPolyData* mesh, Function&& visit)
{
  auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    if (count == 3)
    {
      visit(ids);
    }
  }
}

Vector3 PointAt(vtkPolyData* mesh, vtkIdType id)
{
  double x[3];
  mesh->GetPoint(id, x);
  return { x[0], x[1], x[2] };
}

/**
 * Checks that the surface is closed: each edge must belong to two triangles that traverse it in
 * opposite directions. Where an edge belongs to several such pairs, parts of the surface touch one
 * another.
 */
bool CheckEdges(vtkPolyData* mesh, std::string& error)
{
  struct Run
  {
    std::pair<vtkIdType, vtkIdType> Edge; // lower id first
    int Direction;
  };
  std::vector<Run> runs;
  runs.reserve(3 * static_cast<std::size_t>(mesh->GetNumberOfPolys()));
  ForEachTriangle(mesh,
    [&](const vtkIdType* ids)
    {
      for (int i = 0; i < 3; ++i)
      {
        const vtkIdType from = ids[i];
        const vtkIdType to = ids[(i + 1) % 3];
        runs.push_back({ { std::min(from, to), std::max(from, to) }, from < to ? 1 : -1 });
      }
    });
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.Edge < b.Edge; });
  std::size_t edges = 0;
  std::size_t open = 0;
  std::size_t crossed = 0;
  for (std::size_t i = 0; i < runs.size(); ++edges)
  {
    const std::size_t begin = i;
    int sum = 0;
    for (; i < runs.size() && runs[i].Edge == runs[begin].Edge; ++i)
    {
      sum += runs[i].Direction;
    }
    const bool isOdd = (i - begin) % 2 != 0;
    open += isOdd ? 1 : 0;
    crossed += !isOdd && sum != 0 ? 1 : 0;
  }
  if (open > 0)
  {
    return Refuse(error,
      "is not closed: " + std::to_string(open) + " of its " + std::to_string(edges) +
        " edges belong to one triangle only. Close it, for example with vtkFillHolesFilter "
        "and then vtkPolyDataNormals, or merge points that lie nearly at the same place with "
        "vtkCleanPolyData and SetTolerance().");
  }
  if (crossed > 0)
  {
    return Refuse(error,
      "has neighbours that face opposite sides, at " + std::to_string(crossed) + " of its " +
        std::to_string(edges) +
        " edges. Turn them to one side with vtkPolyDataNormals and ConsistencyOn().");
  }
  return true;
}

/** Checks the ids of points, because VTK's filters would read beyond the array with a wrong id. */
bool CheckIds(vtkCellArray* cells, vtkIdType points, std::string& error)
{
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(cell, count, ids);
    const auto* const missing =
      std::find_if(ids, ids + count, [points](vtkIdType id) { return id < 0 || id >= points; });
    if (missing != ids + count)
    {
      return Refuse(error,
        "has a polygon with the point " + std::to_string(*missing) + ", but only " +
          std::to_string(points) + " points. Correct the mesh.");
    }
  }
  return true;
}

bool CheckPoints(vtkPolyData* mesh, std::string& error)
{
  if (!mesh || mesh->GetNumberOfPoints() == 0 ||
    mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    return Refuse(error, "has no polygons. Give a closed surface, such as that of an STL file.");
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    if (!IsFinite(PointAt(mesh, i)))
    {
      return Refuse(error,
        "has a point that is not finite, number " + std::to_string(i) + ". Correct the mesh.");
    }
  }
  return CheckIds(mesh->GetPolys(), mesh->GetNumberOfPoints(), error) &&
    CheckIds(mesh->GetStrips(), mesh->GetNumberOfPoints(), error);
}

} // namespace

bool ReadToolMesh(vtkPolyData* mesh, std::vector<ToolTriangle>& triangles, std::string& error)
{
  triangles.clear();
  if (!CheckPoints(mesh, error))
  {
    return false;
  }
  const vtkSmartPointer<vtkPolyData> clean = MergeCorners(mesh);
  if (!CheckEdges(clean, error))
  {
    return false;
  }
  double bounds[6];
  clean->GetBounds(bounds);
  const Vector3 middle =
    0.5 * Vector3{ bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5] };
  double volume = 0.0; // six times the volume, by the divergence theorem
  ForEachTriangle(clean,
    [&](const vtkIdType* ids)
    {
      ToolTriangle triangle;
      for (int i = 0; i < 3; ++i)
      {
        triangle.Corner[i] = PointAt(clean, ids[i]);
      }
      const Vector3& from = triangle.Corner[0];
      const Vector3 across = Cross(triangle.Corner[1] - from, triangle.Corner[2] - from);
      const double twice = Norm(across);
      volume += Dot(across, from - middle);
      triangle.Area = 0.5 * twice;
      if (triangle.Area > 0.0 && std::isfinite(triangle.Area))
      {
        triangle.Normal = (1.0 / twice) * across;
        triangles.push_back(triangle);
      }
    });
  if (triangles.empty())
  {
    return Refuse(error, "has no triangle with an area. Give it a surface with an extent.");
  }
  if (!(volume > 0.0))
  {
    triangles.clear();
    return Refuse(error,
      "is inside out: its triangles face inwards. Turn them with vtkReverseSense and "
      "ReverseCellsOn().");
  }
  return true;
}

namespace
{

/**
 * Candidates per point: CandidatesOfFew for fewer than `Many` points, otherwise CandidatesOfMany.
 */
constexpr std::size_t CandidatesOfFew = 40;
constexpr std::size_t CandidatesOfMany = 15;
constexpr std::size_t Many = 20000;
/** The first choice is made among every n-th candidate; this is n. */
constexpr std::size_t CandidatesOfChoice = 5;
/**
 * Smallest length of a mean of unit normals at which the positions are considered to face the same
 * way, so that their mean position is near the surface.
 */
constexpr double LeastMeanNormal = 0.97;
/** Number of rounds in which points move to the centre of their candidates. */
constexpr int LloydRounds = 5;

/** A position on the surface, with its normal. */
struct SurfacePlace
{
  Vector3 Position;
  Vector3 Normal; ///< normal, scaled to a length so that angles and distances can be added
};

double SquaredDistance(const SurfacePlace& a, const SurfacePlace& b)
{
  const Vector3 way = a.Position - b.Position;
  const Vector3 turn = a.Normal - b.Normal;
  return Dot(way, way) + Dot(turn, turn);
}

/**
 * Spreads positions that represent equal areas, stratified along the list of triangles and within
 * each triangle.
 */
std::vector<SurfacePlace> SpreadPlaces(
  const std::vector<ToolTriangle>& triangles, double area, std::size_t count, double turnLength)
{
  // Multiples of the powers of the plastic ratio cover a square evenly.
  constexpr double first = 0.7548776662466927;
  constexpr double second = 0.5698402909980532;
  std::vector<SurfacePlace> places;
  places.reserve(count);
  double passed = 0.0;
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double at = (static_cast<double>(i) + 0.5) / static_cast<double>(count) * area;
    while (triangle + 1 < triangles.size() && passed + triangles[triangle].Area < at)
    {
      passed += triangles[triangle].Area;
      ++triangle;
    }
    const auto n = static_cast<double>(i + 1);
    double u = n * first - std::floor(n * first);
    double v = n * second - std::floor(n * second);
    if (u + v > 1.0)
    {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const ToolTriangle& on = triangles[triangle];
    places.push_back(
      { on.Corner[0] + u * (on.Corner[1] - on.Corner[0]) + v * (on.Corner[2] - on.Corner[0]),
        turnLength * on.Normal });
  }
  return places;
}

/** Finds neighbours among the members, some of the positions, with a grid of cubes. */
class PlaceGrid
{
public:
  PlaceGrid(
    const std::vector<SurfacePlace>& places, const std::vector<std::size_t>& members, double cell)
    : Places(places)
    , Cell(cell)
  {
    for (const std::size_t member : members)
    {
      this->Members.emplace_back(this->KeyOf(this->CubeOf(places[member].Position)), member);
    }
    std::sort(this->Members.begin(), this->Members.end());
    std::size_t buckets = 1;
    for (; buckets < 2 * this->Members.size(); buckets *= 2)
    {
    }
    this->Mask = buckets - 1;
    this->Buckets.assign(buckets, Empty);
    for (std::size_t i = 0; i < this->Members.size(); ++i)
    {
      if (i == 0 || this->Members[i].first != this->Members[i - 1].first)
      {
        std::size_t bucket = HashOf(this->Members[i].first) & this->Mask;
        while (this->Buckets[bucket] != Empty)
        {
          bucket = (bucket + 1) & this->Mask;
        }
        this->Buckets[bucket] = i;
      }
    }
  }

  /** Calls a function with all members within `radius` of a position, and perhaps with others. */
  template <typename Function>
  void ForNear(const Vector3& at, double radius, Function&& visit) const
  {
    const auto low = this->CubeOf(at - Vector3{ radius, radius, radius });
    const auto high = this->CubeOf(at + Vector3{ radius, radius, radius });
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
    {
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
      {
        for (std::int64_t x = low[0]; x <= high[0]; ++x)
        {
          this->ForCube(this->KeyOf({ x, y, z }), visit);
        }
      }
    }
  }

  /**
   * Returns the member nearest to a position, or the first of several equally near ones. Requires
   * at least one member. Searches within a distance first, and farther if there is no member.
   */
  std::size_t FindNearest(const SurfacePlace& place, double within) const
  {
    double least = std::numeric_limits<double>::max();
    std::size_t nearest = this->Members.front().second;
    constexpr double shortest = 0.05; // as a fraction of a cube's edge
    for (double radius = std::max(within, shortest * this->Cell);; radius *= 2.0)
    {
      this->ForNear(place.Position, radius,
        [&](std::size_t member)
        {
          const double square = SquaredDistance(place, this->Places[member]);
          if (square < least || (square == least && member < nearest))
          {
            least = square;
            nearest = member;
          }
        });
      if (least <= radius * radius)
      {
        return nearest;
      }
    }
  }

private:
  using Cube = std::array<std::int64_t, 3>;
  static constexpr std::size_t Empty = std::numeric_limits<std::size_t>::max();

  Cube CubeOf(const Vector3& at) const
  {
    const auto number = [this](double x)
    { return static_cast<std::int64_t>(std::floor(x / this->Cell)); };
    return { number(at.X), number(at.Y), number(at.Z) };
  }
  /**
   * Packs a cube's indices into 21 bits per axis. Cubes a million apart get the same key; both are
   * then visited, which only costs time.
   */
  static std::uint64_t KeyOf(const Cube& cube)
  {
    constexpr std::uint64_t bits = 0x1fffff;
    return (static_cast<std::uint64_t>(cube[0]) & bits) |
      (static_cast<std::uint64_t>(cube[1]) & bits) << 21 |
      (static_cast<std::uint64_t>(cube[2]) & bits) << 42;
  }
  static std::size_t HashOf(std::uint64_t key)
  {
    key *= 0x9E3779B97F4A7C15ULL;
    return static_cast<std::size_t>(key ^ key >> 32);
  }
  template <typename Function>
  void ForCube(std::uint64_t key, Function& visit) const
  {
    for (std::size_t bucket = HashOf(key) & this->Mask; this->Buckets[bucket] != Empty;
         bucket = (bucket + 1) & this->Mask)
    {
      std::size_t i = this->Buckets[bucket];
      if (this->Members[i].first == key)
      {
        for (; i < this->Members.size() && this->Members[i].first == key; ++i)
        {
          visit(this->Members[i].second);
        }
        return;
      }
    }
  }

  const std::vector<SurfacePlace>& Places;
  const double Cell;
  std::vector<std::pair<std::uint64_t, std::size_t>> Members; ///< sorted by cube
  /** Index of the first member of each cube. */
  std::vector<std::size_t> Buckets;
  std::size_t Mask = 0;
};

/** Returns whether a loop should continue. Queries the monitor, if any, in every 1024th step. */
bool GoesOn(const WorkMonitor* monitor, std::size_t step)
{
  constexpr std::size_t between = 1024;
  return !monitor || step % between != 0 || !monitor->IsCancelled();
}

/** Removes the most crowded members until `count` are left. */
std::vector<std::size_t> Eliminate(const std::vector<SurfacePlace>& places,
  const std::vector<std::size_t>& members, std::size_t count, double area,
  const WorkMonitor* monitor)
{
  // Largest radius of discs that fit into the area in a triangular lattice.
  const double most = std::sqrt(area / (2.0 * std::sqrt(3.0) * static_cast<double>(count)));
  const double ratio = static_cast<double>(count) / static_cast<double>(members.size());
  const double least = 0.65 * most * (1.0 - std::pow(ratio, 1.5));
  const double reach = 2.0 * most;
  const auto weigh = [&](std::size_t a, std::size_t b)
  {
    const double distance = std::sqrt(SquaredDistance(places[a], places[b]));
    const double share = 1.0 - std::max(distance, 2.0 * least) / reach;
    return share > 0.0 ? std::pow(share, 8) : 0.0;
  };
  const PlaceGrid grid(places, members, reach);
  std::vector<double> weights(places.size(), 0.0);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry> heaviest;
  for (const std::size_t member : members)
  {
    if (!GoesOn(monitor, heaviest.size()))
    {
      return {};
    }
    grid.ForNear(places[member].Position, reach,
      [&](std::size_t other) { weights[member] += other != member ? weigh(member, other) : 0.0; });
    heaviest.emplace(weights[member], member);
  }
  std::vector<char> isOut(places.size(), 0);
  for (std::size_t left = members.size(); left > count;)
  {
    if (!GoesOn(monitor, left))
    {
      return {};
    }
    const double weight = heaviest.top().first;
    const std::size_t member = heaviest.top().second;
    heaviest.pop();
    if (weight != weights[member])
    {
      heaviest.emplace(weights[member], member);
      continue;
    }
    isOut[member] = 1;
    --left;
    grid.ForNear(places[member].Position, reach,
      [&](std::size_t other) { weights[other] -= other != member ? weigh(member, other) : 0.0; });
  }
  std::vector<std::size_t> kept;
  kept.reserve(count);
  std::copy_if(members.begin(), members.end(), std::back_inserter(kept),
    [&](std::size_t member) { return isOut[member] == 0; });
  return kept;
}

/**
 * Finds the index of the nearest chosen position for each position. If the chosen positions have
 * only moved, starts the search near the last owner. Returns nothing if the work is cancelled.
 */
std::vector<std::size_t> FindOwners(const std::vector<SurfacePlace>& places,
  const std::vector<std::size_t>& chosen, double spacing, const std::vector<std::size_t>& before,
  const WorkMonitor* monitor)
{
  const PlaceGrid grid(places, chosen, spacing);
  std::vector<std::size_t> numbers(places.size(), 0);
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    numbers[chosen[i]] = i;
  }
  std::vector<std::size_t> owners;
  owners.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (!GoesOn(monitor, i))
    {
      return {};
    }
    constexpr double rounding = 1.0 + 1e-9;
    const double within = before.empty()
      ? spacing
      : rounding * std::sqrt(SquaredDistance(places[i], places[chosen[before[i]]]));
    owners.push_back(numbers[grid.FindNearest(places[i], within)]);
  }
  return owners;
}

/** Mean position and mean normal of the candidates that belong to one point, and their number. */
struct OwnPlaces
{
  SurfacePlace Middle;
  double Count = 0.0;
};

std::vector<OwnPlaces> ComputeMiddles(const std::vector<SurfacePlace>& places,
  const std::vector<std::size_t>& owners, std::size_t count)
{
  std::vector<OwnPlaces> all(count);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    OwnPlaces& own = all[owners[i]];
    own.Middle.Position += places[i].Position;
    own.Middle.Normal += places[i].Normal;
    own.Count += 1.0;
  }
  for (OwnPlaces& own : all)
  {
    const double share = 1.0 / std::max(own.Count, 1.0);
    own.Middle = { share * own.Middle.Position, share * own.Middle.Normal };
  }
  return all;
}

/** Moves each point to the one of its candidates that is nearest to their mean position. */
void MoveToMiddles(const std::vector<SurfacePlace>& places, const std::vector<std::size_t>& owners,
  std::vector<std::size_t>& chosen)
{
  const std::vector<OwnPlaces> own = ComputeMiddles(places, owners, chosen.size());
  std::vector<double> nearest(chosen.size(), std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const std::size_t owner = owners[i];
    const double distance = SquaredDistance(own[owner].Middle, places[i]);
    if (distance < nearest[owner])
    {
      nearest[owner] = distance;
      chosen[owner] = i;
    }
  }
}

} // namespace

std::vector<ShellPoint> SpreadShellPoints(
  const std::vector<ToolTriangle>& triangles, std::size_t count, const WorkMonitor* monitor)
{
  double area = 0.0;
  for (const ToolTriangle& triangle : triangles)
  {
    area += triangle.Area;
  }
  const double spacing = std::sqrt(area / static_cast<double>(count));
  const std::size_t candidates = count < Many ? CandidatesOfFew : CandidatesOfMany;
  const std::vector<SurfacePlace> places =
    SpreadPlaces(triangles, area, count * candidates, spacing);
  std::vector<std::size_t> members;
  for (std::size_t i = CandidatesOfChoice / 2; i < places.size(); i += CandidatesOfChoice)
  {
    members.push_back(i);
  }
  std::vector<std::size_t> chosen = Eliminate(places, members, count, area, monitor);
  std::vector<std::size_t> owners =
    chosen.empty() ? chosen : FindOwners(places, chosen, spacing, {}, monitor);
  for (int round = 0; round < LloydRounds && !owners.empty(); ++round)
  {
    MoveToMiddles(places, owners, chosen);
    owners = FindOwners(places, chosen, spacing, owners, monitor);
  }
  if (owners.empty())
  {
    return {};
  }
  // Put each point at the mean position of its candidates, projected onto the surface: sums of a
  // linear function along a plane then equal integrals. On a curved surface that is pressed into a
  // plane, the excess of the points on it balances the deficit of the points at the rim of the
  // contact.
  const std::vector<OwnPlaces> own = ComputeMiddles(places, owners, chosen.size());
  std::vector<ShellPoint> points;
  points.reserve(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const SurfacePlace& middle = own[i].Middle;
    const SurfacePlace& nearest = places[chosen[i]];
    Vector3 position = nearest.Position;
    if (Norm(middle.Normal) >= LeastMeanNormal * spacing)
    {
      const Vector3 normal = (1.0 / spacing) * nearest.Normal;
      position = middle.Position + Dot(nearest.Position - middle.Position, normal) * normal;
    }
    points.push_back({ position, area * own[i].Count / static_cast<double>(places.size()) });
  }
  return points;
}

} // namespace VolumeHaptics
