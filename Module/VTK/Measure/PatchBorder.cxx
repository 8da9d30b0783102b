// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Measure/PatchBorder.h"

#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace VolumeHaptics
{

std::vector<Vector3> FindBorder(const Measurement& area)
{
  using Edge = std::pair<int, int>;
  std::set<Edge> edges; // with the direction that triangles give them
  for (const std::array<int, 3>& t : area.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.insert({ t[i], t[(i + 1) % 3] });
    }
  }
  std::multimap<int, int> next;
  for (const Edge& edge : edges)
  {
    if (edges.count({ edge.second, edge.first }) == 0)
    {
      next.insert(edge);
    }
  }
  std::vector<Vector3> longest;
  double most = 0.0;
  while (!next.empty())
  {
    std::vector<Vector3> line;
    double length = 0.0;
    for (auto edge = next.begin(); edge != next.end();)
    {
      const auto [from, to] = *edge;
      next.erase(edge);
      line.push_back(area.Points[static_cast<std::size_t>(from)]);
      length += Norm(area.Points[static_cast<std::size_t>(to)] - line.back());
      edge = next.find(to);
    }
    if (length > most)
    {
      most = length;
      longest = std::move(line);
    }
  }
  if (longest.empty() && !area.Triangles.empty())
  {
    for (const int corner : area.Triangles.front())
    {
      longest.push_back(area.Points[static_cast<std::size_t>(corner)]);
    }
  }
  return longest;
}

} // namespace VolumeHaptics
