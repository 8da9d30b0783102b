// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the hand feels the release over some milliseconds when a surface gives way. Compares
 * ticks with a release time with the same ticks without one: the remainder of the force before a
 * leap fades by e dt/(tau + dt) or by 150 N/s (Core/State/ProxyRelease.h). No tick may change the
 * force by more than 0.25 N, and the work on the hand, computed with trapezoids, must be at most
 * the |F|^2/(2 k) of a spring that is released slowly.
 */

#include "Core/State/ServoStateNumbers.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <vector>

using namespace coretest;

namespace
{
constexpr double Tau = 0.005;     // s
constexpr double Period = 0.001;  // s
constexpr double MostStep = 0.25; // largest step (N) of the force in a tick with a release

/// Returns a volume with a bright shell, 4 mm thick, at z = 20 mm. Voxels are 1 mm.
TestVolume MakeShell()
{
  TestVolume volume(ScalarType::Float32, { 24, 24, 48 });
  volume.Fill<float>(
    [](std::int64_t, std::int64_t, std::int64_t k)
    {
      const double z = (double(k) - 20.0) / 2.0;
      return 1000.0 * std::exp(-z * z);
    });
  return volume;
}

HapticModelDescription DescribeShell(const TestVolume& volume, double strength)
{
  HapticModelDescription d = Describe(volume);
  d.Material.Stiffness = ConstantPolyline(400.0);
  d.Material.Friction = ConstantPolyline(0.3);
  d.Material.SurfaceStrength = ConstantPolyline(strength);
  d.Material.Distinctness = { { 50.0, 0.0 }, { 150.0, 1.0 } };
  return d;
}

/// Two models that differ only in their release time: one has Tau, the other has none.
class Pair
{
public:
  explicit Pair(HapticModelDescription d)
    : With(Set(d, Tau))
    , Without(Set(d, 0.0))
  {
  }

  /// Runs a tick of both models. Both continue from the same proxy, which must not depend on the
  /// release time.
  void Tick(const Vector3& tip)
  {
    const Vector3 before = this->A.Force;
    const Vector3 beforeB = this->B.Force;
    const Vector3 step = tip - this->StateB.PreviousTip;
    const bool isFirst = !this->StateB.Enabled;
    VolumeHaptics::Tick(this->With, this->StateA, tip, this->A);
    VolumeHaptics::Tick(this->Without, this->StateB, tip, this->B);
    ASSERT_EQ(Norm(this->StateA.Proxy - this->StateB.Proxy), 0.0);
    this->Step = Norm(this->A.Force - before);
    this->StepWithout = Norm(this->B.Force - beforeB);
    this->Most = std::max(this->Most, this->Step);
    this->MostWithout = std::max(this->MostWithout, this->StepWithout);
    if (!isFirst)
    {
      this->Work += 0.5 * Dot(this->A.Force + before, step);
      this->WorkWithout += 0.5 * Dot(this->B.Force + beforeB, step);
    }
    const Vector3 pull = this->A.Stiffness * (this->A.Proxy - this->A.Tip);
    EXPECT_TRUE(this->A.IsUnfinished || Norm(this->A.Force - pull) < 1e-9)
      << "the force is that of the spring, as ever";
  }
  /// Returns the part of the force that remains from earlier forces.
  Vector3 GetRemainder() const { return this->A.Force - this->B.Force; }

  TickRecord A;
  TickRecord B;
  ServoState StateA;
  ServoState StateB;
  double Step = 0.0;
  double StepWithout = 0.0;
  double Most = 0.0;
  double MostWithout = 0.0;
  double Work = 0.0; // work (J) done on the hand
  double WorkWithout = 0.0;

private:
  static HapticModelDescription Set(HapticModelDescription d, double time)
  {
    d.Settings.ReleaseTime = time;
    return d;
  }

  const HapticModel With;
  const HapticModel Without;
};

Vector3 At(double z)
{
  return { 0.012, 0.012, z };
}
} // namespace

