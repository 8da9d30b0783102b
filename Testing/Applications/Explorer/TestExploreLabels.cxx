// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tests a segmentation and tables of its labels: the force, the summary, and the reported errors.
// The .seg.nrrd follows 3D Slicer's documentation "Segmentation labelmap file format".
#include "Applications/Explorer/Options.h"
#include "Applications/Explorer/Report/TraceSummary.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/LabelLoader.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataWriter.h"

#include <vtksys/FStream.hxx>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
std::string File(const std::string& name, const std::string& content)
{
  const std::string path = folder + "/" + name;
  vtksys::ofstream(path.c_str(), std::ios::binary) << content;
  return path;
}

/// Writes a segmentation with one label for all voxels of the volume, in left-posterior-superior
/// axes like the volume.
std::string Segmentation(vtkImageData* volume)
{
  const int* const size = volume->GetDimensions();
  const double* const spacing = volume->GetSpacing();
  const double* const origin = volume->GetOrigin();
  std::ostringstream text;
  text << "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: " << size[0]
       << " " << size[1] << " " << size[2] << "\nspace directions: (" << spacing[0] << ",0,0) (0,"
       << spacing[1] << ",0) (0,0," << spacing[2] << ")\nspace origin: (" << origin[0] << ","
       << origin[1] << "," << origin[2] << ")\nencoding: raw\nSegment0_LabelValue:=7\n"
       << "Segment0_Layer:=0\nSegment0_Name:=everything\n\n"
       << std::string(static_cast<std::size_t>(volume->GetNumberOfPoints()), '\7');
  return text.str();
}

double LargestForce(const Explore::Exploration& exploration)
{
  return exploration.Trace->GetPointData()->GetArray("NormalForce")->GetMaxNorm();
}

bool IsSame(const Explore::Exploration& a, const Explore::Exploration& b)
{
  vtkDataArray* const one = a.Trace->GetPointData()->GetArray("Force");
  vtkDataArray* const other = b.Trace->GetPointData()->GetArray("Force");
  bool isSame = one->GetNumberOfValues() == other->GetNumberOfValues();
  for (vtkIdType i = 0; isSame && i < one->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      isSame = isSame && one->GetComponent(i, c) == other->GetComponent(i, c);
    }
  }
  return isSame;
}

void Refuse(const Explore::Volume& head, const std::string& segmentation,
  const std::vector<std::string>& tables, const std::vector<std::string>& words)
{
  std::string message = "nothing";
  try
  {
    Explore::Volume volume = head;
    Explore::LoadLabels(volume, segmentation, tables);
  }
  catch (const Explore::InputError& error)
  {
    message = error.what();
  }
  for (const std::string& word : words)
  {
    Expect(message.find(word) != std::string::npos, message + " says " + word);
  }
}
/// Writes two half balls (radius 40 mm, centre 0) with the labels 2 and 7. With noise, the file
/// resembles a scan rather than a label map.
std::string LabelMap(const std::string& name, bool isNoisy)
{
  constexpr int size = 48;
  constexpr double radius = 40.0, middle = 2.0 * 0.5 * (size - 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, size);
  image->SetSpacing(2.0, 2.0, 2.0);
  image->SetOrigin(-middle, -middle, -middle);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* value = static_cast<short*>(image->GetScalarPointer());
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    const double* const x = image->GetPoint(p);
    const bool isInside = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] < radius * radius;
    const auto noise = static_cast<short>(isNoisy ? 40 + p * 7919 % 13 : 0);
    value[p] = static_cast<short>(isInside ? (x[0] > 0.0 ? 7 : 2) + noise : 0);
  }
  vtkNew<vtkXMLImageDataWriter> writer;
  const std::string path = folder + "/" + name;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
  return path;
}

