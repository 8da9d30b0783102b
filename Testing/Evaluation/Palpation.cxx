// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Palpation.h"

#include "Shapes.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"

#include <algorithm>
#include <optional>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double TickStep = 0.05;   // mm per tick
constexpr double Wanted = 1.0;      // N, intended force
constexpr double WantedDepth = 2.0; // mm, intended depth
constexpr double Deepest = 10.0;    // mm, largest depth
constexpr double Hardest = 4.0;     // N, largest force of a press
constexpr double StrokeLength = 10.0;
/// mm per tick and N: rate at which a hand approaches its intended force
constexpr double Following = 0.2;
/// Below these floors, the senses do not follow Weber's law. The values are assumptions, small
/// compared with the cues.
constexpr double ForceFloor = 0.05; // N, below which Weber's law fails
constexpr double DepthFloor = 0.5;  // mm, below which Weber's law fails
constexpr double WeberFraction = 0.1;
constexpr double Around = 4.0; // mm around a spot that must belong to one tissue

/** A hand that touches a model, one tick per call. */
class Hand
{
public:
  Hand(const HapticModel& model, const Spot& spot)
    : Model(model)
    , Where(spot)
    , Depth(-spot.Above)
  {
    this->GoOn();
  }

  void GoOn()
  {
    const Vector3 tip =
      this->Where.Surface + this->Depth * this->Where.Inward + this->Way * this->Where.Along;
    Tick(this->Model, this->State, 0.001 * tip, this->Record);
  }
  double Normal() const { return -Dot(this->Record.Force, this->Where.Inward); }
  double Shear() const { return -Dot(this->Record.Force, this->Where.Along); }

  const HapticModel& Model;
  const Spot& Where;
  ServoState State;
  TickRecord Record;
  double Depth; ///< mm below the spot's surface
  double Way = 0.0;
};

Identification Identify(
  const std::string& title, const std::string& text, const std::vector<FeltTissue> (&felt)[2])
{
  Identification found;
  found.Confusions = { title,
    text + " Percent of the touches of a row's tissue that are named as a column's.",
    { "strategy", "tissue" }, {} };
  found.Tissues = felt[0].size();
  for (const FeltTissue& tissue : felt[0])
  {
    found.Confusions.Columns.push_back("\"" + tissue.Name + "\"");
  }
  found.Confusions.Columns.emplace_back("cues");
  for (const HandStrategy strategy : { HandStrategy::ConstantForce, HandStrategy::ConstantDepth })
  {
    const auto& tissues = felt[strategy == HandStrategy::ConstantForce ? 0 : 1];
    const auto confusion = MakeHand(strategy).ComputeConfusion(tissues);
    const std::size_t first = found.Confusions.Rows.size();
    AddConfusion(NameOf(strategy), tissues, confusion, found.Confusions);
    for (std::size_t i = 0; i < tissues.size(); ++i)
    {
      std::string cues;
      for (std::size_t cue = 0; cue < 3; ++cue)
      {
        double mean = 0.0;
        for (const std::vector<double>& place : tissues[i].Places)
        {
          mean += place[cue] / static_cast<double>(tissues[i].Places.size());
        }
        const bool isDepth = cue == 0 && strategy == HandStrategy::ConstantForce;
        cues += (cue > 0 ? ", " : "") + Number(mean) + (isDepth ? " mm" : " N");
      }
      found.Confusions.Rows[first + i].push_back(cues);
    }
    found.Correct.push_back(CountCorrect(confusion));
    found.Confusions.Text += std::string(" ") + NameOf(strategy) + ": " +
      Number(found.Correct.back()) + " of " + std::to_string(tissues.size()) + " right.";
  }
  return found;
}

std::shared_ptr<const HapticModel> BakePreset(vtkImageData* image, const std::string& preset)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputDataObject(0, image);
  filter->GetProperty()->ApplyPreset(preset.c_str());
  return filter->GetBaker().Bake(1000.0, {}, nullptr);
}

/** Returns spots that are spread evenly along arcs. */
std::vector<Spot> SpotsOn(const std::vector<Arc>& arcs, double above, int count)
{
  std::vector<Spot> spots;
  for (const Arc& arc : arcs)
  {
    const std::size_t strokes = arc.Tips.size() - arc.Pressed;
    const int fraction = std::max(1, count / static_cast<int>(arcs.size()));
    for (int i = 0; i < fraction; ++i)
    {
      const std::size_t at = arc.Pressed + strokes * (2 * i + 1) / (2 * fraction);
      const Vector3 way = arc.Tips[at + 1] - arc.Tips[at];
      const Vector3 ray = arc.Tips[at] - arc.Middle;
      const Vector3 in = (-1.0 / Norm(ray)) * ray;
      const Vector3 flat = way - Dot(way, in) * in;
      spots.push_back({ arc.Tips[at] - ArcDepth * in, in, (1.0 / Norm(flat)) * flat, above });
    }
  }
  return spots;
}

/**
 * Returns random spots within one tissue: the mean of the values around each is in a range, and the
 * values differ little.
 */
