#include "gui/calibration/drift_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/calibration_records/worth_table.h"
#include "gui/plots/plot_picture.h"
#include "gui/theme/state_icon.h"

namespace vignole {

DriftPanel::DriftPanel(const Theme& theme, const Units& units, QWidget* parent)
    : Panel(parent), theme_(theme), units_(units) {
  words_ = makeLabel(16, 500, "t1", this, true);
  plot_ = new PlotPicture(theme, this);
  cameras_ = new QTableWidget(kCameraCount, 4, this);
  styleTable(*cameras_);
  cameras_->setSelectionMode(QAbstractItemView::NoSelection);
  cameras_->setIconSize({16, 16});
  cameras_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  cameras_->verticalHeader()->setMinimumSectionSize(24);
  cameras_->verticalHeader()->setDefaultSectionSize(24);
  cameras_->setFixedHeight(4 * 24 + 36);
  content()->addWidget(words_);
  content()->addWidget(plot_, 100);
  content()->addStretch(1);
  content()->addWidget(cameras_);
  connect(&theme_, &Theme::changed, this, &DriftPanel::fill);
  connect(&units_, &Units::changed, this, &DriftPanel::fill);
  retranslate();
}

void DriftPanel::retranslate() {
  setTitle(tr("Health"));
  setNote(tr("seams between the cameras on every rail"));
  plot_->setAccessibleName(tr("Shift of each camera, rail by rail"));
  cameras_->setAccessibleName(tr("Shift of each camera since its calibration"));
  cameras_->setHorizontalHeaderLabels({tr("Camera"), tr("Shift"), tr("U (k = 2)"), tr("Alarm above")});
  for (int c = 1; c < 4; ++c) cameras_->horizontalHeaderItem(c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  fill();
}

void DriftPanel::show(std::shared_ptr<const DriftTrack> track) {
  if (track == track_) return;
  track_ = std::move(track);
  fill();
}

QString DriftPanel::words() const { return words_->text(); }

void DriftPanel::fill() {
  const bool learning = !track_ || track_->latest.learning;
  if (!track_) {
    words_->setText(
        tr("No rail has passed yet. Camera drift shows in the seams of normal production, without a "
           "plate."));
  } else if (learning) {
    words_->setText(tr("Learning what the seams are like: %1 of %2 rails since this calibration came into use.")
                        .arg(track_->latest.rails)
                        .arg(track_->baselineRails));
  } else if (track_->latest.alarm()) {
    for (const CameraDrift& camera : track_->latest.cameras)
      if (camera.alarm) words_->setText(QString::fromStdString(camera.words));
  } else {
    words_->setText(tr("No camera has moved: %n rail(s) watched.", nullptr, static_cast<int>(track_->latest.rails)));
  }
  const Palette& p = theme_.palette();
  for (int c = 0; c < kCameraCount; ++c) {
    const CameraDrift* drift = learning ? nullptr : &track_->latest.cameras[static_cast<std::size_t>(c)];
    const auto put = [&](int column, const QString& text, bool right) {
      auto* item = new QTableWidgetItem(text);
      item->setTextAlignment((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      cameras_->setItem(c, column, item);
      return item;
    };
    const bool alarm = drift != nullptr && drift->alarm;
    put(0, alarm ? tr("%1 moved").arg(c + 1) : QString::number(c + 1), false)
        ->setIcon(stateIcon(drift == nullptr ? StateSymbol::NoLimit
                            : alarm          ? StateSymbol::Out
                                             : StateSymbol::Good,
                            p));
    const auto length = [&](double mm) { return lengthText(mm, units_) + QLatin1Char(' ') + units_.name(); };
    put(1, drift ? length(drift->valueMm) : QStringLiteral("–"), true);
    put(2, drift ? length(2 * drift->uMm) : QStringLiteral("–"), true);
    put(3, drift ? length(drift->limitMm) : QStringLiteral("–"), true);
  }
  Plot plot{"", tr("rail").toStdString(), (tr("shift in ") + units_.name()).toStdString(), {}, false, false, {}, false};
  if (!learning) {
    for (int c = 0; c < kCameraCount; ++c)
      plot.curves.push_back({tr("camera %1").arg(c + 1).toStdString(), {}, c, true, 2});
    plot.curves.push_back({tr("alarm above").toStdString(), {}, 6, true, 1.5});
    double number = static_cast<double>(track_->latest.rails) - static_cast<double>(track_->rails.size());
    for (const DriftTrack::Rail& rail : track_->rails) {
      number += 1;
      for (std::size_t c = 0; c < rail.valueMm.size(); ++c)
        plot.curves[c].points.emplace_back(number, units_.shown(rail.valueMm[c]));
      plot.curves.back().points.emplace_back(number,
                                             units_.shown(*std::min_element(rail.limitMm.begin(), rail.limitMm.end())));
    }
  }
  plot_->setVisible(!learning);
  plot_->show(std::move(plot));
}

}  // namespace vignole
