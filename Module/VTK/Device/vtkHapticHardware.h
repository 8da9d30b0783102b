// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticHardware
 * @brief   the devices that exist, and the settings for opening them
 *
 * Lists and configures haptic devices; the superclass of vtkHapticDevice. Most devices are reached
 * without vendors' libraries:
 *
 *   falcon[:N]         Novint Falcon, through libusb. 3 degrees of freedom in and out, 8 N. Needs
 *                      FirmwareFile after it was plugged in, and is homed by hand.
 *   wooden[:N]         WoodenHaptics, through hidapi. 3 in and out, 2.5 N. Calibrated by hand each
 *                      time it is opened. The Polhem is refused, since its geometry is different.
 *   pid[:VVVV:PPPP]    force-feedback wheels and sticks (HID usage page 0x0F), through hidapi, by
 *                      USB vendor and product (hexadecimal). Set NewtonsPerFullScale to their
 *                      force. Sticks of two axes are refused unless their firmware is known (an
 *                      OpenFFBoard with version 1.16.5 or later, ArduinoJoystickWithFFBLibrary):
 *                      firmwares disagree on the direction of the force along the second axis.
 *   haply[:ID]         Haply's Inverse3, Inverse3x and Minverse, through Haply's Inverse service,
 *                      which has to run. 3 in and out, 2 N; a VerseGrip adds orientation and
 *                      buttons. ID is the service's name of the device, such as 049D. The
 *                      environment variable VOLUMEHAPTICS_HAPLY names other ports, "10001,10020".
 *   spacemouse[:N]     3Dconnexion mice, through hidapi. They push the tip and turn the volume; no
 *                      force.
 *   vibration:pad[:N]  gamepads with rumble motors, on Linux; a DualSense also through hidapi.
 *                      Vibration, not force: the sticks move the tip, and the motors render how the
 *                      force changes.
 *   hfab[:PORT]        WoodenHaptics, Polhem and PHANToMs with an hfab controller, through a serial
 *                      port such as /dev/ttyACM0. 3 in (Polhem 6) and 3 out. Calibrated by hand
 *                      each time it is opened.
 *   vendor:PLUGIN[:N]  devices of a vendor's library, through a plug-in that you build against the
 *                      installed SDK: Force Dimension's (forcedimension) and 3D Systems'
 *                      (openhaptics) are in Examples/Vendor. See SetVendorPath.
 *
 * N counts from 0; without it, the first device is meant. None of this was verified on physical
 * hardware yet: it runs against emulated devices, which answer as public descriptions of the
 * protocols say. A program adds devices of its own with AddDeviceKind.
 *
 * If the program can't send zero force any more, for example after SIGKILL (see vtkHapticDevice),
 * only the watchdog of the device itself ends the force: WoodenHaptics ends it after half a second,
 * a wheel within a tenth of a second. No watchdog is known for the Falcon. On Linux a process of
 * its own, the program volumehaptics-guard, talks to the Falcon, and sends zero force within 50 ms
 * if this program is gone or stands still. Open fails if the guard can't be started. The
 * environment variable VOLUMEHAPTICS_GUARD names the guard if it is not near this library. Without
 * a guard, as on other systems, the Falcon may keep its last force until it is switched off: accept
 * this by UseGuardOff or VOLUMEHAPTICS_GUARD=off, otherwise Open fails.
 *
 * On Linux a user needs permission for the device. The installed udev rules,
 * 70-volume-haptics.rules, grant it to the user who is logged in at the computer. If they are
 * missing, the messages of ListDevices and Open contain the rule that is needed.
 */
#ifndef vtkHapticHardware_h
#define vtkHapticHardware_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <string> // for std::string

class vtkStringArray;
class vtkTable;

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
struct DeviceKind;
struct DeviceOptions;
} // namespace VolumeHaptics
#endif

