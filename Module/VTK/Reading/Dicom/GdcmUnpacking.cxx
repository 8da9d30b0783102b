// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomUnpacking.h"

#include <gdcmByteValue.h>
#include <gdcmImageReader.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include <cstring>
#include <optional>

namespace Explore
{
namespace
{
/// Whether the colours of a JPEG stream are luminance and differences, even if the header of the
/// file says RGB, as GDCM's own writer does. The markers of JFIF and Adobe decide, else the names
/// of the components, as in decoders. Empty if the stream does not show it.
std::optional<bool> IsYbrStream(const char* bytes, std::size_t size)
{
  const auto* const data = reinterpret_cast<const unsigned char*>(bytes);
  for (std::size_t at = 2; at + 4 <= size && data[at] == 0xff;)
  {
    const unsigned marker = data[at + 1];
    const std::size_t length = 256U * data[at + 2] + data[at + 3];
    const unsigned char* const part = data + at + 4;
    if (length < 2 || at + 2 + length > size)
    {
      break;
    }
    if (marker == 0xe0 && length >= 7 && std::memcmp(part, "JFIF", 5) == 0)
    {
      return true;
    }
    if (marker == 0xee && length >= 14 && std::memcmp(part, "Adobe", 5) == 0)
    {
      return part[11] == 1;
    }
    if (marker >= 0xc0 && marker <= 0xc3 && length >= 17)
    {
      return !(part[6] == 'R' && part[9] == 'G' && part[12] == 'B');
    }
    at += 2 + length;
  }
  return {};
}

/// Whether GDCM's unpacked image is luminance and differences.
bool IsYbr(const gdcm::Image& image)
{
  const gdcm::PhotometricInterpretation meaning = image.GetPhotometricInterpretation();
  const gdcm::TransferSyntax syntax = image.GetTransferSyntax();
  const gdcm::SequenceOfFragments* const fragments =
    image.GetDataElement().GetSequenceOfFragments();
  if ((syntax == gdcm::TransferSyntax::JPEGBaselineProcess1 ||
        syntax == gdcm::TransferSyntax::JPEGExtendedProcess2_4) &&
    fragments && fragments->GetNumberOfFragments() > 0)
  {
    const gdcm::ByteValue* const first = fragments->GetFragment(0).GetByteValue();
    const std::optional<bool> told =
      first ? IsYbrStream(first->GetPointer(), first->GetLength()) : std::nullopt;
    if (told)
    {
      return *told;
    }
  }
  return meaning == gdcm::PhotometricInterpretation::YBR_FULL ||
    meaning == gdcm::PhotometricInterpretation::YBR_FULL_422;
}
} // namespace

bool CanUnpackDicom()
{
  return true;
}

bool UnpackDicom(DicomHeader& slice, std::string& bytes)
{
  gdcm::Trace::WarningOff(); // the caller reports errors
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
  slice.IsYbr = slice.Samples == 3 && IsYbr(image);
  return true;
}
} // namespace Explore
