// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the point in several half-spaces that is nearest to a goal. A proxy that touches several
 * faces at once moves to this point.
 */
#ifndef HalfSpaces_h
#define HalfSpaces_h

#include "Core/Math/Vector3.h"

#include <array>

namespace VolumeHaptics
{

/** A half-space: all points y with normal . y >= bound. */
struct HalfSpace
{
  Vector3 Normal; ///< unit vector
  double Bound;
};

/** The half-spaces of the few faces that a proxy touches. */
class HalfSpaces
{
public:
  static constexpr int Most = 16;

  void Clear() noexcept { this->Count = 0; }
  int GetCount() const noexcept { return this->Count; }

  /**
   * Adds a half-space. If a stored one has almost the same normal, keeps only the larger bound.
   * Ignores the new half-space if Most are stored.
   */
  void Add(const HalfSpace& space) noexcept;

  /**
   * Returns the point in all half-spaces that is nearest to a goal, or `fallback` if there is no
   * such point. Uses an active set of at most three half-spaces.
   */
  Vector3 Nearest(const Vector3& goal, const Vector3& fallback) const noexcept;

private:
  std::array<HalfSpace, Most> Spaces;
  int Count = 0;
};

} // namespace VolumeHaptics

#endif
