// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The values that the axis of a chart shows for the scalars of an image.
 */
#ifndef HapticValueScale_h
#define HapticValueScale_h

namespace VolumeHaptics
{

/** The scale of vtkHapticProperty: (scalar + Shift) Scale. By default, the scalars themselves. */
struct ValueScale
{
  double Shift = 0.0;
  double Scale = 1.0;

  double operator()(double scalar) const { return (scalar + this->Shift) * this->Scale; }
  friend bool operator==(const ValueScale& a, const ValueScale& b)
  {
    return a.Shift == b.Shift && a.Scale == b.Scale;
  }
};

} // namespace VolumeHaptics

#endif
