// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Report/ForcePicture.h"

#include "VTK/Scene/Base/RendererAspect.h"

#include "vtkContextActor.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

namespace Explore
{
void BuildForcePicture(ForcePicture& picture, vtkPolyData* trace, const std::vector<Phase>& phases,
  const ForcePictureOptions& options)
{
  picture.Forces.SetModes(options.Modes);
  picture.Forces.Read(trace);
  vtkDataArray* const time = trace->GetPointData()->GetArray("Time");
  const double end = time->GetComponent(time->GetNumberOfTuples() - 1, 0);
  double largest = 0.0;
  for (int c = 0; c < picture.Forces.GetCurves(); ++c)
  {
    largest = std::max(largest, picture.Forces.GetForce(c)->GetRange()[1]);
  }

  picture.Chart.Build();
  picture.Chart.SetModes(options.Modes);
  picture.Chart.Fit(options.Width, options.Height);
  picture.Chart.Show(
    picture.Forces.Get(), { 0.0, end, std::max(0.1, 1.08 * largest) }, options.Title);
  std::vector<VolumeHaptics::HapticForceChart::Phase> named;
  for (const Phase& phase : phases)
  {
    named.push_back(
      { phase.Name, time->GetComponent(phase.First, 0), time->GetComponent(phase.Last - 1, 0) });
  }
  picture.Chart.ShowPhases(named);

  picture.Renderer->SetBackground(1.0, 1.0, 1.0);
  picture.Renderer->AddActor(picture.Chart.GetActor());
  picture.Window->SetOffScreenRendering(1);
  picture.Window->SetMultiSamples(0);
  picture.Window->SetSize(options.Width, options.Height);
  picture.Window->AddRenderer(picture.Renderer);
  VolumeHaptics::ComputeAspect(picture.Renderer);
}
} // namespace Explore
