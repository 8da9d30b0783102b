// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMHapticRegionProxy
 * @brief   the client's side of vtkPVHapticRegionSender
 *
 * A fetch sends one message and receives one answer, so it takes one round trip plus the time to
 * extract and send the region. The client waits, because ParaView's connection can't be used for
 * anything else during a fetch.
 */
#ifndef vtkSMHapticRegionProxy_h
#define vtkSMHapticRegionProxy_h

#include "VolumeHapticsLiveModule.h" // for export macro
#include "vtkSMSourceProxy.h"

#include <string> // for std::string

class vtkImageData;

class VOLUMEHAPTICSLIVE_EXPORT vtkSMHapticRegionProxy : public vtkSMSourceProxy
{
public:
  static vtkSMHapticRegionProxy* New();
  vtkTypeMacro(vtkSMHapticRegionProxy, vtkSMSourceProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Answer
  {
    FETCHED,
    REFUSED, ///< the error contains the server's reason
    LOST     ///< the server does not answer
  };

  /**
   * Fetches a region of the Input at a time and writes it to an image: see
   * vtkPVHapticRegionSender::Send.
   */
  Answer Fetch(const std::string& array, const int region[6], double time, bool isPresent,
    vtkImageData* image, std::string& error);

  ///@{
  /** Whether the Input has changed since the position of its volume was last requested. */
  vtkGetMacro(Stale, bool);
  vtkSetMacro(Stale, bool);
  ///@}

  void MarkDirty(vtkSMProxy* modified) override;

protected:
  vtkSMHapticRegionProxy();
  ~vtkSMHapticRegionProxy() override;

private:
  vtkSMHapticRegionProxy(const vtkSMHapticRegionProxy&) = delete;
  void operator=(const vtkSMHapticRegionProxy&) = delete;

  bool HasSender();

  bool Stale = true;
  bool IsKnown = false; // whether the server is known to have a sender
};

#endif
