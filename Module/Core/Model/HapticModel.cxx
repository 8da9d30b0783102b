// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/HapticModel.h"

#include "Core/Model/SurfaceMesh.h"

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

double SimilarityScale(const Affine3& map)
{
  return std::cbrt(std::abs(Determinant(map.Linear)));
}

/**
 * PRECISE holds its proxy on levels of its own value: its normals have to be normal to them.
 * LOCAL_SURFACE looks for levels of V, but how a normal turns matters to it, too.
 */
GaussianWeights ChooseWeights(const HapticSettings& settings)
{
  const bool isPrecise = settings.Method == HapticMethod::LocalSurface ||
    (settings.Method == HapticMethod::Proxy && settings.Solver == HapticSolver::Precise);
  return isPrecise ? GaussianWeights::OwnDerivative : GaussianWeights::FittedLine;
}

Vector3 MakeFallbackNormal(const Matrix3& indexToDevice)
{
  const Vector3 axis = Transpose(indexToDevice).Row[2];
  return (1.0 / Norm(axis)) * axis;
}

} // namespace

HapticModel::Baked::Baked(const HapticModelDescription& d)
  : Kernel(MakeKernel(d))
  , Field(d.View, this->Kernel)
  , Materials({ d.Material.Stiffness, d.Material.Friction, d.Material.SurfaceStrength,
      d.Material.Viscosity, d.Material.ScalarVisibility })
  , Distinctness({ d.Material.Distinctness, d.Material.GradientVisibility })
  , IndexToWorld(d.IndexToWorld)
  , Settings(d.Settings)
  , Samples(d.Samples)
  , Mesh(d.Mesh)
  , Number(d.Number > 0 ? d.Number : NextNumber())
{
}

GradientKernel HapticModel::MakeKernel(const HapticModelDescription& d)
{
  return { d.Estimator, d.KernelRadius, ChooseWeights(d.Settings) };
}

HapticModel::HapticModel(const HapticModelDescription& description)
  : HapticModel(std::make_shared<const Baked>(description), description.DeviceToWorld)
{
}

HapticModel::HapticModel(const HapticModel& other, const Affine3& deviceToWorld)
  : HapticModel(other.Shared, deviceToWorld)
{
}

HapticModel::HapticModel(std::shared_ptr<const Baked> baked, const Affine3& deviceToWorld)
  : Shared(std::move(baked))
  , Settings(this->Shared->Settings)
  , Kernel(this->Shared->Kernel)
  , Field(this->Shared->Field)
  , Materials(this->Shared->Materials)
  , Distinctness(this->Shared->Distinctness)
  , Mesh(this->Shared->Mesh.get())
  , IndexToWorld(this->Shared->IndexToWorld)
  , BakedNumber(this->Shared->Number)
  , DeviceToWorld(deviceToWorld)
  , WorldToDevice(Inverse(deviceToWorld))
  , DeviceToIndex(Compose(Inverse(this->Shared->IndexToWorld), deviceToWorld))
  , DeviceToWorldRotation((1.0 / SimilarityScale(deviceToWorld)) * deviceToWorld.Linear)
  , WorldUnitsPerMeter(SimilarityScale(deviceToWorld))
  // The rows are at right angles.
  , MostVoxelsPerMeter(LargestColumn(Transpose(this->DeviceToIndex.Linear)))
  // A gradient transforms with the inverse transpose; the device's axes are turned, not scaled.
  , GradientToDevice(Transpose(this->DeviceToWorldRotation) *
      Transpose(Inverse(this->Shared->IndexToWorld.Linear)))
  , FallbackNormal(
      MakeFallbackNormal(Inverse(deviceToWorld.Linear) * this->Shared->IndexToWorld.Linear))
  , KernelLength(this->Kernel.Radius * LargestColumn(this->Shared->IndexToWorld.Linear) /
      SimilarityScale(deviceToWorld))
  , InverseRadius(1.0 / this->Kernel.Radius)
  , GradientToReach(this->KernelLength * (this->DeviceToIndex.Linear * this->GradientToDevice))
  , FallbackReach(this->DeviceToIndex.Linear * (this->KernelLength * this->FallbackNormal))
  , Resident(this->Field.GetView())
{
}

std::array<HapticModel::MemoryRange, 5> HapticModel::GetTables() const noexcept
{
  const MaterialTable& materials = this->Materials;
  const DistinctnessTable& distinctness = this->Distinctness;
  return { MemoryRange{ this, sizeof(*this) }, MemoryRange{ this->Shared.get(), sizeof(Baked) },
    MemoryRange{ this->Kernel.Table.data(), this->Kernel.Table.size() * sizeof(double) },
    MemoryRange{ materials.GetMemory(), materials.GetMemorySize() - sizeof(materials) },
    MemoryRange{ distinctness.GetMemory(), distinctness.GetMemorySize() - sizeof(distinctness) } };
}

std::size_t HapticModel::GetMemorySize() const noexcept
{
  return sizeof(*this) + sizeof(Baked) + this->Kernel.Table.capacity() * sizeof(double) +
    this->Materials.GetMemorySize() - sizeof(this->Materials) + this->Distinctness.GetMemorySize() -
    sizeof(this->Distinctness) + (this->Mesh ? this->Mesh->GetMemorySize() : 0);
}

} // namespace VolumeHaptics
