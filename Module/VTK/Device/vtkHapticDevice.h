// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticDevice
 * @brief   a stylus in a hand, and the servo loop that makes it feel a volume
 *
 * Opens a haptic device and lets a hand feel the volume of a vtkVolumeHapticsFilter with it. The
 * device ticks at ServoRate on a thread of its own (vtkMultiThreader::SpawnThread), with exactly
 * the code that vtkVolumeHapticsFilter runs offline. The loop never waits: it neither locks,
 * allocates nor calls a vtkObject. The thread that owns this object (the GUI thread) hands it
 * immutable snapshots of the filter with Publish, and takes the latest state with UpdateState.
 *
 *   device->Open("virtual");
 *   device->SetVolumeHaptics(filter);
 *   device->Start();                  // ticks; the proxy moves, no force yet
 *   device->Arm();                    // force rises over half a second
 *   ... in the GUI's timer: device->UpdateState(); render with GetProxyPosition() ...
 *   device->Stop();                   // zero force, thread joined
 *
 * Safety. No force leaves before Arm. Every force is checked for NaN, clamped to MaximumForce and
 * to the device's own maximum, and grows by at most MaximumForceRate; after Arm and after every gap
 * it rises from zero over half a second, and the proxy begins at the tip. None of this gives the
 * hand more energy than the hand put in: a wall that is pressed meanwhile, or struck too fast for
 * MaximumForceRate, stays soft until the tip leaves it or presses deeper. A tip that is not finite,
 * that moves faster than a hand can hold the device, or a device that is lost, cuts the force and
 * latches a fault until Arm is called again. Without fresh samples for 30 ms the force goes to
 * zero. Stop, Close, deletion, exit(), quick_exit(), an uncaught exception, a crash and the other
 * signals that end or stop the process send zero force. Signal handlers that the program installed
 * before Arm run after the force is zero; handlers installed later run first. Stiffness and
 * ForceFieldDamping are capped at what the device can hold.
 *
 * A program can't send zero force on SIGKILL, SIGSTOP, real-time signals, _exit(), exec() of
 * another program, loss of power, a crash in the thread that talks to the device, a crash that
 * leaves the heap locked if the device's library needs it, or a stack overflow in a thread other
 * than the owner's. Then the device's own watchdog ends the force, or a guard process: see
 * vtkHapticHardware.
 *
 * While the owner's thread is busy with long work, the force is off: see BeginLongWork, which
 * Publish and StopRecording call by themselves where they need it. If the program does not call the
 * device for 2 s without having announced such work, the force fades and stays off until Arm is
 * called again: see SetAttentionTime.
 *
 * The servo reads the image's own array, without a copy, and so does work in the background: give
 * the image a new array instead of resizing or refilling one that is being touched. Call Modified()
 * after changing values in place; background work on them then begins again.
 *
 * Positions are in world units and forces in newtons along the world's axes, unless stated.
 * Devices: "virtual" has no hardware: SetVirtualTip leads its tip. "vibration:xr" is led in the
 * same way, and returns how strongly to vibrate: see TakeVibration. "replay:FILE" plays back a
 * recording (.vtp or .csv), tick by tick. vtkHapticHardware lists the real devices. A real device
 * that is not homed opens at once and waits for the hand, as GetStatusText says; Arm is refused
 * until it is ready. When it is unplugged, stops answering, loses its zero, or the computer was
 * asleep, the force is cut and stays off until the user calls Home() or Open(), and then Arm().
 *
 * If a vtkHapticRegionSource is on port 0 of the filter, UpdateState makes it read the region
 * around the tip, and publishes each region when it is there.
 *
 * @sa vtkVolumeHapticsFilter, vtkHapticHardware, vtkHapticRegionFilter, vtkHapticRegionPlanner,
 * vtkHapticRegionSource
 */
#ifndef vtkHapticDevice_h
#define vtkHapticDevice_h

#include "vtkHapticHardware.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkMatrix4x4;
class vtkImageData;
class vtkPolyData;
class vtkTable;
class vtkVolumeHapticsFilter;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticDevice : public vtkHapticHardware
{
public:
  static vtkHapticDevice* New();
  vtkTypeMacro(vtkHapticDevice, vtkHapticHardware);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Open a device by its id, and close the device that was open. False, with an error that names
   * the cure, if opening fails.
   */
  bool Open(const char* id);
  /** Stop, and release the device. */
  void Close();
  bool IsOpen();
  std::string GetDeviceId(); ///< Get the id that was opened; empty while closed.

