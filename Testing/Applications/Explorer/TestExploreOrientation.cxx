// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects the head at the same place, the same way up and with the same values from every format,
// whatever the order of its voxels and the numbers stored in the file.
#include "Applications/Explorer/Report/ReportFiles.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "ShuffledHead.h"
#include "VTK/Reading/VolumeOrientation.h"

#include <cmath>
#include <iostream>
#include <utility>

namespace
{
void ExpectSamePlace(const std::string& what, vtkImageData* head, vtkImageData* image)
{
  // Text headers and NIfTI's single precision store fewer digits than a double.
  constexpr double tolerance = 1e-4;
  bool same = head->GetNumberOfPoints() == image->GetNumberOfPoints();
  for (int i = 0; same && i < head->GetDimensions()[0]; i += 3)
  {
    for (int j = 0; j < head->GetDimensions()[1]; j += 3)
    {
      for (int k = 0; k < head->GetDimensions()[2]; k += 3)
      {
        same = same &&
          head->GetScalarComponentAsDouble(i, j, k, 0) ==
            image->GetScalarComponentAsDouble(i, j, k, 0);
      }
    }
  }
  double wanted[3], found[3];
  for (const int corner : { 0, 63 })
  {
    head->TransformIndexToPhysicalPoint(corner, 6, 7, wanted);
    image->TransformIndexToPhysicalPoint(corner, 6, 7, found);
    for (int axis = 0; axis < 3; ++axis)
    {
      same = same && std::abs(wanted[axis] - found[axis]) < tolerance;
    }
  }
  if (!same)
  {
    std::cerr << what << ": the head is not where it was\n";
    ++failures;
  }
}
} // namespace

int TestExploreOrientation(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "ExploreOrientation");
  const vtkSmartPointer<vtkImageData> head = LoadHead(argc, argv);
  const vtkSmartPointer<vtkImageData> shuffled = ShuffleHead(head);

  ExpectSamePlace("a left-handed frame", head, Explore::AlignToAxes(shuffled));
  const std::string written = folder + "/written.vti";
  Explore::WriteImage(shuffled, written);
  ExpectSamePlace("VTK's XML", head, Explore::LoadVolume(written).Image);
  ExpectSamePlace("MetaImage", head, Explore::LoadVolume(WriteMetaImage(folder, shuffled)).Image);
  for (const auto& [slope, intercept] :
    { std::pair<double, double>{ 1.0, 0.0 }, { 1.0, -1024.0 }, { 0.5, -1024.0 } })
  {
    ExpectSamePlace("NIfTI of values that are " + std::to_string(slope) +
        " times the stored ones plus " + std::to_string(intercept),
      head, Explore::LoadVolume(WriteNifti(folder, shuffled, slope, intercept)).Image);
  }
  // NRRD and MetaImage headers may state what their axes refer to, or leave it unknown. NIfTI's
  // transforms always refer to the patient.
  const auto axesOf = [](const std::string& path) { return Explore::LoadVolume(path).Axes; };
  Expect(axesOf(WriteNifti(folder, shuffled, 1.0, 0.0)) == Explore::WorldAxes::Patient,
    "a NIfTI form is of a patient");
  Expect(axesOf(WriteMetaImage(folder, shuffled)) == Explore::WorldAxes::Unknown,
    "a MetaImage without AnatomicalOrientation does not say");
  for (const auto& [line, axes] : { std::pair<std::string, Explore::WorldAxes>{
                                      "AnatomicalOrientation = RAI", Explore::WorldAxes::Patient },
         { "AnatomicalOrientation = ???", Explore::WorldAxes::Unknown } })
  {
    Expect(Explore::ReadMetaImageAxes(WriteText("axes.mhd", line + "\n")) == axes, line);
  }
  for (const auto& [line, axes] :
    { std::pair<std::string, Explore::WorldAxes>{ "space: LPS", Explore::WorldAxes::Patient },
      { "space: left-anterior-superior-time", Explore::WorldAxes::Patient },
      { "space: RAST", Explore::WorldAxes::Patient },
      { "space: scanner-xyz", Explore::WorldAxes::Other },
      { "space: 3D-right-handed", Explore::WorldAxes::Other },
      { "type: short", Explore::WorldAxes::Unknown } })
  {
    const std::string header = WriteText("axes.nhdr", "NRRD0004\n" + line + "\n");
    Expect(Explore::FindNrrdAxes(VolumeHaptics::ReadNrrdHeader(header)) == axes, line);
  }
  for (const char* space :
    { "left-posterior-superior", "right-anterior-superior", "left-anterior-superior" })
  {
    ExpectSamePlace(std::string("NRRD ") + space, head,
      Explore::LoadVolume(WriteNrrd(folder, shuffled, space)).Image);
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
