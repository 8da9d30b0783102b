// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Runs threads that compute without pause, as a software renderer does. */
#ifndef BusyThreads_h
#define BusyThreads_h

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

namespace devicetest
{
class BusyThreads
{
public:
  explicit BusyThreads(unsigned count)
  {
    for (unsigned i = 0; i < count; ++i)
    {
      this->Threads.emplace_back(
        [this]
        {
          volatile double value = 1.0;
          while (!this->Stop.load())
          {
            for (int k = 0; k < 10000; ++k)
            {
              value = std::sin(value) + 1.0;
            }
          }
        });
    }
  }
  ~BusyThreads()
  {
    this->Stop.store(true);
    for (std::thread& thread : this->Threads)
    {
      thread.join();
    }
  }
  BusyThreads(const BusyThreads&) = delete;
  BusyThreads& operator=(const BusyThreads&) = delete;

private:
  std::atomic<bool> Stop{ false };
  std::vector<std::thread> Threads;
};
} // namespace devicetest

#endif
