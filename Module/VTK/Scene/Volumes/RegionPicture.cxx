// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/RegionPicture.h"

#include "Core/Realtime/BackgroundWork.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Scene/Volumes/CarvedArray.h"
#include "VTK/Scene/Volumes/CarvedImage.h"
#include "VTK/Scene/Volumes/CarvedPicture.h"
#include "VTK/Scene/Volumes/TouchedVolume.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkHapticRegionSource.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkVolume.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * The parts behind and in front of the box, as flags of vtkVolumeMapper::SetCroppingRegionFlags.
 * The box itself is never included.
 */
struct RegionParts
{
  int Behind = 0;
  int Before = 0;
};

/**
 * Computes which parts are behind or in front of a box (lower and upper bounds along x, y and z).
 * `eye` is the position of the eye, or the direction to an infinitely distant eye.
 */
RegionParts SplitAroundBox(const double box[6], const double eye[3], bool isDirection)
{
  RegionParts parts;
  for (int part = 0; part < 27; ++part)
  {
    const int side[3] = { part % 3 - 1, part / 3 % 3 - 1, part / 9 - 1 };
    bool isBehind = false;
    bool isBox = true;
    for (int a = 0; a < 3; ++a)
    {
      // A part is behind the box if the eye is on the box's side of the plane between them.
      const double above = side[a] > 0 ? (isDirection ? eye[a] : eye[a] - box[2 * a + 1])
                                       : (isDirection ? -eye[a] : box[2 * a] - eye[a]);
      isBehind = isBehind || (side[a] != 0 && above <= 0.0);
      isBox = isBox && side[a] == 0;
    }
    if (!isBox)
    {
      (isBehind ? parts.Behind : parts.Before) |= 1 << part;
    }
  }
  return parts;
}

/**
 * Copies the samples of a region for display on a worker thread. Call its functions on the owner's
 * thread.
 */
class FineBox
{
public:
  /**
   * Starts to copy an image if it is new; null stands for no image. If the image has more than
   * `mostVoxels`, copies only every n-th sample along each axis.
   */
  void Update(vtkImageData* image, vtkIdType mostVoxels);
  /** Returns the last completed copy, placed like the image; null if there is none. */
  vtkImageData* GetCopy() const { return this->Copy; }

private:
  struct Key
  {
    const void* Samples = nullptr;
    vtkIdType MostVoxels = 0;
    bool operator==(const Key& other) const
    {
      return this->Samples == other.Samples && this->MostVoxels == other.MostVoxels;
    }
  };
  using Bytes = std::shared_ptr<std::vector<char>>;

  void ApplyCopy(const std::vector<char>& bytes);

  vtkSmartPointer<vtkDataArray> Source; ///< array being copied, or copied last
  vtkSmartPointer<vtkImageData> Next;   ///< geometry of the copy in progress
  vtkSmartPointer<vtkImageData> Copy;
  Key Of;    ///< key of the copy in progress, or of the last copy
  Key Shown; ///< key of the shown copy
  KeyedWork<Key, Bytes> Work;
};

/** Every n-th sample of an extent along each axis. */
struct SparseBox
{
  SparseBox(const int extent[6], vtkIdType mostVoxels)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Size[a] = extent[2 * a + 1] - extent[2 * a] + 1;
    }
    while (this->Count() > mostVoxels)
    {
      ++this->Step;
    }
  }
  vtkIdType CountAlong(int axis) const { return (this->Size[axis] - 1) / this->Step + 1; }
  vtkIdType Count() const
  {
    return this->CountAlong(0) * this->CountAlong(1) * this->CountAlong(2);
  }

  std::array<vtkIdType, 3> Size{};
  vtkIdType Step = 1;
};

