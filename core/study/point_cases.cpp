#include "core/study/point_cases.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/city/city_position.h"
#include "core/receivers/points/solid_parts.h"

namespace noonmark {

namespace {

PointCaseShade shadeOf(TreeColumns column, const PointShade& of) {
    PointCaseShade shade{column, of.dayMin, 0, of.sky.skyView, of.sky.skyComponentPct};
    for (const double minutes : sumMonths(of.minutes)) shade.yearMin += minutes;
    return shade;
}

PointCaseFigures figuresOf(const std::string& name, const PointStudy& study) {
    PointCaseFigures figures{.name = name,
                             .skyView = study.baseline.factors.skyView,
                             .skyComponentPct = study.baseline.factors.skyComponentPct};
    for (const SunBand& band : study.baseline.sunlit) figures.dayMin += band.minutes();
    for (const double minutes : sumMonths(study.baseline.minutes)) figures.yearMin += minutes;
    if (const auto& crowns = study.baseline.crowns)
        for (const TreeColumns column : PointCrowns::columns)
            figures.withTrees.push_back(shadeOf(column, crowns->of(column)));
    return figures;
}

// Where no tree is seen, columns with trees are that without.
PointCaseShade shadeOf(const PointCaseFigures& figures, TreeColumns column) {
    for (const PointCaseShade& with : figures.withTrees)
        if (with.column == column) return with;
    return {column, figures.dayMin, figures.yearMin, figures.skyView, figures.skyComponentPct};
}

}  // namespace

std::vector<PointCaseLine> listCaseLines(const PointCaseFigures& figures, const PointCaseFigures& first) {
    std::vector<TreeColumns> columns{TreeColumns::without};
    for (const PointCaseFigures* one : {&first, &figures})
        for (const PointCaseShade& with : one->withTrees)
            if (std::ranges::find(columns, with.column) == columns.end()) columns.push_back(with.column);
    std::vector<PointCaseLine> lines;
    for (const TreeColumns column : columns) {
        const PointCaseShade shade = shadeOf(figures, column);
        lines.push_back({shade, shade.yearMin - shadeOf(first, column).yearMin});
    }
    return lines;
}

Result<std::vector<PointCaseFigures>> measurePointCases(const std::vector<PointScenario>& cases,
                                                        const PointQuestion& question,
                                                        const std::stop_token& stop) {
    std::vector<PointCaseFigures> measured;
    std::optional<glm::vec3> position;
    for (const PointScenario& one : cases) {
        if (stop.stop_requested()) return cancelled();
        const auto study = runPointStudy(*one.city, nullptr, question, stop);
        if (!study && (!position || isCancelled(study.error()))) return tl::make_unexpected(study.error());
        if (!study)
            measured.push_back({.name = one.name, .why = study.error().what});
        else if (position && study->position != *position)
            measured.push_back({.name = one.name, .why = "The scenario builds where the point is"});
        else
            measured.push_back(figuresOf(one.name, *study));
        if (!position) position = study->position;
    }
    return measured;
}

namespace {

constexpr std::size_t widestGapDays = 3;

struct DayLoss {
    std::vector<int> clockMinutes;  // of the steps taken
};

std::vector<DayLoss> lossesByDay(const ShadedSteps& before, const ShadedSteps& after, const SunSteps& sun,
                                 const Zone& zone) {
    std::vector<DayLoss> losses(sun.days.size());
    for (std::size_t day = 0; day < losses.size(); ++day)
        for (std::uint32_t i = sun.days[day].first; i < sun.days[day].first + sun.days[day].count; ++i) {
            if (before[i] != 0 || after[i] == 0) continue;
            const auto at = std::chrono::floor<std::chrono::seconds>(sun.steps[i].at);
            const auto clock = (at + zone.offsetAt(at)).time_since_epoch() % std::chrono::days(1);
            losses[day].clockMinutes.push_back(int(std::chrono::floor<std::chrono::minutes>(clock).count()));
        }
    return losses;
}

SeasonOfLoss seasonOf(const std::vector<DayLoss>& losses, std::size_t first, std::size_t last,
                      const SunSteps& sun) {
    std::vector<int> clock;
    SeasonOfLoss season{.first = sun.days[first].date, .last = sun.days[last].date};
    for (std::size_t day = first;; day = (day + 1) % losses.size()) {
        const auto& minutes = losses[day].clockMinutes;
        clock.insert(clock.end(), minutes.begin(), minutes.end());
        season.days += minutes.empty() ? 0 : 1;
        if (day == last) break;
    }
    std::ranges::sort(clock);
    season.minutesPerDay = double(clock.size()) * sun.stepMinutes / season.days;
    season.mostlyFrom = std::chrono::minutes(clock[clock.size() / 10]);
    season.mostlyTo = std::chrono::minutes(clock[clock.size() - 1 - clock.size() / 10] + 1);
    return season;
}

// A day with losses after more than the widest gap without.
bool beginsSeason(const std::vector<DayLoss>& losses, std::size_t day) {
    if (losses[day].clockMinutes.empty()) return false;
    for (std::size_t back = 1; back <= std::min(widestGapDays + 1, losses.size() - 1); ++back)
        if (!losses[(day + losses.size() - back) % losses.size()].clockMinutes.empty()) return false;
    return true;
}

std::size_t endOfSeason(const std::vector<DayLoss>& losses, std::size_t first) {
    std::size_t last = first;
    for (std::size_t day = first + 1; day < first + losses.size() && day - last <= widestGapDays + 1; ++day)
        if (!losses[day % losses.size()].clockMinutes.empty()) last = day;
    return last % losses.size();
}

}  // namespace

std::vector<SeasonOfLoss> findLosses(const ShadedSteps& before, const ShadedSteps& after, const SunSteps& sun,
                                     const Zone& zone) {
    const std::vector<DayLoss> losses = lossesByDay(before, after, sun, zone);
    const bool any =
        std::ranges::any_of(losses, [](const DayLoss& day) { return !day.clockMinutes.empty(); });
    std::vector<SeasonOfLoss> seasons;
    for (std::size_t day = 0; day < losses.size(); ++day)
        if (beginsSeason(losses, day))
            seasons.push_back(seasonOf(losses, day, endOfSeason(losses, day), sun));
    if (any && seasons.empty()) seasons.push_back(seasonOf(losses, 0, losses.size() - 1, sun));
    std::ranges::sort(seasons, std::ranges::greater(),
                      [](const SeasonOfLoss& season) { return season.minutesPerDay * season.days; });
    return seasons;
}

namespace {

bool touches(const Part& part, glm::dvec2 place) {
    const Box2 box = bounds(part.footprint);
    return place.x >= double(box.low.x) && place.x <= double(box.high.x) && place.y >= double(box.low.y) &&
           place.y <= double(box.high.y) && contains(part.footprint, place);
}

// The highest surface of a mesh above a place; none where it has none.
std::optional<double> topOf(const TriangleMesh& mesh, glm::dvec2 place) {
    std::optional<double> top;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        const glm::dvec2 ab(b - a), ac(c - a), ap = place - glm::dvec2(a);
        const double turn = ab.x * ac.y - ab.y * ac.x;
        if (std::abs(turn) < 1e-9) continue;
        const double u = (ap.x * ac.y - ap.y * ac.x) / turn, v = (ab.x * ap.y - ab.y * ap.x) / turn;
        if (u < 0 || v < 0 || u + v > 1) continue;
        top = std::max(top.value_or(-1e30), a.z + u * (b.z - a.z) + v * (c.z - a.z));
    }
    return top;
}

/// The building whose roof is highest above a place.
struct RoofAbove {
    double topM = -1e30;
    const Building* building = nullptr;
};

RoofAbove findRoof(const City& city, glm::dvec2 place) {
    RoofAbove roof;
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts) {
            if (part.isOverhanging || !touches(part, place)) continue;
            const double top = part.mesh ? topOf(*part.mesh, place).value_or(-1e30) : double(part.topM);
            if (top > roof.topM) roof = {top, building.get()};
        }
    return roof;
}

