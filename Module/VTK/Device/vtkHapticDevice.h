// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticDevice
 * @brief   a haptic device, and the servo loop that lets a hand feel a volume with it
 *
 * Opens a haptic device and lets a hand feel the volume of a vtkVolumeHapticsFilter with it. A
 * thread of its own computes the force 1000 times a second:
 *
 *   device->Open("virtual");
 *   device->SetVolumeHaptics(filter);
 *   device->Start();                  // ticks; the proxy moves, no force yet
 *   device->Arm();                    // force rises over half a second
 *   ... in the GUI's timer ...
 *   device->UpdateState();            // then render with device->GetState()->GetProxyPosition()
 *   ...
 *   device->Stop();                   // zero force, thread joined
 *
 * Positions are in world units and forces in newtons along the world's axes, unless stated.
 *
 * **Devices.** "virtual" has no hardware: the program moves its tip through GetVirtualHand.
 * "vibration:xr" is moved in the same way, and returns how strongly to vibrate: see
 * vtkHapticVirtualHand::TakeVibration. "replay:FILE" plays back a recording (.vtp or .csv), tick by
 * tick. Open lists the real devices, most of which need no vendor's library. None of them was
 * verified on physical hardware yet: the drivers run against emulated devices, which answer as
 * public descriptions of the protocols say. A program adds devices of its own with AddDeviceKind.
 *
 * **Threads.** The servo ticks at ServoRate with exactly the code that vtkVolumeHapticsFilter runs
 * offline. It never waits: it neither locks, allocates nor calls a vtkObject. The thread that owns
 * this object (the GUI thread) hands it immutable snapshots of the filter with Publish, and copies
 * the latest state with UpdateState. The servo and work in the background read the image's own
 * array, without a copy: give the image a new array instead of resizing or refilling one that is
 * being touched. Call Modified() after changing values in place; background work on them then
 * begins again. If a vtkHapticRegionSource is on port 0 of the filter, UpdateState makes it read
 * the region around the tip, and publishes each region when it is there.
 *
 * **Two hands.** Several devices may have the same filter. Each has its own servo, proxy, gate and
 * recording, and its force is the one that it would have alone; the samples and the baked tables
 * are shared. One hand may hold the tool of the filter: SetUseTool.
 *
 * **Safety.** No force leaves before Arm. Every force is checked for NaN, clamped to MaximumForce
 * and to the device's own maximum, and grows by at most MaximumForceRate; after Arm and after every
 * gap it rises from zero over half a second, and the proxy begins at the tip. Stiffness and
 * ForceFieldDamping are capped at what the device can hold. Unless StiffnessGain is above 1, none
 * of this gives the hand more energy than the hand put in: a wall that is pressed while the force
 * rises, or struck too fast for MaximumForceRate, stays soft until the tip leaves it or presses
 * deeper.
 *
 * The force is cut, and a fault is latched until Arm is called again, if the tip is not finite, if
 * it moves faster than a hand can hold the device, or if the device is lost. Without fresh samples
 * for 30 ms the force goes to zero.
 *
 * The force is off while the owner's thread is busy with long work: see BeginLongWork, which
 * Publish and vtkHapticRecorder::Stop call by themselves where they need it. If the program does
 * not call the device for 2 s without having announced such work, the force fades and stays off
 * until Arm is called again: see SetAttentionTime.
 *
 * Stop, Close, deletion, exit(), quick_exit(), an uncaught exception, a crash and the other signals
 * that end or stop the process send zero force. Signal handlers that the program installed before
 * Arm run after the force is zero; handlers installed later run first. A program can't send zero
 * force on SIGKILL, SIGSTOP, real-time signals, _exit(), exec() of another program, loss of power,
 * a crash in the thread that talks to the device, a crash that leaves the heap locked if the
 * device's library needs it, or a stack overflow in a thread other than the owner's. Then the
 * device's own watchdog ends the force: that of WoodenHaptics after half a second, that of a wheel
 * within a tenth of a second. No watchdog is known for the Falcon, so a guard process talks to it:
 * see SetUseGuard.
 *
 * @sa vtkVolumeHapticsFilter, vtkHapticState, vtkHapticPlayback, vtkHapticRecorder,
 * vtkHapticVirtualHand, vtkHapticRegionSource
 */
