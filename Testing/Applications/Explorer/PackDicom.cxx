// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PackDicom.h"

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gdcmJPEGCodec.h>
#include <gdcmReader.h>
#include <gdcmWriter.h>

#include <cstdint>

namespace
{
/// Sets the photometric interpretation to YBR_FULL_422 (luminance, and colour differences at half
/// the resolution along rows), as most writers do. GDCM's writer sets RGB.
bool TellYbr(const std::string& packed)
{
  gdcm::Reader reader;
  reader.SetFileName(packed.c_str());
  if (!reader.Read())
  {
    return false;
  }
  const std::string meaning = "YBR_FULL_422";
  gdcm::DataElement element(gdcm::Tag(0x0028, 0x0004));
  element.SetVR(gdcm::VR::CS);
  element.SetByteValue(meaning.data(), static_cast<std::uint32_t>(meaning.size()));
  reader.GetFile().GetDataSet().Replace(element);
  gdcm::Writer writer;
  writer.SetFileName(packed.c_str());
  writer.SetFile(reader.GetFile());
  return writer.Write();
}
} // namespace

bool PackDicom(
  const std::string& plain, const std::string& packed, const std::string& how, double step)
{
  // Remove the icon first: GDCM's writer can't write an incomplete icon, and the icon of these
  // tests lacks elements.
  gdcm::Reader elements;
  elements.SetFileName(plain.c_str());
  if (!elements.Read())
  {
    return false;
  }
  elements.GetFile().GetDataSet().Remove(gdcm::Tag(0x0088, 0x0200));
  gdcm::Writer withoutIcon;
  withoutIcon.SetFileName(packed.c_str());
  withoutIcon.SetFile(elements.GetFile());
  gdcm::ImageReader reader;
  reader.SetFileName(packed.c_str());
  if (!withoutIcon.Write() || !reader.Read())
  {
    return false;
  }
  gdcm::ImageChangeTransferSyntax change;
  gdcm::JPEGCodec finely;
  finely.SetLossless(false);
  finely.SetQuality(100);
  if (how.rfind("baseline", 0) == 0)
  {
    change.SetUserCodec(&finely);
  }
  change.SetTransferSyntax(how.rfind("baseline", 0) == 0
      ? gdcm::TransferSyntax::JPEGBaselineProcess1
      : how == "lossless" ? gdcm::TransferSyntax::JPEGLosslessProcess14_1
      : how == "wavelets" ? gdcm::TransferSyntax::JPEG2000Lossless
                          : gdcm::TransferSyntax::JPEGLSLossless);
  change.SetInput(reader.GetImage());
  if (!change.Change())
  {
    return false;
  }
  gdcm::ImageWriter writer;
  writer.SetFileName(packed.c_str());
  writer.SetFile(reader.GetFile());
  const gdcm::SmartPointer<gdcm::Image> image = new gdcm::Image(change.GetOutput());
  if (image->GetNumberOfDimensions() == 3)
  {
    image->SetSpacing(2, step); // between frames; GDCM ignores the tag in CTs
  }
  writer.SetImage(*image);
  return writer.Write() && (how != "baseline-422" || TellYbr(packed));
}