std::shared_ptr<std::vector<char>> CopySparsely(
  const char* samples, std::size_t sampleSize, const SparseBox& box, WorkMonitor& monitor)
{
  auto bytes =
    std::make_shared<std::vector<char>>(static_cast<std::size_t>(box.Count()) * sampleSize);
  char* to = bytes->data();
  for (vtkIdType k = 0; k < box.Size[2]; k += box.Step)
  {
    if (monitor.IsCancelled())
    {
      return nullptr;
    }
    for (vtkIdType j = 0; j < box.Size[1]; j += box.Step)
    {
      const char* const row =
        samples + sampleSize * static_cast<std::size_t>(box.Size[0] * (j + box.Size[1] * k));
      for (vtkIdType i = 0; i < box.Size[0]; i += box.Step, to += sampleSize)
      {
        std::memcpy(to, row + sampleSize * static_cast<std::size_t>(i), sampleSize);
      }
    }
  }
  return bytes;
}

void FineBox::Update(vtkImageData* image, vtkIdType mostVoxels)
{
  vtkDataArray* const scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    this->Work.Forget();
    this->Copy = nullptr;
    this->Source = nullptr;
    this->Of = this->Shown = {};
    return;
  }
  const Key key{ scalars, mostVoxels };
  if (!(key == this->Of))
  {
    this->Work.Forget();
    this->Of = key;
    this->Source = scalars;
    const SparseBox box(image->GetExtent(), mostVoxels);
    this->Next = vtkSmartPointer<vtkImageData>::New();
    this->Next->SetDimensions(static_cast<int>(box.CountAlong(0)),
      static_cast<int>(box.CountAlong(1)), static_cast<int>(box.CountAlong(2)));
    const double* const spacing = image->GetSpacing();
    const auto step = static_cast<double>(box.Step);
    this->Next->SetSpacing(step * spacing[0], step * spacing[1], step * spacing[2]);
    double origin[3];
    image->TransformIndexToPhysicalPoint(
      image->GetExtent()[0], image->GetExtent()[2], image->GetExtent()[4], origin);
    this->Next->SetOrigin(origin);
    this->Next->SetDirectionMatrix(image->GetDirectionMatrix());
    // The samples of a region never change. Keep the array until the next region arrives, so that
    // no other array gets its address, which is the key.
    const char* const samples = static_cast<const char*>(scalars->GetVoidPointer(0));
    const auto size = static_cast<std::size_t>(scalars->GetDataTypeSize());
    this->Work.Poll(key,
      [samples, size, box](WorkMonitor& monitor) -> std::optional<Bytes>
      { return CopySparsely(samples, size, box, monitor); });
  }
  const Bytes* const made = this->Work.Find(key);
  if (made && *made && !(this->Shown == key))
  {
    this->ApplyCopy(**made);
    this->Shown = key;
    this->Work.Forget(); // releases the memory of the result
  }
}

void FineBox::ApplyCopy(const std::vector<char>& bytes)
{
  this->Copy = this->Next;
  AllocateScalars(this->Copy, this->Source->GetDataType(), 1);
  std::copy(bytes.begin(), bytes.end(), static_cast<char*>(this->Copy->GetScalarPointer()));
}

/**
 * Draws the parts of the coarse volume in front of the box, with the same mapper as the parts
 * behind it.
 */
class FrontParts : public vtkVolume
{
public:
  static FrontParts* New();
  vtkTypeMacro(FrontParts, vtkVolume);

  int RenderVolumetricGeometry(vtkViewport* viewport) override
  {
    auto* const mapper = vtkVolumeMapper::SafeDownCast(this->GetMapper());
    if (!mapper || this->Parts.Before == 0)
    {
      return 0;
    }
    mapper->SetCroppingRegionFlags(this->Parts.Before);
    const int drawn = this->Superclass::RenderVolumetricGeometry(viewport);
    mapper->SetCroppingRegionFlags(this->Parts.Behind);
    return drawn;
  }

  RegionParts Parts;

protected:
  FrontParts() = default;
  ~FrontParts() override = default;

private:
  FrontParts(const FrontParts&) = delete;
  void operator=(const FrontParts&) = delete;
};
vtkStandardNewMacro(FrontParts);

/**
 * Computes the matrix `toWorld` that places an axis-aligned block of an image's voxels, which all
 * mappers draw alike, at the image's position.
 */
