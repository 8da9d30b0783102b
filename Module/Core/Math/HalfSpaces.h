// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The nearest point in some half-spaces: the goal of a proxy that touches several faces at once.
 */
#ifndef HalfSpaces_h
#define HalfSpaces_h

#include "Core/Math/Vector3.h"

#include <array>

namespace VolumeHaptics
{

/** The points y with normal . y >= bound. */
struct HalfSpace
{
  Vector3 Normal; ///< unit
  double Bound;
};

/** The half-spaces of the faces that a proxy touches; a few. */
class HalfSpaces
{
public:
  static constexpr int Most = 16;

  void Clear() noexcept { this->Count = 0; }
  int GetCount() const noexcept { return this->Count; }

  /**
   * Adds a half-space. If a stored half-space has almost the same normal, the larger bound of both
   * is kept instead. Otherwise a half-space is ignored once Most are stored.
   */
  void Add(const HalfSpace& space) noexcept;

  /**
   * Returns the point in all half-spaces that is nearest to a goal, found with an active set of at
   * most three; `fallback` if there is none.
   */
  Vector3 Nearest(const Vector3& goal, const Vector3& fallback) const noexcept;

private:
  std::array<HalfSpace, Most> Spaces;
  int Count = 0;
};

} // namespace VolumeHaptics

#endif
