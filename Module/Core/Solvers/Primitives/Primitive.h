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
 * All are convex, and except for Force their forces are at most s. The composition of
 * PrimitiveSolver.h has the same properties.
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
  Vector3 Direction;     ///< direction of any length but 0; Point has none
  Vector3 Anchor;        ///< m; Force has none
  double Strength = 0.0; ///< N
};

/** The primitives of a tick. Neither allocates nor throws. */
class PrimitiveSet
{
public:
  static constexpr int Most = MostPrimitives;
  /** N. Larger strengths hold as firmly as this one. */
  static constexpr double MostStrength = 1e6;
  /** m. A farther anchor is an error. */
  static constexpr double FarthestAnchor = 1e9;

  /**
   * Adds a primitive, with a direction of unit length. A primitive without a valid strength,
   * direction or anchor (0, negative, NaN, or infinite) keeps its place in the set, but has the
   * strength 0; an infinite strength holds with MostStrength, unless it pushes. Without a strength
   * the direction stays as given. Returns false if the set is full.
   */
  bool Add(const Primitive& primitive) noexcept;

  void Clear() noexcept { this->Size = 0; }
  int GetSize() const noexcept { return this->Size; }
  const Primitive& operator[](int i) const noexcept { return this->Items[i]; }
  const Primitive* begin() const noexcept { return this->Items.data(); }
  const Primitive* end() const noexcept { return this->Items.data() + this->Size; }

  /** Returns the sum of all strengths (N): the largest sum of the primitives' forces. */
  double SumStrengths() const noexcept;

private:
  std::array<Primitive, Most> Items;
  int Size = 0;
};

} // namespace VolumeHaptics

#endif