void PlaceBlock(vtkImageData* image, vtkMatrix4x4* toWorld)
{
  toWorld->Identity();
  for (int row = 0; row < 3; ++row)
  {
    toWorld->SetElement(row, 3, image->GetOrigin()[row]);
    for (int column = 0; column < 3; ++column)
    {
      toWorld->SetElement(row, column, image->GetDirectionMatrix()->GetElement(row, column));
    }
  }
}

/**
 * Computes the box of a block in other coordinates. Returns false if it is not parallel to their
 * axes.
 */
bool TransformBox(const double size[3], vtkMatrix4x4* matrix, double box[6])
{
  const double origin[4] = { 0.0, 0.0, 0.0, 1.0 };
  double first[4];
  matrix->MultiplyPoint(origin, first);
  double last[3] = { first[0], first[1], first[2] };
  for (int axis = 0; axis < 3; ++axis)
  {
    double largest = 0.0;
    double sum = 0.0;
    for (int row = 0; row < 3; ++row)
    {
      const double along = matrix->GetElement(row, axis);
      last[row] += along * size[axis];
      largest = std::max(largest, std::abs(along));
      sum += std::abs(along);
    }
    if (!(sum - largest <= 1e-6 * largest))
    {
      return false;
    }
  }
  for (int a = 0; a < 3; ++a)
  {
    box[2 * a] = std::min(first[a], last[a]);
    box[2 * a + 1] = std::max(first[a], last[a]);
  }
  return true;
}

/**
 * Copies the quality settings of a mapper to another one, with sample distances scaled to its
 * voxels.
 */
void CopyQuality(vtkVolumeMapper* from, vtkVolumeMapper* to, double scale)
{
  to->SetBlendMode(from->GetBlendMode());
  auto* const gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(from);
  auto* const fineGpu = vtkGPUVolumeRayCastMapper::SafeDownCast(to);
  if (gpu && fineGpu)
  {
    fineGpu->SetAutoAdjustSampleDistances(gpu->GetAutoAdjustSampleDistances());
    fineGpu->SetUseJittering(gpu->GetUseJittering());
    fineGpu->SetImageSampleDistance(gpu->GetImageSampleDistance());
    fineGpu->SetSampleDistance(static_cast<float>(scale * gpu->GetSampleDistance()));
  }
  auto* const cpu = vtkFixedPointVolumeRayCastMapper::SafeDownCast(from);
  auto* const fineCpu = vtkFixedPointVolumeRayCastMapper::SafeDownCast(to);
  if (cpu && fineCpu)
  {
    fineCpu->SetAutoAdjustSampleDistances(cpu->GetAutoAdjustSampleDistances());
    fineCpu->SetImageSampleDistance(cpu->GetImageSampleDistance());
    fineCpu->SetSampleDistance(static_cast<float>(scale * cpu->GetSampleDistance()));
  }
}
} // namespace

class RegionPicture::Internal
{
public:
  vtkVolumeMapper* GetCoarseMapper() const
  {
    return this->Volume ? vtkVolumeMapper::SafeDownCast(this->Volume->GetMapper()) : nullptr;
  }

  void Leave()
  {
    if (this->Renderer)
    {
      this->Renderer->RemoveObserver(this->Observer);
      this->Renderer->RemoveViewProp(this->Fine);
      this->Renderer->RemoveViewProp(this->Front);
    }
    this->Renderer = nullptr;
    this->ShowCoarseOnly();
    this->GiveCoarseBack();
  }

  vtkImageData* GetFine() const { return this->LeftFine.Get(); }
  /** Shows the remaining tissue in the region's copy, which is placed in the world. */
  void UpdateFine(vtkImageData* copy, const RemovedTissue& removed)
  {
    this->LeftFine.Update(copy, copy, removed, CarvedCover::Nearest);
  }

