#pragma once
// The frame that every page is made of: title and a note in one line, content below.

#include <QFrame>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTableView;
class QVBoxLayout;

namespace vignole {

class Theme;

class Panel : public QFrame {
  Q_OBJECT

 public:
  explicit Panel(QWidget* parent = nullptr);
  void setTitle(const QString& title);
  void setNote(const QString& note);                               ///< beside the title, smaller
  [[nodiscard]] QHBoxLayout* head() const { return head_; }        ///< buttons are added at its end
  [[nodiscard]] QVBoxLayout* content() const { return content_; }  ///< no margins of its own

 private:
  QLabel *title_, *note_;
  QHBoxLayout* head_;
  QVBoxLayout* content_;
};

/// A button of 44 px with an icon of resources/icons (empty: none) that follows the theme; `first`: the action that is
/// offered first.
[[nodiscard]] QPushButton* makeButton(const Theme& theme, const QString& icon, QWidget* parent, bool first = false);
/// A table as all pages have it: rows of 46 px, no grid but lines between rows, whole rows chosen, sorted by nothing.
void styleTable(QTableView& table);
/// A label of the page's own type; wraps when `wrapped`. `role`: "t1", "t2" or "t3" of the palette.
[[nodiscard]] QLabel* makeLabel(int pixels, int weight, const char* role, QWidget* parent, bool wrapped = false);

}  // namespace vignole
