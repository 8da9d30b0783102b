// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShuffledHead.h"

#include "VTK/Reading/VolumeOrientation.h"

#include "vtkDataArray.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNIFTIImageWriter.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <vtksys/FStream.hxx>

#include <iomanip>
#include <sstream>

namespace
{
std::string Write(const std::string& path, const std::string& header, vtkImageData* image)
{
  vtksys::ofstream file(path.c_str(), std::ios::out | std::ios::binary);
  file << header;
  file.write(static_cast<const char*>(image->GetScalarPointer()),
    static_cast<std::streamsize>(image->GetNumberOfPoints() * image->GetScalarSize()));
  return path;
}

std::string Triple(const double values[3], const char* separator)
{
  std::ostringstream text;
  text << std::setprecision(12) << values[0] << separator << values[1] << separator << values[2];
  return text.str();
}
} // namespace

vtkSmartPointer<vtkImageData> ShuffleHead(vtkImageData* head)
{
  const int* size = head->GetDimensions();
  const double* spacing = head->GetSpacing();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[2], size[1], size[0]);
  image->SetSpacing(spacing[2], spacing[1], spacing[0]);
  image->AllocateScalars(VTK_SHORT, 1);
  for (int i = 0; i < size[0]; ++i)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int k = 0; k < size[2]; ++k)
      {
        image->SetScalarComponentFromDouble(
          k, size[1] - 1 - j, size[0] - 1 - i, 0, head->GetScalarComponentAsDouble(i, j, k, 0));
      }
    }
  }
  double origin[3];
  head->TransformIndexToPhysicalPoint(size[0] - 1, size[1] - 1, 0, origin);
  const double axes[9] = { 0, 0, -1, 0, -1, 0, 1, 0, 0 };
  Explore::SetFrame(image, axes, origin);
  return image;
}

std::string WriteMetaImage(const std::string& folder, vtkImageData* shuffled)
{
  const std::string header = "ObjectType = Image\nNDims = 3\nBinaryData = True\n"
                             "BinaryDataByteOrderMSB = False\nTransformMatrix = 0 0 1 0 -1 0 -1 0 0"
                             "\nOffset = " +
    Triple(shuffled->GetOrigin(), " ") +
    "\nElementSpacing = " + Triple(shuffled->GetSpacing(), " ") +
    "\nDimSize = 64 64 64\nElementType = MET_SHORT\nElementDataFile = LOCAL\n";
  return Write(folder + "/head.mha", header, shuffled);
}

std::string WriteNrrd(const std::string& folder, vtkImageData* shuffled, const std::string& space)
{
  const double x = space[0] == 'l' ? 1.0 : -1.0;
  const double y = space.find("posterior") != std::string::npos ? 1.0 : -1.0;
  const double* spacing = shuffled->GetSpacing();
  const double* place = shuffled->GetOrigin();
  const double i[3] = { 0.0, 0.0, spacing[0] }, j[3] = { 0.0, -y * spacing[1], 0.0 },
               k[3] = { -x * spacing[2], 0.0, 0.0 };
  const double origin[3] = { x * place[0], y * place[1], place[2] };
  const std::string header = "NRRD0004\ntype: short\ndimension: 3\nspace: " + space +
    "\nsizes: 64 64 64\nspace directions: (" + Triple(i, ",") + ") (" + Triple(j, ",") + ") (" +
    Triple(k, ",") + ")\nendian: little\nencoding: raw\nspace origin: (" + Triple(origin, ",") +
    ")\n\n";
  return Write(folder + "/head-" + space + ".nrrd", header, shuffled);
}

std::string WriteNifti(
  const std::string& folder, vtkImageData* shuffled, double slope, double intercept)
{
  vtkNew<vtkMatrix4x4> form; // transform to right-anterior-superior
  for (int row = 0; row < 3; ++row)
  {
    const double sign = row < 2 ? -1.0 : 1.0;
    for (int column = 0; column < 3; ++column)
    {
      form->SetElement(row, column, sign * shuffled->GetDirectionMatrix()->GetElement(row, column));
    }
    form->SetElement(row, 3, sign * shuffled->GetOrigin()[row]);
  }
  vtkNew<vtkImageData> plain; // the form's matrix has the origin instead
  plain->DeepCopy(shuffled);
  plain->SetOrigin(0.0, 0.0, 0.0);
  vtkDataArray* const stored = plain->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < stored->GetNumberOfTuples(); ++i)
  {
    stored->SetTuple1(i, (stored->GetTuple1(i) - intercept) / slope);
  }
  const std::string path = folder + "/head.nii.gz";
  vtkNew<vtkNIFTIImageWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(plain);
  writer->SetSFormMatrix(form);
  writer->SetNIFTIVersion(1);
  writer->SetRescaleSlope(slope);
  writer->SetRescaleIntercept(intercept);
  writer->Write();
  return path;
}
