// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The slow loop of HapticMethod::LocalSurface, on a thread of its own: it answers the servo's
 * latest question HapticSettings::LocalSurfaceRate times a second.
 *
 * Questions and answers go through triple buffers: neither side waits for the other. An answer
 * counts for the question whose number it carries, and for the volume and settings that the servo
 * uses.
 */
#ifndef LocalSurfaceFitter_h
#define LocalSurfaceFitter_h

#include "Core/Servo/TripleBuffer.h"
#include "Core/Solvers/LocalSurface/LocalSurfaceSolver.h"

namespace VolumeHaptics
{
class ModelExchange;

class LocalSurfaceFitter
{
public:
  explicit LocalSurfaceFitter(ModelExchange& models) noexcept
    : Models(models)
  {
  }

  ///@{
  /** The slow thread. */
  void Run() noexcept;
  void RequestStop() noexcept { this->StopRequested.store(true, std::memory_order_release); }
  ///@}

  ///@{
  /** The servo's side. */
  LocalAnswer FindAnswer(const HapticModel& model, const LocalState& local) noexcept;
  void Ask(const HapticModel& model, const LocalState& local) noexcept;
  ///@}

private:
  struct Question
  {
    LocalQuestion Asked;
    std::uint32_t Number = 0;
  };
  struct Answer
  {
    LocalSurface Surface;
    std::uint32_t Number = 0;
    std::uint64_t Baked = 0; ///< of the volume and the settings
  };

  /** Looks once; ns until the next look. */
  std::int64_t Look() noexcept;

  ModelExchange& Models;
  TripleBuffer<Question> Questions;
  TripleBuffer<Answer> Answers;
  std::atomic<bool> StopRequested{ false };
  std::int64_t Looked = 0; ///< the slow thread's: when the last look was due
};

} // namespace VolumeHaptics

#endif
