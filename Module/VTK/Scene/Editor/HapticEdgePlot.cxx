// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticEdgePlot.h"

#include "vtkContext2D.h"
#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkTable.h"

#include <cmath>

vtkStandardNewMacro(HapticEdgePlot);

namespace
{
using VolumeHaptics::EdgeHistogram;

constexpr unsigned char HistogramColour[3] = { 120, 70, 20 };
constexpr double MostOpacity = 190.0; // of 255
constexpr unsigned char ArcColour[3] = { 205, 90, 20 };
constexpr unsigned char LevelColour[3] = { 110, 115, 125 };

} // namespace

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
  if (!histogram.Shares.empty())
  {
    this->Picture->SetDimensions(EdgeHistogram::Columns, EdgeHistogram::Rows, 1);
    this->Picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto* pixel = static_cast<unsigned char*>(this->Picture->GetScalarPointer());
    for (const double share : histogram.Shares)
    {
      for (const unsigned char part : HistogramColour)
      {
        *pixel++ = part;
      }
      *pixel++ = static_cast<unsigned char>(MostOpacity * share);
    }
  }
  // Kindlmann and Durkin's arc: g_max exp(-x^2 / 2) over V1 + (V2 - V1) Phi(x).
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
      const double share = 0.5 * std::erfc(-x / std::sqrt(2.0));
      arc.push_back({ low + share * (high - low), height * std::exp(-0.5 * x * x) });
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
    corners.push_back(static_cast<float>(point.Share));
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
    const double share = level / this->MostSlope;
    if (share > 0.0 && share < 1.0)
    {
      this->DrawLine(painter, { { this->Values[0], share }, { this->Values[1], share } });
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
