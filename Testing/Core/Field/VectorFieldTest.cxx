// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares vectors and tensors at continuous positions with analytic fields, and with a slow sum
 * over all taps, component by component.
 */

#include "Core/Field/VectorField.h"
#include "NaiveField.h"

#include <gtest/gtest.h>

#include <limits>

using namespace coretest;

namespace
{
/// A volume of interleaved vector components, whose memory ends with the last component.
class VectorVolume
{
public:
  /// @param step number of elements from one component to the next
  VectorVolume(ScalarType type, const TestVolume::Size& n, int components, std::int64_t step = 1)
    : Row(components * step)
    , Memory(type, { this->Row * n[0], n[1], n[2] })
  {
    this->View.Volume = this->Memory.View;
    this->View.Volume.Dimensions[0] = n[0];
    this->View.Volume.Stride[0] = this->Row;
    this->View.Components = components;
    this->View.Stride = step;
  }

  /// Sets each sample to f(component, i, j, k).
  template <typename F>
  void Fill(F&& f)
  {
    WithSampleType(this->View.Volume.Type,
      [&](auto t)
      {
        this->Memory.Fill<decltype(t)>(
          [&](std::int64_t element, std::int64_t j, std::int64_t k)
          {
            const std::int64_t i = element / this->Row;
            const std::int64_t rest = element % this->Row;
            // The elements between components have the value 77, which must not be read.
            return rest % this->View.Stride == 0 ? f(int(rest / this->View.Stride), i, j, k) : 77.0;
          });
      });
  }
  void FillRandom(unsigned seed) { this->Memory.FillRandom(seed); }

  double operator()(int c, std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const std::int64_t last = this->View.Volume.Dimensions[0] - 1;
    const std::int64_t inside = std::max<std::int64_t>(0, std::min(i, last));
    return this->Memory(inside * this->Row + c * this->View.Stride, j, k);
  }

  VectorView View;

private:
  std::int64_t Row;

public:
  TestVolume Memory;
};

/// Returns one component as the weighted sum over all taps. `derivative` is the axis to
/// differentiate along, or -1 for the value.
double SumSlowly(const VectorVolume& volume, int c, const Vector3& p, int derivative)
{
  const std::int64_t* const n = volume.View.Volume.Dimensions;
  const AxisKernel axes[3] = { NaiveSpline(Clamp(p.X, n[0])), NaiveSpline(Clamp(p.Y, n[1])),
    NaiveSpline(Clamp(p.Z, n[2])) };
  const auto weight = [&](int axis, int i)
  { return derivative == axis ? axes[axis].Slope[i] : axes[axis].Smooth[i]; };
  double sum = 0.0;
  for (int tap = 0; tap < 64; ++tap)
  {
    const int at[3] = { tap % 4, tap / 4 % 4, tap / 16 };
    sum += weight(0, at[0]) * weight(1, at[1]) * weight(2, at[2]) *
      volume(c, axes[0].First + at[0], axes[1].First + at[1], axes[2].First + at[2]);
  }
  return sum;
}

Vector3 RandomPlace(std::mt19937_64& engine, double low, double high)
{
  std::uniform_real_distribution<double> uniform(low, high);
  return { uniform(engine), uniform(engine), uniform(engine) };
}

double Largest(const Matrix3& m)
{
  return std::max(Norm(m.Row[0]), std::max(Norm(m.Row[1]), Norm(m.Row[2])));
}

Matrix3 Minus(const Matrix3& a, const Matrix3& b)
{
  return { { a.Row[0] - b.Row[0], a.Row[1] - b.Row[1], a.Row[2] - b.Row[2] } };
}

/// Returns the placement of an anisotropic, rotated and mirrored grid.
Affine3 AnyPlace()
{
  const Vector3 a{ 0.36, 0.48, -0.8 };
  const Vector3 b{ -0.8, 0.6, 0.0 };
  return { Matrix3::FromColumns(0.7 * a, 1.3 * b, -2.0 * Cross(a, b)), { 3.0, -20.0, 7.0 } };
}
} // namespace

