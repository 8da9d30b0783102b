// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Proposal/EdgeSearch.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{
constexpr double MostVoxels = 1e6;
constexpr std::size_t MostLines = 50000;

/** Mixes the bits of a number, as the finalizer of MurmurHash3 (public domain) does. */
std::uint64_t Scramble(std::uint64_t number)
{
  number = (number ^ (number >> 33)) * 0xff51afd7ed558ccdULL;
  number = (number ^ (number >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return number ^ (number >> 33);
}

} // namespace

//------------------------------------------------------------------------------
std::vector<Vector3> ScatterVoxels(const VolumeView& view)
{
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
std::vector<EdgeLine> FindEdges(
  const VolumeView& view, const EdgeTracer& tracer, const EdgeThresholds& thresholds)
{
  const std::vector<Vector3> voxels = ScatterVoxels(view);
  std::vector<char> isSteep(voxels.size());
  auto look = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      isSteep[i] = tracer.Slope(voxels[i]) >= thresholds.Least;
    }
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(voxels.size()), look);
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
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), trace);
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
