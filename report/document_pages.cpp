#include "report/document_pages.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QImage>
#include <QPen>
#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/files/atomic_file.h"
#include "report/page_frame.h"
#include "report/plot_painter.h"
#include "report/report_parts.h"
#include "report/state_symbol.h"
#include "report/typeface.h"

namespace vignole {

namespace {

constexpr double kGap = 18;
constexpr double kRowPx = 25, kTextPx = 15, kHeadPx = 14;
constexpr double kFactRowPx = 50;
constexpr int kFactColumns = 4;

QString text(const std::string& s) { return QString::fromStdString(s); }

StateSymbol symbolOf(Standing standing) {
  switch (standing) {
    case Standing::Bad:
      return StateSymbol::Out;
    case Standing::Near:
      return StateSymbol::Near;
    case Standing::Good:
    case Standing::None:
      break;
  }
  return StateSymbol::Good;
}

/// Places blocks on pages; what a page holds is painted later, when the number of pages is known.
class Typesetter {
 public:
  using Paint = std::function<void(QPainter&)>;

  std::vector<std::function<void(QPainter&, const QRectF&)>> set(const Document& document) {
    newPage();
    for (const Block& block : document.blocks) std::visit([this](const auto& b) { place(b); }, block);
    std::vector<std::function<void(QPainter&, const QRectF&)>> pages;
    for (const auto& page : pages_)
      pages.emplace_back([&page](QPainter& painter, const QRectF&) {
        for (const Paint& paint : page) paint(painter);
      });
    return pages;
  }

 private:
  void newPage() {
    pages_.emplace_back();
    y_ = body_.top();
  }
  [[nodiscard]] double left() const { return body_.bottom() - y_; }
  /// Makes room for something that is not torn apart.
  void need(double height) {
    if (height > left() && y_ > body_.top()) newPage();
  }
  void add(Paint paint) { pages_.back().push_back(std::move(paint)); }
  [[nodiscard]] static double paragraphHeight(const QString& what, double px, double width) {
    return QFontMetricsF(typeface(px)).boundingRect(QRectF(0, 0, width, 1e5), Qt::TextWordWrap, what).height();
  }

  void title(const std::string& what, double following) {
    if (what.empty()) return;
    need(34 + following);
    add([this, y = y_, what](QPainter& p) { writeText(p, body_.left(), y + 18, text(what), palette_.t1, 18, 500); });
    y_ += 34;
  }
  void note(const std::string& what) {
    if (!what.empty()) place(Paragraph{what, true});
  }

  void place(const Heading& heading) {
    if (y_ > body_.top()) y_ += kGap;
    need(160);
    add([this, y = y_, heading](QPainter& p) {
      writeText(p, body_.left(), y + 22, text(heading.text), palette_.t1, 22, QFont::Bold);
    });
    y_ += 40;
  }
  void place(const Paragraph& paragraph) {
    const double px = paragraph.note ? 14 : 16;
    const double height = paragraphHeight(text(paragraph.text), px, body_.width());
    need(height);
    const QRectF area(body_.left(), y_, body_.width(), height + 4);
    add([this, area, px, paragraph](QPainter& p) {
      p.setFont(typeface(px));
      p.setPen(paragraph.note ? palette_.t3 : palette_.t1);
      p.drawText(area, Qt::TextWordWrap, text(paragraph.text));
    });
    y_ += height + 12;
  }
  void place(const FactList& list) {
    const std::size_t rows = (list.facts.size() + kFactColumns - 1) / kFactColumns;
    const double height = kFactRowPx * static_cast<double>(rows);
    need(height);
    std::vector<Fact> facts;
    for (const auto& [label, value] : list.facts) facts.push_back({text(label), text(value)});
    add([this, area = QRectF(body_.left(), y_, body_.width(), height), facts](QPainter& p) {
      p.setFont(typeface(16));
      paintFacts(p, area, facts, kFactColumns, palette_);
    });
    y_ += height + kGap / 2;
  }
  void place(const VerdictLine& verdict) {
    const double reason = paragraphHeight(text(verdict.reason), 17, body_.width() - 120);
    const double height = 62 + reason + 12;
    need(height);
    add([this, area = QRectF(body_.left(), y_, body_.width(), height), verdict](QPainter& p) {
      const bool bad = verdict.standing == Standing::Bad, near = verdict.standing == Standing::Near;
      p.fillRect(area, bad ? palette_.outSoft : near ? palette_.nearSoft : palette_.panel);
      p.fillRect(QRectF(area.topLeft(), QSizeF(10, area.height())), bad    ? palette_.out
                                                                    : near ? palette_.near
                                                                           : palette_.t3);
      paintSymbol(p, QRectF(area.left() + 28, area.top() + 14, 44, 44), symbolOf(verdict.standing), palette_);
      writeText(p, area.left() + 92, area.top() + 44, text(verdict.headline), palette_.t1, 30, QFont::Bold);
      p.setFont(typeface(17));
      p.setPen(palette_.t1);
      p.drawText(QRectF(area.left() + 92, area.top() + 58, area.width() - 108, area.height() - 60), Qt::TextWordWrap,
                 text(verdict.reason));
    });
    y_ += height + kGap;
  }

