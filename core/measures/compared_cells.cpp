#include "core/measures/compared_cells.h"

#include "core/engines/ray/ray_minutes.h"

namespace noonmark {

namespace {

/// Labels the progress of the reference and hides its partial results from viewers.
class SampleProgress final : public Progress {
public:
    explicit SampleProgress(Progress& progress) : progress_(progress) {}
    void report(double fraction, std::string_view) override {
        progress_.report(fraction, "measuring the error on a sample");
    }

private:
    Progress& progress_;
};

// The field's minutes are floats, so the reference's are rounded to float too.
ComparedCell compareCell(const ShadowField& field, std::uint32_t cell, const PointMinutes& truth) {
    const auto columns = std::uint32_t(field.grid.columns);
    return {field.grid.centre(int(cell % columns), int(cell / columns)), field.grossMin[cell],
            float(truth.gross), field.continuousMin[cell], float(truth.continuous)};
}

}  // namespace

Result<std::vector<ComparedCell>> compareByRays(const RayScene& scene, const Receivers& receivers,
                                                const SunSteps& sun, const ShadowField& field,
                                                std::span<const std::uint32_t> cells, Progress& progress,
                                                const std::stop_token& stop) {
    std::vector<glm::vec3> places;
    for (const std::uint32_t cell : cells) places.push_back(receivers.position(cell));
    SampleProgress sampling(progress);
    return traceMinutesAt(scene, places, sun, sampling, stop)
        .map([&](const std::vector<PointMinutes>& truths) {
            std::vector<ComparedCell> pairs;
            for (std::size_t i = 0; i < cells.size(); ++i)
                pairs.push_back(compareCell(field, cells[i], truths[i]));
            return pairs;
        });
}

}  // namespace noonmark
