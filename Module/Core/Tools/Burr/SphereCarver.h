// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Removes a sphere from a volume, after computing its cost.
 *
 * A sphere of radius a around c leaves at x at most the fraction
 *
 *   rho = r + (|x - c| - a)/w,   from 0 to 1,   r = (V_c - V_air)/(V - V_air),
 *
 * with w three voxels, or the length of three where they are longest. With the fraction r a sample
 * of value V has the level V_c. So the remaining surface lies at |x - c| = a, to a small fraction
 * of a voxel, in any tissue, and has smooth normals.
 *
 * The removed volume is the volume that the surface (rho = r) sweeps over: the remainder of each
 * voxel falls from 1 to 0 between rho = r + 1/12 and r - 1/12, as far as fractions reach. (The sum
 * of rho itself belongs to a sphere whose surface is three voxels wide: for a cap that is h deep,
 * it has pi w^2 (a + h)/12 more, in a CT several times the cap's volume.) It costs the energy U of
 * the label at its samples, or U(V) if the label has none; samples that are not solid cost nothing.
 * Bricks without solid samples in and around them stay as they are.
 *
 * If a brick is needed and none is left, the sphere, or its part, is not removed at all.
 *
 * A sphere that takes longer than a tick is removed in parts: bricks in the order of their places.
 * Each sample's fraction depends on the sphere alone, so that the parts leave the same fractions as
 * the whole.
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

/** The energy (J/mm^3) for removing tissue, by value: channel 0. */
using SpecificEnergyTable = PiecewiseTable<2>;

/** Which tissue is carved. */
struct CarvedTissue
{
  double Level = 0.0;   ///< samples with a value beyond the level are solid
  bool IsBelow = false; ///< if true, samples with a value below the level are solid
  const SpecificEnergyTable* SpecificEnergy = nullptr;
};

/** The part of a sphere to remove: all of it, if there is time. */
struct CarvingPart
{
  std::uint32_t First = 0; ///< an index into the sphere's places of bricks, at which the last part
                           ///< ended
  std::size_t MostWork = ~std::size_t{ 0 }; ///< after this much work, no further brick is begun
};

/** The cost of a sphere, or of a part of one, and how much it removes. */
struct CarvingCost
{
  double Energy = 0.0;     ///< J
  double Volume = 0.0;     ///< mm^3, of solid tissue
  std::size_t Work = 0;    ///< time: 1 for a row of samples that does not change
  std::size_t Changes = 0; ///< changed rows of samples
  std::uint32_t Next = 0;  ///< index at which the next part begins; 0: the sphere is complete
  bool IsUsedUp = false;   ///< whether the sphere needs more bricks than there are
};

/** Removes spheres from the volume of one model at a time. Its memory never grows. */
class SphereCarver
{
public:
  /** The width w of the ramp, in voxels along the axis where they are longest. */
  static constexpr double RampWidth = 3.0;
  /** The largest part of the ramp in which a voxel loses its volume. */
  static constexpr double CountedPart = 1.0 / 6.0;
  /** A part does at most CarvingPart::MostWork and the work of one brick. */
  static constexpr std::size_t MostWorkOfBrick = 1385;

  SphereCarver();

  /**
   * Sets model and tissue. Call this first in each tick. Reads the samples of the model as if
   * nothing was removed.
   */
  void SetTissue(const HapticModel& model, const CarvedTissue& tissue) noexcept;
  /** Returns the side (m) of a cube with the volume of a voxel. */
  double GetVoxel() const noexcept { return this->Voxel; }
  /** Returns the width of the ramp (m). */
  double GetRampWidth() const noexcept { return RampWidth * this->Longest; }

  /**
   * Computes the changes that removing a sphere would make, and returns their cost.
   * @param centre in m, in the device's space
   * @param from if not null, a sphere of the same radius that was removed before
   */
  CarvingCost Try(const TissueRemoval& removal, const Vector3& centre, double radius,
    const Vector3* from = nullptr, const CarvingPart& part = {}) noexcept;
  /** Appends the memory that a tick writes. */
  void AppendTables(std::vector<MemoryRange>& tables) const;
  /** Removes the tissue of the last trial. */
  void Carve(TissueRemoval& removal) const noexcept;

private:
  /** A row of new fractions. */
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
  /** Returns the fraction with which a sample has the level, as at the sphere's surface. */
  double ComputeEdge(double value) const noexcept;
  /** Returns U, J/mm^3, at the sample of an index. */
  double ComputeEnergy(double value, const Vector3& index) const noexcept;

  VolumeView View; ///< Data points to the volume's first sample
  Affine3 ToIndex;
  Vector3 Step[3]; ///< m, an index step along each axis
  double Voxel = 0.0;
  double Longest = 0.0; ///< m, the longest side of a voxel
  double Volume = 0.0;  ///< mm^3, the volume of a voxel
  double Reach = 1.0;   ///< in ramps: the distance of the farthest change from a sphere's surface
  double Air = 0.0;     ///< the value of a sample without tissue
  CarvedTissue Tissue;
  const BakedLabels* Labels = nullptr; ///< null: no label has its own energy
  Affine3 ToLabel;                     ///< maps an index of the volume to the label image
  std::uint64_t Model = 0;
  std::vector<Change> Changes;
  std::size_t Count = 0;
  /** Keys, plus one, of bricks without solid samples; for speed only. */
  std::vector<std::uint64_t> Empty;
};

} // namespace VolumeHaptics

#endif
