#include "gui/diagnostics/diagnostics_page.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QSysInfo>
#include <QTableWidget>
#include <QThread>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/database/archive_url.h"
#include "engine/recipe/recipe.h"
#include "gui/diagnostics/pipeline_panel.h"
#include "gui/diagnostics/support_bundle.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "gui/theme/state_icon.h"
#include "report/engine_words.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {

constexpr double kLoopLimitMs = 50, kHotC = 85;
constexpr int kSupportNotePx = 420;
constexpr int kRoomyPx = 760, kLowPanelPx = 246, kLowRowPx = 27;

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
  if (QTableWidgetItem* item = table.item(row, 0)) item->setIcon(stateIcon(symbol, palette));
}

QTableWidget* makeTable(int columns, QWidget* parent) {
  auto* table = new QTableWidget(0, columns, parent);
  styleTable(*table);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setIconSize({18, 18});
  return table;
}

QString gigabytes(double bytes) { return QString::number(bytes / 1e9, 'f', 1); }

/// The archive's file; empty if there is none, or none on this computer.
std::filesystem::path archiveFileOf(const Workplace& place) {
  if (place.archive != nullptr)
    if (const auto url = parseArchiveUrl(place.archiveUrl); url && !url->file.empty())
      return std::filesystem::absolute(url->file);
  return {};
}

std::filesystem::path folderOf(const Workplace& place) {
  const std::filesystem::path file = archiveFileOf(place);
  return file.empty() ? std::filesystem::current_path() : file.parent_path();
}

constexpr int kShareRole = Qt::UserRole + 1;

/// How much of what there is: a bar in a cell.
class ShareDelegate : public QStyledItemDelegate {
 public:
  ShareDelegate(const Theme& theme, QObject* parent) : QStyledItemDelegate(parent), theme_(theme) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const QVariant share = index.data(kShareRole);
    if (!share.isValid()) return;
    const Palette& p = theme_.palette();
    const QRectF bar(option.rect.left() + 6, option.rect.center().y() - 5, option.rect.width() - 12, 11);
    painter->fillRect(bar, p.chan);
    const double full = std::clamp(share.toDouble(), 0.0, 1.0);
    painter->fillRect(QRectF(bar.topLeft(), QSizeF(bar.width() * full, bar.height())), p.t3);
  }

 private:
  const Theme& theme_;
};

/// One picture of every camera as PNG, taken while the bundle waits; nothing if no frame comes.
struct BundlePictures {
  std::shared_ptr<LatestFrames> frames;
  std::optional<FramesWatcher> watcher;
  std::array<LatestFrames::Held, kCameraCount> taken;

  void take(const std::stop_token& stop) {
    watcher.emplace(frames);
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    while (!stop.stop_requested() && std::chrono::steady_clock::now() < until) {
      taken = frames->together();
      if (std::all_of(taken.begin(), taken.end(), [](const auto& held) { return held != nullptr; })) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    watcher.reset();
  }
};

QByteArray png(const LatestFrames::Held& held) {
  QByteArray bytes;
  if (!held) return bytes;
  const ImageView& image = held->frame.image;
  const QImage pixels(image.data, image.width, image.height, image.stride, QImage::Format_Grayscale8);
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  pixels.save(&buffer, "PNG");
  return bytes;
}

}  // namespace

