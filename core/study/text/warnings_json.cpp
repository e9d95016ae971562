#include "core/study/text/warnings_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

Json warningsJson(const Warnings& warnings) {
    Json groups = Json::array();
    for (const WarningGroup& group : groupWarnings(warnings))
        groups.push_back(Json{{"kind", nameOf(group.kind)},
                              {"what", group.what},
                              {"count", group.where.size()},
                              {"where", group.where}});
    return groups;
}

std::string toJsonText(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); }

}  // namespace noonmark
