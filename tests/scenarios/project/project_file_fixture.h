#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>

#include "scenarios/project/edit_json.h"
#include "scenarios/project/project_file.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/scenarios/sample_project.h"

namespace noonmark::tests {

class ProjectFileTest : public testing::Test {
protected:
    ProjectFile made(const Project& project = sampleProject()) {
        return ProjectFile::create(file(), project).value();
    }
    [[nodiscard]] std::filesystem::path file() const { return folder_.path("town.noonmark.gpkg"); }
    [[nodiscard]] Project opened() const { return ProjectFile::open(file()).value().project(); }
    [[nodiscard]] std::string errorOfOpening() const {
        const auto opened = ProjectFile::open(file());
        return opened ? "" : opened.error().text();
    }

    TemporaryFolder folder_;
};

inline MeasuredElement elementOf(const char* id, ElementKind kind, float z) {
    MeasuredElement element{.id = id, .kind = kind, .building = "a", .buildingName = "Haus \"Ä\""};
    element.position = {1.25F, -3.1F, z};
    element.normal = {0.6F, 0.8F, 0};
    element.pane = {{-1.5, -1.5}, {1.5, 1.2}};
    element.sunlitMin = 100.0 / 3;
    element.grossMin = 1000.0 / 7;
    element.continuousMin = 60;
    element.longestSunMin = 59.5;
    element.azimuthDeg = 36.9;
    element.floor = 2;
    element.monthMin.fill(std::nan(""));
    element.monthMin[5] = 1000.1;
    return element;
}

/// The sample with a result at points, since version 7; the third is of a plane.
inline Project sampleWithPoints() {
    Project project = sampleProject();
    SavedResult result{"points", "elements", "A", {}, R"({"kept": 1})", "[]", {0, 0, 1, 1, 1}, {}};
    for (const char* id : {"wall 1", "wall 2"})
        result.elements.push_back(elementOf(id, ElementKind::facade, 4.5F));
    MeasuredElement level = elementOf("3,4", ElementKind::plane, 1.5F);
    level.building = level.buildingName = "";
    level.floor.reset();
    level.azimuthDeg = std::nan("");
    result.elements.push_back(level);
    project.results.push_back(std::make_shared<const SavedResult>(result));
    return project;
}

/// A number that is none equals another.
inline void expectSame(const MeasuredElement& a, const MeasuredElement& b) {
    EXPECT_EQ(std::tie(a.id, a.kind, a.building, a.buildingName, a.floor, a.position, a.normal, a.pane),
              std::tie(b.id, b.kind, b.building, b.buildingName, b.floor, b.position, b.normal, b.pane));
    EXPECT_EQ(std::tie(a.sunlitMin, a.grossMin, a.continuousMin, a.longestSunMin),
              std::tie(b.sunlitMin, b.grossMin, b.continuousMin, b.longestSunMin));
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    EXPECT_TRUE(same(a.azimuthDeg, b.azimuthDeg));
    EXPECT_TRUE(std::ranges::equal(a.monthMin, b.monthMin, same));
}

inline void expectSame(const Project& a, const Project& b) {
    EXPECT_TRUE(sameCity(*a.city, *b.city));
    EXPECT_EQ(a.attribution, b.attribution);
    ASSERT_EQ(a.inputs.size(), b.inputs.size());
    ASSERT_EQ(bool(a.reading->settings), bool(b.reading->settings));
    if (a.reading->settings) {
        EXPECT_EQ(formatText(*a.reading->settings), formatText(*b.reading->settings));
    }
    EXPECT_EQ(a.reading->heights, b.reading->heights);
    ASSERT_EQ(a.reading->warnings.size(), b.reading->warnings.size());
    for (std::size_t i = 0; i < a.reading->warnings.size(); ++i) {
        EXPECT_EQ(a.reading->warnings[i].kind, b.reading->warnings[i].kind) << i;
        EXPECT_EQ(a.reading->warnings[i].what, b.reading->warnings[i].what) << i;
        EXPECT_EQ(a.reading->warnings[i].where, b.reading->warnings[i].where) << i;
    }
    EXPECT_EQ(a.lots, b.lots);
    EXPECT_EQ(a.regions, b.regions);
    EXPECT_EQ(a.places, b.places);
    EXPECT_EQ(a.sheets, b.sheets);
    EXPECT_EQ(a.weights, b.weights);
    EXPECT_EQ(a.periods, b.periods);
    EXPECT_EQ(a.views, b.views);
    EXPECT_EQ(a.view, b.view);
    ASSERT_EQ(a.scenarios.size(), b.scenarios.size());
    for (std::size_t i = 0; i < a.scenarios.size(); ++i) {
        EXPECT_EQ(a.scenarios[i].name, b.scenarios[i].name);
        EXPECT_EQ(a.scenarios[i].base, b.scenarios[i].base);
        ASSERT_EQ(a.scenarios[i].edits.size(), b.scenarios[i].edits.size());
        for (std::size_t e = 0; e < a.scenarios[i].edits.size(); ++e)
            EXPECT_EQ(toJson(a.scenarios[i].edits[e]), toJson(b.scenarios[i].edits[e]));
    }
    ASSERT_EQ(a.results.size(), b.results.size());
    for (std::size_t i = 0; i < a.results.size(); ++i) {
        EXPECT_EQ(a.results[i]->settings, b.results[i]->settings);
        EXPECT_EQ(a.results[i]->grid, b.results[i]->grid);
        ASSERT_EQ(a.results[i]->elements.size(), b.results[i]->elements.size());
        for (std::size_t e = 0; e < a.results[i]->elements.size(); ++e)
            expectSame(a.results[i]->elements[e], b.results[i]->elements[e]);
        ASSERT_EQ(a.results[i]->layers.size(), b.results[i]->layers.size());
        for (std::size_t l = 0; l < a.results[i]->layers.size(); ++l)
            for (std::size_t c = 0; c < a.results[i]->grid.size(); ++c) {
                const float x = a.results[i]->layers[l].values[c], y = b.results[i]->layers[l].values[c];
                ASSERT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << c << ": " << x << " " << y;
            }
    }
}

}  // namespace noonmark::tests
