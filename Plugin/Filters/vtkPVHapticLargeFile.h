// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHapticLargeFile
 * @brief   a volume in a file that is larger than memory, as ParaView sees it
 *
 * The output is an image of the whole volume with coarse voxels, which ParaView shows and filters
 * like any image. A Volume Haptics filter with this Input feels the file itself: the filter is
 * connected to a vtkHapticRegionSource, for paths and for a hand. Only late samples are felt
 * coarsely.
 *
 * @sa vtkHapticRegionSource
 */
#ifndef vtkPVHapticLargeFile_h
#define vtkPVHapticLargeFile_h

#include "VolumeHapticsFiltersModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for ivars

class vtkAlgorithmOutput;
class vtkHapticRegionSource;

class VOLUMEHAPTICSFILTERS_EXPORT vtkPVHapticLargeFile : public vtkImageAlgorithm
{
public:
  static vtkPVHapticLargeFile* New();
  vtkTypeMacro(vtkPVHapticLargeFile, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** A file as vtkHapticRegionSource::OpenFile() reads it. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** The large file that a connection comes from, also through ParaView's own filters; or null. */
  static vtkPVHapticLargeFile* Find(vtkAlgorithmOutput* output);

  /** The volume in the file, for paths. The file is opened at first use. */
  vtkHapticRegionSource* GetRegions();

  /**
   * A source of the hand's own for the volume in the file; null, with an error, if the file can't
   * be opened.
   */
  vtkSmartPointer<vtkHapticRegionSource> MakeRegions();

  /** Open the file, unless that was tried since this was modified. False if that failed. */
  bool Open();
  /** The time of the last opening. */
  vtkMTimeType GetOpenTime() const { return this->Opened; }

protected:
  vtkPVHapticLargeFile();
  ~vtkPVHapticLargeFile() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  class Regions;

  char* FileName = nullptr;
  vtkSmartPointer<Regions> Volume;
  vtkTimeStamp Opened; // time of the last try
  bool IsOpen = false;

  vtkPVHapticLargeFile(const vtkPVHapticLargeFile&) = delete;
  void operator=(const vtkPVHapticLargeFile&) = delete;
};

#endif
