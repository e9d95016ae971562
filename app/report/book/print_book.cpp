#include "app/report/book/print_book.h"

#include <QBuffer>
#include <QImageReader>
#include <QPdfWriter>
#include <cmath>

#include "app/report/book/flow.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/pdf_page.h"
#include "app/report/sheets/study_text.h"

namespace noonmark {

namespace {

QRectF scaled(const QRectF& area, double by) {
    return {area.left() * by, area.top() * by, area.width() * by, area.height() * by};
}

void paintPicture(const Canvas& canvas, const QRectF& area, const PagePicture& picture, double scale) {
    const double caption = captionPt(scale) * canvas.point;
    const QRectF room = area.adjusted(0, 0, 0, -caption);
    const QSizeF size = QSizeF(picture.image.size()).scaled(room.size(), Qt::KeepAspectRatio);
    const QRectF box(room.center() - QPointF(size.width() / 2, size.height() / 2), size);
    canvas.painter.save();
    canvas.painter.setRenderHint(QPainter::LosslessImageRendering);
    canvas.painter.setRenderHint(QPainter::SmoothPixmapTransform);
    canvas.painter.drawImage(box, picture.image);
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(linePen(canvas, ink::quiet, 0.6));
    canvas.painter.drawRect(box);
    canvas.painter.restore();
    paintCaption(canvas, {area.left(), area.bottom() - caption, area.width(), caption}, picture.caption,
                 scale);
}

struct ChartPainter {
    const Canvas& canvas;
    QRectF area;

    void operator()(const TimelineChart& chart) const { paintTimeline(canvas, area, chart); }
    void operator()(const CarpetChart& chart) const { paintCarpet(canvas, area, chart); }
    void operator()(const BarChart& chart) const { paintBars(canvas, area, chart); }
};

void paintChart(const Canvas& canvas, const QRectF& area, const PageChart& page, double scale) {
    const double caption = captionPt(scale) * canvas.point;
    paintCaption(canvas, {area.left(), area.top(), area.width(), caption}, page.caption, scale);
    const Canvas larger{canvas.painter, canvas.point * scale};
    std::visit(ChartPainter{larger, area.adjusted(0, caption, 0, 0)}, page.chart);
}

void paintPageMap(const Canvas& canvas, const QRectF& area, const PageMap& map, double scale,
                  UnitSystem units) {
    const Canvas larger{canvas.painter, canvas.point * scale};
    const double foot = (legendHeightPt + 8) * larger.point;
    const bool hasCaption = !map.caption.first.isEmpty();
    const double caption = hasCaption ? captionPt(scale) * canvas.point : 0;
    const QRectF room = area.adjusted(0, caption, 0, -foot);
    if (hasCaption)
        paintCaption(canvas, {area.left(), area.top(), area.width(), caption}, map.caption, scale);
    const MapView view = makeMapView(map.map->scene, room);
    paintMap(canvas, view, map.map->scene, units);
    paintMapFoot(larger, {area.left(), room.bottom() + 8 * larger.point, area.width(), foot}, view,
                 map.map->legend, map.map->scene, units);
}

/// Paints the content of an item in its area.
struct ContentPainter {
    const Canvas& canvas;
    QRectF area;
    double scale;
    UnitSystem units;

    void operator()(const PageText& text) const { paintBlocks(canvas, text.blocks, area, text.points); }
    void operator()(const PageTable& table) const { paintTable(canvas, area, table); }
    void operator()(const Diagram& diagram) const { paintDiagram(canvas, area, diagram); }
    void operator()(const DiagramFoot& foot) const { paintDiagramFoot(canvas, area, foot); }
    void operator()(const ElevationDrawing& drawing) const { paintElevation(canvas, area, drawing); }
    void operator()(const ElevationFoot& foot) const { paintElevationFoot(canvas, area, foot); }
    void operator()(const PageChart& chart) const { paintChart(canvas, area, chart, scale); }
    void operator()(const PageMap& map) const { paintPageMap(canvas, area, map, scale, units); }
    void operator()(const PagePicture& picture) const { paintPicture(canvas, area, picture, scale); }
};

/// The frame of a page: line, heading, credit and title block.
class FramePainter {
public:
    FramePainter(const Book& book, std::size_t index, const Canvas& canvas)
        : book_(book), index_(index), canvas_(canvas), scale_(textScale(book.setup)) {}