  ///@{
  /**
   * The filter whose volume is felt. Takes effect with Publish or Start. The filter is kept by
   * reference; the servo never touches it.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* GetVolumeHaptics();
  ///@}

  /**
   * Get the name of the felt method as users see it, such as "Proxy, PRECISE": the method of the
   * last Publish, or, if the servo does not run, the filter's method; empty without a filter.
   */
  std::string GetMethodText();

  /**
   * Bring the filter's image up to date and hand the servo a snapshot of everything: image,
   * materials, settings, DeviceToWorld. The servo uses it from the next tick on; if the force
   * becomes larger, it grows at MaximumForceRate. If the servo does not run, Publish only checks.
   * False, with an error, if the input can't be touched; the servo then keeps the last snapshot.
   *
   * Three kinds of work are done in the background first: measuring the distances to forbidden
   * labels of a large label image, meshing a large surface of SURFACE_PROXY, and sampling the
   * points of a vtkHapticPointShell. Publish and Start then return true at once, and UpdateState
   * publishes when the work is done; see IsPublished. While a mesh is made, UpdateState publishes
   * the isosurface around the tip, whose force fades where the tip leaves it before the next part
   * is there (GetResidency). It does not do so while a recording is under way.
   */
  bool Publish();
  /**
   * Whether Publish or Start was called, successfully or not, since the filter, image or surface
   * last changed.
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

  ///@{
  /** Ticks per second (Hz), 100 to 10000. Default 1000. Takes effect with Start. */
  void SetServoRate(double rate);
  vtkGetMacro(ServoRate, double);
  ///@}

  ///@{
  /**
   * Start the servo with the filter as it is now, and stop it with zero force. Without a filter,
   * the tip just moves. Start is false, with an error, if no device is open, if the filter can't be
   * touched, or if the system gives the program no more memory, threads or files: without them, a
   * crash would leave the force on.
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
   * disarms. Every way to disarm invokes vtkCommand::DisableEvent at once. IsArmOrdered tells
   * whether the last of all these orders was Arm, even if the servo has yet to see it, the clutch
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
   * vtkCommand::StartEvent. Meanwhile GetStatusText says "Force is off while" and the given words,
   * such as "the surface is meshed" (nullptr: "the program works"), and AttentionTime does not
   * count. EndLongWork invokes vtkCommand::EndEvent, and the force rises over half a second, with
   * the proxy on the tip at first, unless the device was disarmed meanwhile or has a fault. Arm
   * during the work takes effect after it. Pairs nest: the force comes back with the last
   * EndLongWork, and stays off if that call is missing.
   *
   * If expectedSeconds (s; by default the work is long) is below 0.25 and below an eighth of
   * AttentionTime (unless that is 0), the force stays on: fading would disturb more than such a
   * short pause, and the factor of eight allows for a slow computer. Publish calls these functions
   * by itself for a large mesh that can't be made in the background, because its array has a memory
   * layout of its own. StopRecording and RecoverRecording call them to write a long recording. If
   * the pipeline before the filter takes seconds, the application has to call them.
   */
  void BeginLongWork(const char* what, double expectedSeconds = VTK_DOUBLE_MAX);
  void EndLongWork();
  ///@}

  ///@{
  /**
   * A clutch, which lets the hand move a real device while the tip should not move with it. While
   * it is on, no force leaves, from the next tick on; turning it on invokes
   * vtkCommand::DisableEvent. Turning it off arms the device again, as Arm does, if it was armed
   * before and nothing has disarmed it since: ArmsAfterClutch. An Arm while the clutch is on takes
   * effect when it is turned off. Default off.
   */
  void SetClutch(bool on);
  bool GetClutch();
  bool ArmsAfterClutch();
  ///@}

  /** Search again for the zero of a real device's encoders, with the hand's help; disarms. */
  void Home();

  /**
   * The lights of a real device, until Close: bits 1 green, 2 blue, 4 red of a Falcon, 1 of a
   * SpaceMouse. Below zero (default) the lights show the status of the device.
   */
  void SetLights(int lights);

