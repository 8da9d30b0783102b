// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Describes layers of tissue for a needle, with their closed forms (test N1 of the needle).
 */
#ifndef NeedleScene_h
#define NeedleScene_h

#include "Core/Tools/Needle/BakedNeedle.h"
#include "Rigs/CoreScene.h"

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace coretest
{
inline constexpr double Millimetre = 1e-3;

/// Returns a position (mm) on the scene's central axis.
inline Vector3 Along(double z)
{
  return { 11.5, 11.5, z };
}

struct Layer
{
  double Thickness; ///< thickness (mm)
  double Shaft;     ///< friction tau of the shaft (N/m)
  double Cutting;   ///< cutting force R (N)
  double Puncture;  ///< strength T of the boundary (N)
};

/// Returns the layers of N1, starting at the skin. The last layer has no end.
inline std::vector<Layer> LayersOfN1()
{
  return { { 3.0, 20.0, 0.3, 0.0 }, { 12.0, 5.0, 0.1, 0.0 }, { 20.0, 25.0, 0.3, 0.0 },
    { 3.0, 60.0, 0.8, 0.0 }, { 100.0, 0.0, 0.0, 0.0 } };
}

/// Expected sums over the layers, computed independently of the tested code.
class LayerSums
{
public:
  explicit LayerSums(std::vector<Layer> layers)
    : Layers(std::move(layers))
  {
  }

  const Layer& At(double depth) const
  {
    std::size_t i = 0;
    for (double end = this->Layers[0].Thickness; depth > end; end += this->Layers[i].Thickness)
    {
      ++i;
    }
    return this->Layers[i];
  }

  /// Integrates a function of layer and depth from the skin to a depth (mm). The result has the
  /// function's unit times mm.
  double Integrate(double depth, const std::function<double(const Layer&, double)>& f) const
  {
    constexpr double step = 1e-3;
    double sum = 0.0;
    for (double at = 0.5 * step; at < depth; at += step)
    {
      sum += step * f(this->At(at), at);
    }
    return sum;
  }

  double Shaft(double depth) const
  {
    double sum = 0.0;
    double begin = 0.0;
    for (const Layer& layer : this->Layers)
    {
      const double end = begin + layer.Thickness;
      sum += layer.Shaft * Millimetre * std::max(0.0, std::min(depth, end) - begin);
      begin = end;
    }
    return sum;
  }

  std::vector<Layer> Layers;
};

/// A model of layers in voxels of 1 mm. The layers begin at z = 4.5 mm and have the labels 1, 2,
/// ...; label 0 is air.
class NeedleScene
{
public:
  static constexpr double Skin = 4.5; ///< mm

  explicit NeedleScene(const std::vector<Layer>& layers)
    : Sums(layers)
    , Volume(ScalarType::Int16, { 24, 24, 56 })
    , Labels(ScalarType::UInt8, { 24, 24, 56 })
  {
    this->Labels.Fill<std::uint8_t>([&](std::int64_t, std::int64_t, std::int64_t k)
      { return this->LabelAt(static_cast<double>(k) - Skin); });
    std::vector<LabelledMaterial> entries;
    for (std::size_t i = 0; i < layers.size(); ++i)
    {
      LabelledMaterial entry;
      entry.Label = static_cast<std::int64_t>(i) + 1;
      entry.Material.Value = { 500.0, 0.0, layers[i].Puncture, layers[i].Cutting };
      entry.Material.IsSet = { true, true, true, true };
      entry.Material.ShaftFriction = layers[i].Shaft;
      entry.Material.HasShaftFriction = true;
      entries.push_back(entry);
    }
    auto baked = std::make_shared<BakedLabels>();
    baked->View = LabelView(this->Labels.View);
    baked->Table = LabelTable(entries);
    this->Description = Describe(this->Volume);
    this->Description.Labels = baked;
    this->Description.Settings.Geometry = SurfaceGeometry::Labels;
    // Air has no own material, so it gets the surface strength 0.
    this->Description.Material.SurfaceStrength = ConstantPolyline(0.0);
    this->Description.Tool = std::make_shared<const BakedNeedle>(NeedleDescription{});
  }

  int LabelAt(double depth) const
  {
    if (depth < 0.0)
    {
      return 0;
    }
    int label = 1;
    for (double end = this->Sums.Layers[0].Thickness; depth > end; ++label)
    {
      end += this->Sums.Layers[static_cast<std::size_t>(label)].Thickness;
    }
    return label;
  }

  LayerSums Sums;
  TestVolume Volume;
  TestVolume Labels;
  HapticModelDescription Description;
};

/// A hand that moves in millimetres and sums up the work that it does.
class NeedleHand
{
public:
  explicit NeedleHand(const HapticModel& model)
    : Model(&model)
  {
  }

  /// Moves to a position (mm, world) in steps of `step` (mm). Calls `see` after each tick.
  const TickRecord& MoveTo(const Vector3& to, double step = 0.01,
    const std::function<void(const TickRecord&)>& see = nullptr)
  {
    const Vector3 from = this->IsThere ? this->At : to;
    const int ticks = std::max(1, static_cast<int>(std::ceil(Norm(to - from) / step)));
    for (int i = 1; i <= ticks; ++i)
    {
      this->Place(from + (double(i) / ticks) * (to - from));
      if (see)
      {
        see(this->Record);
      }
    }
    return this->Record;
  }

  const TickRecord& Place(const Vector3& to)
  {
    const Vector3 before = this->At;
    const Vector3 force = this->Record.Force;
    this->At = to;
    Tick(*this->Model, this->State, this->Model->WorldToDevice(to), this->Record);
    if (this->IsThere)
    {
      const Vector3 way = this->Record.Tip - this->Model->WorldToDevice(before);
      this->Work -= 0.5 * Dot(force + this->Record.Force, way);
    }
    this->IsThere = true;
    return this->Record;
  }

  /// Returns the energy (J) of the spring.
  double ComputeStored() const
  {
    const Vector3 lag = this->Record.Tip - this->Record.Proxy;
    return 0.5 * this->Record.Stiffness * Dot(lag, lag);
  }
  /// Returns the proxy's depth (mm) along z below the skin.
  double ComputeDepth() const
  {
    return this->Model->DeviceToWorld(this->Record.Proxy).Z - NeedleScene::Skin;
  }

  const HapticModel* Model;
  ServoState State;
  TickRecord Record;
  Vector3 At;
  bool IsThere = false;
  double Work = 0.0; ///< J, done by the hand
};
} // namespace coretest

#endif
