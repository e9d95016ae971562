#include "core/study/verification/compare_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 14> notCompared{"seconds",
                                                       "accumulate_seconds",
                                                       "write_seconds",
                                                       "mega_rays_per_s",
                                                       "rays",
                                                       "skipped",
                                                       "buildings_skipped",
                                                       "program",
                                                       "engine",
                                                       "engine_settings",
                                                       "instruction_set",
                                                       "repeat",
                                                       "repeat_note",
                                                       "path"};
bool isCompared(const std::string& key) { return std::ranges::find(notCompared, key) == notCompared.end(); }

// The values of a record by their paths, in order of appearance.
class Leaves {
public:
    explicit Leaves(const Json& record) { collect(record, {}); }
    std::vector<std::pair<std::string, const Json*>> all;

private:
    void collect(const Json& json, const std::string& path) {
        if (json.is_object()) {
            for (const auto& [key, value] : json.items())
                if (isCompared(key)) collect(value, path.empty() ? key : fmt::format("{}.{}", path, key));
        } else if (json.is_array()) {
            for (std::size_t i = 0; i < json.size(); ++i) collect(json[i], fmt::format("{}[{}]", path, i));
        } else {
            all.emplace_back(path, &json);
        }
    }
};

bool agree(const Json& a, const Json& b) {
    if (!a.is_number() || !b.is_number()) return a == b;
    return noonmark::agree(a.get<double>(), b.get<double>());
}

std::string textOf(const Json* json) {
    return json ? json->dump(-1, ' ', false, Json::error_handler_t::replace) : std::string();
}

}  // namespace

bool agree(double recorded, double computed) {
    constexpr double agreement = 1e-9;
    return recorded == computed ||
           std::abs(recorded - computed) <= agreement * std::max(std::abs(recorded), std::abs(computed));
}

RecordComparison compareRecords(const Json& recorded, const Json& computed) {
    const Leaves before(recorded), after(computed);
    std::map<std::string, const Json*> left(after.all.begin(), after.all.end());
    RecordComparison result;
    for (const auto& [path, value] : before.all) {
        const auto found = left.find(path);
        if (found == left.end()) {
            result.differences.push_back({path, textOf(value), {}});
            continue;
        }
        ++result.compared;
        if (!agree(*value, *found->second))
            result.differences.push_back({path, textOf(value), textOf(found->second)});
        left.erase(found);
    }
    for (const auto& [path, value] : left) result.differences.push_back({path, {}, textOf(value)});
    return result;
}

}  // namespace noonmark