TEST(ProxyRelease, GoesOverInSomeMilliseconds)
{
  const TestVolume volume = MakeShell();
  for (const double strength : { 1.0, 2.0, 5.0, 8.0 })
  {
    SCOPED_TRACE(strength);
    Pair pair(DescribeShell(volume, strength));
    double highest = 0.0;
    int releases = 0;
    // The tip passes through the shell at 40 mm/s.
    for (int i = 0; i < 1050; ++i)
    {
      const double remained = Norm(pair.GetRemainder());
      pair.Tick(At(0.002 + 4e-5 * i));
      highest = std::max(highest, Norm(pair.B.Force));
      const double remains = Norm(pair.GetRemainder());
      if (pair.StepWithout < 0.02)
      {
        // In ticks in which the proxy does not leap, the remaining force has a closed form.
        const double fall = std::min(remained * Period / (Tau + Period), 150.0 * Period);
        EXPECT_NEAR(remains, remained - fall > 1e-3 ? remained - fall : 0.0, 1e-9) << i;
      }
      releases += pair.StepWithout > 0.5 ? 1 : 0;
    }
    EXPECT_GT(pair.MostWithout, 0.5 * highest) << "without a release time, it is one step";
    EXPECT_GE(releases, 1);
    EXPECT_LT(pair.Most, MostStep);
    EXPECT_LE(pair.Work, pair.WorkWithout);
    EXPECT_NEAR(highest, strength, 0.15 * strength) << "what the wall holds";
    EXPECT_EQ(Norm(pair.GetRemainder()), 0.0) << "it has ended";
  }
}

TEST(ProxyRelease, GoesOverWhereTheProxyDoesNotReachTheTipInATick)
{
  // The spring has 50 N/m and a length of 100 voxels. When the shell gives way, the proxy has a
  // longer path than a tick's samples allow. The solver then continues from a tip nearer to the
  // proxy, and in such a long step friction would let the force change far more.
  TestVolume volume(ScalarType::Float32, { 24, 24, 160 });
  volume.Fill<float>(
    [](std::int64_t, std::int64_t, std::int64_t k)
    {
      const double z = (double(k) - 20.0) / 2.0;
      return 1000.0 * std::exp(-z * z);
    });
  HapticModelDescription d = DescribeShell(volume, 5.0);
  d.Material.Stiffness = ConstantPolyline(50.0);
  d.Material.Friction = ConstantPolyline(20.0);
  Pair pair(d);
  int unfinished = 0;
  for (int i = 0; i < 3600; ++i)
  {
    pair.Tick(At(0.002 + 4e-5 * i));
    unfinished += pair.B.IsUnfinished ? 1 : 0;
  }
  EXPECT_GT(unfinished, 0);
  EXPECT_GT(pair.MostWithout, 4.0);
  EXPECT_LT(pair.Most, MostStep);
  EXPECT_LE(pair.Work, pair.WorkWithout);
  EXPECT_EQ(Norm(pair.GetRemainder()), 0.0) << "it has ended";
}

TEST(ProxyRelease, LeavesWhatDoesNotLeapToTheBit)
{
  // The hand presses, strokes and lifts off without breaking through the shell.
  const TestVolume volume = MakeShell();
  Pair pair(DescribeShell(volume, 1e6));
  for (int i = 0; i < 2000; ++i)
  {
    const double z = 0.017 + 0.004 * std::sin(0.004 * i);
    pair.Tick({ 0.012 + 0.004 * std::sin(0.003 * i), 0.012, z });
    ASSERT_EQ(Norm(pair.GetRemainder()), 0.0) << i;
    ASSERT_EQ(pair.A.Proxy.Z, pair.B.Proxy.Z);
  }
  EXPECT_GT(pair.Work, -1.0);
  EXPECT_EQ(pair.Work, pair.WorkWithout);
}

TEST(ProxyRelease, GivesAHandThatTurnsBackNoMoreThanItsSpringHeld)
{
  // The tip breaks through the shell at 40 mm/s. After `late` ticks, it moves back along the force
  // at 0.04 to 0.5 m/s. At 0.5 m/s, a spring of 400 N/m changes its force by 0.2 N per tick.
  const TestVolume volume = MakeShell();
  for (const double strength : { 1.0, 3.0, 8.0 })
  {
    for (const int late : { 0, 1, 2, 4, 8, 16 })
    {
      for (const double speed : { 0.04, 0.2, 0.5 })
      {
        SCOPED_TRACE(testing::Message() << strength << " N, " << late << ", " << speed << " m/s");
        Pair pair(DescribeShell(volume, strength));
        double z = 0.002;
        int since = -1;
        double held = 0.0;   // energy (J) of the spring before the release
        double before = 0.0; // work (J) up to the release
        for (int i = 0; i < 1200 && z > 0.001; ++i)
        {
          const double force = Norm(pair.A.Force);
          const double work = pair.Work;
          z += since > late ? -speed * Period : 4e-5;
          pair.Tick(At(z));
          if (since < 0 && pair.StepWithout > 0.5)
          {
            held = 0.5 * force * force / pair.A.Stiffness;
            before = work;
            since = 0;
          }
          since += since >= 0 ? 1 : 0;
          EXPECT_LE(pair.Work - before, held + 1e-12) << i;
          EXPECT_LE(pair.Work, 1e-12) << i;
        }
        for (int i = 0; i < 100; ++i) // the tip rests
        {
          pair.Tick(At(z));
        }
        EXPECT_GT(since, late);
        EXPECT_LT(pair.Most, MostStep);
        EXPECT_GT(pair.MostWithout, 0.5 * strength);
        // Afterwards, the back of the shell may hold the proxy. The remainder of the earlier force
        // must then reduce the force.
        EXPECT_TRUE(Norm(pair.GetRemainder()) == 0.0 || Norm(pair.A.Force) < Norm(pair.B.Force));
      }
    }
  }
}

