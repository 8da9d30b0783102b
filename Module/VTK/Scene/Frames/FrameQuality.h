// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How finely the volumes of a touched scene are drawn, so that a frame never blocks the hand.
 */
#ifndef FrameQuality_h
#define FrameQuality_h

#include "VTK/Scene/Frames/RayPace.h"
#include "VTK/Scene/Frames/RayProgress.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <chrono>
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
 * Follows the frames of one window:
 *
 * - In motion (the window wants more than 1 frame a second) ray casters cast as many rays as 20
 *   frames a second allow, one for each pixel at best. VTK's GPU mapper by itself would save
 *   samples along each ray, which lets rays miss thin surfaces: dark speckles. So a sample is taken
 *   in each voxel at least.
 * - A mapper that runs on the processor keeps its image while camera and volume rest, and casts
 *   only the rays that the hand's stylus and arrows have changed (KeptRays). After a complete frame
 *   at rest, frames in motion use its fine rays as long as that is quick enough.
 * - At rest each mapper draws as the application has set it. A mapper that runs on the processor is
 *   interrupted as soon as there is input. One that runs on the graphics card can't be: while a
 *   device is armed, it casts as many rays as 0.1 s allows. The other one then takes 0.5 s at most:
 *   meanwhile nobody reads the device, and its force fades after AttentionTime. As soon as a frame
 *   is seen to take more than 1 s, it is given up and drawn again with fewer rays, at once.
 * - Somebody who changes the window's size would see nothing until the frame at rest is done. So
 *   if that takes long, a frame as in motion comes first.
 * - vtkSmartVolumeMapper casts rays on the processor while a scene is touched or plays, if OpenGL
 *   runs there, too: measured with Mesa's llvmpipe on two cores, that takes a fifth of the time.
 *
 * A window off the screen is left alone, because nobody waits for its pictures, unless it is told
 * that somebody does.
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

  /** `touch` tells before each frame whether the scene is touched; On also if it plays. */
  explicit FrameQuality(std::function<Touch()> touch);
  ~FrameQuality();
  FrameQuality(const FrameQuality&) = delete;
  FrameQuality& operator=(const FrameQuality&) = delete;

  /**
   * Follows this window, nullptr for none, and gives the mappers of the last one their own settings
   * back. `offScreen`: also if it is off the screen.
   */
  void SetWindow(vtkRenderWindow* window, bool offScreen = false);

  /** Why a frame is to be drawn again. */
  enum class Interruption
  {
    None,
    Input,  ///< has come meanwhile
    Slow,   ///< it would have taken too long: the next one casts fewer rays
    Resized ///< the window, so that it was drawn coarsely first
  };
  /** Why a frame is to be drawn again since the last call. */
  Interruption TakeInterruption();

private:
  /** A mapper with what the application has set, and what this has. */
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
    std::shared_ptr<KeptRays> Rays; ///< of one that runs on the processor, in a single renderer
    RayProgress Progress;           ///< of the frame, if it casts all rays
    unsigned long Frame = 0;        ///< that it was adjusted for
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
  /** Notes which share of its rows a mapper has cast; 0 when it begins. */
  void FollowProgress(vtkObject* mapper, double share);
  /** The time of the frame with all its rays, s, if it is known before its end. */
  std::optional<double> EstimateTime() const;
  /** Since the beginning of the frame, s. */
  double GetElapsed() const;
  void Restore();
  template <typename Mapper>
  void Adjust(Mapper* mapper, const Shown& shown);
  /** Its own ray caster on the processor, as if it were the volume's mapper. */
  void AdjustProcessor(vtkSmartVolumeMapper* mapper, const Shown& shown);
  void ChooseProcessor(vtkSmartVolumeMapper* mapper, bool touched);
  static void GiveBack(const Smart& smart);
  /** Makes what keeps the rays of this mapper's image. */
  static void FollowRays(
    Caster& caster, vtkFixedPointVolumeRayCastMapper* mapper, const Shown& shown);
  /** Whether OpenGL runs on the processor. Asks the window once, because its answer takes long. */
  bool IsOnProcessor();

  const std::function<Touch()> AskTouch;
  /** The window, if its frames are adjusted now. */
  vtkRenderWindow* FindWindow() const;

  vtkWeakPointer<vtkRenderWindow> Window;
  bool OffScreen = false; ///< also where the window is off the screen
  vtkSmartPointer<vtkCallbackCommand> Observer;
  std::vector<Caster> Casters;
  std::vector<Smart> SmartMappers;
  std::chrono::steady_clock::time_point Start;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor; ///< that is observed
  std::array<int, 2> DrawnSize{};                       ///< of the window, by the last frame
  std::optional<bool> OnProcessor;                      ///< empty: not known yet
  RayPace InMotion;
  RayPace AtRest;
  unsigned long Frame = 0;
  /** In motion, with fine kept rays; after too many, these are coarse until the next rest. */
  int SlowFrames = 0;
  double CoarseTime = 0.0; ///< s, of frames in motion with coarse kept rays
  bool IsFine = false;     ///< the frame in motion keeps the fine rays of rest
  bool IsExposed = false;  ///< the interactor is about to draw the window
  bool IsResized = false;  ///< the frame is drawn as in motion for that
  bool Moves = false;
  bool IsArmed = false;
  bool IsGivenUp = false; ///< the frame, because it takes too long
  Interruption Interrupted = Interruption::None;
};

} // namespace VolumeHaptics

#endif
