// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Waits for what a kernel does in its own time.
 */
#ifndef Waiting_h
#define Waiting_h

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace machinetest
{
/** Polls until something holds; false after a generous time. */
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
} // namespace machinetest

#endif