DiagnosticsPage::DiagnosticsPage(Workplace& place, const EventLoopWatchdog& watchdog, QWidget* parent)
    : Page(parent), place_(place), watchdog_(watchdog), computerWatch_(folderOf(place), archiveFileOf(place)) {
  setObjectName(QStringLiteral("page"));
  pipelinePanel_ = new Panel(this);
  ledgerPanel_ = new Panel(this);
  cameraPanel_ = new Panel(this);
  computerPanel_ = new Panel(this);
  pipeline_ = new PipelinePanel(place.theme, pipelinePanel_);
  pipelinePanel_->content()->addWidget(pipeline_, 1);
  support_ = makeButton(place.theme, QStringLiteral("export"), pipelinePanel_);
  supportNote_ = makeLabel(15, 400, "t2", pipelinePanel_);
  progress_ = new QProgressBar(pipelinePanel_);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(180);
  progress_->hide();
  pipelinePanel_->head()->addWidget(supportNote_);
  pipelinePanel_->head()->addWidget(progress_);
  pipelinePanel_->head()->addWidget(support_);
  bundle_ = new SupportBundle(this);
  connect(support_, &QPushButton::clicked, this, &DiagnosticsPage::supportPressed);
  connect(bundle_, &SupportBundle::progressed, this, [this](int done, int of) {
    progress_->setRange(0, of);
    progress_->setValue(done);
  });
  connect(bundle_, &SupportBundle::finished, this, [this](const QString& problem) {
    supportSaid_ = problem.isEmpty() ? tr("%1 is written.").arg(QDir(supportFolder_).dirName()) : problem;
    // Beside the button there is room for some words; the tip tells them all.
    supportNote_->setText(supportNote_->fontMetrics().elidedText(supportSaid_, Qt::ElideMiddle, kSupportNotePx));
    supportNote_->setToolTip(problem.isEmpty() ? supportFolder_ : problem);
    showSupport();
  });
  ledger_ = makeTable(2, ledgerPanel_);
  ledger_->horizontalHeader()->hide();
  ledgerPanel_->content()->addWidget(ledger_);
  cameras_ = makeTable(5, cameraPanel_);
  cameras_->setRowCount(kCameraCount);
  cameras_->horizontalHeader()->setMinimumSectionSize(48);
  cameras_->horizontalHeader()->setStretchLastSection(false);
  cameras_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  cameraPanel_->content()->addWidget(cameras_, 1);
  cameraNote_ = makeLabel(15, 400, "t2", cameraPanel_, true);
  cameraPanel_->content()->addWidget(cameraNote_);
  computer_ = makeTable(4, computerPanel_);
  computer_->horizontalHeader()->hide();
  computer_->horizontalHeader()->setMinimumSectionSize(32);
  computer_->verticalHeader()->setDefaultSectionSize(36);
  computer_->setItemDelegateForColumn(2, new ShareDelegate(place.theme, computer_));
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
  progress_->setAccessibleName(tr("How much of the support bundle is written"));
  showSupport();
  ledger_->setAccessibleName(tr("Where every trigger went"));
  cameras_->setAccessibleName(tr("Counters of the cameras"));
  computer_->setAccessibleName(tr("Load of the computer"));
  cameras_->setHorizontalHeaderLabels({tr("Camera"), tr("Frames/s"), tr("Frames"), tr("Missing"), tr("Exposure")});
  for (int column = 1; column < 5; ++column)
    cameras_->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

void DiagnosticsPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  before_ = processUse();
  pictures_ = 0;
  computerWatch_.setLooking(true);
}

void DiagnosticsPage::hideEvent(QHideEvent* event) {
  Page::hideEvent(event);
  computerWatch_.setLooking(false);
}

void DiagnosticsPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  // On low screens the picture keeps its height, the tables give.
  const bool low = height() < kRoomyPx;
  auto* grid = static_cast<QGridLayout*>(layout());
  grid->setRowStretch(0, low ? 1 : 3);
  grid->setRowStretch(1, low ? 0 : 2);
  for (Panel* panel : {ledgerPanel_, cameraPanel_, computerPanel_}) {
    panel->setMinimumHeight(low ? kLowPanelPx : 0);
    panel->setMaximumHeight(low ? kLowPanelPx : QWIDGETSIZE_MAX);
  }
  for (QTableWidget* table : {ledger_, cameras_, computer_}) {
    table->verticalHeader()->setMinimumSectionSize(kLowRowPx);
    table->verticalHeader()->setDefaultSectionSize(low ? kLowRowPx : table == computer_ ? 36 : 40);
    table->setFont(uiFont(low ? 14 : table == computer_ ? 15 : 16));
  }
}

