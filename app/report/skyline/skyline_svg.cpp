#include "app/report/skyline/skyline_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>

#include "core/base/safe_text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/text/point_text.h"

namespace noonmark {

namespace {

constexpr int widthPx = skylineSvgWidthPx, upperPx = 1010;  // without carpets
constexpr int carpetPx = 300;
constexpr std::array colours{"#4e79a7", "#f28e2b", "#59a14f", "#b07aa1", "#76b7b2",
                             "#9c755f", "#edc948", "#d37295", "#86bcb6", "#8cd17d"};
constexpr const char* otherBuildings = "#a3a9b0";
constexpr const char* addedByScenario = "#d62728";

/// The part of the skyline that a building hides.
struct Obstacle {
    std::uint32_t building = 0;
    double widthDeg = 0;
};

std::vector<Obstacle> widestObstacles(const PointStudy& study) {
    std::vector<Obstacle> obstacles;
    for (const auto& [building, width] : skylineWidthsDeg(study.baseline, study.question.facingDeg))
        obstacles.push_back({building, width});
    std::ranges::stable_sort(obstacles, std::ranges::greater{}, &Obstacle::widthDeg);
    if (obstacles.size() > colours.size()) obstacles.resize(colours.size());
    return obstacles;
}

// The 21st of the month, or the last day before it that the period has.
std::optional<std::size_t> dayOfMonth(const SunSteps& sun, unsigned month) {
    std::optional<std::size_t> found;
    for (std::size_t day = 0; day < sun.days.size(); ++day) {
        const CivilDate date = sun.days[day].date;
        if (unsigned(date.month()) == month && unsigned(date.day()) <= 21) found = day;
    }
    return found;
}

/// Puts the parts of the drawing together.
class SkylineSheet {
public:
    SkylineSheet(const PointStudy& study, const City& city, const Zone& zone)
        : study_(study), city_(city), zone_(zone), obstacles_(widestObstacles(study)) {
        for (std::size_t i = 0; i < obstacles_.size(); ++i) colours_[obstacles_[i].building] = colours[i];
    }

    std::string make() {
        begin();
        drawFrame({SkyFrame::Kind::cylindrical, {60, 420}, 1100, 340});
        drawFrame({SkyFrame::Kind::stereographic, {290, 740}, 1, 220});
        addLegend();
        addCarpets();
        svg_ += "</svg>\n";
        return std::move(svg_);
    }

private:
    void addText(double x, double y, std::string_view text, const char* style = "") {
        fmt::format_to(std::back_inserter(svg_), "<text x=\"{:.0f}\" y=\"{:.0f}\" {}>{}</text>\n", x, y,
                       style, escapeXml(text));
    }

    void begin() {
        svg_ = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
            "font-family=\"sans-serif\" font-size=\"12\">\n"
            "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
            widthPx, upperPx + carpetPx * int(carpets().size()));
        const PointQuestion& question = study_.question;
        const std::string facing =
            question.facingDeg ? fmt::format(", facing {:.0f} degrees", *question.facingDeg) : "";
        addText(60, 28,
                fmt::format("Sky at {:.6f}, {:.6f}{}", question.at.lonDeg, question.at.latDeg, facing),
                "font-size=\"18\"");
        addText(60, 48, describe(study_, city_));
    }

    void drawFrame(const SkyFrame& frame) {
        SkyDrawing drawing(frame, svg_);
        drawing.drawSky();
        if (const auto& crowns = shownView().crowns) drawing.drawCrowns(*crowns);
        if (study_.scenario) drawing.drawSkyline(*study_.scenario, {}, addedByScenario);
        drawing.drawSkyline(study_.baseline, colours_, otherBuildings);
        drawing.drawOverhangs(shownView());
        if (study_.scenario) drawing.drawOutline(*study_.scenario, addedByScenario);
        if (study_.question.facingDeg) drawing.drawBehindWall(*study_.question.facingDeg);
        drawPaths(drawing);
        drawDirections(frame, drawing);
    }

    [[nodiscard]] const PointView& shownView() const {
        return study_.scenario ? *study_.scenario : study_.baseline;
    }

    void drawPaths(SkyDrawing& drawing) {
        const ShadedSteps& shaded = shownView().shaded;
        for (const unsigned month : {12U, 1U, 2U, 3U, 4U, 5U, 6U})
            if (const auto day = dayOfMonth(study_.sun, month)) {
                drawing.drawPath(study_.sun, shaded, *day, "#e0a000");
                if (month == 12 || month == 3 || month == 6) drawing.drawHours(study_.sun, *day, zone_);
            }
        drawing.drawPath(study_.sun, shaded, study_.day, "#c2185b");
    }