glm::vec3 normalOf(const PointQuestion& question, const Observer& observer) {
    if (!question.facingDeg) return {0, 0, 1};
    const glm::dvec3 local = observer.frameFromPlace * toDirection({*question.facingDeg}, {0});
    return glm::vec3(glm::normalize(glm::dvec3(local.x, local.y, 0)));
}

std::string nameOf(const Building& building) {
    return building.name.empty() ? building.sourceId : building.name;
}

// The overhang that a place is in; null: none.
const Building* findOverhangAt(const City& city, glm::dvec3 place) {
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts)
            if (part.isOverhanging && touches(part, glm::dvec2(place)) && isInside(part, place))
                return building.get();
    return nullptr;
}

}  // namespace

Result<LocatedPoint> settlePoint(const City& city, const PointQuestion& question) {
    const glm::dvec2 place = city.frame.localFromLonLat(question.at);
    const Observer observer = placeObserver(city, place);
    const double ground = double(groundAt(city, place));
    const RoofAbove roof = findRoof(city, place);
    double height = ground + question.heightM.value_or(0);
    const bool onRoof = roof.building != nullptr && (!question.heightM || height >= roof.topM - 0.05);
    if (onRoof) height = std::max(height, roof.topM);
    if (roof.building != nullptr && !onRoof)
        return failure(
            fmt::format("The point is inside the building {}", nameOf(*roof.building)),
            fmt::format("{:.6f},{:.6f}", question.at.lonDeg, question.at.latDeg),
            fmt::format("Choose a point in front of its wall, or {:.1f} m or more above the ground",
                        roof.topM - ground));
    if (const Building* overhang = findOverhangAt(city, {place, height}))
        return failure(fmt::format("The point is inside an overhang of the building {}", nameOf(*overhang)),
                       fmt::format("{:.6f},{:.6f}", question.at.lonDeg, question.at.latDeg),
                       "Choose a height below it or above it");
    return LocatedPoint{{glm::vec3(glm::dvec3(place, height)), normalOf(question, observer)}, onRoof};
}

}  // namespace noonmark
