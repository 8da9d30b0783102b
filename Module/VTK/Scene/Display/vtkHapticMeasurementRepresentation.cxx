// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticMeasurementRepresentation.h"

#include "Core/Math/Vector3.h"
#include "VTK/Base/HapticTuples.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Scene/Base/HapticDrawing.h"
#include "VTK/Scene/Display/DisplayProbe.h"
#include "VTK/Scene/Display/HapticMeasurementViewSettings.h"
#include "VTK/Scene/Hand/SceneMarker.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkGlyph3D.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticMeasurements.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTubeFilter.h"

#include VOLUME_HAPTICS_OPENGL_HEADER

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

class vtkViewport;
class vtkWindow;

namespace VolumeHaptics
{
namespace
{

/**
 * Draws texts beside points of the scene, so that they overlap neither each other nor the head-up
 * display.
 */
class MeasuredLabels
{
public:
  /** Box in pixels of the viewport. */
  struct Box
  {
    double Left;
    double Right;
    double Bottom;
    double Top;
  };

  struct Label
  {
    std::string Text;
    Vector3 Place; ///< world
  };

  /**
   * Draws labels in the overlay pass. Labels at the start of the list get their preferred positions
   * first. Omits a label if there is no space for it. Returns the number of drawn labels.
   */
  int Render(vtkRenderer* renderer, const std::vector<Label>& labels,
    const std::function<bool(const Box&)>& isTaken);
  void Release(vtkWindow* window);

private:
  std::vector<std::unique_ptr<vtkNew<vtkTextActor>>> Actors;
};

using Box = MeasuredLabels::Box;

constexpr int FontSize = 13;  // points
constexpr double Near = 12.0; ///< pixels between the point and the text
constexpr double Step = 18.0; ///< pixels by which the distance grows from try to try
constexpr int LabelRounds = 4;
constexpr double LabelMargin = 3.0;

bool Overlap(const Box& a, const Box& b)
{
  return a.Left < b.Right && b.Left < a.Right && a.Bottom < b.Top && b.Bottom < a.Top;
}

/** Returns a box of the given size on one of eight sides of a point. */
Box PutBeside(const double at[2], const double size[2], int side, double distance)
{
  // In order of preference: the right side is best to read, then left, above and below.
  static const double sides[8][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 }, { 0.7, 0.7 },
    { 0.7, -0.7 }, { -0.7, 0.7 }, { -0.7, -0.7 } };
  const double* const to = sides[side];
  const auto fraction = [](double way) { return way > 0.0 ? 0.0 : (way < 0.0 ? -1.0 : -0.5); };
  const double left = at[0] + distance * to[0] + fraction(to[0]) * size[0];
  const double bottom = at[1] + distance * to[1] + fraction(to[1]) * size[1];
  return { left, left + size[0], bottom, bottom + size[1] };
}

int MeasuredLabels::Render(vtkRenderer* renderer, const std::vector<Label>& labels,
  const std::function<bool(const Box&)>& isTaken)
{
  while (this->Actors.size() < labels.size())
  {
    this->Actors.push_back(std::make_unique<vtkNew<vtkTextActor>>());
    vtkTextProperty* const text = (*this->Actors.back())->GetTextProperty();
    text->SetFontSize(FontSize);
    text->SetColor(0.93, 0.97, 0.98);
    text->SetBackgroundColor(0.05, 0.09, 0.11);
    text->SetBackgroundOpacity(0.7);
  }
  const int* const view = renderer->GetSize();
  const int* const origin = renderer->GetOrigin();
  std::vector<Box> taken;
  int drawn = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const Vector3& place = labels[i].Place;
    double shown[3];
    renderer->SetWorldPoint(place.X, place.Y, place.Z, 1.0);
    renderer->WorldToDisplay();
    renderer->GetDisplayPoint(shown);
    const double at[2] = { shown[0] - origin[0], shown[1] - origin[1] };
    if (!(shown[2] > 0.0 && shown[2] < 1.0) || at[0] < 0.0 || at[0] > view[0] || at[1] < 0.0 ||
      at[1] > view[1])
    {
      continue;
    }
    vtkTextActor* const actor = *this->Actors[i];
    actor->SetInput(labels[i].Text.c_str());
    double size[2];
    actor->GetSize(renderer, size);
    bool isPlaced = false;
    for (int round = 0; round < LabelRounds * 8 && !isPlaced; ++round)
    {
      const Box box = PutBeside(at, size, round % 8, Near + Step * (round / 8));
      const Box wide{ box.Left - LabelMargin, box.Right + LabelMargin, box.Bottom - LabelMargin,
        box.Top + LabelMargin };
      isPlaced = wide.Left >= 0.0 && wide.Right <= view[0] && wide.Bottom >= 0.0 &&
        wide.Top <= view[1] && !isTaken(wide) &&
        std::none_of(
          taken.begin(), taken.end(), [&wide](const Box& other) { return Overlap(wide, other); });
      if (isPlaced)
      {
        taken.push_back(wide);
        actor->SetPosition(box.Left, box.Bottom);
      }
    }
    if (isPlaced)
    {
      actor->RenderOpaqueGeometry(renderer); // renders the text into the texture that is drawn next
      actor->RenderOverlay(renderer);
      ++drawn;
    }
  }
  return drawn;
}

