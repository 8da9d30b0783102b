// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRegionSource
 * @brief   reads a volume that is too large for memory, region by region around the hand
 *
 * Provides a volume from a file, or from anything that a function can read boxes of samples from.
 * Only regions of the volume are in memory, unless OpenWholeFile() opened it. Connect it directly
 * to port 0 of vtkVolumeHapticsFilter:
 *
 *   source->SetFileName("Bone.raw");              // or OpenFile; or SetReader, C++ only
 *   source->SetWholeExtent(0, 4095, 0, 4095, 0, 2047);
 *   source->SetSpacing(0.01, 0.01, 0.01);
 *   source->SetScalarType(VTK_UNSIGNED_SHORT);
 *   haptics->SetInputConnection(0, source->GetOutputPort());
 *   device->SetVolumeHaptics(haptics);
 *   device->Start();
 *   device->Arm();
 *
 * Paths. Each tick of a path waits for the samples that it reads: the trace is that of the whole
 * volume in memory, to the bit. The samples are read on the calling thread, and the paths are
 * computed one after another. A read that fails is an error of the filter. A path can't be a
 * recording.
 *
 * Live. vtkHapticDevice::UpdateState calls Follow, which plans the region around the tip
 * (Documentation/method.md, "Regions of a volume"). A thread of the source reads this region, and
 * writes it into memory before the servo sees it; neither the servo nor the GUI thread ever waits
 * for the read. Where samples are late, or can't be read, the force fades within 50 ms
 * (vtkHapticState::GetResidency), and returns when the samples are there. Until then, a
 * CoarseImage, if there is one, stands in, with half of its force. A failed read gives one error,
 * is reported by GetStatusText() of source and device, and is repeated at intervals that grow from
 * 50 ms to 2 s. At first nothing is felt: 512 blocks of 5^3 samples are read to estimate the noise,
 * or all samples of a volume of at most 2^26 samples. A source follows one device: two hands need
 * two sources.
 *
 * The output is the region that was read last, or a region of the CoarseImage that stands in, with
 * the field arrays of vtkHapticRegionFilter. Before the first region is there, it is a few voxels
 * of zeros in the middle of the volume. Its scalars are called "Scalars" and have one component.
 *
 * @sa vtkVolumeHapticsFilter, vtkInteractorStyleHaptic::SetCoarseVolume
 */
#ifndef vtkHapticRegionSource_h
#define vtkHapticRegionSource_h

#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

#ifndef __VTK_WRAP__
#include <functional> // for std::function
#include <vector>     // for std::vector

namespace VolumeHaptics
{
class DataSetSampler;
class RegionPlanner;
class RegionStore;
} // namespace VolumeHaptics
#endif

