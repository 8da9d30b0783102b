// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The changed bricks that are not shown yet.
 */
#ifndef FollowedBricks_h
#define FollowedBricks_h

#include "Core/Carving/TissueRemoval.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

/** A follower of the bricks of a removal. */
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
   * Checks for changes; returns whether there are any. If there are more followers than the bricks
   * support, any change marks all bricks.
   */
  bool Follow()
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
      bricks.TakeChanged(this->Follower, note);
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
  /** Calls f(brick) for each waiting brick, and forgets them. */
  template <typename F>
  void Take(F&& f)
  {
    for (const std::uint32_t brick : this->Waiting)
    {
      this->Waits[brick] = false;
      f(brick);
    }
    this->Waiting.clear();
  }
  /** Calls f(brick) for all existing bricks, and forgets the waiting ones. */
  template <typename F>
  void TakeAll(F&& f)
  {
    this->Take([](std::uint32_t) {});
    const std::uint32_t count = this->Removal->Bricks.GetCount();
    for (std::uint32_t brick = 0; brick < count; ++brick)
    {
      f(brick);
    }
  }

private:
  /** The number of followers that the bricks can still have: a recording needs one. */
  static constexpr int KeptFree = 1;

  std::shared_ptr<TissueRemoval> Removal;
  int Follower;
  std::uint64_t Changes = 0; ///< number of changes at the last look without being a follower
  std::vector<bool> Waits;
  std::vector<std::uint32_t> Waiting;
};

} // namespace VolumeHaptics

#endif
