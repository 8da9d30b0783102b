// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes the volumes that the benchmarks touch, and makes models of them.
 */
#ifndef BallVolume_h
#define BallVolume_h

#include "Core/Model/HapticModel.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

namespace benchmarks
{

/** Radius (in voxels, which are 1 mm) of the level along which the tip slides. */
constexpr double BallRadius = 100.0;
/** Value at the radius BallRadius. */
constexpr double BallLevel = 2000.0 - BallRadius * BallRadius / 20.0;

/**
 * An int16 volume whose value falls with the squared distance from its centre. Every level is a
 * ball, the gradient is nonzero everywhere, and filling the volume is fast. Voxels are 1 mm.
 */
struct BallVolume
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  VolumeHaptics::VolumeView View;

  BallVolume(const std::string& name, int nx, int ny, int nz);

  VolumeHaptics::Vector3 GetCentre() const;
};

struct Estimator
{
  std::string Name;
  VolumeHaptics::GradientEstimator Kind;
  int Radius;
  /** Number of taps per axis if the gradient is a sum over taps, otherwise 0. */
  int Taps;
};

/** Returns the gradient estimators that all benchmarks compare. */
const std::vector<Estimator>& GetEstimators();

/** Settings of the model in a benchmark. */
struct ModelChoice
{
  VolumeHaptics::HapticMethod Method = VolumeHaptics::HapticMethod::Proxy;
  VolumeHaptics::HapticSolver Solver = VolumeHaptics::HapticSolver::Paper;
  std::shared_ptr<const VolumeHaptics::SurfaceMesh> Mesh;
  bool ForceShading = true;
  VolumeHaptics::LocalSurfaceShape LocalShape = VolumeHaptics::LocalSurfaceShape::Plane;
  std::shared_ptr<const VolumeHaptics::BakedLabels> Labels;
  VolumeHaptics::SurfaceGeometry Geometry = VolumeHaptics::SurfaceGeometry::Scalars;
  /**
   * Whether PRECISE places surfaces as the paper does: alignment Distinctness, and materials from
   * the kernel.
   */
  bool IsPlacedAsThePaper = false;
  /** Time steps of a moving volume; empty for a static volume. */
  std::vector<VolumeHaptics::VolumeTimeStep> TimeSteps;
};

/** Returns a material table with seven tissues, as in a CT. */
VolumeHaptics::HapticMaterial MakeMaterial(const BallVolume& volume);

/**
 * Makes a model with a material table as in a CT; 1 mm of the volume is 1 mm of the hand. The model
 * does not own the volume.
 */
std::unique_ptr<VolumeHaptics::HapticModel> MakeModel(
  const BallVolume& volume, const Estimator& estimator, const ModelChoice& choice = {});

} // namespace benchmarks

#endif
