#include "app/gui/session/project/scenario_cities.h"

#include <fmt/format.h>

#include <algorithm>

namespace noonmark {

namespace {

constexpr std::size_t most = 64;  // cities cached; each holds its own list of pointers

bool beginsWith(const std::vector<Edit>& edits, const std::vector<Edit>& first) {
    return first.size() <= edits.size() && std::equal(first.begin(), first.end(), edits.begin());
}

}  // namespace

ScenarioCities::Made ScenarioCities::nearest(const std::vector<Edit>& edits) const {
    Made best{{}, existing_};
    for (const Made& made : made_)
        if (made.edits.size() > best.edits.size() && beginsWith(edits, made.edits)) best = made;
    return best;
}

Result<std::shared_ptr<const City>> ScenarioCities::cityOf(const Project& project,
                                                           const std::string& scenario) {
    if (existing_ != project.city) made_.clear();
    existing_ = project.city;
    const auto edits = collectEdits(project.scenarios, scenario);
    if (!edits) return tl::make_unexpected(edits.error());
    const Made from = nearest(*edits);
    if (from.edits.size() == edits->size()) return from.city;
    const auto rest = std::span(*edits).subspan(from.edits.size());
    auto edited = applied(*from.city, rest);
    // Applies all edits again from the first, so that the error names the right one.
    if (!edited)
        return noonmark::cityOf(project, scenario).map([](EditedCity all) {
            return std::make_shared<const City>(std::move(all.city));
        });
    made_.push_back({*edits, std::make_shared<const City>(std::move(edited->city))});
    if (made_.size() > most) made_.erase(made_.begin());
    return made_.back().city;
}

}  // namespace noonmark
