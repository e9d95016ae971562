#include "core/study/provenance/inputs_json.h"

namespace noonmark {

nlohmann::ordered_json inputsJson(const std::vector<InputFile>& inputs) {
    using Json = nlohmann::ordered_json;
    Json json = Json::array();
    for (const InputFile& input : inputs) {
        const bool made = input.sha256.empty();
        json.push_back({{"path", input.path.string()},
                        {"bytes", made ? Json() : Json(input.bytes)},
                        {"sha256", made ? Json() : Json(input.sha256)}});
    }
    return json;
}

}  // namespace noonmark