TEST(VectorField, ComponentsAreThoseOfTheSlowSum)
{
  std::mt19937_64 engine(3);
  for (const ScalarType type : AllScalarTypes)
  {
    for (const int components : { 3, 6, 9 })
    {
      for (const std::int64_t step : { 1, 2 })
      {
        SCOPED_TRACE(testing::Message() << "type " << int(type) << " components " << components);
        VectorVolume volume(type, { 7, 6, 8 }, components, step);
        volume.FillRandom(5);
        double scale = 0.0;
        for (int i = 0; i < 7 * 6 * 8 * components; ++i)
        {
          const int sample = i / components;
          scale = std::max(
            scale, std::abs(volume(i % components, sample % 7, sample / 7 % 6, sample / 42)));
        }
        const VectorSampler sampler(volume.View);
        const VectorSampler baseline(volume.View, InstructionSet::Baseline);
        ASSERT_TRUE(sampler.IsValid());
        for (int round = 0; round < 40; ++round)
        {
          Vector3 p = RandomPlace(engine, -2.0, 9.0);
          p.X = round % 4 == 0 ? std::round(p.X) : p.X;
          VectorSample sample;
          VectorSample values;
          VectorSample other;
          ASSERT_TRUE(sampler.Sample(p, sample));
          ASSERT_TRUE(sampler.SampleValue(p, values));
          ASSERT_TRUE(baseline.Sample(p, other));
          for (int c = 0; c < components; ++c)
          {
            const double slopes[3] = { sample.Gradient[c].X, sample.Gradient[c].Y,
              sample.Gradient[c].Z };
            ASSERT_NEAR(sample.Value[c], SumSlowly(volume, c, p, -1), 1e-14 * scale);
            ASSERT_EQ(sample.Value[c], values.Value[c]) << "with and without the gradient";
            ASSERT_EQ(sample.Value[c], other.Value[c]) << "on every processor";
            ASSERT_TRUE(IsIdentical(sample.Gradient[c], other.Gradient[c]));
            for (int axis = 0; axis < 3; ++axis)
            {
              ASSERT_NEAR(slopes[axis], SumSlowly(volume, c, p, axis), 1e-14 * scale);
            }
          }
        }
      }
    }
  }
  VectorVolume four(ScalarType::Int8, { 5, 5, 5 }, 4);
  EXPECT_FALSE(VectorSampler(four.View).IsValid());
}

TEST(VectorField, LinearFieldsAreExactAndQuadraticOnesHaveTheirOffset)
{
  const Affine3 place = AnyPlace();
  const Matrix3 slope = { { { 1.0, -2.0, 0.5 }, { 0.0, 3.0, 1.0 }, { -1.0, 0.25, 2.0 } } };
  const Vector3 offset{ 5.0, -6.0, 7.0 };
  VectorVolume linear(ScalarType::Float64, { 12, 11, 10 }, 3);
  VectorVolume quadratic(ScalarType::Float64, { 12, 11, 10 }, 3);
  const auto component = [](const Vector3& v, int c)
  { return c == 0 ? v.X : (c == 1 ? v.Y : v.Z); };
  const auto world = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    return place({ double(i), double(j), double(k) });
  };
  linear.Fill([&](int c, std::int64_t i, std::int64_t j, std::int64_t k)
    { return component(slope * world(i, j, k) + offset, c); });
  // The field (x^2, y z, z^2) in index space.
  quadratic.Fill(
    [&](int c, std::int64_t i, std::int64_t j, std::int64_t k) {
      return component({ double(i * i), double(j * k), double(k * k) }, c);
    });
  const VectorField field(linear.View, place);
  const VectorField square(quadratic.View, Affine3{});
  std::mt19937_64 engine(4);
  for (int round = 0; round < 200; ++round)
  {
    const Vector3 p = RandomPlace(engine, 1.0, 8.0);
    Vector3 v;
    Matrix3 jacobian;
    ASSERT_TRUE(field.Read(p, v, jacobian));
    EXPECT_LT(Norm(v - (slope * place(p) + offset)), 1e-12);
    EXPECT_LT(Largest(Minus(jacobian, slope)), 1e-12);
    // With B-spline weights B, the sum of B(x - i) i^2 over all samples i is x^2 + 1/3.
    ASSERT_TRUE(square.Read(p, v, jacobian));
    EXPECT_LT(Norm(v - Vector3{ p.X * p.X + 1.0 / 3.0, p.Y * p.Z, p.Z * p.Z + 1.0 / 3.0 }), 1e-12);
    const Matrix3 expected = { { { 2.0 * p.X, 0.0, 0.0 }, { 0.0, p.Z, p.Y },
      { 0.0, 0.0, 2.0 * p.Z } } };
    EXPECT_LT(Largest(Minus(jacobian, expected)), 1e-12);
  }
}

