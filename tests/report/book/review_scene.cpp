#include "tests/report/book/review_scene.h"

#include <gtest/gtest.h>

#include "core/engines/auto_engine.h"
#include "core/review/library/rule_library.h"

namespace noonmark::tests {

Footprint boxFootprint(float west, float south, float east, float north) {
    return {{{west, south}, {east, south}, {east, north}, {west, north}}, {}};
}

namespace {

std::shared_ptr<const Building> prism(const std::string& id, const Footprint& footprint, float top) {
    Part part;
    part.sourceId = id;
    part.footprint = footprint;
    part.topM = top;
    part.heightSource = HeightSource::measured;
    return std::make_shared<const Building>(Building{id, id, {}, {part}});
}

Rule ruleOf() {
    Rule rule = RuleLibrary::load({}).value().find("four-days", {}).value();
    const auto day = [](unsigned month) {
        return RuleDay{{std::chrono::month{month}, std::chrono::day{21}}, {}, {}, {}};
    };
    rule.days.fixed = {day(3), day(6)};
    rule.deliverables.diagrams = RuleDiagrams{{600, 840}, {}, {"plan"}, {}};
    return rule;
}

}  // namespace

ReviewedPark::ReviewedPark(const std::string& placeName, const std::string& scenarioName) {
    before.frame = Frame({-73.98, 40.75});
    before.buildings = {prism("west house", boxFootprint(-80, 0, -60, 20), 20),
                        prism("east house", boxFootprint(60, 0, 80, 20), 25)};
    after = before;
    after.buildings.push_back(prism("tower", boxFootprint(-10, -30, 10, -10), 60));
    places = {{placeName, PlaceKind::park, {boxFootprint(-50, 0, 50, 60)}, "test"}};
    labels = {"Existing", scenarioName, {}, {}};
    NoProgress progress;
    ReviewSettings settings{2, "America/New_York", 2026, true};
    study = runReview(ruleOf(), before, after, places, settings, AutoEngine(), progress, {}).value();
}

Book ReviewedPark::book(const BookSettings& settings) const {
    NoProgress progress;
    return makeReviewBook(source(), settings, progress, {}).value();
}

}  // namespace noonmark::tests