    void paint() {
        paintHeading();
        paintTitleBlock();
        canvas_.painter.setBrush(Qt::NoBrush);
        canvas_.painter.setPen(linePen(canvas_, ink::text, 0.9 * scale_));
        canvas_.painter.drawRect(scaled(frameArea(book_.setup), canvas_.point));
    }

private:
    void paintHeading() {
        const BookPage& page = book_.pages[index_];
        const QRectF area = scaled(headingArea(book_.setup), canvas_.point);
        const double title = area.height() * (page.subtitle.isEmpty() ? 1 : 0.56);
        paintFitted(canvas_, {area.left(), area.top(), area.width(), title}, page.title, 15 * scale_, 6,
                    QFont::Bold, ink::heading);
        paintFitted(canvas_, {area.left(), area.top() + title, area.width(), area.height() - title},
                    page.subtitle, 8.2 * scale_, 4.5, QFont::Normal, ink::quiet);
    }

    /// A cell: a small name above its value.
    void paintCell(const QRectF& cell, const char* name, const QString& text, double maximum) {
        outline(cell);
        const double unit = scale_ * canvas_.point;
        const QRectF inside = cell.adjusted(4 * unit, 1.5 * unit, -4 * unit, -1.5 * unit);
        const QRectF label(inside.left(), inside.top(), inside.width(), 6.4 * unit);
        paintFitted(canvas_, label, sheetText(name), 5 * scale_, 4, QFont::Normal, ink::quiet);
        paintFitted(canvas_, inside.adjusted(0, 6.4 * unit, 0, 0), text, maximum * scale_, 3.4,
                    QFont::Medium);
    }

    void outline(const QRectF& cell) {
        canvas_.painter.setBrush(Qt::NoBrush);
        canvas_.painter.setPen(linePen(canvas_, ink::quiet, 0.5));
        canvas_.painter.drawRect(cell);
    }

    void paintTitleBlock() {
        const TitleBlock& block = book_.titleBlock;
        const QRectF strip = scaled(titleBlockArea(book_.setup), canvas_.point);
        const double unit = scale_ * canvas_.point, row = strip.height() / 2;
        const double number = 78 * unit, logo = paintLogo(strip);
        paintNumber({strip.right() - number, strip.top(), number, strip.height()});
        const double left = strip.left() + logo, width = strip.width() - logo - number;
        const auto cell = [&](double from, double to, int line) {
            return QRectF(left + from * width, strip.top() + line * row, (to - from) * width, row);
        };
        paintCell(cell(0, 0.46, 0), NM_TEXT("Project"), plainText(block.project), 10);
        paintCell(cell(0.46, 1, 0), NM_TEXT("Title"), book_.title, 9);
        paintCell(cell(0, 0.3, 1), NM_TEXT("Client"), plainText(block.client), 8);
        paintCell(cell(0.3, 0.6, 1), NM_TEXT("Author"), plainText(block.author), 8);
        paintCell(cell(0.6, 0.8, 1), NM_TEXT("Date"), book_.date, 8);
        paintCell(cell(0.8, 1, 1), NM_TEXT("Program"), describeProgram(), 8);
        const QRectF credit(strip.left() + 4 * unit, strip.top() - 11 * unit, strip.width() - 8 * unit,
                            10 * unit);
        paintFitted(canvas_, credit, book_.credit, 6 * scale_, 3.6, QFont::Normal, ink::quiet);
    }

    void paintNumber(const QRectF& cell) {
        outline(cell);
        const double unit = scale_ * canvas_.point;
        const QRectF inside = cell.adjusted(4 * unit, 1.5 * unit, -4 * unit, -1.5 * unit);
        paintFitted(canvas_, {inside.left(), inside.top(), inside.width(), 6.4 * unit}, sheetText("Sheet"),
                    5 * scale_, 4, QFont::Normal, ink::quiet);
        paintFitted(canvas_, inside.adjusted(0, 7 * unit, 0, -13 * unit), sheetNumber(book_, index_),
                    20 * scale_, 4, QFont::Bold, ink::heading, Qt::AlignHCenter);
        paintFitted(canvas_, {inside.left(), inside.bottom() - 11 * unit, inside.width(), 10 * unit},
                    sheetText("sheet %1 of %2").arg(index_ + 1).arg(book_.pages.size()), 7 * scale_, 4,
                    QFont::Normal, ink::quiet, Qt::AlignHCenter);
    }

