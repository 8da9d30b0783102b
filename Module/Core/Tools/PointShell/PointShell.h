// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The surface of a tool, as points with areas.
 */
#ifndef PointShell_h
#define PointShell_h

#include "Core/Math/Vector3.h"

#include <cstddef>
#include <vector>

namespace VolumeHaptics
{

/**
 * A point of a tool's surface, in the tool's own frame and in any unit of length
 * (ShellSettings::Scale), with the area of the surface around it.
 */
struct ShellPoint
{
  Vector3 Position;
  double Area = 0.0; ///< area, more than 0
};

/** Haptic settings of a shell. */
struct ShellSettings
{
  double Level = 0.0;               ///< V_c, the level of contact
  bool IsBelow = false;             ///< whether values below the level are solid
  double ContactArea = 2.5e-5;      ///< area to which materials refer (m^2)
  double CouplingStiffness = 500.0; ///< stiffness between hand and tool (N/m)
  double TurningStiffness = 0.5;    ///< stiffness against rotation between hand and tool (N m/rad)
  double Scale = 1.0;               ///< the shell's unit of length (m)
};

/** A block of 64 neighbouring points. The last block may have fewer. */
struct ShellBlock
{
  static constexpr std::size_t Size = 64;

  Vector3 Centre; ///< centre of a sphere that contains all points of the block
  double Radius = 0.0;
};

/**
 * The surface of a tool. Immutable. The points are ordered so that neighbours in space are
 * neighbours in memory, and each coordinate has its own array, so that several points can be read
 * at a time.
 */
class PointShell
{
public:
  /**
   * Makes a shell of points. Drops points without an area, or with a number that is not finite.
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
  double GetArea() const noexcept { return this->Area; } ///< sum of all areas
  /** Largest distance of a point from the origin. */
  double GetReach() const noexcept { return this->Reach; }
  /** Returns the memory use (bytes). */
  std::size_t GetMemorySize() const noexcept;

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