class vtkDataArray;
class vtkDataObject;
class vtkImageData;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticRegionSource : public vtkImageAlgorithm
{
public:
  static vtkHapticRegionSource* New();
  vtkTypeMacro(vtkHapticRegionSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The extent of the whole volume. Default (0, -1, 0, -1, 0, -1): none. */
  vtkSetVector6Macro(WholeExtent, int);
  vtkGetVector6Macro(WholeExtent, int);
  ///@}

  ///@{
  /** The origin of the whole volume, as that of vtkImageData. Default (0, 0, 0). */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /** The spacing of the whole volume (world units). Default (1, 1, 1). */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  ///@{
  /** The direction of the whole volume: nine numbers, row by row. Default: the identity. */
  void SetDirection(const double direction[9]) VTK_SIZEHINT(9);
  vtkGetVectorMacro(Direction, double, 9);
  ///@}

  ///@{
  /** The type of the samples: VTK_SHORT (4, default), VTK_FLOAT (10) or another type of numbers. */
  vtkSetMacro(ScalarType, int);
  vtkGetMacro(ScalarType, int);
  ///@}

  ///@{
  /**
   * A raw file of samples, x fastest and z slowest, without compression. It is opened for each
   * region, so it may be replaced or grow while it is felt. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** The size (bytes) of the file's header, which is skipped. Default 0. */
  vtkSetClampMacro(HeaderSize, vtkTypeInt64, 0, 1099511627776);
  vtkGetMacro(HeaderSize, vtkTypeInt64);
  ///@}

  /** Byte orders of a raw file. */
  enum ByteOrderType
  {
    LITTLE = 0,
    BIG = 1
  };

  ///@{
  /**
   * The byte order of the file: LITTLE (default), that is, least significant byte first, or BIG.
   */
  vtkSetClampMacro(ByteOrder, int, LITTLE, BIG);
  vtkGetMacro(ByteOrder, int);
  void SetByteOrderToLittleEndian() { this->SetByteOrder(LITTLE); }
  void SetByteOrderToBigEndian() { this->SetByteOrder(BIG); }
  ///@}

  ///@{
  /**
   * The largest memory (bytes) that regions use during live touch, 4194304 (4 MiB) to 2^40. Default
   * 67108864 (64 MiB). A region takes at most a quarter of it: one region is felt, one is the
   * output, one has just arrived and one is being read. One more region, of the CoarseImage, takes
   * at most 2^20 samples. Paths use one region, usually of a million voxels.
   */
  vtkSetClampMacro(MemoryLimit, vtkTypeInt64, 4194304, 1099511627776);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  ///@{
  /** The speed of the hand that the regions allow for (m/s), 0 to 10. Default 0.5. */
  vtkSetClampMacro(MaximumSpeed, double, 0.0, 10.0);
  vtkGetMacro(MaximumSpeed, double);
  ///@}

  ///@{
  /**
   * An image of the whole volume in memory, at the same position in the world and with coarser
   * voxels, such as an upper level of an image pyramid. Live, it is felt where samples are late;
   * paths don't use it. A window may show it. Do not change it while it is set. Default: none.
   */
  void SetCoarseImage(vtkImageData* image);
  vtkImageData* GetCoarseImage();
  ///@}

  /**
   * Make the CoarseImage from the samples, if there is no better one: averages of cubes, at most
   * mostVoxels of them. Files in chunks are read chunk by chunk; in other files, one row in each
   * square of the cubes is read. This takes as long as the reading, so call it before the volume is
   * felt. Returns false and reports an error if a read fails.
   */
  bool MakeCoarseImage(vtkIdType mostVoxels = 4194304);

#ifndef __VTK_WRAP__
  /**
   * Function that fills memory of exactly the size of a box (an extent within the whole) with its
   * samples, x fastest and z slowest. On failure, it returns false, or throws an exception whose
   * text gives the reason; it is then called again later. It is called by the thread of this
   * source, and along paths by the thread that computes them, perhaps by both at once.
   */
  using Reader = std::function<bool(const int extent[6], void* samples)>;

  /**
   * Read the samples with a function instead of from a file; an empty function restores the file.
   * SetReader and the destructor wait for the end of a call in progress. If `isAwaited` is false,
   * they don't wait; the function must then own everything that it uses, and is destroyed after its
   * last call.
   */
  void SetReader(Reader reader, bool isAwaited = true);
#endif

  ///@{
  /**
   * Open a file that describes its contents: a VTKHDF image (.vtkhdf), whose active array is read;
   * a MetaImage or NRRD file (.mhd, .mha, .nhdr, .nrrd), whose samples are in it or in one file
   * beside it; a TIFF file (.tif, .tiff) with a page for each slice, or a folder of TIFF files in
   * the order of the numbers in their names; a FreeSurfer volume (.mgh) or a MINC 1 file (.mnc); or
   * a folder (.zarr) of a Zarr array or an OME-Zarr image. Sets extent, type, origin, spacing and
   * direction, and a reader, as SetReader does; and the CoarseImage, if the file has coarser
   * levels: the finest one of at most 2^22 voxels, which is read at once.
   *
   * The samples may lie in one piece or in chunks; samples of VTKHDF may be compressed by gzip,
   * samples of Zarr by zlib, gzip, lz4, zstd or Blosc, and in shards, but samples of MetaImage,
   * NRRD and FreeSurfer must be uncompressed. A NRRD file in the space right-anterior-superior is
   * converted to left-posterior-superior, as ITK does. Returns false and reports an error that
   * names the cure if it can't be read; nothing is changed then. If the file is written again, open
   * it again. HDF5's library opens VTKHDF; while it does, no other thread may use that library.
   *
   * Lengths are turned into millimetres where NRRD, TIFF or OME-Zarr name their unit. Of several
   * volumes in a file, such as times, channels or components of the voxels, the one with the number
   * `series` is read, from 1 on; 0: the first one.
   */
  bool OpenFile(const char* fileName, int series = 0);
#ifndef __VTK_WRAP__
  /** Open a file like the function above, but return the error as a text. */
  bool OpenFile(const char* fileName, std::string& error, int series = 0);
#endif
  ///@}

  ///@{
  /**
   * Open a file like OpenFile(), but also a file whose samples can't be read in boxes, because they
   * are compressed, written as text or in several files: a MetaImage or NRRD file, or a packed
   * volume of FreeSurfer (.mgz). The first read loads all samples of such a file into memory.
   */
  bool OpenWholeFile(const char* fileName, int series = 0);
#ifndef __VTK_WRAP__
  bool OpenWholeFile(const char* fileName, std::string& error, int series = 0);
#endif
  ///@}

  ///@{
  /**
   * Get the volumes in the opened file that `series` may choose, each with its number, such as `2
   * channel 2 of 3 (DAPI)`, and the number that was read. A file with one volume has none.
   */
  int GetNumberOfSeries();
  const char* GetSeriesName(int index);
  int GetSeriesNumber();
  ///@}

  /**
   * Get the format of a file by its extension, or of a folder by the kind of most of its files,
   * such as "NRRD"; empty if OpenFile() does not support it. The file need not exist.
   */
  static std::string GetFileFormat(const char* fileName);

  /**
   * Get the extensions of the files and folders that OpenFile() reads, separated by blanks, such as
   * ".nrrd .tif".
   */
  static std::string GetFileEndings();

  /**
   * Get the length (mm) of a unit from its name or symbol in files, such as "um", "micrometer" or
   * "inch"; 0 for an unknown unit. OpenFile() converts lengths with it.
   */
  static double GetMillimetersPerUnit(const char* unit);

  /**
   * Get notes on what OpenFile() assumed or ignored, such as a missing voxel size, one per line;
   * empty if there are none, or if no file was opened.
   */
  std::string GetFileNotes() const
  {
    return this->FileNotes;
  }

  /**
   * Discard all samples that were read. Call this if the samples behind the reader or in the file
   * have changed, which the source does not detect. Waits like SetReader.
   */
  void Reload();

  /**
   * Plan and receive regions. Call this on each tick of the GUI if no vtkHapticDevice does, with
   * the tip (world) and its time (s), after vtkVolumeHapticsFilter::ConfigureSource. Returns
   * whether the output has a new region, which must then be published. Does not wait, unless a
   * setting of the volume was changed during a read.
   */
  bool Follow(const double tip[3], double time);

  ///@{
  /**
   * Read the samples of a region (an extent of any size, clipped to the whole) unchanged into an
   * image, with the field arrays of a region, and wait until that is done. On failure, reports an
   * error and returns false.
   */
  bool ReadRegion(const int region[6], vtkImageData* image);
#ifndef __VTK_WRAP__
  /** Read a region like the function above, but return the error as a text. */
  bool ReadRegion(const int region[6], vtkImageData* image, std::string& error);
#endif
  ///@}

#ifndef __VTK_WRAP__
  ///@{
  /**
   * Reserve the source for one device, whose tip the regions then follow. TakeLead returns false
   * while another device has reserved it.
   */
  bool TakeLead(const void* device);
  void LeaveLead(const void* device);
  ///@}
  /**
   * Report the time (s) that it took until the last region could be felt; a device calls this.
   * Later regions are ordered earlier by this time.
   */
  void NoteUseTime(double seconds);
#endif

  /**
   * Provide a vtkDataSet that is not an image, or the parts with cells of a vtkCompositeDataSet:
   * its arrays are resampled where the hand needs them, with a spacing (world units); 0 stands for
   * the edge of a cube as large as the average cell. Cell arrays are averaged to the points. The
   * active scalars, vectors and tensors are resampled, and the named arrays (separated by
   * semicolons). Outside all cells, scalars have the value of the border, and other arrays are
   * 0. The data are copied. Returns false and reports an error if they have no cells, volume or
   * arrays. A vtkVolumeHapticsFilter does this automatically for data on its port 0.
   */
  bool OpenDataSet(vtkDataObject* data, double spacing = 0.0, const char* arrayNames = nullptr);
#ifndef __VTK_WRAP__
  /** Open a data set like the function above, but return the error as a text. */
  bool OpenDataSet(vtkDataObject* data, double spacing, const std::vector<std::string>& arrays,
    std::string& error);
#endif

#ifndef __VTK_WRAP__
  /**
   * Set the settings of the filter on which the output depends;
   * vtkVolumeHapticsFilter::ConfigureSource calls this.
   */
  void SetFeltAs(int kernelRadius, bool areLabels);
  /** Get the planner of the regions, which the filter configures. */
  VolumeHaptics::RegionPlanner& GetPlanner();
#endif

  /** Get whether a region that Follow has ordered is still being read. */
  bool IsWaiting();

  /**
   * Get whether the output contains samples of the volume; false for samples of the CoarseImage, or
   * zeros.
   */
  bool HasSamples();

  /**
   * Get a text on the work that the source waits for and on why the last read failed; empty if
   * there is neither.
   */
  std::string GetStatusText();

protected:
  vtkHapticRegionSource();
  ~vtkHapticRegionSource() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
#ifndef __VTK_WRAP__
  bool Open(const char* fileName, bool mayBeWhole, int series, std::string& error);
  std::string CheckSettings();
  /**
   * Updates the store to the settings. Returns false, with the fault, if the settings are
   * incomplete.
   */
  bool Prepare(std::string& error);
  /**
   * Sets the coarse level in the store. Returns false, with the fault, if the image does not fit
   * the volume.
   */
  bool UpdateCoarse(std::string& error);

  /** Adds read values to an image, as its arrays. */
  bool PutSamples(vtkDataArray* samples, vtkImageData* image, std::string& error);
  void PutArrays(vtkDataArray* samples, vtkImageData* image);
  /** Returns the number of values per sample: its components. */
  int CountValues() const;

  Reader Function;
  std::shared_ptr<VolumeHaptics::DataSetSampler> Sampler; ///< used after OpenDataSet()
  std::string OpenedName;                                 ///< file that was opened last; empty
                                                          ///< without one
  std::string FileNotes;
  std::vector<std::string> Series; ///< volumes of the file; empty if there is one
  int SeriesNumber = 0;
  vtkTypeInt64 ChunkSize[3] = { 0, 0, 0 }; ///< samples per chunk in the opened file; zeros without
                                           ///< chunks
  std::unique_ptr<VolumeHaptics::RegionStore> Store;
  const void* Leader = nullptr; ///< device that TakeLead() has accepted
#endif

  int WholeExtent[6] = { 0, -1, 0, -1, 0, -1 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Spacing[3] = { 1.0, 1.0, 1.0 };
  double Direction[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  int ScalarType = 4;
  char* FileName = nullptr;
  vtkTypeInt64 HeaderSize = 0;
  int ByteOrder = LITTLE;
  vtkTypeInt64 MemoryLimit = 67108864;
  double MaximumSpeed = 0.5;
  bool IsAwaited = true;
  vtkSmartPointer<vtkImageData> CoarseImage;
  int KernelRadius = 2;   // last value of SetFeltAs
  bool AreLabels = false; // last value of SetFeltAs
  int Version = 0;        // incremented when the samples change

  vtkHapticRegionSource(const vtkHapticRegionSource&) = delete;
  void operator=(const vtkHapticRegionSource&) = delete;
};

#ifndef __VTK_WRAP__
///@{
/**
 * Calls SetReader for Python's ctypes. On failure, `read` returns 0 and writes the reason as a text
 * of at most `room` bytes. Nothing waits for it to end, because it may need Python's lock, which
 * the waiting thread holds. Follow therefore invokes vtkCommand::UserEvent while a region is read,
 * so that an observer can release this lock for a while, which VTK's event loop does not do.
 * `release` is called after the last call of `read`. A null `read` ends the reading. Both functions
 * get `context`.
 */
using vtkHapticRegionRead = int (*)(
  void* context, const int* extent, void* samples, char* why, int room);
using vtkHapticRegionRelease = void (*)(void* context);
extern "C" VTKVOLUMEHAPTICS_EXPORT void vtkHapticRegionSourceSetReader(
  vtkObjectBase* source, vtkHapticRegionRead read, vtkHapticRegionRelease release, void* context);
///@}
#endif

#endif