    void drawDirections(const SkyFrame& frame, SkyDrawing& drawing) {
        const bool flat = frame.kind == SkyFrame::Kind::cylindrical;
        constexpr std::array names{"N", "NE", "E", "SE", "S", "SW", "W", "NW", "N"};
        for (std::size_t i = 0; i < (flat ? names.size() : names.size() - 1); ++i) {
            const glm::dvec2 at = frame.at(45.0 * double(i), 0);
            const glm::dvec2 out = flat ? glm::dvec2(0, 15) : (at - frame.corner) * 0.06 + glm::dvec2(0, 4);
            addText(at.x + out.x, at.y + out.y, names[i], "text-anchor=\"middle\"");
        }
        for (int altitude = 10; altitude < 90; altitude += flat ? 10 : 20)
            drawing.drawLabel(flat ? 0 : 180, altitude, fmt::format("{}", altitude), flat ? "end" : "middle");
    }

    void addSwatch(double y, const std::string& fill, const std::string& text) {
        fmt::format_to(std::back_inserter(svg_),
                       "<rect x=\"600\" y=\"{:.0f}\" width=\"18\" height=\"12\" fill=\"{}\"/>\n", y - 10,
                       fill);
        addText(626, y, text);
    }

    void addLegend() {
        double y = 500;
        addText(600, y, "What makes the skyline", "font-size=\"14\"");
        for (const Obstacle& obstacle : obstacles_)
            addSwatch(y += 20, colours_[obstacle.building],
                      fmt::format("{}: {:.0f} degrees", nameOfObstacle(city_, obstacle.building),
                                  obstacle.widthDeg));
        addSwatch(y += 20, otherBuildings, "other buildings");
        if (!study_.baseline.overhangs.empty()) addSwatch(y += 20, overhangFill, "overhangs");
        if (const auto& crowns = shownView().crowns)
            addSwatch(y += 20, crownFill,
                      fmt::format("trees, as dense as on the day ({})",
                                  crowns->inLeaf ? "in leaf" : "those that lose their leaves are bare"));
        if (study_.question.facingDeg) addSwatch(y += 20, behindWallFill, "behind the wall");
        if (study_.scenario) addSwatch(y += 20, addedByScenario, "hidden by the scenario alone");
        addPathKeys(y + 30);
    }

    void addPathKeys(double y) {
        addSwatch(y, "#e0a000",
                  "the sun on the 21st of December to June, from below; thick: the point is lit");
        addSwatch(y + 20, "#c2185b", fmt::format("the sun on {}", formatText(study_.question.day)));
        addText(600, y + 44,
                fmt::format("Hours are those of {}. Azimuths are from true north. In the circle, "
                            "the sky is seen",
                            zone_.name()));
        addText(600, y + 60, "from above (stereographic): east is on the right, the zenith in the middle.");
        const PointView& view = study_.baseline;
        std::string factors = fmt::format("Sky view factor {:.3f}", view.factors.skyView);
        if (study_.question.facingDeg)
            factors += fmt::format(", vertical sky component {:.1f} %", view.factors.skyComponentPct);
        if (study_.scenario)
            factors += fmt::format("; in the scenario {:.3f}", study_.scenario->factors.skyView);
        addText(600, y + 84, factors);
        if (const auto& crowns = shownView().crowns) {
            constexpr const char* small = "font-size=\"10\"";  // the longest texts
            addText(600, y + 104, "Sun with trees: " + treesText(*crowns), small);
            addText(600, y + 124,
                    "Sky with trees: " + treesSkyText(*crowns, study_.question.facingDeg.has_value()), small);
        }
    }

    // Those with trees where any is seen in one of the cities.
    [[nodiscard]] std::vector<TreeColumns> carpets() const {
        if (!study_.baseline.crowns && !(study_.scenario && study_.scenario->crowns))
            return {TreeColumns::without};
        return {TreeColumns::without, TreeColumns::evergreen, TreeColumns::seasonal};
    }

    void addCarpets() {
        const std::vector<TreeColumns> columns = carpets();
        int y = upperPx;
        for (const TreeColumns trees : columns) {
            std::string title = study_.scenario
                                    ? "Minutes of sun on a mean day with the scenario, by month and hour of "
                                      "the clock; in red and green what it takes and gives"
                                    : "Minutes of sun on a mean day, by month and hour of the clock";
            if (columns.size() > 1) title += fmt::format(" ({})", describeTrees(trees));
            addText(60, y, title, "font-size=\"14\"");
            drawSunCarpet(study_, trees, {90, double(y) + 30}, svg_);
            y += carpetPx;
        }
    }

    const PointStudy& study_;
    const City& city_;
    const Zone& zone_;
    std::vector<Obstacle> obstacles_;
    BuildingColours colours_;
    std::string svg_;
};

}  // namespace

std::string skylineSvg(const PointStudy& study, const City& city, const Zone& zone) {
    return SkylineSheet(study, city, zone).make();
}

}  // namespace noonmark