  ///@{
  /**
   * Get whether the signs of the open device are confirmed, or need no confirmation. A real device
   * that gives force may push the wrong way, if its wiring or a setting differs from what was
   * assumed. So its first Arm pushes the hand gently along each of its axes, for about ten seconds,
   * and the tip has to move with the force: hold the device loosely in the middle of its workspace
   * and keep the hand still. Nothing else is felt meanwhile. A wrong sign is a fault (GetStatusText
   * names the axis). If the signs are right, the user's file of devices remembers them by the
   * device's serial number or port: volumehaptics/devices.txt in $XDG_CONFIG_HOME, ~/.config or
   * %APPDATA%, or the file that the environment variable VOLUMEHAPTICS_DEVICES names.
   * ForgetConfirmation, before Start, makes the next Arm confirm the signs again.
   */
  bool GetSignsConfirmed();
  void ForgetConfirmation();
  ///@}

  /**
   * Get whether that file remembers the open device. False for a device that reports neither a
   * serial number nor its port, because it can't be distinguished from others: its confirmation and
   * its calibration then hold until Close. Also false for a device that gives no force.
   */
  bool IsRemembered();

  ///@{
  /**
   * Get the newtons that the open device really gives for each newton that it is asked for, as
   * CalibrateForce has stored it (see IsRemembered): 1 if it was never calibrated. Forces and
   * limits of a calibrated device are true newtons; MaximumForce never exceeds what its driver
   * allows. CalibrateForce takes 0.1 to 10, while the servo does not run; false, with an error, for
   * anything else. The text is "calibrated 0.83 on 2026-11-22", "uncalibrated", or empty if the
   * device gives no force or none is open. None of this was tried on hardware.
   */
  bool CalibrateForce(double scale);
  double GetForceScale();
  std::string GetCalibrationText();
  ///@}

  ///@{
  /**
   * Get the state of the device (StatusType), as of the last UpdateState; the text names the fault
   * and the cure.
   */
  int GetStatus();
  std::string GetStatusText();
  ///@}

  ///@{
  /**
   * The position to which the hand leads the tip of the virtual device (world). Without simulated
   * dynamics the tip goes there at 2 m/s or less; the first call puts it there. PlaceVirtualTip
   * does so at any time: the hand takes the stylus up at a new position, and feels nothing on the
   * way. Disarm before: an armed device would see a hand that is too fast.
   */
  void SetVirtualTip(double x, double y, double z);
  void PlaceVirtualTip(double x, double y, double z);
  void SetVirtualTip(const double x[3]) VTK_SIZEHINT(3);
  void SetVirtualButtons(int buttons);
  ///@}

  ///@{
  /**
   * The orientation of the virtual device's stylus (world): a quaternion w, x, y, z of any norm,
   * see GetTipOrientation. Until this is called, and after four zeros, it has none.
   */
  void SetVirtualTipOrientation(double w, double x, double y, double z);
  void SetVirtualTipOrientation(const double wxyz[4]) VTK_SIZEHINT(4);
  ///@}

  /**
   * Get how strongly the device "vibration:xr" should vibrate: the largest amplitude since the last
   * call, 0 to 1. The program leads the tip like the virtual device's tip, and makes vibrate what
   * the hand holds; call this in each frame. vtkHapticXRController does both for the controllers of
   * a headset. 0 for other devices, and while the servo stands still.
   */
  double TakeVibration();

  /**
   * Simulate the virtual device and the hand that holds it: m x'' = f + handStiffness (lead - x) -
   * damping x' with mass in kg (0, the default: no dynamics), damping in N s/m and the hand's
   * stiffness in N/m. Positions are rounded to an encoder's quantum (m; 0: not), and forces are
   * delayed by ticks (0 to 16). Call it before Start.
   */
  void SetVirtualDynamics(
    double mass, double damping, double handStiffness, double encoderQuantum, int forceDelay);

  /**
   * Give the virtual device the limits of another device: its force (N), stiffness (N/m), damping
   * (N s/m), and its own friction b (N s/m); a spring is not stable above 2 b / period. 0 does not
   * limit. Default: 20 N, the others 0. A Novint Falcon is (8, 3000, 20, 0). Sets MaximumForce to
   * half of the force, as Open does. Call it before Start.
   */
  void SetVirtualLimits(
    double maximumForce, double maximumStiffness, double maximumDamping, double friction);

