#include <QStringList>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/report/book/flow.h"
#include "app/report/book/review/review_pages.h"
#include "app/report/maps/answer_legends.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/study_text.h"
#include "core/measures/places/place_run.h"
#include "core/receivers/place_names.h"
#include "core/study/prepare_review.h"
#include "core/study/shadow_drawings.h"

namespace noonmark {

namespace {

constexpr int maxHoursADay = 6;
constexpr float minSunDeg = 0.5F;  // shadows of a lower sun leave every page
constexpr double farthestM = 1500;
constexpr float marginM = 12, placeMarginM = 4;
constexpr std::array roundScales{500.0,  1000.0, 1250.0, 1500.0, 2000.0, 2500.0,
                                 3000.0, 4000.0, 5000.0, 6000.0, 7500.0, 10000.0};
constexpr double readableScale = 7500;  // smaller ones are taken where nothing else holds what is needed
constexpr double maxKeyShare = 0.16;    // of the page

SunStep sunAt(const Observer& observer, Instant at) {
    const SolarPosition sun = computeSolarPosition(observer, at);
    const glm::dvec3 direction = observer.frameFromPlace * toDirection(sun.azimuth, sun.altitudeApparent);
    return {glm::vec3(direction), float(sun.azimuth.value), float(sun.altitudeApparent.value), 0, at};
}

Box2 grown(Box2 box, float by) {
    if (box.empty()) return box;
    return {box.low - by, box.high + by};
}

Box2 changedBounds(const DiagramScene& scene) {
    Box2 box;
    for (const City* city : {&scene.proposal, &scene.removed})
        for (const auto& building : city->buildings) box.add(bounds(*building));
    return box;
}

/// Where the shadow of a roof ends, as far from its building as farthestM. The ground may fall.
glm::dvec2 shiftOf(const City& city, const Building& building, const glm::vec3& direction) {
    const glm::dvec3 sun(direction);
    const Box2 box = bounds(building);
    const glm::dvec2 foot = glm::dvec2(box.low + box.high) / 2.0;
    double groundM = double(groundAt(city, foot));
    glm::dvec2 shift{};
    for (int i = 0; i < 2; ++i) {
        shift = -glm::dvec2(sun) / sun.z * std::max(0.0, double(topM(building)) - groundM);
        if (const double length = glm::length(shift); length > farthestM) shift *= farthestM / length;
        groundM = std::min(groundM, double(groundAt(city, foot + shift)));
    }
    return shift;
}

/// The shadow of what changes at a moment, with what casts it.
Box2 sweepOf(const DiagramScene& scene, const DiagramMoment& moment) {
    Box2 swept;
    for (const City* city : {&scene.proposal, &scene.removed})
        for (const auto& building : city->buildings) {
            const Box2 box = bounds(*building);
            if (box.empty()) continue;
            const glm::vec2 shift(shiftOf(scene.city, *building, moment.sun.direction));
            for (const glm::vec2 by : {glm::vec2(0), shift})
                swept.add(box.low + by), swept.add(box.high + by);
        }
    return swept;
}

Box2 intersectionOf(const Box2& a, const Box2& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

Box2 unionOf(Box2 a, const Box2& b) {
    if (!b.empty()) a.add(b);
    return a;
}

bool meet(const Box2& a, const Box2& b) { return !intersectionOf(a, b).empty(); }

/// The places in the rows of the sheets that meet a box, each whole; of one that is much larger than the box,
/// what lies in it.
Box2 placesIn(const ReviewScene& scene, const Box2& box) {
    constexpr float largest = 2;  // times the box
    Box2 places;
    const glm::vec2 room = largest * (box.high - box.low);
    for (const PlaceRow& row : scene.list.rows)
        for (const std::size_t i : row.reviews) {
            const Box2 place = bounds(scene.diagrams->places[placeOf(scene.source.study, i)]);
            if (!meet(place, box)) continue;
            const Box2 both = unionOf(place, box);
            const glm::vec2 size = both.high - both.low;
            const bool isWhole = size.x <= room.x && size.y <= room.y;
            places = unionOf(places, isWhole ? grown(place, placeMarginM) : intersectionOf(place, box));
        }
    return places;
}

/// What changes, the places that its shadows reach, and the shadows that reach any of them.
Box2 touchingOf(const ReviewScene& scene, const std::vector<DiagramMoment>& moments) {
    Box2 touching = focusOf(scene, moments);
    if (changedBounds(*scene.diagrams).empty()) return touching;
    for (const DiagramMoment& moment : moments) {
        const Box2 swept = sweepOf(*scene.diagrams, moment);
        if (!placesIn(scene, swept).empty()) touching = unionOf(touching, grown(swept, marginM));
    }
    return touching;
}

std::vector<QRectF> divide(const QRectF& all, int columns, int rows, double gap) {
    const double width = (all.width() - gap * (columns - 1)) / columns;
    const double height = (all.height() - gap * (rows - 1)) / rows;
    std::vector<QRectF> areas;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            areas.emplace_back(all.left() + column * (width + gap), all.top() + row * (height + gap), width,
                               height);
    return areas;
}

/// Metres of ground that one view of a grid shows.
glm::dvec2 groundOf(const ReviewScene& scene, int columns, int rows, double scale) {
    const QRectF area = diagramAreas(scene, columns, rows).front();
    const QRectF map = mapAreaOf(area, textScale(scene.settings.setup));
    return glm::dvec2(map.width(), map.height()) / pointsPerMetre(scale);
}

bool fits(const Box2& box, glm::dvec2 ground) {
    const glm::dvec2 size(box.high - box.low);
    return size.x <= ground.x && size.y <= ground.y;
}

/// The middle of `wide` where it fits; else as near to it as `narrow` allows.
double middleOf(double wideLow, double wideHigh, double narrowLow, double narrowHigh, double shown) {
    const double wide = (wideLow + wideHigh) / 2;
    if (wideHigh - wideLow <= shown) return wide;
    const double low = narrowHigh - shown / 2, high = narrowLow + shown / 2;
    return low <= high ? std::clamp(wide, low, high) : (narrowLow + narrowHigh) / 2;
}

glm::dvec2 centreOf(const Box2& wide, const Box2& narrow, glm::dvec2 shown) {
    return {middleOf(wide.low.x, wide.high.x, narrow.low.x, narrow.high.x, shown.x),
            middleOf(wide.low.y, wide.high.y, narrow.low.y, narrow.high.y, shown.y)};
}

using DiagramGrid = std::pair<int, int>;

/// The grids of views that a page may have, the densest first: none of whose places most would stay empty.
std::vector<DiagramGrid> gridsOf(const ReviewScene& scene) {
    std::vector<DiagramGrid> grids = scene.settings.setup.landscape
                                         ? std::vector<DiagramGrid>{{3, 2}, {2, 2}, {2, 1}, {1, 1}}
                                         : std::vector<DiagramGrid>{{2, 3}, {2, 2}, {1, 2}, {1, 1}};
    const auto viewsOf = [](const DiagramGrid& grid) { return std::size_t(grid.first * grid.second); };
    while (grids.size() > 1 && viewsOf(grids[1]) >= scene.moments.size()) grids.erase(grids.begin());
    if (scene.settings.allPages || scene.settings.scale) return grids;
    std::erase_if(grids, [&](const DiagramGrid& grid) {
        return (scene.moments.size() + viewsOf(grid) - 1) / viewsOf(grid) > maxDiagramPages;
    });
    if (grids.empty()) return {scene.settings.setup.landscape ? DiagramGrid{4, 3} : DiagramGrid{3, 4}};
    return grids;
}

/// Tries grids and scales.
class LayoutChoice {
public:
    explicit LayoutChoice(const ReviewScene& scene)
        : scene_(scene),
          grids_(gridsOf(scene)),
          changed_(grown(changedBounds(*scene.diagrams), marginM)),
          focus_(focusOf(scene, scene.moments)),
          touching_(touchingOf(scene, scene.moments)),
          all_(unionOf(reachOf(scene, scene.moments), focus_)) {}

    [[nodiscard]] DiagramLayout choose() const {
        if (scene_.settings.scale) return atScale(*scene_.settings.scale);
        for (const Box2* shown : {&all_, &touching_})
            if (const auto layout = fit(*shown, readableScale)) return *layout;
        for (const Box2* shown : {&touching_, &focus_})
            if (const auto layout = fit(*shown, roundScales.back())) return *layout;
        return make(grids_[std::min<std::size_t>(1, grids_.size() - 1)], readableScale,
                    changed_.empty() ? focus_ : changed_);
    }

private:
    [[nodiscard]] DiagramLayout atScale(double scale) const {
        for (const Box2* shown : {&touching_, &focus_})
            for (const DiagramGrid& grid : grids_)
                if (holds(grid, scale, *shown))
                    return make(grid, scale, holds(grid, scale, all_) ? all_ : *shown);
        return make(grids_.back(), scale, changed_.empty() ? focus_ : changed_);
    }

    /// The grid that shows a box with the best of two: a large scale and few pages. Half the pages make up
    /// for a scale of 1:1500 instead of 1:1000.
    [[nodiscard]] std::optional<DiagramLayout> fit(const Box2& shown, double maxScale) const {
        constexpr double weightOfPages = 0.6;
        std::optional<DiagramLayout> best;
        double minCost = 0;
        for (const DiagramGrid& grid : grids_) {
            const auto scale =
                std::ranges::find_if(roundScales, [&](double one) { return holds(grid, one, shown); });
            if (scale == roundScales.end() || *scale > maxScale) continue;
            const double views = double(grid.first * grid.second);
            const double cost =
                *scale * std::pow(std::ceil(double(scene_.moments.size()) / views), weightOfPages);
            if (best && cost >= minCost) continue;
            best = make(grid, *scale, shown);
            minCost = cost;
        }
        return best;
    }

    [[nodiscard]] DiagramLayout make(const DiagramGrid& grid, double scale, const Box2& must) const {
        const glm::dvec2 ground = groundOf(scene_, grid.first, grid.second, scale);
        return {grid.first, grid.second, scale, centreOf(all_, must, ground)};
    }

    [[nodiscard]] bool holds(const DiagramGrid& grid, double scale, const Box2& box) const {
        return fits(box, groundOf(scene_, grid.first, grid.second, scale));
    }

    const ReviewScene& scene_;
    std::vector<DiagramGrid> grids_;
    Box2 changed_, focus_, touching_, all_;
};

/// Heights of texts in points.
double keyHeightPt(const ReviewScene& scene, const QString& text) {
    const double scale = textScale(scene.settings.setup);
    MeasuringCanvas measure;
    return heightOf(measure.canvas(), {body(text)},
                    contentArea(scene.settings.setup).width() * MeasuringCanvas::unitsPerPoint,
                    keyTextPt * scale) /
               MeasuringCanvas::unitsPerPoint +
           1;
}

int badness(Verdict verdict) {
    constexpr std::array best{Verdict::notChecked, Verdict::notApplicable, Verdict::pass, Verdict::borderline,
                              Verdict::fail};
    return int(std::ranges::find(best, verdict) - best.begin());
}

/// Of the worst verdict on each place, as drawn.
std::vector<QColor> colourPlaces(const ReviewBookSource& source) {
    std::vector<Verdict> worst(source.places.size(), Verdict::notChecked);
    for (std::size_t i = 0; i < source.study.places.size(); ++i) {
        Verdict& verdict = worst[placeOf(source.study, i)];
        verdict = std::max(verdict, source.study.places[i].verdict,
                           [](Verdict one, Verdict other) { return badness(one) < badness(other); });
    }
    std::vector<QColor> colours;
    for (const Verdict verdict : worst) colours.push_back(verdictMark(verdict));
    return colours;
}

/// The numbers of the places that are seen, by what the key calls them. Places without a name share an entry.
std::map<QString, std::set<int>> seenNumbers(const ReviewScene& scene, const std::vector<Box2>& seen) {
    std::map<QString, std::set<int>> numbers;
    const auto& places = scene.diagrams->places;
    for (const auto* rows : {&scene.list.rows, &scene.list.others})
        for (const PlaceRow& row : *rows)
            for (const std::size_t i : row.reviews) {
                const Place& place = places[placeOf(scene.source.study, i)];
                const Box2 box = bounds(place);
                if (std::ranges::any_of(seen, [&](const Box2& view) { return meet(box, view); }))
                    numbers[row.reviews.size() > 1 ? row.name : shortName(place)].insert(row.number);
            }
    return numbers;
}

/// "4-9" for three numbers or more that follow each other.
QString joinNumbers(const std::set<int>& numbers) {
    QStringList parts;
    for (auto at = numbers.begin(); at != numbers.end();) {
        const int first = *at;
        int last = first;
        while (++at != numbers.end() && *at == last + 1) ++last;
        if (last > first + 1)
            parts << QStringLiteral("%1-%2").arg(first).arg(last);
        else
            for (int number = first; number <= last; ++number) parts << QString::number(number);
    }
    return parts.join(QStringLiteral(", "));
}

/// The entries of a key, the smallest numbers first.
std::vector<QString> keyEntries(const ReviewScene& scene, const std::vector<Box2>& seen) {
    std::map<std::pair<int, QString>, QString> entries;
    for (const auto& [name, numbers] : seenNumbers(scene, seen))
        entries.emplace(std::pair(*numbers.begin(), name), joinNumbers(numbers) + QChar(0xa0) + name);
    std::vector<QString> texts;
    for (auto& [order, text] : entries) texts.push_back(std::move(text));
    return texts;
}

QString joinKey(const std::vector<QString>& entries, std::size_t count) {
    QString text;
    for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? QStringLiteral("   ") : QString()) + entries[i];
    if (count < entries.size()) text += sheetText("   ... further numbers: see the summary");
    return text;
}

}  // namespace

std::vector<QRectF> diagramAreas(const ReviewScene& scene, int columns, int rows) {
    const PageSetup& setup = scene.settings.setup;
    const double below = diagramFootPt(textScale(setup)) + scene.keyPt;
    return divide(contentArea(setup).adjusted(0, 0, 0, -below), columns, rows, 8 * textScale(setup));
}

QString describeKey(const ReviewScene& scene, const std::vector<Box2>& seen) {
    const std::vector<QString> entries = keyEntries(scene, seen);
    std::size_t count = entries.size();
    while (count > 0 && keyHeightPt(scene, joinKey(entries, count)) > scene.keyPt) --count;
    return joinKey(entries, count);
}

std::vector<QRectF> gridAreas(const PageSetup& setup, int columns, int rows) {
    return divide(contentArea(setup), columns, rows, 12 * textScale(setup));
}

void appendPages(std::vector<BookPage>& to, std::vector<BookPage> pages) {
    std::move(pages.begin(), pages.end(), std::back_inserter(to));
}

QString clockText(const ReviewScene& scene) { return plainText(scene.sun.clock.text()); }

QString treesText(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    if (isEnglishInUse()) return plainText(study.trees);
    return plainText(
        describeCountedTrees(study.rule.occluders.trees, scene.source.scenario, scene.source.baseline));
}

QString dayText(CivilDate day) { return describeDates(day); }

Result<ReviewScene> makeReviewScene(const ReviewBookSource& source, const BookSettings& settings,
                                    const std::stop_token& stop) {
    const Rule& rule = source.study.rule;
    const RuleSite site{observerOfPlaces(source.baseline), source.study.settings.zone, source.study.year};
    auto sun = computeRuleSun(rule, site, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    const auto moments = computeReviewMoments(source.study, source.baseline, maxHoursADay, stop);
    if (!moments) return tl::make_unexpected(moments.error());
    auto diagrams = std::make_shared<DiagramScene>();
    diagrams->proposal = keepOwnBuildings(source.scenario, source.baseline);
    diagrams->removed = keepOwnBuildings(source.baseline, source.scenario);
    diagrams->city = keepOwnBuildings(source.scenario, diagrams->proposal);
    diagrams->places = source.places;
    diagrams->streets = source.streets;
    diagrams->units = settings.units;
    CastingCities casting = chooseCasters(rule, source.baseline, source.scenario);
    ReviewScene scene{
        source,        settings,       diagrams, std::move(casting.before), std::move(casting.after),
        site.observer, *std::move(sun)};
    for (const RuleMoment& moment : *moments)
        if (moment.sun.altitudeDeg > minSunDeg)
            scene.moments.push_back(
                {moment.day, moment.minutes, QString::fromStdString(moment.clock), moment.sun});
    const bool hasProposal = !diagrams->proposal.buildings.empty() || !diagrams->removed.buildings.empty();
    scene.list = listPlaces(source, settings, hasProposal);
    diagrams->numbers = scene.list.numbers;
    diagrams->placeColours = colourPlaces(source);
    const std::vector<QString> entries = keyEntries(scene, {reachOf(scene, scene.moments)});
    if (!entries.empty())
        scene.keyPt = std::min(keyHeightPt(scene, joinKey(entries, entries.size())),
                               maxKeyShare * contentArea(settings.setup).height());
    return scene;
}

Box2 reachOf(const ReviewScene& scene, const std::vector<DiagramMoment>& moments) {
    Box2 reach = changedBounds(*scene.diagrams);
    if (reach.empty()) return grown(bounds(scene.diagrams->places), marginM);
    for (const DiagramMoment& moment : moments) reach = unionOf(reach, sweepOf(*scene.diagrams, moment));
    return grown(reach, marginM);
}

Box2 focusOf(const ReviewScene& scene, const std::vector<DiagramMoment>& moments) {
    const Box2 reach = reachOf(scene, moments), changed = changedBounds(*scene.diagrams);
    return unionOf(changed.empty() ? reach : grown(changed, marginM), placesIn(scene, reach));
}

Box2 frameOf(const ReviewScene& scene, const std::vector<DiagramMoment>& moments) {
    return unionOf(reachOf(scene, moments), focusOf(scene, moments));
}

DiagramLayout fitInto(const QRectF& area, double textScale, const Box2& shown) {
    const QSizeF map = mapAreaOf(area, textScale).size();
    const glm::dvec2 size = glm::max(glm::dvec2(shown.high - shown.low), glm::dvec2(1));
    const auto holds = [&](double scale) {
        return size.x * pointsPerMetre(scale) <= map.width() &&
               size.y * pointsPerMetre(scale) <= map.height();
    };
    const auto scale = std::ranges::find_if(roundScales, holds);
    return {1, 1, scale == roundScales.end() ? roundScales.back() : *scale,
            glm::dvec2(shown.low + shown.high) / 2.0};
}

DiagramLayout layoutOf(const ReviewScene& scene) { return LayoutChoice(scene).choose(); }

std::optional<WorstMoment> worstMoment(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    std::pair<int, double> worst{-1, 0};
    std::optional<WorstMoment> found;
    for (std::size_t i = 0; i < study.timelines.size(); ++i)
        for (const DayTimeline& day : study.timelines[i]) {
            const PlaceReview& place = study.places[i];
            const std::pair now{badness(place.verdict), day.incremental.largestM2};
            if (now.second <= 0 || now <= worst) continue;
            worst = now;
            const Instant at = *day.incremental.largestAt;
            found = WorstMoment{
                {day.day, scene.sun.clock.minutesOf(day.day, at),
                 QString::fromStdString(scene.sun.clock.timeText(day.day, at)), sunAt(scene.observer, at)},
                i};
        }
    if (found) return found;
    const auto nearest = std::ranges::min_element(
        scene.moments, {}, [](const DiagramMoment& moment) { return std::abs(moment.minute - 720); });
    return nearest == scene.moments.end() ? std::nullopt : std::optional(WorstMoment{*nearest, std::nullopt});
}

}  // namespace noonmark
