// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A label image with thick slices, on a finer grid whose voxels are nearly cubes.
 *
 * Walls of labels (LabelWalls.h) come from sums over voxels. With thick slices the steps between
 * slices are longer than the kernel's width across them, and walls would be stairs. Between slices,
 * labels are therefore interpolated by their shape (S. P. Raya and J. K. Udupa, "Shape-based
 * interpolation of multidimensional objects", IEEE Trans. Med. Imaging 9, 1990; G. T. Herman, J.
 * Zheng and C. A. Bucholtz, "Shape-based interpolation", IEEE Comput. Graph. Appl. 12(3), 1992):
 *
 * - in each slice a label has a signed distance S to its boundary, above 0 inside;
 * - along the slices' axis S is a cubic between slices, without overshoot (F. N. Fritsch and R. E.
 *   Carlson, SIAM Journal on Numerical Analysis 17, 1980);
 * - at a fine voxel the label with the largest S wins, and the fraction of the label with the
 *   second largest S sets where the boundary between two voxels is.
 *
 * The distances are smoothed along the slice, because pixels make stairs, too, but not where a
 * label or a gap is thinner than eight fine voxels, so that thin parts keep their shape. In a slice
 * that lacks a label, the label has a distance of some slices, so that it ends between both slices.
 */
#ifndef FineLabels_h
#define FineLabels_h

#include "Core/Field/LabelView.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

class FineLabels
{
public:
  /** A spacing up to this multiple of the finest spacing is not refined. */
  static constexpr double LargestRatio = 1.5;
  /**
   * Limit of the fine voxels, which use 2 to 9 bytes each. If an image would need more, its fine
   * voxels become longer.
   */
  static constexpr std::int64_t MostVoxels = std::int64_t{ 1 } << 28;
  /**
   * Largest number of pixels, summed over the bounding boxes of all labels. Each pixel costs about
   * 100 ns.
   */
  static constexpr std::int64_t MostWork = std::int64_t{ 1 } << 30;
  /** Number of parts that a voxel has in GetFractions(). */
  static constexpr int Parts = 254;

  using Body = std::function<void(std::int64_t)>;
  /**
   * Calls a function with each number below `count`, in any order, possibly in parallel. To cancel
   * Make(), a loop leaves out numbers; then the result must not be used.
   */
  using Loop = std::function<void(std::int64_t count, const Body& body)>;

  /**
   * Returns the number of fine voxels per voxel of the image along each axis. All are 1 if no finer
   * grid is needed.
   */
  static Vector3 ChooseSteps(
    const LabelView& view, const Vector3& spacing, std::int64_t mostVoxels = MostVoxels);

  /**
   * Makes the finer grid of an image. Returns null if the spacings are similar, or if the image is
   * too large or has too many labels; then walls come from the image's own voxels. If `last` was
   * made from an earlier version of the same image, only changed slices are computed again.
   * @param spacing spacing of the image, above 0
   * @param mostVoxels limit of the fine voxels: MostVoxels, or less in tests
   */
  static std::shared_ptr<const FineLabels> Make(const LabelView& view, const Vector3& spacing,
    const Loop& loop = nullptr, const FineLabels* last = nullptr,
    std::int64_t mostVoxels = MostVoxels);

  FineLabels(const FineLabels&) = delete;
  FineLabels& operator=(const FineLabels&) = delete;

  const LabelView& GetView() const noexcept { return this->View; }
  /**
   * Returns the number of fine voxels per voxel of the image along each axis. The first samples of
   * both grids coincide.
   */
  const Vector3& GetSteps() const noexcept { return this->Steps; }
  /**
   * Returns, for each sample of GetView(), the fraction of the voxel that has another label, in
   * units of 1 / Parts. This label is that of the first neighbour with a different label.
   * Neighbours are searched axis by axis, along each axis first at the lower index.
   */
  const std::uint8_t* GetFractions() const noexcept { return this->Fractions.data(); }
  /** Returns the size of the object in bytes. */
  std::size_t GetMemorySize() const noexcept
  {
    return sizeof(*this) + this->Labels.capacity() + this->Fractions.capacity() +
      this->Hashes.capacity() * sizeof(std::uint64_t);
  }
  /** Returns the number of slices that Make() computed. Slices from `last` do not count. */
  std::int64_t GetSlicesFound() const noexcept { return this->SlicesFound; }

private:
  FineLabels() = default;
  /** Refines an image along one axis. */
  struct Pass;

  LabelView View;
  Vector3 Steps{ 1, 1, 1 };
  std::vector<std::byte> Labels;
  std::vector<std::uint8_t> Fractions;
  ///@{
  /**
   * Data with which the next Make() finds the slices that have not changed. There is one hash for
   * each slice, or none if more than one axis was refined.
   */
  std::vector<std::uint64_t> Hashes;
  Vector3 Spacing;
  ///@}
  std::int64_t SlicesFound = 0;
};

} // namespace VolumeHaptics

#endif