#ifndef vtkHapticDevice_h
#define vtkHapticDevice_h

#include "vtkHapticPlayback.h"    // for GetPlayback
#include "vtkHapticRecorder.h"    // for GetRecorder
#include "vtkHapticState.h"       // for GetState
#include "vtkHapticVirtualHand.h" // for GetVirtualHand
#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkMatrix4x4;
class vtkPoints;
class vtkStringArray;
class vtkTable;
class vtkVolumeHapticsFilter;

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
struct DeviceKind;
struct DeviceOptions;
struct DeviceParts;
} // namespace VolumeHaptics
#endif

class VTKVOLUMEHAPTICS_EXPORT vtkHapticDevice : public vtkObject
{
public:
  static vtkHapticDevice* New();
  vtkTypeMacro(vtkHapticDevice, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Status of a device, as GetStatus returns it. */
  enum StatusType
  {
    CLOSED = 0,
    OPEN = 1,
    FIRMWARE = 2, ///< waits for its firmware to be loaded
    HOMING = 3,   ///< waits for its encoders to be homed
    READY = 4,    ///< can be started, or runs but is not armed
    ARMED = 5,    ///< armed, but without force yet, because the servo does not run or gets no
                  ///< samples
    ACTIVE = 6,   ///< armed, with force
    FAULT = 7     ///< the force is off until the device is armed again, or the device is lost
  };

  ///@{
  /**
   * Get the ids that Open accepts now, "virtual" first; "replay:FILE" is not among them.
   * ListDevices overwrites a table with the columns Id, Name (maker, product, and where it is
   * plugged in), State: "available", "in use", or the obstacle and the cure; and Force: "calibrated
   * 0.83 on 2026-11-22" or "uncalibrated", empty for devices without force. Each call searches for
   * devices again.
   */
  static vtkStringArray* EnumerateDevices();
  static void ListDevices(vtkTable* devices);
  ///@}

  /**
   * Overwrite a table with the kinds of devices that this computer can't use, even if one is
   * plugged in. Its columns are Kind, such as "vendor", and State: the obstacle (such as a stopped
   * service or a missing library) and the cure.
   */
  static void ListMissingKinds(vtkTable* kinds);

#ifndef __VTK_WRAP__
  /**
   * Register a new kind of device in this process: see DeviceKind.h, and
   * Examples/Cxx/OwnDevice.cxx. Returns false and reports an error if the name is taken.
   */
  static bool AddDeviceKind(const VolumeHaptics::DeviceKind& kind);
#endif

  /**
   * Open a device by its id, after closing the device that was open. On failure, returns false and
   * reports an error with the cure. The ids are "virtual", "vibration:xr", "replay:FILE", those of
   * AddDeviceKind, and
   *
   *   falcon[:N]         Novint Falcon, through libusb. 3 degrees of freedom in and out, 8 N. Needs
   *                      FirmwareFile after it was plugged in, and is homed by hand.
   *   wooden[:N]         WoodenHaptics, through hidapi. 3 in and out, 2.5 N. Calibrated by hand
   *                      each time it is opened. The Polhem is refused, since its geometry is
   *                      different.
   *   pid[:VVVV:PPPP]    force-feedback wheels and sticks (HID usage page 0x0F), through hidapi, by
   *                      USB vendor and product (hexadecimal). Set NewtonsPerFullScale to their
   *                      force. Sticks of two axes are refused unless their firmware is known (an
   *                      OpenFFBoard with version 1.16.5 or later, ArduinoJoystickWithFFBLibrary):
   *                      firmwares disagree on the direction of the force along the second axis.
   *   wheel[:N]          wheels that are not of this usage page, such as Logitech's, through their
   *                      drivers in Linux. 1 in and out. Set NewtonsPerFullScale to their force.
   *   haply[:ID]         Haply's Inverse3, Inverse3x and Minverse, through Haply's Inverse service,
   *                      which has to run. 3 in and out, 2 N; a VerseGrip adds orientation and
   *                      buttons. ID is the service's name of the device, such as 049D. The
   *                      environment variable VOLUMEHAPTICS_HAPLY names other ports, "10001,10020".
   *   spacemouse[:N]     3Dconnexion mice, through hidapi. They push the tip and turn the volume;
   *                      no force.
   *   vibration:pad[:N]  gamepads with rumble motors, on Linux; a DualSense also through hidapi.
   *                      Vibration, not force: the sticks move the tip, and the motors render how
   *                      the force changes.
   *   vibration:bhaptics[:PLACE], vibration:weart[:HAND], vibration:hapbeat:ADDRESS
   *                      bHaptics' gloves, sleeves and vests, WEART's TouchDIVER, a Hapbeat,
   *                      through their services or by UDP. Vibration, not force: the mouse or
   *                      GetVirtualHand leads the tip.
   *   hfab[:PORT]        WoodenHaptics, Polhem and PHANToMs with an hfab controller, through a
   *                      serial port such as /dev/ttyACM0. 3 in (Polhem 6) and 3 out. Calibrated by
   *                      hand each time it is opened.
   *   vendor:PLUGIN[:N]  devices of a vendor's library, through a plug-in that you build against
   *                      the installed SDK: Force Dimension's (forcedimension) and 3D Systems'
   *                      (openhaptics) are in Examples/Vendor. See SetVendorPath.
   *
   * N counts from 0; without it, the first device is meant.
   *
   * On Linux a user needs permission for the device. The installed udev rules,
   * 70-volume-haptics.rules, grant it to the user who is logged in at the computer. If they are
   * missing, the messages of ListDevices and Open contain the rule that is needed.
   *
   * A real device that is not homed opens at once and waits for the hand, as GetStatusText says;
   * Arm is refused until it is ready. When it is unplugged, stops answering, loses its zero, or the
   * computer was asleep, the force is cut and stays off until the user calls Home() or Open(), and
   * then Arm().
   */
  bool Open(const char* id);
  /** Stop the servo and release the device. */
  void Close();
  bool IsOpen();
  std::string GetDeviceId(); ///< Get the id that was passed to Open; empty while closed.

  ///@{
  /**
   * The filter whose volume is felt, kept by reference. The servo never accesses the filter itself.
   * Takes effect with Publish or Start.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* GetVolumeHaptics();
  ///@}

  /**
   * Get the name of the felt method as users see it, such as "Proxy, PRECISE": the method of the
   * last Publish, or the filter's method while the servo is stopped; empty without a filter.
   */
  std::string GetMethodText();

  /**
   * Update the filter's image and send the servo a snapshot of the image, materials, settings and
   * DeviceToWorld. The servo uses it from the next tick on; if the force becomes larger, it grows
   * at MaximumForceRate. If the servo is stopped, Publish only checks the input. Returns false and
   * reports an error if the input can't be touched; the servo then keeps the last snapshot.
   *
   * Four kinds of work are done in the background first: measuring the distances to forbidden
   * labels of a large label image, refining a label image with thick slices, meshing a large
   * surface of SURFACE_PROXY, and spreading the points of a vtkHapticPointShell. Publish and Start
   * then return true at once, and UpdateState publishes when the work is done; see IsPublished.
   * While a mesh is made, UpdateState publishes the isosurface around the tip, whose force fades
   * where the tip leaves it before the next part is there (vtkHapticState::GetResidency). It does
   * not do so while a recording is under way.
   */
  bool Publish();
  /**
   * Returns whether Publish or Start was called, successfully or not, since the last change of the
   * filter, image or surface.
   */
  bool IsPublished();

  ///@{
  /**
   * Maps the device's space (m) to the world: a rotation, a translation and one uniform, positive
   * scale. Takes effect with Publish. nullptr (default): the world scaled by the filter's
   * MetersPerWorldUnit.
   */
  void SetDeviceToWorld(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetDeviceToWorld();
  ///@}

  /**
   * Set DeviceToWorld from three or more points that the stylus touched and whose positions in the
   * world are known, such as marks on the display, so that the hand feels an object where the eye
   * sees it:
   *
   *   touched->InsertNextPoint(device->GetState()->GetTipPosition()); // in m: see below
   *   known->InsertNextPoint(mark);
   *   ... two or more others ...
   *   const double worst = device->FitDeviceToWorld(touched, known);
   *   device->Publish();
   *
   * The matrix is a rotation, a translation and one uniform scale, by least squares, and never a
   * mirror. A `scale` above 0 (world units per metre) is kept: only a rigid motion is computed. The
   * points have to span a triangle whose height is at least 1 % of its longest side. Positions of
   * the device are in its space (m): those of GetTipPosition() while DeviceToWorld is the identity.
   *
   * Returns the largest distance (world units) between a known position and a touched one; if it is
   * large, a point was touched badly. Returns -1, with an error and no change, for points that do
   * not determine the placement.
   */
  double FitDeviceToWorld(vtkPoints* touched, vtkPoints* known, double scale = 0.0);

  ///@{
  /** Ticks per second (Hz), 100 to 10000. Default 1000. Takes effect with Start. */
  void SetServoRate(double rate);
  vtkGetMacro(ServoRate, double);
  ///@}

  ///@{
  /**
   * Start the servo with the filter's present state, and stop it with zero force. Without a filter,
   * the tip moves without touching anything. Start returns false and reports an error if no device
   * is open, if the filter can't be touched, or if the system provides no more memory, threads or
   * files: without them, a crash would leave the force on.
   */
  bool Start();
  void Stop();
  bool IsRunning();
  ///@}

  ///@{
  /**
   * Let force through, or cut it. Arm clears a fault, changes nothing if force flows already, and
   * is refused, with an error, while the device is not ready. The proxy begins at the tip: armed
   * inside, a hand feels nothing until it moves. Disarm cuts the force at once. FadeOut ends it
   * within 50 ms, for example when the connection to the server that sends the data is lost. Stop
   * disarms. Every way to disarm invokes vtkCommand::DisableEvent at once. IsArmOrdered returns
   * whether Arm was the last of these orders, even if the servo has not received it yet, the clutch
   * delays it, or a fault (GetStatus) keeps the force off.
   */
  void Arm();
  void Disarm();
  void FadeOut();
  bool IsArmOrdered();
  ///@}

  ///@{
  /**
   * Call these before and after work that keeps the owner's thread busy, such as computing a mesh.
   * BeginLongWork fades the force out within 50 ms, waits for that, and invokes
   * vtkCommand::StartEvent. Until EndLongWork, GetStatusText says "Force is off while" and the
   * given words, such as "the surface is meshed" (nullptr: "the program works"), and AttentionTime
   * does not count. EndLongWork invokes vtkCommand::EndEvent, and the force rises over half a
   * second, with the proxy on the tip at first, unless the device was disarmed during the work or
   * has a fault. Arm during the work takes effect after it. Pairs nest: the force comes back with
   * the last EndLongWork, and stays off if that call is missing.
   *
   * If expectedSeconds (s; by default the work is long) is below 0.25 and below an eighth of
   * AttentionTime (unless that is 0), the force stays on: fading would disturb more than so short a
   * pause, and the factor of eight allows for a slow computer. Publish calls these functions by
   * itself for a large mesh that can't be made in the background, because its array has a memory
   * layout of its own. vtkHapticRecorder calls them to write a long recording. If the pipeline
   * before the filter takes seconds, the application has to call them.
   */
  void BeginLongWork(const char* what, double expectedSeconds = VTK_DOUBLE_MAX);
  void EndLongWork();
  ///@}

  ///@{
  /**
   * A clutch, which lets the hand move a real device without moving the tip. While it is on, no
   * force leaves, from the next tick on; turning it on invokes vtkCommand::DisableEvent. Turning it
   * off arms the device again, as Arm does, if it was armed before and nothing has disarmed it
   * since: ArmsAfterClutch. An Arm while the clutch is on takes effect when it is turned off.
   * Default off.
   */
  void SetClutch(bool on);
  bool GetClutch();
  bool ArmsAfterClutch();
  ///@}

  /** Disarm, and search again for the zero of a real device's encoders, with the hand's help. */
  void Home();

  /**
   * Set the lights of a real device until Close, as a sum of bits: 1 green, 2 blue and 4 red on a
   * Falcon; 1 on a SpaceMouse. Below zero (default) the lights show the status of the device.
   */
  void SetLights(int lights);

  ///@{
  /**
   * Get whether the signs of the open device are confirmed, or need no confirmation. A real device
   * that gives force may push the wrong way, if its wiring or a setting differs from what was
   * assumed. So its first Arm pushes the hand gently along each of its axes, for about ten seconds,
   * and the tip has to move with the force: hold the device loosely in the middle of its workspace
   * and keep the hand still. Nothing else is felt during these pushes. A wrong sign is a fault
   * (GetStatusText names the axis). If the signs are right, the user's file of devices remembers
   * them by the device's serial number or port: volumehaptics/devices.txt in $XDG_CONFIG_HOME,
   * ~/.config or %APPDATA%, or the file that the environment variable VOLUMEHAPTICS_DEVICES names.
   * ForgetConfirmation, before Start, makes the next Arm confirm the signs again.
   */
  bool GetSignsConfirmed();
  void ForgetConfirmation();
  ///@}

  /**
   * Get whether the user's file of devices has an entry for the open device. Returns false for a
   * device that reports neither a serial number nor its port, because it can't be distinguished
   * from others: its confirmation and its calibration then hold until Close. Also false for a
   * device that gives no force.
   */
  bool IsRemembered();

  ///@{
  /**
   * Get the ratio of the open device's real force to the commanded force, as CalibrateForce has
   * stored it (see IsRemembered); 1 if it was never calibrated. Forces and limits of a calibrated
   * device are true newtons; MaximumForce never exceeds what its driver allows. CalibrateForce
   * accepts 0.1 to 10 while the servo does not run; otherwise it returns false and reports an
   * error. The text is "calibrated 0.83 on 2026-11-22", "uncalibrated", or empty if the device
   * gives no force or none is open. None of this was tried on hardware.
   */
  bool CalibrateForce(double scale);
  double GetForceScale();
  std::string GetCalibrationText();
  ///@}

  ///@{
  /**
   * GetStatus returns the StatusType of the device as of the last UpdateState. GetStatusText
   * returns a description in words, with the cure after a fault.
   */
  int GetStatus();
  std::string GetStatusText();
  ///@}

  /**
   * Copy the latest state from the servo to GetState. Returns true if it is new. Call this on each
   * tick of the GUI's timer: it also publishes models that were prepared in the background, reads
   * regions and time steps ahead, and reports faults.
   */
  bool UpdateState();

  ///@{
  /**
   * Get the parts of this device: its latest state, the player of a moving volume, the recorder of
   * its ticks, and the hand that moves the virtual device. They remain valid for the lifetime of
   * the device.
   */
  vtkHapticState* GetState();
  vtkHapticPlayback* GetPlayback();
  vtkHapticRecorder* GetRecorder();
  vtkHapticVirtualHand* GetVirtualHand();
  ///@}

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
   * The folders of the plug-ins for vendors' libraries, which devices vendor:PLUGIN[:N] use:
   * absolute paths, separated by `:`, on Windows by `;`. A plug-in is not loaded if other users may
   * write its file; the libraries that it needs are not checked. Default: empty, which stands for
   * the environment variable VOLUMEHAPTICS_VENDOR_PATH. EnumerateDevices and ListDevices search
   * only the variable's folders. Takes effect with Open.
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
   * second number of 0 means that only the first axis has a motor, as on a wheel: then the tip
   * moves along x only, and pedals do not move it. Wheels often have a descriptor of two axes. No
   * device reports its force: measure it with a spring scale. A negative number reverses the
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
   * Whether a guard, a process of its own, talks to a device that has no watchdog: the Falcon, a
   * DualSense through hidapi, and WEART's middleware. Default: on. Open fails if there is no guard,
   * as on systems other than Linux. Without it, the Falcon may keep its last force, and a DualSense
   * or a TouchDIVER its vibration, if this program is killed or stopped: keep the power switch
   * within reach. VOLUMEHAPTICS_GUARD=off in the environment also turns it off. Takes effect with
   * Open.
   *
   * The guard is the program volumehaptics-guard. It sends zero force within 50 ms if this program
   * is gone or stands still. The environment variable VOLUMEHAPTICS_GUARD names it if it is not
   * near this library.
   */
  vtkSetMacro(UseGuard, bool);
  vtkGetMacro(UseGuard, bool);
  vtkBooleanMacro(UseGuard, bool);
  ///@}

  ///@{
  /**
   * Whether the hand holds the tool of the filter. Default: on. Off: it feels with a point, while
   * the hand of another device holds the tool, and feels what that tool removes. Takes effect with
   * Publish or Start. A hand without the filter's tool can't be recorded.
   */
  void SetUseTool(bool on);
  vtkGetMacro(UseTool, bool);
  vtkBooleanMacro(UseTool, bool);
  ///@}

  ///@{
  /**
   * The largest force (N) on the hand, at most the device's own maximum. The default is set
   * whenever a device is opened: half of the device's own maximum, or the force that it gives for
   * any time if that is less. ResetMaximumForce returns to it.
   */
  void SetMaximumForce(double force);
  void ResetMaximumForce();
  vtkGetMacro(MaximumForce, double);
  ///@}

  ///@{
  /**
   * The largest torque (N m) on the hand, at most the device's own maximum. The default, half of
   * the device's own maximum, is set whenever a device is opened; ResetMaximumTorque returns to it.
   * The torque grows by at most 20 N m/s, and is sent only while force may flow.
   */
  void SetMaximumTorque(double torque);
  void ResetMaximumTorque();
  vtkGetMacro(MaximumTorque, double);
  ///@}

  ///@{
  /**
   * The fastest growth of the force (N/s), 1 or more. Default 500. Only growth is limited: the
   * force decreases and turns at once, because a limit there would push the hand off a stiff wall
   * with more energy than the hand put in. For the same reason, a wall that is hit so fast that its
   * force is limited stays softer until the tip leaves it or presses deeper.
   */
  void SetMaximumForceRate(double rate);
  vtkGetMacro(MaximumForceRate, double);
  ///@}

  ///@{
  /**
   * Factor, 1 (off) to 8, by which a wall may be stiffer than the loop holds by itself. Default 1.
   * The cap of GetStiffnessCap is multiplied by it, once the round trip is measured and nothing is
   * felt. What is above the cap is damped and paid from an account of the energy that the hand has
   * put in. By this account, the wall gives at most 1 mJ more than it got, and is as soft as
   * without the gain when the account is empty. The account does not see swings within one step of
   * the encoders: the device's dry friction must be at least half of the stiffness times such a
   * step, or else the wall buzzes. Walls that are hit fast need a larger MaximumForceRate. See
   * Documentation/method.md.
   */
  void SetStiffnessGain(double gain);
  vtkGetMacro(StiffnessGain, double);
  ///@}

  ///@{
  /**
   * Fraction, 0 (off) to 1, of an arm's momentum that a pulse takes away at touch-down. Default 0.
   * The pulse rings for some ten milliseconds, the faster the harder the material, so that surfaces
   * of one stiffness feel different; vibrating devices play it, too. It never gives the hand more
   * energy than it took. A fast tap needs a larger MaximumForceRate. See Documentation/method.md.
   */
  void SetTransientGain(double gain);
  vtkGetMacro(TransientGain, double);
  ///@}

  ///@{
  /**
   * How long (s) an armed device keeps its force if the program hangs: a window that hangs can't
   * stop the device. If for that long the program calls none of UpdateState, vtkHapticState::Drain,
   * Publish and Arm, and sets no limit, the servo fades the force out, and a fault holds until Arm.
   * 0.05 or more, default 2; 0 turns it off, for programs that call the device rarely. Work between
   * BeginLongWork and EndLongWork does not count.
   */
  void SetAttentionTime(double seconds);
  vtkGetMacro(AttentionTime, double);
  ///@}

  ///@{
  /**
   * Get the servo's timing statistics since Start or ResetStatistics. GetTickRate: ticks per
   * second. GetTickPercentile, GetWakePercentile: the time (s) that p percent (0 to 100) of the
   * ticks, or of the delays of wake-ups, do not exceed, accurate to 1/8. GetMissedTicks: ticks that
   * were left out because the loop was late. GetAbsentTicks: ticks whose force was reduced because
   * data around the tip were missing (vtkHapticState::GetResidency). GetUnfinishedTicks: ticks that
   * the solver PRECISE could not finish, because the tip jumped by tens of voxels, and that the
   * next ticks finished.
   */
  double GetTickRate();
  double GetTickPercentile(double p);
  double GetWakePercentile(double p);
  vtkIdType GetMissedTicks();
  vtkIdType GetAbsentTicks();
  vtkIdType GetUnfinishedTicks();
  void ResetStatistics();
  ///@}

  ///@{
  /**
   * Get the timing of the device, measured over about the last second: the time (s) from one
   * changed report to the next, and the round trip T (s), which is that time plus twice the time
   * that a force needs to reach the device; 95 % of both are shorter. 0 while they are unknown or
   * the servo is stopped. T caps the stiffness (N/m), k <= StiffnessGain 2 b / T with the device's
   * friction b, and the damping (N s/m). UpdateState adapts the caps to T: it publishes lower caps
   * at once if T has grown by a fifth, and higher ones 2 s later and while nothing is felt. The
   * caps are the felt ones, which include MaximumStiffness of the filter; 0 does not cap.
   */
  double GetReportPeriod();
  double GetRoundTripTime();
  double GetStiffnessCap();
  double GetDampingCap();
  ///@}

protected:
  vtkHapticDevice();
  ~vtkHapticDevice() override;

  std::string FirmwareFile;
  std::string VendorPath;
  double HomingTime = 120.0;
  bool UseGuard = true;
  bool UseTool = true;
  double NewtonsPerFullScale[2] = { 100.0, 100.0 };
  double ServoRate = 1000.0;
  double MaximumForce = 0.0;
  double MaximumForceRate = 500.0;
  double StiffnessGain = 1.0;
  double TransientGain = 0.0;
  double MaximumTorque = 0.0;
  double AttentionTime = 2.0;
  double WantedForce = -1.0;  // value of SetMaximumForce; negative: default, half of the device's
                              // maximum
  double WantedTorque = -1.0; // value of SetMaximumTorque; negative: default, half of the device's
                              // maximum

private:
  vtkHapticDevice(const vtkHapticDevice&) = delete;
  void operator=(const vtkHapticDevice&) = delete;

#ifndef __VTK_WRAP__
  friend class vtkHapticVirtualHand; // changes the limits of the virtual device

  VolumeHaptics::DeviceOptions MakeOptions() const;
  void SendLimits();
  void UpdateLimits();
  void Shut();
  void Halt();

  std::unique_ptr<VolumeHaptics::DeviceParts> Parts;
#endif
};

#endif
