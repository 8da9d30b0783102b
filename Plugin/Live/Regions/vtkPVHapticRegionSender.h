// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHapticRegionSender
 * @brief   sends regions of a volume from the data server to the client
 *
 * Every process of the server requests from its input the piece that it already has, so that
 * nothing is read again. The processes assemble the region together, and the first process sends
 * it. If the data have several times, the pieces of the last two sent times are stored, so that
 * regions of both can be requested. See vtkSMHapticRegionProxy for the client's side.
 *
 * Composite data and data other than images are gathered on the first process, which resamples the
 * regions (vtkHapticRegionSource::OpenDataSet).
 *
 * For a vtkPVHapticLargeFile, the first process reads regions from the file itself.
 */
#ifndef vtkPVHapticRegionSender_h
#define vtkPVHapticRegionSender_h

#include "VolumeHapticsLiveModule.h" // for export macro
#include "vtkAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkImageData;

class VOLUMEHAPTICSLIVE_EXPORT vtkPVHapticRegionSender : public vtkAlgorithm
{
public:
  static vtkPVHapticRegionSender* New();
  vtkTypeMacro(vtkPVHapticRegionSender, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Send a region (an extent) of a point array by name. An empty name stands for the active
   * scalars. An empty region stands for a corner of the volume, which also contains the position of
   * the whole. `time` is the time of the input's current volume, or one of the last two sent times;
   * for any other time, the answer is an error. All processes must call this collectively. The
   * client receives exactly one answer: the region, or an error.
   */
  void Send(
    const char* array, int x0, int x1, int y0, int y1, int z0, int z1, double time, int isPresent);

protected:
  vtkPVHapticRegionSender();
  ~vtkPVHapticRegionSender() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkPVHapticRegionSender(const vtkPVHapticRegionSender&) = delete;
  void operator=(const vtkPVHapticRegionSender&) = delete;

  struct Instant;
#ifndef __VTK_WRAP__
  Instant* Find(double time, bool isPresent);
  bool UpdatePiece(Instant& instant);
  bool ReadLargeFile(const int region[6], vtkImageData* image, std::string& error);
  /**
   * Returns whether any process has data other than images. All processes must call this
   * collectively.
   */
  static bool IsGrid(const Instant& instant);
  bool Assemble(
    Instant& instant, bool hasPiece, const char* array, const int region[6], std::string& error);
  /**
   * Resamples a region of data other than images. The first process gets the image. All processes
   * must call this collectively.
   */
  static bool Resample(Instant& instant, bool hasPiece, const char* array, const int region[6],
    vtkImageData* image, std::string& error);
#endif

  std::unique_ptr<Instant> Instants[2];
  int Latest = 0; ///< index of the latest time in Instants
};

#endif
