// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The scans that Testing/evaluate.sh fetches.
 */
#ifndef Evaluation_Scans_h
#define Evaluation_Scans_h

#include "NeedlePaths.h"

#include "vtkSmartPointer.h"

class vtkImageData;

namespace evaluation
{

/** The scans to measure. Scans that are not available are null or empty. */
struct Scans
{
  vtkSmartPointer<vtkImageData> Head; ///< Hounsfield units
  vtkSmartPointer<vtkImageData> Chest;
  vtkSmartPointer<vtkImageData> ChestLabels; ///< labels on the voxels of Chest
  LabelNames Names;                          ///< names of these labels
  vtkSmartPointer<vtkImageData> Mri;         ///< T1, 0 to 255
};

/**
 * Reads any volume that the explorer can read. Returns null, with a message on stderr, on failure.
 */
vtkSmartPointer<vtkImageData> ReadScan(const std::string& file);

/**
 * Reads the CT (cxr.nii.gz), the labels (mask.nii.gz) and their names (structures.csv) of a folder.
 * Returns false, with a message on stderr, if any of them can't be read.
 */
bool ReadChest(const std::string& folder, Scans& scans);

} // namespace evaluation

#endif
