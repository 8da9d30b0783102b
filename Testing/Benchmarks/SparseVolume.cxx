// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SparseVolume.h"

#include <vtkCallbackCommand.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

namespace benchmarks
{
namespace
{

struct Mapping
{
  void* Begin;
  std::size_t Bytes;
};

/**
 * Unmaps the file when the array is deleted. Background work may read the array for some
 * milliseconds after its cancellation.
 */
void UnmapWith(vtkDataArray* array, const Mapping& mapping)
{
  const vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new Mapping(mapping));
  command->SetClientDataDeleteCallback([](void* held) { delete static_cast<Mapping*>(held); });
  command->SetCallback(
    [](vtkObject*, unsigned long, void* held, void*)
    {
      const Mapping& mapping = *static_cast<Mapping*>(held);
      munmap(mapping.Begin, mapping.Bytes);
    });
  array->AddObserver(vtkCommand::DeleteEvent, command);
}

} // namespace

SparseVolume::SparseVolume(int size, vtkShortArray* array)
  : Size(size)
  , Bytes(sizeof(short) * static_cast<std::size_t>(size) * size * size)
{
  std::FILE* const file = std::tmpfile();
  const bool isThere = file && ftruncate(fileno(file), static_cast<off_t>(this->Bytes)) == 0;
  constexpr int side = 64;
  const int first = (size - side) / 2;
  bool isWritten = isThere;
  for (int k = 0; k < side; ++k)
  {
    const std::vector<short> row(side, static_cast<short>(20 * k));
    for (int j = 0; j < side && isWritten; ++j)
    {
      const std::size_t at =
        (static_cast<std::size_t>(first + k) * size + first + j) * size + first;
      isWritten = pwrite(fileno(file), row.data(), side * sizeof(short),
                    static_cast<off_t>(at * sizeof(short))) == side * sizeof(short);
    }
  }
  this->Begin = isWritten
    ? mmap(nullptr, this->Bytes, PROT_READ | PROT_WRITE, MAP_SHARED, fileno(file), 0)
    : MAP_FAILED;
  if (file)
  {
    std::fclose(file); // the mapping outlives the file handle
  }
  if (this->Begin == MAP_FAILED)
  {
    throw std::runtime_error("there is no room for a file of a volume");
  }
  // Disable read-ahead, so that only accessed samples become resident.
  (void)madvise(this->Begin, this->Bytes, MADV_RANDOM);
  const vtkNew<vtkShortArray> own;
  vtkShortArray* const samples = array ? array : own.Get();
  samples->SetArray(
    static_cast<short*>(this->Begin), static_cast<vtkIdType>(this->Bytes / sizeof(short)), 1);
  UnmapWith(samples, { this->Begin, this->Bytes });
  this->Image->SetDimensions(size, size, size);
  this->Image->GetPointData()->SetScalars(samples);
}

std::size_t SparseVolume::GetResident() const
{
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  std::vector<unsigned char> pages((this->Bytes + page - 1) / page);
  if (mincore(this->Begin, this->Bytes, pages.data()) != 0)
  {
    return 0;
  }
  return page *
    static_cast<std::size_t>(std::count_if(
      pages.begin(), pages.end(), [](unsigned char state) { return (state & 1) != 0; }));
}

} // namespace benchmarks