  ///@{
  /**
   * The time of a volume that moves: its source has several time steps (TIME_STEPS), or its
   * components are its frames (SetFramesToComponents of the filter). It begins with the first Play
   * or SetDataTime: until then, the time step that the source shows is felt, or the component of
   * the property, and the volume stands still.
   *
   * While it plays, data time advances in every tick of the servo by TimeUnitsPerSecond of the
   * filter for each second, also backwards, and time steps are blended. Play, Hold, another speed
   * and another end never step the data time nor the force. At the end of the time steps, it holds
   * (PlaybackToOnce, the default), goes on to the first step through a mean interval in which the
   * last step is blended to it (PlaybackToLoop), or turns around (PlaybackToPingPong).
   *
   * SetDataTime jumps to another time, in the units of the source; beyond the time steps, the
   * nearest step is used. The volume there is felt as a new one: a force that would jump begins
   * again at zero. GetDataTime returns the data time of the latest state, or the time of
   * SetDataTime until it is felt; default 0. In the interval after the last step, it is above the
   * last step's time.
   *
   * UpdateState reads the time steps ahead of the servo, three in memory at most: when SetDataTime
   * jumps to a pair of two other steps, one of them may be felt alone for a moment. If steps are
   * late, data time stands still: IsWaitingForData becomes true, and GetStatusText says which steps
   * are awaited. Components are felt in their array, without a copy.
   */
  void Play();
  void Hold();
  bool IsPlaying(); ///< Get whether the last order was Play. Default false.
  enum PlaybackType
  {
    ONCE = 0,
    LOOP = 1,
    PING_PONG = 2
  };
  void SetPlayback(int playback);
  int GetPlayback();
  void SetPlaybackToOnce() { this->SetPlayback(ONCE); }
  void SetPlaybackToLoop() { this->SetPlayback(LOOP); }
  void SetPlaybackToPingPong() { this->SetPlayback(PING_PONG); }
  void SetDataTime(double time);
  double GetDataTime();
  bool IsWaitingForData();
  ///@}

  ///@{
  /**
   * How many times as fast as by the filter's TimeUnitsPerSecond a volume that moves is played;
   * less than 0, backwards. Unlike that setting, it needs no Publish. -1e6 to 1e6, default 1.
   */
  void SetPlaybackSpeed(double factor);
  double GetPlaybackSpeed();
  ///@}

  ///@{
  /**
   * Get the volume that moves as it is felt now: the frame nearest to GetDataTime, as an image
   * whose scalars are the touched array of that time step, or the component that is the frame; and
   * its time. The image stays the same until the frame changes; its samples must not be changed.
   * vtkInteractorStyleHaptic shows it by itself. nullptr if HasFrames is false: no volume that
   * moves is felt.
   */
  bool HasFrames();
  vtkImageData* GetFrameImage();
  double GetFrameTime();
  ///@}

  /**
   * Copy the latest state from the servo; true if it is a new one. The following getters all return
   * values of this one tick.
   */
  bool UpdateState();

