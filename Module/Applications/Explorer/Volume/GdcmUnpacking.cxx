// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/DicomUnpacking.h"

#include <gdcmImageReader.h>
#include <gdcmTrace.h>

namespace Explore
{
bool CanUnpackDicom()
{
  return true;
}

bool UnpackDicom(DicomHeader& slice, std::string& bytes)
{
  gdcm::Trace::WarningOff(); // the caller tells
  gdcm::Trace::ErrorOff();
  gdcm::ImageReader reader;
  reader.SetFileName(slice.File.c_str());
  if (!reader.Read())
  {
    return false;
  }
  const gdcm::Image& image = reader.GetImage();
  bytes.resize(image.GetBufferLength());
  if (bytes.empty() || !image.GetBuffer(&bytes[0]))
  {
    return false;
  }
  const gdcm::PixelFormat& format = image.GetPixelFormat();
  slice.Bits = format.GetBitsAllocated();
  slice.Stored = format.GetBitsStored();
  slice.Samples = format.GetSamplesPerPixel();
  slice.ArePlanes = image.GetPlanarConfiguration() == 1;
  slice.IsBig = false;
  return true;
}
} // namespace Explore
