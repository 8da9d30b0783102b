// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/DicomFolder.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Errors/MessageCapture.h"
#include "Applications/Explorer/Volume/VolumeOrientation.h"

#include "vtkDICOMImageReader.h"
#include "vtkDirectory.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{
using Explore::InputError;
using Explore::Volume;

struct Slice
{
  std::string File;
  int Width, Height, Bits;
  double Position[3], Row[3], Column[3], Normal[3];
  double Along; // position along the normal, mm
};

// Uncompressed little endian, implicit and explicit, and explicit big endian: the reader supports
// no others.
bool IsReadable(const std::string& transferSyntax)
{
  return transferSyntax.empty() || transferSyntax == "1.2.840.10008.1.2" ||
    transferSyntax == "1.2.840.10008.1.2.1" || transferSyntax == "1.2.840.10008.1.2.2";
}

Slice ReadHeader(const std::string& folder, const std::string& name)
{
  vtkNew<vtkDICOMImageReader> reader;
  reader->SetFileName((folder + "/" + name).c_str());
  reader->UpdateInformation();
  if (!IsReadable(reader->GetTransferSyntaxUID()))
  {
    throw InputError(folder, "holds compressed DICOM slices (" + name + "), which VTK cannot read",
      "unpack them, e.g. with gdcmconv --raw (package libgdcm-tools) or dcmdjpeg (dcmtk)");
  }
  Slice slice{ name, reader->GetWidth(), reader->GetHeight(), reader->GetBitsAllocated(), {}, {},
    {}, {}, 0.0 };
  const auto pixels = static_cast<unsigned long>(slice.Width) * slice.Height * slice.Bits / 8;
  if (pixels == 0 || vtksys::SystemTools::FileLength(folder + "/" + name) < pixels)
  {
    throw InputError(folder, "holds a damaged or cut-off slice (" + name + ")",
      "copy or export the series again, or take that file away");
  }
  const float* orientation = reader->GetImageOrientationPatient();
  for (int axis = 0; axis < 3; ++axis)
  {
    slice.Position[axis] = reader->GetImagePositionPatient()[axis];
    slice.Row[axis] = orientation[axis];
    slice.Column[axis] = orientation[3 + axis];
  }
  vtkMath::Cross(slice.Row, slice.Column, slice.Normal);
  if (vtkMath::Normalize(slice.Normal) < 0.5)
  {
    // No orientation in the header: an axial slice, as scanners make them by default.
    const double plain[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    std::copy_n(plain[0], 3, slice.Row);
    std::copy_n(plain[1], 3, slice.Column);
    std::copy_n(plain[2], 3, slice.Normal);
  }
  slice.Along = vtkMath::Dot(slice.Position, slice.Normal);
  return slice;
}

std::vector<Slice> ReadHeaders(const std::string& folder)
{
  vtkNew<vtkDirectory> directory;
  directory->Open(folder.c_str());
  std::vector<Slice> slices;
  bool folders = false;
  for (vtkIdType i = 0; i < directory->GetNumberOfFiles(); ++i)
  {
    const std::string name = directory->GetFile(i);
    if (directory->FileIsDirectory(name.c_str()))
    {
      folders = folders || (name != "." && name != "..");
      continue;
    }
    vtkNew<vtkDICOMImageReader> reader;
    if (reader->CanReadFile((folder + "/" + name).c_str()))
    {
      slices.push_back(ReadHeader(folder, name));
    }
  }
  if (slices.empty())
  {
    throw InputError(folder, "is a folder without a single DICOM slice",
      folders ? "name the one of its sub-folders that holds the slices of one series"
              : "name a folder of DICOM slices, or a volume file");
  }
  return slices;
}

/// The reader trusts that all slices are alike and copies them into one block of memory.
void CheckSeries(const std::string& folder, std::vector<Slice>& slices, Volume& volume)
{
  for (const Slice& slice : slices)
  {
    const bool alike = slice.Width == slices[0].Width && slice.Height == slices[0].Height &&
      slice.Bits == slices[0].Bits && vtkMath::Dot(slice.Normal, slices[0].Normal) > 0.999;
    if (!alike)
    {
      throw InputError(folder,
        "mixes slices of different size or orientation (" + slices[0].File + ", " + slice.File +
          ")",
        "put the slices of one series into a folder of their own");
    }
  }
  std::sort(
    slices.begin(), slices.end(), [](const Slice& a, const Slice& b) { return a.Along < b.Along; });
  double smallest = VTK_DOUBLE_MAX, largest = 0.0;
  for (std::size_t i = 1; i < slices.size(); ++i)
  {
    smallest = std::min(smallest, slices[i].Along - slices[i - 1].Along);
    largest = std::max(largest, slices[i].Along - slices[i - 1].Along);
  }
  if (slices.size() > 1 && smallest < 1e-4)
  {
    throw InputError(folder, "has two slices at the same place: several series or time steps",
      "put the slices of one series into a folder of their own");
  }
  if (slices.size() > 1 && largest > 1.05 * smallest)
  {
    std::ostringstream note;
    note << "slices are unevenly spaced (" << smallest << " to " << largest
         << " mm): the picture and the feel are stretched there";
    volume.Notes.push_back(note.str());
  }
}

/// The reader puts the slice farthest along the normal first and the last row of each first.
void Place(const std::vector<Slice>& slices, vtkImageData* image)
{
  const Slice& slice = slices.back();
  const double rows = (image->GetDimensions()[1] - 1) * image->GetSpacing()[1];
  double axes[9], origin[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    axes[3 * axis] = slice.Row[axis];
    axes[3 * axis + 1] = -slice.Column[axis];
    axes[3 * axis + 2] = -slice.Normal[axis];
    origin[axis] = slice.Position[axis] + rows * slice.Column[axis];
  }
  Explore::SetFrame(image, axes, origin);
}
} // namespace

namespace Explore
{
Volume ReadDicomFolder(const std::string& path)
{
  const MessageCapture capture; // the reader warns about every file that is not DICOM
  Volume volume;
  volume.Format = "DICOM";
  std::vector<Slice> slices = ReadHeaders(path);
  CheckSeries(path, slices, volume);

  vtkNew<vtkDICOMImageReader> reader;
  reader->SetDirectoryName(path.c_str());
  reader->Update();
  const int* size = reader->GetOutput()->GetDimensions();
  if (reader->GetErrorCode() != 0 || size[2] != static_cast<int>(slices.size()))
  {
    throw InputError(path, "cannot be read as a DICOM series (" + capture.FirstError() + ")",
      "export the series again, uncompressed, and check that the copy is complete");
  }
  vtkNew<vtkImageData> image;
  image->ShallowCopy(reader->GetOutput());
  Place(slices, image);
  volume.Image = image;
  volume.Notes.push_back(std::to_string(slices.size()) + " slices, sorted by position");
  return volume;
}
} // namespace Explore
