// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests settings that are NaN or infinite. They must be refused or reported, and never used. */

#include "Rigs/ApiRig.h"

#include <cmath>
#include <limits>

using namespace apitest;

namespace
{
struct BadSetting
{
  const char* Name;
  void (vtkVolumeHapticsFilter::*Set)(double);
};

const BadSetting BadSettings[] = {
  { "ServoRate", &vtkVolumeHapticsFilter::SetServoRate },
  { "MetersPerWorldUnit", &vtkVolumeHapticsFilter::SetMetersPerWorldUnit },
  { "ForceFieldGain", &vtkVolumeHapticsFilter::SetForceFieldGain },
  { "ForceFieldDamping", &vtkVolumeHapticsFilter::SetForceFieldDamping },
  { "IsoValue", &vtkVolumeHapticsFilter::SetIsoValue },
  { "ProxyRadius", &vtkVolumeHapticsFilter::SetProxyRadius },
  { "LocalSurfaceRate", &vtkVolumeHapticsFilter::SetLocalSurfaceRate },
  { "RecoveryTime", &vtkVolumeHapticsFilter::SetRecoveryTime },
  { "ReleaseTime", &vtkVolumeHapticsFilter::SetReleaseTime },
  { "MaximumForce", &vtkVolumeHapticsFilter::SetMaximumForce },
  { "MaximumStiffness", &vtkVolumeHapticsFilter::SetMaximumStiffness },
};

class BadSettingTest
  : public ApiTest
  , public testing::WithParamInterface<BadSetting>
{
};
} // namespace

TEST_P(BadSettingTest, NeverReachesTheOutput)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  (this->Filter.Get()->*this->GetParam().Set)(nan);
  for (const int method : { vtkVolumeHapticsFilter::PROXY, vtkVolumeHapticsFilter::FORCE_FIELD,
         vtkVolumeHapticsFilter::LOCAL_SURFACE })
  {
    this->Filter->SetMethod(method);
    this->Log.Errors.clear();
    this->Filter->Update();
    // Expect one error that names the setting and an empty output, or no error if the setting was
    // clamped to its range.
    EXPECT_LE(this->Log.Errors.size(), 1U);
    vtkPolyData* const output = this->Filter->GetOutput();
    EXPECT_EQ(output->GetNumberOfPoints(), this->Log.Errors.empty() ? 51 : 0);
    for (const std::string& error : this->Log.Errors)
    {
      EXPECT_NE(error.find(this->GetParam().Name), std::string::npos) << error;
    }
    for (vtkIdType tick = 0; tick < output->GetNumberOfPoints(); ++tick)
    {
      ASSERT_TRUE(std::isfinite(Get(output, "Force", tick, 2))) << "tick " << tick;
      ASSERT_TRUE(std::isfinite(Get(output, "Time", tick))) << "tick " << tick;
      ASSERT_TRUE(std::isfinite(output->GetPoint(tick)[2])) << "tick " << tick;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadSettingTest, testing::ValuesIn(BadSettings),
  [](const auto& info) { return std::string(info.param.Name); });
