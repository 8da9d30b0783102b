// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Controls how ParaView's volumes are drawn while a hand touches them.
 */
#ifndef HapticVolumeFrames_h
#define HapticVolumeFrames_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <chrono>
#include <optional>
#include <vector>

class vtkCallbackCommand;
class vtkObject;
class vtkRenderWindow;
class vtkRenderer;
class vtkSMProxy;
class vtkSMRenderViewProxy;

namespace VolumeHaptics
{

/**
 * ParaView draws images as volumes with vtkMultiBlockVolumeMapper, which hides its ray casters. On
 * software OpenGL its frames in motion are speckled and slow. So this class does what FrameQuality
 * does with VTK's own mappers:
 *
 * - While a scene is touched and OpenGL runs on the processor of the client or server that draws,
 *   volumes whose mode is Smart are drawn by VTK's ray caster for processors if it can: one
 *   component, at points, of an image. The property VolumeRenderingMode stays as it is.
 * - Frames in motion that the client draws with that ray caster take 30 ms: it gets the time that
 *   the rest of the frame leaves, and casts as many rays as fit. Qt draws its window meanwhile,
 *   so that 20 frames a second are left. ParaView itself asks for 5.
 * - These frames are drawn without FXAA, which would take more time there than everything else.
 * - Frames at rest take half a second at most while a device is armed. While the scene is touched,
 *   they are given up within 0.2 s of a motion of the pointer, if its position is known; VTK asks
 *   no more often.
 */
class HapticVolumeFrames
{
public:
  enum class Touch
  {
    Off,
    On,
    Armed
  };

  HapticVolumeFrames();
  ~HapticVolumeFrames();
  HapticVolumeFrames(const HapticVolumeFrames&) = delete;
  HapticVolumeFrames& operator=(const HapticVolumeFrames&) = delete;

  /**
   * Restores the own mode of the last view's volumes, and adjusts those of another view. nullptr
   * for none.
   */
  void SetView(vtkSMRenderViewProxy* view);
  /** Leaves the volumes as they are: nothing may be sent to a lost server. */
  void Forget() { this->Volumes.clear(); }
  /** Draws the view with InteractiveRender or StillRender. */
  void Draw(bool quickly, Touch touch);

  /**
   * Sets a function that returns the pointer's position on the screen, even if its events wait in a
   * queue that is not VTK's; nullptr: the position is not known.
   */
  using PointerQuery = void (*)(int position[2]);
  static void SetPointerQuery(PointerQuery query);

private:
  /** A volume that is drawn by a ray caster other than ParaView's choice. */
  struct Volume
  {
    vtkWeakPointer<vtkSMProxy> Representation;
    vtkWeakPointer<vtkSMProxy> Drawn; ///< the part that draws the volume
    unsigned long long SetTime;       ///< time of the property VolumeRenderingMode
  };
  /**
   * The rate (Hz) at which the ray caster is asked to draw, so that a frame takes its allowed time.
   */
  struct Rate
  {
    double Hz;
    void Update(double time, double longest);
  };

  void ChooseRayCasters(Touch touch);
  /**
   * Whether the process that has the data, and so draws the volumes, has OpenGL on the processor.
   */
  bool IsOnProcessor();
  bool IsWindowOnProcessor();
  /** Whether this object chooses the rate of the frame. */
  bool SetsRate() const { return this->CastsOnProcessor && (this->IsQuick || this->IsArmed); }
  void Begin();
  /** Restore FXAA, and the swap of buffers. */
  void GiveBack();
  void End();
  void Interrupt();

  vtkWeakPointer<vtkSMRenderViewProxy> View;
  vtkWeakPointer<vtkRenderWindow> Window;
  vtkNew<vtkCallbackCommand> Observer;
  std::vector<Volume> Volumes;
  std::vector<vtkWeakPointer<vtkRenderer>> Smoothed; ///< renderers whose FXAA is off for now
  ///@{
  /** Empty: not known yet. */
  std::optional<bool> OnProcessor;
  std::optional<bool> WindowOnProcessor;
  ///@}
  bool CastsOnProcessor = false; ///< some volume is drawn by another ray caster
  bool IsDrawing = false;
  bool IsQuick = false;
  bool IsTouched = false;
  bool IsArmed = false;
  bool KeepsPicture = false; ///< the frame is not shown
  Rate InMotion{ 20.0 };
  Rate AtRest{ 2.0 };
  std::chrono::steady_clock::time_point Start;
  int Pointer[2] = { 0, 0 }; ///< pointer at the frame's beginning
};

} // namespace VolumeHaptics

#endif
