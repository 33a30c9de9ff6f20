#pragma once
// Stripes, the technician's page: what the four cameras see and the lines that are extracted, live or frozen; the five
// parameters of the extraction in use and on trial, side by side, before anything is applied.

#include <array>
#include <memory>

#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"
#include "gui/stripes/stripe_watch.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace vignole {

class ArchiveReader;
class Panel;
class StripeView;

class StripesPage : public Page {
  Q_OBJECT

 public:
  explicit StripesPage(Workplace& place, QWidget* parent = nullptr);
  ~StripesPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  void setFrozen(bool frozen);
  void choose(int camera);
  [[nodiscard]] bool frozen() const { return frozen_; }
  [[nodiscard]] int chosen() const { return chosen_; }
  [[nodiscard]] StripeView& view(int camera) { return *views_[static_cast<std::size_t>(camera)]; }
  [[nodiscard]] StripeSettings onTrial() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QWidget* makeTrial();
  void bindKeys();
  void retranslate();
  [[nodiscard]] bool onTrialDiffers() const;
  void startTrial();
  void discard();
  void apply();
  void save();
  void compare();
  void showPermission();

  Workplace& place_;
  std::unique_ptr<StripeWatch> watch_;
  std::unique_ptr<ArchiveReader> archive_;
  StripeSettings inUse_;
  bool frozen_ = false;
  int chosen_ = 0;
  std::array<StripeView*, kCameraCount> views_{};
  Panel* trial_;
  std::array<QLabel*, 5> words_{}, used_{};
  std::array<QDoubleSpinBox*, 5> fields_{};
  QTableWidget* comparison_;
  QLineEdit* reason_;
  QLabel* result_;
  QPushButton *freeze_, *save_, *discard_, *apply_;
};

}  // namespace vignole
