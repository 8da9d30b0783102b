// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Calls a model once per millisecond of its own time, which never runs ahead of the real time. */
#ifndef ModelClock_h
#define ModelClock_h

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace emulated
{

class ModelClock
{
public:
  explicit ModelClock(std::function<void()> step)
    : Thread([this, step] { this->Run(step); })
  {
  }
  ~ModelClock()
  {
    this->Stop = true;
    this->Thread.join();
  }

private:
  void Run(const std::function<void()>& step)
  {
    auto next = std::chrono::steady_clock::now();
    while (!this->Stop)
    {
      step();
      // Skip missed ticks. On a busy machine, the model then slows down instead of jumping.
      next = std::max(std::chrono::steady_clock::now(), next + std::chrono::milliseconds(1));
      std::this_thread::sleep_until(next);
    }
  }

  std::atomic<bool> Stop{ false };
  std::thread Thread;
};

} // namespace emulated

#endif
