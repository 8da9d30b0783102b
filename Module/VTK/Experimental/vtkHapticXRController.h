// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticXRController
 * @brief   lets a headset's controller move the tip and vibrate when the force changes
 *
 * Lets a controller of a headset move the tip of a device. The controller vibrates instead of
 * exerting a force, so the hand feels contact, texture and stick-slip friction, but not a constant
 * force.
 *
 *   device->Open("vibration:xr");
 *   device->SetVolumeHaptics(filter);
 *   controller->SetDevice(device);
 *   controller->SetInteractor(interactor); // a vtkOpenXRRenderWindowInteractor
 *   device->Start();
 *   device->Arm();
 *   interactor->Start();
 *
 * The interactor's Move3DEvent and Select3DEvent (or Button3DEvent) of the hand move the tip, turn
 * the stylus and press its button. In each frame, at its RenderEvent, the device is updated
 * (vtkHapticDevice::UpdateState), because a headset's interactor has no timers. The controller also
 * gets the amplitude of vtkHapticVirtualHand::TakeVibration, at most every 10 ms. A vibration lasts
 * 150 ms and is repeated every 50 ms, so that it ends soon if the program hangs.
 *
 * The vibration needs a library that was built with VTK's module RenderingOpenXR
 * (VolumeHaptics_USE_OPENXR), and an action that is bound to the controller's motor: see
 * WriteActions. Without them, or with another interactor, the controller still moves the tip, and
 * UserEvent announces each new amplitude (GetAmplitude) to the program.
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
  /**
   * The device to move. Open it as "vibration:xr", or as "virtual", which has a tip but does not
   * vibrate.
   */
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}

  ///@{
  /**
   * Set the interactor of the headset's window. It is observed without a reference, so it may be
   * deleted. nullptr ends the observation and the vibration.
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
  /** The hand whose controller moves the tip, LEFT or RIGHT (default). */
  vtkSetClampMacro(Hand, int, LEFT, RIGHT);
  vtkGetMacro(Hand, int);
  void SetHandToLeft() { this->SetHand(LEFT); }
  void SetHandToRight() { this->SetHand(RIGHT); }
  ///@}

  ///@{
  /**
   * The distance of the tip in front of the controller (m), 0 to 1. Default 0.05. The interactor's
   * physical scale converts it to world units.
   */
  vtkSetClampMacro(Reach, double, 0.0, 1.0);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /**
   * The action in the manifest that makes controllers vibrate. Default "haptic", as in VTK's
   * manifest.
   */
  vtkSetMacro(ActionName, std::string);
  vtkGetMacro(ActionName, std::string);
  ///@}

  /**
   * Copy a manifest of actions, such as VTK's vtk_openxr_actions.json, and the bindings beside it
   * into a folder, and bind ActionName to the motors of both hands' controllers. Without this,
   * controllers don't vibrate: the files of VTK 9.2 to 9.7 have the action but bind it to nothing.
   * Before the interactor is initialized, pass the full name of the copy to its
   * SetActionManifestFileName. Returns false and reports an error if a file can't be read or
   * written.
   */
  bool WriteActions(const char* manifest, const char* folder);

  /** Get whether the interactor is set and can make controllers vibrate. */
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
