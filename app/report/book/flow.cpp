#include "app/report/book/flow.h"

#include <QDate>
#include <QFontMetricsF>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/study_text.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

constexpr double textPt = 8;
constexpr double minColumnPt = 236;
constexpr double gutterPt = 16;
constexpr double tableGapPt = 9;  // of tables, with a little room for rounding

double heightPt(const Canvas& canvas, const TextBlocks& blocks, double widthPt, double points) {
    return heightOf(canvas, blocks, widthPt * canvas.point, points) / canvas.point;
}

/// Collects paragraphs into columns.
class TextFlow {
public:
    TextFlow(const QSizeF& size, double points) : size_(size), points_(points) {}

    void add(TextBlock block) {
        while (!fits(block)) {
            if (column_.empty()) {
                block = addPart(block);
            } else {
                breakColumn();
            }
        }
        column_.push_back(std::move(block));
    }

    std::vector<TextBlocks> finish() {
        if (!column_.empty()) columns_.push_back(std::move(column_));
        return std::move(columns_);
    }

private:
    [[nodiscard]] bool fits(const TextBlock& block) {
        TextBlocks with = column_;
        with.push_back(block);
        return heightPt(measure_.canvas(), with, size_.width(), points_) <= size_.height();
    }

    /// A heading at the end moves to the next column, unless it is alone.
    void breakColumn() {
        TextBlocks next;
        if (column_.size() > 1 && column_.back().kind == TextKind::heading) {
            next.push_back(std::move(column_.back()));
            column_.pop_back();
        }
        columns_.push_back(std::move(column_));
        column_ = std::move(next);
    }

    /// Fills an empty column with the first words of the block, or its first letters; returns the rest.
    TextBlock addPart(const TextBlock& block) {
        qsizetype low = 1, high = block.text.size();
        while (low < high) {
            const qsizetype middle = (low + high + 1) / 2;
            if (fits({block.kind, block.text.left(middle)}))
                low = middle;
            else
                high = middle - 1;
        }
        const qsizetype space = block.text.lastIndexOf(u' ', low - 1);
        const qsizetype cut = space > low / 2 ? space + 1 : low;
        columns_.push_back({{block.kind, block.text.left(cut)}});
        return {block.kind, block.text.mid(cut)};
    }

    MeasuringCanvas measure_;
    QSizeF size_;
    double points_;
    TextBlocks column_;
    std::vector<TextBlocks> columns_;
};

/// What a column of a table would have, in points.
struct ColumnNeed {
    double whole = 0;  ///< each text of its rows in one line, its title word by word
    double word = 0;   ///< no word broken
    double mean = 0;   ///< the texts of its rows, in the mean
};

ColumnNeed measureColumn(const Canvas& canvas, const PageTable& table, std::size_t column) {
    const QFontMetricsF bold(textFont(canvas, table.points, QFont::Bold), canvas.painter.device());
    const QFontMetricsF normal(textFont(canvas, table.points), canvas.painter.device());
    ColumnNeed need;
    const auto widen = [&](double& width, const QString& text, const QFontMetricsF& font) {
        for (const QString& word : text.split(u' ')) width = std::max(width, font.horizontalAdvance(word));
    };
    widen(need.word, table.titles[column], bold);
    need.whole = need.word;
    for (const auto& row : table.rows) {
        const double width = normal.horizontalAdvance(row[column]);
        widen(need.word, row[column], normal);
        need.whole = std::max(need.whole, width);
        need.mean += width / double(table.rows.size());
    }
    const double mark = column == 0 && !table.marks.empty() ? table.points : 0;
    for (double* width : {&need.whole, &need.word, &need.mean})
        *width = *width * 1.01 / canvas.point + tableGapPt + mark;
    return need;
}

BookPage pageAfter(const BookPage& first) {
    return {first.title, first.subtitle.isEmpty() ? sheetText("continued") : first.subtitle, {}, 0};
}

TextBlocks titleOf(const NamedTable& named) {
    TextBlocks blocks{heading(named.title)};
    if (!named.note.isEmpty()) blocks.push_back(body(named.note));
    return blocks;
}

