#pragma once
// What if: the rails that were found, judged against other limits, before a recipe is approved.

#include <QDialog>
#include <vector>

#include "engine/archive/rejudgement.h"
#include "gui/bridge/archive_reader.h"
#include "gui/bridge/workplace.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace vignole {

class WhatIfDialog : public QDialog {
  Q_OBJECT

 public:
  static constexpr std::size_t kFewRails = 20;  ///< fewer prove little, and it says so

  /// Place and reader outlive it.
  WhatIfDialog(Workplace& place, ArchiveReader& reader, QWidget* parent = nullptr);
  /// Rails of the recipe's section; its limits stand in the fields at first.
  void setRails(const Recipe& recipe, std::vector<RailLine> rails);
  void start();  ///< judges them with the limits in the fields
  void stop();
  [[nodiscard]] bool running() const { return running_; }
  [[nodiscard]] const std::vector<RejudgedRail>& judged() const { return judged_; }
  [[nodiscard]] std::size_t changed() const;
  [[nodiscard]] QString summary() const;

 signals:
  void finished();

 protected:
  void changeEvent(QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void retranslate();
  void fillFromClass();
  void fillFields(const PerDimension<ToleranceLimits>& limits);
  void askNext(PerDimension<ToleranceLimits> limits);
  void take(const std::vector<Expected<RejudgedRail>>& rails);
  void showResult();
  [[nodiscard]] std::optional<PerDimension<ToleranceLimits>> limitsEntered();

  Workplace& place_;
  ArchiveReader& reader_;
  Recipe recipe_;
  std::vector<RailLine> rails_;
  std::vector<RejudgedRail> judged_;
  std::size_t next_ = 0, refused_ = 0;
  std::string refusal_;
  std::uint64_t run_ = 0;
  bool running_ = false;
  QLabel *intro_, *profileLabel_, *straightnessLabel_, *lowerHead_, *upperHead_, *result_, *detail_;
  QComboBox *profileClass_, *straightnessClass_;
  PerDimension<QLabel*> names_{};
  PerDimension<QLineEdit*> lower_{}, upper_{};
  QProgressBar* progress_;
  QTableWidget* table_;
  QPushButton *try_, *close_;
};

}  // namespace vignole
