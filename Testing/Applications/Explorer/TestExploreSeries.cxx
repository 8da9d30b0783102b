// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects that a moving volume, in every supported form, is read with the written time steps, times
// and voxels, and that the window plays it.
#include "Expectations.h"
#include "HeadExploration.h"
#include "Rigs/Eventually.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeSeries.h"

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkFloatArray.h"
#include "vtkImageAppendComponents.h"
#include "vtkNIFTIImageWriter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataWriter.h"

#include <vtksys/SystemTools.hxx>

namespace
{
constexpr int COUNT = 3;

/// Returns the head with values that identify its time step.
vtkSmartPointer<vtkImageData> MakeFrame(vtkImageData* head, int number)
{
  auto timeStep = vtkSmartPointer<vtkImageData>::New();
  timeStep->DeepCopy(head);
  vtkDataArray* const values = timeStep->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, values->GetComponent(i, 0) + number);
  }
  return timeStep;
}

/// Returns the head lifted by `slices` slices for each time step, with the motion as an array of
/// displacements.
vtkSmartPointer<vtkImageData> MakeLiftedFrame(vtkImageData* head, int number, int slices)
{
  auto timeStep = vtkSmartPointer<vtkImageData>::New();
  timeStep->DeepCopy(head);
  const int* const n = head->GetDimensions();
  vtkDataArray* const values = timeStep->GetPointData()->GetScalars();
  vtkDataArray* const own = head->GetPointData()->GetScalars();
  const vtkIdType slice = static_cast<vtkIdType>(n[0]) * n[1];
  const vtkIdType shift = slice * slices * number;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, own->GetComponent(i < shift ? i % slice : i - shift, 0));
  }
  vtkNew<vtkFloatArray> motion;
  motion->SetName("motion");
  motion->SetNumberOfComponents(3);
  motion->SetNumberOfTuples(values->GetNumberOfTuples());
  motion->Fill(0.0);
  motion->FillComponent(2, (number + 1 < COUNT ? slices : -2 * slices) * head->GetSpacing()[2]);
  timeStep->GetPointData()->AddArray(motion);
  return timeStep;
}

std::string WriteImage(const std::string& name, vtkImageData* image)
{
  const std::string path = folder + "/" + name;
  vtksys::SystemTools::MakeDirectory(vtksys::SystemTools::GetFilenamePath(path));
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->SetCompressorTypeToNone();
  writer->Write();
  return path;
}

void ExpectSeries(const std::string& what, const std::vector<std::string>& paths, double begin,
  double spacing, const std::vector<int>& order = { 0, 1, 2 })
{
  const Explore::Volume volume = Explore::LoadVolumes(paths);
  const int count = static_cast<int>(order.size());
  const bool isThere = volume.TimeSteps && volume.TimeSteps->GetNumberOfTimeSteps() == count;
  Expect(isThere, what + " has other frames");
  for (int i = 0; isThere && i < count; ++i)
  {
    vtkImageData* const timeStep = volume.TimeSteps->GetTimeStepImage(i);
    const double difference = timeStep->GetPointData()->GetScalars()->GetComponent(0, 0) -
      volume.Image->GetPointData()->GetScalars()->GetComponent(0, 0);
    Expect(difference == order[i] - order[0], what + " has its frames in another order");
    Expect(std::abs(volume.TimeSteps->GetTimeStepValue(i) - begin - i * spacing) < 1e-6,
      what + " has other times");
  }
  Expect(
    isThere && volume.TimeSteps->GetTimeStepImage(0) == volume.Image, what + " has another image");
}

void ExpectError(const std::vector<std::string>& paths, const std::string& fault,
  const std::string& displacements = "")
{
  std::string message = "nothing";
  try
  {
    Explore::Volume volume = Explore::LoadVolumes(paths);
    if (!displacements.empty())
    {
      Explore::UseDisplacements(volume, displacements);
    }
  }
  catch (const Explore::InputError& error)
  {
    message = error.what();
  }
  Expect(message.find(fault) != std::string::npos && message.find("Cure: ") != std::string::npos,
    "should say '" + fault + "', but said: " + message);
}

/// Counts a filter's messages of one kind, and suppresses their output on the terminal.
struct MessageCount
{
  MessageCount(vtkVolumeHapticsFilter* filter, unsigned long kind)
  {
    filter->AddObserver(kind, this, &MessageCount::Add);
  }
  void Add(vtkObject*, unsigned long, void*) { ++this->Count; }
  int Count = 0;
};

