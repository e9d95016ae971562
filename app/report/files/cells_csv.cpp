#include "app/report/files/cells_csv.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "core/measures/has_runs.h"

namespace noonmark {

namespace {

constexpr std::size_t chunkBytes = 1U << 20U;

/// Buffers text for a device, a megabyte at a time.
class Chunks {
public:
    explicit Chunks(QIODevice& device) : device_(device) {}

    fmt::memory_buffer& text() { return text_; }
    bool flushWhenFull() { return text_.size() < chunkBytes || flush(); }
    bool flush() {
        const auto bytes = qint64(text_.size());
        const bool whole = device_.write(text_.data(), bytes) == bytes;
        text_.clear();
        return whole;
    }

private:
    QIODevice& device_;
    fmt::memory_buffer text_;
};

void addCell(fmt::memory_buffer& text, const ShadowField& field, bool runs, const Frame& frame, int column,
             int row) {
    const std::size_t cell = field.grid.index(column, row);
    if (std::isnan(field.grossMin[cell])) return;
    const glm::dvec2 centre = field.grid.centre(column, row);
    const LonLat place = frame.lonLatFromLocal(centre);
    const auto out = std::back_inserter(text);
    fmt::format_to(out, FMT_COMPILE("{:.3f},{:.3f},{:.8f},{:.8f},{:.3f}"), centre.x, centre.y, place.lonDeg,
                   place.latDeg, field.grossMin[cell]);
    if (runs) fmt::format_to(out, FMT_COMPILE(",{:.3f}"), field.continuousMin[cell]);
    text.push_back('\n');
}

}  // namespace

bool writeCellsCsv(const ShadowField& field, const Frame& frame, QIODevice& device) {
    Chunks chunks(device);
    const bool runs = hasRuns(field);
    chunks.text().append(std::string_view("x_m,y_m,lon_deg,lat_deg,gross_min"));
    chunks.text().append(std::string_view(runs ? ",continuous_min\n" : "\n"));
    for (int row = 0; row < field.grid.rows; ++row) {
        for (int column = 0; column < field.grid.columns; ++column)
            addCell(chunks.text(), field, runs, frame, column, row);
        if (!chunks.flushWhenFull()) return false;
    }
    return chunks.flush();
}

}  // namespace noonmark
