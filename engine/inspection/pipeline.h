#pragma once
// The fourteen elements of the paper's Fig. 2 as threads, joined by bounded queues, whatever their work is. Inspection
// puts the measurement in; tests put simple functions in.

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/inspection/inspection.h"
#include "engine/stripe/stripe.h"

namespace vignole {

/// What the stages do. Each function is called by the threads of its stage only; with different cameras at once.
struct PipelineWork {
  std::function<void(int camera, const ImageView& image, StripeResult& result)> extract;
  std::function<void(int camera, std::uint64_t trigger, const StripeResult& stripe, PartialContour& result)> translate;
  std::function<void(const RailBegin& rail, const Profile& profile, Registration& registration,
                     Measurement& measurement)>
      measure;
};

/// See Inspection, whose functions these are.
class Pipeline {
 public:
  Pipeline(FrameSource& source, PipelineWork work, InspectionObserver observer, InspectionSettings settings);
  ~Pipeline();
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  void start();
  void stop();
  void wait();
  [[nodiscard]] bool running() const;
  [[nodiscard]] std::vector<StageStatistics> stages() const;
  [[nodiscard]] TriggerLedger triggers() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
