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
 * Estimates the time of a whole frame while a mapper casts its rays row by row. Work before the
 * rays, such as the gradients of a new volume, counts as measured. After a tenth of the rows, the
 * other rows are assumed to take the same time each.
 */
class RayProgress
{
public:
  static constexpr double LeastFraction = 0.1;

  /** Called when the rays begin. `time` (s) counts from the beginning of the frame. */
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
  /** Returns the time of the frame with all its rays (s); empty while too few are cast. */
  const std::optional<double>& GetWhole() const { return this->Whole; }

private:
  double Before = 0.0;
  std::optional<double> Whole;
};

/**
 * The distance between rays that keeps frames of one kind within a time. It changes in steps,
 * because a mapper whose distance changes makes new buffers.
 */
struct RayPace
{
  static constexpr double MostSteps = 6.0; ///< 8 pixels; a step multiplies the distance by sqrt(2)

  /**
   * Returns the distance between rays for the next frame (pixels). `longest`: the most time (s)
   * that this frame may take.
   */
  double Next(double longest)
  {
    if (this->Time > longest || this->Time < 0.6 * longest)
    {
      // Assume that rays take all of the time: their number falls with the square of their
      // distance. Other drawing takes time, too; the next frames correct this.
      const double steps = std::log2(this->Time / longest);
      this->Steps = std::clamp(
        this->Steps + (steps > 0.0 ? std::ceil(steps) : std::trunc(steps)), 0.0, MostSteps);
      this->Time = longest; // assumed until the next frame's time is known
    }
    return std::exp2(0.5 * this->Steps);
  }
  /** Records the time of a frame with all its rays, s. */
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
 * - In motion (the window wants more than 1 frame a second) ray casters cast as many rays as 20
 *   frames a second allow, one for each pixel at best. VTK's GPU mapper by itself would save
 *   samples along each ray, which lets rays miss thin surfaces: dark speckles. So a sample is taken
 *   in each voxel at least.
 * - A mapper that runs on the processor keeps its image while camera and volume rest, and casts
 *   only the rays that the hand's stylus and arrows have changed (KeptRays). After a complete frame
 *   at rest, frames in motion use its fine rays as long as that is quick enough.
 * - At rest each mapper draws as the application has set it. A mapper that runs on the processor is
 *   interrupted as soon as there is input. A mapper on the graphics card can't be interrupted:
 *   while a device is armed, it casts as many rays as 0.1 s allows. While a device is armed, the
 *   processor's mapper takes 0.5 s at most: meanwhile nobody reads the device, and its force fades
 *   after AttentionTime. As soon as a frame is seen to take more than 1 s, it is given up and drawn
 *   again with fewer rays, at once.
 * - After a change of the window's size, nothing would be seen until the frame at rest is done. So
 *   if that frame takes long, a frame as in motion comes first.
 * - vtkSmartVolumeMapper casts rays on the processor while a scene is touched or plays, if OpenGL
 *   runs there, too: measured with Mesa's llvmpipe on two cores, that takes a fifth of the time.
 *
 * A window off the screen is not adjusted, because nobody waits for its pictures, unless
 * `offScreen` says that somebody does.
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
   * Borrows a function that tells, before each frame, whether the scene is touched; On also if it
   * plays.
   */
  explicit FrameQuality(std::function<Touch()> touch);
  ~FrameQuality();
  FrameQuality(const FrameQuality&) = delete;
  FrameQuality& operator=(const FrameQuality&) = delete;

  /**
   * Adjusts a window (nullptr: none), and restores the own settings of the last window's mappers.
   * With `offScreen`, also adjusts a window off the screen.
   */
  void SetWindow(vtkRenderWindow* window, bool offScreen = false);

  /** Why a frame is to be drawn again. */
  enum class Interruption
  {
    None,
    Input,  ///< input came during the frame
    Slow,   ///< too slow: the next frame casts fewer rays
    Resized ///< the window's size has changed: the frame was drawn coarsely first
  };
  /** Returns why a frame has to be drawn again since the last call. */
  Interruption DrainInterruption();

private:
  /** A mapper, the settings of its application, and the settings made here. */
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
    std::shared_ptr<KeptRays> Rays; ///< kept rays of a processor's mapper in a single renderer
    RayProgress Progress;           ///< progress of the frame, if it casts all rays
    unsigned long Frame = 0;        ///< the frame that it was adjusted for
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
  /** Records which fraction of its rows a mapper has cast; 0 when it begins. */
  void RecordProgress(vtkObject* mapper, double fraction);
  /**
   * Estimates the time of the frame with all its rays (s); empty if it is not known before the
   * frame's end.
   */
  std::optional<double> EstimateTime() const;
  /** Returns the time since the beginning of the frame (s). */
  double GetElapsed() const;
  void Restore();
  template <typename Mapper>
  void Adjust(Mapper* mapper, const Shown& shown);
  /** Adjusts a smart mapper's own ray caster on the processor as if it were the volume's mapper. */
  void AdjustProcessor(vtkSmartVolumeMapper* mapper, const Shown& shown);
  void ChooseProcessor(vtkSmartVolumeMapper* mapper, bool touched);
  static void GiveBack(const Smart& smart);
  /** Makes the object that keeps the rays of this mapper's image. */
  static void KeepRays(
    Caster& caster, vtkFixedPointVolumeRayCastMapper* mapper, const Shown& shown);
  /** Whether OpenGL runs on the processor. Asks the window once, because the answer takes long. */
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
   * Frames in motion with fine kept rays; after too many of them, rays are coarse until the next
   * rest.
   */
  int SlowFrames = 0;
  double CoarseTime = 0.0; ///< time of frames in motion with coarse kept rays (s)
  bool IsFine = false;     ///< whether the frame in motion keeps the fine rays of rest
  bool IsExposed = false;  ///< whether the interactor is about to draw the window
  bool IsResized = false;  ///< whether the frame is drawn as in motion because the size has changed
  bool Moves = false;
  bool IsArmed = false;
  bool IsGivenUp = false; ///< whether the frame was ended because it takes too long
  Interruption Interrupted = Interruption::None;
};

} // namespace VolumeHaptics

#endif
