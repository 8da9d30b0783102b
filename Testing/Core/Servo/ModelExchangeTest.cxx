// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that no owner of a model uses it after it was freed.
 */

#include "Core/Servo/ModelExchange.h"
#include "Rigs/LocalSurfaceRig.h"

#include <thread>
#include <vector>

using namespace coretest;

namespace
{
std::shared_ptr<const HapticModel> MakeModel()
{
  const auto volume = std::make_shared<TestVolume>(MakeRamp(12));
  HapticModelDescription d = DescribeLocal(*volume, 600.0);
  d.Samples = volume;
  return std::make_shared<const HapticModel>(d);
}
} // namespace

TEST(ModelExchange, FreesWhatIsNeitherUsedNorHeld)
{
  ModelExchange exchange;
  EXPECT_EQ(exchange.Hold(ModelExchange::Fitter), nullptr);
  std::weak_ptr<const HapticModel> first;
  {
    auto model = MakeModel();
    first = model;
    EXPECT_EQ(exchange.Publish(std::move(model)), 1U);
  }
  EXPECT_EQ(exchange.Hold(ModelExchange::Fitter), first.lock().get());
  exchange.Publish(MakeModel());
  exchange.Acknowledge(2);
  exchange.Collect();
  EXPECT_FALSE(first.expired()) << "the fitter holds it";
  exchange.LetGo(ModelExchange::Fitter);
  exchange.Collect();
  EXPECT_TRUE(first.expired());
  std::weak_ptr<const HapticModel> second = exchange.GetLatest()->Model;
  exchange.Publish(MakeModel());
  EXPECT_FALSE(second.expired()) << "the servo has not seen the third";
}

TEST(ModelExchange, AFitterNeverSeesAModelThatIsFreed)
{
  ModelExchange exchange;
  std::atomic<bool> done{ false };
  std::atomic<int> found{ 0 };
  std::thread fitter(
    [&]
    {
      while (!done.load())
      {
        if (const HapticModel* const model = exchange.Hold(ModelExchange::Fitter))
        {
          // If the model had been freed, a sanitizer would report this access.
          found += FitLocalSurface(*model, { { 5.0, 5.0, 4.0 }, {}, {} }).IsThere ? 1 : 0;
        }
        exchange.LetGo(ModelExchange::Fitter);
      }
    });
  for (int i = 0; i < 300 || found.load() < 10; ++i)
  {
    exchange.Acknowledge(exchange.Publish(MakeModel()));
    exchange.Collect();
  }
  done.store(true);
  fitter.join();
  EXPECT_GE(found.load(), 10);
}