  /**
   * Shows the remaining tissue in the coarse image. Ignores changes inside the box, where only the
   * fine image is visible, because each change copies and uploads the whole coarse image.
   */
  void UpdateCoarse(vtkImageData* copy, const RemovedTissue& removed)
  {
    vtkVolumeMapper* const mapper = this->GetCoarseMapper();
    if (!mapper || !removed.Removal)
    {
      this->GiveCoarseBack();
      return;
    }
    if (!this->CoarseInput.IsShownBy(mapper) || this->Carved != removed.Removal)
    {
      this->GiveCoarseBack();
      this->Carved = removed.Removal;
      this->Bricks = std::make_unique<FollowedBricks>(removed.Removal);
    }
    vtkImageData* const own = this->CoarseInput.GetReplaced()
      ? this->CoarseInput.UpdateReplaced()
      : vtkImageData::SafeDownCast(mapper->GetDataObjectInput());
    if (!own)
    {
      return;
    }
    this->Bricks->Poll();
    const bool isOtherBox = this->CoarseBox != copy;
    this->CoarseBox = copy;
    const bool hasChanged = this->HasChangesOutside(copy, removed.Volume);
    RemovedTissue made = removed;
    // Ignore the number of changes, which HasChangesOutside() has already checked.
    made.Changes = this->CoarseMade.Changes;
    const vtkMTimeType time = std::max(own->GetMTime(), this->Volume->GetMatrix()->GetMTime());
    const bool isElse = this->CoarseTime != time || !made.IsSame(this->CoarseMade);
    if (!hasChanged && !isOtherBox && !isElse)
    {
      return;
    }
    if (isElse)
    {
      this->LeftCoarse = {}; // the image that it was copied from no longer exists
    }
    this->CoarseTime = time;
    this->CoarseMade = removed;
    vtkNew<vtkImageData> place;
    place->CopyStructure(own);
    if (PlaceImage(this->Volume->GetMatrix(), own, place) &&
      this->LeftCoarse.Update(own, place, removed, CarvedCover::Voxel))
    {
      this->CoarseInput.Put(mapper, 0, this->LeftCoarse.Get());
    }
  }

  void GiveCoarseBack()
  {
    this->CoarseInput.GiveBack();
    this->LeftCoarse = {};
    this->CoarseBox = nullptr;
    this->CoarseTime = 0;
    this->CoarseMade = {};
    this->Bricks = nullptr;
    this->Carved = nullptr;
  }

  /** Returns whether any brick has changed outside the finely shown box. */
  bool HasChangesOutside(vtkImageData* copy, vtkImageData* volume)
  {
    // Box of the fine copy in indices of the volume, reduced by a brick on each side; empty without
    // a copy.
    double inside[6] = { 0.0, -1.0, 0.0, -1.0, 0.0, -1.0 };
    if (copy)
    {
      const int* const end = copy->GetDimensions();
      double corners[2][3];
      copy->TransformIndexToPhysicalPoint(0, 0, 0, corners[0]);
      copy->TransformIndexToPhysicalPoint(end[0] - 1, end[1] - 1, end[2] - 1, corners[1]);
      for (int side = 0; side < 2; ++side)
      {
        double index[3];
        volume->TransformPhysicalPointToContinuousIndex(corners[side], index);
        for (int a = 0; a < 3; ++a)
        {
          inside[2 * a + side] =
            index[a] - volume->GetExtent()[2 * a] + (side == 0 ? 1.0 : -1.0) * CarvedBricks::Side;
        }
      }
    }
    bool isAny = false;
    this->Bricks->Drain(
      [&](std::uint32_t number)
      {
        const BrickPlace place = CarvedBricks::PlaceOf(this->Carved->Bricks.GetKey(number));
        const std::int64_t at[3] = { place.X, place.Y, place.Z };
        for (int a = 0; a < 3; ++a)
        {
          const auto first = static_cast<double>(CarvedBricks::Side * at[a]);
          isAny = isAny || first < inside[2 * a] || first + CarvedBricks::Side > inside[2 * a + 1];
        }
      });
    return isAny;
  }