TEST(ProxyRelease, GoesOverForAHandOnItsWayBack)
{
  // The shell at z = 20 mm ends at x = 12 mm. The hand has pressed 12 mm through the shell, which
  // holds the proxy. The hand then moves along x and slowly back, so that the proxy slides to the
  // shell's end and slips off.
  TestVolume volume(ScalarType::Float32, { 24, 24, 48 });
  volume.Fill<float>(
    [](std::int64_t i, std::int64_t, std::int64_t k)
    {
      const double z = (double(k) - 20.0) / 2.0;
      return 1000.0 * std::exp(-z * z) * 0.5 * std::erfc(double(i) - 12.0);
    });
  for (const double speed : { 0.01, 0.1, 0.3 }) // m/s along x; 0.3 times as fast along -z
  {
    SCOPED_TRACE(speed);
    Pair pair(DescribeShell(volume, 1e6));
    for (int i = 0; i <= 600; ++i)
    {
      pair.Tick({ 0.008, 0.012, 0.002 + 5e-5 * i });
    }
    const double pressed = Norm(pair.B.Force);
    EXPECT_GT(pressed, 4.0);
    const double before = pair.Work;
    const int ticks = static_cast<int>(0.01 / (speed * Period));
    for (int i = 0; i <= ticks; ++i)
    {
      const double way = speed * Period * i;
      pair.Tick({ 0.008 + way, 0.012, 0.032 - 0.3 * way });
    }
    for (int i = 0; i < 100; ++i)
    {
      pair.Tick(pair.StateB.PreviousTip);
    }
    EXPECT_GT(pair.MostWithout, 1.0) << "it slides off in one tick";
    EXPECT_LT(pair.Most, MostStep);
    EXPECT_GT(pair.Work, pair.WorkWithout) << "the hand gets a part of the spring's energy";
    EXPECT_LE(pair.Work - before, 0.5 * pressed * pressed / pair.A.Stiffness);
    EXPECT_EQ(Norm(pair.GetRemainder()), 0.0);
  }
}

/// The hand walks at random at up to 0.5 m/s, on a spring of 400 N/m, in noise that has surfaces
/// everywhere.
TEST(ProxyRelease, HoldsItsLimitsOnRandomWalks)
{
  int remains = 0;
  double mostWithout = 0.0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE(seed);
    TestVolume volume(ScalarType::Float32, { 24, 24, 24 });
    volume.FillRandom(seed);
    HapticModelDescription d = Describe(volume);
    d.Settings.Side = seed % 3 == 0 ? SurfaceSide::Both : SurfaceSide::Higher;
    d.Material.Stiffness = ConstantPolyline(400.0);
    d.Material.Friction = ConstantPolyline(0.3);
    d.Material.Viscosity = ConstantPolyline(0.1);
    d.Material.SurfaceStrength = ConstantPolyline(seed % 2 == 0 ? 2.0 : 6.0);
    Pair pair(d);
    double x[3];
    double turn[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      turn[axis] = 1.7 * seed + 2.0 * axis;
    }
    for (int i = 0; i < 4000; ++i)
    {
      // The path is a Lissajous curve, which turns back everywhere, at a varying speed.
      const double t = 1e-3 * i + 0.15 * std::sin(0.0021 * i);
      const double rates[3] = { 13.0 + 0.7 * seed, 17.0 - 0.9 * seed, 19.0 + 0.3 * seed };
      for (int axis = 0; axis < 3; ++axis)
      {
        x[axis] = 0.012 + 0.008 * std::sin(rates[axis] * t + turn[axis]);
      }
      const Vector3 tip{ x[0], x[1], x[2] };
      const double way = i > 0 ? Norm(tip - pair.StateB.PreviousTip) : 0.0;
      ASSERT_LT(way, 0.6e-3);
      pair.Tick(tip);
      ASSERT_LT(pair.Step, std::max(MostStep, 400.0 * way + 0.02)) << i;
      ASSERT_LE(pair.Work, 1e-9) << i;
      remains += Norm(pair.GetRemainder()) > 0.0 ? 1 : 0;
    }
    mostWithout = std::max(mostWithout, pair.MostWithout);
  }
  EXPECT_GT(remains, 500) << "the walks have releases";
  EXPECT_GT(mostWithout, 1.0);
}

