#pragma once
// What all pages share: A4, its margins, head and foot, and a PDF of pages.

#include <QByteArray>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <functional>
#include <vector>

#include "report/palette.h"

namespace vignole {

/// Units of a page: half a point, so that the sizes of the mock-ups in px become 7 to 12 pt.
struct PageFrame {
  QString title;    ///< after the product's name
  QString subject;  ///< right end of the head
  QString foot;
  bool simulation = false;      ///< the mark in the head ...
  bool markOnFirstPage = true;  ///< ... of the first page too
};

/// Where the body of a page stands.
[[nodiscard]] QRectF pageBody();

/// Text with its base line at y.
void writeText(QPainter& painter, double x, double y, const QString& what, const QColor& ink, double px = 16,
               int weight = 400);
void writeTextRight(QPainter& painter, double right, double y, const QString& what, const QColor& ink, double px = 16);

/// A whole PDF, one function a page, each given the body's area; empty if it could not be begun.
[[nodiscard]] QByteArray pdfOfPages(const PageFrame& frame, const QString& title, const QString& creator,
                                    const std::vector<std::function<void(QPainter&, const QRectF&)>>& pages);

}  // namespace vignole
