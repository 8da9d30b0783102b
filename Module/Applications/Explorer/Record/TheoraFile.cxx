// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Record/MovieFile.h"

#include "vtkNew.h"
#include "vtkOggTheoraWriter.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace Explore
{
namespace
{
/// Largest number of pictures that wait for the thread: one second of the movie.
constexpr std::size_t MOST_WAITING = MovieFile::RATE;

class TheoraFile : public MovieFile
{
public:
  explicit TheoraFile(const std::string& file)
  {
    this->Writer->SetFileName(file.c_str());
    this->Writer->SetRate(RATE);
    this->Writer->SetQuality(2);
    this->Thread = std::thread([this] { this->Run(); });
  }
  ~TheoraFile() override
  {
    this->TheoraFile::End();
    this->Thread.join();
  }
  TheoraFile(const TheoraFile&) = delete;
  TheoraFile& operator=(const TheoraFile&) = delete;

  bool Add(vtkImageData* picture, int count) override
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (this->Waiting.size() >= MOST_WAITING)
      {
        return false;
      }
      this->Waiting.emplace_back(picture, count);
    }
    this->Changed.notify_one();
    return true;
  }

  void End() override
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Ends = true;
    }
    this->Changed.notify_one();
  }

  State GetState() const override { return this->Reached; }

private:
  void Run()
  {
    bool isOpen = false;
    bool hasFailed = false;
    for (;;)
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Changed.wait(lock, [this] { return this->Ends || !this->Waiting.empty(); });
      if (this->Waiting.empty())
      {
        break;
      }
      const auto [picture, count] = std::move(this->Waiting.front());
      this->Waiting.pop_front();
      lock.unlock();
      this->Writer->SetInputData(picture);
      if (!std::exchange(isOpen, true))
      {
        this->Writer->Start();
        hasFailed = this->Writer->GetError() != 0;
      }
      for (int i = 0; i < count && !hasFailed; ++i)
      {
        this->Writer->Write();
        hasFailed = this->Writer->GetError() != 0;
      }
    }
    if (!isOpen)
    {
      RemoveIfEmpty(this->Writer->GetFileName());
      this->Reached = State::Empty;
      return;
    }
    this->Writer->End();
    // Check the file's size, because VTK's writer does not report a full disk.
    hasFailed = hasFailed || this->Writer->GetError() != 0 ||
      vtksys::SystemTools::FileLength(this->Writer->GetFileName()) == 0;
    this->Reached = hasFailed ? State::Failed : State::Written;
  }

  static void RemoveIfEmpty(const std::string& file)
  {
    if (vtksys::SystemTools::FileLength(file) == 0)
    {
      vtksys::SystemTools::RemoveFile(file);
    }
  }

  vtkNew<vtkOggTheoraWriter> Writer; // once the constructor has ended, used only by the thread
  std::mutex Mutex;
  std::condition_variable Changed;
  std::deque<std::pair<vtkSmartPointer<vtkImageData>, int>> Waiting;
  bool Ends = false;
  std::atomic<State> Reached{ State::Writing };
  std::thread Thread;
};
} // namespace

bool MovieFile::IsAvailable()
{
  return true;
}

std::unique_ptr<MovieFile> MovieFile::Open(const std::string& file, std::string& error)
{
  // Test by opening for appending, so that an existing file stays complete until the first picture.
  vtksys::ofstream stream(file.c_str(), std::ios::binary | std::ios::app);
  if (!stream)
  {
    error = "it can't be written";
    return nullptr;
  }
  stream.close();
  return std::make_unique<TheoraFile>(file);
}
} // namespace Explore
