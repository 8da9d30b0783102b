// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reports the state and the problems of a device in the properties of its proxy.
 */
#ifndef HapticReport_h
#define HapticReport_h

#include "HapticErrorCatcher.h"

#include <string>

class vtkHapticDevice;
class vtkObject;
class vtkSMProxy;

namespace VolumeHapticsLive
{

class HapticReport
{
public:
  /** Collects the errors of this object as problems instead of showing them. */
  void Catch(vtkObject* object) { this->Errors.Catch(object); }
  /**
   * Makes the errors since the last call the current problem. Returns their text if it is new,
   * otherwise "".
   */
  std::string DrainNewError();

  ///@{
  /** Set and get the current problem; empty if there is none. */
  void SetProblem(const std::string& problem) { this->Problem = problem; }
  bool HasProblem() const { return !this->Problem.empty(); }
  const std::string& GetProblem() const { return this->Problem; }
  ///@}
  ///@{
  /**
   * Set the reason why the device was stopped. It is shown until the device is started again, but
   * not while there is a problem.
   */
  void SetNotice(const std::string& notice) { this->Notice = notice; }
  const std::string& GetNotice() const { return this->Notice; }
  ///@}

  /** Set the proxy's information properties to the device's latest state. `latency` is in s. */
  void ReportInformation(vtkSMProxy* proxy, vtkHapticDevice* device, double latency) const;

  /**
   * Set the proxy's property State to the device's latest state, for vtkPVHapticStateSource. The
   * caller sends it to the server.
   */
  static void ReportState(vtkSMProxy* proxy, vtkHapticDevice* device);

private:
  HapticErrorCatcher Errors;
  std::string Problem;
  std::string Notice;
  std::string Reported; // last reported error
};

} // namespace VolumeHapticsLive

#endif