void MeasuredLabels::Release(vtkWindow* window)
{
  for (auto& actor : this->Actors)
  {
    (*actor)->ReleaseGraphicsResources(window);
  }
}

/**
 * Shapes of measurements in the scene: spheres for points, tubes for lines, patches for areas. They
 * are faintly visible through objects in front of them.
 */
class MeasuredShapes
{
public:
  MeasuredShapes(double red, double green, double blue);
  ~MeasuredShapes();

  /** Removes all shapes, and sets the radius of spheres (world units). */
  void Clear(double radius);
  /** Adds the shape of a measurement of a vtkHapticMeasurements::KindType. */
  void Add(int kind, vtkPolyData* shape);

  void RenderOpaque(vtkViewport* viewport);
  /** Draws a faint copy of the shapes over objects that hide them. */
  void RenderHidden(vtkViewport* viewport);
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box);

private:
  /** Adds a line, without points that are too close to the previous one to be distinguished. */
  void AddLine(vtkPolyData* shape);
  void AddArc(vtkPolyData* angle);
  void AddPatch(vtkPolyData* shape);

  struct Part
  {
    vtkNew<vtkPolyData> Data;
    vtkNew<vtkPolyDataMapper> Mapper;
    vtkNew<vtkActor> Solid;
    vtkNew<vtkActor> Ghost;
  };
  std::array<Part, 3> Parts;
  Part& Spheres = Parts[0];
  Part& Tubes = Parts[1];
  Part& Patches = Parts[2];
  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkGlyph3D> Glyphs;
  vtkNew<vtkTubeFilter> Tube;
  double Radius = 1.0;
};

/** Radius of lines, relative to the radius of spheres. */
constexpr double LineRadius = 0.3;
/** Radius of an angle's arc, relative to its shorter leg. */
constexpr double ArcRadius = 0.3;
constexpr int ArcSteps = 32;

void Begin(vtkPolyData* data)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  data->Initialize();
  data->SetPoints(points);
  data->SetVerts(vtkNew<vtkCellArray>());
  data->SetLines(vtkNew<vtkCellArray>());
  data->SetPolys(vtkNew<vtkCellArray>());
}

vtkIdType AddPoint(vtkPolyData* data, const Vector3& p)
{
  return data->GetPoints()->InsertNextPoint(p.X, p.Y, p.Z);
}

