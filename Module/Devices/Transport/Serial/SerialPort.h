// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A serial port through termios, open for one program alone, and the ports of USB boards.
 */
#ifndef SerialPort_h
#define SerialPort_h

#include <cstddef>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** A port of a USB board. */
struct SerialPortInfo
{
  std::string Path; ///< the port's node, such as /dev/ttyACM0
  /// the board's name with its serial number, as udev gives it; empty if it is not known
  std::string Name;
};

class SerialPort
{
public:
  /** The folder in which udev names the boards. */
  static constexpr const char* NamesFolder = "/dev/serial/by-id";

  SerialPort() = default;
  ~SerialPort() { this->Close(); }
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /** Lists the boards with a word in their names, in the order of the names. */
  static std::vector<SerialPortInfo> List(
    const std::string& word, const std::string& folder = NamesFolder);
  /** Returns the name of a port's board, given the port's node or a link to it. */
  static std::string NameOf(const std::string& path, const std::string& folder = NamesFolder);
  /** Returns "available", "in use", or the obstacle and its cure. */
  static std::string StateOf(const std::string& path);

  /**
   * Opens the port: raw bytes, 8N1 at 115200 baud, without flow control, and for this holder alone.
   * If this fails, returns false and writes the reason and the cure to `error`.
   */
  bool Open(const std::string& path, std::string& error);
  void Close() noexcept;

  /**
   * Sends all bytes. Returns false if the port does not take them within a time (ms), or is gone.
   */
  bool Write(const char* bytes, std::size_t size, int time) noexcept;
  /**
   * Reads bytes, waiting at most a time (ms). Returns the number of bytes, 0 if none came, negative
   * if the port is gone.
   */
  int Read(char* bytes, std::size_t size, int time) noexcept;
  /** Drops the bytes that wait to be read. */
  void Drain() noexcept;

private:
  int Descriptor = -1;
};

} // namespace VolumeHaptics

#endif
