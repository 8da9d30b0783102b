// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHapticLargeFile
 * @brief   a volume in a file that is larger than memory, as ParaView sees it
 *
 * The output is an image of the whole volume with coarse voxels, which ParaView shows and filters
 * as any other. A Volume Haptics filter with this as its Input feels the file itself: its
 * connection is led to a vtkHapticRegionSource, along paths as under a hand, so that nothing is
 * felt coarsely but where samples are late.
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

  /** The volume in the file, for paths. The file is opened when it is used. */
  vtkHapticRegionSource* GetRegions();

  /** The same for a hand, which has its own; null, with an error, if the file can't be opened. */
  vtkSmartPointer<vtkHapticRegionSource> MakeRegions();

  /** Open the file if that was not tried since this was modified. False if that failed. */
  bool Open();
  /** When it was opened last. */
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
  vtkTimeStamp Opened; // when that was tried
  bool IsOpen = false;

  vtkPVHapticLargeFile(const vtkPVHapticLargeFile&) = delete;
  void operator=(const vtkPVHapticLargeFile&) = delete;
};

#endif
