#include "core/review/library/rule_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/sun/zone_country.h"

namespace noonmark {

namespace {

constexpr std::size_t longestText = 2000;
constexpr std::size_t maxElements = 400;

std::string_view kindOf(const RuleJson& json) { return json.type_name(); }

bool isControl(char letter) { return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f; }

std::string checkedText(const RuleJson& json, const std::string& path, RuleProblem& problem) {
    if (!json.is_string()) {
        problem.add(path, fmt::format("A text is needed here, not {}", kindOf(json)));
        return {};
    }
    std::string text = json.get<std::string>();
    if (text.empty() || text.size() > longestText)
        problem.add(path, fmt::format("A text of 1 to {} bytes is needed here", longestText));
    if (std::ranges::any_of(text, isControl)) problem.add(path, "The text contains control characters");
    return text;
}

/// A key of a hostile file, fit for a message.
std::string printable(std::string_view key) {
    std::string shown;
    for (const char letter : key.substr(0, 60)) shown += letter > 0x20 && letter < 0x7f ? letter : '?';
    return shown;
}

}  // namespace

bool isRuleKey(const std::string& key) {
    return !key.empty() && key.size() <= 60 &&
           key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

bool isPlainText(const std::string& text) {
    return !text.empty() && text.size() <= longestText && std::ranges::none_of(text, isControl);
}

void RuleProblem::add(const std::string& path, std::string what, std::string advice) {
    if (!error) error = Error{std::move(what), file + ", " + path, std::move(advice)};
}

RuleFields::RuleFields(const RuleJson& json, std::string path, RuleProblem& problem)
    : json_(json), path_(std::move(path)), problem_(&problem), known_{"comment"} {
    if (json_.is_object()) return;
    problem_->add(path_.empty() ? "the whole file" : path_,
                  fmt::format("An object is needed here, not {}", kindOf(json_)), "Write { ... }");
    json_ = RuleJson::object();
}

std::string RuleFields::pathOf(const std::string& key) const {
    return path_.empty() ? key : path_ + "." + key;
}

void RuleFields::addProblem(const char* key, std::string what, std::string advice) {
    problem_->add(pathOf(key), std::move(what), std::move(advice));
}

const RuleJson* RuleFields::find(const char* key) {
    known_.insert(key);
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
}

bool RuleFields::has(const char* key) const { return json_.contains(key); }

std::string RuleFields::text(const char* key) {
    const RuleJson* found = find(key);
    if (!found) {
        addProblem(key, "The field is missing", "See docs/rules.md");
        return {};
    }
    return checkedText(*found, pathOf(key), *problem_);
}

std::string RuleFields::textOr(const char* key, std::string otherwise) {
    return has(key) ? text(key) : std::move(otherwise);
}

double RuleFields::number(const char* key, double lowest, double highest) {
    const RuleJson* found = find(key);
    if (!found) {
        addProblem(key, "The field is missing", "See docs/rules.md");
        return lowest;
    }
    const double value = found->is_number() ? found->get<double>() : std::nan("");
    if (value >= lowest && value <= highest) return value;
    addProblem(key, fmt::format("A number from {:g} to {:g} is needed here", lowest, highest));
    return lowest;
}

double RuleFields::numberOr(const char* key, double lowest, double highest, double otherwise) {
    return has(key) ? number(key, lowest, highest) : otherwise;
}

int RuleFields::wholeOr(const char* key, int lowest, int highest, int otherwise) {
    const double value = numberOr(key, lowest, highest, otherwise);
    if (value != std::floor(value)) addProblem(key, "A whole number is needed here");
    return int(value);
}

bool RuleFields::flagOr(const char* key, bool otherwise) {
    const RuleJson* found = find(key);
    if (!found) return otherwise;
    if (found->is_boolean()) return found->get<bool>();
    addProblem(key, "true or false is needed here");
    return otherwise;
}

bool RuleFields::isFlag(const char* key) const { return has(key) && json_.at(key).is_boolean(); }

bool RuleFields::isObject(const char* key) const { return has(key) && json_.at(key).is_object(); }

std::vector<RuleJson> RuleFields::elements(const char* key) {
    const RuleJson* found = find(key);
    if (!found) return {};
    if (found->is_array() && found->size() <= maxElements)
        return std::vector<RuleJson>(found->begin(), found->end());
    addProblem(key, fmt::format("A list of at most {} entries is needed here", maxElements), "Write [ ... ]");
    return {};
}

std::vector<std::pair<std::string, RuleJson>> RuleFields::members(const char* key) {
    const RuleJson* found = find(key);
    if (!found) return {};
    std::vector<std::pair<std::string, RuleJson>> all;
    if (!found->is_object() || found->size() > maxElements) {
        addProblem(key, fmt::format("An object of at most {} fields is needed here", maxElements));
        return {};
    }
    for (const auto& [name, value] : found->items())
        if (name != "comment") all.emplace_back(name, value);
    return all;
}

std::vector<std::string> RuleFields::texts(const char* key) {
    std::vector<std::string> all;
    for (const RuleJson& element : elements(key))
        all.push_back(checkedText(element, fmt::format("{}[{}]", pathOf(key), all.size()), *problem_));
    return all;
}

RuleFields RuleFields::object(const char* key) {
    const RuleJson* found = find(key);
    if (!found) addProblem(key, "The field is missing", "See docs/rules.md");
    return {found ? *found : RuleJson::object(), pathOf(key), *problem_};
}

void RuleFields::finish() {
    for (const auto& [key, value] : json_.items()) {
        if (known_.contains(key)) continue;
        const auto close = findCloseNames(key, {known_.begin(), known_.end()});
        problem_->add(pathOf(printable(key)), "There is no such field in a rule",
                      close.empty() ? "See docs/rules.md" : fmt::format("Did you mean '{}'?", close.front()));
    }
}

}  // namespace noonmark
