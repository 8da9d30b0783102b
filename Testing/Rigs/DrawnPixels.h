// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Reads back the pixels of a window as numbers. */
#ifndef DrawnPixels_h
#define DrawnPixels_h

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <vector>

namespace apitest
{
/// Returns the red, green and blue levels (0 to 255) of each pixel of a rectangle, including its
/// corners.
inline std::vector<double> ReadPixels(
  vtkRenderWindow* window, int left, int bottom, int right, int top)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(left, bottom, right, top, 0, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

/// Returns the mean absolute difference between two pictures' levels.
inline double ComputeMeanDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += std::abs(a[i] - b[i]);
  }
  return sum / static_cast<double>(a.size());
}
} // namespace apitest

#endif
