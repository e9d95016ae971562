#include "app/gui/tools/live/live_trees.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "core/city/terrain/building_ground.h"
#include "core/engines/api/tree_shade.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/trees/crowns_around.h"

namespace noonmark {

namespace {

constexpr double crownSquareM = 16;
constexpr std::uint8_t unknownPass = 255;  // else 254ths of the sun
constexpr double passSteps = 254;
constexpr std::size_t maxPassBytes = std::size_t{1} << 29U;

// 1 where trees are in leaf.
std::vector<std::uint16_t> findLeafySteps(const SunSteps& sun, const LeafDays* leaves) {
    std::vector<std::uint16_t> inLeaf(sun.steps.size(), 1);
    if (leaves == nullptr) return inLeaf;
    for (const SunDay& day : sun.days)
        if (!isInLeaf(*leaves, day.date))
            std::fill_n(inLeaf.begin() + day.first, day.count, std::uint16_t{0});
    return inLeaf;
}

double perMetre(const Crown& crown, const WeightedSun& sun, const LeafPhases& phases) {
    return sun.inLeaf ? crown.leafOnPerM : phases.perM(sun.phase, crown);
}

// Each patch with the minutes of its steps. `kinds`: their phases, or whether trees are in leaf.
std::vector<WeightedSun> weigh(const SunPatches& patches, const SunSteps& sun,
                               const std::vector<std::uint16_t>& kinds, bool arePhases) {
    const double minutes = sun.stepMinutes / double(std::max<std::size_t>(1, sun.dayCount()));
    std::vector<WeightedSun> suns(patches.count());
    for (std::size_t step = 0; step < sun.steps.size(); ++step) {
        WeightedSun& one = suns[patches.ofStep(step)];
        one.direction = patches.direction(patches.ofStep(step));
        one.inLeaf = !arePhases && kinds[step] != 0;
        one.phase = arePhases ? kinds[step] : 0;
        one.minutesPerDay += minutes;
    }
    return suns;
}

}  // namespace

std::vector<WeightedSun> findSuns(const SunSteps& sun, const LeafDays* leaves, std::size_t maximum,
                                  const LeafPhases& phases) {
    constexpr double widerTimes = 1.25, widestDeg = 20;
    const bool arePhases = leaves != nullptr && !phases.empty();
    const std::vector<std::uint16_t> kinds = arePhases ? phases.ofStep : findLeafySteps(sun, leaves);
    double sideDeg = SunPatches::sunDeg;
    SunPatches patches(sun.steps, sideDeg, kinds);
    while (patches.count() > maximum && sideDeg < widestDeg)
        patches = SunPatches(sun.steps, sideDeg *= widerTimes, kinds);
    return weigh(patches, sun, kinds, arePhases);
}

StandingCrowns::Square StandingCrowns::squareOf(glm::dvec2 place) {
    return {int(std::floor(place.x / crownSquareM)), int(std::floor(place.y / crownSquareM))};
}

StandingCrowns::StandingCrowns(const std::vector<Crown>& crowns) {
    highestM_ = -std::numeric_limits<double>::max();
    for (const Crown& crown : crowns) {
        squares_[squareOf({crown.x, crown.y})].push_back(crown);
        highestM_ = std::max(highestM_, crown.topM);
        widestM_ = std::max(widestM_, crown.radiusM);
    }
}

// Each square once: column by column along the ray, with those beside it as far as the widest crown reaches.
double StandingCrowns::depth(glm::dvec3 origin, const WeightedSun& sun, const LeafPhases& phases) const {
    const glm::dvec3 direction = sun.direction;
    if (origin.z >= highestM_ || direction.z <= 0) return 0;
    const glm::dvec2 end =
        glm::dvec2(origin) + glm::dvec2(direction) * ((highestM_ - origin.z) / direction.z);
    const bool isFlipped = std::abs(direction.y) > std::abs(direction.x);
    const auto along = [&](glm::dvec2 place) { return isFlipped ? place.y : place.x; };
    const auto across = [&](glm::dvec2 place) { return isFlipped ? place.x : place.y; };
    const glm::dvec2 start(origin);
    const double low = std::min(along(start), along(end)) - widestM_,
                 high = std::max(along(start), along(end)) + widestM_;
    const double slope =
        along(end) == along(start) ? 0 : (across(end) - across(start)) / (along(end) - along(start));
    double sum = 0;
    for (int column = int(std::floor(low / crownSquareM)); column <= int(std::floor(high / crownSquareM));
         ++column) {
        const double from = std::clamp(column * crownSquareM, low, high),
                     to = std::clamp((column + 1) * crownSquareM, low, high);
        const double a = across(start) + slope * (from - along(start)),
                     b = across(start) + slope * (to - along(start));
        const double reach = 2 * widestM_;  // beside the ray and before and behind it
        const int first = int(std::floor((std::min(a, b) - reach) / crownSquareM)),
                  last = int(std::floor((std::max(a, b) + reach) / crownSquareM));
        for (int row = first; row <= last; ++row) {
            const auto found = squares_.find(isFlipped ? Square{row, column} : Square{column, row});
            if (found == squares_.end()) continue;
            for (const Crown& crown : found->second)
                sum += computeChord(crown, origin, direction) * perMetre(crown, sun, phases);
        }
    }
    return sum;
}

namespace {

// Where no tree reaches a receiver, or the city has none, that is the shadow without trees.
const ShadowField* findFieldWithTrees(const Study& study) {
    const auto& trees = study.field.trees;
    if (trees && trees->seasonal) return &*trees->seasonal;
    if (trees && trees->evergreen) return &*trees->evergreen;
    return study.settings.trees == TreeColumns::without ? nullptr : &study.field;
}

bool measuresSeasons(const Study& study) {
    return study.field.trees ? study.field.trees->seasonal.has_value()
                             : study.settings.trees != TreeColumns::evergreen;
}

Error noLiveTrees(std::string why) {
    return {"Dragged trees are not followed by their shadow", {}, std::move(why)};
}

}  // namespace

LiveTreeShade::LiveTreeShade(std::shared_ptr<const Study> study, RayScene scene,
                             const std::vector<Crown>& others, LeafSeasons seasons)
    : study_(std::move(study)),
      before_(findFieldWithTrees(*study_)),
      scene_(std::move(scene)),
      others_(others),
      seasons_(std::move(seasons)) {}

Result<std::shared_ptr<LiveTreeShade>> LiveTreeShade::of(std::shared_ptr<const Study> study,
                                                         const HandledTrees& trees,
                                                         const std::stop_token& stop) {
    if (trees.moved.size() > maxMoved)
        return tl::make_unexpected(
            noLiveTrees(fmt::format("Drag up to {} trees, or measure again when they stand", maxMoved)));
    if (findFieldWithTrees(*study) == nullptr)
        return tl::make_unexpected(noLiveTrees("Measure a study with trees first"));
    const City& city = study->city;
    const LeafDays leafDays = city.trees ? city.trees->leafDays : assumeLeafDays(city.frame.origin().latDeg);
    std::vector<Crown> others;
    std::vector<Tree> chosen;
    LeafSeasons leafSeasons(leafDays);
    if (trees.planted) leafSeasons.add(*trees.planted);
    for (const Tree& tree : city.trees ? city.trees->trees : std::vector<Tree>()) {
        const std::uint32_t season = leafSeasons.add(tree);
        if (trees.moved.contains(tree.sourceId)) {
            chosen.push_back(tree);
            continue;
        }
        others.push_back(makeCrown(tree));
        others.back().season = season;
    }
    if (chosen.empty() && !trees.planted)
        return tl::make_unexpected(noLiveTrees("The trees are not those of the study"));
    const Receivers& receivers = study->receivers;
    auto scene = RayScene::over(city, findBuildingsInReach(city, receivers, study->sun), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    std::shared_ptr<LiveTreeShade> live(
        new LiveTreeShade(study, *std::move(scene), others, std::move(leafSeasons)));
    live->moved_ = std::move(chosen);
    live->planted_ = trees.planted;
    live->seasonal_ = measuresSeasons(*study);
    const std::size_t maximum =
        std::min(maxPatches, maxPassBytes / std::max<std::size_t>(1, receivers.grid.size()));
    live->phases_ = findLeafPhases(live->seasons_, study->sun);
    live->patches_ = findSuns(study->sun, live->seasonal_ ? &leafDays : nullptr, maximum, live->phases_);
    if (live->patches_.size() > maximum)
        return tl::make_unexpected(noLiveTrees("Measure a smaller region, or larger cells"));
    live->passed_.assign(live->patches_.size() * receivers.grid.size(), unknownPass);
    live->lowestM_ = std::numeric_limits<float>::max();
    live->highestM_ = std::numeric_limits<float>::lowest();
    for (const std::uint32_t cell : receivers.cells) {
        const float z = receivers.position(cell).z;
        live->lowestM_ = std::min(live->lowestM_, z);
        live->highestM_ = std::max(live->highestM_, z);
    }
    live->takenBefore_ = live->measure(live->crownsAt({}));
    return live;
}

std::vector<Crown> LiveTreeShade::crownsAt(const HandledPlaces& places) const {
    std::vector<Crown> crowns;
    const auto add = [&](Tree tree, glm::dvec2 place) {
        if (tree.place != place) tree.groundM = float(groundAt(study_->city, place));
        tree.place = place;
        crowns.push_back(makeCrown(tree));
        crowns.back().season = seasons_.of(tree);
    };
    for (const Tree& tree : moved_) add(tree, tree.place + places.byM);
    if (planted_)
        for (const glm::dvec2 place : places.planted) add(*planted_, place);
    return crowns;
}

// Each task has sums of its own, which are joined in their order: the same on any number of cores.
std::vector<float> LiveTreeShade::measure(const std::vector<Crown>& crowns) {
    const Grid& grid = study_->receivers.grid;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, tasks, 1),
        [&](const auto& range) {
            for (std::size_t task = range.begin(); task < range.end(); ++task) {
                Sums& sums = sums_[task];
                sums.minutes.resize(grid.size(), 0);
                sums.depths.resize(grid.size(), 0);
                sums.firstRow = grid.rows;
                sums.lastRow = -1;
                for (std::size_t k = task; k < patches_.size(); k += tasks)
                    shade(patches_[k], passed_.data() + k * grid.size(), crowns, sums);
            }
        },
        tbb::simple_partitioner());
    std::vector<float> all(grid.size(), 0);
    for (Sums& sums : sums_)
        for (int row = sums.firstRow; row <= sums.lastRow; ++row)
            for (std::size_t cell = grid.index(0, row); cell < grid.index(0, row + 1); ++cell)
                all[cell] += std::exchange(sums.minutes[cell], 0.0F);
    return all;
}

