// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Replaces TheoraFile.cxx if VTK was built without a movie writer.
#include "Applications/Explorer/Record/MovieFile.h"

namespace Explore
{
bool MovieFile::IsAvailable()
{
  return false;
}

std::unique_ptr<MovieFile> MovieFile::Open(const std::string&, std::string& error)
{
  error = "this program's VTK has no module IOOggTheora";
  return nullptr;
}
} // namespace Explore
