#include "core/measures/outlines/level_outlines.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <iterator>

#include "core/city/terrain/ground_contact.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/common/shared_buildings.h"
#include "core/measures/outlines/join_shadows.h"

namespace noonmark {

namespace {

bool overlap(const Box2& a, const Box2& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

void addCover(const Building& building, const Box2& area, std::vector<Footprint>& cover) {
    if (!overlap(bounds(building), area)) return;
    for (const Part& part : building.parts)
        for (Footprint& contact : findGroundContact(part, 0)) cover.push_back(std::move(contact));
}

glm::dvec2 shadowPerMetre(glm::dvec3 towardsSun) { return glm::dvec2(towardsSun) / -towardsSun.z; }

}  // namespace

LevelOutliner::Group LevelOutliner::groupOf(const City& city, const std::vector<std::uint32_t>& indices) {
    Group group;
    for (const std::uint32_t i : indices) {
        group.buildings.push_back(city.buildings[i].get());
        group.boxes.push_back(bounds(*city.buildings[i]));
        group.heightsM.push_back(topM(*city.buildings[i]));
    }
    return group;
}

LevelOutliner::LevelOutliner(const City& baseline, const City* scenario, const Box2& area) : area_(area) {
    std::vector<const City*> cities{&baseline};
    if (scenario != nullptr) cities.push_back(scenario);
    const SharedBuildings shared = findSharedBuildings(cities);
    common_ = groupOf(baseline, shared.common);
    baseline_ = groupOf(baseline, shared.own.front());
    if (scenario != nullptr) scenario_ = groupOf(*scenario, shared.own.back());
    for (const Group* group : {&common_, &baseline_, &scenario_})
        for (const Building* building : group->buildings) addCover(*building, area, cover_);
}

std::vector<ConvexPolygon> LevelOutliner::project(const Group& group, const SunStep& step,
                                                  const std::stop_token& stop) const {
    SunSteps only;
    only.steps = {step};
    const ShadowReach reach(only);
    const glm::dvec2 perMetre = shadowPerMetre(glm::dvec3(step.direction));
    tbb::enumerable_thread_specific<std::vector<ConvexPolygon>> ofThread;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, group.buildings.size(), 64), [&](const auto& range) {
        std::vector<ConvexPolygon>& polygons = ofThread.local();
        for (std::size_t i = range.begin(); i < range.end() && !stop.stop_requested(); ++i)
            if (reach.touches(group.boxes[i], double(group.heightsM[i]), area_))
                projectBuilding(*group.buildings[i], perMetre, polygons);
    });
    std::vector<ConvexPolygon> all;
    for (std::vector<ConvexPolygon>& polygons : ofThread)
        all.insert(all.end(), std::move_iterator(polygons.begin()), std::move_iterator(polygons.end()));
    return all;
}

Result<ShadowOutlines> LevelOutliner::outline(const SunStep& step, Progress& progress,
                                              const std::stop_token& stop) const {
    progress.report(0, "projecting shadows");
    const ProjectedShadowPolygons polygons{project(common_, step, stop), project(baseline_, step, stop),
                                           project(scenario_, step, stop)};
    if (stop.stop_requested()) return cancelled();
    return joinShadows(polygons, cover_, area_, progress, stop);
}

}  // namespace noonmark
