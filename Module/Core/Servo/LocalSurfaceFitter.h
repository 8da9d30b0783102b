// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The slow loop of HapticMethod::LocalSurface, on a thread of its own: it fits a surface for the
 * servo's latest request HapticSettings::LocalSurfaceRate times a second.
 *
 * Requests and results go through triple buffers: neither side waits. A result is valid for the
 * request with its number, on the volume and settings that the servo uses.
 */
#ifndef LocalSurfaceFitter_h
#define LocalSurfaceFitter_h

#include "Core/Realtime/TripleBuffer.h"
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
  /** Runs the slow loop, on the slow thread. */
  void Run() noexcept;
  void RequestStop() noexcept { this->StopRequested.store(true, std::memory_order_release); }
  ///@}

  ///@{
  /**
   * PollResult returns the slow loop's latest result, without a surface if the result does not
   * answer `local`; Send passes on the request. Called by the servo.
   */
  LocalSurfaceResult PollResult(const HapticModel& model, const LocalState& local) noexcept;
  void Send(const HapticModel& model, const LocalState& local) noexcept;
  ///@}

private:
  struct Request
  {
    LocalSurfaceRequest Wanted;
    std::uint32_t Number = 0;
  };
  struct Result
  {
    LocalSurface Surface;
    std::uint32_t Number = 0;
    std::uint64_t Baked = 0; ///< BakedVolume::Number
  };

  /** Fits once, if a fit is due. Returns the time until the next call (ns). */
  std::int64_t Look() noexcept;

  ModelExchange& Models;
  TripleBuffer<Request> Requests;
  TripleBuffer<Result> Results;
  std::atomic<bool> StopRequested{ false };
  std::int64_t Looked = 0; ///< used by the slow thread: when the last fit was due
};

} // namespace VolumeHaptics

#endif
