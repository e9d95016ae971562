#include "app/gui/docks/review/review_choice.h"

#include <array>

#include "app/gui/session/project/view_state.h"
#include "core/describe/choice.h"

namespace noonmark {

namespace {

constexpr std::array<Choice<ReviewedPlaces>, 4> reviewedChoices{{{ReviewedPlaces::automatic, "automatic"},
                                                                 {ReviewedPlaces::inReach, "in_reach"},
                                                                 {ReviewedPlaces::all, "all"},
                                                                 {ReviewedPlaces::chosen, "chosen"}}};

// Earlier versions knew all places or chosen ones only.
ReviewedPlaces readReviewed(const nlohmann::ordered_json& json) {
    if (!json.contains("reviewed"))
        return json.at("all_places").get<bool>() ? ReviewedPlaces::all : ReviewedPlaces::chosen;
    return findChoice<ReviewedPlaces>(reviewedChoices, json.at("reviewed").get<std::string>())
        .value_or(ReviewedPlaces::automatic);
}

}  // namespace

std::string formatText(const ReviewChoice& choice) {
    nlohmann::ordered_json json{
        {"rule", choice.rule},
        {"options", choice.options},
        {"from", choice.from},
        {"to", choice.to},
        {"reviewed", std::string(keyOf<ReviewedPlaces>(reviewedChoices, choice.reviewed))},
        {"places", choice.places}};
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
    choice.reviewed = readReviewed(json);
    choice.places = json.at("places").get<std::vector<std::string>>();
    if (json.contains("windows"))
        choice.windows = elementSettingsFrom(json.at("windows")).value_or(ElementSettings{});
    return choice;
} catch (const nlohmann::ordered_json::exception&) {
    return {};
}

}  // namespace noonmark
