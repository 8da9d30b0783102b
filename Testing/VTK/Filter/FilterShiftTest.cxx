// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that a CT in other units has the same forces as the CT in Hounsfield units. The reference
 * is the same body in Hounsfield units: air at -1000, and a ball of fat, muscle and bone. Programs
 * store the units 1024 or 1000 higher (InVesalius passes uint16 with 1024 to its mapper), or 32768
 * higher.
 */

#include "Rigs/ApiRig.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkHapticNeedle.h>
#include <vtkHapticRegionFilter.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace apitest;

namespace
{
constexpr vtkIdType Ticks = 301;
constexpr int Width = 48;
/// Tolerance (N) for rounding. The force does not depend on the shift, but sums of shifted values
/// are rounded differently. A solver that accepts a result within 2e-4 of its lag may then accept a
/// different result.
constexpr double Rounded = 1e-4;
constexpr double Middle = 0.5 * (Width - 1);

/// Returns the value (HU) of a blurred ball with layers and noise of up to 8 HU.
double Unit(const Point& p)
{
  static std::uint32_t random = 1;
  random = p[0] == 0.0 && p[1] == 0.0 && p[2] == 0.0 ? 1 : random;
  random = random * 1664525U + 1013904223U;
  const double noise = 16.0 * (static_cast<double>(random >> 8) * 0x1p-24 - 0.5);
  const double r = std::hypot(p[0] - Middle, p[1] - Middle, p[2] - Middle);
  const auto inside = [r](double radius) { return 0.5 * std::erfc((r - radius) / 1.0); };
  // Scanners store no values below -1000 HU, so clip the noise.
  return std::max(-1000.0,
    std::round(
      -1000.0 + 900.0 * inside(20.0) + 150.0 * inside(16.0) + 950.0 * inside(8.0) + noise));
}

class FilterShift : public ApiTest
{
protected:
  /// Makes a body with the values (HU + offset) * factor, and a path that presses from air into the
  /// muscle and slides.
  void SetBody(double offset, double factor, int scalarType)
  {
    this->Image = MakeImage(Width, scalarType,
      [=](const Point& p) {
        return std::max((Unit(p) + offset) * factor, scalarType == VTK_UNSIGNED_SHORT ? 0.0 : -1e9);
      });
    this->Filter->SetInputDataObject(0, this->Image);
    std::vector<Point> points = Line({ Middle, Middle, 0.5 }, { Middle, Middle, 9.0 }, 200);
    const std::vector<Point> slide =
      Line({ Middle + 0.02, Middle, 9.0 }, { Middle + 2.0, Middle, 9.0 }, 99);
    points.insert(points.end(), slide.begin(), slide.end());
    points.push_back(points.back());
    this->Filter->SetPathData(MakePath(points));
  }

  vtkSmartPointer<vtkPolyData> Feel()
  {
    this->Filter->Update();
    EXPECT_TRUE(this->Log.Errors.empty()) << this->Log.Errors.front();
    return Keep(this->Filter);
  }

  /// Returns the trace for values in HU, which is the reference.
  vtkSmartPointer<vtkPolyData> FeelUnits(const char* preset)
  {
    this->SetBody(0.0, 1.0, VTK_SHORT);
    this->Property->ApplyPreset(preset);
    auto trace = this->Feel();
    EXPECT_TRUE(this->Log.Warnings.empty());
    EXPECT_EQ(this->Property->GetFoundShift(), 0.0);
    return trace;
  }

  static double Apart(vtkPolyData* a, vtkPolyData* b)
  {
    double most = 0.0;
    for (vtkIdType tick = 0; tick < Ticks; ++tick)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        most = std::max(most, std::abs(Get(a, "Force", tick, axis) - Get(b, "Force", tick, axis)));
      }
    }
    return most;
  }

  static double Most(vtkPolyData* trace)
  {
    double most = 0.0;
    for (vtkIdType tick = 0; tick < Ticks; ++tick)
    {
      most = std::max(most, std::abs(Get(trace, "Force", tick, 2)));
    }
    return most;
  }
};
} // namespace

