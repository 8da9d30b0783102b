// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture with a head phantom and a device in front of its face, as in an application. */
#ifndef PhantomRig_h
#define PhantomRig_h

#include "Rigs/DeviceRig.h"

#include <vtkXMLImageDataReader.h>

namespace emulated
{
using devicetest::Eventually;
using devicetest::Length;

inline constexpr double SkinValue = -300.0; ///< value (HU) half-way between air and skin

/** A filter on the phantom, and the position of the skin on a line into the face. */
class Phantom
{
public:
  Phantom()
  {
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(HEAD_PHANTOM);
    reader->Update();
    this->Image = reader->GetOutput();
    this->Filter->SetInputData(0, this->Image);
    this->Filter->GetProperty()->ApplyPreset("CT contrast");
    this->Skin = this->ComputeSkin(0.0, Height);
  }

  /**
   * Returns a placement with its origin on the skin. One axis of the device (0 to 2), or its
   * opposite (a sign of -1), points out of the face.
   */
  vtkSmartPointer<vtkMatrix4x4> Place(int outward, double sign) const
  {
    auto place = vtkSmartPointer<vtkMatrix4x4>::New();
    // The chosen axis points out of the face, which is -y in the world. The other axes follow in
    // cyclic order; their signs prevent mirroring.
    const double axes[3][3] = { { 0.0, -sign, 0.0 }, { 0.0, 0.0, sign }, { -1.0, 0.0, 0.0 } };
    for (int i = 0; i < 3; ++i)
    {
      for (int row = 0; row < 3; ++row)
      {
        place->SetElement(row, (outward + i) % 3, 1000.0 * axes[i][row]);
      }
    }
    place->SetElement(1, 3, this->Skin);
    place->SetElement(2, 3, Height);
    return place;
  }
  /** Returns how far (mm) a point in world coordinates is inside the skin, near the line. */
  double DepthOf(const double point[3]) const { return point[1] - this->Skin; }
  /** Returns how much deeper (mm) the skin is at these distances (mm) from the line. */
  double SkinBehind(double x, double z) const
  {
    return this->ComputeSkin(x, Height + z) - this->Skin;
  }

  vtkNew<vtkVolumeHapticsFilter> Filter;

private:
  static constexpr double Height = 60.0; // height of the line (mm)

  double ComputeSkin(double x, double z) const
  {
    double point[3] = { x, -115.0, z };
    while (point[1] < 0.0 && this->ValueAt(point) <= SkinValue)
    {
      point[1] += 0.1;
    }
    return point[1];
  }
  /** Returns the value at a point, interpolated between the eight surrounding voxels. */
  double ValueAt(const double point[3]) const
  {
    int index[3];
    double part[3];
    this->Image->ComputeStructuredCoordinates(point, index, part);
    double value = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      int at[3];
      double fraction = 1.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const int step = (corner >> axis) & 1;
        at[axis] = index[axis] + step;
        fraction *= step == 1 ? part[axis] : 1.0 - part[axis];
      }
      value += fraction * this->Image->GetScalarComponentAsDouble(at[0], at[1], at[2], 0);
    }
    return value;
  }

  vtkSmartPointer<vtkImageData> Image;
  double Skin = 0.0;
};

/** An application's device, with the status that the user sees. */
class PhantomHand
{
public:
  PhantomHand(const Phantom& phantom, int outward, double sign)
  {
    // Disable the attention time: a test calls one device at a time, and the other one must keep
    // its force.
    this->Device->SetAttentionTime(0.0);
    this->Device->SetVolumeHaptics(phantom.Filter);
    this->Device->SetDeviceToWorld(phantom.Place(outward, sign));
  }
  template <typename F>
  bool Wait(F&& holds)
  {
    return Eventually(
      [&]
      {
        this->Device->UpdateState();
        return holds();
      });
  }
  bool WaitFor(int status)
  {
    return this->Wait([&] { return this->Device->GetStatus() == status; });
  }
  bool WaitTicks(vtkIdType ticks)
  {
    this->Device->UpdateState();
    const vtkIdType end = this->Device->GetState()->GetTick() + ticks;
    return this->Wait([&] { return this->Device->GetState()->GetTick() >= end; });
  }
  bool Says(const char* words)
  {
    return this->Device->GetStatusText().find(words) != std::string::npos;
  }

  vtkNew<vtkHapticDevice> Device;
};

} // namespace emulated

#endif
