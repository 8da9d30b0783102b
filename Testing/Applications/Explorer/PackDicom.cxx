// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PackDicom.h"

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gdcmReader.h>
#include <gdcmWriter.h>

bool PackDicom(
  const std::string& plain, const std::string& packed, const std::string& how, double step)
{
  // GDCM's writer can't write an icon without all its elements, as that of these tests.
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
  change.SetTransferSyntax(how == "lossless" ? gdcm::TransferSyntax::JPEGLosslessProcess14_1
      : how == "wavelets"                    ? gdcm::TransferSyntax::JPEG2000Lossless
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
    image->SetSpacing(2, step); // of frames, which GDCM does not know of a CT
  }
  writer.SetImage(*image);
  return writer.Write();
}