MeasuredShapes::MeasuredShapes(double red, double green, double blue)
{
  this->Sphere->SetThetaResolution(20);
  this->Sphere->SetPhiResolution(14);
  this->Glyphs->SetInputData(this->Spheres.Data);
  this->Glyphs->SetSourceConnection(this->Sphere->GetOutputPort());
  this->Glyphs->ScalingOff();
  this->Glyphs->OrientOff();
  this->Glyphs->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  this->Tube->SetInputData(this->Tubes.Data);
  this->Tube->SetNumberOfSides(8);
  this->Tube->CappingOn();
  this->Spheres.Mapper->SetInputConnection(this->Glyphs->GetOutputPort());
  this->Tubes.Mapper->SetInputConnection(this->Tube->GetOutputPort());
  this->Patches.Mapper->SetInputData(this->Patches.Data);
  for (Part& part : this->Parts)
  {
    part.Mapper->ScalarVisibilityOff();
    part.Solid->SetMapper(part.Mapper);
    part.Solid->GetProperty()->SetColor(red, green, blue);
    part.Solid->GetProperty()->SetAmbient(0.35);
    part.Solid->GetProperty()->SetDiffuse(0.65);
    part.Ghost->SetMapper(part.Mapper);
    part.Ghost->GetProperty()->SetColor(red, green, blue);
    part.Ghost->GetProperty()->LightingOff();
    part.Ghost->GetProperty()->SetOpacity(HiddenOpacity);
    part.Ghost->ForceOpaqueOn(); // the overlay pass does not sort translucent objects
    Begin(part.Data);
  }
}

MeasuredShapes::~MeasuredShapes() = default;

void MeasuredShapes::Clear(double radius)
{
  this->Radius = radius;
  this->Sphere->SetRadius(radius);
  this->Tube->SetRadius(LineRadius * radius);
  for (Part& part : this->Parts)
  {
    Begin(part.Data);
  }
}

void MeasuredShapes::Add(int kind, vtkPolyData* shape)
{
  const vtkIdType count = shape->GetNumberOfPoints();
  if (count == 0)
  {
    return;
  }
  if (kind == vtkHapticMeasurements::AREA)
  {
    this->AddPatch(shape);
    return;
  }
  const bool isPath = kind == vtkHapticMeasurements::PATH;
  for (vtkIdType i = 0; i < count; i += isPath ? std::max<vtkIdType>(count - 1, 1) : 1)
  {
    AddPoint(this->Spheres.Data, FromArray(shape->GetPoint(i)));
  }
  if (count > 1)
  {
    this->AddLine(shape);
  }
  if (kind == vtkHapticMeasurements::ANGLE && count == 3)
  {
    this->AddArc(shape);
  }
}

void MeasuredShapes::AddLine(vtkPolyData* shape)
{
  const vtkIdType last = shape->GetNumberOfPoints() - 1;
  vtkNew<vtkIdList> line;
  Vector3 before;
  for (vtkIdType i = 0; i <= last; ++i)
  {
    const Vector3 point = FromArray(shape->GetPoint(i));
    // Skip a point that is close to the previous one. Skip the last point only if it equals the
    // previous one, since a tube needs segments of non-zero length.
    const double least = i == last ? 0.0 : 0.5 * this->Radius;
    if (i == 0 || Norm(point - before) > least)
    {
      line->InsertNextId(AddPoint(this->Tubes.Data, point));
      before = point;
    }
  }
  if (line->GetNumberOfIds() > 1)
  {
    this->Tubes.Data->GetLines()->InsertNextCell(line);
  }
}

void MeasuredShapes::AddArc(vtkPolyData* angle)
{
  const Vector3 corner = FromArray(angle->GetPoint(1));
  const Vector3 legs[2] = { FromArray(angle->GetPoint(0)) - corner,
    FromArray(angle->GetPoint(2)) - corner };
  const double lengths[2] = { Norm(legs[0]), Norm(legs[1]) };
  // Unit vector perpendicular to the first leg, towards the second.
  const Vector3 across = Cross(Cross(legs[0], legs[1]), legs[0]);
  if (!(Norm(across) > 0.0))
  {
    return; // no arc, because the angle is 0 or 180 degrees, or a leg has no length
  }
  const Vector3 x = (1.0 / lengths[0]) * legs[0];
  const Vector3 y = (1.0 / Norm(across)) * across;
  const double whole = std::atan2(Dot(legs[1], y), Dot(legs[1], x));
  const double radius = ArcRadius * std::min(lengths[0], lengths[1]);
  this->Tubes.Data->GetLines()->InsertNextCell(ArcSteps + 1);
  for (int i = 0; i <= ArcSteps; ++i)
  {
    const double turn = whole * i / ArcSteps;
    this->Tubes.Data->GetLines()->InsertCellPoint(AddPoint(
      this->Tubes.Data, corner + radius * std::cos(turn) * x + radius * std::sin(turn) * y));
  }
}

