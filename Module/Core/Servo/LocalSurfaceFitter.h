// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The slow loop of HapticMethod::LocalSurface. In a separate thread, it fits a surface for the
 * servo's latest request, HapticSettings::LocalSurfaceRate times a second.
 *
 * Triple buffers pass requests and results, so that neither thread waits. A result answers the
 * request with the same number, provided that the servo still uses the same volume and settings.
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
  /** Runs the slow loop on the calling thread until RequestStop(). */
  void Run() noexcept;
  void RequestStop() noexcept { this->StopRequested.store(true, std::memory_order_release); }
  ///@}

  ///@{
  /**
   * PollResult() returns the latest result of the slow loop, without a surface if it does not
   * answer the request in `local`. Send() stores a request for the slow loop. Only the servo may
   * call these.
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
    std::uint64_t Baked = 0; ///< BakedVolume::Number of the model
  };

  /** Fits a surface if one is due. Returns the time (ns) until the next call. */
  std::int64_t Look() noexcept;

  ModelExchange& Models;
  TripleBuffer<Request> Requests;
  TripleBuffer<Result> Results;
  std::atomic<bool> StopRequested{ false };
  /** Time (ns) at which the last fit was due. Only the slow thread uses it. */
  std::int64_t Looked = 0;
};

} // namespace VolumeHaptics

#endif
