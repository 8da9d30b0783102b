// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/GzipFile.h"

#include "VTK/Base/HapticFiles.h"

#include <cerrno>
#include <unistd.h>

namespace VolumeHaptics
{

GzipFile OpenGzipFile(const std::string& name, std::size_t offset, std::string& error)
{
  const int descriptor = OpenToRead(name);
  const bool isThere =
    descriptor >= 0 && lseek(descriptor, static_cast<off_t>(offset), SEEK_SET) >= 0;
  GzipFile file(isThere ? gzdopen(descriptor, "rb") : nullptr, gzclose);
  if (!file)
  {
    error = "can't be read (" + DescribeError(errno) + "). Check its permissions.";
    if (descriptor >= 0)
    {
      close(descriptor);
    }
  }
  return file;
}

} // namespace VolumeHaptics