void MeasuredShapes::AddPatch(vtkPolyData* shape)
{
  const vtkIdType first = this->Patches.Data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
  {
    AddPoint(this->Patches.Data, FromArray(shape->GetPoint(i)));
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < shape->GetNumberOfPolys(); ++i)
  {
    shape->GetPolys()->GetCellAtId(i, corners);
    for (vtkIdType c = 0; c < corners->GetNumberOfIds(); ++c)
    {
      corners->SetId(c, first + corners->GetId(c));
    }
    this->Patches.Data->GetPolys()->InsertNextCell(corners);
  }
}

void MeasuredShapes::RenderOpaque(vtkViewport* viewport)
{
  for (Part& part : this->Parts)
  {
    if (part.Data->GetNumberOfPoints() > 0)
    {
      part.Solid->RenderOpaqueGeometry(viewport);
    }
  }
}

void MeasuredShapes::RenderHidden(vtkViewport* viewport)
{
  for (Part& part : this->Parts)
  {
    if (part.Data->GetNumberOfPoints() > 0)
    {
      part.Ghost->RenderOpaqueGeometry(viewport);
    }
  }
}

void MeasuredShapes::Release(vtkWindow* window)
{
  for (Part& part : this->Parts)
  {
    part.Solid->ReleaseGraphicsResources(window);
    part.Ghost->ReleaseGraphicsResources(window);
  }
}

void MeasuredShapes::AddTo(vtkBoundingBox& box)
{
  for (Part& part : this->Parts)
  {
    if (part.Data->GetNumberOfPoints() > 0)
    {
      box.AddBounds(part.Data->GetBounds());
    }
  }
}

} // namespace
} // namespace VolumeHaptics

vtkStandardNewMacro(vtkHapticMeasurementRepresentation);

using namespace VolumeHaptics;

namespace
{

/**
 * Returns the position of a label: at a point, in the middle of a distance, at the corner of an
 * angle, at the end of a path, or at the point of an area that is nearest to its centre.
 */
Vector3 ComputePlace(int kind, vtkPolyData* shape)
{
  const vtkIdType count = shape->GetNumberOfPoints();
  const auto at = [shape](vtkIdType i) { return FromArray(shape->GetPoint(i)); };
  switch (kind)
  {
    case vtkHapticMeasurements::DISTANCE:
      return 0.5 * (at(0) + at(1));
    case vtkHapticMeasurements::ANGLE:
      return at(1);
    case vtkHapticMeasurements::AREA:
    {
      // Use the point of the area nearest to the centre, because the centre itself may be inside
      // the body.
      const double* const b = shape->GetBounds();
      const Vector3 middle{ 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) };
      Vector3 nearest = at(0);
      for (vtkIdType i = 1; i < count; ++i)
      {
        nearest = Norm(at(i) - middle) < Norm(nearest - middle) ? at(i) : nearest;
      }
      return nearest;
    }
    default:
      return at(count - 1);
  }
}

} // namespace

//------------------------------------------------------------------------------
struct vtkHapticMeasurementRepresentation::vtkInternals
{
  vtkSmartPointer<vtkHapticMeasurements> List;
  vtkSmartPointer<vtkHapticHeadUpDisplay> Display;
  MeasuredShapes Shapes{ 0.25, 0.95, 1.0 };
  MeasuredShapes Unfinished{ 1.0, 1.0, 1.0 };
  MeasuredLabels Writing;
  std::vector<MeasuredLabels::Label> Labels;
  vtkMTimeType Built = 0;
  double BuiltRadius = 0.0;
  int Shown = 0;
  vtkBoundingBox Box;
  double Bounds[6];
};

//------------------------------------------------------------------------------
vtkHapticMeasurementRepresentation::vtkHapticMeasurementRepresentation()
  : Internals(new vtkInternals)
{
  this->PickableOff();
}

//------------------------------------------------------------------------------
vtkHapticMeasurementRepresentation::~vtkHapticMeasurementRepresentation() = default;