TEST_F(FilterShift, IsFoundAndTold)
{
  for (const char* const preset : { "CT contrast", "CT physical", "CT angiography", "CT chest" })
  {
    SCOPED_TRACE(preset);
    this->Log.Warnings.clear();
    const auto units = this->FeelUnits(preset);
    EXPECT_GT(Most(units), 0.2);
    for (const double offset : { 1024.0, 1000.0, 32768.0 })
    {
      SCOPED_TRACE(offset);
      this->Log.Warnings.clear();
      this->SetBody(offset, 1.0, offset == 1000.0 ? VTK_SHORT : VTK_UNSIGNED_SHORT);
      EXPECT_LT(Apart(this->Feel(), units), Rounded);
      EXPECT_EQ(this->Property->GetFoundShift(), -offset);
      ASSERT_EQ(this->Log.Warnings.size(), 1U);
      for (const std::string& part :
        { std::string("Density"), "Hounsfield units + " + std::to_string(static_cast<int>(offset)),
          std::string("SetScalarShift(-") })
      {
        EXPECT_NE(this->Log.Warnings[0].find(part), std::string::npos) << this->Log.Warnings[0];
      }
      this->Filter->Modified();
      this->Filter->Update();
      EXPECT_EQ(this->Log.Warnings.size(), 1U) << "told once";
    }
  }
}

TEST_F(FilterShift, HasTheCuresThatItNames)
{
  const auto units = this->FeelUnits("CT contrast");
  this->SetBody(1024.0, 1.0, VTK_UNSIGNED_SHORT);
  this->Property->SetScalarShift(-1024.0);
  EXPECT_LT(Apart(this->Feel(), units), Rounded);
  EXPECT_TRUE(this->Log.Warnings.empty()) << "nothing is guessed";
  EXPECT_EQ(this->Property->GetFoundShift(), 0.0);

  // Without the shift, air has a value of 24, like water.
  this->Property->SetScalarShift(0.0);
  this->Property->ShiftFromImageOff();
  EXPECT_GT(Apart(this->Feel(), units), 0.1);
  EXPECT_TRUE(this->Log.Warnings.empty());
}

TEST_F(FilterShift, ScalesValuesAndGradients)
{
  const auto units = this->FeelUnits("CT contrast");
  // Values are (scalar + shift) * scale, without rounding for these powers of two.
  this->SetBody(2048.0, 0.25, VTK_DOUBLE);
  this->Property->SetScalarShift(-512.0);
  this->Property->SetScalarScale(4.0);
  EXPECT_LT(Apart(this->Feel(), units), Rounded);
  EXPECT_EQ(this->Property->ScalarToValue(512.0), 0.0);
  EXPECT_EQ(this->Property->ScalarToValue(522.0), 40.0);
  EXPECT_EQ(this->Property->ValueToScalar(40.0), 522.0);
  EXPECT_TRUE(this->Log.Warnings.empty());
}

TEST_F(FilterShift, IsThatOfNeedlesToo)
{
  const vtkNew<vtkHapticNeedle> needle;
  needle->ApplyPreset("CT contrast");
  this->Filter->SetTool(needle);
  const auto units = this->FeelUnits("CT contrast");
  this->SetBody(1024.0, 1.0, VTK_UNSIGNED_SHORT);
  // A needle's stick-slip motion amplifies rounding errors. Wrong cutting forces would differ by
  // 0.3 N in air.
  EXPECT_LT(Apart(this->Feel(), units), 0.02);
  EXPECT_GT(Most(units), 0.05);
}

