// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/BlockCompressor.h"

#include "vtkNew.h"
#include "vtkZLibDataCompressor.h"

namespace VolumeHaptics
{

struct BlockCompressor::Library
{
  vtkNew<vtkZLibDataCompressor> ZLib;
};

BlockCompressor::BlockCompressor()
  : Used(new Library)
{
  // The values of ticks have few patterns: higher levels take longer and save only 0.4 percent.
  this->Used->ZLib->SetCompressionLevel(1);
}

BlockCompressor::~BlockCompressor()
{
  delete this->Used;
}

std::size_t BlockCompressor::Compress(const void* data, std::size_t size, std::string& to)
{
  const std::size_t begin = to.size();
  const std::size_t most = this->Used->ZLib->GetMaximumCompressionSpace(size);
  to.resize(begin + most);
  const std::size_t used = this->Used->ZLib->Compress(static_cast<const unsigned char*>(data), size,
    reinterpret_cast<unsigned char*>(&to[begin]), most);
  to.resize(begin + used);
  return used;
}

bool BlockCompressor::Expand(const std::string& block, void* data, std::size_t size)
{
  return this->Used->ZLib->Uncompress(reinterpret_cast<const unsigned char*>(block.data()),
           block.size(), static_cast<unsigned char*>(data), size) == size;
}

} // namespace VolumeHaptics
