#pragma once
// Who changed what that touches quality, when and why; nobody can change what stands here.

#include "engine/archive/audit_trail.h"
#include "gui/bridge/workplace.h"
#include "gui/theme/panel.h"

class QTableWidget;

namespace vignole {

class ArchiveReader;

class AuditPanel : public Panel {
  Q_OBJECT

 public:
  AuditPanel(Workplace& place, ArchiveReader& reader, QWidget* parent = nullptr);
  void retranslate();
  void load();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show(const std::vector<AuditEntry>& entries);
  void verify();

  Workplace& place_;
  ArchiveReader& reader_;
  std::vector<AuditEntry> entries_;
  QLabel *words_, *result_;
  QTableWidget* table_;
  QPushButton* verify_;
};

}  // namespace vignole
