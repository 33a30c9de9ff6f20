#include "cli/simulated_files.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <thread>

#include "engine/files/atomic_file.h"

namespace vignole::cli {

namespace {

Expected<void> writePicture(const PictureJob& job) {
  cv::Mat picture(job.heightPx, job.widthPx, CV_8UC1);
  job.render({picture.data, job.widthPx, job.heightPx, static_cast<std::ptrdiff_t>(picture.step)});
  std::vector<unsigned char> png;
  try {
    if (!cv::imencode(".png", picture, png)) return worldError(job.file.string(), "cannot be encoded as PNG");
  } catch (const cv::Exception&) {
    return worldError(job.file.string(), "cannot be encoded as PNG");
  }
  return writeFile(job.file, {reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace

Expected<void> makeFolder(const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) return worldError(folder.string(), "cannot be made: " + problem.message());
  return {};
}

Expected<void> writePictures(const std::vector<PictureJob>& jobs, Progress& progress) {
  for (const PictureJob& job : jobs)
    if (auto made = makeFolder(job.file.parent_path()); !made) return made;
  std::vector<std::optional<Error>> problems(jobs.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::mutex mutex;
  std::size_t done = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size() && !failed; i = next++) {
      if (auto written = writePicture(jobs[i]); !written) {
        problems[i] = written.error();
        failed = true;
      }
      const std::lock_guard lock(mutex);
      ++done;
      progress.update(static_cast<double>(done) / static_cast<double>(jobs.size()));
    }
  };
  {
    std::vector<std::jthread> threads;
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    for (std::size_t t = 1; t < std::min(cores, jobs.size()); ++t) threads.emplace_back(work);
    work();
  }
  for (const auto& problem : problems)
    if (problem) return tl::unexpected<Error>(*problem);
  return {};
}

}  // namespace vignole::cli
