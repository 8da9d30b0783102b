// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRemoval
 * @brief   the tissue that a vtkHapticBurr has removed from a volume
 *
 * Stores how much tissue remains at each sample of the volume on port 0 of a filter, as a share
 * from 0 (none) to 255 (all):
 *
 *   vtkHapticRemoval* removal = filter->GetRemoval();
 *   removal->Undo();                  // the last stroke
 *   removal->WriteFile("cavity.vti");
 *
 * As its share falls, the felt value of a sample changes to the AirValue (equations:
 * Documentation/method.md, "The burr"). The samples stay unchanged. The shares need memory only
 * where tissue was removed: 12 MB for up to 16384 bricks of 8 x 8 x 8 samples. If all bricks are in
 * use, IsUsedUp() is true, and nothing more is removed.
 *
 * A stroke begins when a burr removes something, and ends when it no longer spins or has removed
 * nothing for half a second. The servo that ticks with the burr carries out Undo(), Redo() and
 * Reset(); this takes some ticks, and nothing is felt during them. Without a servo, the calls act
 * at once. Strokes before a recording, and before ReadFile(), can't be undone.
 *
 * One vtkHapticDevice at a time may tick with a removal. Another device feels what is removed after
 * vtkHapticDevice::UseToolOff(); or give its filter its own removal with
 * vtkVolumeHapticsFilter::SetRemoval(). Shares belong to the samples of one extent: a
 * volume with another extent can't be felt until Reset() or SetRemoval(nullptr). But shares that
 * ReadFile() has read fit any part of their volume, or a larger volume, as long as they are not
 * changed. While a volume moves, all of its tissue is there.
 *
 * @sa vtkHapticBurr vtkVolumeHapticsFilter
 */
#ifndef vtkHapticRemoval_h
#define vtkHapticRemoval_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkImageData;
class vtkInformationObjectBaseKey;
class vtkPolyData;

namespace VolumeHaptics
{
struct RemovalData;
}

class VTKVOLUMEHAPTICS_EXPORT vtkHapticRemoval : public vtkObject
{
public:
  static vtkHapticRemoval* New();
  vtkTypeMacro(vtkHapticRemoval, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the AirValue is computed from the volume, as long as nothing is removed: as the value
   * below which 2 % of a few thousand spread samples lie (above which, if the solid is below the
   * contact value). A file has the AirValue of its volume. If the volume is padded with a value
   * that is not air, such as -3024, SetAirValue() is needed. Default: on.
   */
  vtkSetMacro(AutoAirValue, bool);
  vtkGetMacro(AutoAirValue, bool);
  vtkBooleanMacro(AutoAirValue, bool);
  ///@}

  ///@{
  /**
   * The value of a sample without tissue, such as -1000 in a CT. While AutoAirValue is on, the
   * value that was found. Setting it turns AutoAirValue off.
   */
  void SetAirValue(double value);
  vtkGetMacro(AirValue, double);
  ///@}

  ///@{
  /**
   * Undo reverts the last stroke, Redo repeats it, and Reset restores all tissue and can't be
   * undone. Each returns false if there is nothing to undo, redo or reset, or if too many requests
   * are waiting.
   */
  bool Undo();
  bool Redo();
  bool Reset();
  ///@}
  ///@{
  /** Get how many strokes can be undone and redone. */
  int GetNumberOfUndos();
  int GetNumberOfRedos();
  ///@}
  /**
   * Get the volume (mm^3 of the hand's space) that was removed since the beginning or the last
   * ReadFile() or ReadTrace(), without undone strokes.
   */
  double GetRemovedVolume();
  /** Get whether nothing was removed, so that all tissue remains. */
  bool IsEmpty();
  /** Get whether a burr could not remove tissue because all memory for removed tissue is in use. */
  bool IsUsedUp();
  /** Get the number of calls of Undo(), Redo() and Reset() that are waiting or in progress. */
  int GetNumberOfRequests();

  /**
   * Names the touched array in the information of an array that is shown instead of it, such as a
   * copy without a head rest. A scene then shows the removal in this array, too, with the same
   * shares and AirValue:
   *
   *   shown->GetInformation()->Set(vtkHapticRemoval::TOUCHED_ARRAY(), touched);
   *
   * Both arrays have the same number of values and components. The information holds a reference to
   * the touched array.
   */
  static vtkInformationObjectBaseKey* TOUCHED_ARRAY();

  /**
   * Make an image of the shares, VTK_UNSIGNED_CHAR, with the geometry of the volume. It has one
   * byte for each sample of the volume, but no scalars before the first tick with a burr.
   */
  void MakeShares(vtkImageData* fractions);

  ///@{
  /**
   * Write the shares to a .vti file, and read them. The file contains the part of the volume from
   * which something was removed. An existing file is replaced only after the whole new one is on
   * the disk. On failure, both report an error, return false and change nothing. Shares from a file
   * are felt on any volume whose samples lie at the positions of the samples of the file's volume:
   * a volume that was cropped or padded since has the same hole at the same position.
   */
  bool WriteFile(const std::string& file);
  bool ReadFile(const std::string& file);
  ///@}

  /**
   * Set the shares to those at the end of a trace of vtkVolumeHapticsFilter with a single path.
   * Returns false and reports an error if the trace has no shares, or if no model of the volume has
   * been made yet.
   */
  bool ReadTrace(vtkPolyData* trace);

protected:
  vtkHapticRemoval();
  ~vtkHapticRemoval() override;

  bool AutoAirValue = true;
  double AirValue = 0.0;

private:
#ifndef __VTK_WRAP__
  friend struct VolumeHaptics::RemovalData;
  std::unique_ptr<VolumeHaptics::RemovalData> Data;
#endif

  vtkHapticRemoval(const vtkHapticRemoval&) = delete;
  void operator=(const vtkHapticRemoval&) = delete;
};

#endif
