#include "gui/settings/audit_panel.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/bridge/archive_reader.h"
#include "gui/theme/inscription.h"

namespace vignole {

AuditPanel::AuditPanel(Workplace& place, ArchiveReader& reader, QWidget* parent)
    : Panel(parent), place_(place), reader_(reader) {
  words_ = makeLabel(16, 400, "t2", this, true);
  table_ = new QTableWidget(0, 5, this);
  styleTable(*table_);
  verify_ = makeButton(place.theme, QStringLiteral("approve"), this);
  head()->addWidget(verify_);
  result_ = makeLabel(15, 500, "t1", this, true);
  content()->addWidget(words_);
  content()->addWidget(table_, 100);
  content()->addWidget(result_);
  content()->addStretch(1);
  connect(verify_, &QPushButton::clicked, this, &AuditPanel::verify);
  connect(&place_.session, &Session::changed, this, &AuditPanel::load);
  retranslate();
}

void AuditPanel::retranslate() {
  setTitle(tr("Audit trail"));
  table_->setHorizontalHeaderLabels({tr("Time"), tr("Who"), tr("What"), tr("Of what"), tr("Reason")});
  table_->setAccessibleName(tr("Audit trail, newest first"));
  verify_->setText(tr("Check the chain"));
  verify_->setAccessibleName(tr("Check that no entry was changed, put in or taken out"));
  words_->setText(tr("The audit trail is shown to QA and administrators who have signed in."));
  load();
}

void AuditPanel::load() {
  const bool may = place_.archive != nullptr &&
                   (place_.session.may(Permission::ManageUsers) || place_.session.may(Permission::ApproveRecipes));
  for (QWidget* w : std::initializer_list<QWidget*>{table_, verify_, result_}) w->setVisible(may);
  words_->setVisible(!may);
  if (!may) return;
  reader_.ask("audit", [this](const Archive* archive, const std::string& /*problem*/) -> ArchiveReader::Answer {
    if (archive == nullptr) return {};
    auto entries = AuditTrail(*archive).entries();
    if (!entries) return [this, words = entries.error().message()] { result_->setText(QString::fromStdString(words)); };
    return [this, entries = std::move(*entries)] { show(entries); };
  });
}

void AuditPanel::show(const std::vector<AuditEntry>& entries) {
  entries_ = entries;
  table_->setRowCount(static_cast<int>(entries_.size()));
  for (int i = 0; i < table_->rowCount(); ++i) {
    const AuditEntry& e = entries_[static_cast<std::size_t>(i)];
    const QString cells[] = {
        QDateTime::fromMSecsSinceEpoch(e.timeUs / 1000).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")),
        QString::fromStdString(e.user), QString::fromStdString(e.action), QString::fromStdString(e.subject),
        QString::fromStdString(e.reason)};
    for (int column = 0; column < 5; ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setToolTip(column == 3 && !e.details.empty() ? QString::fromStdString(e.details) : cells[column]);
      table_->setItem(i, column, item);
    }
  }
  setNote(tr("%n entry(s), the newest first", nullptr, table_->rowCount()));
  resizeEvent(nullptr);
}

void AuditPanel::resizeEvent(QResizeEvent* event) {
  if (event != nullptr) Panel::resizeEvent(event);
  const int shares[] = {20, 14, 22, 18};
  for (int column = 0; column < 4; ++column)
    table_->setColumnWidth(column, table_->viewport()->width() * shares[column] / 100);
}

void AuditPanel::verify() {
  verify_->setEnabled(false);
  result_->setText(tr("checking …"));
  reader_.ask("verify", [this](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
    const auto wrong = archive != nullptr ? AuditTrail(*archive).verify()
                                          : Expected<std::vector<std::string>>(worldError("archive", problem));
    return [this, wrong] {
      verify_->setEnabled(true);
      if (!wrong)
        result_->setText(QString::fromStdString(wrong.error().message()));
      else if (wrong->empty())
        result_->setText(tr("The chain is whole: no entry was changed, put in or taken out."));
      else
        result_->setText(tr("The chain is broken: %1").arg(QString::fromStdString(wrong->front())));
    };
  });
}

}  // namespace vignole
