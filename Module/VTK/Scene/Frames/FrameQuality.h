// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Chooses how finely the volumes of a touched scene are drawn, so that a frame never blocks the
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
 * Estimates the time of a whole frame while a mapper casts its rays row by row. The time of the
 * work before the rays, such as computing the gradients of a new volume, is measured. After a tenth
 * of the rows, the other rows are assumed to take the same time each.
 */
class RayProgress
{
public:
  static constexpr double LeastFraction = 0.1;

  /** Records that the rays begin. `time` (s) counts from the beginning of the frame. */
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
  /** Forgets the frame. */
  void Clear() { this->Whole.reset(); }
  /**
   * Returns the time of the frame with all its rays (s); empty before a tenth of the rows is cast.
   */
  const std::optional<double>& GetWhole() const { return this->Whole; }

private:
  double Before = 0.0;
  std::optional<double> Whole;
};

/**
 * Chooses the distance between rays so that frames of one kind stay within a time. The distance
 * changes in steps, because a mapper makes new buffers whenever its distance changes.
 */
struct RayPace
{
  /** most steps: 8 pixels; each step multiplies the distance by sqrt(2) */
  static constexpr double MostSteps = 6.0;

  /**
   * Returns the distance between rays for the next frame (pixels). `longest` is the most time (s)
   * that this frame may take.
   */
  double Next(double longest)
  {
    if (this->Time > longest || this->Time < 0.6 * longest)
    {
      // Assume that rays take all of the time: their number falls with the square of their
      // distance. Other drawing takes time, too, so the distance may be wrong at first; the next
      // frames correct it.
      const double steps = std::log2(this->Time / longest);
      this->Steps = std::clamp(
        this->Steps + (steps > 0.0 ? std::ceil(steps) : std::trunc(steps)), 0.0, MostSteps);
      this->Time = longest; // assumed until the next frame's time is known
    }
    return std::exp2(0.5 * this->Steps);
  }
  /** Records the time (s) of a frame with all its rays. */
  void Record(double time)
  {
    this->Time = time;
    this->IsKnown = true;
  }

  double Time = 0.05; ///< s, time of the last frame
  double Steps = 2.0;
  bool IsKnown = false; ///< whether the time was measured
};

/**
 * Adjusts the frames of one window:
 *
 * - In motion (the window wants more than 1 frame a second), ray casters cast as many rays as 20
 *   frames a second allow, at most one for each pixel. VTK's GPU mapper by itself would take fewer
 *   samples along each ray instead. Rays would then miss thin surfaces, which shows as dark
 *   speckles. So at least one sample is taken in each voxel.
 * - A mapper that runs on the processor keeps its image while camera and volume rest, and casts
 *   only the rays that the hand's stylus and arrows have changed (KeptRays). After a complete frame
 *   at rest, frames in motion keep using its fine rays while that is quick enough.
 * - At rest, each mapper draws as the application has set it. A mapper on the processor is
 *   interrupted by input. A mapper on the graphics card can't be interrupted, so while a device is
 *   armed, it casts as many rays as 0.1 s allows. While a device is armed, a mapper on the
 *   processor takes at most 0.5 s, because the device is not read during a frame, and its force
 *   fades after AttentionTime. A frame that turns out to take more than 1 s is given up, and drawn
 *   again at once with fewer rays.
 * - After a change of the window's size, the window shows nothing until a frame is done. So if the
 *   frame at rest takes long, a coarse frame, as in motion, is drawn first.
 * - If OpenGL runs on the processor, vtkSmartVolumeMapper casts rays without OpenGL while a scene
 *   is touched or plays: with Mesa's llvmpipe on two cores, that took a fifth of the time.
 *
 * A window off the screen is adjusted only with `offScreen`, because otherwise nobody waits for its
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
   * `touch` is called before each frame. It returns whether the scene is touched, or plays (On),
   * and whether a device is armed.
   */
  explicit FrameQuality(std::function<Touch()> touch);
  ~FrameQuality();
  FrameQuality(const FrameQuality&) = delete;
  FrameQuality& operator=(const FrameQuality&) = delete;

  /**
   * Adjusts a window (nullptr: none), and restores the application's settings in the mappers of the
   * last window. With `offScreen`, also adjusts a window off the screen.
   */
  void SetWindow(vtkRenderWindow* window, bool offScreen = false);

  /** Sets whether input interrupts frames at rest. */
  void SetInterruptible(bool is) { this->IsInterruptible = is; }

  /** Reasons to draw a frame again. */
  enum class Interruption
  {
    None,
    Input,  ///< input came during the frame
    Slow,   ///< the frame was too slow, so the next frame casts fewer rays
    Resized ///< the window's size has changed, so the frame was drawn coarsely first
  };
  /**
   * Returns the reason for which a frame has to be drawn again; forgets it, so that the next call
   * returns only newer reasons.
   */
  Interruption DrainInterruption();

