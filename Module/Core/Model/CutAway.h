// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of a volume that is cut away and can't be felt.
 *
 * A volume can be cut in three ways: by planes (as in vtkAbstractMapper::SetClippingPlanes), by
 * cropping regions (as in vtkVolumeMapper::SetCroppingRegionPlanes: two planes of constant index
 * along each axis, which make 27 regions), and by a list of hidden voxels. The rest is kept. Let
 * s_i be the signed distance to a plane, positive in the part that the plane keeps, and s_0 the
 * signed distance to the faces of the regions. Then
 *
 *   depth(x) = min_i s_i(x)
 *
 * is positive in the kept part, 0 on its faces, and nowhere larger than the distance to them. The
 * index axes must be perpendicular to one another in the world. For hidden voxels, let t be the
 * fraction of the eight surrounding voxels that are kept, interpolated linearly. The faces of
 * hidden voxels are at t = 1/2, halfway between a hidden voxel and a kept one. If t is neither 0
 * nor 1, the depth there is t - 1/2 times the length of a voxel.
 */
#ifndef CutAway_h
#define CutAway_h

#include "Core/Math/Vector3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

/** A plane. The part to which its normal points is kept. */
struct CutPlane
{
  Vector3 Normal; ///< unit vector in the world
  double Offset;  ///< Dot(Normal, x) for any x (world) on the plane

  friend bool operator==(const CutPlane& a, const CutPlane& b) noexcept
  {
    return a.Normal.X == b.Normal.X && a.Normal.Y == b.Normal.Y && a.Normal.Z == b.Normal.Z &&
      a.Offset == b.Offset;
  }
};

/** Regions between planes of constant index. */
struct CutRegions
{
  static constexpr std::uint32_t All = (std::uint32_t{ 1 } << 27) - 1;
  double Low[3] = {};
  double High[3] = {};
  /**
   * Bit x + 3 y + 9 z is set if region (x, y, z) is kept. x is 0 below Low[0], 1 between Low[0] and
   * High[0], and 2 above High[0]; y and z likewise.
   */
  std::uint32_t Kept = All;

  friend bool operator==(const CutRegions& a, const CutRegions& b) noexcept
  {
    return a.Kept == b.Kept && std::equal(a.Low, a.Low + 3, b.Low) &&
      std::equal(a.High, a.High + 3, b.High);
  }
};

/** Voxels that are hidden individually, by a flag for each point of an image. */
struct HiddenVoxels
{
  const std::uint8_t* Flags = nullptr; ///< one flag per voxel, x fastest; may be null
  std::uint8_t Hidden = 0;             ///< bit of a flag that is set for a hidden voxel
  std::int64_t First[3] = {};          ///< index of the voxel with the first flag
  std::int64_t Dimensions[3] = {};
  std::shared_ptr<const void> Holder; ///< keeps the memory of Flags alive
  std::uint64_t Version = 0;          ///< a number that changes whenever the flags change

  /**
   * Returns 1 if a voxel is kept, and 0 if it is hidden. An index outside the image stands for the
   * nearest voxel in it.
   */
  double IsKept(std::int64_t i, std::int64_t j, std::int64_t k) const noexcept;

  friend bool operator==(const HiddenVoxels& a, const HiddenVoxels& b) noexcept
  {
    return a.Flags == b.Flags && a.Version == b.Version;
  }
};

/** A position, relative to the nearest face of the kept part. */
struct CutPlace
{
  double Depth = HUGE_VAL; ///< depth (world units); below 0 in the part that is cut away
  Vector3 Normal;          ///< unit vector in the world, into the kept part
  double Voxel = 1.0;      ///< length of an index step along Normal in world units
  /**
   * Faces of the nearest region that is cut away. A bit is set if the position is on or behind the
   * face, or at most `TouchDistance` in front of it, so several bits are set in a hollow corner.
   * The face of an axis towards the lower index is bit 2 axis, and the face towards the higher
   * index bit 2 axis + 1.
   */
  std::uint32_t Faces = 0;

