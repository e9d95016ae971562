#include "app/gui/docks/review/review_choice.h"

#include "app/gui/session/project/view_state.h"

namespace noonmark {

std::string formatText(const ReviewChoice& choice) {
    nlohmann::ordered_json json{
        {"rule", choice.rule}, {"options", choice.options},      {"from", choice.from},
        {"to", choice.to},     {"all_places", choice.allPlaces}, {"places", choice.places}};
    json["windows"] = elementSettingsJson(choice.windows);
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

ReviewChoice parseReviewChoice(const std::string& text) try {
    const auto json = nlohmann::ordered_json::parse(text);
    ReviewChoice choice;
    choice.rule = json.at("rule");
    choice.options = json.at("options").get<RuleChoices>();
    choice.from = json.at("from");
    choice.to = json.at("to");
    choice.allPlaces = json.at("all_places");
    choice.places = json.at("places").get<std::vector<std::string>>();
    if (json.contains("windows"))
        choice.windows = elementSettingsFrom(json.at("windows")).value_or(ElementSettings{});
    return choice;
} catch (const nlohmann::ordered_json::exception&) {
    return {};
}

}  // namespace noonmark
