// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/BakedVolume.h"

#include "Core/Math/PolylineMask.h"
#include "Core/Model/HapticModel.h"
#include "Core/Model/UniqueNumber.h"

namespace VolumeHaptics
{
namespace
{

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

/** The stiffness of all materials that have one. */
Polyline MakeStiffness(const HapticModelDescription& d)
{
  if (!d.Settings.SameShape)
  {
    return d.Material.Stiffness;
  }
  Polyline line = MaskAbove(d.Material.Stiffness, HapticModel::MinimumStiffness);
  for (Vertex& vertex : line)
  {
    vertex.Y *= d.Settings.CouplingStiffness;
  }
  return line;
}

std::shared_ptr<const BakedLabels> MakeLabels(const HapticModelDescription& d)
{
  if (!d.Settings.SameShape || !d.Labels)
  {
    return d.Labels;
  }
  const auto labels = std::make_shared<BakedLabels>(*d.Labels);
  labels->Table.SetOneStiffness(d.Settings.CouplingStiffness, HapticModel::MinimumStiffness);
  return labels;
}

std::unique_ptr<const LabelWalls> MakeWalls(
  const HapticModelDescription& d, const BakedLabels* labels)
{
  if (!labels || d.Settings.Geometry == SurfaceGeometry::Scalars)
  {
    return nullptr;
  }
  // The default radius of 2 makes a scale of 1.4 voxels.
  return std::make_unique<const LabelWalls>(labels->View, labels->Table, d.KernelRadius + 1);
}

} // namespace

BakedVolume::BakedVolume(const HapticModelDescription& d)
  : Kernel(MakeKernel(d))
  , Field(d.View, this->Kernel)
  , Materials({ MakeStiffness(d), d.Material.Friction, d.Material.SurfaceStrength,
      d.Material.Viscosity, d.Material.ScalarVisibility })
  , Distinctness({ d.Material.Distinctness, d.Material.GradientVisibility })
  , IndexToWorld(d.IndexToWorld)
  , LargestSpacing(LargestColumn(d.IndexToWorld.Linear))
  , Settings(d.Settings)
  , Samples(d.Samples)
  , Mesh(d.Mesh)
  , Labels(MakeLabels(d))
  , Walls(MakeWalls(d, this->Labels.get()))
  , Number(d.Number > 0 ? d.Number : MakeUniqueNumber())
{
}

GradientKernel BakedVolume::MakeKernel(const HapticModelDescription& d)
{
  return { d.Estimator, d.KernelRadius, ChooseWeights(d.Settings) };
}

} // namespace VolumeHaptics
