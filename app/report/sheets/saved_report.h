#pragma once

#include <string>
#include <vector>

#include "app/report/maps/change_scale.h"
#include "app/report/sheets/sheet.h"
#include "scenarios/project/results/saved_answer.h"

namespace noonmark {

/// What the page of a saved result needs besides the result. `city` must outlive this object.
struct SavedSource {
    const City& city;                    ///< of its scenario as it is now; in the frame of the result's grid
    std::vector<std::string> changes{};  ///< since the result was saved, a sentence each
    std::vector<Region> regions{};       ///< of the project; one of them may be the result's
};

/// The region of a saved result, whose outline is not stored: the region of `known` that has its name and the
/// extent of its cells, else the rectangle around the cells.
Region makeSavedRegion(const SavedResult& result, const SavedAnswer& answer,
                       const std::vector<Region>& known);

/// The page of a saved result: its maps and figures as they were saved, method, inputs with their hashes,
/// when it was saved and what has changed since. `answer` was read from `result`; `region`:
/// makeSavedRegion(). All arguments must outlive the sheet.
Sheet makeSheet(const SavedResult& result, const SavedAnswer& answer, const Region& region,
                const SavedSource& source, const ChangeScale& scale, const LegendChoice& legend = {});

}  // namespace noonmark