/// Expects that a label map is recognised, and that its outer surface can be touched.
void ExpectLabelMap(const Explore::Volume& head)
{
  Expect(!head.MayBeLabels, "a head is no label map");
  Expect(!Explore::LoadVolume(LabelMap("noise.vti", true)).MayBeLabels, "a scan is no label map");
  const std::string path = LabelMap("balls.vti", false);
  Explore::Volume volume = Explore::LoadVolume(path);
  Expect(volume.MayBeLabels, "a label map is recognised");
  Explore::UseAsLabels(volume, path, { File("Names.csv", "label,name,stiffness\n7,liver,300\n") });
  Expect(volume.LabelTable->GetLabelName(7) == "liver" &&
      volume.LabelTable->GetLabelName(2) == "label 2",
    "labels have names");
  Expect(volume.LabelTable->HasColor(2) && volume.LabelTable->HasColor(7), "labels have colours");
  const Explore::Exploration felt = Explore::ExploreVolume(volume, {});
  Expect(felt.Materials == "Labels" && felt.Values.Kind == Explore::VolumeKind::Labels,
    "labels have materials of labels");
  vtkDataArray* const contact = felt.Trace->GetPointData()->GetArray("Contact");
  vtkDataArray* const normal = felt.Trace->GetPointData()->GetArray("NormalForce");
  Expect(normal && normal->GetMaxNorm() > 0.3, "the wall of a label is felt");
  // At the first contact, the proxy is at most a voxel (2 mm) off the ball's surface.
  vtkIdType first = 0;
  while (contact && first < contact->GetNumberOfTuples() && contact->GetComponent(first, 0) == 0.0)
  {
    ++first;
  }
  const double* const x =
    felt.Trace->GetPoint(std::min(first, felt.Trace->GetNumberOfPoints() - 1));
  const double distance = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  Expect(std::abs(distance - 40.0) < 2.0, "contact begins at " + std::to_string(distance) + " mm");

  bool isRefused = false;
  try
  {
    Explore::Volume values = head;
    values.Image = vtkSmartPointer<vtkImageData>::New();
    values.Image->SetDimensions(5, 5, 5);
    values.Image->AllocateScalars(VTK_FLOAT, 1);
    values.Image->GetPointData()->GetScalars()->Fill(0.5);
    Explore::UseAsLabels(values, "half.vti", {});
  }
  catch (const Explore::InputError& error)
  {
    isRefused = std::string(error.what()).find("half.vti") != std::string::npos;
  }
  Expect(isRefused, "halves are no labels");
}
} // namespace

int TestExploreLabels(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "ExploreLabels");
  const Explore::Exploration plain = ExploreHead(argc, argv);
  const Explore::Volume head = plain.Input;
  ExpectLabelMap(head);
  const std::string segmentation = File("Head.seg.nrrd", Segmentation(head.Image));
  const std::string unfelt = File("Unfelt.csv", "label,felt\n7,0\n");
  const std::string soft = File("Soft.csv", "label,stiffness\n7,20\n");
  const Explore::Settings settings;
  Expect(LargestForce(plain) > 1.0, "the head is felt");

  Explore::Volume volume = head;
  Explore::LoadLabels(volume, segmentation, {});
  Expect(volume.LabelTable->GetLabelName(7) == "everything", "the file has a name");
  Explore::Exploration felt = Explore::ExploreVolume(volume, settings);
  Expect(felt.Filter->GetLabelTable() == volume.LabelTable, "the filter has the table");
  Expect(IsSame(plain, felt), "labels without a material change nothing");

  volume = head;
  Explore::LoadLabels(volume, segmentation, { soft, unfelt });
  felt = Explore::ExploreVolume(volume, settings);
  Expect(LargestForce(felt) == 0.0, "a label that is not felt gives no force");
  const std::string summary = Explore::Summarise(felt);
  Expect(summary.find("labels from Head.seg.nrrd: 1 in the table, 1 with a material") !=
      std::string::npos,
    "the summary says so: " + summary);

  // Read the same labels from VTK's own format.
  vtkNew<vtkImageData> image;
  image->ShallowCopy(volume.Labels);
  volume.LabelTable->WriteFieldData(image->GetFieldData());
  vtkNew<vtkXMLImageDataWriter> writer;
  const std::string vti = folder + "/Head.vti";
  writer->SetFileName(vti.c_str());
  writer->SetInputData(image);
  writer->Write();
  volume = head;
  Explore::LoadLabels(volume, vti, {});
  Expect(LargestForce(Explore::ExploreVolume(volume, settings)) == 0.0, "a .vti has a table");

  Refuse(head, folder + "/none.nii", {}, { "none.nii", "no such file" });
  Refuse(head, folder + "/none.nrrd", {}, { "none.nrrd", "does not exist" });
  Refuse(head, soft, {}, { "Soft.csv", "extension" });
  Refuse(head, segmentation, { soft, File("Bad.csv", "label,felt\n7,maybe\n") },
    { "--materials", "Bad.csv", "Line 2", "maybe" });

  const char* words[] = { "explore", "--materials", "x.csv", "head.vti" };
  try
  {
    Explore::ParseOptions(4, const_cast<char**>(words));
    Expect(false, "materials need labels");
  }
  catch (const Explore::InputError& error)
  {
    Expect(std::string(error.what()).find("--labels") != std::string::npos, "the cure is named");
  }
  const char* good[] = { "explore", "--labels=a.nii", "--materials", "x.csv", "--materials=y.csv",
    "head.vti" };
  const Explore::Options options = Explore::ParseOptions(6, const_cast<char**>(good));
  Expect(options.Labels == "a.nii" && options.Materials.size() == 2, "options are read");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
