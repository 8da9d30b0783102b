// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The volumes that are touched, and models of them.
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

/** Radius in voxels (and mm) of the level that the slide runs along. */
constexpr double BallRadius = 100.0;
/** The value there. */
constexpr double BallLevel = 2000.0 - BallRadius * BallRadius / 20.0;

/**
 * An int16 volume whose value falls with the squared distance from its centre: every level is a
 * ball, there is a gradient everywhere, and filling it is cheap. Voxels of 1 mm.
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
  /** Taps along an axis of the sum that its gradient is; 0 when it is not such a sum. */
  int Taps;
};

/** All that are measured. */
const std::vector<Estimator>& GetEstimators();

/** How a model is touched. */
struct ModelChoice
{
  VolumeHaptics::HapticMethod Method = VolumeHaptics::HapticMethod::Proxy;
  VolumeHaptics::HapticSolver Solver = VolumeHaptics::HapticSolver::Paper;
  std::shared_ptr<const VolumeHaptics::SurfaceMesh> Mesh;
  bool ForceShading = true;
  VolumeHaptics::LocalSurfaceShape LocalShape = VolumeHaptics::LocalSurfaceShape::Plane;
  std::shared_ptr<const VolumeHaptics::BakedLabels> Labels;
  VolumeHaptics::SurfaceGeometry Geometry = VolumeHaptics::SurfaceGeometry::Scalars;
  /** Surfaces of the paper with PRECISE: alignment Distinctness, materials of the kernel. */
  bool IsPlacedAsThePaper = false;
  /** Of a volume that moves. */
  std::vector<VolumeHaptics::VolumeTimeStep> TimeSteps;
};

/** Materials like those of a CT. */
VolumeHaptics::HapticMaterial MakeMaterial(const BallVolume& volume);

/** A model in life size with a material table like that of a CT. Borrows the volume. */
std::unique_ptr<VolumeHaptics::HapticModel> MakeModel(
  const BallVolume& volume, const Estimator& estimator, const ModelChoice& choice = {});

} // namespace benchmarks

#endif
