// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShuffledHead_h
#define ShuffledHead_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

/// Returns the same head at the same place with its voxels in another order: index (k, -j, -i), a
/// left-handed frame.
vtkSmartPointer<vtkImageData> ShuffleHead(vtkImageData* head);

/// Write the shuffled head with its orientation in the file's header, and return the file's name.
/// The NRRD `space` is left-posterior-superior, right-anterior-superior or left-anterior-superior.
/// The NIfTI file stores numbers that slope and intercept convert into the values.
std::string WriteMetaImage(const std::string& folder, vtkImageData* shuffled);
std::string WriteNrrd(const std::string& folder, vtkImageData* shuffled, const std::string& space);
std::string WriteNifti(
  const std::string& folder, vtkImageData* shuffled, double slope, double intercept);

#endif
