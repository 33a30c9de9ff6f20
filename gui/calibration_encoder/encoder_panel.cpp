#include "gui/calibration_encoder/encoder_panel.h"

#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <cmath>

#include "engine/simulator/virtual_encoder.h"
#include "gui/plots/plot_picture.h"
#include "gui/theme/panel.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {
constexpr int kReadings = 21;
constexpr double kSlipU = 3;  ///< standard uncertainties beyond which slip is told

QTableWidget* makeTable(int columns, QWidget* parent) {
  auto* table = new QTableWidget(0, columns, parent);
  styleTable(*table);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table->verticalHeader()->setDefaultSectionSize(30);
  return table;
}
}  // namespace

EncoderPanel::EncoderPanel(Workplace& place, QWidget* parent) : QWidget(parent), place_(place) {
  panel_ = new Panel(this);
  panel_->setMinimumWidth(320);
  words_ = makeLabel(16, 400, "t1", panel_, true);
  lengthWord_ = makeLabel(15, 400, "t2", panel_, true);
  uncertaintyWord_ = makeLabel(15, 400, "t2", panel_, true);
  slipWord_ = makeLabel(15, 400, "t2", panel_, true);
  const auto spin = [this](double low, double high, double value, int decimals, const QString& suffix) {
    auto* box = new QDoubleSpinBox(panel_);
    box->setRange(low, high);
    box->setDecimals(decimals);
    box->setValue(value);
    box->setSuffix(suffix);
    box->setFont(uiFont(16));
    box->setMinimumHeight(44);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    return box;
  };
  length_ = spin(10, 100000, 2000, 2, QStringLiteral(" mm"));
  uncertainty_ = spin(0, 100, 0.05, 3, QStringLiteral(" mm"));
  slip_ = spin(-20000, 20000, 0, 0, QStringLiteral(" ppm"));
  drive_ = makeButton(place.theme, QStringLiteral("play"), panel_, true);
  file_ = makeButton(place.theme, QStringLiteral("import"), panel_);
  stopLine_ = makeButton(place.theme, QStringLiteral("pause"), panel_, true);
  leave_ = makeButton(place.theme, QStringLiteral("back"), panel_);
  for (QWidget* w : std::initializer_list<QWidget*>{words_, lengthWord_, length_, uncertaintyWord_, uncertainty_,
                                                    slipWord_, slip_, drive_, stopLine_, file_})
    panel_->content()->addWidget(w);
  panel_->content()->addStretch(1);
  panel_->content()->addWidget(leave_);
  resultPanel_ = new Panel(this);
  sentence_ = makeLabel(18, 500, "t1", resultPanel_, true);
  figures_ = makeTable(3, resultPanel_);
  plot_ = new PlotPicture(place.theme, resultPanel_);
  resultPanel_->content()->addWidget(sentence_);
  resultPanel_->content()->addWidget(figures_, 2);
  resultPanel_->content()->addWidget(plot_, 3);
  readingPanel_ = new Panel(this);
  table_ = makeTable(4, readingPanel_);
  readingPanel_->content()->addWidget(table_, 1);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(12);
  row->addWidget(panel_, 3);
  row->addWidget(resultPanel_, 6);
  row->addWidget(readingPanel_, 4);
  connect(drive_, &QPushButton::clicked, this, &EncoderPanel::drive);
  connect(file_, &QPushButton::clicked, this, &EncoderPanel::readFile);
  connect(stopLine_, &QPushButton::clicked, this, [this] { place_.line.stop(); });
  connect(leave_, &QPushButton::clicked, this, &EncoderPanel::left);
  for (QDoubleSpinBox* box : {length_, uncertainty_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &EncoderPanel::calibrate);
  connect(&place_.units, &Units::changed, this, &EncoderPanel::showAll);
  retranslate();
}

void EncoderPanel::retranslate() {
  const auto name = [](QPushButton* button, const QString& text) {
    button->setText(text);
    button->setAccessibleName(text);
  };
  panel_->setTitle(tr("Encoder"));
  resultPanel_->setTitle(tr("Motion a pulse"));
  readingPanel_->setTitle(tr("Readings"));
  lengthWord_->setText(tr("Known length, first to last reading"));
  length_->setAccessibleName(tr("Known length, mm"));
  uncertaintyWord_->setText(tr("Its standard uncertainty"));
  uncertainty_->setAccessibleName(tr("Standard uncertainty of the length, mm"));
  slipWord_->setText(tr("Slip of the virtual second encoder, for training"));
  slip_->setAccessibleName(tr("Slip of the virtual second encoder, ppm"));
  name(drive_, tr("Drive the rail"));
  name(file_, tr("Readings from a file…"));
  name(leave_, tr("Leave"));
  name(stopLine_, tr("Stop the line"));
  figures_->setHorizontalHeaderLabels({tr("Quantity"), tr("Value"), tr("Standard uncertainty")});
  figures_->setAccessibleName(tr("Motion a pulse"));
  table_->setHorizontalHeaderLabels({tr("Count"), tr("Second"), tr("x mm"), tr("y mm")});
  table_->setAccessibleName(tr("Readings of the encoder"));
  plot_->setAccessibleName(tr("Slip along the way"));
  showAll();
}

void EncoderPanel::begin() {
  readings_.clear();
  result_.reset();
  problem_.clear();
  showAll();
}

void EncoderPanel::showLine(const LineSnapshot& line) {
  const bool runs = place_.line.running() || line.state == LineState::Measuring;
  if (runs == lineRuns_) return;
  lineRuns_ = runs;
  showAll();
}

void EncoderPanel::drive() {
  VirtualEncoderSettings settings;
  settings.slipPpm = slip_->value();
  settings.seed = place_.line.virtualRigSeed().value_or(0) + static_cast<std::uint64_t>(++drives_) * 1000;
  readings_.clear();
  for (const VirtualEncoderReading& r : driveVirtualRail(settings, length_->value(), kReadings))
    readings_.push_back({r.count, r.xMm, r.yMm, r.count2});
  calibrate();
}

void EncoderPanel::readFile() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Readings: count,x_mm,y_mm[,count2]"), {},
                                                    tr("CSV (*.csv);;All files (*)"));
  if (file.isEmpty()) return;
  auto readings = loadEncoderReadings(file.toStdString());
  readings_.clear();
  if (readings) {
    readings_ = *std::move(readings);
    calibrate();
    return;
  }
  result_.reset();
  problem_ = QString::fromStdString(readings.error().message());
  showAll();
}