void DiagnosticsPage::showLine(const LineSnapshot& line, PullDetail detail) {
  ++pictures_;
  if (detail != PullDetail::Everything) return;
  last_ = line;
  pipeline_->show(line);
  pipelinePanel_->setNote(line.held() ? tr("held, %1 old").arg(age(line.ageS))
                                      : tr("%1 profiles/s of %2 expected")
                                            .arg(locale().toString(line.profilesPerS, 'f', 1),
                                                 locale().toString(line.expectedPerS, 'f', 1)));
  showLedger(line);
  showCameras(line);
  showShares();
  showConsumers();
  showComputer();
}

void DiagnosticsPage::showShares() {
  const ProcessUse now = processUse();
  const double wall = now.wallS - before_.wallS;
  if (wall <= 1) return;
  cpuShare_ = (now.processCpuS - before_.processCpuS) / wall;
  windowShare_ = (now.threadCpuS - before_.threadCpuS) / wall;
  picturesPerS_ = pictures_ / wall;
  pictures_ = 0;
  before_ = now;
}

void DiagnosticsPage::showConsumers() {
  std::vector<Consumer> consumers;
  Consumer archive;
  archive.name = tr("Archive");
  if (place_.writer != nullptr) {
    const RailWriterStatus status = place_.writer->status();
    archive.queued = status.queued;
    archive.highWater = status.queueHighWater;
    archive.capacity = status.queueCapacity;
    archive.out = !status.failure.empty() || status.profilesLost > 0;
    archive.near = status.pointsDropped > 0;
    archive.note = !status.failure.empty()    ? QString::fromStdString(status.failure)
                   : status.profilesLost > 0  ? tr("%1 profiles lost").arg(count(status.profilesLost))
                   : status.pointsDropped > 0 ? tr("%1 without points").arg(count(status.pointsDropped))
                                              : tr("%1 profiles kept").arg(count(status.profilesStored));
  } else {
    archive.near = true;
    archive.note = tr("rails are not kept");
  }
  consumers.push_back(archive);
  Consumer screen;
  screen.name = tr("Screen");
  screen.note = tr("%1 pictures/s, %2 % of a core").arg(qRound(picturesPerS_)).arg(qRound(100 * windowShare_));
  screen.near = watchdog_.quantileMs(0.99) > kLoopLimitMs;
  consumers.push_back(screen);
  pipeline_->setConsumers(std::move(consumers));
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
  for (const auto& [reason, n] : t.reasons)
    rows.push_back({QStringLiteral("    ") + QString::fromStdString(reason), n, StateSymbol::Near});
  // Counted where frames come in, apart from the books: what has come in and is in no column yet is under way while the
  // line runs, and has been forgotten once it rests.
  std::uint64_t begun = t.seen;
  for (const StageStatistics& s : line.stages)
    if (s.name.starts_with("acquire")) begun = std::max(begun, s.count);
  const std::uint64_t known = t.measured + t.incomplete + t.lost;
  const bool resting = !place_.line.running();
  const std::uint64_t open = begun > known ? begun - known : 0;
  rows.front().count = begun;
  if (!resting) rows.push_back({tr("Under way"), open, StateSymbol::NoLimit});
  const std::uint64_t forgotten = resting ? open : t.seen > known ? t.seen - known : 0;
  rows.push_back({tr("Not accounted for"), forgotten, forgotten > 0 ? StateSymbol::Out : StateSymbol::Good});
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
    const std::optional<double> exposure = place_.line.exposureMs();
    fill(*cameras_, c, 4, exposure ? tr("%1 ms").arg(locale().toString(*exposure, 'f', 1)) : QStringLiteral("–"), true);
    mark(*cameras_, c, lost ? StateSymbol::NotMeasured : missing > 0 ? StateSymbol::Near : StateSymbol::Good, p);
  }
  if (due) framesSince_ = now;
  constexpr std::array<int, 5> kWidths = {0, 19, 14, 15, 19};  // percent; the names take what is left
  for (int column = 1; column < 5; ++column)
    cameras_->setColumnWidth(column, cameras_->viewport()->width() * kWidths[static_cast<std::size_t>(column)] / 100);
  cameraNote_->setText(line.simulation ? tr("Not available here, because these cameras are rendered: resends, "
                                            "incomplete frames, timeouts, temperature.")
                                       : QString());
}

