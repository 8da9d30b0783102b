// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShuffledHead_h
#define ShuffledHead_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

/// The same head at the same place, with its voxels stored in another order: index (k, -j, -i),
/// which is a left-handed frame.
vtkSmartPointer<vtkImageData> ShuffleHead(vtkImageData* head);

/// Write the shuffled head with its frame in the file's header, and return the file's name. The
/// NRRD space is one of left-posterior-superior, right-anterior-superior and
/// left-anterior-superior. The NIfTI file stores numbers of which slope and intercept make the
/// values.
std::string WriteMetaImage(const std::string& folder, vtkImageData* shuffled);
std::string WriteNrrd(const std::string& folder, vtkImageData* shuffled, const std::string& space);
std::string WriteNifti(
  const std::string& folder, vtkImageData* shuffled, double slope, double intercept);

#endif