/// Expects that every time step is both touched and displayed. `displacements` is the name of the
/// displacement array, or empty.
void ExpectPlaying(const std::vector<std::string>& paths, const std::string& displacements = "")
{
  Explore::Volume volume = Explore::LoadVolumes(paths);
  if (!displacements.empty())
  {
    Explore::UseDisplacements(volume, displacements);
  }
  const Explore::Exploration exploration = Explore::ExploreVolume(volume, Explore::Settings());
  MessageCount warnings(exploration.Filter, vtkCommand::WarningEvent);
  MessageCount errors(exploration.Filter, vtkCommand::ErrorEvent);
  Explore::TouchScene touch;
  Explore::SceneOptions options;
  options.Width = 200;
  options.Height = 150;
  options.Interactive = true;
  options.Mapper = Explore::MapperChoice::CPU;
  Explore::BuildTouchScene(touch, exploration, options, {});
  Expect(touch.Device->GetPlayback()->IsPlaying(), "the window does not play");
  Expect(exploration.Filter->GetDisplacementArrayName() == displacements,
    "the window does not use the displacements '" + displacements + "'");
  double latest = 0.0;
  const bool plays = devicetest::Eventually(
    [&]
    {
      touch.Style->UpdateHaptics();
      latest = std::max(latest, touch.Device->GetPlayback()->GetTimeStepValue());
      return touch.Device->GetPlayback()->HasTimeSteps() && latest > 0.15;
    });
  Expect(plays, "the window does not get to the last frame");
  const bool warns = displacements.empty();
  Expect(errors.Count == 0, "the frames can't be felt");
  Expect((warnings.Count > 0) == warns,
    warns ? "frames that are too fast for a blend are not told"
          : "displacements are not what tells the motion");
  touch.Device->Close();
}
} // namespace

int TestExploreSeries(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "TestExploreSeries");
  const vtkSmartPointer<vtkImageData> head = LoadHead(argc, argv);
  std::vector<std::string> files;
  vtkNew<vtkImageAppendComponents> times;
  // Sorted as plain text, these names would be in the wrong order: 10 would come first.
  const char* const names[COUNT] = { "phases/at2.vti", "phases/at9.vti", "phases/at10.vti" };
  for (int i = 0; i < COUNT; ++i)
  {
    const auto timeStep = MakeFrame(head, i);
    files.push_back(WriteImage(names[i], timeStep));
    times->AddInputData(timeStep);
  }
  ExpectSeries("a list of files", files, 0.0, 0.1);
  ExpectSeries("a list in another order", { files[2], files[0] }, 0.0, 0.1, { 2, 0 });
  ExpectSeries("a folder", { folder + "/phases" }, 0.0, 0.1);
  ExpectSeries("frames that close the loop", { files[0], files[1], files[2], files[0] }, 0.0, 0.1);
  const std::string collection = "<VTKFile type=\"Collection\"><Collection>"
                                 "<DataSet timestep=\"2.5\" file=\"phases/at10.vti\"/>"
                                 "<DataSet timestep=\"1.5\" file=\"phases/at2.vti\"/>"
                                 "<DataSet timestep=\"2\" file=\"phases/at9.vti\"/>"
                                 "</Collection></VTKFile>";
  ExpectSeries("a collection", { WriteText("head.pvd", collection) }, 1.5, 0.5);

  times->Update();
  vtkNew<vtkNIFTIImageWriter> writer;
  const std::string nifti = folder + "/head.nii";
  writer->SetFileName(nifti.c_str());
  writer->SetInputConnection(times->GetOutputPort());
  writer->SetTimeDimension(COUNT);
  writer->SetTimeSpacing(0.25);
  writer->Write();
  ExpectSeries("a NIfTI file", { nifti }, 0.0, 0.25);

  Expect(!Explore::LoadVolumes({ files[1] }).TimeSteps, "one file moves");
  ExpectError({ WriteText("empty.pvd", "<VTKFile/>") }, "is not a ParaView collection");
  ExpectError({ WriteText("twice.pvd",
                "<VTKFile><Collection><DataSet timestep=\"1\" file=\"a.vti\"/>"
                "<DataSet timestep=\"1\" file=\"b.vti\"/></Collection></VTKFile>") },
    "several files for one time");
  vtkNew<vtkImageData> moved;
  moved->ShallowCopy(head);
  moved->SetOrigin(1.0, 2.0, 3.0);
  ExpectError({ files[0], WriteImage("moved.vti", moved) }, "another geometry");
  ExpectError({ files[0], folder + "/none.vti" }, "no such file");

  std::vector<std::string> lifted;
  for (int i = 0; i < COUNT; ++i)
  {
    lifted.push_back(
      WriteImage("lifted" + std::to_string(i) + ".vti", MakeLiftedFrame(head, i, 8)));
  }
  ExpectError(lifted, "is no point array of vectors in the frame at 0 s", "speed");
  ExpectError({ lifted[0], files[1] }, "in the frame at 0.1 s", "motion");
  ExpectError({ lifted[0] }, "is for a volume that moves", "motion");
  ExpectPlaying(lifted);
  ExpectPlaying(lifted, "motion");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
