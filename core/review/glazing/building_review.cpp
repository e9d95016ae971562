#include "core/review/glazing/building_review.h"

#include <algorithm>
#include <map>

namespace noonmark {

namespace {

bool isJudged(Verdict verdict) { return verdict <= Verdict::fail; }

void worsen(Verdict& verdict, Verdict other) {
    if (!isJudged(other)) return;
    verdict = isJudged(verdict) ? worseOf(verdict, other) : other;
}

BuildingShare countShare(const Rule& rule, const UnitShare& share,
                         const std::vector<const GlazingReview*>& windows, bool former) {
    const auto found = std::ranges::find(rule.criteria, share.criterion, &Criterion::key);
    const auto criterion = std::size_t(found - rule.criteria.begin());
    BuildingShare counted;
    for (const GlazingReview* window : windows) {
        const Verdict verdict =
            former ? window->formerVerdicts[criterion] : window->results[criterion].verdict;
        if (!isJudged(verdict)) continue;
        ++counted.units;
        counted.meeting += verdict == Verdict::pass ? 1 : 0;
        counted.borderline += verdict == Verdict::borderline ? 1 : 0;
    }
    const double needed = share.atLeast * double(counted.units) - 1e-9;
    if (counted.units == 0) return counted;
    counted.verdict = double(counted.meeting) >= needed                        ? Verdict::pass
                      : double(counted.meeting + counted.borderline) >= needed ? Verdict::borderline
                                                                               : Verdict::fail;
    return counted;
}

BuildingReview reviewBuilding(const Rule& rule, const std::vector<const GlazingReview*>& windows) {
    BuildingReview building{.id = windows.front()->window.building,
                            .name = windows.front()->window.buildingName};
    Verdict worst = Verdict::notApplicable, formerWorst = Verdict::notApplicable;
    for (const GlazingReview* window : windows) {
        building.windows.add(window->formerVerdict, window->verdict);
        worsen(worst, window->verdict);
        worsen(formerWorst, window->formerVerdict);
    }
    for (const UnitShare& share : rule.shares) {
        building.shares.push_back(countShare(rule, share, windows, false));
        building.formerShares.push_back(countShare(rule, share, windows, true));
        worsen(building.verdict, building.shares.back().verdict);
        worsen(building.formerVerdict, building.formerShares.back().verdict);
    }
    if (rule.shares.empty()) building.verdict = worst, building.formerVerdict = formerWorst;
    const auto isUnchecked = [](const GlazingReview* window) {
        return window->verdict == Verdict::notChecked;
    };
    if (std::ranges::all_of(windows, isUnchecked))
        building.verdict = building.formerVerdict = Verdict::notChecked;
    return building;
}

}  // namespace

void VerdictCounts::add(Verdict verdict) {
    if (verdict == Verdict::pass)
        ++pass;
    else if (verdict == Verdict::borderline)
        ++borderline;
    else if (verdict == Verdict::fail)
        ++fail;
    else if (verdict == Verdict::notApplicable)
        ++notApplicable;
    else
        ++notChecked;
}

void VerdictChanges::add(Verdict former, Verdict verdict) {
    before.add(former);
    after.add(verdict);
    worse += isWorse(former, verdict) ? 1 : 0;
    better += isWorse(verdict, former) ? 1 : 0;
}

bool isWorse(Verdict former, Verdict verdict) {
    return isJudged(former) && isJudged(verdict) && verdict > former;
}

std::vector<const GlazingReview*> sortWorstFirst(const std::vector<GlazingReview>& windows) {
    std::vector<const GlazingReview*> sorted;
    for (const GlazingReview& review : windows) sorted.push_back(&review);
    std::ranges::stable_sort(sorted, {}, [](const GlazingReview* review) {
        if (isWorse(review->formerVerdict, review->verdict)) return 0;
        return review->verdict == Verdict::fail ? 1 : review->verdict == Verdict::borderline ? 2 : 3;
    });
    return sorted;
}

std::vector<BuildingReview> reviewBuildings(const Rule& rule, const std::vector<GlazingReview>& windows) {
    std::map<std::string, std::size_t> indices;
    std::vector<std::vector<const GlazingReview*>> byBuilding;
    for (const GlazingReview& window : windows) {
        const auto [at, isNew] = indices.try_emplace(window.window.building, byBuilding.size());
        if (isNew) byBuilding.emplace_back();
        byBuilding[at->second].push_back(&window);
    }
    std::vector<BuildingReview> buildings;
    for (const auto& own : byBuilding) buildings.push_back(reviewBuilding(rule, own));
    return buildings;
}

}  // namespace noonmark
