// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Record/MovieFile.h"

#include "vtkNew.h"
#include "vtkOggTheoraWriter.h"

#include <vtksys/FStream.hxx>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace Explore
{
namespace
{
/// Pictures that wait for the thread; a second of them.
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

private:
  void Run()
  {
    bool isOpen = false;
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
      }
      for (int i = 0; i < count; ++i)
      {
        this->Writer->Write();
      }
    }
    if (isOpen)
    {
      this->Writer->End();
    }
  }

  vtkNew<vtkOggTheoraWriter> Writer; // after the constructor, of the thread alone
  std::mutex Mutex;
  std::condition_variable Changed;
  std::deque<std::pair<vtkSmartPointer<vtkImageData>, int>> Waiting;
  bool Ends = false;
  std::thread Thread;
};
} // namespace

bool MovieFile::IsAvailable()
{
  return true;
}

std::unique_ptr<MovieFile> MovieFile::Open(const std::string& file, std::string& error)
{
  vtksys::ofstream stream(file.c_str(), std::ios::binary);
  if (!stream)
  {
    error = "it can't be written";
    return nullptr;
  }
  stream.close();
  return std::make_unique<TheoraFile>(file);
}
} // namespace Explore
