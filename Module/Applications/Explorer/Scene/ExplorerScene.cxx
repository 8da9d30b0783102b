// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Scene/ExplorerScene.h"

#include "Applications/Explorer/Scene/Trail.h"
#include "Applications/Explorer/Scene/VolumeLook.h"
#include "Applications/Explorer/View/SceneCamera.h"
#include "VTK/Scene/Base/RendererAspect.h"
#include "VTK/Scene/Frames/SoftwareOpenGL.h"

#include "vtkActor.h"
#include "vtkAnnotatedCubeActor.h"
#include "vtkAssembly.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkLight.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextureObject.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace
{
using Explore::ExplorerScene;
using Explore::MapperChoice;

/// The image without its place in the world: VTK 9.1's CPU mapper ignores the direction matrix, so
/// both mappers get the plain block of voxels, and the volume's own matrix places it.
vtkSmartPointer<vtkImageData> PlainImage(vtkImageData* image, vtkMatrix4x4* toWorld)
{
  auto plain = vtkSmartPointer<vtkImageData>::New();
  plain->ShallowCopy(image);
  const double identity[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  plain->SetDirectionMatrix(identity);
  plain->SetOrigin(0.0, 0.0, 0.0);
  for (int row = 0; row < 3; ++row)
  {
    toWorld->SetElement(row, 3, image->GetOrigin()[row]);
    for (int column = 0; column < 3; ++column)
    {
      toWorld->SetElement(row, column, image->GetDirectionMatrix()->GetElement(row, column));
    }
  }
  return plain;
}

/// Sampled without jitter: the same picture in every run.
vtkSmartPointer<vtkVolumeMapper> MakeGPUMapper(double sampleDistance)
{
  auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(static_cast<float>(sampleDistance));
  mapper->UseJitteringOff();
  return mapper;
}

vtkSmartPointer<vtkVolumeMapper> MakeCPUMapper(double sampleDistance)
{
  auto mapper = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(static_cast<float>(sampleDistance));
  mapper->SetImageSampleDistance(1.0f);
  return mapper;
}

bool IsGPUUsable(vtkRenderWindow* window, vtkVolumeProperty* property, vtkImageData* image)
{
  if (window->GetNeverRendered())
  {
    window->Render(); // only a window with a context can tell
  }
  auto* context = vtkOpenGLRenderWindow::SafeDownCast(window);
  const int* size = image->GetDimensions();
  const bool fits = !context ||
    std::max({ size[0], size[1], size[2] }) <= vtkTextureObject::GetMaximumTextureSize3D(context);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  return fits && mapper->IsRenderSupported(window, property);
}

void AddVolume(ExplorerScene& scene, vtkImageData* image, const Explore::Exploration& exploration,
  const Explore::SceneOptions& options)
{
  const Explore::Analysis& analysis = exploration.Values;
  vtkVolumeProperty* const property = scene.Look;
  Explore::SetVolumeLook(analysis, property);
  if (exploration.Input.AreLabels)
  {
    Explore::SetLabelLook(exploration.Input.LabelTable, property);
  }
  bool gpu = options.Mapper != MapperChoice::CPU;
  if (options.Mapper == MapperChoice::Auto)
  {
    // If the processor emulates the graphics card, its own ray casting takes a fifth of the time,
    // and input interrupts it. A picture may take longer.
    gpu = IsGPUUsable(scene.Window, property, image) &&
      !(options.Interactive && VolumeHaptics::IsSoftwareOpenGL(scene.Window));
  }
  const double* spacing = image->GetSpacing();
  // A frame on the graphics card can't be interrupted, but a picture may take longer.
  const double voxels = gpu && options.Interactive ? 1.0 : 0.5;
  const double sample = voxels * std::min({ spacing[0], spacing[1], spacing[2] });

  vtkNew<vtkMatrix4x4> toWorld;
  vtkVolume* const volume = scene.Volume;
  auto mapper = gpu ? MakeGPUMapper(sample) : MakeCPUMapper(sample);
  mapper->SetInputData(PlainImage(image, toWorld));
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  volume->SetUserMatrix(toWorld);
  scene.Renderer->AddVolume(volume);
  if (exploration.Input.Large)
  {
    scene.Refined->SetSource(exploration.Input.Large);
    scene.Refined->SetVolumeHaptics(exploration.Filter);
    scene.Refined->SetVolume(volume);
    scene.Refined->SetRenderer(scene.Renderer);
  }
  scene.MapperName = gpu ? "vtkGPUVolumeRayCastMapper" : "vtkFixedPointVolumeRayCastMapper";
}

void AddOutline(vtkRenderer* renderer, vtkPolyData* outline)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(outline);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->PickableOff();
  actor->GetProperty()->SetColor(0.72, 0.78, 0.86);
  actor->GetProperty()->SetLineWidth(1.5f);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void AddMarker(ExplorerScene& scene, const Explore::ViewFrame& view, bool anatomical)
{
  vtkNew<vtkAnnotatedCubeActor> cube;
  const char* patient[] = { "L", "R", "P", "A", "S", "I" };
  const char* axes[] = { "+X", "-X", "+Y", "-Y", "+Z", "-Z" };
  const char** text = anatomical ? patient : axes;
  cube->SetXPlusFaceText(text[0]);
  cube->SetXMinusFaceText(text[1]);
  cube->SetYPlusFaceText(text[2]);
  cube->SetYMinusFaceText(text[3]);
  cube->SetZPlusFaceText(text[4]);
  cube->SetZMinusFaceText(text[5]);
  cube->SetFaceTextScale(anatomical ? 0.6 : 0.4);
  cube->GetCubeProperty()->SetColor(0.32, 0.40, 0.52);
  cube->GetTextEdgesProperty()->SetColor(1.0, 1.0, 1.0);
  cube->GetTextEdgesProperty()->SetLineWidth(1.0f);
  scene.Marker->SetViewport(0.84, 0.80, 1.0, 1.0);
  scene.Marker->SetLayer(2);
  scene.Marker->InteractiveOff();
  // The cube itself would set its letters, and find their edges, several times in each frame.
  cube->HasTranslucentPolygonalGeometry(); // sets them
  scene.Marker->AddActor(cube->GetAssembly());
  Explore::ViewFrame centred = view;
  centred.Centre = vtkVector3d(0.0, 0.0, 0.0);
  Explore::AimCamera(scene.Marker, centred, 5.0);
}

/// A lamp from the camera's upper left, and light from all sides, so that no side is black.
void AddLights(vtkRenderer* renderer)
{
  vtkNew<vtkLight> lamp, fill;
  lamp->SetLightTypeToCameraLight();
  lamp->SetPosition(-0.45, 0.65, 1.0);
  lamp->SetIntensity(1.2);
  fill->SetLightTypeToCameraLight();
  fill->SetPosition(0.8, -0.3, 0.6);
  fill->SetIntensity(0.35);
  renderer->AddLight(lamp);
  renderer->AddLight(fill);
}

void AddCaption(vtkRenderer* renderer, const std::string& caption, int height)
{
  vtkNew<vtkTextActor> text;
  text->SetInput(caption.c_str());
  text->GetTextProperty()->SetFontSize(std::max(9, height / 44));
  text->GetTextProperty()->SetColor(0.93, 0.95, 0.98);
  text->GetTextProperty()->SetLineSpacing(1.15);
  text->GetTextProperty()->SetVerticalJustificationToTop();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->GetPositionCoordinate()->SetValue(0.02, 0.975);
  renderer->AddViewProp(text);
}
} // namespace

namespace Explore
{
void BuildScene(ExplorerScene& scene, const Exploration& exploration, const SceneOptions& options)
{
  const Analysis& analysis = exploration.Values;
  scene.Window->SetOffScreenRendering(options.OffScreen);
  scene.Window->SetMultiSamples(0);
  scene.Window->SetSize(options.Width, options.Height);
  scene.Window->SetNumberOfLayers(3);
  for (vtkRenderer* const renderer :
    { scene.Renderer.Get(), scene.Overlay.Get(), scene.Marker.Get() })
  {
    scene.Window->AddRenderer(renderer);
    VolumeHaptics::ComputeAspect(renderer);
  }
  scene.Overlay->SetLayer(1);
  scene.Overlay->InteractiveOff();
  scene.Overlay->SetActiveCamera(scene.Renderer->GetActiveCamera());
  scene.Renderer->GradientBackgroundOn();
  scene.Renderer->SetBackground(0.07, 0.09, 0.12);
  scene.Renderer->SetBackground2(0.24, 0.29, 0.36);

  AddLights(scene.Renderer); // before the first rendering, or VTK adds its own
  // A moving volume is shown as it is felt.
  const bool isMoving = exploration.Input.Frames != nullptr;
  AddVolume(scene, isMoving ? exploration.Input.Image : exploration.Body, exploration, options);
  vtkPolyData* const outline = exploration.Input.Outline;
  if (outline)
  {
    AddOutline(scene.Renderer, outline);
  }
  if (!options.Interactive)
  {
    AddTrail(scene.Renderer, scene.Overlay, exploration.Trace, analysis.MetersPerWorldUnit,
      options.Height);
  }
  AddMarker(scene, exploration.View, options.Anatomical);
  AddCaption(scene.Renderer, options.Caption, options.Height);

  const double width = options.Width * (1.0 - options.SliceShare);
  const double* const seen = outline ? outline->GetBounds() : analysis.BodyBounds;
  FitCamera(scene.Renderer, exploration.View, seen, width / options.Height, outline != nullptr);
}
} // namespace Explore
