// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Chooses how finely the volumes of a touched scene are rendered, so that a frame never blocks the
 * hand.
 */
#ifndef FrameQuality_h
#define FrameQuality_h

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class vtkCallbackCommand;
class vtkFixedPointVolumeRayCastMapper;
class vtkObject;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
class vtkRenderer;
class vtkSmartVolumeMapper;
class vtkVolume;
class vtkVolumeMapper;

namespace VolumeHaptics
{

class KeptRays;

/**
 * Estimates the total time of a frame while a mapper casts its rays row by row. The time before the
 * first ray, for example for the gradients of a new volume, is measured. Once a tenth of the rows
 * are done, the rest are assumed to take equally long.
 */
class RayProgress
{
public:
  static constexpr double LeastFraction = 0.1;

  /** Records the start of ray casting. `time` (s) counts from the beginning of the frame. */
  void Begin(double time)
  {
    this->Before = time;
    this->Whole.reset();
  }
  /**
   * Records the finished fraction of the rows. `time` (s) counts from the beginning of the frame.
   */
  void Record(double time, double fraction)
  {
    if (fraction >= LeastFraction)
    {
      this->Whole = this->Before + (time - this->Before) / fraction;
    }
  }
  /** Discards the frame's estimate. */
  void Clear() { this->Whole.reset(); }
  /**
   * Returns the estimated time (s) of the frame with all its rays; empty before a tenth of the rows
   * are done.
   */
  const std::optional<double>& GetWhole() const { return this->Whole; }

private:
  double Before = 0.0;
  std::optional<double> Whole;
};

/**
 * Chooses the distance between rays so that frames of one kind stay within a time limit. The
 * distance changes in steps, because a mapper makes new buffers whenever it changes.
 */
struct RayPace
{
  /** Largest step: a distance of 8 pixels. Each step multiplies the distance by sqrt(2). */
  static constexpr double MostSteps = 6.0;

  /**
   * Returns the distance (pixels) between rays for the next frame. `longest` is the time limit (s)
   * for this frame.
   */
  double Next(double longest)
  {
    if (this->Time > longest || this->Time < 0.6 * longest)
    {
      // Assume that the time is proportional to the number of rays, and so to 1 / distance^2. Other
      // drawing takes time, too, so the first distance may be wrong; the next frames correct it.
      const double steps = std::log2(this->Time / longest);
      this->Steps = std::clamp(
        this->Steps + (steps > 0.0 ? std::ceil(steps) : std::trunc(steps)), 0.0, MostSteps);
      this->Time = longest; // assumed until the next frame is measured
    }
    return std::exp2(0.5 * this->Steps);
  }
  /** Records the time (s) of a frame with all its rays. */
  void Record(double time)
  {
    this->Time = time;
    this->IsKnown = true;
  }

  double Time = 0.05; ///< time (s) of the last frame
  double Steps = 2.0;
  bool IsKnown = false; ///< whether Time was measured
};

/**
 * Adjusts the frames of one window:
 *
 * - In motion (the window requests more than 1 frame per second), ray casters cast as many rays as
 *   20 frames a second allow, at most one for each pixel. VTK's GPU mapper by itself would take
 *   fewer samples along each ray instead. Rays would then miss thin surfaces, which shows as dark
 *   speckles. So at least one sample is taken in each voxel.
 * - A mapper that runs on the processor keeps its image while camera and volume rest, and casts
 *   only the rays that the hand's stylus and arrows have changed (KeptRays). After a complete frame
 *   at rest, frames in motion keep using its fine rays while that is quick enough.
 * - At rest, each mapper draws as the application has set it. A mapper on the processor is
 *   interrupted by input. A mapper on the graphics card can't be interrupted, so while a device is
 *   armed, it casts as many rays as 0.1 s allows. While a device is armed, a mapper on the
 *   processor takes at most 0.5 s, because the device is not read during a frame, and its force
 *   fades after AttentionTime. A frame that turns out to take more than 1 s is abandoned, and drawn
 *   again at once with fewer rays.
 * - After a change of the window's size, the window shows nothing until a frame is done. So if the
 *   frame at rest takes long, a coarse frame, as in motion, is drawn first.
 * - If OpenGL runs on the processor, vtkSmartVolumeMapper casts rays without OpenGL while a scene
 *   is touched or plays: with Mesa's llvmpipe on two cores, that took a fifth of the time.
 *
 * An off-screen window is adjusted only with `offScreen`, because usually nobody waits for its
 * frames.
 */
class FrameQuality
{
public:
  enum class Touch
  {
    Off,
    On,
    Armed
  };

  /**
   * `touch` is called before each frame. It returns whether the scene is touched or plays (On), and
   * whether a device is armed.
   */
  explicit FrameQuality(std::function<Touch()> touch);
  ~FrameQuality();
  FrameQuality(const FrameQuality&) = delete;
  FrameQuality& operator=(const FrameQuality&) = delete;

