// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Scene/ExplorerScene.h"

#include "Applications/Explorer/Scene/VolumeLook.h"
#include "Applications/Explorer/View/SceneCamera.h"
#include "VTK/Scene/Base/RendererAspect.h"
#include "VTK/Scene/Frames/SoftwareOpenGL.h"

#include "vtkActor.h"
#include "vtkAnnotatedCubeActor.h"
#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextureObject.h"
#include "vtkTubeFilter.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double TUBE_RADIUS = 0.0012; // m
constexpr double SPACING = 0.0006;     // m between the points of the tube
constexpr const char* FORCE_NAME = "Force (N)";

/// Thins the trace to a polyline with a point every SPACING: a tube needs distinct points, but the
/// proxy stands still for many ticks. Each point has the largest force since the previous one.
vtkSmartPointer<vtkPolyData> Thin(vtkPolyData* trace, double spacing)
{
  vtkDataArray* force = trace->GetPointData()->GetArray("Force");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble(); // single precision at 5e6, as in UTM coordinates, has steps of 0.5
  vtkNew<vtkCellArray> line;
  vtkNew<vtkDoubleArray> magnitude;
  magnitude->SetName(FORCE_NAME);
  line->InsertNextCell(0);
  double last[3] = { 0, 0, 0 }, largest = 0.0;
  for (vtkIdType i = 0; i < trace->GetNumberOfPoints(); ++i)
  {
    double position[3], newtons[3];
    trace->GetPoint(i, position);
    force->GetTuple(i, newtons);
    largest = std::max(largest, vtkMath::Norm(newtons));
    if (i == 0 || vtkMath::Distance2BetweenPoints(position, last) >= spacing * spacing)
    {
      line->InsertCellPoint(points->InsertNextPoint(position));
      magnitude->InsertNextValue(largest);
      std::copy_n(position, 3, last);
      largest = 0.0;
    }
  }
  line->UpdateCellCount(static_cast<int>(points->GetNumberOfPoints()));
  auto thinned = vtkSmartPointer<vtkPolyData>::New();
  thinned->SetPoints(points);
  thinned->SetLines(line);
  thinned->GetPointData()->SetScalars(magnitude);
  return thinned;
}

/// Makes colours from blue (no force) through green and yellow to red, which differ from the
/// colours of skin and bone.
vtkSmartPointer<vtkColorTransferFunction> ForceColours(double largest)
{
  const double stops[][3] = { { 0.16, 0.30, 0.85 }, { 0.10, 0.66, 0.95 }, { 0.10, 0.85, 0.62 },
    { 0.55, 0.93, 0.22 }, { 0.98, 0.80, 0.10 }, { 0.97, 0.42, 0.05 }, { 0.75, 0.05, 0.05 } };
  auto colours = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (int i = 0; i < 7; ++i)
  {
    colours->AddRGBPoint(largest * i / 6.0, stops[i][0], stops[i][1], stops[i][2]);
  }
  return colours;
}

/// Labels of the colour scale: 0, Step, 2 Step ... up to the largest force or just above.
struct Scale
{
  double Step;
  int Steps;
};

Scale ChooseScale(double largest)
{
  const double wanted = std::max(largest, 0.01) / 5.0;
  const double unit = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = 10.0 * unit;
  for (const double factor : { 5.0, 2.0, 1.0 })
  {
    step = wanted <= factor * unit ? factor * unit : step;
  }
  return { step, std::max(1, static_cast<int>(std::ceil(largest / step - 1e-6))) };
}

void AddScalarBar(
  vtkRenderer* renderer, vtkScalarsToColors* colours, const Scale& scale, int pictureHeight)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colours);
  bar->SetTitle(FORCE_NAME);
  bar->SetNumberOfLabels(scale.Steps + 1);
  bar->SetLabelFormat(scale.Step < 0.1 ? "%.2f" : scale.Step < 1.0 ? "%.1f" : "%.0f");
  bar->UnconstrainedFontSizeOn();
  bar->SetPosition(0.86, 0.22);
  bar->SetWidth(0.11);
  bar->SetHeight(0.56);
  bar->SetBarRatio(0.28);
  bar->SetTitleRatio(0.5);
  bar->SetVerticalTitleSeparation(std::max(4, pictureHeight / 70));
  for (vtkTextProperty* text : { bar->GetTitleTextProperty(), bar->GetLabelTextProperty() })
  {
    text->SetFontSize(std::max(9, pictureHeight / 42));
    text->SetColor(0.93, 0.95, 0.98);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
  }
  renderer->AddViewProp(bar);
}
} // namespace

namespace Explore
{
namespace
{
/// Adds a tube along the proxy's path, coloured by the magnitude of the force, and its scalar bar.
/// Adds a faint copy to `overlay`, which is drawn over the renderer's picture, so that occluded
/// parts of the tube stay visible.

void AddTrail(vtkRenderer* renderer, vtkRenderer* overlay, vtkPolyData* trace,
  double metersPerWorldUnit, int pictureHeight)
{
  vtkSmartPointer<vtkPolyData> thinned = Thin(trace, SPACING / metersPerWorldUnit);
  double range[2];
  thinned->GetPointData()->GetScalars()->GetRange(range);
  const Scale scale = ChooseScale(range[1]);
  auto colours = ForceColours(scale.Step * scale.Steps);

  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(thinned);
  tube->SetRadius(TUBE_RADIUS / metersPerWorldUnit);
  tube->SetNumberOfSides(14);
  tube->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tube->GetOutputPort());
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.75);
  actor->GetProperty()->SetSpecular(0.25);
  actor->GetProperty()->SetSpecularPower(25.0);
  renderer->AddActor(actor);
  vtkNew<vtkActor> ghost;
  ghost->SetMapper(mapper);
  ghost->GetProperty()->LightingOff();
  ghost->GetProperty()->SetOpacity(0.3);
  overlay->AddActor(ghost);
  AddScalarBar(renderer, colours, scale, pictureHeight);
}
} // namespace
} // namespace Explore

namespace
{
using Explore::ExplorerScene;
using Explore::MapperChoice;

/// Returns the image without its origin, spacing and direction. VTK 9.1's CPU mapper ignores the
/// direction matrix, so both mappers get the plain block of voxels, and the volume's own matrix
/// places it in the world.
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

/// Makes the mapper. Samples have no jitter, so that every run renders the same picture.
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
    window->Render(); // creates the OpenGL context, which the checks below need
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
    // If OpenGL runs on the CPU, prefer VTK's CPU ray caster in a window: it takes a fifth of the
    // time, and input can interrupt it. A picture may take longer.
    gpu = IsGPUUsable(scene.Window, property, image) &&
      !(options.Interactive && VolumeHaptics::IsSoftwareOpenGL(scene.Window));
  }
  const double* spacing = image->GetSpacing();
  // A frame on the graphics card can't be interrupted, so use coarser samples in a window than in a
  // picture.
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
  // Set the letters now. Otherwise the cube would set them, and extract their edges, several times
  // in each frame.
  cube->HasTranslucentPolygonalGeometry(); // sets the letters as a side effect
  scene.Marker->AddActor(cube->GetAssembly());
  Explore::ViewFrame centred = view;
  centred.Centre = vtkVector3d(0.0, 0.0, 0.0);
  Explore::AimCamera(scene.Marker, centred, 5.0);
}

/// Adds a light at the camera's upper left, and ambient light, so that no side is black.
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

  // before the first rendering, because VTK would otherwise add a default light
  AddLights(scene.Renderer);
  // Show a moving volume complete, as it is felt.
  const bool isMoving = exploration.Input.TimeSteps != nullptr;
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
