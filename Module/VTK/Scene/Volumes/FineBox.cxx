// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/FineBox.h"

#include "VTK/Base/ArrayMemory.h"

#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace VolumeHaptics
{
namespace
{

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

} // namespace

void FineBox::Follow(vtkImageData* image, vtkIdType mostVoxels)
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
    // A region never changes. Keep it until the next one is there, so that no other has its
    // address.
    const char* const samples = static_cast<const char*>(scalars->GetVoidPointer(0));
    const auto size = static_cast<std::size_t>(scalars->GetDataTypeSize());
    this->Work.Follow(key,
      [samples, size, box](WorkMonitor& monitor) -> std::optional<Bytes>
      { return CopySparsely(samples, size, box, monitor); });
  }
  const Bytes* const made = this->Work.Find(key);
  if (made && *made && !(this->Shown == key))
  {
    this->TakeCopy(**made);
    this->Shown = key;
    this->Work.Forget(); // releases its memory
  }
}

void FineBox::TakeCopy(const std::vector<char>& bytes)
{
  this->Copy = this->Next;
  AllocateScalars(this->Copy, this->Source->GetDataType(), 1);
  std::copy(bytes.begin(), bytes.end(), static_cast<char*>(this->Copy->GetScalarPointer()));
}

} // namespace VolumeHaptics
