// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PackDicom.h"

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>

bool PackDicom(const std::string& plain, const std::string& packed, const std::string& how)
{
  gdcm::ImageReader reader;
  reader.SetFileName(plain.c_str());
  if (!reader.Read())
  {
    return false;
  }
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(how == "lossless" ? gdcm::TransferSyntax::JPEGLosslessProcess14_1
      : how == "prediction"                  ? gdcm::TransferSyntax::JPEGLSLossless
                                             : gdcm::TransferSyntax::JPEG2000Lossless);
  change.SetInput(reader.GetImage());
  if (!change.Change())
  {
    return false;
  }
  gdcm::ImageWriter writer;
  writer.SetFileName(packed.c_str());
  writer.SetFile(reader.GetFile());
  writer.SetImage(change.GetOutput());
  return writer.Write();
}
