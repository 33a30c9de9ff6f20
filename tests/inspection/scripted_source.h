#pragma once
// Sources and stage work for tests: what each camera delivers is written down, and every picture carries its camera and
// trigger, so that a mix-up anywhere shows in the numbers that come out.

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/inspection/pipeline.h"

namespace vignole::testing {

inline Frame frame(int camera, std::uint64_t trigger) {
  auto pixels = std::make_shared<std::array<std::uint8_t, 9>>();
  std::memcpy(pixels->data(), &trigger, sizeof trigger);
  (*pixels)[8] = static_cast<std::uint8_t>(camera);
  Frame f;
  f.camera = camera;
  f.trigger = trigger;
  f.image = {pixels->data(), 9, 1, 9};
  f.lease = pixels;
  return f;
}

inline RailBegin rail(std::uint64_t firstTrigger, double spacingMm = 15) {
  RailBegin begin;
  begin.id = "rail at " + std::to_string(firstTrigger);
  begin.firstTrigger = firstTrigger;
  begin.spacingMm = spacingMm;
  return begin;
}

using Script = std::vector<FrameMessage>;
using Scripts = std::array<Script, 4>;

/// A whole rail of one camera.
inline void appendRail(Script& script, int camera, std::uint64_t first, std::uint64_t end) {
  script.emplace_back(rail(first));
  for (std::uint64_t t = first; t < end; ++t) script.emplace_back(frame(camera, t));
  script.emplace_back(RailEnd{end});
}

inline Scripts wholeRail(std::uint64_t first, std::uint64_t end) {
  Scripts scripts;
  for (int c = 0; c < 4; ++c) appendRail(scripts[static_cast<std::size_t>(c)], c, first, end);
  return scripts;
}

/// After its script a camera ends, or, if endless, waits for the stop.
class ScriptedSource : public FrameSource {
 public:
  explicit ScriptedSource(Scripts scripts) : scripts_(std::move(scripts)) {}
  bool isLive = false;
  bool endless = false;
  /// Called before each message is given out, on the camera's thread; a test may wait here.
  std::function<void(int camera, std::size_t step)> before;

  FrameMessage next(int camera, std::stop_token stop) override {
    const auto c = static_cast<std::size_t>(camera);
    if (stop.stop_requested()) return SourceEnd{};
    const std::size_t step = steps_[c]++;
    if (before) before(camera, step);
    if (step < scripts_[c].size()) return scripts_[c][step];
    if (endless) {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, stop, [] { return false; });
    }
    return SourceEnd{};
  }
  bool live() const override { return isLive; }

 private:
  Scripts scripts_;
  std::array<std::size_t, 4> steps_{};
  std::mutex mutex_;
  std::condition_variable_any wake_;
};

/// A door that stays open once opened.
class Gate {
 public:
  void open() {
    {
      const std::scoped_lock lock(mutex_);
      open_ = true;
    }
    changed_.notify_all();
  }
  void pass() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return open_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
};

/// Each camera contributes one point at (trigger, camera) as read from its picture; RH is the sum of the points' x.
inline PipelineWork simpleWork() {
  PipelineWork work;
  work.extract = [](int, const ImageView& image, StripeResult& result) {
    std::uint64_t trigger = 0;
    std::memcpy(&trigger, image.data, sizeof trigger);
    StripePoint point;
    point.x = static_cast<float>(trigger);
    point.y = image.data[8];
    result.points.assign(1, point);
    result.lines.assign(1, {0, 1, Rejection::None});
  };
  work.translate = [](int camera, std::uint64_t, const StripeResult& stripe, PartialContour& result) {
    result.points.clear();
    result.lineEnds.clear();
    result.missing.clear();
    for (const StripePoint& p : stripe.points) {
      ProfilePoint point;
      point.x = static_cast<double>(p.x);
      point.y = static_cast<double>(p.y);
      point.camera = static_cast<std::uint8_t>(camera);
      result.points.push_back(point);
    }
    result.lineEnds.push_back(static_cast<std::uint32_t>(result.points.size()));
  };
  work.measure = [](const RailBegin&, const Profile& profile, Registration& registration, Measurement& measurement) {
    registration.valid = true;
    double sum = 0;
    for (const ProfilePoint& p : profile.points) sum += p.x;
    measurement.dimensions[index(Dimension::RH)].valueMm = sum;
  };
  return work;
}

/// Everything the observer was told, in words.
struct Told {
  std::vector<std::string> events;  ///< "begin ID", "profile T", "end ID", "ended ERROR"
  std::vector<std::uint64_t> triggers;
  std::vector<double> positionsMm, values;
  std::vector<Profile> profiles;
  std::vector<TriggerLedger> ledgers;  ///< of each rail
  std::string error;
  bool ended = false;

  InspectionObserver observer() {
    InspectionObserver o;
    o.railBegan = [this](const RailBegin& r) { events.push_back("begin " + r.id); };
    o.profileMeasured = [this](const ProfileResult& p) {
      events.push_back("profile " + std::to_string(p.profile.trigger));
      triggers.push_back(p.profile.trigger);
      positionsMm.push_back(p.profile.positionMm);
      values.push_back(p.measurement.dimensions[index(Dimension::RH)].valueMm.value_or(-1));
      profiles.push_back(p.profile);
    };
    o.railEnded = [this](const RailBegin& r, const TriggerLedger& ledger) {
      events.push_back("end " + r.id);
      ledgers.push_back(ledger);
    };
    o.ended = [this](const std::string& e) {
      events.push_back("ended " + e);
      error = e;
      ended = true;
    };
    return o;
  }
};

}  // namespace vignole::testing
