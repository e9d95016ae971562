#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/gui/session/project/view_mode.h"
#include "app/report/maps/change_scale.h"
#include "app/report/maps/shadow_measure.h"
#include "core/measures/legend_choice.h"
#include "core/study/elements/place_elements.h"
#include "render/view/camera_pose.h"
#include "render/view/section_box.h"
#include "scenarios/scenario.h"

namespace noonmark {

/// Where the points of a study, or the windows of a review, lie; as the project's view state holds it.
nlohmann::ordered_json elementSettingsJson(const ElementSettings& elements);
/// None for JSON of another structure, and where a length is out of its range.
std::optional<ElementSettings> elementSettingsFrom(const nlohmann::ordered_json& json);

/// The window's state that is saved in Project::view and restored when the project is opened.
struct ViewState {
    std::optional<CameraPose> camera;
    std::optional<SectionBox> section{};
    ViewMode mode = ViewMode::exploration;
    ShadowMeasure measure = ShadowMeasure::gross;
    ChangeScale changeScale;
    LegendChoice legend;
    std::string scenario = existingCity;
    std::string baseline;                     ///< empty: none
    std::string answer;                       ///< "study" or "comparison" was displayed; empty: neither
    std::string shown;                        ///< the name of the result displayed; empty: none in the file
    double answerSeconds = 0;                 ///< time to compute it
    std::optional<StudySettings> study;       ///< region, cells, period, engine
    std::optional<ElementSettings> elements;  ///< where the study has points
    std::string review;                       ///< what is reviewed: JSON, as review_choice.h writes it
};

/// Keys: "camera", "section", "mode", "measure", "change_scale", "legend" (JSON), "scenario", "baseline",
/// "answer", "answer_seconds", "shown", "study" (JSON), "elements" (JSON), "review" (JSON). The window adds
/// "weights", the chosen table, "figures" (latest_answers.h), "question", "places_asked", "places_listed",
/// "compared" and "clock" (window_project.cpp).
std::map<std::string, std::string> textsOf(const ViewState& state);

/// Reads what is valid; the rest is as in ViewState{}. Accepts any text, since the file may come from
/// anywhere.
ViewState parseViewState(const std::map<std::string, std::string>& texts);

}  // namespace noonmark
