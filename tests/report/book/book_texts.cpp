#include "tests/report/book/book_texts.h"

#include "app/report/book/flow.h"
#include "app/report/book/print_book.h"

namespace noonmark::tests {

std::vector<PaintedText> textsOfPage(const Book& book, std::size_t index) {
    constexpr double unit = MeasuringCanvas::unitsPerPoint;
    RecordedPage page((sizePt(book.setup) * unit).toSize());
    QPainter painter(&page);
    paintPage(book, index, {painter, unit});
    painter.end();
    return page.texts();
}

std::vector<std::string> listMeetings(const std::vector<PaintedText>& texts) {
    std::vector<std::string> meetings;
    for (std::size_t i = 0; i < texts.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const PaintedText &a = texts[i], &b = texts[j];
            if (a.text.trimmed().isEmpty() || b.text.trimmed().isEmpty() || !a.box.intersects(b.box))
                continue;
            if (!a.outline.intersects(b.outline)) continue;
            meetings.push_back(a.text.toStdString() + " / " + b.text.toStdString());
        }
    return meetings;
}

QString textOfPage(const Book& book, std::size_t index) {
    QString all;
    for (const PaintedText& text : textsOfPage(book, index)) all += text.text + u' ';
    return all.simplified();
}

}  // namespace noonmark::tests
