#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/report/maps/change_scale.h"
#include "app/report/maps/shadow_measure.h"
#include "app/window/view/view_mode.h"
#include "core/study/study.h"
#include "render/view/camera_pose.h"
#include "scenarios/scenario.h"

namespace noonmark {

/// What the window shows and asks, kept in Project::view and found again when the project is opened.
struct ViewState {
    std::optional<CameraPose> camera;
    ViewMode mode = ViewMode::exploration;
    ShadowMeasure measure = ShadowMeasure::gross;
    ChangeScale changeScale;
    std::string scenario = existingCity;
    std::string baseline;                ///< empty: none
    std::string answer;                  ///< "study" or "comparison": it was shown; empty: none was
    double answerSeconds = 0;            ///< that it took to work out
    std::optional<StudySettings> study;  ///< region, cells, period, engine
};

/// Keys: "camera", "mode", "measure", "change_scale", "scenario", "baseline", "answer", "answer_seconds",
/// "study" (JSON).
std::map<std::string, std::string> textsOf(const ViewState& state);

/// What can be read; the rest is as in ViewState{}. Any text is taken: the file may come from anywhere.
ViewState parseViewState(const std::map<std::string, std::string>& texts);

}  // namespace noonmark
