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
 * ParaView draws images as volumes with vtkMultiBlockVolumeMapper, which hides its ray casters.
 * With software OpenGL, its frames in motion are speckled and slow. Therefore this class does for
 * ParaView what FrameQuality does for VTK's own mappers:
 *
 * - While a scene is touched, and the client or server that draws has software OpenGL, volumes
 *   whose mode is Smart are drawn by VTK's ray caster for the CPU. It can draw images with one
 *   component at points. The property VolumeRenderingMode stays unchanged.
 * - Frames in motion that the client draws with that ray caster take 30 ms: the ray caster casts as
 *   many rays as the rest of the frame leaves time for. With the time that Qt needs to draw its
 *   window, that makes 20 frames a second. ParaView itself aims at 5.
 * - These frames are drawn without FXAA, which would take more time than everything else.
 * - Frames at rest take at most half a second while a device is armed. While the scene is touched,
 *   they are aborted within 0.2 s after a motion of the pointer, if its position is known; VTK does
 *   not check more often.
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
   * Restores the mode of the last view's volumes, and adjusts the volumes of another view. nullptr
   * stands for no view.
   */
  void SetView(vtkSMRenderViewProxy* view);
  /** Leaves the volumes unchanged, because nothing may be sent to a lost server. */
  void Forget() { this->Volumes.clear(); }
  /** Draws the view by InteractiveRender or StillRender. */
  void Draw(bool quickly, Touch touch);

  /**
   * Sets a function that returns the pointer's position on the screen, even if its motion events
   * are still in a queue outside VTK. nullptr means that the position is unknown.
   */
  using PointerQuery = void (*)(int position[2]);
  static void SetPointerQuery(PointerQuery query);

private:
  /**
   * A volume that this class draws with VTK's ray caster for the CPU instead of ParaView's choice.
   */
  struct Volume
  {
    vtkWeakPointer<vtkSMProxy> Representation;
    vtkWeakPointer<vtkSMProxy> Drawn; ///< the part of the representation that draws the volume
    unsigned long long SetTime;       ///< modification time of the property VolumeRenderingMode
  };
  /** The frame rate (Hz) that makes a frame of the ray caster take its allowed time. */
  struct Rate
  {
    double Hz;
    void Update(double time, double longest);
  };

  void ChooseRayCasters(Touch touch);
  /**
   * Returns whether the process that has the data, and thus draws the volumes, uses software
   * OpenGL.
   */
  bool IsOnProcessor();
  bool IsWindowOnProcessor();
  /** Returns whether this object sets the desired rate of the frame. */
  bool SetsRate() const { return this->CastsOnProcessor && (this->IsQuick || this->IsArmed); }
  void Begin();
  /** Restores FXAA, and the swap of buffers. */
  void GiveBack();
  void End();
  void Interrupt();

  vtkWeakPointer<vtkSMRenderViewProxy> View;
  vtkWeakPointer<vtkRenderWindow> Window;
  vtkNew<vtkCallbackCommand> Observer;
  std::vector<Volume> Volumes;
  /** Renderers whose FXAA is off during the frame. */
  std::vector<vtkWeakPointer<vtkRenderer>> Smoothed;
  ///@{
  /**
   * Whether OpenGL runs on the CPU: where the data are, and in the client's window. Empty if not
   * known yet.
   */
  std::optional<bool> OnProcessor;
  std::optional<bool> WindowOnProcessor;
  ///@}
  /** Whether a volume is drawn by the ray caster for the CPU. */
  bool CastsOnProcessor = false;
  bool IsDrawing = false;
  bool IsQuick = false;
  bool IsTouched = false;
  bool IsArmed = false;
  /** Whether the frame is not shown, so that the window keeps the last frame. */
  bool KeepsPicture = false;
  Rate InMotion{ 20.0 };
  Rate AtRest{ 2.0 };
  std::chrono::steady_clock::time_point Start;
  int Pointer[2] = { 0, 0 }; ///< position of the pointer at the start of the frame
};

} // namespace VolumeHaptics

#endif
