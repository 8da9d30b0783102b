// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds Haply's Inverse service on this computer, and sends it requests over HTTP.
 */
#ifndef HaplyService_h
#define HaplyService_h

#include "Devices/Haply/HaplyMessages.h"

#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/** Cure for error texts if the service does not answer. */
extern const char* const HowToStartHaply;

/**
 * The ports of the service: those in $VOLUMEHAPTICS_HAPLY ("PORT", "PORT,EVENTS" or
 * "PORT,EVENTS,HTTP"), or the default ports. According to the documentation, HTTP uses port 10000
 * up to version 3.1, and the port of the states in version 3.5.
 */
struct HaplyPorts
{
  std::uint16_t States = 10001; ///< port of the states and, from version 3.5, of HTTP
  std::uint16_t Events = 10020;
  std::uint16_t Http = 10000; ///< port of HTTP in earlier versions

  /** Reads the ports. Returns false and writes the reason and the cure to `error` if this fails. */
  static bool Read(HaplyPorts& ports, std::string& error);
};

/**
 * Sends an HTTP request, trying both ports. `target` is "/version" or "/devices", with the prefix
 * of a version. Writes the answer to `text`. On failure, returns false and writes the reason to
 * `error`.
 */
bool AskHaply(
  const HaplyPorts& ports, const std::string& target, std::string& text, std::string& error);

/**
 * Requests the service's version. On failure, returns false and writes the reason and the cure to
 * `error`.
 */
bool DetectHaplyService(const HaplyPorts& ports, HaplyVersion& version, std::string& error);

/**
 * Returns a name for the user: maker, product, the service's identifier of the arm, and the
 * handedness.
 */
std::string NameOfHaply(const HaplyArm& arm);

} // namespace VolumeHaptics

#endif
