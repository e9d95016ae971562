#include "app/report/book/paper.h"

#include <algorithm>
#include <cctype>

#include "core/describe/text.h"

namespace noonmark {

namespace {

constexpr std::array<Choice<Paper>, papers.size()> paperChoices{{{Paper::a4, "A4"},
                                                                 {Paper::a3, "A3"},
                                                                 {Paper::a1, "A1"},
                                                                 {Paper::letter, "Letter"},
                                                                 {Paper::tabloid, "Tabloid"}}};
constexpr double marginPt = 22;
constexpr double bindingPt = 36;  // left
constexpr double titleBlockPt = 50;
constexpr double headingPt = 36;
constexpr double paddingPt = 10;
constexpr double creditPt = 11;

bool equalInAnyCase(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::string_view nameOf(Paper paper) { return keyOf<Paper>(paperChoices, paper); }

std::optional<Paper> parsePaper(std::string_view name) {
    for (const Paper paper : papers)
        if (equalInAnyCase(name, nameOf(paper))) return paper;
    return std::nullopt;
}

const Fields<PageSetup>& pageFields() {
    static const Fields<PageSetup> fields{
        choiceField(&PageSetup::paper, paperChoices,
                    {.key = "paper",
                     .flag = "--paper",
                     .label = NM_TEXT("Paper"),
                     .help = NM_TEXT("Paper of the sheets: A4, A3, A1, Letter or Tabloid"),
                     .hint = "PAPER",
                     .role = SettingRole::none,
                     .restated = true}),
        field(&PageSetup::landscape, {.key = "landscape",
                                      .flag = "--landscape",
                                      .label = NM_TEXT("Landscape"),
                                      .help = NM_TEXT("Sheets are wider than high"),
                                      .role = SettingRole::none})};
    return fields;
}

QPageSize pageSizeOf(Paper paper) {
    switch (paper) {
        case Paper::a3:
            return QPageSize(QPageSize::A3);
        case Paper::a1:
            return QPageSize(QPageSize::A1);
        case Paper::letter:
            return QPageSize(QPageSize::Letter);
        case Paper::tabloid:
            return QPageSize(QPageSize::Tabloid);
        case Paper::a4:
            break;
    }
    return QPageSize(QPageSize::A4);
}

QSizeF sizePt(const PageSetup& setup) {
    const QSizeF size = pageSizeOf(setup.paper).size(QPageSize::Point);
    return setup.landscape == (size.width() > size.height()) ? size : size.transposed();
}

double textScale(const PageSetup& setup) {
    switch (setup.paper) {
        case Paper::a3:
        case Paper::tabloid:
            return 1.15;
        case Paper::a1:
            return 1.7;
        case Paper::a4:
        case Paper::letter:
            break;
    }
    return 1;
}

QRectF frameArea(const PageSetup& setup) {
    const QSizeF size = sizePt(setup);
    return {bindingPt, marginPt, size.width() - bindingPt - marginPt, size.height() - 2 * marginPt};
}

QRectF titleBlockArea(const PageSetup& setup) {
    const QRectF frame = frameArea(setup);
    const double height = titleBlockPt * textScale(setup);
    return {frame.left(), frame.bottom() - height, frame.width(), height};
}

QRectF headingArea(const PageSetup& setup) {
    const double padding = paddingPt * textScale(setup);
    const QRectF inside = frameArea(setup).adjusted(padding, padding, -padding, 0);
    return {inside.left(), inside.top(), inside.width(), headingPt * textScale(setup)};
}

QRectF contentArea(const PageSetup& setup) {
    const double scale = textScale(setup);
    const QRectF heading = headingArea(setup);
    const double top = heading.bottom() + 4 * scale;
    const double bottom = titleBlockArea(setup).top() - (creditPt + 4) * scale;
    return {heading.left(), top, heading.width(), bottom - top};
}

}  // namespace noonmark
