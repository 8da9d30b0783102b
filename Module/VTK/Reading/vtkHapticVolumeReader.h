// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticVolumeReader
 * @brief   reads a volume from a file or a folder, where and as large as it is in the patient
 *
 * Reads DICOM folders, slices and DICOMDIR, NIfTI and Analyze, NRRD, MetaImage, VTK images and
 * grids, TIFF stacks, VTKHDF and Zarr. Every program of this project reads its volumes so:
 *
 *   vtkNew<vtkHapticVolumeReader> reader;
 *   reader->SetFileName("scans/thorax");
 *   reader->Update();
 *   std::cout << reader->GetNotes();
 *   filter->SetInputConnection(reader->GetOutputPort());
 *
 * The output has one scalar a voxel, in millimetres if the file has a unit of length, and its index
 * axes are within 45 degrees of the axes of the world: left-posterior-superior for files that know
 * a patient. The notes tell, a line each, what was guessed, dropped, filled, resampled or turned;
 * the output's field data has them in the string array "Notes".
 * A volume that moves has its time steps. The labels of a segmentation have their table; the
 * output's field data has it, too.
 *
 * A file that can't be read gives one error that names the cause and the cure, and an empty output.
 * For volumes larger than memory, use vtkHapticRegionSource.
 *
 * @sa vtkHapticRegionSource, vtkHapticLabelTable, vtkHapticTimeStepSource
 */
#ifndef vtkHapticVolumeReader_h
#define vtkHapticVolumeReader_h

#include "vtkImageAlgorithm.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkHapticLabelTable;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticVolumeReader : public vtkImageAlgorithm
{
public:
  static vtkHapticVolumeReader* New();
  vtkTypeMacro(vtkHapticVolumeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file or the folder. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The number of a series of a DICOM folder, or of a volume along the fourth axis of a NIfTI file,
   * from 1 on. 0 (default): the series with most pixels, or all volumes as time steps. The notes
   * list what there is.
   */
  vtkSetClampMacro(Series, int, 0, VTK_INT_MAX);
  vtkGetMacro(Series, int);
  ///@}

  ///@{
  /**
   * The point array whose values, or the magnitude of whose vectors, are the scalars. Default: the
   * active scalars.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /**
   * Whether the values are numbers of labels: numbers within 0.001 of whole ones are rounded,
   * others are an error, and the table has the names and colours that the file has. The voxels stay
   * in the order of the file. Off (default): only a DICOM SEG has labels.
   */
  vtkSetMacro(AsLabels, bool);
  vtkGetMacro(AsLabels, bool);
  vtkBooleanMacro(AsLabels, bool);
  ///@}

  ///@{
  /**
   * From UpdateInformation() on: the notes, a line each, the format, such as "NIfTI", and DICOM's
   * modality.
   */
  const char* GetNotes();
  const char* GetFormat();
  const char* GetModality();
  ///@}

  ///@{
  /**
   * From UpdateInformation() on: the series of a DICOM folder, as
   * `2 "Thorax", CT, 133 slices of 512 x 512`, and the number of the one that was read.
   */
  int GetNumberOfSeries();
  const char* GetSeriesName(int index);
  int GetSeriesNumber();
  ///@}

  /**
   * Whether the file says where the volume lies; a NIfTI file may not. From UpdateInformation() on.
   */
  bool HasPlace();

  /** The table of the labels, from UpdateInformation() on; nullptr if the file has none. */
  vtkHapticLabelTable* GetLabelTable();

protected:
  vtkHapticVolumeReader();
  ~vtkHapticVolumeReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHapticVolumeReader(const vtkHapticVolumeReader&) = delete;
  void operator=(const vtkHapticVolumeReader&) = delete;

  char* FileName = nullptr;
  int Series = 0;
  std::string ArrayName;
  bool AsLabels = false;
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
