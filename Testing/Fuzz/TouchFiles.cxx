// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchFiles.h"

#include "Dealer.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticVolumeReader.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

extern "C" void vtkHapticServeReading(
  int link); // a function of the module that no public header declares

namespace
{
namespace fs = std::filesystem;

/** A folder, in memory if possible, that is removed when the process ends. */
struct Folder
{
  fs::path Path;

  Folder()
  {
    const char* const shared = "/dev/shm";
    std::string name = (fs::exists(shared) ? shared : "/tmp") + std::string("/fuzz-XXXXXX");
    Check(mkdtemp(name.data()) != nullptr, "a folder can be made");
    this->Path = name;
  }
  ~Folder() { fs::remove_all(this->Path); }

  fs::path Empty() const
  {
    const fs::path inner = this->Path / "in";
    fs::remove_all(inner);
    fs::create_directory(inner);
    return inner;
  }
};

void Write(const fs::path& file, std::string_view bytes)
{
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<long>(bytes.size()));
}

/** Unpacks files into a folder. Their names can't lead out of the folder. */
void Unpack(std::string_view bytes, const fs::path& folder)
{
  while (!bytes.empty())
  {
    const auto length = static_cast<std::uint8_t>(bytes.front());
    std::string name(bytes.substr(1, length));
    bytes.remove_prefix(std::min(bytes.size(), std::size_t{ 1 } + length));
    const auto at = [&](std::size_t i)
    { return i < bytes.size() ? static_cast<std::uint8_t>(bytes[i]) : std::uint8_t{ 0 }; };
    const std::size_t size = at(0) + 256U * at(1);
    bytes.remove_prefix(std::min<std::size_t>(bytes.size(), 2));
    fs::path inner = folder;
    int depth = 0;
    for (std::size_t begin = 0; begin < name.size() && depth < 6; ++depth)
    {
      const std::size_t end = std::min(name.find('/', begin), name.size());
      const std::string part = name.substr(begin, end - begin);
      if (!part.empty() && part != "." && part != ".." && part.find('\0') == std::string::npos)
      {
        inner /= part;
      }
      begin = end + 1;
    }
    std::error_code failed; // set if a file has the name of a folder
    fs::create_directories(inner.parent_path(), failed);
    if (inner != folder && !failed && !fs::is_directory(inner, failed))
    {
      Write(inner, bytes.substr(0, size));
    }
    bytes.remove_prefix(std::min(bytes.size(), size));
  }
}

/**
 * Makes this process read files itself instead of starting a reader process, in which a sanitizer's
 * fault would not stop the search.
 */
void ReadHere()
{
  static const bool isSet =
    (vtkHapticServeReading(-1), true); // no requests arrive through this link
  (void)isSet;
}

struct Errors
{
  std::string First;
  vtkNew<vtkCallbackCommand> Command;

  explicit Errors(vtkObject* watched)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* text)
      {
        std::string& first = static_cast<Errors*>(self)->First;
        first = first.empty() ? static_cast<const char*>(text) : first;
      });
    watched->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
};

void CheckVolume(vtkImageData* image)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  Check(scalars != nullptr, "a volume has scalars");
  Check(scalars->GetNumberOfTuples() == image->GetNumberOfPoints(), "each voxel has a value");
  Check(scalars->GetNumberOfComponents() == 1, "each voxel has one value");
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = image->GetSpacing()[axis];
    Check(std::isfinite(spacing) && spacing != 0.0, "voxels have a size");
    Check(std::isfinite(image->GetOrigin()[axis]), "a volume has a place");
  }
  Check(std::isfinite(image->GetDirectionMatrix()->Determinant()), "a volume has axes");
  double sum = 0.0;
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    sum += scalars->GetComponent(i, 0); // reads all of the array's memory
  }
  (void)sum;
}

