// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticVirtualHand
 * @brief   a virtual hand that the program moves
 *
 * Moves the tip of a device without hardware, and makes up for what a real device lacks: turns the
 * tool of a device that measures no orientation, and lets a burr spin without a button.
 *
 *   device->Open("virtual");
 *   vtkHapticVirtualHand* hand = device->GetVirtualHand();
 *   hand->Place(0.0, 0.0, 50.0);             // where the hand takes the stylus up
 *   device->Start();
 *   device->Arm();
 *   ... in the GUI's timer ...
 *   hand->SetPosition(world);                // where the mouse is
 *   device->UpdateState();
 *
 * @sa vtkHapticDevice
 */
#ifndef vtkHapticVirtualHand_h
#define vtkHapticVirtualHand_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
class VirtualDevice;
struct DeviceParts;
} // namespace VolumeHaptics
#endif

class VTKVOLUMEHAPTICS_EXPORT vtkHapticVirtualHand : public vtkObject
{
public:
  static vtkHapticVirtualHand* New();
  vtkTypeMacro(vtkHapticVirtualHand, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The position to which the hand moves the tip of the virtual device (world). Without simulated
   * dynamics, the tip moves there at no more than GetSpeed; the first call places it there at once.
   * Place does so at any time: the hand lets the stylus go and holds it again at the new position,
   * so it feels nothing on the way. Disarm before Place: an armed device would detect a hand that
   * moves too fast.
   */
  void SetPosition(double x, double y, double z);
  void SetPosition(const double x[3]) VTK_SIZEHINT(3);
  void Place(double x, double y, double z);
  ///@}

  /**
   * Return whether the mouse of a window may move the tip of the open device: the device "virtual",
   * and devices that vibrate but have no position, such as "vibration:bhaptics".
   */
  bool MayMouseLead();

  /** Get the speed of the tip without simulated dynamics: 2 m/s. */
  static double GetSpeed();

  /** The buttons that the hand presses on the virtual device: bit 0 is the main button. */
  void SetButtons(int buttons);

  ///@{
  /**
   * The orientation of the virtual device's stylus (world): a quaternion w, x, y, z of any norm,
   * see vtkHapticState::GetTipOrientation. Before the first call, and after four zeros, it has no
   * orientation.
   */
  void SetOrientation(double w, double x, double y, double z);
  void SetOrientation(const double wxyz[4]) VTK_SIZEHINT(4);
  ///@}

  /**
   * The orientation of the tool in the hand (world), for a device that measures none, such as one
   * with three degrees of freedom: a quaternion w, x, y, z of any norm. The tool turns to this
   * orientation at 4 rad/s at most, and then turns with the device's placement, as a stylus does.
   * Before the first call, and after four zeros, there is no orientation. It applies to later
   * servos, too.
   */
  void SetToolOrientation(double w, double x, double y, double z);

  ///@{
  /**
   * Whether a vtkHapticBurr spins without its SpinButton while the device is armed, for this and
   * later servos. Default: off.
   */
  void SetSpinning(bool spinning);
  bool GetSpinning();
  vtkBooleanMacro(Spinning, bool);
  ///@}

  /**
   * Get how strongly the device "vibration:xr" should vibrate: the largest amplitude since the last
   * call, 0 to 1. The program moves the tip as it moves the virtual device's tip, and makes the
   * controller in the hand vibrate; call this once per rendered frame. vtkHapticXRController does
   * both for the controllers of a headset. 0 for other devices, and while the servo stands still.
   */
  double TakeVibration();

  /**
   * Simulate the virtual device and the hand that holds it: m x'' = f + handStiffness (lead - x) -
   * damping x' with mass in kg (0, the default: no dynamics), damping in N s/m and the hand's
   * stiffness in N/m. Positions are rounded to an encoder's quantum (m; 0: no rounding), and forces
   * are delayed by ticks (0 to 16). Call this before Start.
   */
  void SetDynamics(
    double mass, double damping, double handStiffness, double encoderQuantum, int forceDelay);

  /**
   * Give the virtual device the limits of another device: the largest force (N), stiffness (N/m)
   * and damping (N s/m), 0: not limited; and the friction b of the device itself (N s/m), with
   * which a spring is stable up to the stiffness 2 b / period, 0: not limited. Default: 20 N, the
   * others 0. A Novint Falcon is (8, 3000, 20, 0). Sets MaximumForce to half of the force, as Open
   * does. Call this before Start.
   */
  void SetLimits(
    double maximumForce, double maximumStiffness, double maximumDamping, double friction);

protected:
  vtkHapticVirtualHand() = default;
  ~vtkHapticVirtualHand() override = default;

private:
#ifndef __VTK_WRAP__
  friend struct VolumeHaptics::DeviceParts;

  /** Returns the parts of the device. Without a device, reports an error and returns null. */
  VolumeHaptics::DeviceParts* GetParts();
  /**
   * Returns the open device if the program moves its tip; otherwise reports an error and returns
   * null.
   */
  VolumeHaptics::VirtualDevice* FindLed(double x, double y, double z);

  VolumeHaptics::DeviceParts* Parts = nullptr; // null without a device
#endif

  vtkHapticVirtualHand(const vtkHapticVirtualHand&) = delete;
  void operator=(const vtkHapticVirtualHand&) = delete;
};

#endif