  ///@{
  /**
   * Get the latest tip and proxy (world); the force sent to the device, and the computed force (N,
   * world axes).
   */
  double* GetTipPosition() VTK_SIZEHINT(3);
  double* GetProxyPosition() VTK_SIZEHINT(3);
  double* GetForce() VTK_SIZEHINT(3);
  double* GetComputedForce() VTK_SIZEHINT(3);
  ///@}
  ///@{
  /**
   * Get, in the latest state, the torque of a tool that has a shape (vtkHapticPointShell) on the
   * hand about the tip (N m, world axes), as sent and as computed, and the orientation of the tool,
   * whose origin is the proxy: a unit quaternion (w, x, y, z) that turns from the world's axes to
   * the tool's. All are zeros without such a tool; the head of a vtkHapticBurr does not turn, and
   * gives no torque. No torque is sent to a device that gives none.
   */
  double* GetTorque() VTK_SIZEHINT(3);
  double* GetComputedTorque() VTK_SIZEHINT(3);
  double* GetToolOrientation() VTK_SIZEHINT(4);
  ///@}
  ///@{
  /**
   * Get the orientation of the stylus in the latest state, if the device measures one. It is a unit
   * quaternion (w, x, y, z, as in vtkQuaternion) that turns from the world's axes to the stylus's:
   * the stylus points along its -z, its handle is on the side of +z, and its button on the side of
   * +y. HasTipOrientation is false, and the quaternion (1, 0, 0, 0), if the device measures none or
   * its quaternion is not finite or not of unit norm within 1 %, unless SetTipOrientation turns it.
   * The forces of tools depend on it.
   */
  double* GetTipOrientation() VTK_SIZEHINT(4);
  bool HasTipOrientation();
  ///@}
  /** Get whether, in the latest state, the device itself measures how it is held. */
  bool IsTipOrientationMeasured();
  /**
   * How the hand holds its tool (world) if the device measures no orientation, such as one with
   * three degrees of freedom: a quaternion w, x, y, z of any norm. The tool turns to this
   * orientation at 4 rad/s at most, and then turns with the device's placement, as a stylus does.
   * Until this is called, and after four zeros, there is none. It holds for later servos, too.
   */
  void SetTipOrientation(double w, double x, double y, double z);
  ///@{
  /**
   * Whether a vtkHapticBurr spins without its SpinButton while the device is armed, for this and
   * later servos. Default: off.
   */
  void SetSpinning(bool spinning);
  bool GetSpinning();
  vtkBooleanMacro(Spinning, bool);
  ///@}
  /** Get whether, in the latest state, a vtkHapticBurr spins, by SetSpinning() or its button. */
  bool IsSpinning();
  int GetButtons(); ///< Get the buttons in the latest state: bit 0 is the main button.
  /** Get how fast a SpaceMouse turns the volume in the latest state (rad/s, the device's axes). */
  double* GetTurnRate() VTK_SIZEHINT(3);
  /** Get the contact in the latest state: 0 free, 1 sticking, 2 sliding, 3 penetrating. */
  int GetContact();
  ///@{
  /**
   * Get, in the latest state, the value V(x_s) in the surface, and the parts of the force from the
   * surface, friction and the medium (N).
   */
  double GetSurfaceValue();
  double GetNormalForce();
  double GetFrictionForce();
  double GetDragForce();
  ///@}
  /**
   * Get, in the latest state, the part of the distance between tip and proxy (world) that gives no
   * force. With the solver PRECISE, a spring that gets stiffer under a resting hand gets slack
   * instead of more force; 0 otherwise.
   */
  double GetSlack();
  /**
   * Get, in the latest state, the force of a mode of PRIMITIVES on the hand (N, world axes), before
   * MaximumForce; zero for other methods and numbers. Modes count from 0 as in GetMode of the
   * filter.
   */
  double* GetModeForce(int mode) VTK_SIZEHINT(3);

  /**
   * Write the shapes that the felt modes hold the hand on, at the proxy of the latest state: lines
   * such as a flow line, up to `reach` voxels to either side, and fronts as polygons with a radius
   * of a quarter of `reach`, with point normals to the free side. A mode about tensors also gives a
   * vertex at the proxy with the tensor as point tensors, whose first eigenvalue is scaled to an
   * eighth of `reach`, for vtkTensorGlyph. The shapes come from the data that the servo reads, in
   * world units. The cell array Mode has the number of the mode. Empty for other methods.
   */
  void GetFollowed(vtkPolyData* shapes, double reach = 32.0);

  /**
   * Write where a vtkHapticNeedle in the hand runs through tissue (world): a line for each stretch
   * of one label, from the entry to the tip. Point array Depth (world units), cell arrays Label and
   * Length (world units). Field arrays, one number each: Depth and Deepest (world units), Angle to
   * the normal of the surface at the entry (degrees; -1 without one), ShaftForce (N), and
   * ForbiddenTouches, how often a forbidden label stopped this insertion. Without a needle in
   * tissue there are no lines. vtkXMLPolyDataWriter exports the track. Make sure that there is
   * room: on a full disk it leaves a part of the file, and Write() may return 1 all the same.
   */
  void GetNeedleTrack(vtkPolyData* track);

  /**
   * Get how deep a vtkHapticNeedle is inserted in the latest state (world units); 0 if it is not.
   */
  double GetNeedleDepth();

