// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Haptic primitives: the four simple potentials of which a mode is made.
 *
 * With x the proxy, c the anchor, q the unit direction and s the strength (N):
 *
 * | kind  | potential                  | feel                                              |
 * | ----- | -------------------------- | ------------------------------------------------- |
 * | Force | -s q.x                     | pushes with s along q                             |
 * | Point | s abs(x - c)               | holds at c up to s, beyond that pulls to it       |
 * | Line  | s abs((I - q q^T) (x - c)) | holds on the line through c along q in this way   |
 * | Plane | s max(0, -(x - c).q)       | a wall; its free side is the one to which q points|
 *
 * All are convex, and but for Force their forces are at most s. So is what PrimitiveSolver.h makes
 * of them.
 */
#ifndef Primitive_h
#define Primitive_h

#include "Core/Math/Vector3.h"
#include "Core/State/PrimitiveMemory.h"

#include <array>
#include <cstdint>

namespace VolumeHaptics
{

enum class PrimitiveKind : std::uint8_t
{
  Force,
  Point,
  Line,
  Plane
};

struct Primitive
{
  PrimitiveKind Kind = PrimitiveKind::Force;
  Vector3 Direction;     ///< of any length, but not 0; Point has none
  Vector3 Anchor;        ///< m; Force has none
  double Strength = 0.0; ///< N
};

/** The primitives of a tick. Neither allocates nor throws. */
class PrimitiveSet
{
public:
  static constexpr int Most = MostPrimitives;
  /** N. More than this holds as firmly as this does. */
  static constexpr double MostStrength = 1e6;
  /** m. An anchor beyond this is an error. */
  static constexpr double FarthestAnchor = 1e9;

  /**
   * Adds a primitive, with a direction of unit length. One without a strength, a direction or an
   * anchor (0, negative, NaN, or infinite) keeps its place in the set, but has the strength 0;
   * except that an infinite strength holds with MostStrength, if it does not push. Without a
   * strength the direction stays as it is. False if the set is full.
   */
  bool Add(const Primitive& primitive) noexcept;

  void Clear() noexcept { this->Size = 0; }
  int GetSize() const noexcept { return this->Size; }
  const Primitive& operator[](int i) const noexcept { return this->Items[i]; }
  const Primitive* begin() const noexcept { return this->Items.data(); }
  const Primitive* end() const noexcept { return this->Items.data() + this->Size; }

  /** The most that they pull with, together (N). */
  double SumStrengths() const noexcept;

private:
  std::array<Primitive, Most> Items;
  int Size = 0;
};

} // namespace VolumeHaptics

#endif
