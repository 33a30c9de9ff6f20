#include "gui/recipes/section_dialog.h"

#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <algorithm>

#include "engine/database/archive_url.h"
#include "engine/files/atomic_file.h"
#include "engine/rail/catalogue.h"
#include "engine/rail/outline.h"
#include "gui/recipes/section_drawing.h"
#include "gui/theme/panel.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {

QString shown(const std::string& text) { return QString::fromStdString(text); }

/// Sections that people bring lie beside the archive whose recipes name them.
Expected<std::filesystem::path> sectionFolder(const Workplace& place) {
  if (place.archive == nullptr) return worldError("archive", "there is none to keep the section with");
  const auto url = parseArchiveUrl(place.archiveUrl);
  if (!url) return tl::unexpected(url.error());
  const std::filesystem::path folder = std::filesystem::absolute(url->file).parent_path() / "sections";
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return worldError(folder.string(), "cannot be made: " + failed.message());
  return folder;
}

}  // namespace

SectionDialog::SectionDialog(Workplace& place, QWidget* parent) : QDialog(parent), place_(place) {
  auto* all = new QGridLayout(this);
  all->setContentsMargins(24, 20, 24, 20);
  all->setHorizontalSpacing(24);
  all->setVerticalSpacing(10);
  drawing_ = new SectionDrawing(place.theme, this);
  words_ = makeLabel(16, 500, "t1", this, true);
  facts_ = makeLabel(15, 400, "t2", this, true);
  table_ = new QTableWidget(0, 4, this);
  styleTable(*table_);
  table_->setFont(uiFont(15));
  table_->verticalHeader()->setDefaultSectionSize(28);
  nameWord_ = makeLabel(15, 400, "t2", this);
  classWord_ = makeLabel(15, 400, "t2", this);
  name_ = new QLineEdit(this);
  class_ = new QComboBox(this);
  for (QWidget* w : std::initializer_list<QWidget*>{name_, class_}) w->setFont(uiFont(16));
  for (const char* one : {"X/A", "X/B", "Y/A", "Y/B"}) class_->addItem(QString::fromLatin1(one));
  open_ = makeButton(place.theme, QStringLiteral("import"), this);
  make_ = makeButton(place.theme, QStringLiteral("save"), this, true);
  close_ = makeButton(place.theme, QString(), this);
  all->addWidget(words_, 0, 0, 1, 2);
  all->addWidget(drawing_, 1, 0);
  auto* side = new QVBoxLayout;
  auto* form = new QGridLayout;
  form->setSpacing(8);
  side->setSpacing(8);
  form->addWidget(nameWord_, 0, 0);
  form->addWidget(name_, 0, 1);
  form->addWidget(classWord_, 1, 0);
  form->addWidget(class_, 1, 1);
  form->setColumnStretch(1, 1);
  side->addWidget(facts_);
  side->addWidget(table_, 1);
  side->addLayout(form);
  all->addLayout(side, 1, 1);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addWidget(open_);
  buttons->addStretch(1);
  buttons->addWidget(make_);
  buttons->addWidget(close_);
  all->addLayout(buttons, 2, 0, 1, 2);
  all->setColumnStretch(0, 3);
  all->setColumnStretch(1, 2);
  all->setRowStretch(1, 1);
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    const QTableWidgetItem* item = table_->item(table_->currentRow(), 0);
    drawing_->setChosen(item != nullptr ? item->text() : QString());
  });
  connect(open_, &QPushButton::clicked, this, [this] {
    openFile(QFileDialog::getOpenFileName(this, tr("Drawing of a section"), {},
                                          QStringLiteral("DXF, JSON, MiniProf (*.dxf *.json *.ban *.prr)")));
  });
  connect(name_, &QLineEdit::editingFinished, this, &SectionDialog::read);
  connect(make_, &QPushButton::clicked, this, &SectionDialog::make);
  connect(close_, &QPushButton::clicked, this, &QDialog::close);
  resize(1180, 680);
  retranslate();
}

QString SectionDialog::words() const { return words_->text(); }

void SectionDialog::retranslate() {
  setWindowTitle(tr("Section"));
  drawing_->setAccessibleName(tr("Section with its primitives named"));
  table_->setHorizontalHeaderLabels({tr("Name"), tr("Kind"), tr("Length, mm"), tr("Radius, mm")});
  table_->setAccessibleName(tr("Primitives of the section"));
  nameWord_->setText(tr("Name"));
  name_->setAccessibleName(tr("Name of the section"));
  classWord_->setText(tr("Class"));
  class_->setAccessibleName(tr("Profile and straightness class of its recipe"));
  open_->setText(tr("Open a drawing…"));
  open_->setAccessibleName(tr("Open a drawing of a section"));
  make_->setText(tr("Make a draft of it"));
  make_->setAccessibleName(tr("Keep the section and make a draft of it"));
  close_->setText(tr("Close"));
  close_->setAccessibleName(close_->text());
  showFacts();
}

void SectionDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void SectionDialog::showSection(const Section& section) {
  file_.clear();
  section_ = section;
  name_->setText(shown(section.name));
  drawing_->show(section);
  showFacts();
}

void SectionDialog::openFile(const QString& file) {
  if (file.isEmpty()) return;
  file_ = file;
  name_->setText(QFileInfo(file).completeBaseName());
  read();
}

void SectionDialog::read() {
  if (file_.isEmpty()) return;
  const std::filesystem::path path = file_.toStdString();
  auto section = importSection(path, name_->text().trimmed().toStdString());
  if (section) {
    section_ = *std::move(section);
    drawing_->show(*section_);
    showFacts();
    return;
  }
  section_.reset();
  const auto pieces = readPieces(path);
  if (pieces && !pieces->empty())
    drawing_->showOpen(*pieces, firstGap(*pieces));
  else
    drawing_->showMessage(tr("There is nothing in this file that could be drawn."));
  showFacts();
  words_->setText(tr("Refused: %1").arg(shown(section.error().message())));
}

void SectionDialog::showFacts() {
  const bool brought = !file_.isEmpty();
  for (QWidget* w : std::initializer_list<QWidget*>{nameWord_, name_, classWord_, class_, make_})
    w->setVisible(brought);
  make_->setEnabled(section_.has_value() && place_.session.may(Permission::EditRecipes) && place_.archive != nullptr);
  make_->setToolTip(place_.session.may(Permission::EditRecipes) ? QString() : tr("QA makes drafts: sign in."));
  table_->setRowCount(0);
  if (!section_) {
    facts_->clear();
    words_->setText(tr("Open a drawing: one closed outline of lines and arcs, the rail upright."));
    if (!brought) drawing_->showMessage(tr("DXF, JSON or a MiniProf design"));
    return;
  }
  const SectionProperties p = properties(*section_);
  words_->setText(section_->note.empty() ? shown(section_->name) : shown(section_->note));
  facts_->setText(
      tr("%1 mm high, %2 cm², %3 kg/m, %4; %n primitive(s)", nullptr, static_cast<int>(section_->primitives.size()))
          .arg(numberText(section_->heightMm(), 3), numberText(p.areaMm2 / 100, 2), numberText(p.massKgPerM, 2),
               section_->symmetric() ? tr("symmetric") : tr("asymmetric")));
  table_->setRowCount(static_cast<int>(section_->primitives.size()));
  for (int i = 0; i < table_->rowCount(); ++i) {
    const NamedPrimitive& primitive = section_->primitives[static_cast<std::size_t>(i)];
    const auto* arc = std::get_if<Arc>(&primitive.shape);
    const QString cells[] = {shown(primitive.name), arc != nullptr ? tr("arc") : tr("segment"),
                             numberText(length(primitive.shape), 3),
                             arc != nullptr ? numberText(arc->radiusMm, 2) : QStringLiteral("–")};
    for (int column = 0; column < 4; ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setTextAlignment((column < 2 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      table_->setItem(i, column, item);
    }
  }
}

void SectionDialog::make() {
  if (!section_ || file_.isEmpty()) return;
  const QString name = name_->text().trimmed();
  static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9][A-Za-z0-9 ._-]*$"));
  if (!plain.match(name).hasMatch()) {
    words_->setText(tr("A name has letters, digits, spaces, dots and hyphens: it becomes the name of a file."));
    return;
  }
  const auto catalogue = catalogueNames();
  if (std::find(catalogue.begin(), catalogue.end(), name.toStdString()) != catalogue.end()) {
    words_->setText(tr("%1 is a section of the catalogue: give yours another name.").arg(name));
    return;
  }
  section_->name = name.toStdString();
  const auto folder = sectionFolder(place_);
  if (!folder) {
    words_->setText(shown(folder.error().message()));
    return;
  }
  const std::filesystem::path file = *folder / (section_->name + ".json");
  const std::string text = toJson(*section_);
  // Recipes refer to it: a section that is there is never changed under them.
  if (const auto there = readFile(file); there && *there != text) {
    words_->setText(tr("There is another section of the name %1: give a new name.").arg(name));
    return;
  }
  if (const auto written = writeFile(file, text); !written) {
    words_->setText(shown(written.error().message()));
    return;
  }
  const QStringList classes = class_->currentText().split('/');
  const auto recipe = makeRecipe(file.string(), classes[0].toStdString(), classes[1].toStdString());
  if (!recipe) {
    words_->setText(shown(recipe.error().message()));
    return;
  }
  emit made(*recipe, QFileInfo(file_).fileName());
  accept();
}

}  // namespace vignole
