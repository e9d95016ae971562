#include "app/report/files/cells_csv.h"

#include <cmath>
#include <string>
#include <vector>

#include "core/base/csv_text.h"
#include "core/engines/api/tree_shade.h"
#include "core/measures/has_runs.h"

namespace noonmark {

namespace {

constexpr std::size_t chunkBytes = 1U << 20U;

bool flush(CsvText& csv, QIODevice& device) {
    const std::string text = csv.take();
    return device.write(text.data(), qint64(text.size())) == qint64(text.size());
}

void addCell(CsvText& csv, const ShadowField& field, bool runs, const Frame& frame, int column, int row) {
    const std::size_t cell = field.grid.index(column, row);
    if (std::isnan(field.grossMin[cell])) return;
    const glm::dvec2 centre = field.grid.centre(column, row);
    const LonLat place = frame.lonLatFromLocal(centre);
    csv.number(centre.x, 3).number(centre.y, 3).number(place.lonDeg, 8).number(place.latDeg, 8);
    csv.number(double(field.grossMin[cell]), 3);
    if (runs) csv.number(double(field.continuousMin[cell]), 3);
    for (const ShadeColumn& shade : listShadeColumns(field)) {
        csv.number(double(shade.field->grossMin[cell]), 3);
        if (runs) csv.number(double(shade.field->continuousMin[cell]), 3);
    }
    csv.endRow();
}

}  // namespace

bool writeCellsCsv(const ShadowField& field, const Frame& frame, QIODevice& device) {
    const bool runs = hasRuns(field);
    std::vector<std::string> columns{"x_m", "y_m", "lon_deg", "lat_deg", "gross_min"};
    if (runs) columns.emplace_back("continuous_min");
    for (const ShadeColumn& shade : listShadeColumns(field)) {
        columns.push_back("gross_min" + suffixOf(shade.column));
        if (runs) columns.push_back("continuous_min" + suffixOf(shade.column));
    }
    CsvText csv(columns);
    for (int row = 0; row < field.grid.rows; ++row) {
        for (int column = 0; column < field.grid.columns; ++column)
            addCell(csv, field, runs, frame, column, row);
        if (csv.size() >= chunkBytes && !flush(csv, device)) return false;
    }
    return flush(csv, device);
}

}  // namespace noonmark