  /**
   * Get the label just inside the surface in the latest state, that is, at the proxy plus r times
   * the normal; 0 if the filter has no label image, or there is no label. vtkHapticLabelTable has
   * its name.
   */
  vtkTypeInt64 GetLabel();
  /**
   * Get whether, in the latest state, the wall in front of a forbidden label holds the tip back.
   * When this begins, UpdateState invokes vtkCommand::UserEvent.
   */
  bool IsAtForbiddenLabel();
  ///@{
  /**
   * Get, in the latest state (world), the unit normal inwards, and the positions x_s and x_v at
   * which the materials were read (fig. 4).
   */
  double* GetNormal() VTK_SIZEHINT(3);
  double* GetSurfacePosition() VTK_SIZEHINT(3);
  double* GetMediumPosition() VTK_SIZEHINT(3);
  ///@}
  /**
   * Get the fraction of the force, 0 to 1, that missing data around the tip
   * (vtkHapticRegionFilter), FadeOut, AttentionTime and long work leave in the latest state; 1
   * without any of these. Changes from 0 to 1 or back in 50 ms at the fastest. The ramp after Arm
   * is not part of it.
   */
  double GetResidency();
  /** Get the number of the latest state since Start, and its time (s). */
  vtkIdType GetTick();
  double GetTime();

  /**
   * Write all states since the last call, oldest first, as rows of a table that is overwritten. Its
   * columns are Time (s), Tick, NormalForce, FrictionForce, DragForce (N), SurfaceValue, Contact,
   * Armed, Fault, Residency, with three components Tip, Proxy (world), Force (computed) and Command
   * (sent; N, world axes), with four Orientation (world; w, x, y, z; all 0 if the device has none),
   * and with eight ModeForces (N, magnitudes of GetModeForce). States are kept from the first call
   * on; a reader that does not call for 86000 ticks loses the oldest. Each reader has a number, and
   * gets all states; a call with nullptr as the table ends the reading. The first
   * vtkInteractorStyleHaptic of a device has number 0, further ones have -1, -2 and so on: see
   * AddReader.
   */
  void DrainStates(vtkTable* states, int reader = 0);

  ///@{
  /**
   * Reserve a number for DrainStates: 0, or if it is taken, -1, -2 and so on. RemoveReader releases
   * the number and ends the reading. Applications may use numbers above 0 without reserving them.
   */
  int AddReader();
  void RemoveReader(int reader);
  ///@}

  ///@{
  /**
   * Longest force (N) on the hand, at most the device's own maximum. Half of that by default, for
   * every device that is opened; ResetMaximumForce returns to this default.
   */
  void SetMaximumForce(double force);
  void ResetMaximumForce();
  vtkGetMacro(MaximumForce, double);
  ///@}

  ///@{
  /**
   * Largest torque (N m) on the hand, at most the device's own maximum. Half of that by default,
   * for every device that is opened; ResetMaximumTorque returns to this default. The torque grows
   * by at most 20 N m/s. It leaves only while force may leave.
   */
  void SetMaximumTorque(double torque);
  void ResetMaximumTorque();
  vtkGetMacro(MaximumTorque, double);
  ///@}

  ///@{
  /**
   * Largest growth of force (N/s), 1 or more. Default 500. Only growth is limited: a force that
   * becomes smaller does so at once, and one that turns takes its new direction at once. A limit on
   * these, too, would push the hand off a stiff wall with more energy than the hand put in. For the
   * same reason, if a wall is hit so fast that its force is limited, it stays softer until the tip
   * leaves it or presses deeper.
   */
  void SetMaximumForceRate(double rate);
  vtkGetMacro(MaximumForceRate, double);
  ///@}

  ///@{
  /**
   * How long (s) an armed device keeps its force if the program stands still: a window that hangs
   * can't stop the device. If for that long the program calls none of UpdateState, DrainStates,
   * Publish and Arm, and sets no limit, the servo fades the force out, and a fault holds until Arm.
   * 0.05 or more, default 2; 0 turns it off, for programs that call the device rarely. Work between
   * BeginLongWork and EndLongWork does not count.
   */
  void SetAttentionTime(double seconds);
  vtkGetMacro(AttentionTime, double);
  ///@}

