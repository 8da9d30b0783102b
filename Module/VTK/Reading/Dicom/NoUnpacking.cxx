// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomUnpacking.h"

namespace Explore
{
bool CanUnpackDicom()
{
  return false;
}

bool UnpackDicom(DicomHeader&, std::string&)
{
  return false;
}
} // namespace Explore
