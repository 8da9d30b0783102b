// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticSegmentationReader
 * @brief   reads a segmentation of 3D Slicer or VolView (.seg.nrrd), overlapping segments included
 *
 * Reads both the label image and the names and colours of its labels from one file:
 *
 *   vtkNew<vtkHapticSegmentationReader> reader;
 *   reader->SetFileName("Liver.seg.nrrd");
 *   filter->SetLabelConnection(reader->GetOutputPort());
 *   filter->SetLabelTable(reader->GetLabelTable());
 *
 * The output has one label (int) a voxel. Overlapping segments are in layers, which vtkNrrdReader
 * doesn't read: where segments overlap, the last of them in the file counts, as in 3D Slicer.
 * Labels are the values of the file; if two segments of different layers share a value, segment N
 * has the label N + 1 (see vtkHapticLabelTable::ReadFile). Any other label map in a NRRD file is
 * read as well.
 *
 * Origin, spacing and direction are those of the file, converted to left-posterior-superior. Some
 * of VTK's readers ignore a file's directions; an image from such a reader lies elsewhere.
 *
 * A file that can't be read gives one error that names the file and the cure, and an empty output.
 *
 * @sa vtkHapticLabelTable, vtkVolumeHapticsFilter
 */
#ifndef vtkHapticSegmentationReader_h
#define vtkHapticSegmentationReader_h

#include "vtkImageAlgorithm.h"
#include "vtkNew.h"                 // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for ivars
#include <string> // for std::string

class vtkHapticLabelTable;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticSegmentationReader : public vtkImageAlgorithm
{
public:
  static vtkHapticSegmentationReader* New();
  vtkTypeMacro(vtkHapticSegmentationReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file. Default: none.
   */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

  /**
   * Get the names and colours of the labels, which are known after UpdateInformation(). It is
   * always the same table, to which you may add materials: reading again does not remove them.
   */
  vtkHapticLabelTable* GetLabelTable();

protected:
  vtkHapticSegmentationReader();
  ~vtkHapticSegmentationReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string FileName;
  vtkNew<vtkHapticLabelTable> LabelTable;

private:
  vtkHapticSegmentationReader(const vtkHapticSegmentationReader&) = delete;
  void operator=(const vtkHapticSegmentationReader&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