  /**
   * Adjusts a window (nullptr: none), and restores the application's settings in the mappers of the
   * previous window. With `offScreen`, also adjusts an off-screen window.
   */
  void SetWindow(vtkRenderWindow* window, bool offScreen = false);

  /** Sets whether input may interrupt frames at rest. */
  void SetInterruptible(bool is) { this->IsInterruptible = is; }

  /** Reasons to render a frame again. */
  enum class Interruption
  {
    None,
    Input,  ///< input arrived during the frame
    Slow,   ///< the frame was too slow, so the next one casts fewer rays
    Resized ///< the window's size has changed, so the frame was rendered coarsely first
  };
  /**
   * Returns the reason to render the frame again, and resets it, so that the next call returns only
   * newer reasons.
   */
  Interruption DrainInterruption();

private:
  /** Adjustable settings of a mapper. */
  struct Settings
  {
    double ImageDistance; ///< distance between rays (pixels)
    double SampleDistance;
    bool AutoAdjust;
  };
  struct Caster
  {
    vtkWeakPointer<vtkVolumeMapper> Mapper;
    Settings Own;
    Settings Set;
    /** Caches the rays of a mapper on the processor that a single renderer uses. */
    std::shared_ptr<KeptRays> Rays;
    RayProgress Progress;    ///< progress of the frame; used only if the frame casts all rays
    unsigned long Frame = 0; ///< number of the last frame that the mapper was adjusted for
  };
  struct Smart
  {
    vtkWeakPointer<vtkSmartVolumeMapper> Mapper;
    int Mode;
    double SampleDistance;
    bool AutoAdjust;
    bool IsInteractive;
  };
  /** A volume with a mapper, and the renderer that draws it. */
  struct Shown
  {
    vtkRenderer* Renderer;
    vtkVolume* Volume;
  };

  void Begin();
  void End();
  void Interrupt();
  /** Records the fraction of the rows that a mapper has cast; 0 when the mapper begins. */
  void RecordProgress(vtkObject* mapper, double fraction);
  /**
   * Estimates the time (s) of the frame with all its rays. Returns nothing if the time can only be
   * known at the end of the frame.
   */
  std::optional<double> EstimateTime() const;
  /** Returns the time (s) since the frame began. */
  double GetElapsed() const;
  void Restore();
  template <typename Mapper>
  void Adjust(Mapper* mapper, const Shown& shown);
  /**
   * Adjusts the ray caster on the processor inside a smart mapper as if it were the volume's own
   * mapper.
   */
  void AdjustProcessor(vtkSmartVolumeMapper* mapper, const Shown& shown);
  void ChooseProcessor(vtkSmartVolumeMapper* mapper, bool touched);
  static void GiveBack(const Smart& smart);
  /** Makes the cache of rays for this mapper's image. */
  static void KeepRays(
    Caster& caster, vtkFixedPointVolumeRayCastMapper* mapper, const Shown& shown);
  /**
   * Returns whether OpenGL runs on the processor. Queries the window only once, because that takes
   * long.
   */
  bool IsOnProcessor();

  const std::function<Touch()> AskTouch;
  /** Returns the window if its frames are to be adjusted now; null otherwise. */
  vtkRenderWindow* GetWindow() const;

  vtkWeakPointer<vtkRenderWindow> Window;
  bool OffScreen = false; ///< whether to adjust off-screen windows, too
  vtkSmartPointer<vtkCallbackCommand> Observer;
  std::vector<Caster> Casters;
  std::vector<Smart> SmartMappers;
  std::chrono::steady_clock::time_point Start;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor; ///< the observed interactor
  std::array<int, 2> DrawnSize{};                       ///< size of the window in the last frame
  std::optional<bool> OnProcessor;                      ///< empty until known
  RayPace InMotion;
  RayPace AtRest;
  unsigned long Frame = 0;
  /**
   * Number of slow frames in motion with fine cached rays. After too many, rays are coarse until
   * the next rest.
   */
  int SlowFrames = 0;
  double CoarseTime = 0.0; ///< time (s) of frames in motion with coarse cached rays
  bool IsInterruptible = true;
  bool IsFine = false;    ///< whether this frame in motion uses the fine rays cached at rest
  bool IsExposed = false; ///< whether the interactor is about to draw the window
  bool IsResized = false; ///< whether the frame is rendered as in motion because the size has
                          ///< changed
  bool Moves = false;
  bool IsArmed = false;
  bool IsGivenUp = false; ///< whether the frame was abandoned because it takes too long
  Interruption Interrupted = Interruption::None;
};

} // namespace VolumeHaptics

#endif
