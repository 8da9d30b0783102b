// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes, brick by brick and for display, an array's values after a tool has removed tissue. The
 * array itself is never changed, because the servo reads it.
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

/** Converts a number to the nearest value of a type. */
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
    // Compare before the cast, because the limits of 64-bit integers are rounded when they become
    // doubles. NaN becomes the lowest value.
    return !(rounded > static_cast<double>(Limits::lowest())) ? Limits::lowest()
      : rounded >= static_cast<double>(Limits::max())         ? Limits::max()
                                                              : static_cast<T>(rounded);
  }
}

/** Point array of an image, with the removed tissue of one of its components. */
struct CarvedArray
{
  vtkSmartPointer<vtkDataArray> Array; ///< samples, x fastest
  int Component = 0;
  std::int64_t Dimensions[3] = { 0, 0, 0 };
  /**
   * Index of the array's first sample in the volume whose tissue is removed; not 0 if the array is
   * a region of that volume.
   */
  std::int64_t First[3] = { 0, 0, 0 };
  std::shared_ptr<TissueRemoval> Removal;
  double Air = 0.0; ///< value of a sample whose tissue was removed

  bool IsSame(const CarvedArray& other) const
  {
    return this->Array == other.Array && this->Component == other.Component &&
      std::equal(this->Dimensions, this->Dimensions + 3, other.Dimensions) &&
      std::equal(this->First, this->First + 3, other.First) && this->Removal == other.Removal &&
      this->Air == other.Air;
  }
};

/** A box of samples, in indices that start at the array's first sample. */
struct ArrayBox
{
  std::int64_t Low[3];
  std::int64_t Size[3];

  std::int64_t Samples() const { return this->Size[0] * this->Size[1] * this->Size[2]; }
};

/** Content of a brick to read: with removed tissue taken out, or as if nothing had been removed. */
enum class BrickContent : std::uint8_t
{
  Left,
  Whole
};

/** Computes the box of a brick's samples. Returns false if the array contains none of them. */
bool ComputeBrickBox(const CarvedArray& carved, std::uint32_t brick, ArrayBox& box);

/**
 * Writes the tuples of a brick, x fastest, in the array's type. Integers are rounded, and values
 * outside the type's range are clamped.
 */
void CopyBrick(const CarvedArray& carved, std::uint32_t brick, BrickContent content,
  const ArrayBox& box, std::vector<unsigned char>& to);

/**
 * Writes the tuples of CopyBrick() as floats, each component multiplied by its scale, plus its
 * bias.
 */
void CopyBrickAsFloat(const CarvedArray& carved, std::uint32_t brick, BrickContent content,
  const ArrayBox& box, const float* scale, const float* bias, std::vector<unsigned char>& to);

/** Collects the changed bricks of a removal until they are displayed. */
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
   * Collects the bricks that have changed, and returns whether there are any. If the removal can't
   * have another follower, any change marks all bricks.
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
  /** Calls f(brick) for each collected brick, and clears the collection. */
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
  /** Calls f(brick) for all existing bricks, and clears the collection. */
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
  /** Number of followers that must remain possible, because a recording needs one. */
  static constexpr int KeptFree = 1;

  std::shared_ptr<TissueRemoval> Removal;
  int Follower;
  std::uint64_t Changes = 0; ///< number of changes at the last poll, used if this object is not a
                             ///< follower
  std::vector<bool> Waits;
  std::vector<std::uint32_t> Waiting;
};

} // namespace VolumeHaptics

#endif
