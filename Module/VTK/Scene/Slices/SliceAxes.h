// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The layout of slices along the three axes of an image on the screen.
 */
#ifndef SliceAxes_h
#define SliceAxes_h

#include <array>

class vtkImageData;

namespace VolumeHaptics
{

/** An index axis of an image, forwards (1) or backwards (-1). */
struct SignedAxis
{
  int Axis = 0;
  int Sign = 1;
};

/** The layout of one slice on the screen. */
struct SliceAxes
{
  SignedAxis Through; ///< direction of a step of the wheel
  SignedAxis Right;   ///< right on the screen
  SignedAxis Up;
  const char* Name = "";                              ///< "Axial", or the name of an index, "k"
  std::array<const char*, 4> Sides{ "", "", "", "" }; ///< left, right, bottom, top
};

/**
 * The slices along the index axes k, j and i of an image. If the world's axes point to a patient's
 * left, back and head: the axial, coronal and sagittal slice as radiologists look at them, each
 * along the index axis nearest to the world's axis.
 */
std::array<SliceAxes, 3> FindSliceAxes(vtkImageData* image, bool anatomical);

} // namespace VolumeHaptics

#endif
