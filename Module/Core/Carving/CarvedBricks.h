// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The remaining fraction of the tissue at each sample of a volume.
 *
 * A fraction is a byte; 255 means that all tissue remains. Fractions are stored only where tissue
 * was removed, in bricks of 8^3 samples. A fixed number of bricks is allocated at once, and a hash
 * of fixed size locates them, so that no memory grows with the volume.
 *
 * One thread writes, without a lock or an allocation. Any other thread may read at any time, but
 * the rows of a brick may then come from different moments. A few threads may follow the changes:
 * each receives every brick that was written since its last call, even if it calls rarely.
 */
#ifndef CarvedBricks_h
#define CarvedBricks_h

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace VolumeHaptics
{

/** The position of a brick along each axis, counted in bricks. */
struct BrickPlace
{
  std::int64_t X;
  std::int64_t Y;
  std::int64_t Z;
};

class CarvedBricks
{
public:
  static constexpr int Side = 8;  ///< number of samples along each side of a brick
  static constexpr int Shift = 3; ///< shift that converts a sample's index to its brick's index
  /**
   * A row is 8 samples along x, one byte each. The row at (y, z) in a brick has the number y + 8 z.
   */
  static constexpr int Rows = Side * Side;
  static constexpr std::uint64_t WholeRow = ~std::uint64_t{ 0 };
  static constexpr std::uint8_t Whole = 255;
  static constexpr std::uint32_t None = ~std::uint32_t{ 0 };
  static constexpr std::uint32_t DefaultMost = 16384; ///< default limit of bricks (8 MiB)
  static constexpr int MostFollowers = 8;
  /** Limit of a brick's position along each axis, because a key has 21 bits per axis. */
  static constexpr std::int64_t PlaceLimit = std::int64_t{ 1 } << 21;

  /** Allocates all memory, and writes to all of it, so that no page fault occurs later. */
  explicit CarvedBricks(std::uint32_t most = DefaultMost);
  CarvedBricks(const CarvedBricks&) = delete;
  CarvedBricks& operator=(const CarvedBricks&) = delete;

  static std::uint64_t KeyOf(const BrickPlace& place) noexcept
  {
    return static_cast<std::uint64_t>(place.X) | static_cast<std::uint64_t>(place.Y) << 21 |
      static_cast<std::uint64_t>(place.Z) << 42;
  }
  static BrickPlace PlaceOf(std::uint64_t key) noexcept
  {
    constexpr std::uint64_t mask = (std::uint64_t{ 1 } << 21) - 1;
    return { static_cast<std::int64_t>(key & mask), static_cast<std::int64_t>(key >> 21 & mask),
      static_cast<std::int64_t>(key >> 42) };
  }

  ///@{
  /**
   * Return the limit of bricks, the number of bricks in use, and whether none is in use. Any thread
   * may call these functions.
   */
  std::uint32_t GetMost() const noexcept { return this->Most; }
  std::uint32_t GetCount() const noexcept { return this->Count.load(std::memory_order_acquire); }
  bool IsEmpty() const noexcept { return this->Count.load(std::memory_order_relaxed) == 0; }
  /** Returns whether all tissue remains. If it does, the call has to read all bricks. */
  bool IsWhole() const noexcept;
  bool IsWhole(std::uint32_t brick) const noexcept;
  /** Returns a counter that grows with each call of MarkChanged. */
  std::uint64_t GetChanges() const noexcept
  {
    return this->Changes.load(std::memory_order_acquire);
  }
  /** Returns the number of a brick, 0 to GetCount() - 1; None if all of its tissue remains. */
  std::uint32_t Find(std::uint64_t key) const noexcept
  {
    for (std::uint64_t slot = this->SlotOf(key);; slot = (slot + 1) & this->SlotMask)
    {
      const std::uint32_t brick = this->Slots[slot].load(std::memory_order_acquire);
      if (brick == None || this->Keys[brick] == key)
      {
        return brick;
      }
    }
  }
  std::uint64_t GetKey(std::uint32_t brick) const noexcept { return this->Keys[brick]; }
  std::uint64_t GetRow(std::uint32_t brick, int row) const noexcept
  {
    return this->Fractions[RowAt(brick, row)].load(std::memory_order_relaxed);
  }
  /** Returns the remaining fraction (0 to Whole) at a sample. Its indices must not be negative. */
  std::uint8_t GetFraction(std::int64_t i, std::int64_t j, std::int64_t k) const noexcept;
  /** Returns whether any sample in a box of indices, both ends included, is in a brick. */
  bool HasBricks(const std::int64_t* low, const std::int64_t* high) const noexcept;
  ///@}

  ///@{
  /**
   * Returns the number of a brick. If the brick does not exist, adds it with all of its tissue;
   * returns None if there is no room. Only the writer may call this.
   */
  std::uint32_t FindOrAdd(std::uint64_t key) noexcept;
  void SetRow(std::uint32_t brick, int row, std::uint64_t fractions) noexcept
  {
    this->Fractions[RowAt(brick, row)].store(fractions, std::memory_order_relaxed);
  }
  /** Marks a brick as changed for all followers. Call this after SetRow(). */
  void MarkChanged(std::uint32_t brick) noexcept
  {
    this->Changed[brick / BricksOfWord].fetch_or(
      AllFollowers << MostFollowers * (brick % BricksOfWord), std::memory_order_release);
    this->Changes.store(
      this->Changes.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }
  ///@}

  ///@{
  /**
   * Registers a follower, for which all bricks count as changed at first. Returns the follower's
   * number, or -1 if fewer than keptFree places for followers would remain. Any thread may call
   * this.
   */
  int AddFollower(int keptFree = 0) noexcept;
  void RemoveFollower(int follower) noexcept
  {
    this->Followers.fetch_and(~(1U << follower), std::memory_order_release);
  }
  ///@}

  /**
   * Called by a follower: calls f(brick) for each brick that has changed since the last call. The
   * data that f reads are at least as new as the change.
   */
  template <typename F>
  void DrainChanged(int follower, F&& f)
  {
    constexpr std::uint64_t first = 0x0101010101010101; // the bits of the first follower
    const std::uint64_t mine = first << follower;
    const std::uint32_t count = this->GetCount();
    for (std::uint32_t word = 0; BricksOfWord * word < count; ++word)
    {
      if ((this->Changed[word].load(std::memory_order_relaxed) & mine) == 0)
      {
        continue;
      }
      std::uint64_t changed =
        (this->Changed[word].fetch_and(~mine, std::memory_order_acquire) & mine) >> follower;
      for (std::uint32_t brick = BricksOfWord * word; changed != 0;
           changed >>= MostFollowers, ++brick)
      {
        if ((changed & 1) != 0)
        {
          f(brick);
        }
      }
    }
  }

  /** Returns the memory use (bytes). */
  std::size_t GetMemorySize() const noexcept;

private:
  static constexpr std::uint32_t BricksOfWord = 64 / MostFollowers;
  static constexpr std::uint64_t AllFollowers = (1U << MostFollowers) - 1;

  static std::size_t RowAt(std::uint32_t brick, int row) noexcept
  {
    return std::size_t{ brick } * Rows + static_cast<std::size_t>(row);
  }
  std::uint64_t SlotOf(std::uint64_t key) const noexcept
  {
    return (key * 0x9e3779b97f4a7c15) >> this->SlotShift;
  }

  const std::uint32_t Most;
  std::uint64_t SlotMask = 0;
  int SlotShift = 0;
  /** Hash table of brick numbers, with at least twice as many slots as bricks. */
  std::unique_ptr<std::atomic<std::uint32_t>[]> Slots;
  std::unique_ptr<std::uint64_t[]> Keys; ///< key of each brick, written before the brick's slot
  std::unique_ptr<std::atomic<std::uint64_t>[]> Fractions;
  /** For each brick, one bit per possible follower. */
  std::unique_ptr<std::atomic<std::uint64_t>[]> Changed;
  std::atomic<std::uint64_t> Changes{ 0 };
  std::atomic<std::uint32_t> Followers{ 0 }; ///< one bit per existing follower
  std::atomic<std::uint32_t> Count{ 0 };
};

} // namespace VolumeHaptics

#endif
