#include <fmt/format.h>

#include <cmath>

#include "core/base/safe_text.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/tables/database.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/geopackage.h"
#include "scenarios/project/write_project.h"

// Reads and writes the layer `result_elements`: the points of saved results.
namespace noonmark {

namespace {

constexpr NumberLimits minuteLimits{0, 1e7};
constexpr NumberLimits paneLimitsM{-1e4, 1e4};
constexpr NumberLimits unitLimits{-1.001, 1.001};
constexpr NumberLimits floorLimits{-1000, 100000};
constexpr int firstNumber = 6;  // the columns before it are texts and the floor

std::string listMonths(const char* before) {
    std::string list;
    for (int month = 1; month <= 12; ++month) list += fmt::format("{}{:02}", before, month);
    return list;
}

std::string columnList() {
    return "element_id, kind, building, building_name, floor, azimuth_deg, x_m, y_m, z_m, normal_x, "
           "normal_y, normal_z, left_m, below_m, right_m, above_m, sunlit_min, gross_min, continuous_min, "
           "longest_sun_min" +
           listMonths(", sunlit_min_");
}

std::optional<double> stored(double value) { return std::isnan(value) ? std::nullopt : std::optional(value); }

ElementKind kindOf(const CheckedRow& checked, const std::string& name) {
    for (const auto kind : {ElementKind::facade, ElementKind::window, ElementKind::plane, ElementKind::point})
        if (nameOf(kind) == name) return kind;
    checked.refuse("the kind is unknown");
}

/// Reads the columns of one row in order.
class ElementReader {
public:
    explicit ElementReader(const Statement& row) : row_(row), checked_(row, "result_elements") {}

    MeasuredElement read() {
        MeasuredElement element{.id = cleanText(row_.text(1)),
                                .kind = kindOf(checked_, row_.text(2)),
                                .building = cleanText(row_.text(3)),
                                .buildingName = cleanText(row_.text(4))};
        if (!row_.isNull(5)) element.floor = checked_.integer(5, "floor", floorLimits);
        element.azimuthDeg = orNothing("azimuth_deg", {0, 360});
        element.position = vector("x_m", placeLimitsM);
        element.normal = vector("normal_x", unitLimits);
        element.pane.low = {next("left_m", paneLimitsM), next("below_m", paneLimitsM)};
        element.pane.high = {next("right_m", paneLimitsM), next("above_m", paneLimitsM)};
        for (double* minutes :
             {&element.sunlitMin, &element.grossMin, &element.continuousMin, &element.longestSunMin})
            *minutes = next("minutes", minuteLimits);
        for (double& minutes : element.monthMin) minutes = orNothing("sunlit_min", minuteLimits);
        return element;
    }

private:
    double next(const char* name, const NumberLimits& limits) {
        return checked_.number(column_++, name, limits);
    }
    double orNothing(const char* name, const NumberLimits& limits) {
        if (!row_.isNull(column_)) return next(name, limits);
        ++column_;
        return std::nan("");
    }
    // In this order, which the arguments of a constructor need not have.
    glm::vec3 vector(const char* name, const NumberLimits& limits) {
        glm::vec3 made;
        for (int i = 0; i < 3; ++i) made[i] = float(next(name, limits));
        return made;
    }

    const Statement& row_;
    CheckedRow checked_;
    int column_ = firstNumber;
};

}  // namespace

void writeElements(Database& database, std::int64_t result, const std::vector<MeasuredElement>& elements) {
    if (elements.empty()) return;
    std::string values = "?, ?";
    for (int i = 0; i < 32; ++i) values += ", ?";
    Statement add = database.prepare(
        fmt::format("INSERT INTO result_elements (geom, result, {}) VALUES ({})", columnList(), values));
    Box2 box;
    for (const MeasuredElement& one : elements) {
        const Bytes place = multiPointBlob({glm::vec2(one.position)});
        const auto& month = one.monthMin;
        add.run(AsBlob{place}, result, one.id, nameOf(one.kind), one.building, one.buildingName, one.floor,
                stored(one.azimuthDeg), one.position.x, one.position.y, one.position.z, one.normal.x,
                one.normal.y, one.normal.z, one.pane.low.x, one.pane.low.y, one.pane.high.x, one.pane.high.y,
                one.sunlitMin, one.grossMin, one.continuousMin, one.longestSunMin, stored(month[0]),
                stored(month[1]), stored(month[2]), stored(month[3]), stored(month[4]), stored(month[5]),
                stored(month[6]), stored(month[7]), stored(month[8]), stored(month[9]), stored(month[10]),
                stored(month[11]));
        box.add(glm::vec2(one.position));
    }
    touchLayer(database, "result_elements", double(box.low.x), double(box.low.y), double(box.high.x),
               double(box.high.y));
}

std::vector<MeasuredElement> readElements(Database& database, std::int64_t result) {
    std::vector<MeasuredElement> elements;
    Statement row = database.prepare("SELECT fid, " + columnList() +
                                     " FROM result_elements WHERE result = ? ORDER BY fid");
    for (row.begin(result); row.step();) elements.push_back(ElementReader(row).read());
    return elements;
}

}  // namespace noonmark