  void ShowCoarseOnly()
  {
    vtkVolumeMapper* const mapper = this->GetCoarseMapper();
    if (mapper && this->HasCropped)
    {
      mapper->CroppingOff();
    }
    this->HasCropped = false;
    this->Fine->VisibilityOff();
    this->Front->VisibilityOff();
  }

  /**
   * Draws the box between the coarse parts behind it and in front of it. Returns false if that is
   * not possible.
   */
  bool Refine(vtkImageData* copy)
  {
    vtkVolumeMapper* const coarse = this->GetCoarseMapper();
    auto* const shown = coarse ? vtkImageData::SafeDownCast(coarse->GetDataObjectInput()) : nullptr;
    if (!shown || !shown->GetDirectionMatrix()->IsIdentity())
    {
      return false;
    }
    double size[3];
    for (int a = 0; a < 3; ++a)
    {
      size[a] = copy->GetSpacing()[a] * (copy->GetDimensions()[a] - 1);
    }
    vtkNew<vtkMatrix4x4> toWorld;
    vtkNew<vtkMatrix4x4> toCoarse;
    vtkNew<vtkMatrix4x4> toVolume;
    PlaceBlock(copy, toWorld);
    vtkMatrix4x4::Invert(this->Volume->GetMatrix(), toCoarse);
    vtkMatrix4x4::Multiply4x4(toCoarse, toWorld, toVolume);
    double box[6];
    if (!TransformBox(size, toVolume, box))
    {
      return false;
    }
    this->ShowFine(copy, toWorld, coarse, shown);
    this->Split(box, toCoarse);
    coarse->SetCroppingRegionPlanes(box);
    coarse->SetCroppingRegionFlags(this->Front->Parts.Behind);
    coarse->CroppingOn();
    this->HasCropped = true;
    this->Front->SetMapper(coarse);
    this->Front->SetProperty(this->Volume->GetProperty());
    this->Front->SetUserMatrix(this->Volume->GetMatrix());
    const int visibility = this->Volume->GetVisibility();
    this->Fine->SetVisibility(visibility);
    this->Front->SetVisibility(visibility);
    return true;
  }