// Of crowns that overlap on a ray the depths add up.
void LiveTreeShade::shade(const WeightedSun& patch, std::uint8_t* passed, const std::vector<Crown>& crowns,
                          Sums& sums) const {
    for (const Crown& crown : crowns)
        visitShadow(crown, patch.direction, [&](std::uint32_t cell) {
            const glm::dvec3 origin(placeRayOrigin(study_->receivers.position(cell)));
            const double depth =
                computeChord(crown, origin, patch.direction) * perMetre(crown, patch, phases_);
            if (depth <= 0) return;
            if (sums.depths[cell] == 0) sums.touched.push_back(cell);
            sums.depths[cell] += float(depth);
        });
    for (const std::uint32_t cell : sums.touched) {
        const int row = int(cell) / study_->receivers.grid.columns;
        sums.firstRow = std::min(sums.firstRow, row);
        sums.lastRow = std::max(sums.lastRow, row);
        const double taken = -std::expm1(-double(std::exchange(sums.depths[cell], 0.0F)));
        sums.minutes[cell] += float(patch.minutesPerDay * passOf(cell, patch, passed[cell]) * taken);
    }
    sums.touched.clear();
}

// The receivers in a strip of the ground from below the crown's lower end to where its top casts its shadow.
template <class Visit>
void LiveTreeShade::visitShadow(const Crown& crown, glm::dvec3 direction, Visit&& visit) const {
    const Receivers& receivers = study_->receivers;
    const Grid& grid = receivers.grid;
    const glm::dvec2 flat(-direction.x, -direction.y);
    const double perMetre = glm::length(flat) / direction.z;  // of height
    const glm::dvec2 away = glm::length(flat) > 0 ? flat / glm::length(flat) : glm::dvec2(1, 0);
    const double from = std::max(0.0, crown.bottomM - double(highestM_)) * perMetre,
                 to = std::max(0.0, crown.topM - double(lowestM_)) * perMetre;
    const glm::dvec2 axis(crown.x, crown.y), a = axis + away * from, b = axis + away * to;
    const double reach = crown.radiusM + grid.cellM;
    const auto rowOf = [&](double y) { return int(std::floor((y - grid.southM) / grid.cellM)); };
    const auto columnOf = [&](double x) { return int(std::floor((x - grid.westM) / grid.cellM)); };
    const int firstRow = std::max(0, rowOf(std::min(a.y, b.y) - reach)),
              lastRow = std::min(grid.rows - 1, rowOf(std::max(a.y, b.y) + reach));
    for (int row = firstRow; row <= lastRow; ++row) {
        const double y = grid.centre(0, row).y;
        double low = from, high = to;  // the part of the strip's middle that is near this row
        if (std::abs(away.y) > 1e-9) {
            const double s = (y - reach - axis.y) / away.y, t = (y + reach - axis.y) / away.y;
            low = std::max(low, std::min(s, t));
            high = std::min(high, std::max(s, t));
        }
        if (low > high) continue;
        const double west = axis.x + std::min(away.x * low, away.x * high) - reach,
                     east = axis.x + std::max(away.x * low, away.x * high) + reach;
        const int firstColumn = std::max(0, columnOf(west)),
                  lastColumn = std::min(grid.columns - 1, columnOf(east));
        for (int column = firstColumn; column <= lastColumn; ++column) {
            const auto cell = std::uint32_t(grid.index(column, row));
            if (isReceiver(receivers.kind[cell])) visit(cell);
        }
    }
}

