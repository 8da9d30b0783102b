// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Waits until another thread has done its work. */
#ifndef Eventually_h
#define Eventually_h

#include <chrono>
#include <thread>

namespace devicetest
{
/// Polls until `holds` returns true. Returns false after a timeout of at least 30 s.
template <typename F>
bool Eventually(F&& holds)
{
#if defined(__SANITIZE_THREAD__)
  constexpr std::chrono::seconds longest(120); // sanitizers slow programs down several times
#else
  constexpr std::chrono::seconds longest(30);
#endif
  const auto end = std::chrono::steady_clock::now() + longest;
  while (!holds())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  return true;
}
} // namespace devicetest

#endif
