// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes walls between labels directly from the label image, without a distance field or
 * smoothing beforehand.
 *
 * The fraction of a set of labels around a position x,
 *
 *   u(x) = sum of w(x - x_i) over the voxels i of the set,   sum of all w = 1,
 *
 * with the weights w of the Gaussian kernel (GradientKernel.h), is smooth although labels are not.
 * Labels have an order (LabelTable::OrderOf), and a set contains a label and all harder labels.
 * There is a wall where the set and the remaining labels have equal fractions. Its value is u_in -
 * u_out = 2 u - 1, and its normal is the gradient of the value, which points to the harder side.
 * The sets are nested, so that walls never cross. Near several walls, the nearest counts.
 * - 1 is its value and the gradient of that its normal, into the harder side. The sets are nested,
 * so that walls never cross. Near several walls, the nearest counts.
 *
 * The kernel is wider than that of gradients. For a radius r it is cut at r + 1 voxels of the label
 * image, and its standard deviation is s = 0.355 (r + 1), 1.4 voxels for r = 3. The wall of a ball
 * with radius R is s^2 / R inside the ball, and a sheet thinner than 1.35 s between equal labels
 * has no wall.
 *
 * In FineLabels, which resolve boundaries within voxels, each voxel counts for its two labels with
 * their fractions.
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
 * The voxels that the last lookup read around a cell of the label image. The next lookups usually
 * need the same voxels, and become faster. The memory changes no result.
 */
struct WallMemory
{
  std::uint64_t Walls = 0; ///< number of the LabelWalls that used the memory; 0 if none did
  std::int64_t Cell[3] = {};
  bool HasWall = false; ///< whether the voxels have two labels; without two there is no wall
  ///@{
  /**
   * Whether the label covers one end, the whole or nothing of each row of voxels. If not, the
   * lookup uses Planes, as in LabelBlock.
   */
  bool HasSteps = false;
  LabelSteps Steps = {};
  std::uint64_t Planes[LabelBlock::Taps] = {};
  ///@}
};

/** Computes walls. Owns neither the view's memory nor the table. */
class LabelWalls
{
public:
  /**
   * Makes walls for a label image. `radius` is the kernel's radius in voxels of the label image.
   * `fractions` come from the FineLabels with this view, or are null.
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
   * Returns the strength factor of walls near the image's border: 0 at the border, and 1 from one
   * kernel radius inside.
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
  /**
   * Return the table that every tick reads if the kernel has the default radius, and its size
   * (bytes).
   */
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
  /** Like Gather(), from voxels with fractions. */
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
