// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Removes tissue from images with loops over their samples, and writes the removed tissue in the
 * file format that vtkHapticRemoval::WriteFile() documents.
 */
#ifndef RemovalRig_h
#define RemovalRig_h

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkHapticRemoval.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <unistd.h>

namespace removaltest
{
/// A ball of removed tissue, whose edge is three samples wide (FRONTIER 3.3).
struct Hole
{
  double Middle[3]; ///< index of the centre
  double Radius;    ///< radius in samples

  unsigned char GetFraction(int i, int j, int k) const
  {
    const double from = std::sqrt((i - this->Middle[0]) * (i - this->Middle[0]) +
      (j - this->Middle[1]) * (j - this->Middle[1]) +
      (k - this->Middle[2]) * (k - this->Middle[2]));
    return static_cast<unsigned char>(
      std::lround(255.0 * std::clamp(0.5 + (from - this->Radius) / 3.0, 0.0, 1.0)));
  }
};

/// Returns the remaining value V' = V - (1 - rho) (V - V_air) for a fraction of rho = `fraction` /
/// 255.
inline double LeftOf(double value, double fraction, double air)
{
  return value - (1.0 - fraction / 255.0) * (value - air);
}

/// Loads the fractions of a hole into a removal through a file. Returns false on failure.
inline bool LoadHole(vtkHapticRemoval* removal, vtkImageData* volume, const Hole& hole, double air)
{
  // Use a unique file name, because tests may run in parallel in one folder.
  const std::string file = "LoadedHole" + std::to_string(getpid()) + ".vti";
  const int* const extent = volume->GetExtent();
  vtkNew<vtkImageData> image;
  image->CopyStructure(volume);
  vtkNew<vtkUnsignedCharArray> fractions;
  fractions->SetName("RemainingShares");
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        fractions->InsertNextValue(hole.GetFraction(i, j, k));
      }
    }
  }
  image->GetPointData()->SetScalars(fractions);
  vtkNew<vtkIntArray> whole;
  whole->SetName("VolumeExtent");
  whole->SetNumberOfComponents(6);
  whole->InsertNextTypedTuple(extent);
  image->GetFieldData()->AddArray(whole);
  vtkNew<vtkDoubleArray> value;
  value->SetName("AirValue");
  value->InsertNextValue(air);
  image->GetFieldData()->AddArray(value);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  const bool isRead = writer->Write() == 1 && removal->ReadFile(file);
  std::remove(file.c_str());
  return isRead;
}

/// Returns a copy of an image, with the hole removed from one component. Each sample has the mean
/// fraction of a cube of samples in a volume that begins at `first` and is `step` times as fine.
inline vtkSmartPointer<vtkImageData> MakeLeft(
  vtkImageData* image, int component, const Hole& hole, double air, int step = 1)
{
  auto left = vtkSmartPointer<vtkImageData>::New();
  left->DeepCopy(image);
  vtkDataArray* const values = left->GetPointData()->GetScalars();
  const bool isWhole = values->GetDataType() != VTK_FLOAT && values->GetDataType() != VTK_DOUBLE;
  const int* const extent = image->GetExtent();
  vtkIdType at = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i, ++at)
      {
        double sum = 0.0;
        for (int n = 0; n < step * step * step; ++n)
        {
          sum += hole.GetFraction(
            step * i + n % step, step * j + n / step % step, step * k + n / (step * step));
        }
        const double value =
          LeftOf(values->GetComponent(at, component), sum / (step * step * step), air);
        values->SetComponent(at, component, isWhole ? std::round(value) : value);
      }
    }
  }
  return left;
}
} // namespace removaltest

#endif
