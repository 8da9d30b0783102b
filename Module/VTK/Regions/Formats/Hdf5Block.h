// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Parses a piece of the structure of an HDF5 file.
 */
#ifndef Hdf5Block_h
#define Hdf5Block_h

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

/** Reads consecutive numbers, least significant byte first, and texts. */
class Hdf5Block
{
public:
  explicit Hdf5Block(std::vector<unsigned char> bytes = {})
    : Bytes(std::move(bytes))
  {
  }

  [[noreturn]] static void ThrowDamaged()
  {
    throw std::runtime_error("it is damaged: its HDF5 structure ends too early or makes no sense. "
                             "Copy or write it again.");
  }

  std::size_t GetPlace() const { return this->Place; }
  std::size_t GetLeft() const { return this->Bytes.size() - this->Place; }
  void Go(std::size_t place)
  {
    if (place > this->Bytes.size())
    {
      ThrowDamaged();
    }
    this->Place = place;
  }
  void Skip(std::size_t count) { this->Go(this->Place + this->Need(count)); }
  /** Reads a whole number of up to 8 bytes. */
  std::uint64_t Number(std::size_t size)
  {
    this->Need(size);
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < size && i < 8; ++i)
    {
      number |= std::uint64_t{ this->Bytes[this->Place + i] } << (8 * i);
    }
    this->Place += size;
    return number;
  }
  int Byte() { return static_cast<int>(this->Number(1)); }
  std::vector<char> Take(std::size_t count)
  {
    this->Need(count);
    const auto begin = this->Bytes.begin() + static_cast<std::ptrdiff_t>(this->Place);
    this->Place += count;
    return { begin, begin + static_cast<std::ptrdiff_t>(count) };
  }
  Hdf5Block Part(std::size_t count)
  {
    const std::vector<char> bytes = this->Take(count);
    return Hdf5Block({ bytes.begin(), bytes.end() });
  }
  /** Reads a text up to the next null character. */
  std::string Text()
  {
    std::string text;
    for (int letter = this->Byte(); letter != 0; letter = this->Byte())
    {
      text += static_cast<char>(letter);
    }
    return text;
  }
  bool Begins(const char* signature)
  {
    const std::string wanted = signature;
    const std::vector<char> bytes = this->Take(wanted.size());
    return std::string(bytes.begin(), bytes.end()) == wanted;
  }

private:
  std::size_t Need(std::size_t count) const
  {
    if (count > this->GetLeft())
    {
      ThrowDamaged();
    }
    return count;
  }

  std::vector<unsigned char> Bytes;
  std::size_t Place = 0;
};

} // namespace VolumeHaptics

#endif