private:
  /** The adjustable settings of a mapper. */
  struct Settings
  {
    double ImageDistance; ///< pixels between rays
    double SampleDistance;
    bool AutoAdjust;
  };
  struct Caster
  {
    vtkWeakPointer<vtkVolumeMapper> Mapper;
    Settings Own;
    Settings Set;
    /** keeps the rays of a mapper on the processor that is drawn in a single renderer */
    std::shared_ptr<KeptRays> Rays;
    RayProgress Progress;    ///< progress of the frame, if it casts all rays
    unsigned long Frame = 0; ///< number of the last frame for which the mapper was adjusted
  };
  struct Smart
  {
    vtkWeakPointer<vtkSmartVolumeMapper> Mapper;
    int Mode;
    double SampleDistance;
    bool AutoAdjust;
    bool IsInteractive;
  };
  /** The volume of a mapper, and the renderer that draws it. */
  struct Shown
  {
    vtkRenderer* Renderer;
    vtkVolume* Volume;
  };

  void Begin();
  void End();
  void Interrupt();
  /** Records the fraction of the rows that a mapper has cast. It is 0 when the mapper begins. */
  void RecordProgress(vtkObject* mapper, double fraction);
  /**
   * Estimates the time of the frame with all its rays (s). The result is empty if the time can be
   * known only at the frame's end.
   */
  std::optional<double> EstimateTime() const;
  /** Returns the time since the beginning of the frame (s). */
  double GetElapsed() const;
  void Restore();
  template <typename Mapper>
  void Adjust(Mapper* mapper, const Shown& shown);
  /**
   * Adjusts the ray caster on the processor within a smart mapper, as if it were the volume's own
   * mapper.
   */
  void AdjustProcessor(vtkSmartVolumeMapper* mapper, const Shown& shown);
  void ChooseProcessor(vtkSmartVolumeMapper* mapper, bool touched);
  static void GiveBack(const Smart& smart);
  /** Makes the object that keeps the rays of this mapper's image. */
  static void KeepRays(
    Caster& caster, vtkFixedPointVolumeRayCastMapper* mapper, const Shown& shown);
  /**
   * Returns whether OpenGL runs on the processor. Asks the window once, because the answer takes
   * long.
   */
  bool IsOnProcessor();

  const std::function<Touch()> AskTouch;
  /** Returns the window, if its frames are adjusted now; otherwise null. */
  vtkRenderWindow* GetWindow() const;

  vtkWeakPointer<vtkRenderWindow> Window;
  bool OffScreen = false; ///< adjusts windows off the screen, too
  vtkSmartPointer<vtkCallbackCommand> Observer;
  std::vector<Caster> Casters;
  std::vector<Smart> SmartMappers;
  std::chrono::steady_clock::time_point Start;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor; ///< the observed interactor
  std::array<int, 2> DrawnSize{};                       ///< size of the window in the last frame
  std::optional<bool> OnProcessor;                      ///< empty: not known yet
  RayPace InMotion;
  RayPace AtRest;
  unsigned long Frame = 0;
  /**
   * The number of slow frames in motion with fine kept rays. After too many of them, rays are
   * coarse until the next rest.
   */
  int SlowFrames = 0;
  double CoarseTime = 0.0; ///< time of frames in motion with coarse kept rays (s)
  bool IsInterruptible = true;
  bool IsFine = false;    ///< whether the current frame in motion uses the fine rays kept from rest
  bool IsExposed = false; ///< whether the interactor is about to draw the window
  bool IsResized = false; ///< whether the frame is drawn as in motion because the size has changed
  bool Moves = false;
  bool IsArmed = false;
  bool IsGivenUp = false; ///< whether the frame was ended because it takes too long
  Interruption Interrupted = Interruption::None;
};

} // namespace VolumeHaptics

#endif
