// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticChartBackground.h"

#include "VTK/Scene/Base/HapticChartText.h"
#include "VTK/Scene/Editor/HapticMaterialList.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkRect.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkTransform2D.h"

#include <algorithm>
#include <cmath>

namespace
{

using VolumeHaptics::EdgeHistogram;

constexpr unsigned char HistogramColour[3] = { 120, 70, 20 };
constexpr double MostOpacity = 190.0; // opacity, of at most 255
constexpr unsigned char ArcColour[3] = { 205, 90, 20 };
constexpr unsigned char LevelColour[3] = { 110, 115, 125 };

} // namespace

vtkStandardNewMacro(HapticEdgePlot);

//------------------------------------------------------------------------------
HapticEdgePlot::HapticEdgePlot()
{
  this->SetInteractive(false);
  this->SetSelectable(false);
}

HapticEdgePlot::~HapticEdgePlot() = default;

//------------------------------------------------------------------------------
void HapticEdgePlot::ShowEdges(const EdgeHistogram& histogram, vtkHapticProperty* proposed)
{
  vtkTable* const boundaries = proposed ? proposed->GetProposedBoundaries() : nullptr;
  this->Values[0] = histogram.Values[0];
  this->Values[1] = histogram.Values[1];
  this->MostSlope = histogram.MostSlope;
  this->Picture->Initialize();
  if (!histogram.Fractions.empty())
  {
    this->Picture->SetDimensions(EdgeHistogram::Columns, EdgeHistogram::Rows, 1);
    this->Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto* pixel = static_cast<unsigned char*>(this->Picture->GetScalarPointer());
    for (const double fraction : histogram.Fractions)
    {
      for (const unsigned char part : HistogramColour)
      {
        *pixel++ = part;
      }
      *pixel++ = static_cast<unsigned char>(MostOpacity * fraction);
    }
  }
  // Compute the arc of a boundary after Kindlmann and Durkin: gradient magnitude g_max exp(-x^2 /
  // 2) at value V1 + (V2 - V1) Phi(x).
  this->Arcs.clear();
  for (vtkIdType i = 0; boundaries && i < boundaries->GetNumberOfRows(); ++i)
  {
    const auto get = [&](const char* name)
    { return vtkDataArray::SafeDownCast(boundaries->GetColumnByName(name))->GetComponent(i, 0); };
    const double low = proposed->ValueToScalar(get("Low"));
    const double high = proposed->ValueToScalar(get("High"));
    const double height = get("Slope") / proposed->GetScalarScale() / this->MostSlope;
    constexpr int steps = 48;
    constexpr double reach = 3.0;
    std::vector<ArcPoint> arc;
    for (int k = 0; k <= steps; ++k)
    {
      const double x = reach * (2.0 * k / steps - 1.0);
      const double fraction = 0.5 * std::erfc(-x / std::sqrt(2.0));
      arc.push_back({ low + fraction * (high - low), height * std::exp(-0.5 * x * x) });
    }
    this->Arcs.push_back(arc);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void HapticEdgePlot::ShowDistinctness(double start, double full)
{
  this->Distinctness[0] = start;
  this->Distinctness[1] = full;
}

//------------------------------------------------------------------------------
void HapticEdgePlot::ScaleValues(const VolumeHaptics::ValueScale& scale)
{
  this->ToValue = scale;
  this->Modified();
}

//------------------------------------------------------------------------------
float HapticEdgePlot::Scaled(double scalar)
{
  const vtkRectd scale = this->GetShiftScale();
  return static_cast<float>((this->ToValue(scalar) + scale[0]) * scale[2]);
}

//------------------------------------------------------------------------------
void HapticEdgePlot::DrawLine(vtkContext2D* painter, const std::vector<ArcPoint>& points)
{
  std::vector<float> corners;
  for (const ArcPoint& point : points)
  {
    corners.push_back(this->Scaled(point.Value));
    corners.push_back(static_cast<float>(point.Fraction));
  }
  painter->DrawPoly(corners.data(), static_cast<int>(points.size()));
}

//------------------------------------------------------------------------------
bool HapticEdgePlot::Paint(vtkContext2D* painter)
{
  if (!this->Visible)
  {
    return false;
  }
  const float left = this->Scaled(this->Values[0]);
  const float right = this->Scaled(this->Values[1]);
  if (this->Picture->GetNumberOfPoints() > 0)
  {
    painter->DrawImage(vtkRectf(left, 0.0f, right - left, 1.0f), this->Picture);
  }
  vtkPen* const pen = painter->GetPen();
  pen->SetOpacity(255);
  pen->SetWidth(1.0f);
  pen->SetLineType(vtkPen::DOT_LINE);
  pen->SetColor(LevelColour[0], LevelColour[1], LevelColour[2], 255);
  for (const double level : this->Distinctness)
  {
    const double fraction = level / this->MostSlope;
    if (fraction > 0.0 && fraction < 1.0)
    {
      this->DrawLine(painter, { { this->Values[0], fraction }, { this->Values[1], fraction } });
    }
  }
  pen->SetLineType(vtkPen::SOLID_LINE);
  pen->SetWidth(1.5f);
  pen->SetColor(ArcColour[0], ArcColour[1], ArcColour[2], 255);
  for (const auto& arc : this->Arcs)
  {
    this->DrawLine(painter, arc);
  }
  return true;
}

//------------------------------------------------------------------------------
void HapticEdgePlot::GetBounds(double bounds[4])
{
  bounds[0] = this->ToValue(this->Values[0]);
  bounds[1] = this->ToValue(this->Values[1]);
  bounds[2] = 0.0;
  bounds[3] = 1.0;
}

namespace
{

constexpr int BandOpacity = 110; // of 255, so that the histogram stays visible
constexpr double BandInk[3] = { 0.25, 0.27, 0.31 };
constexpr float NameMargin = 3.0f; // pixels

} // namespace

vtkStandardNewMacro(HapticTissueBands);

//------------------------------------------------------------------------------
HapticTissueBands::HapticTissueBands()
{
  this->SetInteractive(false);
  this->SetSelectable(false);
}

HapticTissueBands::~HapticTissueBands() = default;

//------------------------------------------------------------------------------
void HapticTissueBands::Show(vtkHapticProperty* property, const VolumeHaptics::ValueScale& toValue,
  const double range[2], int letters)
{
  this->Bands.clear();
  std::copy_n(range, 2, this->Range);
  this->Letters = letters;
  const int tissues = property ? property->GetNumberOfTissues() : 0;
  for (int i = 0; i < tissues; ++i)
  {
    double values[2];
    property->GetTissueRange(i, values);
    std::transform(values, values + 2, values,
      [&](double value) { return toValue(property->ValueToScalar(value)); });
    const double low = i == 0 ? range[0] : values[0];
    const double high = i + 1 == tissues ? range[1] : values[1];
    if (high > range[0] && low < range[1])
    {
      this->Bands.push_back({ property->GetTissueName(i), std::max(low, range[0]),
        std::min(high, range[1]), VolumeHaptics::GetTissueColor(i) });
    }
  }
  this->SetVisible(!this->Bands.empty());
}

//------------------------------------------------------------------------------
void HapticTissueBands::PaintName(
  vtkContext2D* painter, const Band& band, const vtkRectf& place) const
{
  vtkTextProperty* const text = painter->GetTextProp();
  VolumeHaptics::SetChartText(text, this->Letters, BandInk);
  float bounds[4]; // x and y of the lower left corner, width, height
  text->SetOrientation(0.0);
  painter->ComputeStringBounds(band.Name, bounds);
  const bool isUpright = bounds[2] + 2.0f * NameMargin > place.GetWidth();
  const float across = isUpright ? bounds[3] : bounds[2];
  const float along = isUpright ? bounds[2] : bounds[3];
  if (across + 1.0f > place.GetWidth() || along + 2.0f * NameMargin > place.GetHeight())
  {
    return;
  }
  const float middle = std::round(place.GetLeft() + 0.5f * place.GetWidth());
  const float top = place.GetTop() - NameMargin;
  if (isUpright)
  {
    // Start the name below the end of the function's axis, which is at the top.
    text->SetOrientation(90.0);
    text->SetJustificationToCentered();
    text->SetVerticalJustificationToCentered();
    painter->DrawString(middle, std::round(top - 0.5f * bounds[2]), band.Name);
    text->SetOrientation(0.0);
    return;
  }
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToTop();
  painter->DrawString(middle, std::round(top), band.Name);
}

//------------------------------------------------------------------------------
bool HapticTissueBands::Paint(vtkContext2D* painter)
{
  if (!this->Visible)
  {
    return false;
  }
  // Draw in pixels, since the size of letters is in pixels.
  const vtkRectd scale = this->GetShiftScale();
  const auto scaled = [&scale](double value)
  { return static_cast<float>((value + scale[0]) * scale[2]); };
  std::vector<vtkRectf> places;
  for (const Band& band : this->Bands)
  {
    float corners[4] = { scaled(band.Low), 0.0f, scaled(band.High), 1.0f };
    painter->GetTransform()->TransformPoints(corners, corners, 2);
    places.emplace_back(corners[0], corners[1], corners[2] - corners[0], corners[3] - corners[1]);
  }
  vtkNew<vtkTransform2D> pixels;
  painter->PushMatrix();
  painter->SetTransform(pixels);
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    constexpr double most = 255.0;
    const std::array<double, 3>& color = this->Bands[i].Color;
    painter->GetBrush()->SetColor(static_cast<unsigned char>(most * color[0]),
      static_cast<unsigned char>(most * color[1]), static_cast<unsigned char>(most * color[2]),
      BandOpacity);
    const vtkRectf& place = places[i];
    painter->DrawRect(place.GetX(), place.GetY(), place.GetWidth(), place.GetHeight());
  }
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    this->PaintName(painter, this->Bands[i], places[i]);
  }
  painter->PopMatrix();
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  return true;
}

//------------------------------------------------------------------------------
void HapticTissueBands::GetBounds(double bounds[4])
{
  bounds[0] = this->Range[0];
  bounds[1] = this->Range[1];
  bounds[2] = 0.0;
  bounds[3] = 1.0;
}
