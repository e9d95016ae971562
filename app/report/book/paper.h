#pragma once

#include <QPageSize>
#include <QRectF>
#include <array>
#include <optional>
#include <string_view>

#include "core/describe/field.h"

namespace noonmark {

enum class Paper { a4, a3, a1, letter, tabloid };
inline constexpr std::array papers{Paper::a4, Paper::a3, Paper::a1, Paper::letter, Paper::tabloid};

/// "A4", "A3", "A1", "Letter", "Tabloid"
std::string_view nameOf(Paper paper);
/// The paper of that name, in any case; nothing for any other text.
std::optional<Paper> parsePaper(std::string_view name);

struct PageSetup {
    Paper paper = Paper::a4;
    bool landscape = false;
    bool operator==(const PageSetup&) const = default;
};

const Fields<PageSetup>& pageFields();

QPageSize pageSizeOf(Paper paper);  ///< upright

// Lengths are in points (1/72 inch) from the top left corner of the page.

QSizeF sizePt(const PageSetup& setup);
/// How much larger text and lines are than on A4: large paper is read from farther away.
double textScale(const PageSetup& setup);
/// The line around the page. The left margin is wide enough for holes.
QRectF frameArea(const PageSetup& setup);
/// Inside the frame, along its bottom.
QRectF titleBlockArea(const PageSetup& setup);
/// The title of a page, at the top of the frame.
QRectF headingArea(const PageSetup& setup);
/// What is left for the items of a page.
QRectF contentArea(const PageSetup& setup);

/// Points on paper for a metre on the ground at 1:`scale`: 1:2000 makes 0.5 mm of it.
constexpr double pointsPerMetre(double scale) { return 72 / 0.0254 / scale; }

}  // namespace noonmark
