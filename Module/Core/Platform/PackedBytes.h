// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Packs numbers and texts into bytes, to send them between processes of one build on one computer.
 * Unpacked bytes are only as trustworthy as the file that the other process has read.
 */
#ifndef PackedBytes_h
#define PackedBytes_h

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace VolumeHaptics
{

class BytePacker
{
public:
  template <typename T>
  void Put(const T& value)
  {
    static_assert(std::is_trivially_copyable<T>::value, "it is sent as it is in memory");
    this->PutBytes(&value, sizeof(value));
  }
  void PutBytes(const void* from, std::size_t size)
  {
    this->Bytes.append(static_cast<const char*>(from), size);
  }
  void PutText(const std::string& text)
  {
    this->Put<std::uint64_t>(text.size());
    this->Bytes += text;
  }
  template <typename T>
  void PutList(const std::vector<T>& list)
  {
    this->Put<std::uint64_t>(list.size());
    this->PutBytes(list.data(), list.size() * sizeof(T));
  }

  std::string Bytes;
};

/**
 * Unpacks numbers and texts from bytes. Throws std::runtime_error if the bytes are not as expected.
 */
class ByteUnpacker
{
public:
  explicit ByteUnpacker(const std::string& bytes)
    : Bytes(bytes)
  {
  }

  template <typename T>
  T Get()
  {
    if constexpr (std::is_same<T, bool>::value) // a byte may have a value other than 0 and 1
    {
      return this->Get<std::uint8_t>() != 0;
    }
    else
    {
      T value;
      std::memcpy(&value, this->Take(sizeof(T), 1), sizeof(T));
      return value;
    }
  }
  std::string GetText()
  {
    const auto size = this->Get<std::uint64_t>();
    const char* const begin = this->Take(size, 1);
    return std::string(begin, static_cast<std::size_t>(size));
  }
  template <typename T>
  std::vector<T> GetList()
  {
    const auto count = this->Get<std::uint64_t>();
    const char* const begin = this->Take(count, sizeof(T));
    std::vector<T> list(static_cast<std::size_t>(count));
    count > 0 ? std::memcpy(list.data(), begin, list.size() * sizeof(T)) : nullptr;
    return list;
  }
  /**
   * Returns the address of `count` elements with a given size, and moves the position past them.
   */
  const char* Take(std::uint64_t count, std::size_t size)
  {
    if (size > 0 && count > (this->Bytes.size() - this->At) / size)
    {
      throw std::runtime_error("it can't be read: its reader gave an answer that is cut off.");
    }
    const char* const begin = this->Bytes.data() + this->At;
    this->At += static_cast<std::size_t>(count) * size;
    return begin;
  }

private:
  const std::string& Bytes;
  std::size_t At = 0;
};

} // namespace VolumeHaptics

#endif
