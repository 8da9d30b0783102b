// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// A segmentation and tables of its labels: what is felt, what the summary says, and what cannot be.
// The .seg.nrrd is made after 3D Slicer's documentation "Segmentation labelmap file format".
#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Options.h"
#include "Applications/Explorer/Report/TraceSummary.h"
#include "Applications/Explorer/Volume/LabelLoader.h"
#include "Expectations.h"
#include "HeadExploration.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataWriter.h"

#include <vtksys/FStream.hxx>

#include <sstream>

namespace
{
std::string File(const std::string& name, const std::string& content)
{
  const std::string path = folder + "/" + name;
  vtksys::ofstream(path.c_str(), std::ios::binary) << content;
  return path;
}

/// One label everywhere in the volume, in left-posterior-superior, as the volume itself.
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
} // namespace

int TestExploreLabels(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "ExploreLabels");
  const Explore::Exploration plain = ExploreHead(argc, argv);
  const Explore::Volume head = plain.Input;
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

  // The same through VTK's own format.
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
  Refuse(head, soft, {}, { "Soft.csv", "ending" });
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