//------------------------------------------------------------------------------
void vtkHapticMeasurementRepresentation::SetMeasurements(vtkHapticMeasurements* measurements)
{
  if (this->Internals->List != measurements)
  {
    this->Internals->List = measurements;
    this->Internals->Built = 0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticMeasurements* vtkHapticMeasurementRepresentation::GetMeasurements()
{
  return this->Internals->List;
}

//------------------------------------------------------------------------------
void vtkHapticMeasurementRepresentation::SetHeadUpDisplay(vtkHapticHeadUpDisplay* display)
{
  if (this->Internals->Display != display)
  {
    this->Internals->Display = display;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticHeadUpDisplay* vtkHapticMeasurementRepresentation::GetHeadUpDisplay()
{
  return this->Internals->Display;
}

//------------------------------------------------------------------------------
int DisplayProbe::CountLabels(vtkHapticMeasurementRepresentation* measurements)
{
  return measurements->Internals->Shown;
}

//------------------------------------------------------------------------------
void vtkHapticMeasurementRepresentation::Build()
{
  auto& d = *this->Internals;
  const vtkMTimeType time = d.List ? d.List->GetMTime() : 1;
  if (time == d.Built && this->Radius == d.BuiltRadius)
  {
    return;
  }
  d.Built = time;
  d.BuiltRadius = this->Radius;
  d.Shapes.Clear(this->Radius);
  d.Unfinished.Clear(this->Radius);
  d.Labels.clear();
  if (!d.List)
  {
    return;
  }
  vtkNew<vtkPolyData> shape;
  for (vtkIdType i = 0; i < d.List->GetNumberOfMeasurements(); ++i)
  {
    const int kind = d.List->GetKind(i);
    d.List->GetShape(i, shape);
    d.Shapes.Add(kind, shape);
    d.Labels.push_back({ d.List->GetText(i), ComputePlace(kind, shape) });
  }
  d.List->GetUnfinished(shape);
  d.Unfinished.Add(d.List->GetUnfinishedKind(), shape);
}

//------------------------------------------------------------------------------
double* vtkHapticMeasurementRepresentation::GetBounds()
{
  auto& d = *this->Internals;
  this->Build();
  d.Box.Reset();
  d.Shapes.AddTo(d.Box);
  d.Unfinished.AddTo(d.Box);
  if (!d.Box.IsValid())
  {
    return nullptr;
  }
  d.Box.Inflate(this->Radius);
  d.Box.GetBounds(d.Bounds);
  return d.Bounds;
}

//------------------------------------------------------------------------------
int vtkHapticMeasurementRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  if (!VolumeHaptics::IsDrawing(viewport))
  {
    return 0;
  }
  this->Build();
  this->Internals->Shapes.RenderOpaque(viewport);
  this->Internals->Unfinished.RenderOpaque(viewport);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHapticMeasurementRepresentation::RenderOverlay(vtkViewport* viewport)
{
  auto& d = *this->Internals;
  d.Shown = 0;
  vtkRenderer* const renderer = vtkRenderer::SafeDownCast(viewport);
  if (!renderer || !VolumeHaptics::IsDrawing(viewport))
  {
    return 0;
  }
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (this->HiddenVisibility && window)
  {
    vtkOpenGLState* const state = window->GetState();
    const vtkOpenGLState::ScopedglEnableDisable depth(state, GL_DEPTH_TEST);
    const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    d.Shapes.RenderHidden(viewport);
    d.Unfinished.RenderHidden(viewport);
  }
  if (this->LabelVisibility)
  {
    const auto isTaken = [&d](const MeasuredLabels::Box& box)
    {
      const double sides[4] = { box.Left, box.Right, box.Bottom, box.Top };
      return d.Display && d.Display->Covers(sides);
    };
    d.Shown = d.Writing.Render(renderer, d.Labels, isTaken);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticMeasurementRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Shapes.Release(window);
  this->Internals->Unfinished.Release(window);
  this->Internals->Writing.Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkHapticMeasurementRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Measurements: " << this->GetMeasurements() << "\n";
  os << indent << "HeadUpDisplay: " << this->GetHeadUpDisplay() << "\n";
  PrintSettings(os, indent, this, MeasurementViewSettings);
}
