// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A value of several cache lines that reveals whether two writes were mixed, and a reader that
 * counts errors.
 */
#ifndef SealedValue_h
#define SealedValue_h

#include <cstdint>

namespace servotest
{
class SealedValue
{
public:
  SealedValue() = default;
  explicit SealedValue(std::uint64_t number)
  {
    for (std::uint64_t i = 0; i < Words; ++i)
    {
      this->Word[i] = number * (2 * i + 1);
    }
  }

  std::uint64_t Number() const { return this->Word[0]; }
  bool IsWhole() const
  {
    for (std::uint64_t i = 0; i < Words; ++i)
    {
      if (this->Word[i] != this->Word[0] * (2 * i + 1))
      {
        return false;
      }
    }
    return true;
  }

private:
  static constexpr std::uint64_t Words = 61;
  std::uint64_t Word[Words] = {};
};

/// Counts the errors in a sequence of numbered values that one thread reads from another.
class SealedReader
{
public:
  void Take(const SealedValue& value)
  {
    ++this->Taken;
    this->Torn += value.IsWhole() ? 0 : 1;
    this->Backward += value.Number() > this->Last ? 0 : 1;
    this->Last = value.Number();
  }

  std::uint64_t Taken = 0;
  std::uint64_t Torn = 0;
  std::uint64_t Backward = 0; ///< number of values that are not above the previous one
  std::uint64_t Last = 0;     ///< number of the latest value
};
} // namespace servotest

#endif
