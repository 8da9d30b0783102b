// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticDevice
 * @brief   a stylus in a hand, and the servo loop that makes it feel a volume
 *
 * The device ticks at ServoRate on a thread of its own (vtkMultiThreader::SpawnThread), with exactly the code
 * that vtkVolumeHapticsFilter runs offline. The loop never waits: it neither locks, allocates nor calls a vtkObject.
 * The thread that owns this object (the GUI thread) hands it immutable snapshots of the filter with Publish, and
 * takes the latest state with UpdateState.
 *
 *   device->Open("virtual");
 *   device->SetVolumeHaptics(filter);
 *   device->Start();                  // ticks; the proxy moves, no force yet
 *   device->Arm();                    // force rises over half a second
 *   ... in the GUI's timer: device->UpdateState(); render with GetProxyPosition() ...
 *   device->Stop();                   // zero force, thread joined
 *
 * Safety. No force leaves before Arm. Every force is checked for NaN, clamped to MaximumForce and to the device's
 * own maximum, and grows by at most MaximumForceRate; after Arm and after every gap it rises from zero over half
 * a second. A tip that is not finite, that moves faster than a hand can hold the device, or a device that is lost,
 * cuts the force and latches a fault until Arm is called again. Without fresh samples for 30 ms the force goes to
 * zero. Stop, Close, deletion, exit(), quick_exit(), an uncaught exception, and crashes and other signals that end or
 * stop the process send zero force; handlers that were there before run after that. Where zero can't be sent, a device
 * without a watchdog of its own keeps its last force: SIGKILL, SIGSTOP, real-time signals, _exit(), exec() of another
 * program, a crash in the thread that talks to the device or with the heap locked that its library needs, a full stack
 * of another thread than the owner's, and loss of power. A handler that a program adds to an armed device comes first.
 * Stiffness and ForceFieldDamping are capped at what the device can hold. During work that keeps the owner's thread
 * for long (BeginLongWork), as StartRecording and Publish have it with large volumes, the force is off. A program that
 * stands still for 2 s without such an announcement loses the force until Arm is called again: see SetAttentionTime.
 *
 * The servo reads the image's own array, without a copy: give the image a new array instead of resizing or
 * refilling one that is being touched.
 *
 * Positions are in world units and forces in newtons along the world's axes, except where said.
 * Devices: "virtual" has no hardware: SetVirtualTip leads its tip. "replay:FILE" plays back a recording
 * (.vtp or .csv), tick by tick. Real ones are those of vtkHapticHardware. A real device that is not homed
 * opens at once and waits for the hand, as GetStatusText tells; Arm is refused until it is ready. When it
 * is unplugged, stops answering, loses its zero, or the computer was asleep, the force is cut off for
 * good: the user brings it back, with Home() or Open(), and Arm().
 *
 * @sa vtkVolumeHapticsFilter, vtkHapticHardware, vtkHapticRegionFilter, vtkHapticRegionPlanner
 */
#ifndef vtkHapticDevice_h
#define vtkHapticDevice_h

#include "vtkHapticHardware.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkMatrix4x4;
class vtkTable;
class vtkVolumeHapticsFilter;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticDevice : public vtkHapticHardware
{
public:
  static vtkHapticDevice* New();
  vtkTypeMacro(vtkHapticDevice, vtkHapticHardware);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Open a device by its id. False, with an error that says what to do, where that is not possible. Closes the one
   * that was open.
   */
  bool Open(const char* id);
  /** Stop, and let go of the device. */
  void Close();
  bool IsOpen();
  std::string GetDeviceId(); ///< The id that was opened; empty while closed.

  ///@{
  /**
   * What is felt. Takes effect with Publish or Start. The filter is kept by reference; the servo never touches it.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* GetVolumeHaptics();
  ///@}

  /**
   * Which method is felt, for people: that of the last Publish, such as "Proxy, PRECISE". While the servo does not
   * run, that of the filter; empty without one.
   */
  std::string GetMethodText();