void DiagnosticsPage::showComputer() {
  const Palette& p = place_.theme.palette();
  if (auto fresh = computerWatch_.takeNew()) computerState_ = std::move(fresh);
  struct Entry {
    QString name, value, note;
    StateSymbol symbol = StateSymbol::Good;
    std::optional<double> share = {};
  };
  const auto number = [this](double value, int decimals) { return locale().toString(value, 'f', decimals); };
  const ComputerState computer = computerState_ ? *computerState_ : ComputerState{};
  std::vector<Entry> rows;
  if (computer.diskBytes > 0) {
    const double full = 1 - static_cast<double>(computer.diskFreeBytes) / static_cast<double>(computer.diskBytes);
    rows.push_back({tr("Disk"),
                    tr("%1 of %2 GB")
                        .arg(gigabytes(static_cast<double>(computer.diskBytes - computer.diskFreeBytes)),
                             gigabytes(static_cast<double>(computer.diskBytes))),
                    full > 0.95 ? tr("make room: nearly full") : QString::fromStdString(computer.disk),
                    full > 0.98   ? StateSymbol::Out
                    : full > 0.95 ? StateSymbol::Near
                                  : StateSymbol::Good,
                    full});
  } else {
    rows.push_back({tr("Disk"), QStringLiteral("–"), tr("not told"), StateSymbol::NoLimit});
  }
  if (place_.writer != nullptr) {
    const RailWriterStatus status = place_.writer->status();
    rows.push_back({tr("Archive"), tr("%n rail(s) kept", nullptr, static_cast<int>(status.railsStored)),
                    status.failure.empty() ? tr("%1 MB, WAL %2 MB")
                                                 .arg(number(static_cast<double>(computer.archiveBytes) / 1e6, 1),
                                                      number(static_cast<double>(computer.walBytes) / 1e6, 1))
                                           : inWords(status.failure),
                    status.failure.empty() ? StateSymbol::Good : StateSymbol::Out,
                    status.queueCapacity > 0
                        ? std::optional(static_cast<double>(status.queued) / static_cast<double>(status.queueCapacity))
                        : std::nullopt});
  } else if (place_.archive != nullptr) {
    rows.push_back({tr("Archive"), tr("open, nothing is written"), QString::fromStdString(place_.archive->url()),
                    StateSymbol::Near});
  } else {
    rows.push_back({tr("Archive"), tr("rails are not kept"), inWords(place_.archiveProblem), StateSymbol::Near});
  }
  const int cores = QThread::idealThreadCount();
  rows.push_back({tr("Processor"), tr("%1 % of one core").arg(qRound(100 * cpuShare_)),
                  tr("%n core(s)", nullptr, cores), cpuShare_ > 0.9 * cores ? StateSymbol::Near : StateSymbol::Good,
                  cpuShare_ / cores});
  const double rssMb = processUse().rssMb;
  rows.push_back({tr("Memory"), tr("%1 MB").arg(qRound(rssMb)),
                  computer.memoryMb > 0 ? tr("of %1 GB").arg(number(computer.memoryMb / 1024, 1)) : QString(),
                  StateSymbol::Good, computer.memoryMb > 0 ? std::optional(rssMb / computer.memoryMb) : std::nullopt});
  const double p99 = watchdog_.quantileMs(0.99);
  rows.push_back({tr("Window"), tr("p99 %1 ms").arg(number(p99, 1)),
                  tr("p50 %1, max %2").arg(number(watchdog_.quantileMs(0.5), 1), number(watchdog_.maxMs(), 0)),
                  p99 > kLoopLimitMs ? StateSymbol::Near : StateSymbol::Good, p99 / kLoopLimitMs});
  rows.push_back({tr("Screen"), tr("%1 % of one core").arg(qRound(100 * windowShare_)), tr("window"), StateSymbol::Good,
                  windowShare_});
  if (computer.temperatureC)
    rows.push_back(
        {tr("Temperature"), tr("%1 °C").arg(number(*computer.temperatureC, 1)), QString::fromStdString(computer.sensor),
         *computer.temperatureC > kHotC ? StateSymbol::Near : StateSymbol::Good, *computer.temperatureC / 100});
  else
    rows.push_back({tr("Temperature"), QStringLiteral("–"), tr("not told"), StateSymbol::NoLimit});
  if (computer_->rowCount() != static_cast<int>(rows.size())) computer_->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const Entry& row = rows[static_cast<std::size_t>(i)];
    fill(*computer_, i, 0, row.name);
    fill(*computer_, i, 1, row.value);
    fill(*computer_, i, 2, QString());
    fill(*computer_, i, 3, row.note);
    const QVariant share = row.share ? QVariant(*row.share) : QVariant();
    if (computer_->item(i, 2)->data(kShareRole) != share) computer_->item(i, 2)->setData(kShareRole, share);
    computer_->item(i, 3)->setToolTip(row.note);
    mark(*computer_, i, row.symbol, p);
  }
  const int width = computer_->viewport()->width();
  computer_->setColumnWidth(0, width * 31 / 100);
  computer_->setColumnWidth(1, width * 33 / 100);
  computer_->setColumnWidth(2, width * 11 / 100);
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

