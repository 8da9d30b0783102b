// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRecorder
 * @brief   records every tick of a device
 *
 * Records what a hand does and feels, tick by tick, to a file that replays to the bit:
 *
 *   device->Start();                         // a filter is felt
 *   vtkHapticRecorder* recorder = device->GetRecorder();
 *   recorder->Start("touch.vtp");
 *   ... the hand moves; in the GUI's timer: device->UpdateState() ...
 *   recorder->Stop();                        // the file is complete now
 *   ... "replay:touch.vtp" is a device, and the file a path for vtkVolumeHapticsFilter ...
 *
 * @sa vtkHapticDevice, vtkHapticPathSource
 */
#ifndef vtkHapticRecorder_h
#define vtkHapticRecorder_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
struct DeviceParts;
} // namespace VolumeHaptics
#endif

class vtkHapticDevice;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticRecorder : public vtkObject
{
public:
  static vtkHapticRecorder* New();
  vtkTypeMacro(vtkHapticRecorder, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Record every tick, with settings, units, device and a hash of the volume, until Stop writes it
   * to a .vtp, or to a .csv with all data that do not belong to a tick in a .csv.json beside it. On
   * port 1 of vtkVolumeHapticsFilter a .vtp gives the same forces to the bit, as long as only the
   * placement of the device changed during the recording. Needs a running servo and a filter. A
   * region (vtkHapticRegionFilter) is not recorded, nor published during a recording: no single
   * image could replay it.
   *
   * The recording begins at once, however large the volume is. The hashes of volume and labels are
   * computed during the recording, from the values at that time; vtkHapticDevice::UpdateState hands
   * them to the recording, and its GetStatusText reports their progress. Stop waits up to 10 s for
   * them, but not while the device is armed. If they are still not known, VolumeHash is empty, a
   * replay is not refused for its labels, and a warning says so.
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
   * and FILE.part up to about two thirds of that, beside the .vtp while it is written. Start
   * returns false and reports an error if the file can't be written. If writing fails later, for
   * example because the disk is full, the next UpdateState gives an error, and GetStatusText says
   * so from then on.
   *
   * Stop returns false and reports an error unless the file holds all ticks that were collected. It
   * replaces an existing file only with a complete one. If a busy machine or a slow disk kept ticks
   * from being collected, Stop gives a warning, and the field array LostTicks has their number.
   */
  bool Start(const char* file);
  bool Stop();
  ///@}
  /**
   * Make a .vtp or .csv from a FILE.part that was left because Stop failed or the program
   * died. The file gets all ticks that reached the disk; after a crash usually fewer than 600 of
   * the last ticks are missing, and up to 16500 if the disk was slow. FILE.part is then removed,
   * except on a file system without locks, where another program might still write to it. On
   * failure, returns false with an error, and keeps FILE.part. If FILE.part can't be read to its
   * end, that is an error, too, but the ticks before the damage are written unless the file exists
   * already. Needs neither a device nor a volume.
   */
  bool Recover(const char* part, const char* file);

  /** Get the file of the recording in progress; empty without one. */
  std::string GetFileName();

protected:
  vtkHapticRecorder();
  ~vtkHapticRecorder() override;

private:
#ifndef __VTK_WRAP__
  friend class vtkHapticDevice;
  friend struct VolumeHaptics::DeviceParts;

  /** Returns the device. Without a device, reports an error and returns null. */
  vtkHapticDevice* FindDevice();
  void Attach(VolumeHaptics::DeviceParts& parts);
  void Detach();
  /**
   * Adds the volume's hashes to the recording once they are computed, and reports errors; call this
   * often.
   */
  void Update();
  /** Writes the file of a recording in progress, if any, without announcing long work. */
  void Finish();

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals; // null without a device
#endif

  vtkHapticRecorder(const vtkHapticRecorder&) = delete;
  void operator=(const vtkHapticRecorder&) = delete;
};

#endif
