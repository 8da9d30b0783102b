// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Provides code for all fuzz targets: choices made from bytes, and checks that abort.
 */
#ifndef Dealer_h
#define Dealer_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

/** Hands out a fuzzer's bytes one after another, and zeros after the last byte. */
class Dealer
{
public:
  Dealer(const std::uint8_t* bytes, std::size_t size)
    : Bytes(bytes)
    , Left(size)
  {
  }

  bool HasMore() const { return this->Left > 0; }
  std::uint8_t Byte()
  {
    if (this->Left == 0)
    {
      return 0;
    }
    --this->Left;
    return *this->Bytes++;
  }
  int Choose(int count) { return this->Byte() % count; }
  /** Returns a number from `low` to `high`, in steps of 1/65535 of their difference. */
  double Between(double low, double high)
  {
    const int word = this->Byte() * 256 + this->Byte();
    return low + (high - low) * word / 65535.0;
  }
  void Fill(void* to, std::size_t size)
  {
    const std::size_t some = size < this->Left ? size : this->Left;
    // Avoid memcpy(), which needs valid pointers even for zero bytes.
    char* const rest = std::copy_n(this->Bytes, some, static_cast<char*>(to));
    std::fill_n(rest, size - some, '\0');
    this->Bytes += some;
    this->Left -= some;
  }

private:
  const std::uint8_t* Bytes;
  std::size_t Left;
};

inline void Check(bool holds, const char* what)
{
  if (!holds)
  {
    std::fprintf(stderr, "Violated: %s\n", what);
    std::abort();
  }
}

#endif
