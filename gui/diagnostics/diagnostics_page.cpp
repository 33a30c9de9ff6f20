#include "gui/diagnostics/diagnostics_page.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSaveFile>
#include <QStorageInfo>
#include <QSysInfo>
#include <QTableWidget>
#include <QThread>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/archive/archive_url.h"
#include "engine/recipe/recipe.h"
#include "gui/diagnostics/pipeline_panel.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "report/engine_words.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {

constexpr double kLoopLimitMs = 50;

QIcon symbolIcon(StateSymbol symbol, const Palette& palette) {
  QPixmap pixmap(40, 40);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintSymbol(painter, QRectF(2, 2, 36, 36), symbol, palette);
  return pixmap;
}

void fill(QTableWidget& table, int row, int column, const QString& text, bool right = false) {
  QTableWidgetItem* item = table.item(row, column);
  if (item == nullptr) {
    item = new QTableWidgetItem;
    table.setItem(row, column, item);
    item->setTextAlignment((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (item->text() != text) item->setText(text);
}

void mark(QTableWidget& table, int row, StateSymbol symbol, const Palette& palette) {
  if (QTableWidgetItem* item = table.item(row, 0)) item->setIcon(symbolIcon(symbol, palette));
}

QTableWidget* makeTable(int columns, QWidget* parent) {
  auto* table = new QTableWidget(0, columns, parent);
  styleTable(*table);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setIconSize({18, 18});
  return table;
}

QString gigabytes(double bytes) { return QString::number(bytes / 1e9, 'f', 1); }

std::filesystem::path folderOf(const Workplace& place) {
  if (place.archive != nullptr)
    if (const auto url = parseArchiveUrl(place.archive->url()); url && !url->file.empty())
      return std::filesystem::absolute(url->file).parent_path();
  return std::filesystem::current_path();
}

}  // namespace

DiagnosticsPage::DiagnosticsPage(Workplace& place, const EventLoopWatchdog& watchdog, QWidget* parent)
    : Page(parent), place_(place), watchdog_(watchdog) {
  setObjectName(QStringLiteral("page"));
  pipelinePanel_ = new Panel(this);
  ledgerPanel_ = new Panel(this);
  cameraPanel_ = new Panel(this);
  computerPanel_ = new Panel(this);
  pipeline_ = new PipelinePanel(place.theme, pipelinePanel_);
  pipelinePanel_->content()->addWidget(pipeline_, 1);
  support_ = makeButton(place.theme, QStringLiteral("export"), pipelinePanel_);
  pipelinePanel_->head()->addWidget(support_);
  connect(support_, &QPushButton::clicked, this, &DiagnosticsPage::saveSupport);
  ledger_ = makeTable(2, ledgerPanel_);
  ledger_->horizontalHeader()->hide();
  ledgerPanel_->content()->addWidget(ledger_);
  cameras_ = makeTable(4, cameraPanel_);
  cameras_->setRowCount(kCameraCount);
  cameraPanel_->content()->addWidget(cameras_, 1);
  cameraNote_ = makeLabel(15, 400, "t2", cameraPanel_, true);
  cameraPanel_->content()->addWidget(cameraNote_);
  computer_ = makeTable(3, computerPanel_);
  computer_->horizontalHeader()->hide();
  computerPanel_->content()->addWidget(computer_);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(16, 16, 16, 16);
  grid->setSpacing(16);
  grid->addWidget(pipelinePanel_, 0, 0, 1, 3);
  grid->addWidget(ledgerPanel_, 1, 0);
  grid->addWidget(cameraPanel_, 1, 1);
  grid->addWidget(computerPanel_, 1, 2);
  grid->setRowStretch(0, 3);
  grid->setRowStretch(1, 2);
  for (int column = 0; column < 3; ++column) grid->setColumnStretch(column, 1);
  before_ = processUse();
  setFocusPolicy(Qt::ClickFocus);
  retranslate();
}

void DiagnosticsPage::retranslate() {
  pipelinePanel_->setTitle(tr("Pipeline"));
  ledgerPanel_->setTitle(tr("Every trigger accounted for"));
  ledgerPanel_->setNote(tr("since the line was started"));
  cameraPanel_->setTitle(tr("Cameras"));
  computerPanel_->setTitle(tr("Computer"));
  support_->setText(tr("Support file…"));
  support_->setAccessibleName(tr("Save a support file"));
  ledger_->setAccessibleName(tr("Where every trigger went"));
  cameras_->setAccessibleName(tr("Counters of the cameras"));
  computer_->setAccessibleName(tr("Load of the computer"));
  cameras_->setHorizontalHeaderLabels({tr("Camera"), tr("Frames/s"), tr("Frames"), tr("Missing")});
  for (int column = 1; column < 4; ++column)
    cameras_->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

void DiagnosticsPage::showLine(const LineSnapshot& line, PullDetail detail) {
  if (detail != PullDetail::Everything) return;
  last_ = line;
  pipeline_->show(line);
  pipelinePanel_->setNote(line.held() ? tr("held, %1 old").arg(age(line.ageS))
                                      : tr("%1 profiles/s of %2 expected")
                                            .arg(locale().toString(line.profilesPerS, 'f', 1),
                                                 locale().toString(line.expectedPerS, 'f', 1)));
  showLedger(line);
  showCameras(line);
  showComputer();
}

void DiagnosticsPage::showLedger(const LineSnapshot& line) {
  const Palette& p = place_.theme.palette();
  const TriggerLedger& t = line.triggers;
  struct Entry {
    QString word;
    std::uint64_t count;
    StateSymbol symbol;
  };
  std::vector<Entry> rows = {{tr("Triggers"), t.seen, StateSymbol::NoLimit},
                             {tr("Measured"), t.measured, StateSymbol::Good},
                             {tr("Incomplete: measured by fewer cameras"), t.incomplete,
                              t.incomplete > 0 ? StateSymbol::Near : StateSymbol::Good},
                             {tr("Lost"), t.lost, t.lost > 0 ? StateSymbol::Out : StateSymbol::Good}};
  // What is in the pipeline at this moment is under way, not unaccounted for.
  const std::uint64_t known = t.measured + t.incomplete + t.lost;
  const bool resting = !place_.line.running();
  rows.push_back({resting ? tr("Not accounted for") : tr("Under way"), t.seen > known ? t.seen - known : 0,
                  resting && t.seen != known ? StateSymbol::Out : StateSymbol::Good});
  for (const auto& [reason, n] : t.reasons)
    rows.push_back({QStringLiteral("    ") + QString::fromStdString(reason), n, StateSymbol::Near});
  if (ledger_->rowCount() != static_cast<int>(rows.size())) ledger_->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const Entry& row = rows[static_cast<std::size_t>(i)];
    fill(*ledger_, i, 0, row.word);
    fill(*ledger_, i, 1, count(row.count), true);
    mark(*ledger_, i, row.symbol, p);
  }
  ledger_->setColumnWidth(0, ledger_->viewport()->width() * 3 / 4);
}

void DiagnosticsPage::showCameras(const LineSnapshot& line) {
  const Palette& p = place_.theme.palette();
  const double now = processUse().wallS;
  const bool due = now - framesSince_ > 1;
  for (int c = 0; c < kCameraCount; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const std::string stage = "acquire." + std::to_string(c + 1), camera = "camera " + std::to_string(c + 1);
    std::uint64_t frames = 0, missing = 0;
    for (const StageStatistics& s : line.stages)
      if (s.name == stage) frames = s.count;
    for (const auto& [reason, n] : line.triggers.reasons)
      if (reason.find(camera) != std::string::npos) missing += n;
    if (due) {
      framesPerS_[i] = framesSince_ > 0 && frames >= framesBefore_[i]
                           ? static_cast<double>(frames - framesBefore_[i]) / (now - framesSince_)
                           : 0;
      framesBefore_[i] = frames;
    }
    bool lost = false;
    for (const LostCamera& l : line.lostCameras) lost = lost || l.camera == c;
    fill(*cameras_, c, 0, tr("Camera %1").arg(c + 1) + (lost ? tr(": lost") : QString()));
    fill(*cameras_, c, 1, locale().toString(framesPerS_[i], 'f', 1), true);
    fill(*cameras_, c, 2, count(frames), true);
    fill(*cameras_, c, 3, count(missing), true);
    mark(*cameras_, c, lost ? StateSymbol::NotMeasured : missing > 0 ? StateSymbol::Near : StateSymbol::Good, p);
  }
  if (due) framesSince_ = now;
  cameras_->setColumnWidth(0, cameras_->viewport()->width() * 40 / 100);
  cameraNote_->setText(line.simulation ? tr("Rendered cameras: no packets to be sent again, no temperature.")
                                       : QString());
}

void DiagnosticsPage::showComputer() {
  const Palette& p = place_.theme.palette();
  const ProcessUse now = processUse();
  if (const double wall = now.wallS - before_.wallS; wall > 1) {
    cpuShare_ = (now.processCpuS - before_.processCpuS) / wall;
    windowShare_ = (now.threadCpuS - before_.threadCpuS) / wall;
    before_ = now;
  }
  struct Entry {
    QString name, value, note;
    StateSymbol symbol;
  };
  std::vector<Entry> rows;
  const std::filesystem::path folder = folderOf(place_);
  const QStorageInfo disk(QString::fromStdString(folder.string()));
  const double share =
      disk.bytesTotal() > 0 ? static_cast<double>(disk.bytesAvailable()) / static_cast<double>(disk.bytesTotal()) : 1;
  rows.push_back({tr("Disk"),
                  tr("%1 of %2 GB free")
                      .arg(gigabytes(static_cast<double>(disk.bytesAvailable())),
                           gigabytes(static_cast<double>(disk.bytesTotal()))),
                  share < 0.05 ? tr("make room: nearly full") : disk.rootPath(),
                  share < 0.02   ? StateSymbol::Out
                  : share < 0.05 ? StateSymbol::Near
                                 : StateSymbol::Good});
  if (place_.archive != nullptr)
    rows.push_back({tr("Archive"), tr("open"), QString::fromStdString(place_.archive->url()), StateSymbol::Good});
  else
    rows.push_back({tr("Archive"), tr("none: rails are not kept"), inWords(place_.archiveProblem), StateSymbol::Near});
  const int cores = QThread::idealThreadCount();
  rows.push_back({tr("Processor"), tr("%1 % of one core").arg(qRound(100 * cpuShare_)),
                  tr("%n core(s)", nullptr, cores), cpuShare_ > 0.9 * cores ? StateSymbol::Near : StateSymbol::Good});
  rows.push_back({tr("Memory"), tr("%1 MB").arg(qRound(now.rssMb)), {}, StateSymbol::Good});
  const double p99 = watchdog_.quantileMs(0.99);
  rows.push_back(
      {tr("Window"), tr("turn p99 %1 ms").arg(locale().toString(p99, 'f', 1)),
       tr("p50 %1, largest %2, limit 50 ms")
           .arg(locale().toString(watchdog_.quantileMs(0.5), 'f', 1), locale().toString(watchdog_.maxMs(), 'f', 0)),
       p99 > kLoopLimitMs ? StateSymbol::Near : StateSymbol::Good});
  rows.push_back({tr("Screen"), tr("%1 % of one core").arg(qRound(100 * windowShare_)), tr("the window's thread"),
                  StateSymbol::Good});
  if (computer_->rowCount() != static_cast<int>(rows.size())) computer_->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const Entry& row = rows[static_cast<std::size_t>(i)];
    fill(*computer_, i, 0, row.name);
    fill(*computer_, i, 1, row.value);
    fill(*computer_, i, 2, row.note);
    computer_->item(i, 2)->setToolTip(row.note);
    mark(*computer_, i, row.symbol, p);
  }
  computer_->setColumnWidth(0, computer_->viewport()->width() * 26 / 100);
  computer_->setColumnWidth(1, computer_->viewport()->width() * 37 / 100);
}

QByteArray DiagnosticsPage::supportText() const {
  using Json = nlohmann::json;
  Json stages = Json::array(), reasons = Json::object(), lost = Json::array();
  for (const StageStatistics& s : last_.stages)
    stages.push_back({{"name", s.name},
                      {"count", s.count},
                      {"mean_ms", s.meanMs},
                      {"sd_ms", s.sdMs},
                      {"ucl99_ms", s.ucl99Ms},
                      {"max_ms", s.maxMs},
                      {"queue_high_water", s.queueHighWater},
                      {"queue_capacity", s.queueCapacity},
                      {"overflows", s.overflows}});
  for (const auto& [reason, n] : last_.triggers.reasons) reasons[reason] = n;
  for (const LostCamera& l : last_.lostCameras) lost.push_back({{"camera", l.camera + 1}, {"reason", l.reason}});
  const ProcessUse use = processUse();
  const Json document = {
      {"program", "vignole"},
      {"version", QCoreApplication::applicationVersion().toStdString()},
      {"written", QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()},
      {"system", QSysInfo::prettyProductName().toStdString()},
      {"simulation", last_.simulation},
      {"error", last_.error},
      {"recipe", last_.recipe != nullptr ? last_.recipe->name : std::string()},
      {"calibration", last_.calibrationMethod},
      {"profiles_per_s", last_.profilesPerS},
      {"stages", std::move(stages)},
      {"triggers",
       {{"seen", last_.triggers.seen},
        {"measured", last_.triggers.measured},
        {"incomplete", last_.triggers.incomplete},
        {"lost", last_.triggers.lost},
        {"reasons", std::move(reasons)}}},
      {"lost_cameras", std::move(lost)},
      {"event_loop_ms",
       {{"p50", watchdog_.quantileMs(0.5)}, {"p99", watchdog_.quantileMs(0.99)}, {"max", watchdog_.maxMs()}}},
      {"archive", place_.archive != nullptr ? place_.archive->url() : place_.archiveProblem},
      {"rss_mb", use.rssMb}};
  return QByteArray::fromStdString(document.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

void DiagnosticsPage::saveSupport() {
  const QString name =
      QFileDialog::getSaveFileName(this, tr("Save a support file"), QStringLiteral("vignole-support.json"));
  if (name.isEmpty()) return;
  QSaveFile file(name);
  if (!file.open(QIODevice::WriteOnly) || file.write(supportText()) < 0 || !file.commit())
    pipelinePanel_->setNote(tr("%1 cannot be written: %2").arg(name, file.errorString()));
}

void DiagnosticsPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace vignole
