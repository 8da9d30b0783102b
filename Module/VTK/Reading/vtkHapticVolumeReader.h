// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticVolumeReader
 * @brief   reads a volume from a file or a folder, with its position and size in the patient
 *
 * Reads DICOM folders, slices and DICOMDIR, NIfTI and Analyze, NRRD, MetaImage, MGZ and MGH of
 * FreeSurfer, MINC 1, VTK images and grids, TIFF stacks, VTKHDF and Zarr. Every program of this
 * project reads its volumes with this class:
 *
 *   vtkNew<vtkHapticVolumeReader> reader;
 *   reader->SetFileName("scans/thorax");
 *   reader->Update();
 *   std::cout << reader->GetNotes();
 *   filter->SetInputConnection(reader->GetOutputPort());
 *
 * The output has one scalar per voxel. Its lengths are in millimetres if the file has a unit of
 * length. Its index axes are within 45 degrees of the axes of the world, which are
 * left-posterior-superior if the file is about a patient. The notes describe, one per line, what
 * was guessed, dropped, filled, resampled or turned; the output's field data also has them, in the
 * string array "Notes". A moving volume has time steps. The labels of a segmentation have a table,
 * which is also in the output's field data.
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
class vtkImageData;
class vtkPolyData;

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
   * What to read if a file or folder has several: the number, counted from 1, of a series of a
   * DICOM folder, a segment of a segmentation, a mask of a folder of masks, a channel, a time, or a
   * component of the voxels. 0 (default): the series with most pixels, all segments, all times of a
   * NIfTI file as time steps, or the first one. GetSeriesName() lists what there is.
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
   * Whether the values are label numbers: numbers within 0.001 of whole ones are rounded,
   * others are an error, and the table has the names and colours from the file. The voxels stay in
   * the order of the file. Off (default): only a DICOM SEG, a NRRD file with segments and a folder
   * of masks have labels.
   */
  vtkSetMacro(AsLabels, bool);
  vtkGetMacro(AsLabels, bool);
  vtkBooleanMacro(AsLabels, bool);
  ///@}

  ///@{
  /**
   * GetNotes returns the notes, one per line; GetFormat the format, such as "NIfTI"; GetModality
   * the DICOM modality. Valid after UpdateInformation().
   */
  const char* GetNotes();
  const char* GetFormat();
  const char* GetModality();
  ///@}

  ///@{
  /**
   * Get the choices for SetSeries(), each with its number, such as `2 "Thorax", CT, 133 slices of
   * 512 x 512`, and the number that was read. Valid after UpdateInformation().
   */
  int GetNumberOfSeries();
  const char* GetSeriesName(int index);
  int GetSeriesNumber();
  ///@}

  /**
   * Get whether the file states the position of the volume; a NIfTI file may not. Valid after
   * UpdateInformation().
   */
  bool HasPlace();

  /** Get the table of the labels; nullptr if the file has none. Valid after UpdateInformation(). */
  vtkHapticLabelTable* GetLabelTable();

  /**
   * Returns warnings about labels, one per line: if no label is inside the volume, or if labels of
   * the table, which may be null, occur in no voxel.
   */
  static std::string DescribeLabels(
    vtkImageData* labels, vtkImageData* volume, vtkHapticLabelTable* table);

  /**
   * Reads points, lines and polygons of a .stl, .ply, .obj, .vtk or .vtp file into `surface`. On
   * failure, returns the reason and leaves `surface` unchanged; on success, returns an empty text.
   * If the program volumehaptics-read is installed, the file is read there, because damaged files
   * can crash VTK's readers.
   */
  static std::string ReadSurface(const char* file, vtkPolyData* surface);

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
