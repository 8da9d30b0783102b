// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/LabelLoader.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Errors/MessageCapture.h"

#include "vtkHapticSegmentationReader.h"
#include "vtkNew.h"

#include <vtksys/SystemTools.hxx>

namespace
{
using Explore::InputError;
using Explore::Volume;

bool IsNrrd(const std::string& path)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path)) ==
    ".nrrd";
}

void ReadSegmentation(Volume& volume, const std::string& path)
{
  vtkNew<vtkHapticSegmentationReader> reader;
  const Explore::MessageCapture capture;
  reader->SetFileName(path);
  reader->Update();
  if (capture.HasErrors())
  {
    throw InputError("--labels " + path, capture.FirstError(), "name another file");
  }
  volume.Labels = vtkSmartPointer<vtkImageData>::New();
  volume.Labels->ShallowCopy(reader->GetOutput());
  volume.LabelTable->DeepCopy(reader->GetLabelTable());
}
} // namespace

namespace Explore
{
void LoadLabels(
  Volume& volume, const std::string& segmentation, const std::vector<std::string>& tables)
{
  volume.LabelTable = vtkSmartPointer<vtkHapticLabelTable>::New();
  if (IsNrrd(segmentation))
  {
    ReadSegmentation(volume, segmentation);
  }
  else
  {
    const Volume labels = ReadVolume(segmentation);
    if (labels.IsGrid)
    {
      throw InputError(segmentation, "has no voxels, but cells", "write the labels as an image");
    }
    volume.Labels = labels.Image;
    const MessageCapture capture; // without names there are numbers
    volume.LabelTable->ReadFile(segmentation.c_str());
  }
  for (const std::string& table : tables)
  {
    const MessageCapture capture;
    if (!volume.LabelTable->ReadFile(table.c_str()))
    {
      throw InputError("--materials " + table, capture.FirstError(), "name another file");
    }
  }
  int withMaterial = 0;
  for (vtkIdType i = 0; i < volume.LabelTable->GetNumberOfLabels(); ++i)
  {
    withMaterial += volume.LabelTable->HasMaterial(volume.LabelTable->GetLabel(i)) ? 1 : 0;
  }
  volume.Notes.push_back("labels from " + vtksys::SystemTools::GetFilenameName(segmentation) +
    ": " + std::to_string(volume.LabelTable->GetNumberOfLabels()) + " in the table, " +
    std::to_string(withMaterial) + " with a material of their own");
}
} // namespace Explore
