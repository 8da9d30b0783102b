// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An immutable snapshot of everything that a servo tick reads.
 *
 * Spaces: *index* (0 ... samples - 1 along each axis of the array), *world* (the units of the
 * image, mm for CT) and *device* (metres; tip, proxy and force). The map from device to world is a
 * similarity, so that a volume feels equally stiff at any size on the screen.
 *
 * A model is built outside the servo thread, and never changes afterwards. It keeps the scalar
 * array alive through HapticModelDescription::Samples, and reads the array without copying it.
 */
#ifndef HapticModel_h
#define HapticModel_h

#include "Core/Field/ResidentBox.h"
#include "Core/Model/BakedVolume.h"

#include <vector>

namespace VolumeHaptics
{

/** A baked volume, felt with a device that is placed in the volume's world. */
class HapticModel
{
public:
  explicit HapticModel(const HapticModelDescription& description);
  ///@{
  /**
   * Copies a model, with another device or another placement. Bakes nothing again.
   */
  HapticModel(const HapticModel& other, const Affine3& deviceToWorld, const ForceCaps& deviceCaps);
  HapticModel(std::shared_ptr<const BakedVolume> baked, const Affine3& deviceToWorld,
    const ForceCaps& deviceCaps);
  ///@}
  HapticModel(const HapticModel&) = delete;
  HapticModel& operator=(const HapticModel&) = delete;

  /** Stiffness (N/m) below which nothing is felt; the proxy then moves with the tip. */
  static constexpr double MinimumStiffness = 1e-3;

  const std::shared_ptr<const BakedVolume> Baked;
  /**
   * Largest stiffness and damping that are felt. Each is the tighter of the user's and the device's
   * caps.
   */
  const ForceCaps Caps;

  const Affine3 DeviceToWorld;
  const Affine3 WorldToDevice;
  const Affine3 DeviceToIndex;
  const Matrix3 DeviceToWorldRotation;
  const double WorldUnitsPerMeter;
  /** Number of index steps in 1 m along each axis. */
  const Vector3 VoxelsPerMeter;
  /** Number of index steps in 1 m along the axis with the smallest spacing. */
  const double MostVoxelsPerMeter;
  /** Maps a gradient per index step to scalar units per world unit along the device's axes. */
  const Matrix3 GradientToDevice;
  /** Normal where there is no gradient. It is the direction of the volume's third axis. */
  const Vector3 FallbackNormal;
  /**
   * Whether the kernel's length depends on the direction, because it is KernelRadius voxels along
   * that direction. False for cubic voxels and for the solver Paper.
   */
  const bool HasLengthByDirection;
  /** Whether the distinctness depends on the direction (HapticMaterial::IsDistinctFromNoise). */
  const bool HasNoiseByDirection;
  /**
   * KernelRadius times the largest spacing, in metres. With the solver Paper or cubic voxels, this
   * is the distance of x_s and x_v from the proxy; otherwise it is the largest such distance.
   */
  const double KernelLength;
  const double InverseRadius; ///< 1/KernelRadius
  /**
   * 1 divided by the number of voxels along each axis over which surfaces fade at the volume's
   * border. The length of this band is KernelRadius times the smallest spacing or, with the solver
   * Paper, KernelRadius voxels.
   */
  const Vector3 FadePerVoxel;
  /**
   * Maps a gradient per index step, divided by its magnitude in device space, to x_s - x_p for the
   * length KernelLength (see ComputeReach).
   */
  const Matrix3 GradientToReach;
  /** Vector x_s - x_p (index steps) that is used where the field has no gradient. */
  const Vector3 FallbackReach;
  const ResidentBox Resident; ///< box of the samples that are in memory
  ///@{
  /** Map an index of the volume, and a device position, to an index of the label image. */
  const Affine3 IndexToLabel;
  const Affine3 DeviceToLabel;
  ///@}
  /**
   * Maps a gradient per index step of the label image to a gradient per world unit along the
   * device's axes.
   */
  const Matrix3 LabelGradientToDevice;
  /**
   * HasLengthByDirection and KernelLength for walls between labels. The length is KernelRadius
   * voxels of the coarser image.
   */
  const bool HasLabelLengthByDirection;
  const double LabelReach;
  /**
   * GradientToReach for a gradient per index step of the label image, and for the length
   * LabelReach.
   */
  const Matrix3 LabelGradientToReach;
  /**
   * The largest number of index steps in 1 m along any axis, of the volume and, if labels are felt,
   * of the label image.
   */
  const double MostStepsPerMeter;

