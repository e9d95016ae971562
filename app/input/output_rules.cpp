#include "app/input/output_rules.h"

#include <system_error>

namespace noonmark {

OutputRules outputRules(const std::vector<std::string>& named, const std::vector<InputFile>& inputs,
                        bool overwrite) {
    OutputRules rules{{named.begin(), named.end()}, overwrite};
    for (const InputFile& input : inputs) {
        rules.inputs.push_back(input.path);
        if (input.path.is_relative())
            for (const std::filesystem::path file : named)
                rules.inputs.push_back(file.parent_path() / input.path);
    }
    return rules;
}

void addPlace(OutputRules& rules, const std::string& place) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(place, ignored)) rules.inputs.emplace_back(place);
}

}  // namespace noonmark
