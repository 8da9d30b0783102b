// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Uses a head of 101 x 51 x 31 samples of 0.5 mm, whose first sample is at (-20, 5, 100) mm. The
 * expected planes are computed by hand from UpdateMapperParameters() of
 * vtkImageVolumeRepresentation.cxx, in ParaView v5.11.0 and v5.12.1 (DataBounds) and in v5.13.0,
 * v5.13.3 and v6.0.0 (WholeExtent).
 */

#include "HapticCropPlanes.h"

#include <cstdio>
#include <cstdlib>

using namespace VolumeHapticsLive;

namespace
{
void Expect(bool isSo, const char* what)
{
  if (!isSo)
  {
    std::fprintf(stderr, "FAILED: %s\n", what);
    std::exit(1);
  }
}

void ExpectPlanes(CropBase base, const double (&wanted)[6], const char* what)
{
  const double bounds[6] = { -20.0, 30.0, 5.0, 30.0, 100.0, 115.0 };
  const int extent[6] = { 0, 100, 0, 50, 0, 30 };
  const double origin[3] = { -20.0, 5.0, 107.5 };
  const double scale[3] = { 0.5, 0.25, 0.25 };
  double planes[6];
  ComputeCropPlanes(base, bounds, extent, origin, scale, planes);
  for (int i = 0; i < 6; ++i)
  {
    Expect(planes[i] == wanted[i], what);
  }
}
} // namespace

int main()
{
  ExpectPlanes(CropBase::Bounds, { -30.0, -5.0, 6.25, 12.5, 132.5, 136.25 }, "bounds");
  ExpectPlanes(CropBase::WholeExtent, { -20.0, 30.0, 5.0, 17.5, 107.5, 115.0 }, "whole extent");
  Expect(ChooseCropBase(5, 11) == CropBase::Bounds, "5.11");
  Expect(ChooseCropBase(5, 12) == CropBase::Bounds, "5.12");
  Expect(ChooseCropBase(5, 13) == CropBase::WholeExtent, "5.13");
  Expect(ChooseCropBase(6, 0) == CropBase::WholeExtent, "6.0");
  Expect(ChooseCropBase(6, 1) == CropBase::WholeExtent, "6.1");
  return 0;
}
