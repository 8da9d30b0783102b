// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A surface that guides a hand, either at a distance from a mesh, or at a level of a distance
 * field.
 *
 * For a mesh, let p be the nearest place, n its normal, and u the direction from p to the position,
 * reversed behind the mesh. The surface at the distance a goes through p + a u with the normal u;
 * at the distance 0 the normal is n. For a field, let d be the distance, a cubic B-spline of the
 * samples, and g its gradient. The surface is at (a - d) g/|g|^2 from the position. Where |g| is
 * less than a half, a place is equally far from several parts of the surface and has no single
 * direction. There, and within two voxels of the field's border, the hold fades.
 */
#ifndef GuideSurface_h
#define GuideSurface_h

#include "Core/Field/FieldSampler.h"
#include "Core/Model/GuideMesh.h"

#include <memory>

namespace VolumeHaptics
{

/** The place on a guiding surface that is nearest to a position. */
struct GuideSurfacePlace
{
  Vector3 Anchor;
  Vector3 Normal;        ///< unit vector towards larger distances
  double Distance = 0.0; ///< distance from the surface to the position
  double Fraction = 0.0; ///< factor of the holding strength, 0 to 1; 0 if there is no place
};

/** A surface that guides a hand. Immutable. All lengths are in world units. */
class GuideSurface
{
public:
  GuideSurface(std::shared_ptr<const GuideMesh> mesh, double distance);
  /**
   * Makes a surface from a level of a distance field. `view` shows `samples`, which this object
   * keeps alive.
   */
  GuideSurface(const VolumeView& view, std::shared_ptr<const void> samples,
    const Affine3& indexToWorld, double distance);
  GuideSurface(const GuideSurface&) = delete; // not copied, because Field refers to Kernel
  void operator=(const GuideSurface&) = delete;

  GuideSurfacePlace Find(const Vector3& position) const noexcept;

  /** Returns whether another surface is the same level of the same mesh or samples. */
  bool IsSame(const GuideSurface& other) const noexcept;
  std::size_t GetMemorySize() const noexcept;

private:
  GuideSurfacePlace FindOnMesh(const Vector3& position) const noexcept;
  GuideSurfacePlace FindInField(const Vector3& position) const noexcept;

  std::shared_ptr<const GuideMesh> Mesh; ///< null if the surface is from a field
  std::shared_ptr<const void> Samples;
  GradientKernel Kernel;
  FieldSampler Field;
  Affine3 WorldToIndex;
  double Distance;
};

} // namespace VolumeHaptics

#endif