/// Puts tables below each other.
class TablePages {
public:
    TablePages(const PageSetup& setup, const BookPage& page)
        : page_(page), content_(contentArea(setup)), scale_(textScale(setup)), pages_{page} {}

    void add(NamedTable named) {
        PageTable& table = named.table;
        table.widthsPt = fitColumns(table, content_.width());
        const TextBlocks title = titleOf(named);
        const double titlePt = heightPt(measure_.canvas(), title, content_.width(), textPt * scale_) + 1;
        constexpr double minRowsPt = 70;
        const double needed = std::min(tableHeightPt(table), minRowsPt * scale_);
        if (used_ > 0 && used_ + titlePt + needed > content_.height()) addPage();
        pages_.back().items.push_back({area(titlePt), PageText{title, textPt * scale_}});
        used_ += titlePt;
        for (PageTable& part : flowTable(table, content_.height() - used_, content_.height())) {
            if (part.rows.empty() && !table.rows.empty()) {
                addPage();
                continue;
            }
            const double height = tableHeightPt(part);
            if (used_ + height > content_.height() + 1 && used_ > 0) addPage();
            pages_.back().items.push_back({area(height), std::move(part)});
            used_ += height;
        }
        used_ += gutterPt * scale_;
    }

    std::vector<BookPage> finish() { return std::move(pages_); }

private:
    [[nodiscard]] QRectF area(double height) const {
        return {content_.left(), content_.top() + used_, content_.width(), height};
    }
    void addPage() {
        pages_.push_back(pageAfter(page_));
        used_ = 0;
    }

    MeasuringCanvas measure_;
    BookPage page_;
    QRectF content_;
    double scale_;
    std::vector<BookPage> pages_;
    double used_ = 0;
};

}  // namespace

MeasuringCanvas::MeasuringCanvas() : image_(1, 1, QImage::Format_RGB32), painter_(&image_) {}
MeasuringCanvas::~MeasuringCanvas() = default;

QString describeToday() {
    const QDate day = QDate::currentDate();
    return describeDates({std::chrono::year{day.year()}, std::chrono::month{unsigned(day.month())},
                          std::chrono::day{unsigned(day.day())}});
}

namespace {

constexpr std::array languageChoices{
    Choice<Language>{Language::system, "window", NM_TEXT("That of the window")},
    Choice<Language>{Language::english, "en", "English"}, Choice<Language>{Language::german, "de", "Deutsch"},
    Choice<Language>{Language::spanish, "es", "Español"},
    Choice<Language>{Language::japanese, "ja", "日本語"}};

}  // namespace

const Fields<BookSettings>& scaleFields() {
    static const Fields<BookSettings> fields{
        field(&BookSettings::scale,
              {.key = "scale",
               .flag = "--scale",
               .label = NM_TEXT("Scale of diagrams"),
               .help = NM_TEXT("Scale of diagrams and elevations: 2000 for 1:2000 (default: a round one that "
                               "fits)"),
               .hint = "NUMBER",
               .range = ValueRange{BookSettings::minScale, BookSettings::maxScale},
               .role = SettingRole::none})};
    return fields;
}

const Fields<BookSettings>& bookFields() {
    static const Fields<BookSettings> fields{
        field(&BookSettings::allPages,
              {.key = "all_pages",
               .flag = "--all-pages",
               .label = NM_TEXT("Everything in full"),
               .help = NM_TEXT("Sheets: all tables, maps, elevations and timelines in full, on as many pages "
                               "as that takes (default: at most 30 pages, with what changes most and what "
                               "fails or is borderline)"),
               .role = SettingRole::none}),
        field(&BookSettings::heightMap,
              {.key = "height_map",
               .flag = "--height-map",
               .label = NM_TEXT("Map of sources of heights"),
               .help = NM_TEXT("Sheets: a page with the buildings coloured by where their heights come from: "
                               "measured, from storeys, assumed, of a 3D model, designed"),
               .role = SettingRole::none}),
        choiceField(&BookSettings::language, languageChoices,
                    {.key = "language",
                     .flag = "--language",
                     .label = NM_TEXT("Language of sheets"),
                     .help = NM_TEXT("Language of the texts, numbers and dates of sheets: en, de, es or ja "
                                     "(default: that of the window, English on the command line). Files for "
                                     "programs are the same in every language"),
                     .hint = "LANGUAGE",
                     .role = SettingRole::none})};
    return fields;
}

