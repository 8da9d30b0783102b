// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PackDicom.h"

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gdcmReader.h>
#include <gdcmWriter.h>

bool PackDicom(const std::string& plain, const std::string& packed, const std::string& how)
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
                                             : gdcm::TransferSyntax::JPEGLSLossless);
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
