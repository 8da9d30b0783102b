// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The immutable snapshot of everything that a servo tick reads.
 *
 * Spaces: *index* (0 ... samples - 1 along each axis of the array), *world* (the units of the
 * image, mm for CT) and *device* (metres; tip, proxy and force). Device and world differ by a
 * similarity, so that a volume feels equally stiff at any size on the screen.
 *
 * A model is built outside the servo thread, and never changes afterwards. It keeps the scalar
 * array alive through HapticModelDescription::Samples and borrows its memory: nothing is copied.
 */
#ifndef HapticModel_h
#define HapticModel_h

#include "Core/Field/ResidentBox.h"
#include "Core/Model/BakedVolume.h"

#include <vector>

namespace VolumeHaptics
{

/** A baked volume, touched with a device that is placed in its world. */
class HapticModel
{
public:
  explicit HapticModel(const HapticModelDescription& description);
  ///@{
  /**
   * Makes a model of the same volume, with another device or another placement, without baking
   * again.
   */
  HapticModel(const HapticModel& other, const Affine3& deviceToWorld, const ForceCaps& deviceCaps);
  HapticModel(std::shared_ptr<const BakedVolume> baked, const Affine3& deviceToWorld,
    const ForceCaps& deviceCaps);
  ///@}
  HapticModel(const HapticModel&) = delete;
  HapticModel& operator=(const HapticModel&) = delete;

  /** Below this stiffness (N/m) nothing is felt: the proxy follows the tip. */
  static constexpr double MinimumStiffness = 1e-3;

  const std::shared_ptr<const BakedVolume> Baked;
  /**
   * The tighter of the user's and the device's caps: no stiffness or damping is felt above them.
   */
  const ForceCaps Caps;

  const Affine3 DeviceToWorld;
  const Affine3 WorldToDevice;
  const Affine3 DeviceToIndex;
  const Matrix3 DeviceToWorldRotation;
  const double WorldUnitsPerMeter;
  /** The largest number of index steps along any axis for a vector of 1 m. */
  const Vector3 VoxelsPerMeter;
  const double MostVoxelsPerMeter; ///< index steps in 1 m along the axis of the smallest spacing
  /** Turns a gradient per index step into scalar units per world unit along the device's axes. */
  const Matrix3 GradientToDevice;
  /** Stands in for the normal without a gradient: the volume's third axis. */
  const Vector3 FallbackNormal;
  /**
   * Whether the kernel's length depends on the direction, because it is KernelRadius voxels along
   * that direction. False for cubic voxels and with the solver PAPER.
   */
  const bool HasLengthByDirection;
  /** Whether the distinctness depends on the direction: HapticMaterial::IsDistinctFromNoise. */
  const bool HasNoiseByDirection;
  /**
   * KernelRadius times the largest spacing, in metres: with the solver PAPER and for cubes, the
   * distance of x_s and x_v from the proxy; otherwise, the largest such distance.
   */
  const double KernelLength;
  const double InverseRadius; ///< 1/KernelRadius
  /**
   * Turns a gradient per index step, over its magnitude in device space, into x_s - x_p at
   * KernelLength: see ComputeReach.
   */
  const Matrix3 GradientToReach;
  /** The vector x_s - x_p, as index steps, where there is no gradient. */
  const Vector3 FallbackReach;
  const ResidentBox Resident; ///< the resident samples in Baked->Field
  ///@{
  /** Maps from an index of the volume, and from the device, to an index of the label image. */
  const Affine3 IndexToLabel;
  const Affine3 DeviceToLabel;
  ///@}
  /**
   * Turns a gradient per index step of the label image into one per world unit, along the device's
   * axes.
   */
  const Matrix3 LabelGradientToDevice;
  /**
   * The counterparts of HasLengthByDirection and KernelLength at a wall between labels:
   * KernelRadius voxels of the coarser image.
   */
  const bool HasLabelLengthByDirection;
  const double LabelReach;
  /**
   * The counterpart of GradientToReach for a gradient per index step of the label image, and
   * LabelReach.
   */
  const Matrix3 LabelGradientToReach;
  /** The most index steps in 1 m: of the volume or, if its walls are felt, of the label image. */
  const double MostStepsPerMeter;

  /**
   * Returns the length of KernelRadius voxels along a direction whose unit vector has these index
   * steps.
   */
  double KernelLengthOf(const Vector3& steps) const noexcept
  {
    return this->Baked->Kernel.Radius / std::fmax(Norm(steps), 1e-300);
  }
  /**
   * Returns the distance (m) of x_s and x_v from a proxy whose surface has this normal (unit or
   * zero).
   */
  double KernelLengthAlong(const Vector3& normal) const noexcept
  {
    return this->HasLengthByDirection ? this->KernelLengthOf(this->DeviceToIndex.Linear * normal)
                                      : this->KernelLength;
  }
  /**
   * Returns x_s - x_p (index steps) for a vector in its direction; the same as GradientToReach for
   * cubes.
   */
  Vector3 ComputeReach(const Vector3& direction) const noexcept
  {
    return this->HasLengthByDirection ? this->KernelLengthOf(direction) * direction : direction;
  }
  /**
   * Returns W_d and the visibility of a gradient, given its magnitude (per world unit) and its
   * direction.
   */
  DistinctnessTable::Values DistinctnessOf(double magnitude, const Vector3& normal) const noexcept
  {
    DistinctnessTable::Values values = this->Baked->Distinctness(magnitude);
    if (this->HasNoiseByDirection)
    {
      // Returns 1 along the axis of the smallest spacing.
      const double voxels = Norm(this->DeviceToIndex.Linear * normal) / this->MostVoxelsPerMeter;
      values[0] = this->Baked->Distinctness(magnitude / std::fmax(voxels, 1e-300))[0];
    }
    return values;
  }
  /** Does the same as KernelLengthAlong, at a wall between labels. */
  double LabelReachAlong(const Vector3& normal) const noexcept;

  bool IsCutAway(const Vector3& world) const noexcept
  {
    return this->Baked->Cut &&
      this->Baked->Cut->Compute(this->DeviceToIndex(this->WorldToDevice(world))).Depth < 0.0;
  }
  /** Returns the index steps of a displacement (m), in the finer of the felt images. */
  double StepsOf(const Vector3& displacement) const noexcept
  {
    const double steps = Norm(this->DeviceToIndex.Linear * displacement);
    return this->Baked->FeelsLabels()
      ? std::fmax(steps, Norm(this->DeviceToLabel.Linear * displacement))
      : steps;
  }

  /** Returns 0 at the volume's border, rising to 1 one kernel radius inside. */
  double BorderFade(const Vector3& index) const noexcept
  {
    const double fade = this->Baked->Field.DistanceToBorder(index) * this->InverseRadius;
    return fade < 1.0 ? (fade > 0.0 ? fade : 0.0) : 1.0;
  }

  /** Returns V at a device position, and at a data time if the volume moves. */
  double ValueAtDevice(const Vector3& device, double time = 0.0) const noexcept
  {
    return this->Baked->At(time).Value(this->DeviceToIndex(device));
  }

  /** Returns the label at a device position; NoLabel if there is none. */
  std::int64_t LabelAtDevice(const Vector3& device) const noexcept
  {
    return this->Baked->Labels ? this->Baked->Labels->View.Nearest(this->DeviceToLabel(device))
                               : NoLabel;
  }

  /** Returns the tables that every tick reads, without the samples and the mesh. */
  std::vector<MemoryRange> GetTables() const;

  /** Returns the size (bytes) of the model without the image. */
  std::size_t GetMemorySize() const;
};

} // namespace VolumeHaptics

#endif