const Fields<BookSettings>& extentFields() {
    static const Fields<BookSettings> fields{
        field(&BookSettings::minPlaceM2,
              {.key = "least_place_m2",
               .flag = "--least-place",
               .label = NM_TEXT("Smallest place"),
               .help = NM_TEXT("Sheets of places: smaller places without a name are listed together, "
                               "under the place that they lie in or by kind"),
               .hint = "M2",
               .unit = "m2",
               .range = ValueRange{0, 1e6},
               .role = SettingRole::none})};
    return fields;
}

Language statedLanguage(Language language) {
    const Language stated = language == Language::system ? languageInUse() : language;
    return stated == Language::english ? Language::system : stated;
}

Book beginBook(const BookSettings& settings, const QString& title, const std::string& attribution) {
    const std::string& date = settings.titleBlock.date;
    return {settings.setup,
            settings.titleBlock,
            title,
            date.empty() ? describeToday() : plainText(date),
            describeData(attribution),
            settings.units,
            {},
            settings.language,
            {}};
}

QString sheetNumber(const Book& book, std::size_t index) {
    return plainText(book.titleBlock.sheetPrefix) + QString::number(index + 1);
}

std::vector<TextBlocks> flowText(const TextBlocks& blocks, const QSizeF& sizePt, double points) {
    TextFlow flow(sizePt, points);
    for (const TextBlock& block : blocks) flow.add({block.kind, plainLines(block.text)});
    return flow.finish();
}

namespace {

double sumWidths(const std::vector<double>& widths) {
    return std::accumulate(widths.begin(), widths.end(), 0.0);
}

// The widest are narrowed to one width.
void narrowWidest(std::vector<double>& widths, double widthPt) {
    double maximum = *std::ranges::max_element(widths);
    const std::vector<double> wanted = widths;
    while (sumWidths(widths) > widthPt && maximum > 12) {
        maximum -= 1;
        for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::min(wanted[i], maximum);
    }
    if (sumWidths(widths) > widthPt)
        for (double& width : widths) width = widthPt / double(widths.size());
}

// What words leave goes to the columns with the longest texts: a name is in all rows, a title in one.
std::vector<double> shareWidth(const std::vector<ColumnNeed>& needs, double widthPt) {
    std::vector<double> widths, wholes;
    for (const ColumnNeed& need : needs) {
        widths.push_back(need.word);
        wholes.push_back(need.whole);
    }
    if (sumWidths(widths) > widthPt) {  // words are broken
        narrowWidest(wholes, widthPt);
        return wholes;
    }
    constexpr int rounds = 4;  // what a column does not need is shared again
    for (int round = 0; round < rounds; ++round) {
        double wanted = 0;
        for (std::size_t i = 0; i < needs.size(); ++i)
            if (widths[i] < needs[i].whole) wanted += needs[i].mean;
        const double spare = widthPt - sumWidths(widths);
        for (std::size_t i = 0; i < needs.size() && wanted > 0; ++i)
            if (widths[i] < needs[i].whole)
                widths[i] = std::min(needs[i].whole, widths[i] + spare * needs[i].mean / wanted);
    }
    return widths;
}

}  // namespace

std::vector<double> fitColumns(const PageTable& table, double widthPt) {
    MeasuringCanvas measure;
    std::vector<ColumnNeed> needs;
    std::vector<double> widths;
    for (std::size_t i = 0; i < table.titles.size(); ++i) {
        needs.push_back(measureColumn(measure.canvas(), table, i));
        widths.push_back(needs.back().whole);
    }
    if (sumWidths(widths) > widthPt) return shareWidth(needs, widthPt);
    const double spare = widthPt - sumWidths(widths);
    for (double& width : widths)  // the rows end where the page does, but short tables are not torn apart
        width += std::min(spare / double(widths.size()), 0.35 * width);
    return widths;
}