/**
 * The tissue's stiffness varies from 50 to 1000 N/m. The hand moves at up to 0.1 m/s, and its
 * springs are millimetres long. A proxy that creeps by hundredths of a voxel reaches tissue that is
 * softer by some percent, which changes a force of several newtons.
 */
TEST(ProxyRelease, HoldsItsLimitsWhereAProxyCreepsToSofterTissue)
{
  constexpr double stiffest = 1000.0;
  constexpr double friction = 0.3;
  int remains = 0;
  double mostWithout = 0.0;
  for (unsigned seed = 1; seed <= 8; ++seed)
  {
    SCOPED_TRACE(seed);
    TestVolume volume(ScalarType::Float32, { 24, 24, 24 });
    volume.FillRandom(seed);
    HapticModelDescription d = Describe(volume);
    d.Material.Stiffness = { { -2e5, 50.0 }, { 2e5, stiffest } };
    d.Material.Friction = ConstantPolyline(friction);
    d.Material.SurfaceStrength = ConstantPolyline(seed % 2 == 0 ? 8.0 : 20.0);
    Pair pair(d);
    for (int i = 0; i < 8000; ++i)
    {
      const double t = 1e-3 * i;
      double x[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        x[axis] = 0.012 + 0.008 * std::sin((3.1 + 1.3 * axis + 0.2 * seed) * t + 1.7 * seed + axis);
      }
      const Vector3 tip{ x[0], x[1], x[2] };
      const double way = i > 0 ? Norm(tip - pair.StateB.PreviousTip) : 0.0;
      pair.Tick(tip);
      const double own = stiffest * std::sqrt(1.0 + friction * friction) * way + 0.02;
      ASSERT_LT(pair.Step, std::max(MostStep, own)) << i;
      ASSERT_LE(pair.Work, 1e-9) << i;
      remains += Norm(pair.GetRemainder()) > 0.0 ? 1 : 0;
    }
    mostWithout = std::max(mostWithout, pair.MostWithout);
  }
  EXPECT_GT(remains, 500) << "the walks have releases";
  EXPECT_GT(mostWithout, 1.0);
}

TEST(ProxyRelease, IsNotOfPaperAndOfTheKernelsMaterials)
{
  const TestVolume volume = MakeShell();
  HapticModelDescription d = DescribeShell(volume, 3.0);
  PlaceAsThePaper(d);
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    d.Settings.Solver = solver;
    Pair pair(d);
    for (int i = 0; i < 1050; ++i)
    {
      pair.Tick(At(0.002 + 4e-5 * i));
      ASSERT_EQ(Norm(pair.GetRemainder()), 0.0);
    }
    EXPECT_GT(pair.Most, 1.0);
  }
}

TEST(ProxyRelease, GoesOnToTheBitIfStored)
{
  const TestVolume volume = MakeShell();
  const HapticModel model(DescribeShell(volume, 3.0));
  ServoState state;
  TickRecord a;
  TickRecord b;
  int remains = 0;
  for (int i = 0; i < 1050; ++i)
  {
    ServoState stored = FromNumbers(ToNumbers(state));
    Tick(model, state, At(0.002 + 4e-5 * i), a);
    Tick(model, stored, At(0.002 + 4e-5 * i), b);
    ASSERT_EQ(ToNumbers(state), ToNumbers(stored));
    ASSERT_TRUE(AreOfAState(ToNumbers(state)));
    ASSERT_EQ(Norm(a.Force - b.Force), 0.0);
    remains += Norm(state.Release.Force) > 0.0 ? 1 : 0;
  }
  EXPECT_GT(remains, 10);
}

TEST(ProxyRelease, EndsWithTheTouch)
{
  // After the tip was lost, or in a model without a release time, no remainder of earlier forces is
  // felt.
  const TestVolume volume = MakeShell();
  HapticModelDescription d = DescribeShell(volume, 3.0);
  const HapticModel model(d);
  d.Settings.ReleaseTime = 0.0;
  const HapticModel other(d);
  ServoState state;
  TickRecord record;
  double z = 0.002;
  while (!(Norm(state.Release.Force) > 0.0) && z < 0.045)
  {
    Tick(model, state, At(z += 4e-5), record);
  }
  ASSERT_GT(Norm(state.Release.Force), 2.0);
  ServoState swapped = state;
  Tick(other, swapped, At(z), record);
  EXPECT_EQ(Norm(swapped.Release.Force), 0.0);
  state.Enabled = false;
  Tick(model, state, At(z), record);
  EXPECT_EQ(Norm(record.Force), 0.0);
  EXPECT_EQ(Norm(state.Release.Force), 0.0);
}
