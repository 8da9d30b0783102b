// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHapticLargeFile
 * @brief   a source for ParaView: a volume in a file that is larger than memory
 *
 * The output is an image of the whole volume with coarse voxels, which ParaView shows and filters
 * like any image. A Volume Haptics filter with this Input feels the file itself in full resolution:
 * it is connected to a vtkHapticRegionSource, for paths and for a hand. Only samples that have not
 * been read in time are felt coarsely.
 *
 * @sa vtkHapticRegionSource
 */
#ifndef vtkPVHapticLargeFile_h
#define vtkPVHapticLargeFile_h

#include "VolumeHapticsFiltersModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for ivars

#include <string> // for std::string

class vtkAlgorithmOutput;
class vtkHapticRegionSource;

class VOLUMEHAPTICSFILTERS_EXPORT vtkPVHapticLargeFile : public vtkImageAlgorithm
{
public:
  static vtkPVHapticLargeFile* New();
  vtkTypeMacro(vtkPVHapticLargeFile, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file, in a format that vtkHapticRegionSource::OpenFile() reads. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The number of a channel, a time or a component of a file with several, from 1 on. 0 (default):
   * the first one.
   */
  vtkSetClampMacro(Series, int, 0, VTK_INT_MAX);
  vtkGetMacro(Series, int);
  ///@}

  /**
   * Returns what was guessed, omitted or rotated when the file was opened, one item per line; empty
   * if there is nothing.
   */
  const char* GetNotes();

  /**
   * Returns the large file from which a connection comes, directly or through ParaView's own
   * filters; null if there is none.
   */
  static vtkPVHapticLargeFile* Find(vtkAlgorithmOutput* output);

  /** Returns the region source for paths. The first call opens the file. */
  vtkHapticRegionSource* GetRegions();

  /**
   * Makes a second region source, for the hand. If the file can't be opened, returns null and
   * reports an error.
   */
  vtkSmartPointer<vtkHapticRegionSource> MakeRegions();

  /**
   * Opens the file, unless this was already tried since the last change of a setting. Returns
   * whether the file is open.
   */
  bool Open();
  /** Returns the time of the last attempt to open the file. */
  vtkMTimeType GetOpenTime() const { return this->Opened; }

protected:
  vtkPVHapticLargeFile();
  ~vtkPVHapticLargeFile() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  class Regions;

  char* FileName = nullptr;
  int Series = 0;
  vtkSmartPointer<Regions> Volume;
  std::string Notes;
  vtkTimeStamp Opened; // time of the last attempt to open the file
  bool IsOpen = false;

  vtkPVHapticLargeFile(const vtkPVHapticLargeFile&) = delete;
  void operator=(const vtkPVHapticLargeFile&) = delete;
};

#endif
