// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/BakedVolume.h"

#include <atomic>

namespace VolumeHaptics
{
namespace
{

std::uint64_t NextNumber()
{
  static std::atomic<std::uint64_t> last{ 0 };
  return ++last;
}

/**
 * PRECISE holds its proxy on levels of the estimator's own value: the normals must be normal to
 * them. LOCAL_SURFACE looks for levels of V, but depends on how the normals turn, too.
 */
GaussianWeights ChooseWeights(const HapticSettings& settings)
{
  const bool isPrecise = settings.Method == HapticMethod::LocalSurface ||
    (settings.Method == HapticMethod::Proxy && settings.Solver == HapticSolver::Precise);
  return isPrecise ? GaussianWeights::OwnDerivative : GaussianWeights::FittedLine;
}

} // namespace

BakedVolume::BakedVolume(const HapticModelDescription& d)
  : Kernel(MakeKernel(d))
  , Field(d.View, this->Kernel)
  , Materials({ d.Material.Stiffness, d.Material.Friction, d.Material.SurfaceStrength,
      d.Material.Viscosity, d.Material.ScalarVisibility })
  , Distinctness({ d.Material.Distinctness, d.Material.GradientVisibility })
  , IndexToWorld(d.IndexToWorld)
  , LargestSpacing(LargestColumn(d.IndexToWorld.Linear))
  , Settings(d.Settings)
  , Samples(d.Samples)
  , Mesh(d.Mesh)
  , Labels(d.Labels)
  , Number(d.Number > 0 ? d.Number : NextNumber())
{
}

GradientKernel BakedVolume::MakeKernel(const HapticModelDescription& d)
{
  return { d.Estimator, d.KernelRadius, ChooseWeights(d.Settings) };
}

} // namespace VolumeHaptics
