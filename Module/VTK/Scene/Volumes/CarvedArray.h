// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The remaining values of an array from which a tool has removed tissue, brick by brick, for
 * display. The array itself is never changed, because the servo reads it.
 */
#ifndef CarvedArray_h
#define CarvedArray_h

#include "Core/Carving/TissueRemoval.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

/** Returns the value of a type that is nearest to a number. */
template <typename T>
T NearestOf(double value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return static_cast<T>(value);
  }
  else
  {
    using Limits = std::numeric_limits<T>;
    const double rounded = std::round(value);
    // The limits of 64-bit integers are rounded when they become doubles, so compare before the
    // cast. NaN becomes the lowest value.
    return !(rounded > static_cast<double>(Limits::lowest())) ? Limits::lowest()
      : rounded >= static_cast<double>(Limits::max())         ? Limits::max()
                                                              : static_cast<T>(rounded);
  }
}

/** The array of an image, of which one component has lost tissue. */
struct CarvedArray
{
  vtkSmartPointer<vtkDataArray> Array; ///< the array of the image's points, along x first
  int Component = 0;
  std::int64_t Dimensions[3] = { 0, 0, 0 };
  /**
   * The indices of the array's first sample in the volume whose tissue is removed. They are not 0
   * if the array is a region of that volume.
   */
  std::int64_t First[3] = { 0, 0, 0 };
  std::shared_ptr<TissueRemoval> Removal;
  double Air = 0.0; ///< the value of a sample without tissue

  bool IsSame(const CarvedArray& other) const
  {
    return this->Array == other.Array && this->Component == other.Component &&
      std::equal(this->Dimensions, this->Dimensions + 3, other.Dimensions) &&
      std::equal(this->First, this->First + 3, other.First) && this->Removal == other.Removal &&
      this->Air == other.Air;
  }
};

/** A box of an array. Its indices count from the array's first sample. */
struct ArrayBox
{
  std::int64_t Low[3];
  std::int64_t Size[3];

  std::int64_t Samples() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
};

/** Content to read of a brick: the remaining tissue, or all tissue as if nothing was removed. */
enum class BrickContent : std::uint8_t
{
  Left,
  Whole
};

/** Computes the box of a brick's samples. Returns false if none of them is in the array. */
bool ComputeBrickBox(const CarvedArray& carved, std::uint32_t brick, ArrayBox& box);

/**
 * Writes the tuples of a brick, along x first, in the array's own type. Integers are rounded, and
 * values beyond the type's range become its limits.
 */
void CopyBrick(const CarvedArray& carved, std::uint32_t brick, BrickContent content,
  const ArrayBox& box, std::vector<unsigned char>& to);

/**
 * Writes the tuples of CopyBrick() as float, each component multiplied by its scale, plus its bias.
 */
void CopyBrickAsFloat(const CarvedArray& carved, std::uint32_t brick, BrickContent content,
  const ArrayBox& box, const float* scale, const float* bias, std::vector<unsigned char>& to);

/** Collects the changed bricks of a removal until they are shown. */
class FollowedBricks
{
public:
  explicit FollowedBricks(std::shared_ptr<TissueRemoval> removal)
    : Removal(std::move(removal))
    , Follower(Removal->Bricks.AddFollower(KeptFree))
    , Waits(Removal->Bricks.GetMost(), false)
  {
  }
  ~FollowedBricks()
  {
    if (this->Follower >= 0)
    {
      this->Removal->Bricks.RemoveFollower(this->Follower);
    }
  }
  FollowedBricks(const FollowedBricks&) = delete;
  FollowedBricks& operator=(const FollowedBricks&) = delete;

  /**
   * Collects the bricks that have changed; returns whether there are any. If the removal has no
   * room for another follower, any change marks all bricks.
   */
  bool Poll()
  {
    CarvedBricks& bricks = this->Removal->Bricks;
    if (this->Follower < 0)
    {
      this->Follower = bricks.AddFollower(KeptFree);
    }
    bool isAny = false;
    const auto note = [this, &isAny](std::uint32_t brick)
    {
      isAny = true;
      if (!this->Waits[brick])
      {
        this->Waits[brick] = true;
        this->Waiting.push_back(brick);
      }
    };
    if (this->Follower >= 0)
    {
      bricks.DrainChanged(this->Follower, note);
      return isAny;
    }
    const std::uint64_t changes = bricks.GetChanges();
    const std::uint32_t count = changes == this->Changes ? 0 : bricks.GetCount();
    this->Changes = changes;
    for (std::uint32_t brick = 0; brick < count; ++brick)
    {
      note(brick);
    }
    return isAny;
  }
  /** Calls f(brick) for each collected brick, and forgets the collected bricks. */
  template <typename F>
  void Drain(F&& f)
  {
    for (const std::uint32_t brick : this->Waiting)
    {
      this->Waits[brick] = false;
      f(brick);
    }
    this->Waiting.clear();
  }
  /** Calls f(brick) for all existing bricks, and forgets the collected ones. */
  template <typename F>
  void DrainAll(F&& f)
  {
    this->Drain([](std::uint32_t) {});
    const std::uint32_t count = this->Removal->Bricks.GetCount();
    for (std::uint32_t brick = 0; brick < count; ++brick)
    {
      f(brick);
    }
  }

private:
  /**
   * Number of followers for which the removal must still have room, because a recording needs one.
   */
  static constexpr int KeptFree = 1;

  std::shared_ptr<TissueRemoval> Removal;
  int Follower;
  std::uint64_t Changes = 0; ///< number of changes at the last poll, if this is no follower
  std::vector<bool> Waits;
  std::vector<std::uint32_t> Waiting;
};

} // namespace VolumeHaptics

#endif
