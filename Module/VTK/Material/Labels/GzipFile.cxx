// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/GzipFile.h"

#include "Core/Platform/Files.h"
#include "VTK/Base/HapticFiles.h"

#include <cerrno>

namespace VolumeHaptics
{

GzipFile OpenGzipFile(const std::string& name, std::size_t offset, std::string& error)
{
  const int descriptor = Files::Open(name, Files::For::Reading);
  const bool isThere =
    descriptor >= 0 && Files::Seek(descriptor, static_cast<std::int64_t>(offset));
  GzipFile file(isThere ? gzdopen(descriptor, "rb") : nullptr, gzclose);
  if (!file)
  {
    error = "can't be read (" + DescribeError(errno) + "). Check its permissions.";
    if (descriptor >= 0)
    {
      Files::Close(descriptor);
    }
  }
  return file;
}

} // namespace VolumeHaptics
