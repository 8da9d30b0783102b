// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Haptic primitives are the four simple potentials from which modes are made.
 *
 * x is the proxy, c the anchor, q the unit direction and s the strength (N):
 *
 * | kind  | potential                  | feel                                              |
 * | ----- | -------------------------- | ------------------------------------------------- |
 * | Force | -s q.x                     | pushes with s along q                             |
 * | Point | s abs(x - c)               | holds at c up to s, beyond that pulls to it       |
 * | Line  | s abs((I - q q^T) (x - c)) | holds on the line through c along q in this way   |
 * | Plane | s max(0, -(x - c).q)       | a wall; its free side is the one to which q points|
 *
 * All of them are convex, and their forces are at most s, except for Force. The composition in
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
  Vector3 Direction;     ///< direction of any length except 0; not used by Point
  Vector3 Anchor;        ///< anchor in m; not used by Force
  double Strength = 0.0; ///< strength (N)
};

/** The primitives of a tick. No function allocates or throws. */
class PrimitiveSet
{
public:
  static constexpr int Most = MostPrimitives;
  /** Largest strength (N). Larger strengths are reduced to it. */
  static constexpr double MostStrength = 1e6;
  /** Largest coordinate of an anchor (m). An anchor farther away is an error. */
  static constexpr double FarthestAnchor = 1e9;

  /**
   * Adds a primitive, and scales its direction to unit length. A primitive whose strength,
   * direction or anchor is not valid (0, negative, NaN or infinite) is added with the strength 0.
   * An infinite strength becomes MostStrength, except for a push. If the strength is 0, the
   * direction does not change. Returns false if the set is full.
   */
  bool Add(const Primitive& primitive) noexcept;

  void Clear() noexcept { this->Size = 0; }
  int GetSize() const noexcept { return this->Size; }
  const Primitive& operator[](int i) const noexcept { return this->Items[i]; }
  const Primitive* begin() const noexcept { return this->Items.data(); }
  const Primitive* end() const noexcept { return this->Items.data() + this->Size; }

  /** Returns the sum of all strengths (N), which is the largest possible sum of the forces. */
  double SumStrengths() const noexcept;

private:
  std::array<Primitive, Most> Items;
  int Size = 0;
};

} // namespace VolumeHaptics

#endif