void EncoderPanel::calibrate() {
  result_.reset();
  problem_.clear();
  if (!readings_.empty()) {
    EncoderSettings settings;
    settings.lengthMm = length_->value();
    settings.uLengthMm = uncertainty_->value();
    const auto result = calibrateEncoder(readings_, settings);
    if (result)
      result_ = *result;
    else
      problem_ = QString::fromStdString(result.error().message());
  }
  showAll();
}

void EncoderPanel::showAll() {
  const bool rig = place_.line.virtualRigSeed().has_value();
  words_->setText(lineRuns_ ? tr("Closed while the line measures: the rail is driven by hand over a known length. Stop "
                                 "the line to go on.")
                            : tr("A rail is driven over a length that is known, and the pulses are counted: where the "
                                 "light crosses it, it is seen as well."));
  drive_->setVisible(!lineRuns_ && rig);
  slip_->setVisible(rig);
  slipWord_->setVisible(rig);
  file_->setVisible(!lineRuns_);
  stopLine_->setVisible(lineRuns_);
  figures_->setRowCount(0);
  const auto add = [this](const QString& what, const QString& value, const QString& u) {
    const int row = figures_->rowCount();
    figures_->insertRow(row);
    const QString cells[] = {what, value, u};
    for (int c = 0; c < 3; ++c) figures_->setItem(row, c, new QTableWidgetItem(cells[c]));
  };
  Plot plot{"",   tr("reading").toStdString(), tr("second behind first, pulses").toStdString(), {}, false, false, {},
            false};
  if (!problem_.isEmpty()) {
    sentence_->setText(problem_);
  } else if (!result_) {
    sentence_->setText(tr("Next: drive the rail over the known length."));
  } else {
    const EncoderCalibration& c = *result_;
    const auto motion = [&](const QString& what, const PerPulse& v) {
      add(what, numberText(v.mm * 1000, 4) + tr(" µm a pulse"),
          v.uMm ? numberText(*v.uMm * 1000, 4) + tr(" µm") : tr("unknown: fewer than three readings"));
    };
    motion(tr("Along (V z)"), c.vz);
    motion(tr("Sideways (V x)"), c.vx);
    motion(tr("Upwards (V y)"), c.vy);
    add(tr("Pulses"), numberText(c.counts, 0), {});
    bool slips = false;
    if (c.slip) {
      slips = std::abs(c.slip->ppm) > kSlipU * c.slip->uPpm;
      add(tr("Slip of the second"), numberText(c.slip->ppm, 0) + QStringLiteral(" ppm"),
          numberText(c.slip->uPpm, 0) + QStringLiteral(" ppm"));
      Curve curve{"", {}, 5, true, 2};
      for (std::size_t i = 0; i < readings_.size(); ++i)
        if (readings_[i].count2)
          curve.points.emplace_back(static_cast<double>(i + 1),
                                    (readings_[i].count - readings_.front().count) * c.slip->ratio -
                                        (*readings_[i].count2 - *readings_.front().count2));
      plot.curves.push_back(std::move(curve));
    }
    sentence_->setText(slips ? tr("One of the encoders slips. Next: clean the wheels, press them on and drive again.")
                             : tr("One pulse is %1 µm of rail. Next: enter it where the encoder's pulses are divided "
                                  "into triggers.")
                                   .arg(numberText(c.vz.mm * 1000, 4)));
  }
  plot_->setVisible(!plot.curves.empty());
  plot_->show(std::move(plot));
  table_->setRowCount(static_cast<int>(readings_.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const EncoderReading& r = readings_[static_cast<std::size_t>(row)];
    const QString cells[] = {numberText(r.count, 0), r.count2 ? numberText(*r.count2, 0) : QStringLiteral("–"),
                             numberText(r.xMm, 3), numberText(r.yMm, 3)};
    for (int column = 0; column < 4; ++column) table_->setItem(row, column, new QTableWidgetItem(cells[column]));
  }
}

}  // namespace vignole
