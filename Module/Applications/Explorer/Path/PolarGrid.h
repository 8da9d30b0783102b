// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_PolarGrid_h
#define Explore_PolarGrid_h

#include <vector>

namespace Explore
{
/// A regular grid over two angles, with the operations that a map of distances needs.
class PolarGrid
{
public:
  static constexpr double STEP = 4.0; // degrees

  PolarGrid(double rightLimit, double upLimit);

  int Size() const { return this->Columns * this->Rows; }
  double Right(int node) const { return (node % this->Columns) * STEP - this->RightLimit; }
  double Up(int node) const { return (node / this->Columns) * STEP - this->UpLimit; }

  /// Fills negative nodes (nothing found) from their neighbours, takes the median of each 3 x 3
  /// neighbourhood and smooths. At least one node must be above zero.
  void Clean(std::vector<double>& map) const;
  void Smooth(std::vector<double>& map) const;

  /// Catmull-Rom interpolation; angles beyond the grid are clamped.
  double Interpolate(const std::vector<double>& map, double right, double up) const;

private:
  template <typename Visitor>
  void VisitNeighbours(int node, Visitor visit) const;
  void Fill(std::vector<double>& map) const;

  double RightLimit, UpLimit;
  int Columns, Rows;
};
} // namespace Explore

#endif