class VTKVOLUMEHAPTICS_EXPORT vtkHapticHardware : public vtkObject
{
public:
  vtkTypeMacro(vtkHapticHardware, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The status of a device. */
  enum StatusType
  {
    CLOSED = 0,
    OPEN = 1,
    FIRMWARE = 2, ///< waits for its firmware
    HOMING = 3,   ///< waits for its encoders to be homed
    READY = 4,    ///< can be started, or runs unarmed
    ARMED = 5,    ///< armed; no force yet, because the servo does not run or gets no samples
    ACTIVE = 6,   ///< force flows
    FAULT = 7     ///< the force is off until the device is armed again, or the device is lost
  };

  ///@{
  /**
   * Get the ids that Open accepts now, "virtual" first; "replay:FILE" is not among them.
   * ListDevices overwrites a table with the columns Id, Name (maker, product, and where it is
   * plugged in), State: "available", "in use", or the obstacle and the cure; and Force: "calibrated
   * 0.83 on 2026-11-22" or "uncalibrated", empty for devices without force. Each call searches
   * again.
   */
  static vtkStringArray* EnumerateDevices();
  static void ListDevices(vtkTable* devices);
  ///@}

  /**
   * Overwrite a table with the kinds of devices that this computer can't use, whatever is plugged
   * in: the columns Kind, such as "vendor", and State, with the obstacle (a service that does not
   * run, a library that is not found) and the cure.
   */
  static void ListMissingKinds(vtkTable* kinds);

#ifndef __VTK_WRAP__
  /**
   * Register a kind of devices in this process: see DeviceKind.h, and Examples/Cxx/OwnDevice.cxx.
   * False, with an error, if the name is taken.
   */
  static bool AddDeviceKind(const VolumeHaptics::DeviceKind& kind);
#endif

  ///@{
  /**
   * The firmware image for a Novint Falcon that has none. It belongs to Novint and can't be
   * distributed with this library: it is the file that comes with their drivers. Default: the value
   * of the environment variable VOLUMEHAPTICS_FALCON_FIRMWARE, else none. Takes effect with Open.
   */
  void SetFirmwareFile(const std::string& file);
  std::string GetFirmwareFile() const
  {
    return this->FirmwareFile;
  }
  ///@}

  ///@{
  /**
   * The folders of plug-ins for vendors' libraries, vendor:PLUGIN[:N], separated by colons. No
   * plug-in is loaded that other users may write; the libraries that it needs are not checked.
   * Default: empty, which stands for the environment variable VOLUMEHAPTICS_VENDOR_PATH.
   * EnumerateDevices and ListDevices look by the variable only. Takes effect with Open.
   */
  void SetVendorPath(const std::string& path);
  std::string GetVendorPath() const
  {
    return this->VendorPath;
  }
  ///@}

  ///@{
  /**
   * How long (s) each step of homing by hand may take, 1 to 3600. Default 120. After that, Home()
   * begins again. Takes effect with Open.
   */
  vtkSetClampMacro(HomingTime, double, 1.0, 3600.0);
  vtkGetMacro(HomingTime, double);
  ///@}

  ///@{
  /**
   * The force (N) of a force-feedback device at full scale, -100 to 100, along its axes x and y. A
   * second number of 0 says that only the first axis has a motor, as that of a wheel: then the tip
   * moves along x only, and pedals do not move it. Wheels often have a descriptor of two axes.
   * No device reports its force: measure it with a spring scale. A negative number reverses the
   * direction; a first number of 0 gives no force. Firmwares differ in the direction, so try it
   * gently first (volumehaptics-device test): if the wall pulls the hand in, give a negative
   * number. A number that is too small gives too much force. Default 100, more than nearly all
   * devices have, so that none pushes harder than was asked for; weaker ones are hardly felt until
   * this is set. Takes effect with Open.
   */
  void SetNewtonsPerFullScale(double x, double y);
  void SetNewtonsPerFullScale(const double newtons[2]) VTK_SIZEHINT(2);
  vtkGetVector2Macro(NewtonsPerFullScale, double);
  ///@}

  ///@{
  /**
   * Whether a guard, a process of its own, talks to a device that has no watchdog: the Falcon, and
   * a DualSense through hidapi. Default: on. Open fails if there is no guard, as on systems other
   * than Linux. Without it, the Falcon may keep its last force, and a DualSense its vibration, if
   * this program is killed or stopped: keep the power switch within reach. VOLUMEHAPTICS_GUARD=off
   * in the environment also turns it off. Takes effect with Open.
   */
  vtkSetMacro(UseGuard, bool);
  vtkGetMacro(UseGuard, bool);
  vtkBooleanMacro(UseGuard, bool);
  ///@}

protected:
  vtkHapticHardware();
  ~vtkHapticHardware() override = default;

#ifndef __VTK_WRAP__
  VolumeHaptics::DeviceOptions MakeOptions() const;
#endif

  std::string FirmwareFile;
  std::string VendorPath;
  double HomingTime = 120.0;
  bool UseGuard = true;
  double NewtonsPerFullScale[2] = { 100.0, 100.0 };

private:
  vtkHapticHardware(const vtkHapticHardware&) = delete;
  void operator=(const vtkHapticHardware&) = delete;
};

#endif
