// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Path/PolarGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int SMOOTHING_PASSES = 2;

/// Catmull-Rom weights of the four nodes around fraction t.
void CubicWeights(double t, double weights[4])
{
  weights[0] = 0.5 * t * (t * (2.0 - t) - 1.0);
  weights[1] = 0.5 * (t * t * (3.0 * t - 5.0) + 2.0);
  weights[2] = 0.5 * t * (t * (4.0 - 3.0 * t) + 1.0);
  weights[3] = 0.5 * t * t * (t - 1.0);
}
} // namespace

namespace Explore
{
PolarGrid::PolarGrid(double rightLimit, double upLimit)
  : RightLimit(rightLimit)
  , UpLimit(upLimit)
  , Columns(static_cast<int>(2.0 * rightLimit / STEP) + 1)
  , Rows(static_cast<int>(2.0 * upLimit / STEP) + 1)
{
}

template <typename Visitor>
void PolarGrid::VisitNeighbours(int node, Visitor visit) const
{
  const int column = node % this->Columns, row = node / this->Columns;
  for (int r = std::max(0, row - 1); r <= std::min(this->Rows - 1, row + 1); ++r)
  {
    for (int c = std::max(0, column - 1); c <= std::min(this->Columns - 1, column + 1); ++c)
    {
      visit(r * this->Columns + c);
    }
  }
}

void PolarGrid::Fill(std::vector<double>& map) const
{
  bool hole = true;
  while (hole)
  {
    hole = false;
    const std::vector<double> before = map;
    for (int node = 0; node < this->Size(); ++node)
    {
      if (before[node] > 0.0)
      {
        continue;
      }
      double sum = 0.0;
      int count = 0;
      this->VisitNeighbours(node,
        [&](int other)
        {
          sum += before[other] > 0.0 ? before[other] : 0.0;
          count += before[other] > 0.0 ? 1 : 0;
        });
      map[node] = count > 0 ? sum / count : map[node];
      hole = hole || count == 0;
    }
  }
}

void PolarGrid::Smooth(std::vector<double>& map) const
{
  const std::vector<double> before = map;
  for (int node = 0; node < this->Size(); ++node)
  {
    double sum = 0.0;
    int count = 0;
    this->VisitNeighbours(node,
      [&](int other)
      {
        sum += before[other];
        count += 1;
      });
    map[node] = sum / count;
  }
}

void PolarGrid::Clean(std::vector<double>& map) const
{
  this->Fill(map);
  const std::vector<double> before = map;
  for (int node = 0; node < this->Size(); ++node)
  {
    std::vector<double> around;
    this->VisitNeighbours(node, [&](int other) { around.push_back(before[other]); });
    std::nth_element(around.begin(), around.begin() + around.size() / 2, around.end());
    map[node] = around[around.size() / 2];
  }
  for (int pass = 0; pass < SMOOTHING_PASSES; ++pass)
  {
    this->Smooth(map);
  }
}

double PolarGrid::Interpolate(const std::vector<double>& map, double right, double up) const
{
  const double x = std::clamp((right + this->RightLimit) / STEP, 0.0, this->Columns - 1.0);
  const double y = std::clamp((up + this->UpLimit) / STEP, 0.0, this->Rows - 1.0);
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  double across[4], along[4], sum = 0.0;
  CubicWeights(x - column, across);
  CubicWeights(y - row, along);
  for (int j = 0; j < 4; ++j)
  {
    const int r = std::clamp(row - 1 + j, 0, this->Rows - 1);
    for (int i = 0; i < 4; ++i)
    {
      const int c = std::clamp(column - 1 + i, 0, this->Columns - 1);
      sum += along[j] * across[i] * map[r * this->Columns + c];
    }
  }
  return sum;
}
} // namespace Explore