  // --- tables -------------------------------------------------------------------------------------------------------

  struct Columns {
    std::vector<double> x, width;
    std::vector<bool> leftAligned;
    std::vector<QString> heads;
  };
  [[nodiscard]] Columns columnsOf(const TableBlock& table) const {
    Columns c;
    const QFontMetricsF body(typeface(kTextPx)), head(typeface(kHeadPx));
    double total = 0;
    for (std::size_t i = 0; i < table.heads.size(); ++i) {
      const bool leftAligned = table.heads[i].starts_with('<');
      c.leftAligned.push_back(leftAligned);
      c.heads.push_back(text(table.heads[i].substr(leftAligned ? 1 : 0)));
      double widest = head.horizontalAdvance(c.heads.back());
      for (const auto& row : table.rows)
        if (i < row.size()) widest = std::max(widest, body.horizontalAdvance(text(row[i])));
      widest = 1.04 * widest + 2;  // a printer's metrics are not the screen's
      c.width.push_back(widest);
      total += widest;
    }
    const double marks = table.standings.empty() ? 0 : 28;
    const double room = body_.width() - marks;
    const double gaps = 20 * static_cast<double>(table.heads.size());
    if (total + gaps > room) {
      // Too wide: the widest columns give way, their texts are elided.
      double limit = room;
      while (limit > 40) {
        double sum = 0;
        for (const double w : c.width) sum += std::min(w, limit);
        if (sum + gaps <= room) break;
        limit -= 4;
      }
      total = 0;
      for (double& w : c.width) total += (w = std::min(w, limit));
    }
    const double extra = std::min(90.0, (room - total) / static_cast<double>(std::max<std::size_t>(1, c.width.size())));
    double x = body_.left() + marks;
    for (const double w : c.width) {
      c.x.push_back(x);
      x += w + extra;
    }
    return c;
  }
  void cell(QPainter& p, const Columns& c, std::size_t i, double y, const QString& what) const {
    const QString shown = QFontMetricsF(p.font()).horizontalAdvance(what) > c.width[i]
                              ? QFontMetricsF(p.font()).elidedText(what, Qt::ElideRight, c.width[i])
                              : what;
    const double x = c.leftAligned[i] ? c.x[i] : c.x[i] + c.width[i] - QFontMetricsF(p.font()).horizontalAdvance(shown);
    p.drawText(QPointF(x, y), shown);
  }
  void place(const TableBlock& table) {
    const double atLeast = kRowPx * (1 + static_cast<double>(std::min<std::size_t>(table.rows.size(), 4)));
    title(table.title, atLeast);
    need(atLeast);
    const Columns columns = columnsOf(table);
    const auto head = [&] {
      add([this, y = y_, columns](QPainter& p) {
        p.setFont(typeface(kHeadPx));
        p.setPen(palette_.t2);
        for (std::size_t i = 0; i < columns.heads.size(); ++i) cell(p, columns, i, y + 17, columns.heads[i]);
      });
      y_ += kRowPx;
    };
    head();
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      if (kRowPx > left()) {
        newPage();
        head();
      }
      const Standing standing = r < table.standings.size() ? table.standings[r] : Standing::None;
      add([this, y = y_, columns, row = table.rows[r], standing](QPainter& p) {
        if (standing == Standing::Bad || standing == Standing::Near)
          p.fillRect(QRectF(body_.left(), y, body_.width(), kRowPx),
                     standing == Standing::Bad ? palette_.outSoft : palette_.nearSoft);
        p.setPen(QPen(palette_.line2, 1));
        p.drawLine(QPointF(body_.left(), y), QPointF(body_.right(), y));
        if (standing != Standing::None)
          paintSymbol(p, QRectF(body_.left() + 2, y + 4, 17, 17), symbolOf(standing), palette_);
        p.setFont(typeface(kTextPx));
        p.setPen(palette_.t1);
        for (std::size_t i = 0; i < row.size() && i < columns.x.size(); ++i) cell(p, columns, i, y + 18, text(row[i]));
      });
      y_ += kRowPx;
    }
    y_ += 8;
    note(table.note);
    y_ += kGap / 2;
  }

