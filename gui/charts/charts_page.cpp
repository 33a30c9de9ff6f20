#include "gui/charts/charts_page.h"

#include <QComboBox>
#include <QDateTime>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSaveFile>
#include <QShortcut>
#include <QTableWidget>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gui/bridge/archive_reader.h"
#include "gui/plots/histogram_plot.h"
#include "gui/plots/tolerance_plot.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "gui/theme/state_icon.h"
#include "report/dimension_text.h"
#include "report/engine_words.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

QString shown(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

ChartsPage::ChartsPage(Workplace& place, QWidget* parent)
    : Page(parent), place_(place), reader_(std::make_unique<ArchiveReader>(place.archive ? place.archiveUrl : "")) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  dimensionPanel_ = new Panel(this);
  dimensions_ = new QTableWidget(static_cast<int>(kDimensionCount), 2, dimensionPanel_);
  styleTable(*dimensions_);
  dimensions_->setIconSize({18, 18});
  dimensions_->horizontalHeader()->hide();
  dimensions_->verticalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  connect(dimensions_, &QTableWidget::itemSelectionChanged, this, [this] {
    if (const int row = dimensions_->currentRow(); row >= 0 && !dimensions_->selectedItems().isEmpty())
      choose(kDimensions[static_cast<std::size_t>(row)]);
  });
  dimensionPanel_->content()->addWidget(dimensions_, 1);
  dimensionPanel_->setMinimumWidth(216);  // a name and a value, whole

  chartPanel_ = new Panel(this);
  rail_ = new QComboBox(chartPanel_);
  rail_->setFont(uiFont(16));
  rail_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  rail_->setMinimumContentsLength(14);
  connect(rail_, &QComboBox::activated, this, [this](int row) {
    newest_ = row == 0;
    load(rail_->itemData(row).toLongLong());
  });
  fit_ = makeButton(place.theme, QStringLiteral("fit"), chartPanel_);
  export_ = makeButton(place.theme, QStringLiteral("export"), chartPanel_);
  for (QWidget* w : std::initializer_list<QWidget*>{rail_, fit_, export_}) chartPanel_->head()->addWidget(w);
  chart_ = new TolerancePlot(place.theme, chartPanel_);
  cursorText_ = makeLabel(16, 500, "t1", chartPanel_);
  empty_ = makeLabel(18, 400, "t2", chartPanel_, true);
  chartPanel_->content()->addWidget(empty_);
  chartPanel_->content()->addWidget(chart_, 1);
  chartPanel_->content()->addWidget(cursorText_);
  connect(fit_, &QPushButton::clicked, chart_, &TolerancePlot::fit);
  connect(export_, &QPushButton::clicked, this, &ChartsPage::save);
  connect(chart_, &TolerancePlot::cursorChanged, this, &ChartsPage::showCursor);

  railPanel_ = new Panel(this);
  perRail_ = new TolerancePlot(place.theme, railPanel_);
  railPanel_->content()->addWidget(perRail_, 1);
  histogramPanel_ = new Panel(this);
  histogram_ = new HistogramPlot(place.theme, histogramPanel_);
  histogramPanel_->content()->addWidget(histogram_, 1);
  figurePanel_ = new Panel(this);
  figures_ = new QTableWidget(0, 2, figurePanel_);
  styleTable(*figures_);
  figures_->horizontalHeader()->hide();
  figures_->setSelectionMode(QAbstractItemView::NoSelection);
  figures_->verticalHeader()->setDefaultSectionSize(28);
  figurePanel_->content()->addWidget(figures_, 1);
  figurePanel_->setMinimumWidth(320);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(16, 16, 16, 16);
  grid->setSpacing(16);
  grid->addWidget(dimensionPanel_, 0, 0, 2, 1);
  grid->addWidget(chartPanel_, 0, 1);
  grid->addWidget(railPanel_, 1, 1);
  grid->addWidget(histogramPanel_, 0, 2);
  grid->addWidget(figurePanel_, 1, 2);
  grid->setColumnStretch(0, 2);
  grid->setColumnStretch(1, 10);
  grid->setColumnStretch(2, 4);
  grid->setRowStretch(0, 5);
  grid->setRowStretch(1, 3);
  connect(&place_.theme, &Theme::changed, this, &ChartsPage::showDimensions);
  connect(&place_.units, &Units::changed, this, &ChartsPage::showAll);
  bindKeys();
  retranslate();
}

ChartsPage::~ChartsPage() { reader_.reset(); }