  ///@{
  /**
   * Record every tick, with settings, units, device and a hash of the volume, until StopRecording
   * writes it to a .vtp, or to a .csv with all data that do not belong to a tick in a .csv.json
   * beside it. On port 1 of vtkVolumeHapticsFilter a .vtp gives the same forces to the bit, as long
   * as only the placement of the device changed during the recording. Needs a running servo and a
   * filter. A region (vtkHapticRegionFilter) is not recorded, nor published during a recording: no
   * single image could replay it.
   *
   * The recording begins at once, however large the volume is. The hashes of volume and labels are
   * computed meanwhile, from the values at that time; UpdateState hands them to the recording, and
   * GetStatusText reports their progress. StopRecording waits up to 10 s for them, but not while
   * the device is armed: if they are not known then, VolumeHash is empty, a replay is not refused
   * for its labels, and a warning says so.
   *
   * Besides the arrays of vtkVolumeHapticsFilter, a tick has DeviceTip (m), Command (N, sent),
   * Torque (N m, of tools; computed) and TorqueCommand (N m, sent), Orientation (world) and
   * DeviceOrientation (w, x, y, z; all 0 if the device has none), Tick, Buttons, Armed, Fault,
   * Share (0 to 1: the fraction of Force that the gate let through) and Reason (why Share is below
   * 1; numbers in Documentation/devices.md). A vtkHapticBurr adds Spinning, RemovedVolume and
   * RemovalRequest (1 undo, 2 redo, 3 reset that began), and the tissue that was removed before as
   * field arrays.
   *
   * During the recording the ticks are written to FILE.part; memory holds only the last seconds. A
   * .vtp takes 220 to 250 bytes a tick (15 MB a minute at 1 kHz), 65 more while the stylus turns,
   * and FILE.part up to about two thirds of that, beside the .vtp while it is written.
   * StartRecording is false, with an error, if the file can't be written. If writing fails later,
   * for example because the disk is full, the next UpdateState gives an error, and GetStatusText
   * says so from then on.
   *
   * StopRecording is false, with an error, unless the file holds all ticks that were collected. It
   * replaces an existing file only with a complete one. If a busy machine or a slow disk kept ticks
   * from being collected, StopRecording gives a warning, and the field array LostTicks has their
   * number.
   */
  bool StartRecording(const char* file);
  bool StopRecording();
  ///@}
  /**
   * Make a .vtp or .csv from a FILE.part that was left because StopRecording failed or the program
   * died. The file gets all ticks that reached the disk; after a crash usually fewer than 600 of
   * the last ticks are missing, and up to 16500 if the disk was slow. FILE.part is then removed,
   * except on a file system without locks, where another program might still write to it. On
   * failure, returns false with an error, and keeps FILE.part. If FILE.part can't be read to its
   * end, that is an error, too, but the ticks before the damage are written unless the file exists
   * already. Needs neither a device nor a volume.
   */
  bool RecoverRecording(const char* part, const char* file);

  ///@{
  /**
   * Get how well the servo keeps time, since Start or ResetStatistics: ticks per second; the
   * duration (s) that a percentage p (0 to 100) of ticks, or of the delays of wake-ups, do not
   * exceed, to 1/8 of it; ticks that were left out because the loop was late; ticks whose force was
   * reduced because data around the tip were missing (GetResidency); and ticks that solver PRECISE
   * could not finish (a tip that jumps by tens of voxels), which the next ticks finished.
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
   * Get the timing of the device, measured over about the last second: the time (s) from one report
   * with news to the next, and the round trip T (s), which is that time plus twice the time that a
   * force needs to reach the device; 95 % of both are shorter. 0 as long as they are not known, or
   * while the servo does not run. T caps the stiffness (N/m), k <= 2 b / T with the device's
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

  double ServoRate = 1000.0;
  double MaximumForce = 0.0;
  double MaximumForceRate = 500.0;
  double MaximumTorque = 0.0;
  double AttentionTime = 2.0;
  double WantedForce = -1.0;  // as set by SetMaximumForce; negative: half of the device's maximum
  double WantedTorque = -1.0; // as set by SetMaximumTorque; negative: half of the device's maximum

private:
  vtkHapticDevice(const vtkHapticDevice&) = delete;
  void operator=(const vtkHapticDevice&) = delete;

  void SendLimits();
  void TakeLimits();
  void Shut();
  void Halt();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