TEST_F(FilterShift, OfARegionIsThatOfTheWhole)
{
  const vtkNew<vtkHapticRegionFilter> crop;
  crop->SetRegion(6, 41, 6, 41, 0, 30);
  const auto feel = [&](double offset)
  {
    this->SetBody(offset, 1.0, offset == 0.0 ? VTK_SHORT : VTK_UNSIGNED_SHORT);
    crop->SetInputData(this->Image);
    crop->Update();
    this->Filter->SetInputDataObject(0, crop->GetOutput());
    return this->Feel();
  };
  this->Property->ApplyPreset("CT contrast");
  const auto units = feel(0.0);
  EXPECT_EQ(this->Property->GetFoundShift(), 0.0);
  EXPECT_LT(Apart(feel(1024.0), units), Rounded);
  EXPECT_EQ(this->Property->GetFoundShift(), -1024.0);
  EXPECT_GT(Most(units), 0.2);

  // The values of a region do not determine the shift, because a part of a lung is not a whole
  // chest.
  crop->GetOutput()->GetFieldData()->RemoveArray("HapticShift");
  this->Filter->SetInputDataObject(0, crop->GetOutput());
  this->Feel();
  EXPECT_EQ(this->Property->GetFoundShift(), 0.0);
}

TEST_F(FilterShift, IsKeptByProposals)
{
  this->SetBody(1024.0, 1.0, VTK_UNSIGNED_SHORT);
  this->Property->ApplyPreset("CT contrast");
  this->Feel();
  ASSERT_EQ(this->Property->GetFoundShift(), -1024.0);
  ASSERT_TRUE(this->Property->ProposeFromImage(this->Image));
  EXPECT_EQ(this->Property->GetScalarShift(), -1024.0);
  EXPECT_FALSE(this->Property->GetShiftFromImage());
  // The lowest tissue range is that of the air outside, at -1000 HU.
  double range[2];
  this->Property->GetTissueRange(0, range);
  EXPECT_LE(range[0], -1000.0 + 20.0);
  EXPECT_GE(range[1], -1000.0 - 20.0);
  EXPECT_LT(range[1], -150.0);
  const auto shifted = this->Feel();

  this->SetBody(0.0, 1.0, VTK_SHORT);
  const vtkNew<vtkVolumeHapticsFilter> other;
  ASSERT_TRUE(other->GetProperty()->ProposeFromImage(this->Image));
  this->Property->DeepCopy(other->GetProperty());
  EXPECT_EQ(this->Property->GetScalarShift(), 0.0);
  EXPECT_LT(Apart(this->Feel(), shifted), 1e-6);
}

TEST_F(FilterShift, WarnsOfDataThatCannotBeHounsfieldUnits)
{
  struct Data
  {
    double Offset;
    double Factor;
    int Type;
  };
  const Data others[] = { { 1010.0, 0.1, VTK_UNSIGNED_CHAR }, { 1000.0, 0.00002, VTK_FLOAT },
    { 1100.0, 25.0, VTK_UNSIGNED_SHORT } };
  for (const Data& data : others)
  {
    SCOPED_TRACE(data.Factor);
    this->Log.Warnings.clear();
    this->SetBody(data.Offset, data.Factor, data.Type);
    this->Property->ApplyPreset("CT contrast");
    this->Filter->Update();
    ASSERT_EQ(this->Log.Warnings.size(), 1U);
    EXPECT_NE(this->Log.Warnings[0].find("can't be a CT"), std::string::npos);
    // Apply the settings that the warning suggests.
    this->Property->SetScalarShift(-data.Offset * data.Factor);
    this->Property->SetScalarScale(1.0 / data.Factor);
    this->Filter->Update();
    EXPECT_EQ(this->Log.Warnings.size(), 1U);
    EXPECT_GT(Most(Keep(this->Filter)), 0.2);
    this->Property->SetScalarShift(0.0);
    this->Property->SetScalarScale(1.0);
    this->Property->ApplyPreset("Micro-CT");
    this->Filter->Update();
    EXPECT_EQ(this->Log.Warnings.size(), 1U);
    EXPECT_GT(Most(Keep(this->Filter)), 0.2);
  }
}
