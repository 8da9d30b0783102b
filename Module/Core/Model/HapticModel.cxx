// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/HapticModel.h"

#include "Core/Model/SurfaceMesh.h"

namespace VolumeHaptics
{
namespace
{

double SimilarityScale(const Affine3& map)
{
  return std::cbrt(std::abs(Determinant(map.Linear)));
}

Vector3 MakeFallbackNormal(const Matrix3& indexToDevice)
{
  const Vector3 axis = Transpose(indexToDevice).Row[2];
  return (1.0 / Norm(axis)) * axis;
}

Affine3 MakeIndexToLabel(const BakedVolume& baked)
{
  return baked.Labels ? Compose(Inverse(baked.Labels->IndexToWorld), baked.IndexToWorld)
                      : Affine3{};
}

const Affine3& LabelToWorld(const BakedVolume& baked)
{
  return baked.Labels ? baked.Labels->IndexToWorld : baked.IndexToWorld;
}

/**
 * Returns whether voxels are cubes apart from rounding, so that a voxel has the same length in all
 * directions.
 */
bool IsOfCubes(const Matrix3& indexToWorld)
{
  constexpr double rounding = 1e-9;
  const double largest = LargestColumn(indexToWorld);
  const Matrix3 columns = Transpose(indexToWorld);
  return std::fmin(Norm(columns.Row[0]), std::fmin(Norm(columns.Row[1]), Norm(columns.Row[2]))) >=
    (1.0 - rounding) * largest;
}

/**
 * Returns whether the solver is Paper, for which the radius r has the same length in all
 * directions.
 */
bool IsOfPaper(const HapticSettings& settings)
{
  return settings.Method == HapticMethod::Proxy && settings.Solver == HapticSolver::Paper;
}

/** Returns the length of KernelRadius voxels of the coarser image in world units. */
double ComputeLabelReach(const BakedVolume& baked)
{
  return baked.Kernel.Radius *
    std::fmax(baked.LargestSpacing, LargestColumn(LabelToWorld(baked).Linear));
}

double ComputeMostSteps(const HapticModel& model)
{
  double most = model.MostVoxelsPerMeter;
  for (const Vector3& row : model.DeviceToLabel.Linear.Row)
  {
    most = model.Baked->FeelsLabels() ? std::fmax(most, Norm(row)) : most;
  }
  return most;
}

/** Returns the size (bytes) of all meshes. */
std::size_t GetMeshSize(const BakedVolume& baked)
{
  std::size_t size = baked.Mesh ? baked.Mesh->GetMemorySize() : 0;
  for (const FieldTimeStep& timeStep : baked.TimeSteps)
  {
    size += timeStep.Mesh && timeStep.Mesh != baked.Mesh ? timeStep.Mesh->GetMemorySize() : 0;
  }
  return size;
}

} // namespace

HapticModel::HapticModel(const HapticModelDescription& description)
  : HapticModel(std::make_shared<const BakedVolume>(description), description.DeviceToWorld,
      description.DeviceCaps)
{
}

HapticModel::HapticModel(
  const HapticModel& other, const Affine3& deviceToWorld, const ForceCaps& deviceCaps)
  : HapticModel(other.Baked, deviceToWorld, deviceCaps)
{
}

HapticModel::HapticModel(std::shared_ptr<const BakedVolume> baked, const Affine3& deviceToWorld,
  const ForceCaps& deviceCaps)
  : Baked(std::move(baked))
  , Caps(TighterCaps(this->Baked->Settings.Caps, deviceCaps))
  , DeviceToWorld(deviceToWorld)
  , WorldToDevice(Inverse(deviceToWorld))
  , DeviceToIndex(Compose(Inverse(this->Baked->IndexToWorld), deviceToWorld))
  , DeviceToWorldRotation((1.0 / SimilarityScale(deviceToWorld)) * deviceToWorld.Linear)
  , WorldUnitsPerMeter(SimilarityScale(deviceToWorld))
  , VoxelsPerMeter{ Norm(this->DeviceToIndex.Linear.Row[0]),
    Norm(this->DeviceToIndex.Linear.Row[1]), Norm(this->DeviceToIndex.Linear.Row[2]) }
  // The axes are perpendicular, so the length of a row is the number of index steps in 1 m.
  , MostVoxelsPerMeter(
      std::fmax(this->VoxelsPerMeter.X, std::fmax(this->VoxelsPerMeter.Y, this->VoxelsPerMeter.Z)))
  // A gradient transforms with the inverse transpose, and stays per world unit. From the world's
  // axes to the device's, it is only rotated.
  , GradientToDevice(
      Transpose(this->DeviceToWorldRotation) * Transpose(Inverse(this->Baked->IndexToWorld.Linear)))
  , FallbackNormal(
      MakeFallbackNormal(Inverse(deviceToWorld.Linear) * this->Baked->IndexToWorld.Linear))
  , HasLengthByDirection(
      !IsOfPaper(this->Baked->Settings) && !IsOfCubes(this->Baked->IndexToWorld.Linear))
  , HasNoiseByDirection(this->HasLengthByDirection && this->Baked->IsDistinctFromNoise)
  , KernelLength(
      this->Baked->Kernel.Radius * this->Baked->LargestSpacing / SimilarityScale(deviceToWorld))
  , InverseRadius(1.0 / this->Baked->Kernel.Radius)
  , FadePerVoxel(this->HasLengthByDirection
        ? this->InverseRadius *
          Vector3{ this->MostVoxelsPerMeter / this->VoxelsPerMeter.X,
            this->MostVoxelsPerMeter / this->VoxelsPerMeter.Y,
            this->MostVoxelsPerMeter / this->VoxelsPerMeter.Z }
        : Vector3{ this->InverseRadius, this->InverseRadius, this->InverseRadius })
  , GradientToReach(this->KernelLength * (this->DeviceToIndex.Linear * this->GradientToDevice))
  , FallbackReach(this->DeviceToIndex.Linear *
      (this->KernelLengthAlong(this->FallbackNormal) * this->FallbackNormal))
  , Resident(this->Baked->Field.GetView(), this->Baked->ResidentShare)
  , IndexToLabel(MakeIndexToLabel(*this->Baked))
  , DeviceToLabel(Compose(this->IndexToLabel, this->DeviceToIndex))
  , LabelGradientToDevice(Transpose(this->DeviceToWorldRotation) *
      Transpose(Inverse(LabelToWorld(*this->Baked).Linear)))
  , HasLabelLengthByDirection(this->HasLengthByDirection ||
      (!IsOfPaper(this->Baked->Settings) && !IsOfCubes(LabelToWorld(*this->Baked).Linear)))
  , LabelReach(ComputeLabelReach(*this->Baked) / this->WorldUnitsPerMeter)
  , LabelGradientToReach(
      this->LabelReach * (this->DeviceToIndex.Linear * this->LabelGradientToDevice))
  , MostStepsPerMeter(ComputeMostSteps(*this))
{
}

double HapticModel::LabelReachAlong(const Vector3& normal) const noexcept
{
  if (!this->HasLabelLengthByDirection)
  {
    return this->LabelReach;
  }
  return std::fmax(this->KernelLengthOf(this->DeviceToIndex.Linear * normal),
    this->KernelLengthOf(this->DeviceToLabel.Linear * normal));
}

std::vector<MemoryRange> HapticModel::GetTables() const
{
  const MaterialTable& materials = this->Baked->Materials;
  const DistinctnessTable& distinctness = this->Baked->Distinctness;
  const BakedLabels* const labels = this->Baked->Labels.get();
  const LabelWalls* const walls = this->Baked->Walls.get();
  std::vector<MemoryRange> tables = { MemoryRange{ this, sizeof(*this) },
    MemoryRange{ this->Baked.get(), sizeof(BakedVolume) },
    MemoryRange{
      this->Baked->Kernel.Table.data(), this->Baked->Kernel.Table.size() * sizeof(double) },
    MemoryRange{ materials.GetMemory(), materials.GetMemorySize() - sizeof(materials) },
    MemoryRange{ distinctness.GetMemory(), distinctness.GetMemorySize() - sizeof(distinctness) },
    labels ? MemoryRange{ labels->Table.GetEntries(), labels->Table.GetEntriesSize() }
           : MemoryRange{},
    labels ? MemoryRange{ labels->Table.GetPlaces(), labels->Table.GetPlacesSize() }
           : MemoryRange{},
    walls ? MemoryRange{ walls, sizeof(*walls) } : MemoryRange{},
    walls ? MemoryRange{ walls->GetTable(), walls->GetTableSize() } : MemoryRange{} };
  for (const BakedMode& mode : this->Baked->Modes)
  {
    tables.push_back({ &mode, sizeof(mode) });
    tables.push_back(
      { mode.Strengths.GetMemory(), mode.Strengths.GetMemorySize() - sizeof(mode.Strengths) });
    if (mode.Guide)
    {
      tables.push_back({ mode.Guide->GetSegments(), mode.Guide->GetSegmentsSize() });
      tables.push_back({ mode.Guide->GetBoxes(), mode.Guide->GetBoxesSize() });
    }
  }
  if (this->Baked->Tool)
  {
    this->Baked->Tool->AppendTables(tables);
  }
  return tables;
}

std::size_t HapticModel::GetMemorySize() const
{
  const BakedVolume& baked = *this->Baked;
  std::size_t modes = 0;
  for (const BakedMode& mode : baked.Modes)
  {
    modes += sizeof(mode) + mode.Strengths.GetMemorySize() - sizeof(mode.Strengths) +
      (mode.Guide ? mode.Guide->GetSegmentsSize() + mode.Guide->GetBoxesSize() : 0) +
      (mode.GuideSurface ? mode.GuideSurface->GetMemorySize() : 0);
  }
  std::size_t ofTool = 0;
  if (baked.Tool)
  {
    std::vector<MemoryRange> tables;
    baked.Tool->AppendTables(tables);
    for (const MemoryRange& table : tables)
    {
      ofTool += table.Size;
    }
  }
  return modes + ofTool + sizeof(*this) + sizeof(baked) +
    baked.Kernel.Table.capacity() * sizeof(double) + baked.Materials.GetMemorySize() -
    sizeof(baked.Materials) + baked.Distinctness.GetMemorySize() - sizeof(baked.Distinctness) +
    GetMeshSize(baked) +
    (baked.Labels ? sizeof(BakedLabels) + baked.Labels->Table.GetMemorySize() : 0) +
    (baked.Labels && baked.Labels->Fine ? baked.Labels->Fine->GetMemorySize() : 0) +
    (baked.GetZone() ? baked.GetZone()->GetMemorySize() : 0) +
    (baked.Walls ? sizeof(LabelWalls) + baked.Walls->GetMemorySize() : 0);
}

} // namespace VolumeHaptics
