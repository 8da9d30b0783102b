// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/HapticJournalChunks.h"

#include "VTK/Trace/HapticTraceColumns.h"

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

} // namespace VolumeHaptics
