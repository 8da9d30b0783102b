// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Waits for the kernel, and measures how long it takes.
 */
#ifndef Waiting_h
#define Waiting_h

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <thread>

namespace machinetest
{
/** Polls until `holds` returns true. Returns false after a generous time. */
template <typename F>
bool Eventually(F&& holds)
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!holds())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/** Counts events. At its end, prints how many events there were per second. */
class RateOf
{
public:
  RateOf(const char* what, int times)
    : What(what)
    , Times(times)
  {
  }
  ~RateOf()
  {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - this->Begin;
    std::cout << this->What << ": " << this->Times / time.count() << " round trips/s\n";
  }

private:
  const char* const What;
  const int Times;
  const std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now();
};
} // namespace machinetest

#endif
