// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The frequency of a volume's values and gradient magnitudes together: edges are arcs in it.
 */
#ifndef EdgeHistogram_h
#define EdgeHistogram_h

#include <vector>

class vtkImageData;

namespace VolumeHaptics
{

struct EdgeHistogram
{
  static constexpr int Columns = 128; ///< of values, from Values[0] to Values[1]
  static constexpr int Rows = 64;     ///< of gradient magnitudes, from 0 to MostSlope

  double Values[2] = { 0.0, 1.0 };
  double MostSlope = 1.0; ///< scalar units per world unit
  /**
   * Row by row from gradient 0 on: log(1 + count) as a share of the largest one beyond the lowest
   * gradients, at most 1; empty without data.
   */
  std::vector<double> Shares;
};

/**
 * Fills the Shares from some hundred thousand voxels of a component of the scalars, with the
 * gradients of a kernel. Larger gradients do not count.
 */
void CountEdges(vtkImageData* image, int component, int kernelRadius, EdgeHistogram& histogram);

/** How long that takes, approximately (s). */
double EstimateEdgeTime(int kernelRadius);

} // namespace VolumeHaptics

#endif
