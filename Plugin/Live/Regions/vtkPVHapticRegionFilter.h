// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHapticRegionFilter
 * @brief   a region of a volume whose pieces are on several processes
 *
 * Runs like a vtkHapticRegionFilter on every process of a controller. Each process has its own
 * piece and the whole volume's extent; the first process gets the output. The estimated noise is
 * bit-identical to that of the whole volume, for any division into pieces. All processes must
 * execute the filter collectively, after CanExecute has returned true on all of them.
 */
#ifndef vtkPVHapticRegionFilter_h
#define vtkPVHapticRegionFilter_h

#include "VolumeHapticsLiveModule.h" // for export macro
#include "vtkHapticRegionFilter.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string> // for std::string

class vtkImageData;
class vtkMultiProcessController;
class vtkTrivialProducer;

class VOLUMEHAPTICSLIVE_EXPORT vtkPVHapticRegionFilter : public vtkHapticRegionFilter
{
public:
  static vtkPVHapticRegionFilter* New();
  vtkTypeMacro(vtkPVHapticRegionFilter, vtkHapticRegionFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The controller of the processes. nullptr (default) stands for this process alone. */
  void SetController(vtkMultiProcessController* controller);

  /**
   * Set the piece of this process (null or empty if it has none), and the extent of the whole
   * volume.
   */
  void SetPiece(vtkImageData* piece, const int whole[6]);

  /**
   * Returns whether all processes can execute: each has its piece, and the array is usable. All
   * processes must call this collectively. On the first process, `error` describes a fault on any
   * of them.
   */
  bool CanExecute(bool hasPiece, std::string& error);

  /**
   * Get the reason why gathering the last region failed; empty if it did not fail or was not
   * attempted.
   */
  std::string GetProblem() const;

protected:
  vtkPVHapticRegionFilter();
  ~vtkPVHapticRegionFilter() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
#ifndef __VTK_WRAP__
  bool IsCurrent(vtkMTimeType time) override;
  void GatherSamples(SamplesOfComponents& samples) override;
  bool GatherRegion(vtkImageData* piece, vtkDataArray* array, const int region[6],
    vtkImageData* output, std::string& error) override;
#endif

private:
  vtkPVHapticRegionFilter(const vtkPVHapticRegionFilter&) = delete;
  void operator=(const vtkPVHapticRegionFilter&) = delete;

  bool IsAlone() const;
#ifndef __VTK_WRAP__
  void ShareName(int from);
#endif

  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkSmartPointer<vtkTrivialProducer> Producer;
  vtkWeakPointer<vtkImageData> Seen;
  vtkMTimeType SeenTime = 0;
  int ArrayType = 0; // the same on all processes
  int Components = 0;
  std::string ArrayName;
  std::string Problem;
};

#endif
