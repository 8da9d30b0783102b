// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRemoval
 * @brief   the tissue that a vtkHapticBurr has removed from a volume
 *
 * vtkVolumeHapticsFilter::GetRemoval() has it. It is the share rho of tissue that remains at each
 * sample of the volume on port 0, 255 for all of it. What is felt is
 *
 *   V' = V - (1 - rho/255) (V - AirValue),
 *
 * while the samples V stay as they are. Only where tissue was removed it needs memory: 12 MB for up
 * to 16384 bricks of 8 x 8 x 8 samples. If all are in use, IsUsedUp() tells so, and nothing more is
 * removed.
 *
 * A stroke begins when a burr removes something, and ends when it no longer spins or has removed
 * nothing for half a second. Undo(), Redo() and Reset() are carried out by the servo that ticks
 * with the burr, within some ticks in which nothing is felt; without one, at once. Strokes of
 * before a recording, and of before ReadFile(), can't be undone.
 *
 * One vtkHapticDevice at a time may tick with a removal: give the filter of another one a removal
 * of its own with vtkVolumeHapticsFilter::SetRemoval(). Shares are of the samples of one extent: a
 * volume with another one can't be felt until Reset() or SetRemoval(nullptr). But what ReadFile()
 * has read goes with any part of its volume, or a larger one, as long as it is not changed. While a
 * volume moves, all of its tissue is there.
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
   * Whether the AirValue follows from the volume, as long as nothing is removed: 2 % of a few
   * thousand samples spread over it are less, or more if the solid is below the contact value. A
   * file has that of its volume. If the volume is padded with a value that is not air, such as
   * -3024, SetAirValue() is needed. Default: on.
   */
  vtkSetMacro(AutoAirValue, bool);
  vtkGetMacro(AutoAirValue, bool);
  vtkBooleanMacro(AutoAirValue, bool);
  ///@}

  ///@{
  /**
   * The value of a sample without tissue, such as -1000 in a CT; or the one that was found. Setting
   * it turns AutoAirValue off.
   */
  void SetAirValue(double value);
  vtkGetMacro(AirValue, double);
  ///@}

  ///@{
  /**
   * Undo takes the last stroke back, Redo does it again, Reset brings all tissue back and can't be
   * undone. Each returns false if there is nothing to do, or too many of these wait.
   */
  bool Undo();
  bool Redo();
  bool Reset();
  ///@}
  ///@{
  /** How many strokes can be undone and redone. */
  int GetNumberOfUndos();
  int GetNumberOfRedos();
  ///@}
  /**
   * The volume (mm^3 of the hand's space) that was removed since the beginning, ReadFile() or
   * ReadTrace(), less what was undone.
   */
  double GetRemovedVolume();
  /** Whether all tissue is there. */
  bool IsEmpty();
  /** Whether tissue could not be removed because the memory is used up. */
  bool IsUsedUp();
  /** How many of Undo(), Redo() and Reset() wait or are carried out. */
  int GetNumberOfRequests();

  /**
   * In the information of an array that is shown instead of the touched one, such as a copy of it
   * in which a head rest is hidden: the touched array. Then a scene shows what was removed of the
   * shown array, too, by the same shares and AirValue:
   *
   *   shown->GetInformation()->Set(vtkHapticRemoval::TOUCHED_ARRAY(), touched);
   *
   * Both have the same number of values and components. The key keeps the touched array.
   */
  static vtkInformationObjectBaseKey* TOUCHED_ARRAY();

  /**
   * Makes an image of the shares, VTK_UNSIGNED_CHAR, with the geometry of the volume; without
   * scalars as long as there was no tick with a burr. It has the volume's size: one byte a sample.
   */
  void MakeShares(vtkImageData* shares);

  ///@{
  /**
   * Writes the shares to a .vti file, and reads them. The file has the part of the volume from
   * which something was removed, and is replaced as a whole: if the disk is full, the old one
   * stays. False, after an error, if that is not possible; then nothing has changed. What was read
   * is felt on any volume whose samples lie where those of the file's volume do: one that was
   * cropped or padded since has the same hole at the same place.
   */
  bool WriteFile(const std::string& file);
  bool ReadFile(const std::string& file);
  ///@}

  /**
   * Takes over what a burr has removed at the end of the only path of a trace of
   * vtkVolumeHapticsFilter. False, after an error, if there is none, or no model of the volume was
   * made yet.
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
