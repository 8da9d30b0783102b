// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The surface of a tool as points with areas.
 */
#ifndef PointShell_h
#define PointShell_h

#include "Core/Math/Vector3.h"

#include <cstddef>
#include <vector>

namespace VolumeHaptics
{

/**
 * A point of a tool's surface, in the tool's own frame and in any unit of length (see
 * ShellSettings::Scale), and the area that it stands for.
 */
struct ShellPoint
{
  Vector3 Position;
  double Area = 0.0; ///< more than 0
};

/** How a shell is felt. */
struct ShellSettings
{
  double Level = 0.0;               ///< V_c
  bool IsBelow = false;             ///< whether values below the level are solid
  double ContactArea = 2.5e-5;      ///< m^2, the area to which materials refer
  double CouplingStiffness = 500.0; ///< N/m, between hand and tool
  double TurningStiffness = 0.5;    ///< N m/rad, between hand and tool
  double Scale = 1.0;               ///< m, length of the shell's unit
};

/** A block of 64 neighbouring points; the last one may have fewer. */
struct ShellBlock
{
  static constexpr std::size_t Size = 64;

  Vector3 Centre; ///< the radius of a sphere that contains all points of the block
  double Radius = 0.0;
};

/**
 * The surface of a tool, immutable. The points are ordered so that neighbours in space are
 * neighbours in memory, and their numbers are laid out for reading several at a time.
 */
class PointShell
{
public:
  /**
   * Makes a shell of points; leaves out points with a number that is not finite, or without an
   * area.
   */
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
  double GetArea() const noexcept { return this->Area; }   ///< area of all points
  double GetReach() const noexcept { return this->Reach; } ///< largest distance from the origin
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
