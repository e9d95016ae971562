#include "app/report/skyline/sun_carpet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace noonmark {

namespace {

constexpr double cellWidthPx = 44, cellHeightPx = 20;
constexpr double minMinutes = 0.5;  // of a mean day; less is not written
constexpr int hours = 24, months = 12;

std::array<int, months> countDays(const SunSteps& sun) {
    std::array<int, months> days{};
    for (const SunDay& day : sun.days) ++days[unsigned(day.date.month()) - 1];
    return days;
}

// From white to a dark yellow.
std::string fillOf(double minutes) {
    const double part = std::min(1.0, minutes / 60);
    return fmt::format("#{:02x}{:02x}{:02x}", int(255 - 20 * part), int(255 - 75 * part),
                       int(255 - 215 * part));
}

void addFigure(std::string& svg, glm::dvec2 at, const char* fill, const std::string& text) {
    fmt::format_to(std::back_inserter(svg),
                   "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"9\" text-anchor=\"middle\" "
                   "fill=\"{}\">{}</text>\n",
                   at.x, at.y, fill, text);
}

void addCell(std::string& svg, glm::dvec2 corner, double before, double after) {
    fmt::format_to(std::back_inserter(svg),
                   "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"{}\" "
                   "stroke=\"#dfe4ea\" stroke-width=\"0.5\"/>\n",
                   corner.x, corner.y, cellWidthPx, cellHeightPx, fillOf(after));
    const double change = after - before;
    const bool changes = std::abs(change) >= minMinutes;
    if (after < minMinutes && !changes) return;
    const double middle = corner.x + (changes ? cellWidthPx * 0.3 : cellWidthPx / 2);
    const double line = corner.y + cellHeightPx / 2 + 3;
    addFigure(svg, {middle, line}, "#1f2933", fmt::format("{:.0f}", after));
    if (changes)
        addFigure(svg, {corner.x + cellWidthPx * 0.72, line}, change < 0 ? "#c0141b" : "#1b7a3d",
                  fmt::format("{}{:.0f}", change < 0 ? "\u2212" : "+", std::abs(change)));
}

}  // namespace

void drawSunCarpet(const PointStudy& study, glm::dvec2 corner, std::string& svg) {
    constexpr std::array names{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                               "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    const MonthHours& before = study.baseline.minutes;
    const MonthHours& after = study.scenario ? study.scenario->minutes : before;
    const std::array<int, months> days = countDays(study.sun);
    for (std::size_t hour = 0; hour < hours; ++hour)
        addFigure(svg, corner + glm::dvec2((double(hour) + 0.5) * cellWidthPx, -5), "#1f2933",
                  fmt::format("{}", hour));
    for (std::size_t month = 0; month < months; ++month) {
        const glm::dvec2 row = corner + glm::dvec2(0, double(month) * cellHeightPx);
        addFigure(svg, row + glm::dvec2(-20, cellHeightPx / 2 + 3), "#1f2933", names[month]);
        const double of = std::max(1, days[month]);
        for (std::size_t hour = 0; hour < hours; ++hour)
            addCell(svg, row + glm::dvec2(double(hour) * cellWidthPx, 0), before[month][hour] / of,
                    after[month][hour] / of);
    }
}

}  // namespace noonmark