void ChartsPage::bindKeys() {
  const auto bind = [this](const QKeySequence& key, auto action) {
    auto* shortcut = new QShortcut(key, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, action);
  };
  bind(Qt::Key_Plus, [this] { chart_->zoom(0.5); });
  bind(Qt::Key_Equal, [this] { chart_->zoom(0.5); });
  bind(Qt::Key_Minus, [this] { chart_->zoom(2); });
  bind(Qt::Key_0, [this] { chart_->fit(); });
  bind(Qt::Key_Left, [this] { moveCursor(-1); });
  bind(Qt::Key_Right, [this] { moveCursor(1); });
  const auto metre = [this](int sign) {
    if (data_ && data_->rail.summary.lengthM > 0)
      moveCursor(sign * std::max(1, static_cast<int>(std::lround(static_cast<double>(data_->profiles.size()) /
                                                                 data_->rail.summary.lengthM))));
  };
  bind(QKeySequence(Qt::SHIFT | Qt::Key_Left), [metre] { metre(-1); });
  bind(QKeySequence(Qt::SHIFT | Qt::Key_Right), [metre] { metre(1); });
  bind(Qt::Key_Home, [this] { moveCursor(std::numeric_limits<int>::min() / 2); });
  bind(Qt::Key_End, [this] { moveCursor(std::numeric_limits<int>::max() / 2); });
  bind(QKeySequence(Qt::CTRL | Qt::Key_E), [this] { save(); });
}

void ChartsPage::retranslate() {
  dimensionPanel_->setTitle(tr("Dimensions"));
  dimensions_->setAccessibleName(tr("Dimension that is charted"));
  rail_->setAccessibleName(tr("Rail that is charted"));
  fit_->setText(tr("Fit"));
  fit_->setAccessibleName(tr("Whole range"));
  fit_->setToolTip(tr("Whole range (0)"));
  export_->setText(tr("Export…"));
  export_->setAccessibleName(tr("Export the chart as picture, PDF or CSV"));
  chart_->setAccessibleName(tr("Dimension along the rail"));
  perRail_->setAccessibleName(tr("Dimension rail by rail"));
  histogram_->setAccessibleName(tr("Histogram of the rail"));
  histogramPanel_->setTitle(tr("Histogram"));
  histogramPanel_->setNote(tr("same scale, this rail"));
  railPanel_->setTitle(tr("Per rail"));
  figurePanel_->setTitle(tr("Figures"));
  figurePanel_->setNote(tr("this rail"));
  figures_->setAccessibleName(tr("Figures of the rail"));
  showAll();
}

void ChartsPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void ChartsPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  load(newest_ || !data_ ? 0 : data_->rail.key);
}

void ChartsPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  auto* grid = static_cast<QGridLayout*>(layout());
  const bool low = height() < 760;
  const int gap = low || width() < 1600 ? 8 : 16;
  grid->setContentsMargins(gap, gap, gap, gap);
  grid->setSpacing(gap);
  grid->setRowStretch(1, low ? 4 : 3);
  layOutTables();
}

void ChartsPage::layOutTables() {
  dimensions_->setColumnWidth(0, dimensions_->viewport()->width() * 52 / 100);
  figures_->setColumnWidth(0, figures_->viewport()->width() * 64 / 100);
}

void ChartsPage::showLine(const LineSnapshot& line, PullDetail detail) {
  if (detail != PullDetail::Everything || line.railsPassed == railsPassed_) return;
  railsPassed_ = line.railsPassed;
  if (newest_) QTimer::singleShot(1500, this, [this] { load(0); });  // the writer needs a moment
}

void ChartsPage::load(std::int64_t key) {
  reader_->ask("load", [this, key](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
    if (archive == nullptr)
      return [this, problem] {
        problem_ =
            tr("Rails are not kept: %1. Start the program with an archive (--archive FILE).").arg(inWords(problem));
        showAll();
        emit dataChanged();
      };
    auto data = chartData(*archive, key);
    if (!data)
      return [this, error = data.error()] {
        problem_ = shown(error.message());
        showAll();
        emit dataChanged();
      };
    return [this, data = std::make_shared<const ChartData>(std::move(*data))] {
      problem_.clear();
      data_ = data;
      showAll();
      emit dataChanged();
    };
  });
}

void ChartsPage::choose(Dimension dimension) {
  if (dimension == dimension_) return;
  dimension_ = dimension;
  showAll();
}

