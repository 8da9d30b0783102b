// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The surface of a tool as points with areas.
 */
#ifndef PointShell_h
#define PointShell_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"

#include <cstddef>
#include <vector>

namespace VolumeHaptics
{

/** A point of a tool's surface, in the tool's own frame, and the area that it stands for. */
struct ShellPoint
{
  Vector3 Position;  ///< m
  double Area = 0.0; ///< m^2, more than 0
};

/** Where a tool is: its frame in that of the device. */
struct ShellPose
{
  Vector3 Position;       ///< m, of the frame's origin
  Quaternion Orientation; ///< a unit quaternion
};

/** Some points that are neighbours: 64, the last ones fewer. */
struct ShellBlock
{
  static constexpr std::size_t Size = 64;

  Vector3 Centre;      ///< m, of a sphere that has all of them
  double Radius = 0.0; ///< m
};

/**
 * The surface of a tool, immutable. The points are ordered so that neighbours in space are
 * neighbours in memory, and their numbers are laid out for reading several at a time.
 */
class PointShell
{
public:
  /** Leaves out points that have a number that is not finite, or no area. */
  explicit PointShell(std::vector<ShellPoint> points);

  std::size_t GetSize() const noexcept { return this->Areas.size(); }
  const double* GetX() const noexcept { return this->X.data(); }
  const double* GetY() const noexcept { return this->Y.data(); }
  const double* GetZ() const noexcept { return this->Z.data(); }
  const double* GetAreas() const noexcept { return this->Areas.data(); }
  const std::vector<ShellBlock>& GetBlocks() const noexcept { return this->Blocks; }
  Vector3 GetPosition(std::size_t i) const noexcept
  {
    return { this->X[i], this->Y[i], this->Z[i] };
  }
  double GetArea() const noexcept { return this->Area; }   ///< m^2, of all points
  double GetReach() const noexcept { return this->Reach; } ///< m, of the farthest from the origin
  std::size_t GetMemorySize() const noexcept;              ///< bytes

private:
  std::vector<double> X;
  std::vector<double> Y;
  std::vector<double> Z;
  std::vector<double> Areas;
  std::vector<ShellBlock> Blocks;
  double Area = 0.0;
  double Reach = 0.0;
};

} // namespace VolumeHaptics

#endif