void DiagnosticsPage::supportPressed() {
  if (bundle_->running()) {
    bundle_->cancel();
    return;
  }
  const QString parent = QFileDialog::getExistingDirectory(this, tr("Where the support bundle is put"));
  if (!parent.isEmpty()) saveSupport(parent);
}

void DiagnosticsPage::showSupport() {
  const bool running = bundle_->running();
  progress_->setVisible(running);
  support_->setText(running ? tr("Cancel") : tr("Support bundle…"));
  support_->setAccessibleName(running ? tr("Cancel the support bundle") : tr("Save a support bundle"));
}

QString DiagnosticsPage::note() const { return supportSaid_; }

bool DiagnosticsPage::saveSupport(const QString& parent) {
  const auto kept = [](std::string text) {
    return [text = std::move(text)](const std::stop_token&) -> Expected<QByteArray> {
      return QByteArray::fromStdString(text);
    };
  };
  std::vector<SupportFile> files = {{QStringLiteral("state.json"), kept(supportText().toStdString())}};
  if (last_.recipe != nullptr) files.push_back({QStringLiteral("recipe.toml"), kept(toToml(*last_.recipe))});
  files.push_back({QStringLiteral("calibration.toml"),
                   [calibration = place_.line.calibration()](const std::stop_token&) -> Expected<QByteArray> {
                     return QByteArray::fromStdString(toToml(calibration));
                   }});
  if (auto frames = place_.line.frames(); frames && place_.line.running()) {
    auto pictures = std::make_shared<BundlePictures>();
    pictures->frames = std::move(frames);
    for (int c = 0; c < kCameraCount; ++c)
      files.push_back({QStringLiteral("camera%1.png").arg(c + 1),
                       [pictures, c](const std::stop_token& stop) -> Expected<QByteArray> {
                         if (c == 0) pictures->take(stop);
                         return png(pictures->taken[static_cast<std::size_t>(c)]);
                       }});
  }
  const QString name =
      QStringLiteral("vignole-support-") + QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
  const QString folder = QDir(parent).filePath(name);
  if (!bundle_->start(folder, std::move(files))) return false;
  supportFolder_ = folder;
  supportSaid_.clear();
  supportNote_->clear();
  showSupport();
  return true;
}

void DiagnosticsPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace vignole
