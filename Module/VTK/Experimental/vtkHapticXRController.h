// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticXRController
 * @brief   a controller of a headset leads the tip, and vibrates when the force changes
 *
 * Lets a controller of a headset lead the tip of a device. It renders vibration, not force:
 * contact, texture and friction that sticks and slips are felt, but a constant force is not.
 *
 *   device->Open("vibration:xr");
 *   device->SetVolumeHaptics(filter);
 *   controller->SetDevice(device);
 *   controller->SetInteractor(interactor); // a vtkOpenXRRenderWindowInteractor
 *   device->Start();
 *   device->Arm();
 *   interactor->Start();
 *
 * The interactor's Move3DEvent and Select3DEvent (or Button3DEvent) of the hand lead the tip, turn
 * the stylus and press its button. In each frame, at its RenderEvent, the device is updated
 * (vtkHapticDevice::UpdateState, as a headset's interactor has no timers) and the controller gets
 * the amplitude of vtkHapticVirtualHand::TakeVibration: at most every 10 ms, for 150 ms, and again
 * every 50 ms, so that it falls silent if the program stands still.
 *
 * The vibration needs a library that was built with VTK's module RenderingOpenXR
 * (VolumeHaptics_USE_OPENXR), and an action that is bound to the controller's motor, see
 * WriteActions. Without them, and with headsets that are used through other interactors, the tip is
 * led all the same, and UserEvent announces each new amplitude (GetAmplitude) to the program.
 *
 * @sa vtkHapticDevice, vtkHapticRepresentation
 */
#ifndef vtkHapticXRController_h
#define vtkHapticXRController_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkHapticDevice;
class vtkRenderWindowInteractor;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticXRController : public vtkObject
{
public:
  static vtkHapticXRController* New();
  vtkTypeMacro(vtkHapticXRController, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The device: "vibration:xr", or "virtual", which is led and does not vibrate. */
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}

  ///@{
  /**
   * Set the interactor of the headset's window. It is observed, and not kept alive; nullptr ends
   * the observation and silences the controller.
   */
  void SetInteractor(vtkRenderWindowInteractor* interactor);
  vtkRenderWindowInteractor* GetInteractor();
  ///@}

  enum HandType
  {
    LEFT = 0,
    RIGHT = 1
  };

  ///@{
  /** The hand whose controller leads the tip, LEFT or RIGHT (default). */
  vtkSetClampMacro(Hand, int, LEFT, RIGHT);
  vtkGetMacro(Hand, int);
  void SetHandToLeft() { this->SetHand(LEFT); }
  void SetHandToRight() { this->SetHand(RIGHT); }
  ///@}

  ///@{
  /**
   * How far the tip is in front of the controller (m), 0 to 1. Default 0.05. The interactor's
   * physical scale makes world units of it.
   */
  vtkSetClampMacro(Reach, double, 0.0, 1.0);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /** The action of the manifest by which controllers vibrate. Default "haptic", as VTK names it. */
  vtkSetMacro(ActionName, std::string);
  vtkGetMacro(ActionName, std::string);
  ///@}

  /**
   * Copy a manifest of actions, such as VTK's vtk_openxr_actions.json, and the bindings beside it
   * into a folder, and bind ActionName to the motors of both hands' controllers: the files of VTK
   * 9.2 to 9.7 have the action and bind it to nothing, so that nothing vibrates. Before the
   * interactor is initialized, give it the copy by its whole name (SetActionManifestFileName).
   * False, with an error, if a file can't be read or written.
   */
  bool WriteActions(const char* manifest, const char* folder);

  /** Get whether the interactor is there and can make controllers vibrate. */
  bool CanVibrate();

  /** Get the amplitude of the last vibration, 0 to 1. */
  vtkGetMacro(Amplitude, double);

protected:
  vtkHapticXRController();
  ~vtkHapticXRController() override;

  int Hand = RIGHT;
  double Reach = 0.05;
  std::string ActionName = "haptic";
  double Amplitude = 0.0;

private:
  vtkHapticXRController(const vtkHapticXRController&) = delete;
  void operator=(const vtkHapticXRController&) = delete;

  void Handle(unsigned long event, void* data);
  void UpdateInFrame();
  void Vibrate(double amplitude);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
