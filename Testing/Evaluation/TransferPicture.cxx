// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TransferPicture.h"

#include "TransferCharts.h"

#include "Applications/Explorer/Analysis/BodyIsolation.h"
#include "Applications/Explorer/Scene/VolumeLook.h"
#include "Applications/Explorer/View/SceneCamera.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeLoader.h"

#include "vtkCamera.h"
#include "vtkContextActor.h"
#include "vtkHapticProperty.h"
#include "vtkPNGWriter.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

#include <cstdio>

namespace evaluation
{
namespace
{
constexpr int Width = 1500;
constexpr int Height = 900;
/** Fraction of the width that the rendered CT occupies. */
constexpr double Fraction = 0.36;

/** Adds the CT with the explorer's opacity, which depends on the gradient, as distinctness does. */
void AddHead(
  vtkRenderer* renderer, vtkVolume* head, const Explore::Volume& volume, const Effort& effort)
{
  Explore::Analysis values = Explore::AnalyseVolume(volume.Image);
  const vtkSmartPointer<vtkImageData> body =
    Explore::IsolateBody(volume.Image, values.OuterThreshold, values.Range[0]);
  Explore::MeasureBody(values, body);
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputData(body);
  if (!effort.IsFull)
  {
    mapper->SetRequestedRenderModeToRayCast(); // grainy, but fast without a graphics card
  }
  head->SetMapper(mapper);
  Explore::SetVolumeLook(values, head->GetProperty());
  renderer->AddVolume(head);
  Explore::FitCamera(renderer, Explore::MakeViewFrame(values.Centre, "-y", "+z"), values.BodyBounds,
    Fraction * Width / Height, false);
  renderer->GetActiveCamera()->Zoom(1.2); // the corners of the head's box are empty
}
} // namespace

Picture DrawTransferPicture(
  const std::string& volumeFile, const Effort& effort, const std::string& folder)
{
  vtkNew<vtkRenderer> scene;
  scene->SetViewport(0.0, 0.0, Fraction, 1.0);
  scene->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkVolume> head;
  try
  {
    AddHead(
      scene, head, Explore::LoadVolume(volumeFile.empty() ? PHANTOM_FILE : volumeFile), effort);
  }
  catch (const Explore::InputError& error)
  {
    std::fprintf(stderr, "There is no picture of the transfer functions. %s\n", error.what());
    return {};
  }
  vtkNew<vtkHapticProperty> feel;
  feel->ApplyPreset("CT contrast");
  head->GetProperty()->SetGradientOpacity(feel->GetDistinctness());

  vtkNew<vtkRenderer> charts;
  charts->SetViewport(Fraction, 0.0, 1.0, 1.0);
  charts->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkContextActor> context;
  AddTransferCharts(
    context->GetScene(), head->GetProperty(), feel, (1.0 - Fraction) * Width, Height);
  charts->AddActor(context);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(Width, Height);
  window->SetMultiSamples(4);
  window->AddRenderer(scene);
  window->AddRenderer(charts);
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff(); // rerendering takes seconds without a graphics card
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName((folder + "/transfer.png").c_str());
  writer->SetInputConnection(picture->GetOutputPort());
  writer->Write();
  return { "transfer",
    "The paper's table 1: visual transfer functions and, beside each, the haptic one" };
}

} // namespace evaluation
