#include "tests/report/synthetic_study.h"

#include <limits>

namespace noonmark::tests {

namespace {

Footprint plot(float west, float south, float east, float north) {
    return {{{west, south}, {east, south}, {east, north}, {west, north}}, {}};
}

std::shared_ptr<const Building> building(const char* id, const Footprint& footprint, float bottomM,
                                         bool isOverhanging) {
    Building made{id, "", "built", {}};
    made.parts.push_back({id, footprint, bottomM, 30, HeightSource::measured, isOverhanging, nullptr});
    return std::make_shared<const Building>(std::move(made));
}

City cityOfTwo() {
    City city;
    city.frame = Frame(LonLat{-73.984, 40.754});
    city.buildings = {building("way 1", plot(50, 30, 70, 50), 0, false),
                      building("way 2", plot(50, 50, 70, 60), 10, true),
                      building("way 3", plot(-20, 20, -3, 60), 0, false)};
    return city;
}

float grossAt(const Grid& grid, int column, int row) {
    const bool east = column >= grid.columns / 2;
    const bool north = row >= grid.rows / 2;
    if (north) return east ? 360 : 60;
    return east ? 180 : 0;
}

void addCell(Study& study, int column, int row) {
    const Grid& grid = study.receivers.grid;
    const bool covered = contains(plot(50, 30, 70, 50), grid.centre(column, row));
    const float gross = covered ? std::numeric_limits<float>::quiet_NaN() : grossAt(grid, column, row);
    study.receivers.kind.push_back(covered ? CellKind::building : CellKind::ground);
    if (!covered) study.receivers.cells.push_back(std::uint32_t(grid.index(column, row)));
    study.field.grossMin.push_back(gross);
    study.field.continuousMin.push_back(gross / 2);
}

void addCells(Study& study) {
    const Grid grid{0, 0, 1, 120, 80};
    study.receivers.grid = grid;
    study.field.grid = grid;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) addCell(study, column, row);
}

SunSteps sixHours() {
    SunSteps sun;
    sun.steps.resize(360, SunStep{{0, -0.7F, 0.7F}, 180, 45, 0, {}});
    sun.days = {{CivilDate{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}}, 0, 360, 0}};
    return sun;
}

}  // namespace

Study syntheticStudy() {
    Study study;
    study.city = cityOfTwo();
    study.settings.region = {"Four quarters", {plot(0, 0, 120, 80)}};
    study.settings.period.zone = "America/New_York";
    addCells(study);
    study.sun = sixHours();
    study.field.sunlitMinutesPerDay = 360;
    study.field.engineKey = "ray";
    study.field.engine = "Ray reference: Embree, one occlusion ray a receiver and step";
    study.field.cost.buildingsUsed = 2;
    study.statistics = computeStatistics(study.field);
    study.provenance.attribution = "(c) OpenStreetMap contributors";
    return study;
}

Study grossOnly(Study study) {
    study.field.continuousMin.assign(study.field.grid.size(), std::numeric_limits<float>::quiet_NaN());
    study.statistics = computeStatistics(study.field);
    return study;
}

}  // namespace noonmark::tests