  /**
   * Returns the fraction of the force that is felt. It falls from 1 to 0 over the last voxel in
   * front of a face.
   */
  double Fraction() const noexcept { return std::clamp(this->Depth / this->Voxel, 0.0, 1.0); }
};

/** The cut of a volume. Immutable. */
class CutAway
{
public:
  /** A position touches a face within this distance (voxels). */
  static constexpr double TouchDistance = 5e-3;

  /** @param isSolid whether the faces can be touched, like the material behind them */
  CutAway(std::vector<CutPlane> planes, const CutRegions& regions, const Affine3& indexToWorld,
    bool isSolid, HiddenVoxels hidden = {});

  CutPlace Compute(const Vector3& index) const noexcept;
  /**
   * Returns the normal of a face in CutPlace::Faces, a unit vector in the world that points into
   * the kept part.
   */
  Vector3 GetNormal(int face) const noexcept
  {
    return face % 2 == 0 ? -this->Axes[face / 2].Normal : this->Axes[face / 2].Normal;
  }
  /**
   * Returns where a motion (index space) ends that begins in a region that is cut away, or at one
   * of its faces. The motion stops at the next face, because solid faces hold as soon as they are
   * touched. Only regions stop a motion, because the faces of planes form no hollow corners.
   */
  Vector3 StopAtFaces(const Vector3& from, const Vector3& to) const noexcept;
  bool IsSolid() const noexcept { return this->HasSolidFaces; }

  bool IsSame(const CutAway& other) const noexcept
  {
    return this->Planes == other.Planes && this->Regions == other.Regions &&
      this->HasSolidFaces == other.HasSolidFaces && this->Hidden == other.Hidden;
  }

private:
  struct Axis
  {
    Vector3 Normal;       ///< unit vector (world) normal to the planes of constant index
    double WorldPerIndex; ///< distance between planes of consecutive indices
  };
  /**
   * A region as seen from a position: how far (world units) the position is behind the region's
   * lower and higher plane along each axis.
   */
  struct Beyond
  {
    double Low[3];
    double High[3];
    double Behind(int face) const noexcept
    {
      return face % 2 == 0 ? this->Low[face / 2] : this->High[face / 2];
    }
    double Distance() const noexcept;
    /**
     * Returns the vector (world units) from the region's nearest point to the position; zero inside
     * the region.
     */
    Vector3 Direction(const Axis (&axes)[3]) const noexcept;
  };

  bool IsKept(int region) const noexcept { return (this->Regions.Kept >> region & 1U) != 0; }
  /** Returns whether a position touches a face, given its distance behind the face. */
  bool IsAt(int face, double aside) const noexcept
  {
    return aside > -TouchDistance * this->Axes[face / 2].WorldPerIndex;
  }
  int FindRegionOf(const Vector3& index) const noexcept;
  /**
   * Returns the number of the nearest kept region (or cut region, if not isKept), and writes the
   * distance from the index to this region to `distance`. Returns -1 if no such region exists.
   */
  int FindNearest(const Vector3& index, bool isKept, double& distance) const noexcept;
  /** Returns whether a kept region is behind a face of a region that is cut away. */
  bool HasFace(int region, int face) const noexcept;
  Beyond ComputeBeyond(const Vector3& index, int region) const noexcept;
  CutPlace ComputeRegion(const Vector3& index) const noexcept;
  CutPlace ComputeHidden(const Vector3& index) const noexcept;

  const std::vector<CutPlane> Planes;
  std::vector<double> Voxels; ///< for each plane, the length of a voxel along its normal
  const CutRegions Regions;
  const Affine3 IndexToWorld;
  const Matrix3 WorldToIndex;
  Axis Axes[3]; ///< index axes
  const bool HasSolidFaces;
  const HiddenVoxels Hidden;
};

} // namespace VolumeHaptics

#endif