void ChartsPage::showAll() {
  empty_->setVisible(!data_);
  empty_->setText(problem_.isEmpty() ? tr("No rail has been measured yet. Its chart appears here when it has passed.")
                                     : problem_);
  export_->setEnabled(data_ != nullptr);
  showDimensions();
  if (!data_) {
    chartPanel_->setTitle(spoken(dimension_));
    return;
  }
  const QSignalBlocker quiet(rail_);
  rail_->clear();
  rail_->addItem(tr("Newest rail"), 0LL);
  for (auto it = data_->recent.rbegin(); it != data_->recent.rend(); ++it)
    rail_->addItem(shown(it->summary.rail.id), static_cast<qlonglong>(it->key));
  rail_->setCurrentIndex(newest_ ? 0 : std::max(0, rail_->findData(static_cast<qlonglong>(data_->rail.key))));
  showChart();
  showPerRail();
  showFigures();
  showCursor();
}

void ChartsPage::showDimensions() {
  const Palette& p = place_.theme.palette();
  const QSignalBlocker quiet(dimensions_);
  for (int i = 0; i < static_cast<int>(kDimensionCount); ++i) {
    const Dimension d = kDimensions[static_cast<std::size_t>(i)];
    auto* name = new QTableWidgetItem(spoken(d));
    QString value = QStringLiteral("–");
    if (data_) {
      const DimensionSummary& s = data_->rail.summary.dimensions[index(d)];
      name->setIcon(stateIcon(symbolOf(s.verdict), p));
      name->setToolTip(wordOf(s.verdict));
      if (s.values.count() > 0)
        value = locale().toString(place_.units.shown(s.meanMm()), 'f', place_.units.decimals(decimalsOf(d)));
    }
    auto* number = new QTableWidgetItem(value);
    number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    dimensions_->setItem(i, 0, name);
    dimensions_->setItem(i, 1, number);
  }
  layOutTables();
  dimensions_->selectRow(static_cast<int>(index(dimension_)));
}

void ChartsPage::showChart() {
  const DimensionSummary& summary = data_->rail.summary.dimensions[index(dimension_)];
  const Units& units = place_.units;
  ToleranceSeries series;
  series.xLabel = tr("length, m");
  series.yLabel = QStringLiteral("%1, %2").arg(spoken(dimension_), units.name());
  for (const ProfileRecord& profile : data_->profiles) {
    const DimensionResult& r = profile.dimensions[index(dimension_)];
    series.x.append(profile.positionMm / 1000);
    series.y.append(r.valueMm ? units.shown(*r.valueMm) : kNone);
  }
  const ChartBand band = bandOf(*data_, dimension_);
  series.bandX = band.xM;
  for (const double v : band.low) series.bandLow.append(units.shown(v));
  for (const double v : band.high) series.bandHigh.append(units.shown(v));
  series.expected = units.shown(summary.nominalMm);
  if (summary.lowerMm) series.lower = units.shown(*summary.lowerMm);
  if (summary.upperMm) series.upper = units.shown(*summary.upperMm);
  chart_->show(series);
  chartPanel_->setTitle(tr("%1 along the rail").arg(spoken(dimension_)));
  QString note = tr("rail %1, %2 profiles").arg(shown(data_->rail.summary.rail.id), count(data_->profiles.size()));
  note += band.xM.isEmpty() ? tr("; no band: %1 of %2 other rails").arg(band.rails).arg(kBandRails)
                            : tr("; band: last %1 rails, 10 to 90 %").arg(kBandRails);
  chartPanel_->setNote(note);
  histogram_->show(series.y, chart_->yMin(), chart_->yMax(), series.lower, series.upper);
  histogramPanel_->setNote(
      tr("same scale, longest bar %1 %").arg(locale().toString(100 * histogram_->largestShare(), 'f', 1)));
}

void ChartsPage::showPerRail() {
  const Units& units = place_.units;
  ToleranceSeries series;
  series.dots = true;
  series.yLabel = units.name();
  series.xLabel = tr("rail");
  double at = 0;
  for (const StoredRail& rail : data_->recent) {
    const DimensionSummary& s = rail.summary.dimensions[index(dimension_)];
    at += 1;
    if (s.values.count() == 0) continue;
    series.x.append(at);
    series.y.append(units.shown(s.meanMm()));
    series.low.append(units.shown(s.values.min()));
    series.high.append(units.shown(s.values.max()));
    series.names.append(shown(rail.summary.rail.id));
  }
  const DimensionSummary& summary = data_->rail.summary.dimensions[index(dimension_)];
  series.expected = units.shown(summary.nominalMm);
  if (summary.lowerMm) series.lower = units.shown(*summary.lowerMm);
  if (summary.upperMm) series.upper = units.shown(*summary.upperMm);
  perRail_->show(series);
  perRail_->fit();
  railPanel_->setNote(tr("mean with smallest and largest value, last %n rail(s) of this section", nullptr,
                         static_cast<int>(data_->recent.size())));
}

