// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/EdgeSearch.h"

#include "Core/Field/Estimates/NoiseEstimate.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double MostVoxels = 1e6;
constexpr std::size_t MostLines = 50000;
/**
 * Number of rows that are read in a large volume. Each block of voxels needs 36 rows of samples
 * around it, because its gradients are estimated from them.
 */
constexpr std::int64_t MostRows = 512;
constexpr std::int64_t MostVoxelsInARow = 2048;
/** Number of voxels whose background work takes some milliseconds. */
constexpr std::size_t VoxelsAtOnce = 4096;
constexpr std::size_t LinesAtOnce = 128;
/** Fraction of a search's time that is spent on finding steep voxels. */
constexpr double SteepFraction = 0.5;

/** Mixes the bits of a number, as the finalizer of MurmurHash3 (public domain) does. */
std::uint64_t Scramble(std::uint64_t number)
{
  number = (number ^ (number >> 33)) * 0xff51afd7ed558ccdULL;
  number = (number ^ (number >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return number ^ (number >> 33);
}

/** Returns a number below `room`, and removes it from `random`. */
std::int64_t Draw(std::uint64_t& random, std::int64_t room)
{
  const auto count = static_cast<std::uint64_t>(room);
  const auto drawn = static_cast<std::int64_t>(random % count);
  random /= count;
  return drawn;
}

/**
 * Picks the voxels of one row in each of at most MostRows columns along the first axis, which
 * divide the volume equally.
 */
std::vector<Vector3> ScatterRows(const VolumeView& view)
{
  const std::int64_t* const n = view.Dimensions;
  const double ratio = static_cast<double>(n[1]) / static_cast<double>(n[2]);
  const std::int64_t most = std::min(MostRows, n[1]);
  const std::int64_t along =
    std::clamp<std::int64_t>(std::llround(std::sqrt(MostRows * ratio)), 1, most);
  const std::int64_t across = std::min(MostRows / along, n[2]);
  const std::int64_t length = std::min(MostVoxelsInARow, n[0]);
  std::vector<Vector3> voxels;
  voxels.reserve(static_cast<std::size_t>(along * across * length));
  for (std::int64_t column = 0; column < along * across; ++column)
  {
    const std::int64_t j = column % along;
    const std::int64_t k = column / along;
    // The first row of this column, and the first row after it.
    const std::int64_t firstRow[2] = { n[1] * j / along, n[1] * (j + 1) / along };
    const std::int64_t firstSlice[2] = { n[2] * k / across, n[2] * (k + 1) / across };
    std::uint64_t random = Scramble(static_cast<std::uint64_t>(column) + 1);
    const std::int64_t row = firstRow[0] + Draw(random, firstRow[1] - firstRow[0]);
    const std::int64_t slice = firstSlice[0] + Draw(random, firstSlice[1] - firstSlice[0]);
    const std::int64_t first = Draw(random, n[0] - length + 1);
    for (std::int64_t i = first; i < first + length; ++i)
    {
      voxels.push_back({ static_cast<double>(view.First[0] + i),
        static_cast<double>(view.First[1] + row), static_cast<double>(view.First[2] + slice) });
    }
  }
  return voxels;
}

} // namespace

//------------------------------------------------------------------------------
std::vector<Vector3> ScatterVoxels(const VolumeView& view)
{
  if (IsLargeVolume(view.Dimensions))
  {
    return ScatterRows(view);
  }
  const std::int64_t* const n = view.Dimensions;
  const double all =
    static_cast<double>(n[0]) * static_cast<double>(n[1]) * static_cast<double>(n[2]);
  const auto side =
    static_cast<std::int64_t>(std::ceil(std::cbrt(std::max(1.0, all / MostVoxels))));
  std::vector<Vector3> voxels;
  std::uint64_t block = 0;
  for (std::int64_t k = 0; k < n[2]; k += side)
  {
    for (std::int64_t j = 0; j < n[1]; j += side)
    {
      for (std::int64_t i = 0; i < n[0]; i += side)
      {
        std::uint64_t random = Scramble(++block);
        const std::int64_t first[3] = { i, j, k };
        double at[3];
        for (int a = 0; a < 3; ++a)
        {
          const auto room = static_cast<std::uint64_t>(std::min(side, n[a] - first[a]));
          at[a] = static_cast<double>(
            view.First[a] + first[a] + static_cast<std::int64_t>(random % room));
          random /= room;
        }
        voxels.push_back({ at[0], at[1], at[2] });
      }
    }
  }
  return voxels;
}

//------------------------------------------------------------------------------
std::vector<EdgeLine> DetectEdges(const VolumeView& view, const EdgeTracer& tracer,
  const EdgeThresholds& thresholds, const SearchPart& part)
{
  const double middle = part.Begin + SteepFraction * (part.End - part.Begin);
  const std::vector<Vector3> voxels = ScatterVoxels(view);
  std::vector<char> isSteep(voxels.size());
  auto look = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      isSteep[i] = tracer.Slope(voxels[i]) >= thresholds.Least;
    }
  };
  if (!LookAtAll(voxels.size(), VoxelsAtOnce, { part.Monitor, part.Begin, middle }, look))
  {
    return {};
  }
  std::vector<Vector3> steep;
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    if (isSteep[i])
    {
      steep.push_back(voxels[i]);
    }
  }
  const std::size_t count = std::min(steep.size(), MostLines);
  std::vector<EdgeLine> lines(count);
  std::vector<char> isEdge(count);
  auto trace = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      isEdge[i] = tracer.Trace(steep[i * steep.size() / count], lines[i]);
    }
  };
  LookAtAll(count, LinesAtOnce, { part.Monitor, middle, part.End }, trace);
  std::vector<EdgeLine> edges;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isEdge[i])
    {
      edges.push_back(lines[i]);
    }
  }
  return edges;
}

} // namespace VolumeHaptics
