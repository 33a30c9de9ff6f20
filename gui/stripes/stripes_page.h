#pragma once
// Stripes, the technician's page: what the four cameras see and the lines that are extracted, live or frozen; exposure
// and the five parameters of the extraction in use and on trial, side by side, before anything is applied.

#include <array>
#include <memory>

#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"
#include "gui/stripes/stripe_watch.h"

namespace vignole {

class ArchiveReader;
class StripeView;
class TrialPanel;

class StripesPage : public Page {
  Q_OBJECT

 public:
  explicit StripesPage(Workplace& place, QWidget* parent = nullptr);
  ~StripesPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  void setFrozen(bool frozen);
  void choose(int camera);
  /// The pictures behind a profile of the running line: those still held, or made again where the line can.
  void showBehind(const ProfileResult& profile);
  [[nodiscard]] bool frozen() const { return frozen_; }
  [[nodiscard]] int chosen() const { return chosen_; }
  [[nodiscard]] StripeView& view(int camera) { return *views_[static_cast<std::size_t>(camera)]; }
  [[nodiscard]] TrialPanel& trial() { return *trial_; }
  /// In a worker's thread; what it says of the file comes into the panel's message.
  void savePicture(const QString& file);
  /// As it is when it has made itself small.
  [[nodiscard]] QSize minimumSizeHint() const override { return {1160, 600}; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void bindKeys();
  void watch(const LineSnapshot& line);
  void showStates(const LineSnapshot& line);
  void showRates(const LineSnapshot& line);
  void followSettings(const LineSnapshot& line);
  void startTrial();
  void discard();
  void apply();
  void use(const StripeSettings& stripe, std::optional<double> exposureMs);
  void save();
  void say();  ///< what the page has to say when nothing has just happened

  Workplace& place_;
  std::unique_ptr<StripeWatch> watch_;
  std::unique_ptr<ArchiveReader> archive_;
  StripeSettings inUse_;
  std::optional<double> exposureMs_;
  std::optional<StripeSettings> waiting_;
  std::shared_ptr<const ProfileResult> latest_;
  bool frozen_ = false;
  int chosen_ = 0;
  std::uint64_t changes_ = 0;
  std::array<std::uint64_t, kCameraCount> framesBefore_{};
  std::chrono::steady_clock::time_point framesAt_{};
  std::array<QString, kCameraCount> missing_;  ///< of the profile whose pictures are shown
  std::array<StripeView*, kCameraCount> views_{};
  TrialPanel* trial_;
  std::jthread writing_;
};

}  // namespace vignole