double tableHeightPt(const PageTable& table) {
    MeasuringCanvas measure;
    const Canvas canvas = measure.canvas();
    double height = rowHeight(canvas, table, table.titles, true);
    for (const auto& row : table.rows) height += rowHeight(canvas, table, row, false);
    return height / canvas.point;
}

std::vector<PageTable> flowTable(const PageTable& table, double firstPt, double otherPt) {
    MeasuringCanvas measure;
    const Canvas canvas = measure.canvas();
    const double titles = rowHeight(canvas, table, table.titles, true) / canvas.point;
    const PageTable blank{table.titles, table.widthsPt, {}, {}, table.points};
    std::vector<PageTable> tables{blank};
    double left = firstPt - titles;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const double height = rowHeight(canvas, table, table.rows[i], false) / canvas.point;
        if (height > left && (!tables.back().rows.empty() || tables.size() == 1)) {
            tables.push_back(blank);
            left = otherPt - titles;
        }
        tables.back().rows.push_back(table.rows[i]);
        if (i < table.marks.size()) tables.back().marks.push_back(table.marks[i]);
        left -= height;
    }
    return tables;
}

namespace {

std::vector<BookPage> layOutText(const PageSetup& setup, const BookPage& page, const TextBlocks& blocks,
                                 double points) {
    const QRectF content = contentArea(setup);
    const double scale = textScale(setup), gutter = gutterPt * scale;
    const int columns = std::max(1, int((content.width() + gutter) / (minColumnPt * scale + gutter)));
    const double width = (content.width() - (columns - 1) * gutter) / columns;
    const auto flowed = flowText(blocks, {width, content.height()}, points * scale);
    std::vector<BookPage> pages;
    for (std::size_t i = 0; i < flowed.size(); ++i) {
        if (i % std::size_t(columns) == 0) pages.push_back(i == 0 ? page : pageAfter(page));
        const QRectF area(content.left() + double(i % std::size_t(columns)) * (width + gutter), content.top(),
                          width, content.height());
        pages.back().items.push_back({area, PageText{flowed[i], points * scale}});
    }
    return pages;
}

}  // namespace

// A little smaller where that saves a last page of some lines.
std::vector<BookPage> makeTextPages(const PageSetup& setup, const BookPage& page, const TextBlocks& blocks) {
    std::vector<BookPage> pages = layOutText(setup, page, blocks, textPt);
    for (const double smaller : {0.96, 0.92}) {
        if (pages.size() < 2) break;
        auto fewer = layOutText(setup, page, blocks, textPt * smaller);
        if (fewer.size() < pages.size()) return fewer;
    }
    return pages;
}

std::vector<PageItem> takeTables(std::vector<NamedTable>& tables, const QRectF& area, double scale) {
    MeasuringCanvas measure;
    std::vector<PageItem> items;
    double top = area.top();
    std::size_t taken = 0;
    for (NamedTable& named : tables) {
        named.table.widthsPt = fitColumns(named.table, area.width());
        const TextBlocks title = titleOf(named);
        const double titlePt = heightPt(measure.canvas(), title, area.width(), textPt * scale) + 1;
        const double tablePt = tableHeightPt(named.table);
        if (top + titlePt + tablePt > area.bottom()) break;
        items.push_back({{area.left(), top, area.width(), titlePt}, PageText{title, textPt * scale}});
        items.push_back({{area.left(), top + titlePt, area.width(), tablePt}, std::move(named.table)});
        top += titlePt + tablePt + gutterPt * scale;
        ++taken;
    }
    tables.erase(tables.begin(), tables.begin() + std::ptrdiff_t(taken));
    return items;
}

std::vector<BookPage> makeTablePages(const PageSetup& setup, const BookPage& page,
                                     std::vector<NamedTable> tables) {
    TablePages pages(setup, page);
    for (NamedTable& table : tables) pages.add(std::move(table));
    return pages.finish();
}

}  // namespace noonmark
