// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the presets have the values in the tables of Documentation/materials.md, and the
 * properties that the document states for all presets.
 */

#include "Rigs/ApiRig.h"

#include <vtkHapticNeedle.h>
#include <vtkHapticRegionFilter.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

using namespace apitest;

namespace
{
constexpr double Endless = std::numeric_limits<double>::infinity();

/// A row of a preset's table: the stiffness k, friction mu, drag R and strength T_N between two
/// values.
struct Tissue
{
  std::string Name;
  double Low = -Endless;
  double High = Endless;
  double Values[4] = {};
  double Lows[4] = {}; ///< start of the values: Low, or the number after "from"
};

/// Returns the cells of a row of a Markdown table.
std::vector<std::string> Cells(const std::string& row)
{
  std::vector<std::string> cells;
  std::istringstream stream(row.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');)
  {
    const std::size_t first = cell.find_first_not_of(' ');
    const std::size_t last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

/// Reads the table under the heading of a preset in Documentation/materials.md.
std::vector<Tissue> ReadTable(const std::string& preset)
{
  std::ifstream file(std::string(VolumeHaptics_SOURCE_DIR) + "/Documentation/materials.md");
  std::vector<Tissue> tissues;
  bool isHere = false;
  for (std::string line; std::getline(file, line);)
  {
    if (line.compare(0, 2, "##") == 0)
    {
      isHere = line == "### Preset " + preset;
    }
    const std::vector<std::string> cells =
      isHere && !line.empty() && line[0] == '|' ? Cells(line) : std::vector<std::string>();
    if (cells.size() != 6 || cells[0] == "---" || cells[2] == "k, N/m")
    {
      continue;
    }
    Tissue tissue;
    tissue.Name = cells[0];
    std::istringstream range(cells[1]);
    std::string word;
    if (cells[1].compare(0, 6, "up to ") == 0)
    {
      range >> word >> word >> tissue.High;
    }
    else if (cells[1].compare(0, 5, "from ") == 0)
    {
      range >> word >> tissue.Low;
    }
    else
    {
      range >> tissue.Low >> word >> tissue.High;
    }
    for (int i = 0; i < 4; ++i)
    {
      std::istringstream cell(cells[2 + i]);
      cell >> tissue.Values[i];
      tissue.Lows[i] = cell >> word >> tissue.Lows[i] ? tissue.Lows[i] : tissue.Low;
    }
    tissues.push_back(tissue);
  }
  return tissues;
}

class Presets : public testing::Test
{
protected:
  std::array<vtkPiecewiseFunction*, 4> Functions()
  {
    return { this->Property->GetStiffness(), this->Property->GetFriction(),
      this->Property->GetViscosity(), this->Property->GetSurfaceStrength() };
  }

  vtkNew<vtkHapticProperty> Property;
  MessageLog Log{ this->Property };
};
} // namespace

TEST_F(Presets, AreThoseOfTheTables)
{
  vtkPiecewiseFunction* const stiffness = this->Property->GetStiffness();
  stiffness->AddPoint(-5000.0, 77.0);
  stiffness->ClampingOff();
  vtkStringArray* const names = vtkHapticProperty::GetPresetNames();
  for (vtkIdType n = 0; n < names->GetNumberOfValues(); ++n)
  {
    SCOPED_TRACE(names->GetValue(n));
    ASSERT_TRUE(this->Property->ApplyPreset(names->GetValue(n).c_str()));
    EXPECT_EQ(this->Property->GetStiffness(), stiffness) << "filled in place";
    const std::vector<Tissue> table = ReadTable(names->GetValue(n));
    ASSERT_FALSE(table.empty());
    ASSERT_EQ(this->Property->GetNumberOfTissues(), static_cast<int>(table.size()));
    for (std::size_t t = 0; t < table.size(); ++t)
    {
      const Tissue& tissue = table[t];
      EXPECT_EQ(this->Property->GetTissueName(static_cast<int>(t)), tissue.Name);
      const double low = std::max(tissue.Low, std::min(tissue.High, 0.0) - 3000.0);
      const double high = std::min(tissue.High, std::max(tissue.Low, 0.0) + 30000.0);
      for (int f = 0; f < 4; ++f)
      {
        for (int i = 0; i <= 20; ++i)
        {
          const double value = low + i * (high - low) / 20.0;
          EXPECT_NEAR(this->Functions()[f]->GetValue(value), tissue.Values[f], 1e-12)
            << tissue.Name << " at " << value << ", function " << f;
        }
        if (t > 0) // a value halfway between two rows
        {
          const double middle = 0.5 * (table[t - 1].High + tissue.Lows[f]);
          EXPECT_NEAR(this->Functions()[f]->GetValue(middle),
            0.5 * (table[t - 1].Values[f] + tissue.Values[f]), 1e-12)
            << "before " << tissue.Name << ", function " << f;
        }
      }
    }
  }
}

TEST_F(Presets, AreSmoothForARealScan)
{
  // A change of the value by 10 units must change the strength by less than a third. The stiffness
  // must be constant, and the strength must not fall.
  for (const char* const name : { "CT contrast", "CT angiography", "CT chest", "MRI" })
  {
    SCOPED_TRACE(name);
    ASSERT_TRUE(this->Property->ApplyPreset(name));
    const auto [k, mu, drag, strength] = this->Functions();
    double before = 0.0;
    for (double value = -1100.0; value < 3200.0; value += 1.0)
    {
      const double here = strength->GetValue(value);
      EXPECT_GE(here, before - 1e-12) << value;
      before = here;
      EXPECT_NEAR(k->GetValue(value), 400.0, 1e-9) << value;
      if (here >= 0.8)
      {
        EXPECT_LT(strength->GetValue(value + 10.0), 1.35 * here) << value;
        const double now = std::hypot(1.0, mu->GetValue(value));
        EXPECT_NEAR(std::hypot(1.0, mu->GetValue(value + 10.0)) / now, 1.0, 0.03) << value;
        EXPECT_NEAR(drag->GetValue(value + 10.0), drag->GetValue(value), 0.1) << value;
      }
    }
  }
}

TEST_F(Presets, MriTakesUpItsSurfacesSlowly)
{
  // A change of the gradient by 10 grey levels per millimetre must change the distinctness by less
  // than a fifth.
  ASSERT_TRUE(this->Property->ApplyPreset("MRI"));
  vtkPiecewiseFunction* const distinct = this->Property->GetDistinctness();
  for (double gradient = 0.0; gradient < 200.0; gradient += 1.0)
  {
    EXPECT_LT(distinct->GetValue(gradient + 10.0) - distinct->GetValue(gradient), 0.2) << gradient;
  }
  EXPECT_EQ(distinct->GetValue(100.0), 1.0);
}

TEST_F(Presets, MriIsFittedToTheGreyLevelsOfAnImage)
{
  // The head has mostly grey matter, and white matter. Its grey levels are multiplied by 2^n, so
  // that functions scale exactly. The forces must not depend on the factor.
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetPathData(MakePath(Line({ 15.5, 15.5, 0.5 }, { 15.5, 15.5, 14.5 }, 200)));
  std::vector<double> expected;
  for (const double times : { 1.0, 0.25, 2.0, 16.0 })
  {
    SCOPED_TRACE(times);
    const auto head = MakeImage(32, VTK_DOUBLE,
      [=](const Point& x)
      {
        const double r = std::hypot(x[0] - 15.5, x[1] - 15.5, x[2] - 15.5);
        const double noise = std::abs(std::sin(13.7 * x[0] + 7.1 * x[1] * x[2] + 3.3 * x[2]));
        const double brain = 40.0 * std::erfc(r - 12.0) + 18.0 * std::erfc(r - 6.0);
        return times * (brain + 3.0 * noise);
      });
    ASSERT_TRUE(this->Property->ApplyPreset("MRI", head));
    // The table has these values in the rows "background" and "grey matter, muscle".
    EXPECT_EQ(this->Property->GetSurfaceStrength()->GetValue(times * 8.0), 0.0);
    EXPECT_NEAR(this->Property->GetSurfaceStrength()->GetValue(times * 83.0), 1.4, 0.1);
    EXPECT_GT(this->Property->GetSurfaceStrength()->GetValue(times * 120.0), 1.8);
    filter->SetInputData(0, head);
    filter->SetProperty(this->Property);
    filter->Update();
    vtkPolyData* const output = filter->GetOutput();
    double largest = 0.0;
    for (vtkIdType tick = 0; tick < output->GetNumberOfPoints(); ++tick)
    {
      const double force = Get(output, "Force", tick, 2);
      largest = std::max(largest, std::abs(force));
      if (times == 1.0)
      {
        expected.push_back(force);
      }
      EXPECT_NEAR(force, expected[static_cast<std::size_t>(tick)], 1e-9) << "tick " << tick;
    }
    EXPECT_GT(largest, 0.3);
  }
}

TEST_F(Presets, MriIsFittedToTheValuesThatFunctionsTake)
{
  const auto head = [](const Point& x)
  { return 45.0 * std::erfc(std::hypot(x[0] - 15.5, x[1] - 15.5, x[2] - 15.5) - 11.0); };
  ASSERT_TRUE(this->Property->ApplyPreset("MRI", MakeImage(32, VTK_DOUBLE, head)));
  vtkNew<vtkHapticProperty> scaled;
  scaled->SetScalarShift(-100.0);
  scaled->SetScalarScale(0.5);
  ASSERT_TRUE(scaled->ApplyPreset(
    "MRI", MakeImage(32, VTK_DOUBLE, [&](const Point& x) { return 2.0 * head(x) + 100.0; })));
  for (double value = 0.0; value < 200.0; value += 5.0)
  {
    EXPECT_NEAR(scaled->GetSurfaceStrength()->GetValue(value),
      this->Property->GetSurfaceStrength()->GetValue(value), 1e-9);
    EXPECT_NEAR(scaled->GetDistinctness()->GetValue(value),
      this->Property->GetDistinctness()->GetValue(value), 1e-9);
  }
}

TEST_F(Presets, MriFeelsEdgesOfCoarseVoxels)
{
  // The samples are the same for every voxel width, so an edge has the same values on both sides,
  // one voxel apart. The edge must resist with the same force.
  vtkNew<vtkVolumeHapticsFilter> filter;
  double expected = 0.0;
  for (const double width : { 1.0, 0.5, 2.0, 4.0 })
  {
    SCOPED_TRACE(testing::Message() << "voxels of " << width << " mm");
    const auto head = MakeImage(32, VTK_DOUBLE,
      [](const Point& x)
      {
        const double noise = std::abs(std::sin(13.7 * x[0] + 7.1 * x[1] * x[2] + 3.3 * x[2]));
        return 45.0 * std::erfc(std::hypot(x[0] - 15.5, x[1] - 15.5, x[2] - 15.5) - 11.0) + noise;
      });
    head->SetSpacing(width, width, width);
    ASSERT_TRUE(this->Property->ApplyPreset("MRI", head));
    EXPECT_FALSE(this->Property->GetDistinctnessPerMillimeter());
    Point from = { 15.5 * width, 15.5 * width, 0.5 * width };
    Point to = { 15.5 * width, 15.5 * width, 12.0 * width };
    filter->SetPathData(MakePath(Line(from, to, static_cast<int>(115 * width))));
    filter->SetInputData(0, head);
    filter->SetProperty(this->Property);
    filter->Update();
    double largest = 0.0;
    for (vtkIdType tick = 0; tick < filter->GetOutput()->GetNumberOfPoints(); ++tick)
    {
      largest = std::max(largest, std::abs(Get(filter->GetOutput(), "Force", tick, 2)));
    }
    expected = width == 1.0 ? largest : expected;
    EXPECT_GT(largest, 0.5);
    EXPECT_NEAR(largest, expected, 0.1 * expected);
  }
  // In thick slices, use the mean of the voxel widths.
  const auto thick = MakeImage(32, VTK_DOUBLE,
    [](const Point& x)
    { return 45.0 * std::erfc(std::hypot(x[0] - 15.5, x[1] - 15.5, x[2] - 15.5) - 11.0); });
  ASSERT_TRUE(this->Property->ApplyPreset("MRI", thick));
  double ends[2] = {};
  this->Property->GetDistinctness()->GetRange(ends);
  thick->SetSpacing(1.0, 1.0, 4.0);
  ASSERT_TRUE(this->Property->ApplyPreset("MRI", thick));
  double thickEnds[2] = {};
  this->Property->GetDistinctness()->GetRange(thickEnds);
  EXPECT_EQ(thickEnds[0], 0.5 * ends[0]);
  EXPECT_EQ(thickEnds[1], 0.5 * ends[1]);
}

TEST_F(Presets, MriHasNoStrengthInTheNoiseOfAnImage)
{
  // MRI measures the magnitude of a complex signal with normal noise. Without a signal, the
  // magnitude has Rayleigh's distribution, whose mean is sqrt(pi/2) standard deviations.
  constexpr double sigma = 2.3;
  constexpr double body = 60.0;
  std::mt19937_64 engine(5);
  std::normal_distribution<double> random(0.0, sigma);
  double brightest = 0.0;
  const auto head = MakeImage(40, VTK_DOUBLE,
    [&](const Point& x)
    {
      const double r = std::hypot(x[0] - 19.5, x[1] - 19.5, x[2] - 19.5);
      const double real = 0.5 * body * std::erfc(r - 14.0) + random(engine);
      const double value = std::hypot(real, random(engine));
      brightest = r > 17.0 ? std::max(brightest, value) : brightest;
      return value;
    });
  ASSERT_TRUE(this->Property->ApplyPreset("MRI", head));
  vtkPiecewiseFunction* const strength = this->Property->GetSurfaceStrength();
  EXPECT_EQ(strength->GetValue(brightest), 0.0);
  EXPECT_EQ(this->Property->GetViscosity()->GetValue(brightest), 0.0);
  // The background ends at 14.4, five times the mean of the noise. Without noise, it would end at
  // 8, which is 12 times 60/90.
  const double end = 5.0 * std::sqrt(std::acos(0.0)) * sigma;
  EXPECT_EQ(strength->GetValue(0.97 * end), 0.0);
  EXPECT_GT(strength->GetValue(1.03 * end), 0.0);
  EXPECT_GE(strength->GetValue(body), 0.8) << "as fluid";
  // The height of distinct edges must scale with the brightness of the body: 70 for a body of 90.
  vtkPiecewiseFunction* const distinct = this->Property->GetDistinctness();
  EXPECT_EQ(distinct->GetValue(70.0 * body / 90.0 * 1.03), 1.0);
  EXPECT_LT(distinct->GetValue(70.0 * body / 90.0 * 0.97), 1.0);
  // A region must use the grey levels of the whole volume.
  vtkNew<vtkHapticRegionFilter> region;
  region->SetInputData(head);
  region->SetRegion(14, 25, 14, 25, 14, 25);
  region->Update();
  vtkNew<vtkHapticProperty> same;
  ASSERT_TRUE(same->ApplyPreset("MRI", region->GetOutput()));
  for (double value = 0.0; value < 200.0; value += 5.0)
  {
    EXPECT_EQ(same->GetSurfaceStrength()->GetValue(value), strength->GetValue(value)) << value;
    EXPECT_EQ(same->GetDistinctness()->GetValue(value), distinct->GetValue(value)) << value;
  }
}

TEST_F(Presets, MriTakesNoTissueForNoise)
{
  // In a brain without surroundings, grey matter is the darker cluster. It must not count as a
  // noisy background.
  const auto brain = MakeImage(32, VTK_DOUBLE,
    [](const Point& x)
    { return 75.0 + 20.0 * std::erfc(std::hypot(x[0] - 15.5, x[1] - 15.5, x[2] - 15.5) - 11.0); });
  ASSERT_TRUE(this->Property->ApplyPreset("MRI", brain));
  EXPECT_GT(this->Property->GetSurfaceStrength()->GetValue(75.0), 0.8);
}

TEST_F(Presets, AnImageIsLookedAtOnlyIfThereIsNoUnit)
{
  EXPECT_TRUE(this->Property->ApplyPreset("CT contrast", nullptr));
  EXPECT_TRUE(this->Property->ApplyPreset("Micro-CT", nullptr));
  EXPECT_TRUE(this->Log.Errors.empty());
  EXPECT_FALSE(this->Property->ApplyPreset("MRI", nullptr));
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("call ApplyPreset(name)"), std::string::npos);
  EXPECT_TRUE(this->Property->GetSolidFromImage()) << "nothing has changed";
  // An image with a single value has no background, so the preset uses its table unchanged.
  const auto image = MakeImage(16, VTK_DOUBLE, [](const Point&) { return 900.0; });
  ASSERT_TRUE(this->Property->ApplyPreset("MRI", image));
  EXPECT_EQ(this->Property->GetSurfaceStrength()->GetValue(12.0), 0.0);
  EXPECT_EQ(this->Property->GetSurfaceStrength()->GetValue(90.0), 1.4);
}

TEST_F(Presets, PhysicalHasThePublishedLiver)
{
  ASSERT_TRUE(this->Property->ApplyPreset("CT physical"));
  // The expected stiffness is 2 E a / (1 - nu^2), with a shear modulus of 1.8 kPa and a = 2 mm.
  EXPECT_NEAR(this->Property->GetStiffness()->GetValue(55.0), 28.0, 1.0);
  // The expected stiffness follows from the same formula with a Young's modulus of 10 kPa, the
  // softest published value of skin in vivo.
  EXPECT_NEAR(this->Property->GetStiffness()->GetValue(-100.0), 2.0 * 10e3 * 2e-3 / 0.75, 1.0);
  const double friction = this->Property->GetFriction()->GetValue(1000.0);
  EXPECT_TRUE(friction >= 0.29 && friction <= 0.36) << "bone on muscle";
}

TEST_F(Presets, ANeedleHasCuttingForcesOfItsOwn)
{
  // The presets have one drag for all soft tissues, but a needle distinguishes the layers of
  // Documentation/method.md.
  vtkNew<vtkHapticNeedle> needle;
  vtkPiecewiseFunction* const force = needle->GetCuttingForce();
  for (const char* const name : { "CT contrast", "CT physical", "CT angiography", "CT chest" })
  {
    SCOPED_TRACE(name);
    needle->SetCuttingForce(force);
    force->RemoveAllPoints();
    ASSERT_TRUE(needle->ApplyPreset(name));
    EXPECT_EQ(needle->GetCuttingForce(), force) << "filled in place";
    EXPECT_EQ(force->GetValue(-1000.0), 0.0);
    EXPECT_NEAR(force->GetValue(-100.0), 0.1, 1e-12);
    EXPECT_NEAR(force->GetValue(55.0), 0.3, 1e-12);
    for (double value = -1100.0; value < 3200.0; value += 1.0)
    {
      EXPECT_GE(force->GetValue(value + 1.0), force->GetValue(value) - 1e-12) << value;
    }
  }
  const vtkMTimeType before = needle->GetMTime();
  for (const char* const name : { "MRI", "Labels", "CT", "", static_cast<const char*>(nullptr) })
  {
    const MessageLog log(needle);
    EXPECT_FALSE(needle->ApplyPreset(name));
    ASSERT_EQ(log.Errors.size(), 1U);
    EXPECT_NE(log.Errors[0].find("GetCuttingForce()"), std::string::npos);
    EXPECT_EQ(needle->GetMTime(), before);
  }
}

TEST_F(Presets, EveryPresetMakesSense)
{
  vtkStringArray* const names = vtkHapticProperty::GetPresetNames();
  ASSERT_EQ(names->GetNumberOfValues(), 7);
  EXPECT_EQ(names->LookupValue("CT contrast"), 0) << "the default comes first";
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    const vtkStdString name = names->GetValue(i);
    SCOPED_TRACE(name);
    vtkNew<vtkHapticProperty> used;
    used->SetSurfaceSideToLower();
    used->DistinctnessFromNoiseOff();
    used->GetStiffness()->UseLogScaleOn();
    used->GetDistinctness()->AddPoint(7.0, 0.7);
    ASSERT_TRUE(this->Property->ApplyPreset(name.c_str()));
    ASSERT_TRUE(used->ApplyPreset(name.c_str()));
    EXPECT_EQ(used->GetSurfaceSide(), this->Property->GetSurfaceSide());
    const bool isBoth = name == "MRI" || name == "Labels";
    EXPECT_EQ(used->GetScalarsAreLabels(), name == "Labels");
    EXPECT_EQ(used->GetSolidFromImage(), name == "Micro-CT");
    EXPECT_EQ(used->GetShiftFromImage(), name.compare(0, 3, "CT ") == 0);
    EXPECT_EQ(used->GetSurfaceSide(), isBoth ? vtkHapticProperty::BOTH : vtkHapticProperty::HIGHER);
    for (double value = -1100.0; value < 3200.0; value += 7.0)
    {
      const double k = this->Property->GetStiffness()->GetValue(value);
      EXPECT_TRUE(k >= 0.0 && k <= 1000.0 + 1e-9) << value;
      EXPECT_EQ(used->GetStiffness()->GetValue(value), k) << "whatever was there before";
    }
    vtkPiecewiseFunction* const distinct = used->GetDistinctness();
    if (name == "Micro-CT" || name == "Labels") // presets for values without a fixed unit
    {
      EXPECT_EQ(distinct->GetSize(), 0);
      EXPECT_TRUE(used->GetDistinctnessFromNoise());
      EXPECT_FALSE(used->GetDistinctnessPerMillimeter());
      continue;
    }
    EXPECT_TRUE(used->GetDistinctnessPerMillimeter());
    EXPECT_EQ(distinct->GetValue(0.0), 0.0);
    EXPECT_EQ(distinct->GetValue(1e4), 1.0);
  }
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(Presets, UnknownNamesChangeNothing)
{
  this->Property->ApplyPreset("CT contrast");
  const vtkMTimeType before = this->Property->GetMTime();
  for (const char* const name : { "ct contrast", "", "CT", static_cast<const char*>(nullptr) })
  {
    this->Log.Errors.clear();
    EXPECT_FALSE(this->Property->ApplyPreset(name));
    EXPECT_EQ(this->Property->GetMTime(), before);
    ASSERT_EQ(this->Log.Errors.size(), 1U);
    EXPECT_NE(this->Log.Errors[0].find("\"CT physical\""), std::string::npos);
  }
}
