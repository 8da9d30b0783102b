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
  /** The file, in a format that vtkHapticRegionSource::OpenFile() reads. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Returns the large file that a connection comes from, also through ParaView's own filters; or
   * null.
   */
  static vtkPVHapticLargeFile* Find(vtkAlgorithmOutput* output);

  /** Returns the volume in the file, for paths. Opens the file at the first call. */
  vtkHapticRegionSource* GetRegions();

  /**
   * Returns a second source of the volume in the file, for the hand; null, with an error, if the
   * file can't be opened.
   */
  vtkSmartPointer<vtkHapticRegionSource> MakeRegions();

  /** Opens the file, unless this was tried since the last change of a setting. False on failure. */
  bool Open();
  /** Returns when the file was opened last. */
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
  vtkTimeStamp Opened; // when opening was tried last
  bool IsOpen = false;

  vtkPVHapticLargeFile(const vtkPVHapticLargeFile&) = delete;
  void operator=(const vtkPVHapticLargeFile&) = delete;
};

#endif
