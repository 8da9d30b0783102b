// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds Haply's Inverse service on this computer, and asks it by HTTP.
 */
#ifndef HaplyService_h
#define HaplyService_h

#include "Devices/Haply/HaplyMessages.h"

#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/** The cure if the service does not answer, for errors. */
extern const char* const HowToStartHaply;

/**
 * Where the service listens: $VOLUMEHAPTICS_HAPLY, "PORT", "PORT,EVENTS" or "PORT,EVENTS,HTTP", or
 * its defaults. By the documentation, HTTP is at 10000 up to 3.1, and at the port of the states in
 * 3.5.
 */
struct HaplyPorts
{
  std::uint16_t States = 10001; ///< the port of the states and, in later services, of HTTP
  std::uint16_t Events = 10020;
  std::uint16_t Http = 10000; ///< the port of HTTP in earlier services

  /**
   * Reads the ports. If this fails, returns false and writes the reason and the cure to `error`.
   */
  static bool Read(HaplyPorts& ports, std::string& error);
};

/**
 * Asks the service by HTTP: "/version", or "/devices", at either port, with the prefix of a
 * version; writes the answer to `text`. If this fails, returns false and writes the reason to
 * `error`.
 */
bool AskHaply(
  const HaplyPorts& ports, const std::string& target, std::string& text, std::string& error);

/**
 * Asks the service for its version. If this fails, returns false and writes the reason and the cure
 * to `error`.
 */
bool DetectHaplyService(const HaplyPorts& ports, HaplyVersion& version, std::string& error);

/**
 * Returns a name for people: maker, product, the service's name of the arm, and the hand that it is
 * built for.
 */
std::string NameOfHaply(const HaplyArm& arm);

} // namespace VolumeHaptics

#endif
