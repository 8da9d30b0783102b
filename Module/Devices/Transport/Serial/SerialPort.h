// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A serial port that only one program can open, and the list of ports of USB boards.
 */
#ifndef SerialPort_h
#define SerialPort_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** A port of a USB board. */
struct SerialPortInfo
{
  std::string Path; ///< node of the port, such as /dev/ttyACM0 or COM3
  /// Name of the board, including its serial number, as reported by the system; empty if unknown.
  std::string Name;
};

class SerialPort
{
public:
#if defined(_WIN32)
  using Handle = std::intptr_t;
  static constexpr const char* NamesFolder = "the Device Manager";
  static constexpr const char* Example = "COM3";
#else
  using Handle = int;
  /** Folder with udev's links, which are named after the boards. */
  static constexpr const char* NamesFolder = "/dev/serial/by-id";
  static constexpr const char* Example = "/dev/ttyACM0";
#endif

  SerialPort() = default;
  ~SerialPort()
  {
    this->Close();
  }
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /** Returns whether a nonempty text may be the path of a port. */
  static bool IsPath(const std::string& path);
  /** Returns whether a port with this path exists. */
  static bool IsThere(const std::string& path);
  /** Lists the boards whose names contain a word, sorted by name. */
  static std::vector<SerialPortInfo> List(
    const std::string& word, const std::string& folder = NamesFolder);
  /** Returns the name of the board at a port. `path` is the port's node or a link to it. */
  static std::string NameOf(const std::string& path, const std::string& folder = NamesFolder);
  /** Returns "available", "in use", or the obstacle and its cure. */
  static std::string StateOf(const std::string& path);

  /**
   * Opens the port exclusively: raw bytes, 8N1 at 115200 baud, without flow control. On failure,
   * returns false and writes the reason and the cure to `error`.
   */
  bool Open(const std::string& path, std::string& error);
  void Close() noexcept;

  /**
   * Sends all bytes. Returns false if the port does not accept them within `time` (ms) or is gone.
   */
  bool Write(const char* bytes, std::size_t size, int time) noexcept;
  /**
   * Reads bytes. Waits at most `time` (ms). Returns the number of bytes: 0 if none arrived, or a
   * negative number if the port is gone.
   */
  int Read(char* bytes, std::size_t size, int time) noexcept;
  /** Discards all bytes that are waiting to be read. */
  void Drain() noexcept;

private:
  static constexpr Handle Closed = -1;

  Handle Descriptor = Closed;
};

} // namespace VolumeHaptics

#endif
