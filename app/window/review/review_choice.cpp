#include "app/window/review/review_choice.h"

#include <nlohmann/json.hpp>

namespace noonmark {

namespace {

WindowChoice windowsFrom(const nlohmann::json& json) {
    WindowChoice windows{json.at("of_file"), json.at("file"), json.at("buildings"), json.at("bay_m"),
                         json.at("storey_m")};
    const auto inRange = [](double metres) {
        return metres >= FacadeSettings::leastM && metres <= FacadeSettings::mostM;
    };
    if (!inRange(windows.bayM)) windows.bayM = WindowChoice{}.bayM;
    if (!inRange(windows.storeyM)) windows.storeyM = WindowChoice{}.storeyM;
    return windows;
}

}  // namespace

std::string formatText(const ReviewChoice& choice) {
    nlohmann::ordered_json json{
        {"rule", choice.rule}, {"options", choice.options},      {"from", choice.from},
        {"to", choice.to},     {"all_places", choice.allPlaces}, {"places", choice.places}};
    const WindowChoice& windows = choice.windows;
    json["windows"] = {{"of_file", windows.ofFile},
                       {"file", windows.file},
                       {"buildings", windows.buildings},
                       {"bay_m", windows.bayM},
                       {"storey_m", windows.storeyM}};
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

ReviewChoice parseReviewChoice(const std::string& text) try {
    const auto json = nlohmann::json::parse(text);
    ReviewChoice choice;
    choice.rule = json.at("rule");
    choice.options = json.at("options").get<RuleChoices>();
    choice.from = json.at("from");
    choice.to = json.at("to");
    choice.allPlaces = json.at("all_places");
    choice.places = json.at("places").get<std::vector<std::string>>();
    if (json.contains("windows")) choice.windows = windowsFrom(json.at("windows"));
    return choice;
} catch (const nlohmann::json::exception&) {
    return {};
}

}  // namespace noonmark