    /// Returns the width of the logo's cell; 0 without one. A picture that cannot be read is left out.
    double paintLogo(const QRectF& strip) {
        const auto& bytes = book_.titleBlock.logo;
        if (bytes.empty()) return 0;
        QByteArray data = QByteArray::fromStdString(bytes);
        QBuffer device(&data);
        QImageReader reader(&device);
        constexpr int maxPixels = 4096;
        const QSize size = reader.size();
        if (size.width() > maxPixels || size.height() > maxPixels) return 0;
        const QImage image = reader.read();
        if (image.isNull()) return 0;
        const QRectF cell(strip.left(), strip.top(), strip.height() * 1.6, strip.height());
        const double padding = 5 * scale_ * canvas_.point;
        const QRectF room = cell.adjusted(padding, padding, -padding, -padding);
        const QSizeF fit = QSizeF(image.size()).scaled(room.size(), Qt::KeepAspectRatio);
        canvas_.painter.drawImage(QRectF(room.center() - QPointF(fit.width() / 2, fit.height() / 2), fit),
                                  image);
        outline(cell);
        return cell.width();
    }

    const Book& book_;
    std::size_t index_;
    Canvas canvas_;
    double scale_;
};

}  // namespace

void paintPage(const Book& book, std::size_t index, const Canvas& canvas) {
    const SheetScope words(book.language);
    QPainter& painter = canvas.painter;
    constexpr double unit = MeasuringCanvas::unitsPerPoint;
    painter.save();
    if (std::abs(canvas.point - unit) > 1e-9) painter.scale(canvas.point / unit, canvas.point / unit);
    const Canvas inner{painter, unit};
    for (const PageItem& item : book.pages[index].items)
        std::visit(ContentPainter{inner, scaled(item.area, unit), textScale(book.setup), book.units},
                   item.content);
    FramePainter(book, index, inner).paint();
    painter.restore();
}

QImage makePagePicture(const Book& book, std::size_t index, double dotsPerInch) {
    const QSizeF size = sizePt(book.setup) * dotsPerInch / 72;
    QImage image(size.toSize(), QImage::Format_RGB32);
    image.fill(ink::paper);
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    paintPage(book, index, {painter, dotsPerInch / 72});
    return image;
}

namespace {

bool paintPages(const Book& book, QIODevice& device) {
    QPdfWriter writer(&device);
    writer.setResolution(int(MeasuringCanvas::unitsPerPoint * 72));
    writer.setPageSize(pageSizeOf(book.setup.paper));
    writer.setPageOrientation(book.setup.landscape ? QPageLayout::Landscape : QPageLayout::Portrait);
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle(book.title);
    writer.setCreator(describeProgram());
    attachRecord(book.record, writer);
    QPainter painter;
    if (!painter.begin(&writer)) return false;
    for (std::size_t i = 0; i < book.pages.size(); ++i) {
        if (i > 0 && !writer.newPage()) return false;
        paintPage(book, i, {painter, MeasuringCanvas::unitsPerPoint});
    }
    return painter.end();
}

PdfStructure structureOf(const Book& book) {
    const SheetScope words(book.language);
    PdfStructure structure{{}, QString::fromStdString(wordingInUse().code()), {}};
    for (std::size_t i = 0; i < book.pages.size(); ++i) {
        const BookPage& page = book.pages[i];
        structure.labels.push_back(sheetNumber(book, i));
        if (!page.bookmark.isEmpty()) structure.bookmarks.push_back({page.bookmark, int(i), page.level});
    }
    return structure;
}

}  // namespace

Result<QByteArray> printBook(const Book& book) {
    if (book.pages.empty()) return failure("The book has no pages");
    QBuffer pages;
    pages.open(QIODevice::WriteOnly);
    if (!paintPages(book, pages)) return failure("The pages could not be written as PDF");
    return addPdfStructure(pages.data(), structureOf(book));
}

}  // namespace noonmark