void ChartsPage::showFigures() {
  const ChartFigures f = figuresOf(*data_, dimension_);
  const Units& units = place_.units;
  const int decimals = units.decimals(decimalsOf(dimension_));
  const auto length = [&](double mm) { return locale().toString(units.shown(mm), 'f', decimals); };
  const QString all = count(f.count + f.missing);
  std::vector<std::pair<QString, QString>> rows;
  if (f.count > 0)
    rows = {{tr("Mean"), length(f.mean)},
            {tr("Standard deviation"), length(f.sd)},
            {tr("Smallest"), length(f.smallest)},
            {tr("Largest"), length(f.largest)},
            {tr("Uncertainty U (k = 2)"), QStringLiteral("±") + length(2 * f.uMm)}};
  rows.emplace_back(tr("Beyond a limit"), tr("%1 of %2").arg(count(f.beyond), all));
  rows.emplace_back(tr("In the guard band"), tr("%1 of %2").arg(count(f.guard), all));
  rows.emplace_back(tr("Not measured"), tr("%1 of %2").arg(count(f.missing), all));
  if (f.roomMm) rows.emplace_back(tr("Room to the nearer limit"), length(*f.roomMm));
  figures_->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const auto& [word, value] = rows[static_cast<std::size_t>(i)];
    figures_->setItem(i, 0, new QTableWidgetItem(word));
    auto* number = new QTableWidgetItem(value);
    number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    figures_->setItem(i, 1, number);
  }
  layOutTables();
}

void ChartsPage::showCursor() {
  const auto at = chart_->cursor();
  if (!data_ || !at || *at >= static_cast<int>(data_->profiles.size())) {
    cursorText_->setText(
        tr("Move over the chart or press Left and Right to read values; wheel or + and − zoom, drag moves."));
    return;
  }
  const ProfileRecord& profile = data_->profiles[static_cast<std::size_t>(*at)];
  const DimensionResult& r = profile.dimensions[index(dimension_)];
  const QString place = tr("%1 m").arg(locale().toString(profile.positionMm / 1000, 'f', 3));
  if (!r.valueMm) {
    cursorText_->setText(place + QStringLiteral("   ") + tr("not measured: %1").arg(shown(r.reason)));
    return;
  }
  const Units& units = place_.units;
  const int decimals = units.decimals(decimalsOf(dimension_));
  const auto length = [&](double mm) { return locale().toString(units.shown(mm), 'f', decimals); };
  cursorText_->setText(tr("%1   %2 %3   U ±%4   %5 from expected   %6")
                           .arg(place, length(*r.valueMm), units.name(), length(2 * r.uMm),
                                length(*r.valueMm - r.nominalMm), wordOf(r.verdict)));
}

void ChartsPage::moveCursor(int values) {
  if (!data_ || data_->profiles.empty()) return;
  const auto last = static_cast<std::int64_t>(data_->profiles.size()) - 1;
  const std::int64_t from = chart_->cursor() ? *chart_->cursor() : (values > 0 ? -1 : last + 1);
  chart_->setCursor(static_cast<int>(std::clamp<std::int64_t>(from + values, 0, last)));
}

void ChartsPage::save() {
  if (!data_) return;
  const QString proposal =
      QStringLiteral("%1-%2.png").arg(shown(data_->rail.summary.rail.id), shown(std::string(name(dimension_))));
  const QString file = QFileDialog::getSaveFileName(this, tr("Export the chart"), proposal,
                                                    QStringLiteral("PNG (*.png);;PDF (*.pdf);;CSV (*.csv)"));
  if (file.isEmpty()) return;
  bool done = false;
  if (file.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive)) {
    QString text = QStringLiteral("position_m,value_mm,u_mm,verdict\n");
    for (const ProfileRecord& profile : data_->profiles) {
      const DimensionResult& r = profile.dimensions[index(dimension_)];
      text += QString::number(profile.positionMm / 1000, 'f', 6) + ',' +
              (r.valueMm ? QString::number(*r.valueMm, 'f', 6) + ',' + QString::number(r.uMm, 'f', 6)
                         : QStringLiteral(",")) +
              ',' + shown(std::string(name(r.verdict))) + '\n';
    }
    QSaveFile out(file);
    done = out.open(QIODevice::WriteOnly) && out.write(text.toUtf8()) >= 0 && out.commit();
  } else {
    done = chart_->save(file);
  }
  chartPanel_->setNote(done ? tr("%1 is written").arg(file) : tr("%1 cannot be written").arg(file));
}

}  // namespace vignole