  /**
   * Bring the filter's image up to date and hand the servo a snapshot of everything: image, materials, settings,
   * DeviceToWorld. Used from the next tick on; a force that grows with it does so at MaximumForceRate. Without a
   * running servo only checks. False, with an error, where the input can't be touched; the servo then goes on with what it has.
   */
  bool Publish();
  /** Whether it was tried, with Publish or Start, since the filter, its image or its surface changed last. */
  bool IsPublished();

  ///@{
  /**
   * From the device's space (m) to the world: a rotation, a translation and one uniform, positive scale. Takes
   * effect with Publish. nullptr (default): the world scaled by the filter's MetersPerWorldUnit.
   */
  void SetDeviceToWorld(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetDeviceToWorld();
  ///@}

  ///@{
  /** Ticks per second, 100 to 10000. Default 1000. Takes effect with Start. */
  void SetServoRate(double rate);
  vtkGetMacro(ServoRate, double);
  ///@}

  ///@{
  /**
   * Start the servo, with the filter as it is now (without one the tip just moves), and stop it with zero force.
   * Start is false, with an error, where no device is open, the filter can't be touched, or the program may have no more
   * memory, threads or files, so that a crash would leave the force on.
   */
  bool Start();
  void Stop();
  bool IsRunning();
  ///@}

  ///@{
  /**
   * Let force through, or not. Arm forgets a fault, changes nothing where force flows already, and is refused, with an
   * error, while the device is not ready; Disarm cuts the force at once, FadeOut within 50 ms, for data that will not
   * come any more, as of a server that is gone. Stop disarms. Whatever disarms invokes vtkCommand::DisableEvent, at
   * once.
   */
  void Arm();
  void Disarm();
  void FadeOut();
  ///@}

  ///@{
  /**
   * Around work that keeps the owner's thread from looking after the hand, such as computing a mesh. BeginLongWork
   * lets the force fade within 50 ms, waits for that, invokes vtkCommand::StartEvent, and GetStatusText says
   * "Force is off while" and the given words ("the surface is meshed"). EndLongWork invokes vtkCommand::EndEvent,
   * and the force rises over half a second from where the tip is then, unless the device was
   * disarmed meanwhile or has a fault. Arm during the work takes effect after it. AttentionTime does not count
   * meanwhile. Pairs nest, and the force comes back with the last EndLongWork; without that it stays off.
   *
   * If expectedSeconds is below 0.25, and below an eighth of AttentionTime, the force stays on: the hand would feel
   * but a flicker, and a computer that is eight times slower than expected is no fault. The device announces by itself
   * that StartRecording hashes, and Publish meshes, a large volume, and that a long recording is written or recovered.
   * A pipeline before the filter that takes seconds is the application's to announce.
   */
  void BeginLongWork(const char* what, double expectedSeconds = VTK_DOUBLE_MAX);
  void EndLongWork();
  ///@}

  /** Look for the zero of a real device's encoders anew, with the hand's help; disarms. */
  void Home();

  /**
   * What a real device lights up, until Close: bits 1 green, 2 blue, 4 red of a Falcon, 1 of a SpaceMouse. Below
   * zero (default) the lights show how the device stands.
   */
  void SetLights(int lights);

  ///@{
  /** Where the device stands (StatusType), as of the last UpdateState; the text says what is wrong, and the cure. */
  int GetStatus();
  std::string GetStatusText();
  ///@}

  ///@{
  /**
   * Where the hand leads the tip of the virtual device (world). Without simulated dynamics the tip goes there at 2
   * m/s or less; the first call puts it there. PlaceVirtualTip does so at any time: the hand takes the stylus up
   * there anew, and feels nothing of the way. Disarm before; an armed device takes it for a hand that is too fast.
   */
  void SetVirtualTip(double x, double y, double z);
  void PlaceVirtualTip(double x, double y, double z);
  void SetVirtualTip(const double x[3]) VTK_SIZEHINT(3);
  void SetVirtualButtons(int buttons);
  ///@}

  /**
   * Simulate the virtual device and the hand that holds it: m x'' = f + handStiffness (lead - x) - damping x' with
   * mass in kg (0: none, the default), damping in N s/m and the hand's stiffness in N/m, positions rounded to an
   * encoder's quantum (m, 0: not) and forces delayed by ticks (0 to 16). Before Start.
   */
  void SetVirtualDynamics(
    double mass, double damping, double handStiffness, double encoderQuantum, int forceDelay);

  /**
   * Let the virtual device stand no more than another one: its force (N), stiffness (N/m), damping (N s/m), and its
   * own friction b (N s/m), above twice which, over the tick's period, a spring is not stable. 0 does not limit.
   * Default: 20 N, the others 0. A Novint Falcon is (8, 3000, 20, 0). Sets MaximumForce to half of the force, as
   * Open does. Before Start.
   */
  void SetVirtualLimits(
    double maximumForce, double maximumStiffness, double maximumDamping, double friction);

  /** Take the latest state from the servo; true if it is a new one. What follows belongs to one tick. */
  bool UpdateState();

  ///@{
  /** Of the latest state: tip and proxy (world); what went to the device, and what was computed (N, world axes). */
  double* GetTipPosition() VTK_SIZEHINT(3);
  double* GetProxyPosition() VTK_SIZEHINT(3);
  double* GetForce() VTK_SIZEHINT(3);
  double* GetComputedForce() VTK_SIZEHINT(3);
  ///@}
  int GetButtons(); ///< Of the latest state: bit 0 is the main button.
  /** Of the latest state (rad/s, the device's axes): how fast a SpaceMouse asks the volume to turn. */
  double* GetTurnRate() VTK_SIZEHINT(3);
  /** Of the latest state: 0 free, 1 sticking, 2 sliding, 3 penetrating. */
  int GetContact();
  ///@{
  /** Of the latest state: V(x_s), the value in the surface; what it, friction and the medium take of the force (N). */
  double GetSurfaceValue();
  double GetNormalForce();
  double GetFrictionForce();
  double GetDragForce();
  ///@}
  ///@{
  /** Of the latest state (world): the unit normal inwards; x_s and x_v, where the materials were read (fig. 4). */
  double* GetNormal() VTK_SIZEHINT(3);
  double* GetSurfacePosition() VTK_SIZEHINT(3);
  double* GetMediumPosition() VTK_SIZEHINT(3);
  ///@}
  /**
   * Of the latest state: the share of the force, 0 to 1, that passed since the data around the tip are here; 1
   * unless the image is a region (vtkHapticRegionFilter). Changes by 1 in 50 ms at most.
   */
  double GetResidency();
  /** Of the latest state: its number since Start, and its time (s). */
  vtkIdType GetTick();
  double GetTime();

  /**
   * Every state since the last call, oldest first, as rows of a table that is overwritten: columns Time (s), Tick,
   * NormalForce, FrictionForce, DragForce (N), SurfaceValue, Contact, Armed, Fault, Residency, and with three
   * components Tip, Proxy (world), Force (computed) and Command (sent; N, world axes). The first call begins to
   * keep states. Where nobody calls for 100000 ticks, the oldest are dropped. Each reader, by a number of its own,
   * gets all; nullptr ends it. vtkInteractorStyleHaptic is number 0, and further ones on the same device have the
   * numbers below: see AddReader.
   */
  void DrainStates(vtkTable* states, int reader = 0);

  ///@{
  /**
   * A number for DrainStates that AddReader has given to no other reader: 0, or if that is taken, -1, -2 and so on,
   * until RemoveReader, which ends the reading, too. Numbers above 0 are free for applications to choose from.
   */
  int AddReader();
  void RemoveReader(int reader);
  ///@}

  ///@{
  /**
   * Longest force (N) on the hand, at most the device's own maximum. Default, and with ResetMaximumForce again:
   * half of that, of any device that is opened.
   */
  void SetMaximumForce(double force);
  void ResetMaximumForce();
  vtkGetMacro(MaximumForce, double);
  ///@}

  ///@{
  /**
   * Largest growth of force (N/s), 1 or more. Default 500. A force that falls or turns falls at once: held back, it
   * would push the hand off a stiff wall with more energy than the hand brought along. For the same reason a wall that
   * is struck so fast that its force was held back stays softer until the tip leaves it or presses on.
   */
  void SetMaximumForceRate(double rate);
  vtkGetMacro(MaximumForceRate, double);
  ///@}

  ///@{
  /**
   * Let go when the program stands still, and with it whatever stops the device, such as a window that hangs: armed,
   * and without UpdateState, DrainStates, Publish, Arm or a new limit for so long (s), the servo fades the force out,
   * and a fault holds until Arm. 0.05 or more, default 2; 0 turns it off, for programs that seldom look.
   */
  void SetAttentionTime(double seconds);
  vtkGetMacro(AttentionTime, double);
  ///@}

  ///@{
  /**
   * Record every tick, with settings, units, device and a hash of the volume, until StopRecording writes it to a
   * .vtp, or to a .csv with what is not of a tick in a .csv.json beside it. A .vtp on port 1 of
   * vtkVolumeHapticsFilter gives the same forces to the bit, as long as nothing but the placement of the device
   * changed while it was made. Needs a running servo and a filter. A region (vtkHapticRegionFilter) is not
   * recorded, nor published during a recording: no one image could replay it.
   *
   * Meanwhile the ticks go to FILE.part, in memory there are never more than the last seconds. A .vtp takes 220 to
   * 250 bytes a tick, 15 MB a minute at 1 kHz, and while it is written FILE.part takes two thirds of that beside
   * it. StartRecording is false, with an error, where the file can't be written. Where that shows later, as on a
   * full disk, GetStatusText says so from then on, and the next UpdateState gives an error. StopRecording is false,
   * with an error, unless all ticks that were collected are in the file; a file that was there before is replaced only
   * by one that holds them all. Ticks that a busy machine or a slow disk kept from being collected give a warning, and
   * are counted in the field array LostTicks.
   */
  bool StartRecording(const char* file);
  bool StopRecording();
  ///@}
  /**
   * Make a .vtp or .csv of the FILE.part that a recording left which StopRecording could not write, or whose program
   * died: all that the disk took. What a dead program had yet to write is missing, as a rule less than 600 ticks, and up
   * to 16500 where the disk made it wait. The part is then removed, unless its file system has no locks, which would
   * tell that no program writes to it. It stays where this is false, with an error; if it can't be read to its end, the
   * file gets what comes before, if none was there. Needs neither a device nor a volume.
   */
  bool RecoverRecording(const char* part, const char* file);

  ///@{
  /**
   * How well the servo keeps time, since Start or ResetStatistics: ticks per second; the duration (s) that a
   * percentage p (0 to 100) of ticks, or of wake-ups after their time, stayed below, to 1/8 of it; ticks that were
   * left out because the loop was late; ticks whose force was held back since the data around the tip were not here
   * (GetResidency); and ticks that solver PRECISE could not finish (a tip that jumps by tens of voxels), which the
   * next ones did.
   */
  double GetTickRate();
  double GetTickPercentile(double p);
  double GetWakePercentile(double p);
  vtkIdType GetMissedTicks();
  vtkIdType GetAbsentTicks();
  vtkIdType GetUnfinishedTicks();
  void ResetStatistics();
  ///@}

protected:
  vtkHapticDevice();
  ~vtkHapticDevice() override;

  double ServoRate = 1000.0;
  double MaximumForce = 0.0;
  double MaximumForceRate = 500.0;
  double AttentionTime = 2.0;
  double WantedForce = -1.0; // what SetMaximumForce was given; negative: half of the device's

private:
  vtkHapticDevice(const vtkHapticDevice&) = delete;
  void operator=(const vtkHapticDevice&) = delete;

  void SendLimits();
  void TakeLimits();
  void Shut();
  void Halt();
  void AnnounceDisarmed();
  void TellRecordingTrouble();
  bool BeginRecording(const std::string& name);
  bool EndRecording(bool isAnnounced);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
