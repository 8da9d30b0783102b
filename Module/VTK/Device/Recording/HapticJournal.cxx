// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/HapticJournal.h"

#include "VTK/Trace/HapticTraceColumns.h"

#include "vtkNew.h"
#include "vtkZLibDataCompressor.h"

namespace VolumeHaptics
{

std::uint64_t SumOf(const std::string& payload)
{
  // FNV-1a hash
  std::uint64_t sum = 0xCBF29CE484222325ULL;
  for (const char c : payload)
  {
    sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  }
  return sum;
}

std::string SignatureOfColumns()
{
  std::string signature;
  for (const TraceColumn& column : GetRecordingColumns())
  {
    signature += std::string(column.Name) + ":" + std::to_string(static_cast<int>(column.Type)) +
      ":" + std::to_string(column.Components) + " ";
  }
  return signature;
}

void PutText(std::string& bytes, const std::string& text)
{
  Put(bytes, static_cast<std::uint64_t>(text.size()));
  bytes += text;
}

bool GetText(const std::string& bytes, std::size_t& position, std::string& text)
{
  std::uint64_t size = 0;
  if (!Get(bytes, position, size) || size > bytes.size() - position)
  {
    return false;
  }
  text = bytes.substr(position, size);
  position += size;
  return true;
}

struct BlockCompressor::Library
{
  vtkNew<vtkZLibDataCompressor> ZLib;
};

BlockCompressor::BlockCompressor()
  : Used(new Library)
{
  // Use the fastest level: the values of ticks have few patterns, so higher levels take longer and
  // save only 0.4 percent.
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