double LiveTreeShade::passOf(std::uint32_t cell, const WeightedSun& patch, std::uint8_t& known) const {
    if (known == unknownPass) {
        const glm::vec3 origin = placeRayOrigin(study_->receivers.position(cell));
        const bool blocked = scene_.occluded(origin, glm::vec3(patch.direction));
        const double passes = blocked ? 0 : std::exp(-others_.depth(glm::dvec3(origin), patch, phases_));
        known = std::uint8_t(std::lround(passes * passSteps));
    }
    return double(known) / passSteps;
}

ShadowField LiveTreeShade::with(const HandledPlaces& places) {
    const std::vector<float> taken = measure(crownsAt(places));
    ShadowField field = *before_;
    for (const std::uint32_t cell : study_->receivers.cells)
        field.grossMin[cell] = std::clamp(field.grossMin[cell] + taken[cell] - takenBefore_[cell], 0.0F,
                                          float(field.sunlitMinutesPerDay));
    std::ranges::fill(field.continuousMin, std::numeric_limits<float>::quiet_NaN());
    return field;
}

namespace {

LivePlaceShade comparePlace(const GridPlace& place, const ShadowField& before, const ShadowField& now) {
    LivePlaceShade shade{.name = place.name, .whole = place.whole};
    for (const std::uint32_t cell : place.cells) {
        shade.beforeMin += double(before.grossMin[cell]) / double(place.cells.size());
        shade.nowMin += double(now.grossMin[cell]) / double(place.cells.size());
    }
    return shade;
}

std::vector<GridPlace> findReceiversOf(const std::vector<Place>& places, const Receivers& receivers) {
    std::vector<GridPlace> found = findPlaceCells(places, receivers.grid);
    for (GridPlace& place : found)
        std::erase_if(place.cells, [&](std::uint32_t cell) { return !isReceiver(receivers.kind[cell]); });
    std::erase_if(found, [](const GridPlace& place) { return place.cells.empty(); });
    return found;
}

}  // namespace