  /**
   * Returns the length (m) of KernelRadius voxels along a direction. `steps` is the direction's
   * unit vector in index steps.
   */
  double KernelLengthOf(const Vector3& steps) const noexcept
  {
    return this->Baked->Kernel.Radius / std::fmax(Norm(steps), 1e-300);
  }
  /**
   * Returns the distance (m) of x_s and x_v from a proxy on a surface with this normal, which is a
   * unit vector or zero.
   */
  double KernelLengthAlong(const Vector3& normal) const noexcept
  {
    return this->HasLengthByDirection ? this->KernelLengthOf(this->DeviceToIndex.Linear * normal)
                                      : this->KernelLength;
  }
  /**
   * Returns x_s - x_p (index steps), given a vector from GradientToReach in the same direction.
   * With cubic voxels, it is this vector.
   */
  Vector3 ComputeReach(const Vector3& direction) const noexcept
  {
    return this->HasLengthByDirection ? this->KernelLengthOf(direction) * direction : direction;
  }
  /**
   * Returns W_d and the visibility of a gradient, given its magnitude (per world unit) and
   * direction.
   */
  DistinctnessTable::Values DistinctnessOf(double magnitude, const Vector3& normal) const noexcept
  {
    DistinctnessTable::Values values = this->Baked->Distinctness(magnitude);
    if (this->HasNoiseByDirection)
    {
      // For the axis with the smallest spacing, `voxels` is 1.
      const double voxels = Norm(this->DeviceToIndex.Linear * normal) / this->MostVoxelsPerMeter;
      values[0] = this->Baked->Distinctness(magnitude / std::fmax(voxels, 1e-300))[0];
    }
    return values;
  }
  /** KernelLengthAlong() for a wall between labels. */
  double LabelReachAlong(const Vector3& normal) const noexcept;

  bool IsCutAway(const Vector3& world) const noexcept
  {
    return this->Baked->Cut &&
      this->Baked->Cut->Compute(this->DeviceToIndex(this->WorldToDevice(world))).Depth < 0.0;
  }
  /**
   * Returns the length of a displacement (m) in index steps of the finest felt image.
   */
  double StepsOf(const Vector3& displacement) const noexcept
  {
    const double steps = Norm(this->DeviceToIndex.Linear * displacement);
    return this->Baked->FeelsLabels()
      ? std::fmax(steps, Norm(this->DeviceToLabel.Linear * displacement))
      : steps;
  }

  /**
   * Returns the strength factor of surfaces near the volume's border: 0 at the border, and 1 from
   * one kernel radius of the smallest spacing on.
   */
  double BorderFade(const Vector3& index) const noexcept
  {
    const Vector3 inside = this->Baked->Field.DistancesToBorder(index);
    const Vector3& per = this->FadePerVoxel;
    const double fade = std::min(std::min(inside.X * per.X, inside.Y * per.Y), inside.Z * per.Z);
    return fade < 1.0 ? (fade > 0.0 ? fade : 0.0) : 1.0;
  }

  /** Returns V at a device position and, if the volume moves, at a data time. */
  double ValueAtDevice(const Vector3& device, double time = 0.0) const noexcept
  {
    return this->Baked->At(time).Value(this->DeviceToIndex(device));
  }

  /** Returns the label at a device position, or NoLabel if there is none. */
  std::int64_t LabelAtDevice(const Vector3& device) const noexcept
  {
    return this->Baked->Labels ? this->Baked->Labels->View.Nearest(this->DeviceToLabel(device))
                               : NoLabel;
  }

  /** Returns the tables that every tick reads, without samples and mesh. */
  std::vector<MemoryRange> GetTables() const;

  /** Returns the size (bytes) of the model without its image. */
  std::size_t GetMemorySize() const;
};

} // namespace VolumeHaptics

#endif
