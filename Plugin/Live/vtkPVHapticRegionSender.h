// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHapticRegionSender
 * @brief   sends regions of a volume from the data server to the client
 *
 * Every process of the server requests the piece from its input that it already has, so that
 * nothing is read again. The first process sends the region that they assemble. See
 * vtkSMHapticRegionProxy for the other side.
 */
#ifndef vtkPVHapticRegionSender_h
#define vtkPVHapticRegionSender_h

#include "VolumeHapticsLiveModule.h" // for export macro
#include "vtkAlgorithm.h"
#include "vtkNew.h" // for ivars

#include <string> // for std::string
#include <vector> // for std::vector

class vtkImageData;
class vtkPVHapticRegionFilter;

class VOLUMEHAPTICSLIVE_EXPORT vtkPVHapticRegionSender : public vtkAlgorithm
{
public:
  static vtkPVHapticRegionSender* New();
  vtkTypeMacro(vtkPVHapticRegionSender, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Send a region (an extent) of a point array by name. An empty name means the active scalars. A
   * region without indices means a corner of the volume, from which the client learns the position
   * of the whole. Call it on all processes together. The client gets exactly one answer: the
   * region, or an error.
   */
  void Send(const char* array, int x0, int x1, int y0, int y1, int z0, int z1);

protected:
  vtkPVHapticRegionSender();
  ~vtkPVHapticRegionSender() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkPVHapticRegionSender(const vtkPVHapticRegionSender&) = delete;
  void operator=(const vtkPVHapticRegionSender&) = delete;

#ifndef __VTK_WRAP__
  bool UpdatePiece(int whole[6]);
  bool Assemble(const char* array, const int region[6], std::string& error);
#endif

  vtkNew<vtkPVHapticRegionFilter> Filter;
  std::string Array;
};

#endif
