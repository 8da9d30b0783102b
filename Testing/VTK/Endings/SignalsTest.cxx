// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the device has no force when a terminating signal reaches the application's handler.
 * Each test runs a child process, because the process ends with a signal.
 */

#include "SignalsRig.h"

using namespace devicetest;

TEST_F(Signals, CutTheForceBeforeTheHandlerThatWasThere)
{
  for (const int signal : { SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGTSTP })
  {
    EXPECT_EQ(InChild(
                [&]
                {
                  std::signal(signal, OnSignal);
                  const bool active = this->Activate();
                  kill(getpid(), signal);
                  const bool handled = Eventually([] { return Handled.load() > 0; });
                  return active && handled ? ForceWhenHandled.load() : 50;
                }),
      0)
      << strsignal(signal);
  }
}

TEST_F(Signals, CutTheForceAgainAfterArmingAgain)
{
  EXPECT_EQ(InChild(
              [&]
              {
                std::signal(SIGINT, OnSignal);
                for (int i = 1; i <= 3; ++i)
                {
                  const bool active = this->Activate();
                  kill(getpid(), SIGINT);
                  const bool handled = Eventually([&] { return Handled.load() == i; });
                  if (!active || !handled || ForceWhenHandled.load() > 0)
                  {
                    return i;
                  }
                }
                return 0;
              }),
    0);
}

TEST_F(Signals, EndTheProcessWhereNothingHandlesThem)
{
  EXPECT_EQ(InChild(
              [&]
              {
                this->Activate();
                kill(getpid(), SIGTERM);
                return Eventually([] { return false; }) ? 1 : 2;
              }),
    -SIGTERM);
}

TEST_F(Signals, ToAChildProcessAreItsOwn)
{
  EXPECT_EQ(InChild(
              [&]
              {
                this->Activate();
                const pid_t child = fork();
                if (child == 0)
                {
                  return Eventually([] { return false; }) ? 1 : 2;
                }
                kill(child, SIGTERM);
                const int result = Wait(child);
                return result == -SIGTERM && this->WaitForce() ? 0 : 3;
              }),
    0);
}