std::vector<Spot> SpotsIn(
  const HapticModel& model, const double* box, double low, double high, int count)
{
  std::mt19937 random(7);
  Uniform uniform(random);
  std::vector<Spot> spots;
  for (int attempt = 0; attempt < 200000 && static_cast<int>(spots.size()) < count; ++attempt)
  {
    const Vector3 at = { uniform(box[0], box[1]), uniform(box[2], box[3]),
      uniform(box[4], box[5]) };
    const Vector3 in = OnOddCircle(1.0, uniform(0.0, TwoPi)) - OddCentre;
    double sum = 0.0;
    double squares = 0.0;
    int samples = 0;
    constexpr int half = 4;
    bool isNear = true;
    for (int k = -half; k <= half && isNear; ++k)
    {
      for (int j = -half; j <= half; ++j)
      {
        for (int i = -half; i <= half; ++i)
        {
          const Vector3 off = (Around / half) * Vector3{ 1.0 * i, 1.0 * j, 1.0 * k };
          if (Norm(off) <= Around)
          {
            const double value = model.ValueAtDevice(0.001 * (at + off));
            sum += value;
            squares += value * value;
            ++samples;
          }
        }
      }
      const double mean = sum / samples;
      isNear = mean > low - 40.0 && mean < high + 40.0;
    }
    const double mean = sum / samples;
    const double variance = squares / samples - mean * mean;
    if (isNear && mean > low && mean < high && variance < 30.0 * 30.0)
    {
      spots.push_back({ at, in, OddNormal, 0.0 });
    }
  }
  return spots;
}
} // namespace

const char* NameOf(HandStrategy strategy)
{
  return strategy == HandStrategy::ConstantForce ? "constant force" : "constant depth";
}

std::vector<double> Palpate(const HapticModel& model, const Spot& spot, HandStrategy strategy)
{
  const bool isForce = strategy == HandStrategy::ConstantForce;
  const double last = isForce ? Deepest : WantedDepth;
  Hand hand(model, spot);
  while (hand.Depth < last && !(isForce && hand.Normal() >= Wanted))
  {
    hand.Depth = std::min(last, hand.Depth + TickStep);
    hand.GoOn();
  }
  double pressed = 0.0;
  double shear = 0.0;
  int counted = 0;
  while (hand.Way < StrokeLength)
  {
    hand.Way += TickStep;
    if (isForce)
    {
      hand.Depth =
        std::clamp(hand.Depth + Following * std::clamp(Wanted - hand.Normal(), -0.25, 0.25),
          -spot.Above, Deepest);
    }
    hand.GoOn();
    if (hand.Way > 0.4 * StrokeLength)
    {
      pressed += isForce ? hand.Depth : hand.Normal();
      shear += hand.Shear();
      ++counted;
    }
  }
  double strength = hand.Normal();
  while (hand.Depth < Deepest && strength < Hardest)
  {
    hand.Depth += TickStep;
    hand.GoOn();
    strength = std::max(strength, hand.Normal());
  }
  return { std::max(0.0, pressed / counted), std::max(0.0, shear / counted),
    std::clamp(strength, 0.0, Hardest) };
}

IdealHand MakeHand(HandStrategy strategy, double weberFraction)
{
  return IdealHand(weberFraction,
    { strategy == HandStrategy::ConstantForce ? DepthFloor : ForceFloor, ForceFloor, ForceFloor });
}

vtkSmartPointer<vtkImageData> MakeSlab(double outside, double inside)
{
  return SampleImage(
    [=](const Vector3& x) { return outside + BlurredStep(-x.Z, 1.0, inside - outside); }, 24.0);
}

Spot OnSlab()
{
  return { { -5.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 }, { 1.0, 0.0, 0.0 }, 6.0 };
}

Identification IdentifyOnSlabs(const std::string& preset)
{
  // The centres of the ranges in SPEC's table for CT.
  const std::pair<const char*, double> tissues[] = { { "lung", -725.0 }, { "fat", -90.0 },
    { "fluid", 3.0 }, { "muscle", 50.0 }, { "contrast medium", 200.0 }, { "bone", 900.0 } };
  std::vector<FeltTissue> felt[2];
  for (const auto& [name, value] : tissues)
  {
    const auto model = BakePreset(MakeSlab(-1000.0, value), preset);
    for (const HandStrategy strategy : { HandStrategy::ConstantForce, HandStrategy::ConstantDepth })
    {
      felt[strategy == HandStrategy::ConstantForce ? 0 : 1].push_back(
        { name, { Palpate(*model, OnSlab(), strategy) } });
    }
  }
  return Identify("Told apart by an ideal hand: slabs of \"" + preset + "\"",
    "Each tissue under air, without noise.", felt);
}

Identification IdentifyOnHead(
  const std::vector<FeltSurface>& surfaces, const std::string& preset, const Effort& effort)
{
  if (surfaces.size() < 2 || surfaces[0].Arcs.empty() || surfaces[1].Arcs.empty())
  {
    return {};
  }
  vtkImageData* const image = surfaces[0].Image;
  const auto model = BakePreset(image, preset);
  if (!model)
  {
    return {};
  }
  const int count = effort.Pick(6, 40);
  const std::pair<const char*, std::vector<Spot>> places[] = {
    { "skin", SpotsOn(surfaces[0].Arcs, 6.0, count) },
    { "muscle", SpotsIn(*model, image->GetBounds(), 30.0, 75.0, count) },
    { "fluid", SpotsIn(*model, image->GetBounds(), -8.0, 15.0, count) },
    { "bone", SpotsOn(surfaces[1].Arcs, 1.5, count) }
  };
  std::vector<FeltTissue> felt[2];
  std::string text = "Places:";
  for (const auto& [name, spots] : places)
  {
    text += std::string(" ") + name + " " + std::to_string(spots.size()) + ",";
    for (std::size_t strategy = 0; strategy < 2 && !spots.empty(); ++strategy)
    {
      FeltTissue tissue{ name, {} };
      for (const Spot& spot : spots)
      {
        tissue.Places.push_back(Palpate(
          *model, spot, strategy == 0 ? HandStrategy::ConstantForce : HandStrategy::ConstantDepth));
      }
      felt[strategy].push_back(std::move(tissue));
    }
  }
  text.back() = '.';
  return Identify(
    "Told apart by an ideal hand: tissues of the head CT, \"" + preset + "\"", text, felt);
}

} // namespace evaluation
