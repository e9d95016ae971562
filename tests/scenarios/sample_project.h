#pragma once

#include <chrono>
#include <limits>

#include "core/city/map_context.h"
#include "core/city/trees/tree_facts.h"
#include "scenarios/project/project.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {

inline std::shared_ptr<const SavedResult> makeSavedResult(const std::string& name, int columns = 300,
                                                          int rows = 40) {
    SavedResult result{name, "impact", "A", existingCity, R"({"engine":"ray"})", R"([{"path":"city.gpkg"}])",
                       {},   {}};
    result.grid = {-10, -20, 2, columns, rows};
    for (const char* layer : {"gross change", "continuous change"}) {
        SavedLayer map{layer, "min/day", {}};
        for (std::size_t i = 0; i < result.grid.size(); ++i)
            map.values.push_back(i % 7 == 0 ? std::numeric_limits<float>::quiet_NaN()
                                            : float(i) * 0.37F - 500);
        result.layers.push_back(std::move(map));
    }
    return std::make_shared<const SavedResult>(std::move(result));
}

/// A project with one of everything that a project can contain.
inline Project sampleProject() {
    using namespace std::chrono;
    City city = threeHouses();
    Building solid = house("mesh house", box(0.1F, 40.3F, 10.7F, 50.9F), 12.34F);
    solid.parts[0].mesh = std::make_shared<const TriangleMesh>(meshOf(solid.parts[0]));
    solid.parts[0].isOverhanging = true;
    solid.parts[0].heightSource = HeightSource::mesh;
    city.buildings.push_back(shared(solid));
    Building court = house("court \"5\"", box(100, 100, 150, 150), 21);
    court.parts[0].footprint.holes.push_back({{110, 110}, {110, 140}, {140, 140}, {140, 110}});
    court.parts.push_back(house("tower", box(100, 100, 108, 108), 60, 21).parts[0]);
    court.name = "Cour d'Été";
    city.buildings.push_back(shared(court));
    city.terrain = slope();
    city.context = std::make_shared<const MapContext>(MapContext{
        {{ContextKind::park, "Cour d'Été", {{{{0.1F, 0}, {9.7F, 0}, {4, 8}}, {}}, court.parts[0].footprint}}},
        {{ContextKind::street, "Main", 7.5F, {{0.3F, 1}, {2, 3}, {-4, 5.1F}}},
         {ContextKind::path, "", 2, {{0, 1}, {2, 3}}}},
        {{1, 2}, {3.3F, 4}},
        "(c) map"});
    Trees trees{.trees = {completeTree({.sourceId = "node 1", .species = "Pinus d'Été", .heightM = 11.3}),
                          completeTree({.sourceId = "node 2", .stemDiameterM = 0.31})},
                .leafDays = {101, 317}};
    trees.trees[0].place = {20.3F, 5.1F};
    trees.trees[1].place = {150.7F, -3};
    trees.trees[1].leafOnDay = 122;
    trees.trees[1].leafOffDay = 365;
    for (Tree& tree : trees.trees) tree.groundM = groundAt(city, tree.place);
    city.trees = std::make_shared<const Trees>(std::move(trees));
    Project project;
    project.city = std::make_shared<const City>(city);
    project.attribution = "(c) OpenStreetMap contributors, ODbL";
    project.inputs = {{"city.gpkg", 1234, "abcd"}};
    CityReading reading;
    reading.settings->metresPerLevel = 3.1;
    reading.settings->crs = "EPSG:2263";
    reading.warnings = {{WarningKind::repaired, "outline crossed itself", "way 7"},
                        {WarningKind::assumed, "no height", "way 1"},
                        {WarningKind::repaired, "outline crossed itself", "\"way\" 8, d'Été"},
                        {WarningKind::dropped, "outline crossed itself", ""}};
    reading.heights = {{{"city.gpkg", "HAUTEUR", "height of the building", "m", 3}},
                       {{"city.gpkg", "n_d'Été", 1, 12.5, false, 4}}};
    project.reading = std::make_shared<const CityReading>(reading);
    project.lots = {{"corner", box(200, 0, 240, 30), {{ParcelSide::south, 8}, {ParcelSide::east, 12.5}}},
                    {"court", court.parts[0].footprint}};
    project.regions = {{"Park", {box(0, 60, 100, 90), box(0, 100, 50, 120)}}};
    project.places = {
        {"Church \"yard\"", PlaceKind::cemetery, {court.parts[0].footprint}, "OSM way 12"},
        {"Cour d'Été", PlaceKind::stainedGlass, {box(0, 60, 100, 90), box(0, 100, 50, 120)}, "drawn"}};
    Building imported = solid;
    imported.sourceId = "imported";
    project.scenarios = {
        {"A", "", {Demolish{"a"}, Replace{"b", shared(house("new b", box(30.2F, 0, 40, 10.1F), 55.5F))}}},
        {"B",
         "A",
         {AddBuilding{shared(house("tower", box(200, 0, 220, 20), 99))}, ChangeHeight{"c", 31.7},
          Move{"c", {1.5, -2}}, Rotate{"c", 12.25},
          ImportMesh{shared(imported), {.scale = 1.5, .clockwiseDeg = 30, .byM = {300, 10}}, "house.obj"}}}};
    project.weights.push_back({"school",
                               {{.name = "afternoons",
                                 .first = September / 1,
                                 .last = June / 30,
                                 .from = minutes(15 * 60),
                                 .to = minutes(17 * 60),
                                 .weight = -1}}});
    project.periods = {{"equinox", {}},
                       {"sun",
                        {.days = 365,
                         .window = SolarHours{minutes(90), minutes(90)},
                         .zone = "America/New_York",
                         .refraction = false}}};
    project.views = {{"Plan \"A\"", {12.5, -7.25, 1.5}, 432.1, 0, 90, true},
                     {"Depuis l'Été",
                      {0, 0, 0},
                      1e4,
                      359.9,
                      2,
                      false,
                      ViewMoment{2026y / June / 21, minutes(20 * 60 + 5)},
                      ViewBox{{-50, -60.5, -2}, {70, 80.25, 31}}}};
    project.results = {makeSavedResult("first")};
    project.sheets = {
        {"Tower \"A\"", "Ä. Planer", "城市", "1 May 2026", "A-", std::string("\x89PNG\r\n\x1a\n\0x", 10)},
        UnitSystem::both};
    project.view = {{"camera", "1 2 3"}, {"palette", "divergent"}};
    return project;
}

/// Whether two projects are equal, comparing buildings and results by value.
inline bool sameCity(const City& a, const City& b) {
    if (a.frame != b.frame || a.buildings.size() != b.buildings.size()) return false;
    if (bool(a.terrain) != bool(b.terrain) || (a.terrain && *a.terrain != *b.terrain)) return false;
    if (bool(a.context) != bool(b.context) || (a.context && *a.context != *b.context)) return false;
    if (bool(a.trees) != bool(b.trees) || (a.trees && *a.trees != *b.trees)) return false;
    for (std::size_t i = 0; i < a.buildings.size(); ++i) {
        Building x = *a.buildings[i], y = *b.buildings[i];
        if (x.parts.size() != y.parts.size()) return false;
        for (std::size_t p = 0; p < x.parts.size(); ++p) {
            if (bool(x.parts[p].mesh) != bool(y.parts[p].mesh)) return false;
            if (x.parts[p].mesh && *x.parts[p].mesh != *y.parts[p].mesh) return false;
            x.parts[p].mesh = y.parts[p].mesh = nullptr;
        }
        if (x != y) return false;
    }
    return true;
}

}  // namespace noonmark::tests
