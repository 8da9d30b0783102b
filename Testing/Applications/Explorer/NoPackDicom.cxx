// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PackDicom.h"

bool PackDicom(const std::string&, const std::string&, const std::string&, double)
{
  return false;
}