  void ShowFine(
    vtkImageData* copy, vtkMatrix4x4* toWorld, vtkVolumeMapper* coarse, vtkImageData* shown)
  {
    auto* mapper = vtkVolumeMapper::SafeDownCast(this->Fine->GetMapper());
    if (!mapper || !mapper->IsA(coarse->GetClassName()))
    {
      const auto made = vtkSmartPointer<vtkVolumeMapper>::Take(coarse->NewInstance());
      this->Fine->SetMapper(made);
      mapper = made;
      this->FineImage = nullptr;
    }
    if (this->FineImage != copy)
    {
      this->FineImage = copy;
      vtkNew<vtkImageData> block;
      block->ShallowCopy(copy);
      const double identity[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
      block->SetDirectionMatrix(identity);
      block->SetOrigin(0.0, 0.0, 0.0);
      mapper->SetInputDataObject(block);
      this->Fine->SetUserMatrix(toWorld);
    }
    CopyQuality(coarse, mapper, SmallestSpacing(copy) / SmallestSpacing(shown));
    if (mapper->GetClippingPlanes() != coarse->GetClippingPlanes())
    {
      mapper->SetClippingPlanes(coarse->GetClippingPlanes());
    }
    this->Fine->SetProperty(this->Volume->GetProperty());
  }

  void Split(const double box[6], vtkMatrix4x4* toCoarse)
  {
    vtkCamera* const camera = this->Renderer->GetActiveCamera();
    const bool isParallel = camera->GetParallelProjection() != 0;
    double eye[4] = { 0.0, 0.0, 0.0, isParallel ? 0.0 : 1.0 };
    std::copy_n(camera->GetPosition(), 3, eye);
    if (isParallel)
    {
      camera->GetDirectionOfProjection(eye);
      vtkMath::MultiplyScalar(eye, -1.0);
    }
    double local[4];
    toCoarse->MultiplyPoint(eye, local);
    this->Front->Parts = SplitAroundBox(box, local, isParallel);
  }

  vtkSmartPointer<vtkHapticRegionSource> Source;
  vtkSmartPointer<vtkVolume> Volume;
  vtkWeakPointer<vtkRenderer> Renderer;
  const vtkNew<vtkCallbackCommand> Observer;
  const vtkNew<vtkVolume> Fine;
  const vtkNew<FrontParts> Front;
  vtkSmartPointer<vtkImageData> FineImage;
  FineBox Box;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  CarvedImage LeftFine;
  CarvedImage LeftCoarse;
  ReplacedInput CoarseInput;
  ///@{
  /** State from which LeftCoarse was made. */
  std::shared_ptr<TissueRemoval> Carved;
  std::unique_ptr<FollowedBricks> Bricks;
  vtkSmartPointer<vtkImageData> CoarseBox;
  RemovedTissue CoarseMade; ///< removed tissue that the coarse image shows
  vtkMTimeType CoarseTime = 0;
  ///@}
  bool HasCropped = false;
};

//------------------------------------------------------------------------------
RegionPicture::RegionPicture()
  : Internals(new Internal)
{
  for (vtkVolume* const part :
    { this->Internals->Fine.Get(), static_cast<vtkVolume*>(this->Internals->Front.Get()) })
  {
    part->PickableOff();
    part->UseBoundsOff();
    part->VisibilityOff();
  }
  this->Internals->Observer->SetClientData(this);
  this->Internals->Observer->SetCallback([](vtkObject*, unsigned long, void* picture, void*)
    { static_cast<RegionPicture*>(picture)->Update(); });
}

//------------------------------------------------------------------------------
RegionPicture::~RegionPicture()
{
  this->Internals->Leave();
}

//------------------------------------------------------------------------------
void RegionPicture::SetSource(vtkHapticRegionSource* source)
{
  this->Internals->Source = source;
}

//------------------------------------------------------------------------------
void RegionPicture::SetVolumeHaptics(vtkVolumeHapticsFilter* filter)
{
  this->Internals->Filter = filter;
}

//------------------------------------------------------------------------------
void RegionPicture::SetVolume(vtkVolume* volume)
{
  if (this->Internals->Volume != volume)
  {
    this->Internals->ShowCoarseOnly();
    this->Internals->GiveCoarseBack();
    this->Internals->Volume = volume;
  }
}

//------------------------------------------------------------------------------
vtkVolume* RegionPicture::GetVolume() const
{
  return this->Internals->Volume;
}

//------------------------------------------------------------------------------
void RegionPicture::SetRenderer(vtkRenderer* renderer)
{
  if (this->Internals->Renderer == renderer)
  {
    return;
  }
  this->Internals->Leave();
  this->Internals->Renderer = renderer;
  if (renderer)
  {
    renderer->AddObserver(vtkCommand::StartEvent, this->Internals->Observer);
    // Props are drawn in the order of this list, so add these after the coarse volume.
    renderer->AddViewProp(this->Internals->Fine);
    renderer->AddViewProp(this->Internals->Front);
  }
}

//------------------------------------------------------------------------------
void RegionPicture::Update()
{
  Internal& in = *this->Internals;
  if (!in.Renderer)
  {
    return;
  }
  const bool isResident = in.Source && in.Source->HasSamples();
  in.Box.Update(isResident ? in.Source->GetOutput() : nullptr, this->MaximumVoxels);
  vtkImageData* const copy = in.Box.GetCopy();
  const RemovedTissue removed = GetRemoved(in.Filter);
  in.UpdateFine(copy, removed);
  const bool isRefined = copy && in.Refine(in.GetFine());
  if (!isRefined)
  {
    in.ShowCoarseOnly();
  }
  in.UpdateCoarse(isRefined ? copy : nullptr, removed);
}

//------------------------------------------------------------------------------
bool RegionPicture::IsRefined() const
{
  return this->Internals->HasCropped;
}

//------------------------------------------------------------------------------
vtkVolume* RegionPicture::GetFineVolume() const
{
  return this->Internals->Fine;
}

} // namespace VolumeHaptics