std::vector<LivePlaceShade> comparePlaces(const Receivers& receivers, const std::vector<GridPlace>& places,
                                          const ShadowField& before, const ShadowField& now) {
    std::vector<LivePlaceShade> shades{comparePlace({{}, receivers.cells}, before, now)};
    for (const GridPlace& place : places) shades.push_back(comparePlace(place, before, now));
    std::ranges::stable_sort(shades.begin() + 1, shades.end(), std::ranges::greater{},
                             [](const LivePlaceShade& one) { return std::abs(one.nowMin - one.beforeMin); });
    return shades;
}

void LiveTrees::begin(std::shared_ptr<const Study> study, HandledTrees trees, std::vector<Place> places) {
    end();
    study_ = std::move(study);
    trees_ = std::move(trees);
    places_ = std::make_shared<const std::vector<Place>>(std::move(places));
    if (study_) ask();
}

void LiveTrees::end() {
    slot_.drop();
    study_.reset();
    shade_.reset();
    cells_.reset();
    field_.reset();
    figures_.clear();
    at_ = {};
    newer_ = false;
}

void LiveTrees::follow(HandledPlaces places) {
    if (!study_) return;
    at_ = std::move(places);
    newer_ = true;
    if (!slot_.busy()) ask();
}

void LiveTrees::ask() {
    newer_ = false;
    slot_.start<Followed>(
        tr("Live shade of trees"),
        [study = study_, shade = shade_, cells = cells_, places = places_, trees = trees_, at = at_](
            Progress&, const std::stop_token& stop) mutable -> Result<Followed> {
            auto live =
                shade ? Result<std::shared_ptr<LiveTreeShade>>(shade) : LiveTreeShade::of(study, trees, stop);
            if (!live) return tl::make_unexpected(live.error());
            const Receivers& receivers = study->receivers;
            if (!cells)
                cells = std::make_shared<const std::vector<GridPlace>>(findReceiversOf(*places, receivers));
            auto field = std::make_shared<const ShadowField>((*live)->with(at));
            auto figures = comparePlaces(receivers, *cells, (*live)->before(), *field);
            return Followed{*std::move(live), std::move(cells), std::move(field), std::move(figures)};
        },
        [this](Result<Followed> followed) { take(std::move(followed)); });
}

void LiveTrees::take(Result<Followed> followed) {
    if (!followed) {
        end();
        return Q_EMIT failed(followed.error());
    }
    shade_ = std::move(followed->shade);
    cells_ = std::move(followed->cells);
    field_ = std::move(followed->field);
    figures_ = std::move(followed->figures);
    if (newer_) ask();
    Q_EMIT changed();
}

}  // namespace noonmark
