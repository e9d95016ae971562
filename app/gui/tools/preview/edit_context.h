#pragma once

#include "app/gui/session/study/open_city.h"
#include "app/gui/tools/preview/edit_preview.h"
#include "app/gui/tools/preview/extrude_handle.h"
#include "app/gui/view/panel/view_panel.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// State shared by the edit tools: the view, its city, the preview and the drag handle.
struct EditContext {
    EditContext(ViewPanel& view, std::shared_ptr<SharedHorizonCache> horizons)
        : panel(view), preview(view, std::move(horizons)), handle(view) {}

    ViewPanel& panel;
    EditPreview preview;
    ExtrudeHandle handle;
    std::shared_ptr<const OpenCity> city;  ///< null before the first city
    std::vector<NamedLot> lots;
};

}  // namespace noonmark
