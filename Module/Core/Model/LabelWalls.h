// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Walls between labels, straight from the label image: no distance field, no smoothing beforehand.
 *
 * The fraction of a set of labels around a position x,
 *
 *   u(x) = sum of w(x - x_i) over the voxels i of the set,   sum of all w = 1,
 *
 * with the weights of the Gaussian kernel (GradientKernel.h), is smooth although labels are not.
 * Labels have an order (LabelTable::OrderOf); a set contains a label and all harder labels. Where
 * the set and the remaining labels have equal fractions, there is a wall; u_in - u_out = 2 u
 * - 1 is its value and the gradient of that its normal, into the harder side. The sets are nested,
 * so that walls never cross. Near several walls, the nearest counts.
 *
 * The kernel is wider than that of gradients, and cut at r + 1 voxels of the label image for a
 * radius r: its standard deviation is s = 0.355 (r + 1), 1.4 voxels for r = 3. A wall on a ball of
 * radius R lies s^2 / R inside it, and a sheet thinner than 1.35 s between equal labels has no
 * wall.
 *
 * In FineLabels, which resolve boundaries within voxels, each voxel counts with the fractions of
 * its two labels.
 */
#ifndef LabelWalls_h
#define LabelWalls_h

#include "Core/Field/GradientKernel.h"
#include "Core/Field/LabelSampler.h"
#include "Core/Model/LabelTable.h"

#include <algorithm>

namespace VolumeHaptics
{

/** The wall that is nearest to a position. */
struct LabelWall
{
  bool IsThere = false;
  /** u_in - u_out: -1 far outside the harder labels, 0 on the wall, 1 far inside. */
  double Value = 0.0;
  Vector3 Gradient; ///< gradient of Value, per index step of the label image
};

/**
 * The voxels that the last lookup read, in a cell of the label image. The next lookups mostly need
 * the same voxels. The memory makes them faster and changes no result.
 */
struct WallMemory
{
  std::uint64_t Walls = 0; ///< number of the LabelWalls that used the memory; 0 if none did
  std::int64_t Cell[3] = {};
  bool HasWall = false; ///< whether the voxels have two labels; without two there is no wall
  ///@{
  /**
   * Whether the rows of the harder label are steps. If not, the lookup uses Planes, as in
   * LabelBlock.
   */
  bool HasSteps = false;
  LabelSteps Steps = {};
  std::uint64_t Planes[LabelBlock::Taps] = {};
  ///@}
};

/** Computes walls. Stores references to the view's memory and to the table. */
class LabelWalls
{
public:
  /**
   * Makes walls for a label image. `radius` is the kernel's radius in voxels of the label image.
   * `fractions`, unless null, are those of the FineLabels with this view.
   */
  LabelWalls(const LabelView& view, const LabelTable& table, int radius,
    const std::uint8_t* fractions = nullptr);
  LabelWalls(const LabelWalls&) = delete;
  LabelWalls& operator=(const LabelWalls&) = delete;

  ///@{
  /**
   * Returns the nearest wall at an index of the label image, or no wall if the index is outside the
   * image.
   */
  LabelWall Compute(const Vector3& index, WallMemory& memory) const noexcept;
  LabelWall Compute(const Vector3& index) const noexcept
  {
    WallMemory memory;
    return this->Compute(index, memory);
  }
  ///@}

  /**
   * Returns the factor of walls near the image's border: 0 at the border, 1 from one kernel radius
   * inside.
   */
  double BorderFade(const Vector3& index) const noexcept
  {
    const Vector3 inside = Least(index, this->Last - index);
    const double nearest = std::min(std::min(inside.X, inside.Y), inside.Z);
    return std::clamp(nearest * this->InverseRadius, 0.0, 1.0);
  }

  /** Returns the size (bytes) of the memory outside the object. */
  std::size_t GetMemorySize() const noexcept
  {
    return this->Kernel.Table.capacity() * sizeof(double) + this->Sampler.GetMemorySize();
  }

  ///@{
  /** Return the table that every tick reads if the kernel has the default radius. */
  const void* GetTable() const noexcept { return this->Sampler.GetMemory(); }
  std::size_t GetTableSize() const noexcept { return this->Sampler.GetMemorySize(); }
  ///@}

  /**
   * Standard deviation of the kernel's Gaussian, as a fraction of the length at which it is cut.
   */
  static constexpr double ScalePerCut = 0.55;

private:
  struct Taps;
  struct Around;
  using GatherFunction = void (*)(const VolumeView&, const Taps&, Around&) noexcept;

  template <typename T>
  static void Gather(const VolumeView& view, const Taps& taps, Around& around) noexcept;
  /** Gathers as Gather, from voxels with fractions. */
  template <typename T>
  static void GatherShared(const VolumeView& view, const Taps& taps, Around& around) noexcept;

  LabelWall ComputeInBlock(const Vector3& index, WallMemory& memory) const noexcept;
  /** Stores the labels of a block. Returns false if there are more than two labels. */
  bool Remember(const LabelBlock& block, WallMemory& memory) const noexcept;
  LabelWall ComputeInRuns(const Vector3& index) const noexcept;
  /**
   * Returns the nearest wall. fraction(i) returns the fraction of label i and the fraction's
   * gradient.
   */
  template <typename F>
  LabelWall FindNearest(int count, const std::int64_t* labels, F&& fraction) const noexcept;

  const GradientKernel Kernel;
  const VolumeView View;
  const LabelTable& Table;
  const std::uint64_t Number; ///< differs from the number of any other object
  Vector3 Last;               ///< largest index along each axis
  const double InverseRadius;
  const LabelSampler Sampler; ///< for the default radius of 3, whose taps fit into a LabelBlock
  const std::uint8_t* const Fractions;
  GatherFunction GatherFractions; ///< gathers for other radii, and for voxels with fractions
};

} // namespace VolumeHaptics

#endif
