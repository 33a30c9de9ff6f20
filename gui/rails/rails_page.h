#pragma once
// Rails: every rail that was measured, found, replayed along its length, reported and exported.

#include <memory>
#include <optional>
#include <vector>

#include "engine/archive/rail_archive.h"
#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"
#include "gui/rails/stored_profile.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QTimer;
class QVBoxLayout;

namespace vignole {

class ArchiveReader;
class NextRailDialog;
class Panel;
class RailBand;
class ReplayCanvas;
class StripChart;
class WhatIfDialog;

class RailsPage : public Page {
  Q_OBJECT

 public:
  explicit RailsPage(Workplace& place, QWidget* parent = nullptr);
  ~RailsPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  void search();                    ///< what the filters say, anew
  void openRail(std::int64_t key);  ///< starts its replay at the head
  void goTo(double positionM);      ///< along the rail that is open
  void step(int profiles);          ///< from where it is
  void nextException(bool backwards);
  [[nodiscard]] const std::vector<RailLine>& found() const { return found_; }
  [[nodiscard]] const std::shared_ptr<const OpenedRail>& opened() const { return opened_; }
  [[nodiscard]] std::uint64_t profile() const { return number_; }
  [[nodiscard]] QLineEdit& searchField() const { return *text_; }

 signals:
  void liveAsked();
  void listChanged();     ///< an answer has come
  void profileChanged();  ///< an answer has come

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QWidget* makeList();
  QWidget* makeReplay();
  void bindKeys();
  void retranslate();
  [[nodiscard]] RailQuery query() const;
  [[nodiscard]] bool filtered() const;
  void clearFilters();
  void showWriter();
  void enterNextRail();
  void askWhatIf();
  void showFound(std::vector<RailLine> found, std::uint64_t all);
  void showOpened(std::shared_ptr<const OpenedRail> rail);
  void showProfile(const StoredProfile& profile);
  void showStrips();
  void askProfile();
  void play(bool on);
  void save(bool report);

  Workplace& place_;
  std::unique_ptr<ArchiveReader> reader_;
  std::vector<RailLine> found_;
  std::shared_ptr<const OpenedRail> opened_;
  std::uint64_t number_ = 0;
  std::optional<StoredProfile> shown_;
  std::vector<Dimension> stripDimensions_;
  std::uint64_t railsPassed_ = 0;
  std::size_t stripsShown_ = 2;  ///< low windows have room for two

  Panel *list_, *drawing_, *along_, *scrub_, *exceptions_;
  QLineEdit* text_;
  QComboBox *verdict_, *dimension_, *period_, *section_, *drawn_;
  QTableWidget *table_, *exceptionTable_;
  QLabel *empty_, *writer_, *band_, *positionLabel_, *valueNote_;
  QPushButton *whatIf_, *nextRail_, *clear_, *report_, *export_, *back_, *live_, *playButton_, *forward_, *before_;
  NextRailDialog* nextRailDialog_ = nullptr;  ///< made when it is first asked for
  WhatIfDialog* whatIfDialog_ = nullptr;      ///< the same
  ReplayCanvas* canvas_;
  RailBand* railBand_;
  std::array<StripChart*, 3> strips_;
  QVBoxLayout* replayColumn_;
  QTimer *typing_, *playing_;
};

}  // namespace vignole
