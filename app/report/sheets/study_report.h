#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/maps/change_scale.h"
#include "app/report/sheets/sheet.h"
#include "core/study/study.h"
#include "scenarios/project/results/saved_answer.h"

namespace noonmark {

/// The page of a study: maps, figures, method, error, inputs with their hashes, warnings, and the repeat
/// command. `study` must outlive it.
Sheet makeSheet(const Study& study, const LegendChoice& legend = {});

/// Writes the report of a study as a PDF of one A4 page. Text remains text. `device` must be open; the caller
/// checks it for write errors. False if the PDF could not be started.
bool writeReport(const Study& study, QIODevice& device, const LegendChoice& legend = {});

/// The map of one measure as a picture, so many pixels wide: see makePicture().
QImage mapPicture(const Study& study, ShadowMeasure measure, int width = pictureWidth,
                  const LegendChoice& legend = {});

/// What the page of a saved result needs besides the result. `city` must outlive this object.
struct SavedSource {
    const City& city;                    ///< of its scenario as it is now; in the frame of the result's grid
    std::vector<std::string> changes{};  ///< since the result was saved, a sentence each
    std::vector<Region> regions{};       ///< of the project; one of them may be the result's
};

/// The region of a saved result, whose outline is not stored: the region of `known` that has its name and the
/// extent of its cells, else the rectangle around the cells.
Region makeSavedRegion(const SavedResult& result, const SavedOrigin& origin,
                       const std::vector<Region>& known);

/// What maps of saved results are drawn with.
struct SavedMaps {
    const City& city;
    const Region& region;  ///< makeSavedRegion()
    const ChangeScale& scale;
    const LegendChoice& legend;
};

/// What the page of a saved result has of its kind.
struct SavedSheet {
    QString subject;  ///< "Shadow study of Tower"
    SheetMap map;
    std::optional<SheetMap> smallMap{};
    TextBlocks definitions{};
    std::vector<FigureText> figures{};
    std::string error{};  ///< of a study, as text; empty: none is stated
};

/// The maps refer to the saved content, which must outlive them.
SavedSheet makeSavedSheet(const SavedResult& result, const SavedStudy& study, const SavedMaps& with);
SavedSheet makeSavedSheet(const SavedResult& result, const SavedImpact& impact, const SavedMaps& with);
SavedSheet makeSavedSheet(const SavedResult& result, const SavedScore& score, const SavedMaps& with);

/// Credit of the data that it was measured with.
std::string attributionOf(const SavedResult& result);

/// When it was saved and what has changed since, method, and inputs with their hashes.
std::vector<TextBlocks> makeSavedSections(const SavedResult& result, const SavedOrigin& origin,
                                          const SavedSource& source, const std::string& error = {});

/// The page of a saved result: its maps and figures as they were saved, method, inputs with their hashes,
/// when it was saved and what has changed since. `origin` was read from `result`. All arguments must outlive
/// the sheet.
Sheet makeSheet(const SavedResult& result, const SavedOrigin& origin, SavedSheet saved, const Region& region,
                const SavedSource& source);

}  // namespace noonmark