  // --- pictures and plots -------------------------------------------------------------------------------------------

  void place(const PictureBlock& block) {
    if (block.cells.empty()) return;
    const double gap = 16, columns = std::max(1, block.columns);
    const double width = (body_.width() - gap * (columns - 1)) / columns;
    const auto heightOf = [&](const PictureCell& cell) {
      return (cell.width > 0 ? width * cell.height / cell.width : width) + (cell.caption.empty() ? 0 : 24);
    };
    title(block.title, heightOf(block.cells.front()));
    for (std::size_t first = 0; first < block.cells.size(); first += static_cast<std::size_t>(columns)) {
      const std::size_t last = std::min(block.cells.size(), first + static_cast<std::size_t>(columns));
      double height = 0;
      for (std::size_t i = first; i < last; ++i) height = std::max(height, heightOf(block.cells[i]));
      need(height);
      for (std::size_t i = first; i < last; ++i) {
        const QRectF area(body_.left() + static_cast<double>(i - first) * (width + gap), y_, width, height);
        add([this, area, &cell = block.cells[i]](QPainter& p) { picture(p, area, cell); });
      }
      y_ += height + gap;
    }
    note(block.note);
  }
  void picture(QPainter& p, const QRectF& area, const PictureCell& cell) const {
    if (cell.width <= 0 || cell.height <= 0) return;
    const double scale = area.width() / cell.width;
    const QRectF frame(area.topLeft(), QSizeF(area.width(), scale * cell.height));
    if (cell.grey.empty()) {
      p.fillRect(frame, palette_.panel2);
    } else {
      const QImage image(cell.grey.data(), cell.width, cell.height, cell.width, QImage::Format_Grayscale8);
      p.drawImage(frame, image);
    }
    p.save();
    p.setClipRect(frame);
    for (const Curve& curve : cell.curves)
      paintCurve(
          p, curve, curveColour(curve.colour, cell.grey.empty() ? palette_ : darkPalette()),
          [&](const Point2& at) { return frame.topLeft() + QPointF((at.x() + 0.5) * scale, (at.y() + 0.5) * scale); });
    p.restore();
    p.setPen(QPen(palette_.line, 1));
    p.setBrush(Qt::NoBrush);
    p.drawRect(frame);
    if (!cell.caption.empty()) writeText(p, area.left(), frame.bottom() + 18, text(cell.caption), palette_.t2, 14);
  }
  void place(const PlotBlock& block) {
    if (block.plots.empty()) return;
    const double gap = 24, columns = std::max(1, block.columns);
    const double width = (body_.width() - gap * (columns - 1)) / columns, height = width * block.aspect;
    title(block.title, height);
    for (std::size_t first = 0; first < block.plots.size(); first += static_cast<std::size_t>(columns)) {
      need(height);
      const std::size_t last = std::min(block.plots.size(), first + static_cast<std::size_t>(columns));
      for (std::size_t i = first; i < last; ++i) {
        const QRectF area(body_.left() + static_cast<double>(i - first) * (width + gap), y_, width, height);
        add([this, area, &plot = block.plots[i]](QPainter& p) { paintPlot(p, area, plot, palette_); });
      }
      y_ += height + gap;
    }
    note(block.note);
  }

  const Palette& palette_ = lightPalette();
  const QRectF body_ = pageBody();
  std::vector<std::vector<Paint>> pages_;
  double y_ = 0;
};

}  // namespace

Expected<void> writeDocument(const Document& document, const std::string& programVersion,
                             const std::filesystem::path& file) {
  if (file.extension() != ".pdf")
    return inputError(file.string(), "this report is written as .pdf; name the file accordingly");
  if (qGuiApp == nullptr) return worldError(file.string(), "pages need a QGuiApplication before they can be painted");
  Typesetter typesetter;
  const auto pages = typesetter.set(document);
  PageFrame frame{text(document.title), text(document.subject), text(document.foot), document.simulation, true};
  const QByteArray bytes =
      pdfOfPages(frame, text(document.title), QStringLiteral("Vignole ") + text(programVersion), pages);
  if (bytes.isEmpty()) return worldError(file.string(), "the pages could not be painted; is there enough memory?");
  return writeFile(file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

}  // namespace vignole