void Read(const fs::path& path, bool areLabels)
{
  vtkNew<vtkHapticVolumeReader> reader;
  const Errors errors(reader);
  const Errors executive(reader->GetExecutive()); // the executive only repeats the reader's error
  reader->SetFileName(path.c_str());
  reader->SetAsLabels(areLabels);
  reader->Update();
  if (errors.First.empty())
  {
    Check(executive.First.empty(), "a failure has a reason");
    areLabels ? (void)reader->GetOutput() : CheckVolume(reader->GetOutput());
    return;
  }
  Check(errors.First.find("Cure: ") != std::string::npos, errors.First.c_str());
}

void Touch(const char* name, const std::uint8_t* bytes, std::size_t size, bool areLabels = false)
{
  static const Folder folder;
  constexpr std::string_view pack = "PACK";
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const fs::path inner = folder.Empty();
  const bool isFolder = text.substr(0, pack.size()) == pack;
  const fs::path named = inner / name;
  if (isFolder)
  {
    // The first file may refer to the other files, as the header of a pair of files does.
    const fs::path place = named.extension() == ".zarr" ? named : inner;
    Unpack(text.substr(pack.size()), place);
    const fs::path file = inner / ("volume" + named.extension().string());
    Read(fs::exists(file) && !areLabels ? file : place == inner ? inner : place, areLabels);
    return;
  }
  Write(named, text);
  Read(named, areLabels);
}
} // namespace

void TouchDicom(const std::uint8_t* bytes, std::size_t size)
{
  Touch("slice.dcm", bytes, size);
}

void TouchBrain(const std::uint8_t* bytes, std::size_t size)
{
  Touch(size > 1 && bytes[0] == 'C' ? "volume.mnc" : "volume.mgz", bytes, size);
}

void TouchGrid(const std::uint8_t* bytes, std::size_t size)
{
  Dealer dealer(bytes, size);
  const char* const names[] = { "grid.vtk", "grid.vtu", "grid.vtr", "grid.vts", "grid.vtm" };
  const char* const name = names[dealer.Choose(5)];
  const std::size_t first = std::min<std::size_t>(size, 1);
  Touch(name, bytes + first, size - first);
}

void TouchHdf(const std::uint8_t* bytes, std::size_t size)
{
  ReadHere();
  Touch("volume.vtkhdf", bytes, size);
}

void TouchMetaImage(const std::uint8_t* bytes, std::size_t size)
{
  Touch("volume.mha", bytes, size);
}

void TouchNifti(const std::uint8_t* bytes, std::size_t size)
{
  Touch(size > 1 && bytes[0] == 0x1f ? "volume.nii.gz" : "volume.nii", bytes, size);
}

void TouchNrrd(const std::uint8_t* bytes, std::size_t size)
{
  Touch("volume.nrrd", bytes, size);
}

void TouchTiff(const std::uint8_t* bytes, std::size_t size)
{
  ReadHere();
  Touch("volume.tif", bytes, size);
}

void TouchVti(const std::uint8_t* bytes, std::size_t size)
{
  Touch("volume.vti", bytes, size);
}

void TouchZarr(const std::uint8_t* bytes, std::size_t size)
{
  Touch("volume.zarr", bytes, size);
}

void TouchLabelFile(const std::uint8_t* bytes, std::size_t size)
{
  static const Folder folder;
  const fs::path inner = folder.Empty();
  Dealer dealer(bytes, size);
  const char* const names[] = { "a.csv", "a.txt", "a.lut", "a.pal", "a.seg.nrrd", "a.nii",
    "a.nii.gz", "a.mha" };
  const std::string name = names[dealer.Choose(8)];
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  Write(inner / name, text.substr(std::min<std::size_t>(size, 1)));
  vtkNew<vtkHapticLabelTable> table;
  const Errors errors(table);
  Check(table->ReadFile((inner / name).c_str()) == errors.First.empty(), "a failure has a reason");
  if (name.find(".n") != std::string::npos || name == "a.mha")
  {
    Read(inner / name, true);
  }
}
