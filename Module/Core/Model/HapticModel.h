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
 * A model is built off the servo thread and never changes afterwards. It keeps the scalar array
 * alive through HapticModelDescription::Samples and borrows its memory: nothing is copied.
 */
#ifndef HapticModel_h
#define HapticModel_h

#include "Core/Field/FieldSampler.h"
#include "Core/Field/ResidentBox.h"
#include "Core/Math/PiecewiseTable.h"
#include "Core/Model/ForceCaps.h"

#include <memory>

namespace VolumeHaptics
{
class SurfaceMesh;

enum class HapticMethod : std::uint8_t
{
  Proxy,        ///< the paper's section 3
  ForceField,   ///< the paper's eq. 1
  SurfaceProxy, ///< a sphere on the triangles of a mesh; see SurfaceProxy.h
  LocalSurface  ///< a plane or quadric that a slow loop renews; see LocalSurfaceSolver.h
};

/** How Proxy advances the proxy in a tick. */
enum class HapticSolver : std::uint8_t
{
  Paper,  ///< as published, with one gradient a tick
  Precise ///< the same law in balance where the proxy ends; see PreciseSolver.h
};

/** Where a surface begins to hold; of HapticSolver::Precise. */
enum class ContactAlignment : std::uint8_t
{
  Distinctness, ///< where W_d and T_N say so
  Edge          ///< not before V(x_p) >= (V(x_s) + V(x_v))/2
};

/** What stands in for the surface near the proxy; of HapticMethod::LocalSurface. */
enum class LocalSurfaceShape : std::uint8_t
{
  Plane,
  Quadric
};

/** Which way a structure lies from its surface: where the scalar is higher, lower, or either. */
enum class SurfaceSide : std::uint8_t
{
  Higher,
  Lower,
  Both
};

struct HapticSettings
{
  HapticMethod Method = HapticMethod::Proxy;
  HapticSolver Solver = HapticSolver::Precise;
  ContactAlignment Alignment = ContactAlignment::Distinctness;
  SurfaceSide Side = SurfaceSide::Higher;
  double TickPeriod = 1e-3; ///< s
  ForceCaps Caps;
  double MaximumForce = 0.0;      ///< N on the hand; 0 does not limit
  double ForceFieldGain = 0.0;    ///< C1 of eq. 1, N per (scalar per world unit)
  double ForceFieldDamping = 0.0; ///< C2 of eq. 1, N s/m
  double IsoValue = 0.0;          ///< of the surface of SurfaceProxy and LocalSurface
  bool HasIsoSurface = false;     ///< the surface is where V is IsoValue, not another mesh
  double ProxyRadius = 0.5;       ///< world units, more than 0; of SurfaceProxy
  bool ForceShading = true;       ///< of SurfaceProxy, where the mesh has normals
  double LocalSurfaceRate = 60.0; ///< Hz, of the slow loop of LocalSurface
  double RecoveryTime = 0.015;    ///< s, from one surface to the next, of LocalSurface
  LocalSurfaceShape LocalShape = LocalSurfaceShape::Plane;
};

/** Material functions of the scalar, and functions of the gradient magnitude per world unit. */
struct HapticMaterial
{
  Polyline Stiffness = ConstantPolyline(500.0);        ///< k, N/m
  Polyline Friction = ConstantPolyline(0.0);           ///< mu
  Polyline SurfaceStrength = ConstantPolyline(2.0);    ///< T_N, N
  Polyline Viscosity = ConstantPolyline(0.0);          ///< R, N
  Polyline Distinctness = ConstantPolyline(1.0);       ///< W_d, 0 to 1
  Polyline ScalarVisibility = ConstantPolyline(1.0);   ///< 0 or 1, scales T_N and R
  Polyline GradientVisibility = ConstantPolyline(1.0); ///< 0 or 1, scales T_N and R
};

struct HapticModelDescription
{
  VolumeView View;
  std::shared_ptr<const void> Samples; ///< keeps View.Data alive
  Affine3 IndexToWorld;                ///< not singular
  Affine3 DeviceToWorld;               ///< a similarity, world units per metre
  GradientEstimator Estimator = GradientEstimator::Gaussian;
  int KernelRadius = 2; ///< voxels
  HapticMaterial Material;
  HapticSettings Settings;
  std::shared_ptr<const SurfaceMesh> Mesh; ///< in the world; for HapticMethod::SurfaceProxy
  /**
   * 0, or the BakedNumber of a model of another region of the same volume, with the same material
   * and settings: a servo goes on from one to the other as if it had the whole.
   */
  std::uint64_t Number = 0;
};

class HapticModel
{
public:
  explicit HapticModel(const HapticModelDescription& description);
  /** The same volume, material and settings, with the device placed elsewhere. Bakes nothing anew.
   */
  HapticModel(const HapticModel& other, const Affine3& deviceToWorld);
  HapticModel(const HapticModel&) = delete;
  HapticModel& operator=(const HapticModel&) = delete;

