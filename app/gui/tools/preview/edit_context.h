#pragma once

#include <map>

#include "app/gui/session/study/open_city.h"
#include "app/gui/tools/preview/edit_preview.h"
#include "app/gui/tools/preview/extrude_handle.h"
#include "app/gui/view/panel/view_panel.h"
#include "scenarios/massing/tower_design.h"
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
    std::map<std::string, ProposedTower> towers;  ///< of the shown scenario

    /// Null: it was not designed here.
    [[nodiscard]] const ProposedTower* findTower(const Building& building) const {
        const auto found = towers.find(building.sourceId);
        return found == towers.end() ? nullptr : &found->second;
    }
};

}  // namespace noonmark