TEST(VectorField, ComponentsOnImageAxesAreTurned)
{
  const Affine3 place = AnyPlace();
  const Vector3 a{ 0.36, 0.48, -0.8 };
  const Vector3 b{ -0.8, 0.6, 0.0 };
  const Matrix3 direction = Matrix3::FromColumns(a, b, -Cross(a, b));
  VectorVolume vectors(ScalarType::Float32, { 8, 8, 8 }, 3);
  VectorVolume six(ScalarType::Float64, { 8, 8, 8 }, 6);
  VectorVolume nine(ScalarType::Float64, { 8, 8, 8 }, 9);
  vectors.FillRandom(1);
  six.FillRandom(2);
  // Tensors of six components have the order XX YY ZZ XY YZ XZ. The tensor with nine components
  // also has an antisymmetric part, which the field must ignore.
  constexpr int places[9] = { 0, 3, 5, 3, 1, 4, 5, 4, 2 };
  constexpr int signs[9] = { 0, 1, 1, -1, 0, 1, -1, -1, 0 };
  nine.Fill([&](int c, std::int64_t i, std::int64_t j, std::int64_t k)
    { return six(places[c], i, j, k) + 1e5 * signs[c]; });
  std::mt19937_64 engine(5);
  for (int round = 0; round < 100; ++round)
  {
    const Vector3 p = RandomPlace(engine, 0.0, 7.0);
    Vector3 v;
    Vector3 turned;
    Matrix3 jacobian;
    Matrix3 turnedJacobian;
    const VectorField onWorld(vectors.View, place);
    const VectorField onImage(vectors.View, place, VectorAxes::Image);
    ASSERT_TRUE(onWorld.Read(p, v, jacobian));
    ASSERT_TRUE(onImage.Read(p, turned, turnedJacobian));
    EXPECT_LT(Norm(turned - direction * v), 1e-8) << "of values of a million";
    EXPECT_LT(Largest(Minus(turnedJacobian, direction * jacobian)), 1e-8);
    ASSERT_TRUE(onImage.Read(p, v));
    EXPECT_TRUE(IsIdentical(v, turned));
    Matrix3 tensor;
    Matrix3 turnedTensor;
    Matrix3 ofNine;
    ASSERT_TRUE(VectorField(six.View, place).ReadTensor(p, tensor));
    ASSERT_TRUE(VectorField(six.View, place, VectorAxes::Image).ReadTensor(p, turnedTensor));
    ASSERT_TRUE(VectorField(nine.View, place).ReadTensor(p, ofNine));
    VectorSample sample;
    VectorSampler(six.View).Sample(p, sample);
    EXPECT_EQ(tensor.Row[0].Z, sample.Value[5]);
    EXPECT_EQ(tensor.Row[2].Y, sample.Value[4]);
    EXPECT_LT(Largest(Minus(ofNine, tensor)), 1e-8);
    const Matrix3 expected = direction * (tensor * Transpose(direction));
    EXPECT_LT(Largest(Minus(turnedTensor, expected)), 1e-8);
    EXPECT_FALSE(VectorField(six.View, place).Read(p, v)) << "tensors are no vectors";
    EXPECT_FALSE(onWorld.ReadTensor(p, tensor));
    EXPECT_EQ(Largest(tensor), 0.0);
  }
}

TEST(VectorField, WhatIsNotANumberCountsOnlyWithAWeight)
{
  VectorVolume volume(ScalarType::Float32, { 9, 9, 9 }, 3);
  volume.Fill([](int c, std::int64_t i, std::int64_t, std::int64_t)
    { return i == 4 && c == 1 ? std::numeric_limits<double>::quiet_NaN() : double(i); });
  const VectorField field(volume.View, Affine3{});
  Vector3 v;
  EXPECT_FALSE(field.Read({ 4.0, 4.5, 4.5 }, v));
  EXPECT_FALSE(field.Read({ 2.5, 4.5, 4.5 }, v));
  EXPECT_EQ(Norm(v), 0.0);
  EXPECT_TRUE(field.Read({ 2.0, 4.5, 4.5 }, v)) << "its weight there is 0";
  EXPECT_NEAR(v.Y, 2.0, 1e-14);
  EXPECT_TRUE(field.Read({ 0.5, 4.5, 4.5 }, v));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vector3& outside : { Vector3{ -0.01, 4.0, 4.0 }, Vector3{ 1.0, 8.01, 4.0 },
         Vector3{ nan, 1.0, 1.0 }, Vector3{ 1.0, 1.0, nan } })
  {
    EXPECT_FALSE(field.Read(outside, v));
  }
  EXPECT_FALSE(VectorField{}.Read({ 1.0, 1.0, 1.0 }, v));
}

TEST(VectorField, ARegionIsReadAsTheWhole)
{
  VectorVolume whole(ScalarType::Int16, { 12, 12, 12 }, 3);
  whole.FillRandom(8);
  VectorVolume part(ScalarType::Int16, { 7, 6, 5 }, 3);
  part.Fill([&](int c, std::int64_t i, std::int64_t j, std::int64_t k)
    { return whole(c, i + 3, j + 2, k + 5); });
  const std::int64_t first[3] = { 3, 2, 5 };
  std::copy(first, first + 3, part.View.Volume.First);
  std::fill_n(part.View.Volume.Whole, 3, 12);
  const VectorSampler a(whole.View);
  const VectorSampler b(part.View);
  std::mt19937_64 engine(6);
  for (int round = 0; round < 100; ++round)
  {
    const Vector3 p = Vector3{ 4.0, 3.0, 6.0 } + RandomPlace(engine, 0.0, 1.99);
    VectorSample of[2];
    ASSERT_TRUE(a.Sample(p, of[0]) && b.Sample(p, of[1]));
    EXPECT_EQ(of[0].Value[2], of[1].Value[2]);
    EXPECT_TRUE(IsIdentical(of[0].Gradient[0], of[1].Gradient[0]));
    EXPECT_EQ(a.DistanceToBorder(p), b.DistanceToBorder(p));
  }
}
