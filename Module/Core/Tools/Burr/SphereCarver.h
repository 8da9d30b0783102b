// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the cost of removing a sphere from a volume, and removes it.
 *
 * After a sphere of radius a around c is removed, the fraction at x is at most
 *
 *   rho = r + (|x - c| - a)/w,   from 0 to 1,   r = (V_c - V_air)/(V - V_air),
 *
 * where w is the length of three voxels along their longest axis. A sample of value V with the
 * fraction r has the level V_c. The remaining surface is therefore at |x - c| = a, to a small
 * fraction of a voxel, in any tissue, and has smooth normals.
 *
 * The removed volume is the volume that the surface (rho = r) passes through: the remaining volume
 * of each voxel falls from 1 to 0 between rho = r + 1/12 and r - 1/12, as far as fractions allow.
 * (The sum of rho itself would belong to a sphere whose surface is three voxels wide. For a cap of
 * height h it exceeds the volume by pi w^2 (a + h)/12, which in a CT is several times the cap's
 * volume.) The cost is computed from the energy U of the label at each sample, or U(V) if the label
 * has none. Samples that are not solid cost nothing. Bricks without solid samples in and around
 * them do not change.
 *
 * If a brick is needed and none is left, nothing of the sphere, or of the current part, is removed.
 *
 * A sphere that takes longer than a tick is removed in parts, brick by brick in the order of their
 * positions. Each sample's fraction depends only on the sphere, so all parts together leave the
 * same fractions as the whole.
 */
#ifndef SphereCarver_h
#define SphereCarver_h

#include "Core/Carving/TissueRemoval.h"
#include "Core/Model/HapticModel.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** Energy (J/mm^3) to remove tissue, by value, in channel 0. */
using SpecificEnergyTable = PiecewiseTable<2>;

/** Describes the tissue that is carved. */
struct CarvedTissue
{
  double Level = 0.0;   ///< level beyond which the value of a sample is solid
  bool IsBelow = false; ///< whether values below the level are solid, instead of values above
  const SpecificEnergyTable* SpecificEnergy = nullptr;
};

/** The part of a sphere to remove. By default, it is the whole sphere. */
struct CarvingPart
{
  /** Index of the brick with which the part begins. The previous part ended there. */
  std::uint32_t First = 0;
  std::size_t MostWork = ~std::size_t{ 0 }; ///< work after which no more bricks are started
};

/** The cost of a sphere, or of a part of it, and the amount of tissue that it removes. */
struct CarvingCost
{
  double Energy = 0.0;     ///< energy needed for the removal (J)
  double Volume = 0.0;     ///< volume of solid tissue (mm^3)
  std::size_t Work = 0;    ///< measure of time: 1 for a row of unchanged samples
  std::size_t Changes = 0; ///< number of rows of samples that change
  /** Index of the brick with which the next part begins; 0 if the sphere is complete. */
  std::uint32_t Next = 0;
  bool IsUsedUp = false; ///< whether the sphere needs more bricks than are left
};

/** Removes spheres from the volume of one model at a time. Its memory does not grow. */
class SphereCarver
{
public:
  /** Width w of the ramp, in voxels along the axis with the longest ones. */
  static constexpr double RampWidth = 3.0;
  /** Fraction of the ramp over which a voxel loses its volume. */
  static constexpr double CountedPart = 1.0 / 6.0;
  /** Limit of the work for one brick. A part may exceed CarvingPart::MostWork by this amount. */
  static constexpr std::size_t MostWorkOfBrick = 1385;

  SphereCarver();

  /**
   * Sets model and tissue. Must be called first in each tick. The samples are read as if nothing
   * were removed.
   */
  void SetTissue(const HapticModel& model, const CarvedTissue& tissue) noexcept;
  /** Returns the side (m) of a cube with the volume of a voxel. */
  double GetVoxel() const noexcept { return this->Voxel; }
  double GetRampWidth() const noexcept { return RampWidth * this->Longest; }

  /**
   * Computes the changes that the removal of a sphere would make. Returns their cost.
   * @param centre in m, in the device's space
   * @param from centre of a sphere with the same radius that was removed before; may be null
   */
  CarvingCost Try(const TissueRemoval& removal, const Vector3& centre, double radius,
    const Vector3* from = nullptr, const CarvingPart& part = {}) noexcept;
  /** Appends the ranges of memory that a tick writes. */
  void AppendTables(std::vector<MemoryRange>& tables) const;
  /** Removes the tissue of the last trial. */
  void Carve(TissueRemoval& removal) const noexcept;

private:
  /** A row of samples with new fractions. */
  struct Change
  {
    std::uint64_t Key;
    std::uint64_t Fractions;
    int Row;
  };
  struct Sphere;
  static constexpr std::size_t MostChanges = 8192;
  static constexpr std::size_t Remembered = 4096;

  template <typename T>
  CarvingCost TryTyped(
    const CarvedBricks& bricks, const Sphere& sphere, const CarvingPart& wanted) noexcept;
  template <typename T>
  bool LookAt(const CarvedBricks& bricks, const Sphere& sphere, const BrickPlace& place,
    CarvingCost& cost) noexcept;
  template <typename T>
  bool IsAnySolid(const BrickPlace& place) noexcept;
  /** Returns the fraction r at which a sample has the level, as at the sphere's surface. */
  double ComputeEdge(double value) const noexcept;
  /** Returns U (J/mm^3) at a sample, given its value and index. */
  double ComputeEnergy(double value, const Vector3& index) const noexcept;

  VolumeView View; ///< the volume; Data points to its first sample
  Affine3 ToIndex;
  Vector3 Step[3]; ///< index step along each axis (m)
  double Voxel = 0.0;
  double Longest = 0.0; ///< longest side of a voxel (m)
  double Volume = 0.0;  ///< volume of a voxel (mm^3)
  /** Distance of the farthest change from the sphere's surface, in widths of the ramp. */
  double Reach = 1.0;
  double Air = 0.0; ///< value of a sample without tissue
  CarvedTissue Tissue;
  const BakedLabels* Labels = nullptr; ///< null if no label has its own energy
  Affine3 ToLabel; ///< maps an index of the volume to an index of the label image
  std::uint64_t Model = 0;
  std::vector<Change> Changes;
  std::size_t Count = 0;
  /**
   * For each slot, the key plus one of a brick without solid samples. It makes later trials faster.
   */
  std::vector<std::uint64_t> Empty;
};

} // namespace VolumeHaptics

#endif