  /** What a model with these settings would be given. */
  static GradientKernel MakeKernel(const HapticModelDescription& description);

  /** Below this stiffness (N/m) nothing is felt: the proxy follows the tip. */
  static constexpr double MinimumStiffness = 1e-3;

private:
  /** What does not depend on where the device is. */
  struct Baked
  {
    explicit Baked(const HapticModelDescription& description);

    const GradientKernel Kernel;
    const FieldSampler Field;
    const MaterialTable Materials;
    const DistinctnessTable Distinctness;
    const Affine3 IndexToWorld;
    const HapticSettings Settings;
    const std::shared_ptr<const void> Samples;
    const std::shared_ptr<const SurfaceMesh> Mesh;
    const std::uint64_t Number;
  };
  HapticModel(std::shared_ptr<const Baked> baked, const Affine3& deviceToWorld);

  const std::shared_ptr<const Baked> Shared;

public:
  const HapticSettings& Settings;
  const GradientKernel& Kernel;
  const FieldSampler& Field;
  const MaterialTable& Materials;        ///< channels k, mu, T_N, R, visibility
  const DistinctnessTable& Distinctness; ///< channels W_d, visibility
  const SurfaceMesh* const Mesh;         ///< null without one
  const Affine3& IndexToWorld;
  const std::uint64_t
    BakedNumber; ///< of the volume, the material and the settings; only regions may share one
  const Affine3 DeviceToWorld;
  const Affine3 WorldToDevice;
  const Affine3 DeviceToIndex;
  const Matrix3 DeviceToWorldRotation;
  const double WorldUnitsPerMeter;
  const double MostVoxelsPerMeter; ///< along the axis of the smallest spacing
  /** Turns a gradient per index step into scalar units per world unit along the device's axes. */
  const Matrix3 GradientToDevice;
  /** Stands in for the normal where there is no gradient: the volume's third axis. */
  const Vector3 FallbackNormal;
  /** KernelRadius times the largest spacing, in metres: how far x_s and x_v are from the proxy. */
  const double KernelLength;
  const double InverseRadius; ///< 1/KernelRadius
  /** Turns a gradient per index step, over its magnitude in device space, into x_s - x_p. */
  const Matrix3 GradientToReach;
  /** x_s - x_p, as index steps, where there is no gradient. */
  const Vector3 FallbackReach;
  const ResidentBox Resident; ///< the region that View is

  /** 0 at the volume's border, rising to 1 one kernel radius inside. */
  double BorderFade(const Vector3& index) const noexcept
  {
    const double fade = this->Field.DistanceToBorder(index) * this->InverseRadius;
    return fade < 1.0 ? (fade > 0.0 ? fade : 0.0) : 1.0;
  }

  /** V at a device position. */
  double ValueAtDevice(const Vector3& device) const noexcept
  {
    return this->Field.Value(this->DeviceToIndex(device));
  }

  struct MemoryRange
  {
    const void* Begin = nullptr;
    std::size_t Size = 0; ///< bytes
  };
  /** The tables that every tick reads, without the samples and the mesh. */
  std::array<MemoryRange, 5> GetTables() const noexcept;

  /** Bytes beyond the image. */
  std::size_t GetMemorySize() const noexcept;
};

} // namespace VolumeHaptics

#endif
